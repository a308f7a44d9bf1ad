// SPDX-License-Identifier: BSD-3-Clause
// What the readers ask of a case, recorded while they read: the calls of a reader are the schema of its table, so the
// case reference is made of these calls and not of a copy of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "input/text/quantity.hpp"

namespace tiretherm::input {

/// In which form a reader takes a value.
enum class KeyForm : std::uint8_t { mentioned, any, text, name, texts, choice, flag, count, quantity, table, tables };

/// One call of a reader.
struct KeyUse {
    std::string table{};    ///< as messages call it: "[[mesh.layer]]"
    std::string variant{};  ///< the `kind` of the table, or the word that says what it is about; often empty
    std::string key{};
    KeyForm form = KeyForm::mentioned;
    bool required = false;
    QuantitySpec spec{};                 ///< of a quantity
    std::string unit{};                  ///< of a quantity, which may outlive its spec's
    std::vector<std::string> options{};  ///< of a choice
    int low = 0;                         ///< of a count
    int high = 0;                        ///< of a count
};

/// Records the calls of all readers of this thread while it lives. Only one at a time.
class KeyRecord {
public:
    KeyRecord();
    ~KeyRecord();
    KeyRecord(const KeyRecord&) = delete;
    KeyRecord& operator=(const KeyRecord&) = delete;

    [[nodiscard]] const std::vector<KeyUse>& uses() const { return uses_; }

    /// Adds a call where something records; otherwise does nothing.
    static void add(KeyUse use);
    [[nodiscard]] static bool is_on();

private:
    std::vector<KeyUse> uses_;
};

}  // namespace tiretherm::input
