// SPDX-License-Identifier: BSD-3-Clause
// Looks up what [[run]] and [data] say about a column, and tracks which of their keys a file has.

#include <algorithm>

#include <fmt/format.h>

#include "input/drive/run_table.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

void ColumnKeys::read_words(TomlTable table, std::vector<Key>& into) {
    for (const Entry& entry : table.content().entries) {
        if (const std::optional<std::string> word = table.text(entry.key)) {
            into.push_back({.column = {entry.key, entry.place}, .value = {*word, entry.value.place}});
        }
    }
}

void ColumnKeys::read(TomlTable& table) {
    read_words(table.subtable("columns"), names_);
    read_words(table.subtable("units"), units_);
    read_words(table.subtable("unit_names"), unit_names_);
    keep_suspicious_ = table.flag("keep_suspicious");
    has_ignored_ = table.has("ignore");
    for (LocatedString& word : table.texts("ignore")) {
        ignored_.push_back({.column = std::move(word), .value = {}});
    }
    has_held_ = table.has("hold");
    for (LocatedString& word : table.texts("hold")) {
        held_.push_back({.column = std::move(word), .value = {}});
    }
}

bool ColumnKeys::keeps_suspicious() const {
    return keep_suspicious_.value_or(shared_ != nullptr && shared_->keeps_suspicious());
}

ColumnKeys::Key* ColumnKeys::find(std::vector<Key>& keys, const std::string& word) {
    Key* first = nullptr;
    for (Key& key : keys) {
        if (key.column.text == word) {
            key.found = true;
            first = first == nullptr ? &key : first;
        }
    }
    return first;
}

const LocatedString* ColumnKeys::mapped_name(const std::string& heading) {
    headings_.insert(heading);
    if (const Key* key = find(names_, heading)) {
        return &key->value;
    }
    const LocatedString* name = shared_ != nullptr ? shared_->mapped_name(heading) : nullptr;
    const auto is_mine = [&](const Key& own) { return own.value.text == name->text; };
    return name != nullptr && std::ranges::none_of(names_, is_mine) ? name : nullptr;
}

LocatedString ColumnKeys::name_of(const std::string& heading, const SourceLocation& place) {
    const LocatedString* name = mapped_name(heading);
    return name != nullptr ? *name : LocatedString{heading, place};
}

const LocatedString* ColumnKeys::value_of(std::vector<Key> ColumnKeys::*keys, const std::string& word) {
    if (const Key* key = find(this->*keys, word)) {
        return &key->value;
    }
    return shared_ != nullptr ? shared_->value_of(keys, word) : nullptr;
}

bool ColumnKeys::ignores(const std::string& heading) {
    return has_ignored_ || shared_ == nullptr ? find(ignored_, heading) != nullptr : shared_->ignores(heading);
}

bool ColumnKeys::holds(const std::string& name) {
    return has_held_ || shared_ == nullptr ? find(held_, name) != nullptr : shared_->holds(name);
}

void ColumnKeys::allow_unknown_keys() {
    unknown_keys_allowed_ = true;
    if (shared_ != nullptr) {
        shared_->allow_unknown_keys();
    }
}

std::vector<const ColumnKeys::Key*> ColumnKeys::unknown_columns() const {
    std::vector<const Key*> unknown;
    for (const std::vector<Key>* keys : {&names_, &units_, &ignored_}) {
        for (const Key& key : *keys) {
            if (!key.found) {
                unknown.push_back(&key);
            }
        }
    }
    return unknown;
}

void ColumnKeys::report_unknown_columns(InputErrors& errors) const {
    if (shared_ != nullptr) {
        shared_->warn_of_unknown_columns(errors);
    }
    if (unknown_keys_allowed_) {
        return;
    }
    const std::vector<std::string> known(headings_.begin(), headings_.end());
    for (const Key* key : unknown_columns()) {
        errors.add(key->column.place, fmt::format("the file has no column \"{}\"", key->column.text),
                   suggest(key->column.text, known, "columns"));
    }
    for (const Key& key : held_) {
        if (!key.found) {
            errors.add(key.column.place,
                       fmt::format("hold: no column of the file is the input \"{}\"", key.column.text),
                       "name an input as the model calls it, hold = [\"laser_power\"]");
        }
    }
    for (const Key& key : unit_names_) {
        if (!key.found) {
            errors.warn(key.column.place, "no column of the file is in [{}]", key.column.text);
        }
    }
}

void ColumnKeys::warn_of_unknown_columns(InputErrors& errors) const {
    if (shared_ != nullptr) {
        shared_->warn_of_unknown_columns(errors);
    }
    if (unknown_keys_allowed_) {
        return;
    }
    const std::vector<std::string> known(headings_.begin(), headings_.end());
    for (const Key* key : unknown_columns()) {
        const std::string near = nearest(key->column.text, known);
        errors.warn(key->column.place, "no file of a [[run]] has the column \"{}\"{}", key->column.text,
                    near.empty() ? "" : fmt::format(": did you mean `{}`?", near));
    }
}

}  // namespace tiretherm::input
