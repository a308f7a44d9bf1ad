// SPDX-License-Identifier: BSD-3-Clause
// The reference of keys is what the readers ask for: complete, with a sentence for each key and a key for each sentence.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "input/reference/case_keys.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".toml") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

const CaseTable& table(const std::vector<CaseTable>& tables, std::string_view path) {
    return *std::ranges::find(tables, path, &CaseTable::path);
}

const CaseKey& key(const std::vector<CaseTable>& tables, std::string_view path, std::string_view name) {
    return *std::ranges::find(table(tables, path).keys, name, &CaseKey::key);
}

}  // namespace

TEST(CaseKeys, EveryKeyHasASentenceAndEverySentenceAKey) {
    std::vector<std::string> unknown;
    EXPECT_FALSE(case_tables(&unknown).empty());
    for (const std::string& sentence : unknown) {
        ADD_FAILURE() << sentence;
    }
}

// What the readers ask of the shipped and of the wrong cases is in the reference, so that no branch of a reader has been
// missed by the made-up files.
TEST(CaseKeys, ShippedAndWrongCasesAskForNothingElse) {
    std::set<KeyName> known;
    for (const CaseTable& one : case_tables()) {
        for (const CaseKey& entry : one.keys) {
            known.insert({one.path, entry.key});
        }
    }
    std::set<KeyName> missing;
    const fs::path root(TIRETHERM_SOURCE_DIR);
    for (const fs::path& folder : {root / "cases", root / "tests/bad_cases"}) {
        for (const KeyUse& use : keys_asked(files_below(folder))) {
            const std::optional<KeyName> name = name_in_reference(use);
            if (name && !known.contains(*name)) {
                missing.insert(*name);
            }
        }
    }
    for (const KeyName& name : missing) {
        ADD_FAILURE() << name.key << " of [" << name.table << "]";
    }
}

// By hand, from input/model/mesh_patch.cpp and its neighbours.
TEST(CaseKeys, SayWhatTheReadersTake) {
    const std::vector<CaseTable> tables = case_tables();
    const CaseKey& thickness = key(tables, "mesh.layer", "thickness");
    EXPECT_TRUE(thickness.required);
    EXPECT_EQ(thickness.uses.front().form, KeyForm::quantity);
    EXPECT_EQ(thickness.uses.front().unit, "m");
    EXPECT_TRUE(table(tables, "mesh.layer").is_list);
    EXPECT_FALSE(table(tables, "mesh").is_list);
    const CaseKey& cells = key(tables, "mesh", "crown_cells");
    EXPECT_EQ(cells.variants, std::vector<std::string>{"section"});
    EXPECT_EQ(cells.uses.front().form, KeyForm::count);
    EXPECT_EQ(cells.uses.front().low, 1);
    const CaseKey& kind = key(tables, "mesh", "kind");
    EXPECT_TRUE(kind.variants.empty());
    EXPECT_EQ(kind.uses.front().options.size(), 6U);
    EXPECT_EQ(key(tables, "identify", "noise").uses.front().options,
              (std::vector<std::string>{"automatic", "correlated", "white"}));
    const CaseKey& end = key(tables, "time", "end");
    EXPECT_FALSE(end.required);
    EXPECT_TRUE(end.sometimes_required);
}

// Names that a user chooses are no keys: columns of a file, layers, parameters of an effect.
TEST(CaseKeys, NamesOfTheUserAreNone) {
    EXPECT_FALSE(name_in_reference({.table = "[run.columns]", .key = "V"}));
    EXPECT_FALSE(name_in_reference({.table = "[initial]", .key = "tread"}));
    EXPECT_FALSE(name_in_reference({.table = "[effects.road_contact]", .key = "Hc"}));
    EXPECT_FALSE(name_in_reference({.table = "[effects.road_contact]", .key = "Hc_by_patch"}));
    EXPECT_EQ(name_in_reference({.table = "[effects.road_contact]", .key = "on"}), (KeyName{"effects.NAME", "on"}));
    EXPECT_EQ(name_in_reference({.table = "[material.conductivity]", .key = "at"}), (KeyName{"law", "at"}));
    EXPECT_EQ(name_in_reference({.table = "the case", .key = "title"}), (KeyName{"", "title"}));
}

TEST(KeyRecord, ListensOnlyWhileItLives) {
    EXPECT_FALSE(KeyRecord::is_on());
    KeyRecord::add({.key = "before"});
    {
        const KeyRecord record;
        EXPECT_TRUE(KeyRecord::is_on());
        KeyRecord::add({.key = "during"});
        ASSERT_EQ(record.uses().size(), 1U);
        EXPECT_EQ(record.uses().front().key, "during");
    }
    EXPECT_FALSE(KeyRecord::is_on());
}

}  // namespace tiretherm::input
