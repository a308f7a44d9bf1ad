#include "input/text/section.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "input/text/words.hpp"

namespace tiretherm::input {

Section::Section(const Node& table, std::string name, Mistakes& mistakes)
    : table_(&table), name_(std::move(name)), mistakes_(&mistakes) {}

Section::Section(const Place& place, std::string name, Mistakes& mistakes)
    : table_(&nothing_), name_(std::move(name)), mistakes_(&mistakes) {
    nothing_.kind = Node::Kind::table;
    nothing_.place = place;
}

Section::~Section() {
    if (forgiving_) {
        return;
    }
    for (const Entry& entry : table_->entries) {
        if (std::find(known_.begin(), known_.end(), entry.key) == known_.end()) {
            mistakes_->add(entry.place, fmt::format("\"{}\" is not a key of {}", entry.key, name_),
                           suggest(entry.key, known_, "keys"));
        }
    }
}

void Section::know(std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
        if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
            known_.emplace_back(key);
        }
    }
}

Place Section::place(std::string_view key) const {
    const Node* node = table_->find(key);
    return node != nullptr ? node->place : table_->place;
}

void Section::mistake(std::string_view key, std::string what, std::string remedy) const {
    mistakes_->add(place(key), std::move(what), std::move(remedy));
}

void Section::miss(std::string_view key, std::string_view example) const {
    if (exists()) {
        const std::string_view missing = example.starts_with('[') ? example : key;
        mistakes_->add(place(), fmt::format("{} lacks {}", name_, missing), fmt::format("add {}", example));
    }
}

const Node* Section::take(std::string_view key, Need need, std::initializer_list<Node::Kind> kinds,
                          std::string_view wanted, std::string_view example) {
    know({key});
    const Node* node = table_->find(key);
    if (node == nullptr) {
        if (need == Need::required) {
            miss(key, example);
        }
        return nullptr;
    }
    if (std::find(kinds.begin(), kinds.end(), node->kind) == kinds.end()) {
        mistakes_->add(node->place, fmt::format("{} is {}; {} is wanted", key, shown(*node), wanted),
                       fmt::format("write {}", example));
        return nullptr;
    }
    return node;
}

const Node* Section::value(std::string_view key, Need need, std::string_view example) {
    know({key});
    const Node* node = table_->find(key);
    if (node == nullptr && need == Need::required) {
        miss(key, example);
    }
    return node;
}

std::string Section::child_name(std::string_view key, bool list) const {
    std::string path = name_.find('[') == std::string::npos ? std::string() : name_;
    std::erase_if(path, [](char c) { return c == '[' || c == ']'; });
    path += path.empty() ? "" : ".";
    path += key;
    return list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
}

Section Section::section(std::string_view key, Need need) {
    const std::string title = child_name(key, false);
    const Node* node = take(key, need, {Node::Kind::table}, "a table", title);
    if (node == nullptr) {
        return {place(key), title, *mistakes_};
    }
    return {*node, title, *mistakes_};
}

void Section::each(std::string_view key, const std::function<void(Section&)>& read, Need need,
                   std::string_view example) {
    const std::string title = child_name(key, true);
    const std::string entry(example.empty() ? title : example);
    const Node* list = take(key, need, {Node::Kind::array}, "a list of tables", entry);
    if (list == nullptr) {
        return;
    }
    if (list->items.empty() && need == Need::required) {
        mistakes_->add(list->place, fmt::format("{} is an empty list", key), fmt::format("write {}", entry));
    }
    for (const Node& item : list->items) {
        if (item.kind != Node::Kind::table) {
            mistakes_->add(item.place, fmt::format("{} has {}; a table is wanted", key, shown(item)),
                           fmt::format("write {}", entry));
            continue;
        }
        Section section(item, title, *mistakes_);
        read(section);
    }
}

}  // namespace tiretherm::input
