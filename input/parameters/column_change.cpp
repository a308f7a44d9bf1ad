// SPDX-License-Identifier: BSD-3-Clause
// Sets keys of `columns` and `units`, and makes [[run]] tables of files where a key is of one run.

#include "input/parameters/column_change.hpp"

#include <algorithm>

#include "input/drive/run_table.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

/// A value of a case as a value in braces or brackets, whether or not it had a heading of its own.
TomlValue in_one_line(TomlValue value) {
    value.in_braces = true;
    for (TomlValue& item : value.items) {
        item.in_braces = true;
    }
    return value;
}

/// The table at a key, made where there is none. What is new stands where the table around it stands, for messages about it.
TomlValue& table_at(TomlValue& within, std::string_view key, bool in_braces) {
    TomlValue& table = within.at(key, within.place);
    if (table.kind != TomlValue::Kind::table) {
        table = toml_text::table_value();
        table.in_braces = in_braces;
        table.place = within.place;
    }
    return table;
}

/// Lets a new table and its keys stand somewhere: paths are relative to the file in which they stand.
void take_place(TomlValue& table, const SourceLocation& place) {
    table.place = place;
    for (Entry& entry : table.entries) {
        if (entry.value.place.file < 0) {
            entry.place = entry.value.place = place;
        }
    }
}

void set_word(TomlValue& table, std::string_view key, const std::string& heading, const std::string& word) {
    if (!word.empty()) {
        TomlValue value = toml_text::text_value(word);
        value.place = table.place;
        table_at(table, key, true).set(heading, std::move(value), table.place);
    }
}

bool says(const TomlValue& table, std::string_view key, const std::string& heading) {
    return table.find({key, heading}) != nullptr;
}

}  // namespace

void change_column(TomlValue& table, const ColumnChange& change) {
    set_word(table, "columns", change.heading, change.name);
    set_word(table, "units", change.heading, change.unit);
}

bool says_column(const TomlValue& table, const ColumnChange& change) {
    return (!change.name.empty() && says(table, "columns", change.heading)) ||
           (!change.unit.empty() && says(table, "units", change.heading));
}

void change_columns(TomlValue& document, const std::vector<ColumnChange>& changes,
                    std::vector<std::filesystem::path>& data) {
    if (changes.empty()) {
        return;
    }
    if (!document.entries.empty()) {
        document.place = document.entries.front().place;
    }
    const auto of_all = [](const ColumnChange& change) { return change.run.empty(); };
    for (const ColumnChange& change : changes) {
        if (of_all(change)) {
            change_column(table_at(document, "data", false), change);
        }
    }
    // [data] counts for all files: a key of one run needs a table of its own, and then each file needs one.
    if (!data.empty() && !std::ranges::all_of(changes, of_all)) {
        std::vector<TomlValue> tables;
        for (const std::filesystem::path& file : data) {
            const TomlValue* shared = document.find("data");
            const TomlValue* laps = document.find({"data", "laps"});
            const std::string name = name_beside(data, file, laps != nullptr ? laps->text : "");
            tables.push_back(run_table_of_file(name, std::filesystem::absolute(file), shared, {}));
            take_place(tables.back(), document.place);
        }
        document.set("run", toml_text::list_value(std::move(tables)), document.place);
        data.clear();
    }
    TomlValue* const runs = data.empty() ? document.find("run") : nullptr;
    if (runs == nullptr) {
        return;
    }
    for (TomlValue& run : runs->items) {
        for (const ColumnChange& change : changes) {
            // What a run says itself wins over [data].
            if (change.run.empty() ? says_column(run, change) : name_of_run_table(run) == change.run) {
                change_column(run, change);
            }
        }
    }
}

TomlValue run_table_of_file(const std::string& name, const std::filesystem::path& file, const TomlValue* data,
                            const std::filesystem::path& folder) {
    TomlValue table = toml_text::table_value();
    table.in_braces = false;
    // A list in which a name is missing takes the place of the original's runs instead of joining them.
    if (file.empty() || name != file.stem().string()) {
        table.set("name", toml_text::text_value(name));
    }
    if (!file.empty()) {
        table.set("file",
                  folder.empty() ? toml_text::text_value(file.generic_string()) : toml_text::path_value(file, folder));
        for (const Entry& entry : data != nullptr ? data->entries : std::vector<Entry>{}) {
            table.set(entry.key, in_one_line(entry.value));
        }
    }
    return table;
}

}  // namespace tiretherm::input
