// SPDX-License-Identifier: BSD-3-Clause
// Access to keys and subtables, and the errors for missing and unknown keys.

#include "input/toml/toml_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "input/schema/all_tables.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

TomlTable::TomlTable(const TomlValue& table, std::string name, InputErrors& errors)
    : table_(&table), name_(std::move(name)), keys_(keys_of_table(name_)), errors_(&errors) {}

TomlTable::TomlTable(const SourceLocation& place, std::string name, InputErrors& errors)
    : table_(&nothing_), name_(std::move(name)), keys_(keys_of_table(name_)), errors_(&errors) {
    nothing_.kind = TomlValue::Kind::table;
    nothing_.place = place;
}

TomlTable::~TomlTable() {
    // After an error it is not known which keys belong here, and each would be called unknown.
    if (unknown_keys_allowed_) {
        return;
    }
    if (keys_ != nullptr) {  // the order in which a reader asks says nothing to the user
        std::ranges::stable_sort(known_, {}, [&](const std::string& name) {
            return std::ranges::find(keys_->keys, name, &Key::name) - keys_->keys.begin();
        });
    }
    for (const Entry& entry : table_->entries) {
        if (std::find(known_.begin(), known_.end(), entry.key) == known_.end()) {
            errors_->add(entry.place, fmt::format("\"{}\" is not a key of {}", entry.key, name_),
                         suggest(entry.key, known_, "keys"));
        }
    }
}

const Key* TomlTable::find(std::string_view key) const {
    if (keys_ == nullptr) {
        return nullptr;
    }
    const TomlValue* kind = table_->find("kind");
    return keys_->find(key, kind == nullptr ? std::string_view() : kind->text);
}

const Key& TomlTable::described(std::string_view key) const {
    const Key* found = find(key);
    if (found == nullptr) {
        throw std::logic_error(fmt::format("{} of {} is read, but not described", key, name_));
    }
    return *found;
}

bool TomlTable::is_required(std::string_view key, Need need) const {
    if (need != Need::described) {
        return need == Need::required;
    }
    const Key* found = find(key);
    return found != nullptr && found->need == Need::required;
}

void TomlTable::declare_keys(std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
        if (keys_ != nullptr && !keys_->has_names) {
            static_cast<void>(described(key));
        }
        if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
            known_.emplace_back(key);
        }
    }
}

SourceLocation TomlTable::place(std::string_view key) const {
    const TomlValue* node = table_->find(key);
    return node != nullptr ? node->place : table_->place;
}

std::nullopt_t TomlTable::add_error(std::string_view key, std::string what, std::string remedy) const {
    return errors_->add(place(key), std::move(what), std::move(remedy));
}

void TomlTable::report_missing(std::string_view key, std::string_view example) const {
    if (exists()) {
        const std::string_view missing = example.starts_with('[') ? example : key;
        errors_->add(place(), fmt::format("{} lacks {}", name_, missing), fmt::format("add {}", example));
    }
}

const TomlValue* TomlTable::take(std::string_view key, Need need, std::initializer_list<TomlValue::Kind> kinds,
                                 std::string_view expected, std::string_view example) {
    const TomlValue* node = value(key, need, example);
    if (node != nullptr && std::ranges::find(kinds, node->kind) == kinds.end()) {
        errors_->add(node->place, fmt::format("{} is {}; {} is wanted", key, shown(*node), expected),
                     fmt::format("write {}", example));
        return nullptr;
    }
    return node;
}

const TomlValue* TomlTable::value(std::string_view key, Need need, std::string_view example) {
    declare_keys({key});
    const TomlValue* node = table_->find(key);
    if (node == nullptr && is_required(key, need)) {
        report_missing(key, example);
    }
    return node;
}

std::string TomlTable::child_name(std::string_view key, bool list) const {
    std::string path = name_.find('[') == std::string::npos ? std::string() : name_;
    std::erase_if(path, [](char c) { return c == '[' || c == ']'; });
    path += path.empty() ? "" : ".";
    path += key;
    return list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
}

TomlTable TomlTable::subtable(std::string_view key, Need need) {
    const std::string title = child_name(key, false);
    const TomlValue* node = take(key, need, {TomlValue::Kind::table}, "a table", title);
    if (node == nullptr) {
        return {place(key), title, *errors_};
    }
    return {*node, title, *errors_};
}

void TomlTable::each(std::string_view key, const std::function<void(TomlTable&)>& read, Need need,
                     std::string_view example) {
    const std::string title = child_name(key, true);
    const std::string entry(example.empty() ? title : example);
    const TomlValue* list = take(key, need, {TomlValue::Kind::array}, "a list of tables", entry);
    if (list == nullptr) {
        return;
    }
    if (list->items.empty() && is_required(key, need)) {
        errors_->add(list->place, fmt::format("{} is an empty list", key), fmt::format("write {}", entry));
    }
    for (const TomlValue& item : list->items) {
        if (item.kind != TomlValue::Kind::table) {
            errors_->add(item.place, fmt::format("{} has {}; a table is wanted", key, shown(item)),
                         fmt::format("write {}", entry));
            continue;
        }
        TomlTable table(item, title, *errors_);
        read(table);
    }
}

}  // namespace tiretherm::input
