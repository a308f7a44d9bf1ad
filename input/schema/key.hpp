// SPDX-License-Identifier: BSD-3-Clause
// One description of a key of a case: name, form, unit and range, need, kinds of the table that have it and meaning.
// Readers take units and ranges from it, `tiretherm keys` and docs/case-reference.md print it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "input/text/quantity.hpp"

namespace tiretherm::input {

enum class Need : std::uint8_t {
    optional,
    required,
    sometimes,  ///< of some kinds of the table, or beside some other key: the reader says when
    described,  ///< to a reader: as the description of the key says
};

/// How a value is written.
enum class KeyForm : std::uint8_t {
    value,  ///< as the sentence says
    text,
    name,    ///< a text that later names a column or a folder
    texts,   ///< a text, or a list of texts
    choice,  ///< one of `words`
    flag,
    count,  ///< a whole number from `low` to `high`
    quantity,
    quantity_of_owner,  ///< unit and range are those of what the table is about: a channel, a parameter, a law
    quantity_or_text,
    law,  ///< a quantity, or a table that says how it follows temperature
    table,
    tables,  ///< a list of tables
};

/// One of the words of a choice.
struct Word {
    std::size_t index = 0;
    std::string_view text;
};
/// A value as it was read: a quantity in SI units, a count, a flag, a text or a word.
using KeyValue = std::variant<double, int, bool, std::string, Word>;

/// What tells one struct from another.
template <class Struct>
inline constexpr char tag_of{};

/// The member of a struct that takes a value.
struct Member {
    const char* owner = nullptr;                                   ///< tag_of the struct
    void (*store)(void* object, const KeyValue& value) = nullptr;  ///< of a value that has the form of the key
};
template <class Struct, class Type, Type Struct::*member>
[[nodiscard]] constexpr Member member_of() {
    return {&tag_of<Struct>, [](void* object, const KeyValue& value) {
                auto& into = static_cast<Struct*>(object)->*member;
                if constexpr (std::is_enum_v<Type>) {
                    into = static_cast<Type>(std::get<Word>(value).index);
                } else if constexpr (std::is_same_v<Type, std::optional<double>>) {
                    into = std::get<double>(value);
                } else {
                    into = std::get<Type>(value);
                }
            }};
}
template <auto member>
struct MemberPointer;
template <class Struct, class Type, Type Struct::*member>
struct MemberPointer<member> {
    static constexpr Member value = member_of<Struct, Type, member>();
};

struct Key {
    std::string_view name;
    KeyForm form = KeyForm::value;
    std::string_view sentence;  ///< what it means, with its default
    QuantitySpec spec{};
    std::vector<std::string_view> words{};  ///< of a choice; where a reader makes an enumeration of them, in its order
    int low = 0;
    int high = 0;
    Need need = Need::optional;
    std::string_view of_kinds{};  ///< kinds of the table that have it, a blank apart; empty: all
    std::vector<Member>
        members{};  ///< which TomlTable::read_into fills; empty: the reader of the table asks for the value

    [[nodiscard]] Key required() && { return (need = Need::required, std::move(*this)); }
    [[nodiscard]] Key sometimes() && { return (need = Need::sometimes, std::move(*this)); }
    [[nodiscard]] Key kinds(std::string_view kinds) && { return (of_kinds = kinds, std::move(*this)); }
    /// The value goes to this member, whose default is that of the key.
    template <auto member>
    [[nodiscard]] Key into() && {
        return (members.push_back(MemberPointer<member>::value), std::move(*this));
    }
    /// @param kind word of the table's `kind`; empty where it has none
    [[nodiscard]] bool is_of(std::string_view kind) const;
};

enum class TableForm : std::uint8_t { table, list };

/// A table of a case, of a study or of a table of measured numbers.
struct TableKeys {
    std::string_view path;  ///< "mesh.layer"; "" for the top of a case, "study:" and "table:" of the other two files
    TableForm form = TableForm::table;
    std::string_view sentence;
    std::vector<Key> keys;
    bool has_names = false;  ///< beside these, its keys are names: of layers, of effects and their parameters

    /// @param kind word of the table's `kind`; empty: the first key of that name
    /// @returns null where the table has no such key
    [[nodiscard]] const Key* find(std::string_view name, std::string_view kind = {}) const;
};

}  // namespace tiretherm::input
