// SPDX-License-Identifier: BSD-3-Clause
// Typed values of a TOML table: quantities, texts, names, choices, flags, counts and lists of texts.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "input/text/characters.hpp"
#include "input/text/suggestions.hpp"
#include "input/toml/toml_table.hpp"

namespace tiretherm::input {

std::optional<double> TomlTable::quantity(std::string_view key, Need need) {
    return quantity(key, described(key).spec, need);
}

std::optional<double> TomlTable::quantity(std::string_view key, const QuantitySpec& spec, Need need) {
    declare_keys({key});
    const TomlValue* node = table_->find(key);
    if (node == nullptr || (node->kind != TomlValue::Kind::text && !node->is_number())) {
        if (node != nullptr || is_required(key, need)) {
            const Dimension what = dimension(spec.unit, spec.scale);
            take(key, need, {}, what.name, fmt::format("{} = {}", key, spell_example(spec)));
        }
        return std::nullopt;
    }
    ParsedQuantity parsed;
    if (node->kind == TomlValue::Kind::text) {
        parsed = parse_quantity(node->text, spec, key);
    } else if (spec.is_pure()) {
        parsed = check_quantity(node->number, {}, "", spec, key, shown(*node));
    } else {
        parsed.error = ErrorText{fmt::format("{} is {}, without a unit", key, shown(*node)), write_like(spec)};
    }
    if (parsed.error) {
        return errors_->add(node->place, *parsed.error);
    }
    if (!parsed.remark.empty()) {
        errors_->warn(node->place, parsed.remark);
    }
    return parsed.value;
}

std::optional<std::string> TomlTable::text(std::string_view key, Need need) {
    const TomlValue* node = take(key, need, {TomlValue::Kind::text}, "a text", fmt::format("{} = \"...\"", key));
    return node == nullptr ? std::nullopt : std::optional(node->text);
}

std::optional<std::string> TomlTable::name(std::string_view key, Need need) {
    std::optional<std::string> name = text(key, need);
    if (!name) {
        return std::nullopt;
    }
    const bool control =
        std::any_of(name->begin(), name->end(), [](char c) { return static_cast<unsigned char>(c) < ' '; });
    // A dot begins the folders "..", of somebody else, and ".tiretherm", of the program.
    if (name->empty() || name->front() == '.' || trim(*name) != *name || control ||
        name->find_first_of("[]{}\"'`,;/\\") != std::string::npos) {
        add_error(key, fmt::format("{} is \"{}\", which cannot name a column or a folder", key, *name),
                  "use letters, digits and underscores");
        return std::nullopt;
    }
    return name;
}

std::optional<std::size_t> TomlTable::choice(std::string_view key, Need need) {
    return choice(key, described(key).words, need);
}

std::optional<std::string_view> TomlTable::word(std::string_view key, Need need) {
    const std::optional<std::size_t> index = choice(key, need);
    return index ? std::optional(described(key).words[*index]) : std::nullopt;
}

std::optional<std::size_t> TomlTable::choice(std::string_view key, std::span<const std::string_view> options,
                                             Need need) {
    const std::vector<std::string> known(options.begin(), options.end());
    const TomlValue* node =
        take(key, need, {TomlValue::Kind::text}, "a word", fmt::format("{} = \"{}\"", key, known.front()));
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto found = std::find(options.begin(), options.end(), node->text);
    if (found == options.end()) {
        return errors_->add(node->place, fmt::format("{} cannot be \"{}\"", key, node->text),
                            suggest(node->text, known, "possible words"));
    }
    return static_cast<std::size_t>(found - options.begin());
}

std::optional<bool> TomlTable::flag(std::string_view key) {
    const TomlValue* node =
        take(key, Need::optional, {TomlValue::Kind::boolean}, "true or false", fmt::format("{} = true", key));
    return node == nullptr ? std::nullopt : std::optional(node->truth);
}

std::optional<int> TomlTable::count(std::string_view key, Need need) {
    const auto [low, high] = std::pair(described(key).low, described(key).high);
    const TomlValue* node =
        take(key, need, {TomlValue::Kind::integer}, "a whole number", fmt::format("{} = {}", key, std::max(low, 8)));
    if (node == nullptr) {
        return std::nullopt;
    }
    // Compared as numbers: a count beyond the integers of the program must not turn into one that is allowed.
    if (node->number < low || node->number > high) {
        return errors_->add(node->place,
                            fmt::format("{} is {}; it must be between {} and {}", key, shown(*node), low, high));
    }
    return static_cast<int>(node->number);
}

std::vector<LocatedString> TomlTable::texts(std::string_view key, Need need) {
    const TomlValue* node = take(key, need, {TomlValue::Kind::text, TomlValue::Kind::array}, "a list of texts",
                                 fmt::format("{} = [\"...\"]", key));
    if (node == nullptr) {
        return {};
    }
    if (node->kind == TomlValue::Kind::text) {
        return {{node->text, node->place}};
    }
    std::vector<LocatedString> words;
    for (const TomlValue& item : node->items) {
        if (item.kind == TomlValue::Kind::text) {
            words.push_back({item.text, item.place});
        } else {
            errors_->add(item.place, fmt::format("{} has {}; a text is wanted", key, shown(item)),
                         fmt::format("write {} = [\"...\"]", key));
        }
    }
    return words;
}

std::optional<std::array<double, 2>> TomlTable::range(std::string_view key, const QuantitySpec& spec) {
    const std::size_t before = errors_->count();
    const std::vector<LocatedString> ends = texts(key);
    if (!has(key) || errors_->count() > before) {
        return std::nullopt;
    }
    if (ends.size() != 2) {
        return add_error(key, "a range has two ends",
                         fmt::format("write {} = [{}, \"...\"]", key, spell_example(spec)));
    }
    const auto low = read_quantity(ends[0], spec, key, *errors_);
    const auto high = read_quantity(ends[1], spec, key, *errors_);
    if (low && high && *low > *high) {
        return add_error(key, "the range begins with its upper end", "swap the two ends");
    }
    return low && high ? std::optional(std::array{*low, *high}) : std::nullopt;
}

std::optional<KeyValue> TomlTable::value_of(const Key& key) {
    const auto as_value = [](const auto& found) { return found ? std::optional<KeyValue>(*found) : std::nullopt; };
    switch (key.form) {
        case KeyForm::quantity:
            return as_value(quantity(key.name));
        case KeyForm::count:
            return as_value(count(key.name));
        case KeyForm::flag:
            return as_value(flag(key.name));
        case KeyForm::text:
            return as_value(text(key.name));
        case KeyForm::name:
            return as_value(name(key.name));
        case KeyForm::choice: {
            const std::optional<std::size_t> index = choice(key.name);
            return index ? std::optional<KeyValue>(Word{*index, key.words[*index]}) : std::nullopt;
        }
        default:
            throw std::logic_error(fmt::format("{} of {} has no form that a member takes", key.name, name_));
    }
}

void TomlTable::read_members(const char* owner, void* object) {
    for (const Key& key : keys_->keys) {
        for (const Member& member : key.members) {
            if (member.owner != owner || find(key.name) != &key) {
                continue;
            }
            if (const std::optional<KeyValue> value = value_of(key)) {
                member.store(object, *value);
            }
        }
    }
}

std::optional<double> read_quantity(const LocatedString& text, const QuantitySpec& spec, std::string_view name,
                                    InputErrors& errors) {
    const ParsedQuantity parsed = parse_quantity(text.text, spec, name);
    return parsed.error ? errors.add(text.place, *parsed.error) : std::optional(parsed.value);
}

std::optional<std::size_t> find_name(const LocatedString& name, const std::vector<std::string>& known,
                                     std::string_view what, std::string_view plural, InputErrors& errors) {
    const auto found = std::ranges::find(known, name.text);
    if (found == known.end()) {
        return errors.add(name.place, fmt::format("{} \"{}\"", what, name.text), suggest(name.text, known, plural));
    }
    return static_cast<std::size_t>(found - known.begin());
}

}  // namespace tiretherm::input
