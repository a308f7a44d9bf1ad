// SPDX-License-Identifier: BSD-3-Clause
// Walks along paths; whatever edits a document does it by these functions.

#include "input/toml/tree.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "input/text/characters.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

const std::string* name_text(const TomlValue& table) {
    const TomlValue* name = table.kind == TomlValue::Kind::table ? table.find("name") : nullptr;
    return name != nullptr && name->kind == TomlValue::Kind::text ? &name->text : nullptr;
}

/// The key with which a rest of a path begins: in a list the longest name of its tables, with or without dots in it,
/// otherwise what stands before the next dot.
std::string_view first_key(std::string_view rest, const TomlValue* list) {
    std::string_view found;
    for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i) {
        const std::string* name = name_text(list->items[i]);
        const bool here =
            name != nullptr && rest.starts_with(*name) && (rest.size() == name->size() || rest[name->size()] == '.');
        if (here && found.size() < name->size()) {
            found = rest.substr(0, name->size());
        }
    }
    return found.empty() ? rest.substr(0, rest.find('.')) : found;
}

std::vector<std::string> names_in(const TomlValue& list) {
    std::vector<std::string> names;
    for (const TomlValue& item : list.items) {
        if (const std::string* name = name_text(item)) {
            names.push_back(*name);
        }
    }
    return names;
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view key) const {
    const auto found = std::ranges::find(entries, key, &Entry::key);
    return found == entries.end() ? nullptr : &found->value;
}

TomlValue* TomlValue::find(std::string_view key) { return const_cast<TomlValue*>(std::as_const(*this).find(key)); }

const TomlValue* TomlValue::find(std::initializer_list<std::string_view> keys) const {
    const TomlValue* at = this;
    for (const std::string_view key : keys) {
        at = at != nullptr ? at->find(key) : nullptr;
    }
    return at;
}

TomlValue* TomlValue::find(std::initializer_list<std::string_view> keys) {
    return const_cast<TomlValue*>(std::as_const(*this).find(keys));
}

const TomlValue* TomlValue::find_named(std::string_view name) const {
    const auto found = std::ranges::find_if(items, [&](const TomlValue& item) {
        const std::string* its = name_text(item);
        return its != nullptr && *its == name;
    });
    return found == items.end() ? nullptr : &*found;
}

TomlValue* TomlValue::find_named(std::string_view name) {
    return const_cast<TomlValue*>(std::as_const(*this).find_named(name));
}

TomlValue& TomlValue::at(std::string_view key, const SourceLocation& place) {
    if (TomlValue* known = find(key)) {
        return *known;
    }
    return entries.emplace_back(Entry{.key = std::string(key), .place = place, .value = {}}).value;
}

void TomlValue::set(std::string_view key, TomlValue value, const SourceLocation& place) {
    at(key, place) = std::move(value);
}

void TomlValue::remove(std::string_view key) {
    std::erase_if(entries, [&](const Entry& entry) { return entry.key == key; });
}

TomlPath split_path(const LocatedString& text, const TomlValue& document) {
    TomlPath path;
    const TomlValue* at = &document;
    for (std::size_t begin = 0; begin <= text.text.size();) {
        const bool in_list = at != nullptr && at->kind == TomlValue::Kind::array;
        const std::string key(first_key(std::string_view(text.text).substr(begin), in_list ? at : nullptr));
        // The text begins behind its quotation mark.
        SourceLocation place = text.place;
        place.column += 1 + static_cast<int>(split_characters(text.text.substr(0, begin)).size());
        place.length = std::max<int>(1, static_cast<int>(split_characters(key).size()));
        path.push_back({key, place});
        at = at == nullptr ? nullptr : in_list ? at->find_named(key) : at->find(key);
        begin += key.size() + 1;  // up to the end itself: behind a last dot a key is missing, which is an empty one
    }
    return path;
}

std::string joined(const TomlPath& keys, std::size_t n) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
        text += (i > 0 ? "." : "") + keys[i].text;
    }
    return text;
}

const TomlValue* find(const TomlValue& document, const TomlPath& path) {
    const TomlValue* at = &document;
    for (const LocatedString& key : path) {
        at = at == nullptr                        ? nullptr
             : at->kind == TomlValue::Kind::array ? at->find_named(key.text)
                                                  : at->find(key.text);
    }
    return at;
}

bool set(TomlValue& document, const TomlPath& keys, const TomlValue& value, InputErrors& errors) {
    TomlValue* at = &document;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const LocatedString& key = keys[i];
        const bool is_last = i + 1 == keys.size();
        if (at->kind == TomlValue::Kind::array) {
            // A list is not made longer: a table with one key is seldom one that its reader takes.
            TomlValue* item = at->find_named(key.text);
            if (item == nullptr) {
                const std::vector<std::string> names = names_in(*at);
                errors.add(key.place, fmt::format("there is no \"{}\" in [[{}]]", key.text, joined(keys, i)),
                           names.empty() ? "its tables have no names, so none can be told from the others"
                                         : suggest(key.text, names, "names"));
                return false;
            }
            if (is_last) {
                SourceLocation whole = keys.front().place;
                whole.length = key.place.column + key.place.length - whole.column;
                errors.add(whole, fmt::format("\"{}\" is a table; one of its values is wanted", joined(keys, i + 1)),
                           fmt::format("go on with a key of it: \"{}.key\"", joined(keys, i + 1)));
                return false;
            }
            at = item;
            continue;
        }
        if (at->kind != TomlValue::Kind::table) {
            errors.add(key.place, fmt::format("{} is {}, which has no \"{}\"", joined(keys, i), shown(*at), key.text),
                       fmt::format("end the path there: \"{}\"", joined(keys, i)));
            return false;
        }
        TomlValue& next = at->at(key.text, key.place);
        if (is_last) {
            next = value;
            return true;
        }
        if (next.kind == TomlValue::Kind::nothing) {
            next.kind = TomlValue::Kind::table;
            next.place = key.place;
        }
        at = &next;
    }
    return false;
}

void unset(TomlValue& document, const LocatedString& path, InputErrors& errors) {
    const TomlPath keys = split_path(path, document);
    TomlValue* at = &document;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string& key = keys[i].text;
        const bool in_list = at->kind == TomlValue::Kind::array;
        TomlValue* next = in_list ? at->find_named(key) : at->find(key);
        if (next == nullptr) {
            errors.add(path.place, fmt::format("unset: no included file has \"{}\"", path.text),
                       in_list ? suggest(path.text.substr(joined(keys, i).size() + 1), names_in(*at),
                                         fmt::format("names in [[{}]]", keys[i - 1].text))
                               : suggest(key, names_of(at->entries, &Entry::key), "keys there"));
            return;
        }
        if (i + 1 < keys.size()) {
            at = next;
        } else if (in_list) {
            at->items.erase(at->items.begin() + (next - at->items.data()));
        } else {
            at->remove(key);
        }
    }
}

}  // namespace tiretherm::input
