// SPDX-License-Identifier: BSD-3-Clause
// Checked reading of a TOML table; the calls of the reader are the schema of the table, and unknown keys are reported.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/schema/key.hpp"
#include "input/text/input_error.hpp"
#include "input/text/quantity.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {
/// A table that is being read. Forms, units, ranges and needs of its keys are those of its description (keys_of_table). A
/// wrong value becomes an error and is returned as if it were absent; at the end of its life the table reports the keys
/// that nobody has read.
class TomlTable {
public:
    /// @param name as messages show it: "[mesh]"; the case itself: "the case"
    TomlTable(const TomlValue& table, std::string name, InputErrors& errors);
    /// A table that is missing, which has been reported where it is required: none of its keys is reported again.
    TomlTable(const SourceLocation& place, std::string name, InputErrors& errors);
    ~TomlTable();
    TomlTable(const TomlTable&) = delete;
    TomlTable& operator=(const TomlTable&) = delete;

    [[nodiscard]] bool exists() const { return table_ != &nothing_; }
    [[nodiscard]] bool has(std::string_view key) const { return table_->find(key) != nullptr; }

    // The need is that of the description; a reader that knows better gives it.
    std::optional<double> quantity(std::string_view key, Need need = Need::described);
    /// A quantity whose unit and range follow from what the table is about.
    std::optional<double> quantity(std::string_view key, const QuantitySpec& spec, Need need = Need::described);
    std::optional<std::string> text(std::string_view key, Need need = Need::described);
    /// A text that later names a column or a data set: not empty, without brackets, quotes, slashes, commas and blanks
    /// at its ends.
    std::optional<std::string> name(std::string_view key, Need need = Need::described);
    /// One of the words of the description. @returns its index
    std::optional<std::size_t> choice(std::string_view key, Need need = Need::described);
    /// The same. @returns the word
    std::optional<std::string_view> word(std::string_view key, Need need = Need::described);
    /// One of several words that follow from what the table is about.
    std::optional<std::size_t> choice(std::string_view key, std::span<const std::string_view> options,
                                      Need need = Need::described);
    std::optional<bool> flag(std::string_view key);
    std::optional<int> count(std::string_view key, Need need = Need::described);
    /// Reads every key whose description names a member of this struct. What is absent or wrong leaves its member as it is.
    template <class Struct>
    void read_into(Struct& object) {
        read_members(&tag_of<Struct>, &object);
    }
    /// A list of texts, or one text.
    std::vector<LocatedString> texts(std::string_view key, Need need = Need::described);

    /// Two texts, the lower end of a range and the upper one. @returns nothing after an error, or where the key is absent
    std::optional<std::array<double, 2>> range(std::string_view key, const QuantitySpec& spec);

    /// The table of this key; one that does not exist when there is none.
    [[nodiscard]] TomlTable subtable(std::string_view key, Need need = Need::described);
    /// Reads each table of a list.
    /// @param example one entry as the user may write it; empty: its heading [[...]]
    void each(std::string_view key, const std::function<void(TomlTable&)>& read, Need need = Need::described,
              std::string_view example = {});
    /// The value as it stands, null when absent.
    const TomlValue* value(std::string_view key, Need need = Need::described, std::string_view example = {});

    [[nodiscard]] const TomlValue& content() const { return *table_; }
    [[nodiscard]] const SourceLocation& place() const { return table_->place; }
    /// Place of a value, or of the table when there is none.
    [[nodiscard]] SourceLocation place(std::string_view key) const;
    [[nodiscard]] const std::string& title() const { return name_; }
    [[nodiscard]] InputErrors& errors() const { return *errors_; }

    /// @returns nothing, as InputErrors::add
    std::nullopt_t add_error(std::string_view key, std::string what, std::string remedy = {}) const;
    /// Adds keys to those that are known, without reading them. @errors std::logic_error for one that is not described
    void declare_keys(std::initializer_list<std::string_view> keys);
    /// Unknown keys are not reported: after an error it is not known which keys belong here.
    void allow_unknown_keys() { unknown_keys_allowed_ = true; }
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }

private:
    /// The value when it is of an expected kind; otherwise an error and null.
    /// @param example what to write, which begins with the key or is the heading of its table
    const TomlValue* take(std::string_view key, Need need, std::initializer_list<TomlValue::Kind> kinds,
                          std::string_view expected, std::string_view example);
    void read_members(const char* owner, void* object);
    [[nodiscard]] std::optional<KeyValue> value_of(const Key& key);
    void report_missing(std::string_view key, std::string_view example) const;
    [[nodiscard]] const Key* find(std::string_view key) const;  ///< its description; null when absent
    /// The same. @errors std::logic_error where there is none: then the reader is wrong
    [[nodiscard]] const Key& described(std::string_view key) const;
    [[nodiscard]] bool is_required(std::string_view key, Need need) const;
    [[nodiscard]] std::string child_name(std::string_view key, bool list) const;

    TomlValue nothing_;
    const TomlValue* table_;
    std::string name_;
    const TableKeys* keys_;  ///< null where its keys are names that the user chooses
    InputErrors* errors_;
    std::vector<std::string> known_;
    bool unknown_keys_allowed_ = false;
};

/// The quantity of a text of a list; nothing after an error. @param name what messages call it
[[nodiscard]] std::optional<double> read_quantity(const LocatedString& text, const QuantitySpec& spec,
                                                  std::string_view name, InputErrors& errors);
/// Which of the known names a name is; nothing after an error, with the one that was probably meant.
/// @param what the error without the name: "there is no sensor"  @param plural of what they name: "sensors"
[[nodiscard]] std::optional<std::size_t> find_name(const LocatedString& name, const std::vector<std::string>& known,
                                                   std::string_view what, std::string_view plural, InputErrors& errors);

}  // namespace tiretherm::input
