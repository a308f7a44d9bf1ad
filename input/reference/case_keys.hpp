// SPDX-License-Identifier: BSD-3-Clause
// Every table and key that the readers know, as they ask for them (KeyRecord), with the sentences of keys.list. This is
// what `tiretherm keys` prints and docs/case-reference.md holds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/toml/key_record.hpp"

namespace tiretherm::input {

/// A key as the readers take it.
struct CaseKey {
    std::string key;
    std::string sentence;
    std::vector<KeyUse> uses;           ///< of different forms; the first is the most particular
    std::vector<std::string> variants;  ///< kinds of the table that have it; empty: all
    bool required = false;              ///< wherever it is read
    bool sometimes_required = false;    ///< by some of the kinds, or beside some other key
};

struct CaseTable {
    std::string path;  ///< "mesh.layer"; "" for the top of a case, "study:" and "table:" of the other two files
    bool is_list = false;
    std::string sentence;
    std::vector<CaseKey> keys;
};

/// All of them, in the order of keys.list. Reads made-up cases of every kind, so that every reader is heard.
/// @param unknown out, where given: keys that readers know and keys.list does not, and the reverse, as sentences
[[nodiscard]] std::vector<CaseTable> case_tables(std::vector<std::string>* unknown = nullptr);

/// A key by table and name, as the reference has it; nothing for names that a user chooses (layers, columns, parameters
/// of an effect).
struct KeyName {
    std::string table;
    std::string key;

    auto operator<=>(const KeyName&) const = default;
};
[[nodiscard]] std::optional<KeyName> name_in_reference(const KeyUse& use);

/// What the readers ask while they read these files: cases, studies and tables of measured numbers. Errors do not matter.
[[nodiscard]] std::vector<KeyUse> keys_asked(const std::vector<std::filesystem::path>& files);

/// Made-up files that lead every reader through every branch: name and text.
struct MadeUpFile {
    std::string_view name;
    std::string_view text;
};
[[nodiscard]] const std::vector<MadeUpFile>& files_of_every_kind();

}  // namespace tiretherm::input
