// SPDX-License-Identifier: BSD-3-Clause
// A TOML document as values with their places in the files, independent of the parser, and the rules for `include`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

struct Entry;

/// A value of a case file and its place there. Independent of the parser: a table merged from several files still knows
/// the file of each of its values.
struct TomlValue {
    enum class Kind : std::uint8_t { nothing, text, integer, real, boolean, date, array, table };

    Kind kind = Kind::nothing;
    SourceLocation place;
    std::string text;              ///< of a text
    double number = 0.0;           ///< of an integer or a real
    bool truth = false;            ///< of a boolean
    bool in_braces = false;        ///< of a table: { ... }, which is one value; others are merged key by key
    std::vector<TomlValue> items;  ///< of an array
    std::vector<Entry> entries;    ///< of a table

    [[nodiscard]] bool is_number() const { return kind == Kind::integer || kind == Kind::real; }
    [[nodiscard]] const TomlValue* find(std::string_view key) const;  ///< null when absent
    [[nodiscard]] TomlValue* find(std::string_view key);
    /// The value below these keys of tables, null when one of them is absent.
    [[nodiscard]] const TomlValue* find(std::initializer_list<std::string_view> keys) const;
    [[nodiscard]] TomlValue* find(std::initializer_list<std::string_view> keys);
    /// The table of a list that has this name, null where there is none.
    [[nodiscard]] const TomlValue* find_named(std::string_view name) const;
    [[nodiscard]] TomlValue* find_named(std::string_view name);
    /// The value of a key, nothing yet where the key is new. @param place of a new key
    TomlValue& at(std::string_view key, const SourceLocation& place = {});
    /// Gives a key a value in the place of any other. @param place of a new key
    void set(std::string_view key, TomlValue value, const SourceLocation& place = {});
    void remove(std::string_view key);
};

/// A text with the place where it stands.
struct LocatedString {
    std::string text;
    SourceLocation place;
};

/// A key of a table, with the place of the key itself.
struct Entry {
    std::string key;
    SourceLocation place;
    TomlValue value;
};

/// The value as messages show it: `"abc"`, `8`, `a table`.
[[nodiscard]] std::string shown(const TomlValue& node);

/// The text of a file, which is read once for the same `errors` and their copies.
/// @param mentioned where the path was written; its file is -1 for the one that the user named
/// @returns the file's number in `errors` and its text, which `errors` and their copies keep; nothing after an error
struct TextFile {
    int number = -1;
    std::string_view text;
};
[[nodiscard]] std::optional<TextFile> read_text(const std::filesystem::path& path, const SourceLocation& mentioned,
                                                InputErrors& errors);
/// The same of a file that other programs write, in whatever encoding, as UTF-8 with line feeds.
[[nodiscard]] std::optional<TextFile> read_foreign_text(const std::filesystem::path& path,
                                                        const SourceLocation& mentioned, InputErrors& errors);

/// The tables of one TOML file, or nothing after an error.
[[nodiscard]] std::optional<TomlValue> parse_toml(const TextFile& file, InputErrors& errors);

/// A case file and what it includes, merged: tables key by key, the including file's values win, a later included
/// file wins over an earlier one. Lists and tables in braces are values and replaced as a whole; only the lists at the
/// top of a file whose tables have a `name` ([[material]], [[sensor]], [[run]]) are merged by it. A table that changes
/// its `kind` is replaced as well. Nothing when a file could not be read.
/// @param text of the file at `path`, which is then not looked at; null: as it is there
[[nodiscard]] std::optional<TomlValue> read_document(const std::filesystem::path& path, InputErrors& errors,
                                                     const std::string* text = nullptr);

/// The tables `names` of `over` laid over those of a document as an including file's are, also where they stand in
/// braces. What is of another type than in the document is left out, for its reader to report.
void override_tables(TomlValue& document, const TomlValue& over, std::span<const std::string_view> names);

}  // namespace tiretherm::input
