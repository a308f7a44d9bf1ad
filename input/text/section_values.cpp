#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/text/section.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

std::optional<double> Section::quantity(std::string_view key, const Wanted& wanted, Need need) {
    know({key});
    const Node* node = table_->find(key);
    if (node == nullptr || (node->kind != Node::Kind::text && !node->is_number())) {
        if (node != nullptr || need == Need::required) {
            const Dimension what = dimension(wanted.unit, wanted.scale);
            take(key, need, {}, what.name, fmt::format("{} = {}", key, spell_example(wanted)));
        }
        return std::nullopt;
    }
    Judged judged;
    if (node->kind == Node::Kind::text) {
        judged = input::quantity(node->text, wanted, key);
    } else if (wanted.is_pure()) {
        judged = judge(node->number, {}, "", wanted, key, shown(*node));
    } else {
        judged.fault = Fault{fmt::format("{} is {}, without a unit", key, shown(*node)), write_like(wanted)};
    }
    if (judged.fault) {
        mistakes_->add(node->place, *judged.fault);
        return std::nullopt;
    }
    if (!judged.remark.empty()) {
        mistakes_->warn(node->place, judged.remark);
    }
    return judged.value;
}

std::optional<std::string> Section::text(std::string_view key, Need need) {
    const Node* node = take(key, need, {Node::Kind::text}, "a text", fmt::format("{} = \"...\"", key));
    return node == nullptr ? std::nullopt : std::optional(node->text);
}

std::optional<std::string> Section::name(std::string_view key, Need need) {
    std::optional<std::string> name = text(key, need);
    if (!name) {
        return std::nullopt;
    }
    const bool control =
        std::any_of(name->begin(), name->end(), [](char c) { return static_cast<unsigned char>(c) < ' '; });
    if (name->empty() || trim(*name) != *name || control || name->find_first_of("[]{}\"'`,;/\\") != std::string::npos) {
        mistake(key, fmt::format("{} is \"{}\", which cannot name a column", key, *name),
                "use letters, digits and underscores");
        return std::nullopt;
    }
    return name;
}

std::optional<std::size_t> Section::choice(std::string_view key, std::span<const std::string_view> options, Need need) {
    const std::vector<std::string> known(options.begin(), options.end());
    const Node* node = take(key, need, {Node::Kind::text}, "a word", fmt::format("{} = \"{}\"", key, known.front()));
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto found = std::find(options.begin(), options.end(), node->text);
    if (found == options.end()) {
        mistakes_->add(node->place, fmt::format("{} cannot be \"{}\"", key, node->text),
                       suggest(node->text, known, "possible words"));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - options.begin());
}

std::optional<bool> Section::flag(std::string_view key) {
    const Node* node = take(key, Need::optional, {Node::Kind::boolean}, "true or false", fmt::format("{} = true", key));
    return node == nullptr ? std::nullopt : std::optional(node->truth);
}

std::optional<int> Section::count(std::string_view key, int low, int high, Need need) {
    const Node* node =
        take(key, need, {Node::Kind::integer}, "a whole number", fmt::format("{} = {}", key, std::max(low, 8)));
    if (node == nullptr) {
        return std::nullopt;
    }
    if (node->number < low || node->number > high) {
        mistakes_->add(node->place,
                       fmt::format("{} is {}; it must be between {} and {}", key, shown(*node), low, high));
        return std::nullopt;
    }
    return static_cast<int>(node->number);
}

std::vector<Word> Section::texts(std::string_view key, Need need) {
    const Node* node =
        take(key, need, {Node::Kind::text, Node::Kind::array}, "a list of texts", fmt::format("{} = [\"...\"]", key));
    if (node == nullptr) {
        return {};
    }
    if (node->kind == Node::Kind::text) {
        return {{node->text, node->place}};
    }
    std::vector<Word> words;
    for (const Node& item : node->items) {
        if (item.kind == Node::Kind::text) {
            words.push_back({item.text, item.place});
        } else {
            mistakes_->add(item.place, fmt::format("{} has {}; a text is wanted", key, shown(item)));
        }
    }
    return words;
}

}  // namespace tiretherm::input
