// SPDX-License-Identifier: BSD-3-Clause
// Includes of TOML files: which value wins, how tables and lists merge, and where each value comes from.

#include <algorithm>

#include <gtest/gtest.h>

#include "input/toml/document.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// The merged document of "case.toml" in a folder.
TomlValue document(const Written& written, InputErrors& errors) {
    const std::optional<TomlValue> node = read_document(written.folder() / "case.toml", errors);
    EXPECT_TRUE(node.has_value());
    return node.value_or(TomlValue{});
}

const TomlValue& at(const TomlValue& node, std::initializer_list<std::string_view> keys) {
    static const TomlValue nothing;
    const TomlValue* found = node.find(keys);
    EXPECT_NE(found, nullptr);
    return found != nullptr ? *found : nothing;
}

std::string place(const InputErrors& errors, const TomlValue& node) {
    return std::filesystem::path(errors.file(node.place.file)).filename().string() + ":" +
           std::to_string(node.place.line) + ":" + std::to_string(node.place.column);
}

}  // namespace

// Tables of a list go by their names, which may have blanks and dots; a key of one goes alone.
TEST(Include, UnsetTakesATableOfAListAwayByItsName) {
    const Written written;
    written.add("base.toml",
                std::string(slab) +
                    "[[sensor]]\nname = \"spot\"\nkind = \"point\"\ndepth = \"0 mm\"\n"
                    "[[sensor]]\nname = \"kept\"\nkind = \"point\"\ndepth = \"1 mm\"\nmeaning = \"below\"\n");
    const Reading reading = read_case(
        written.add("case.toml", "include = [\"base.toml\"]\nunset = [\"sensor.spot\", \"sensor.kept.meaning\"]\n"));
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_TRUE(
        std::ranges::none_of(reading.problem->channels, [](const auto& channel) { return channel.name == "spot"; }));
    EXPECT_TRUE(
        std::ranges::any_of(reading.problem->channels, [](const auto& channel) { return channel.name == "kept"; }));
    const Reading wrong =
        read_case(written.add("wrong.toml", "include = [\"base.toml\"]\nunset = [\"sensor.spott\"]\n"));
    EXPECT_NE(render(wrong).find("unset: no included file has \"sensor.spott\""), std::string::npos);
    EXPECT_NE(render(wrong).find("did you mean `spot`?"), std::string::npos) << render(wrong);
}

// A list in a table is replaced as a whole by an including file; a path leads to one value of one of its tables.
TEST(Include, SetChangesOneValueWithinAListOfAnIncludedFile) {
    const Written written;
    written.add("base.toml",
                "[a]\nx = 1\n[[a.layer]]\nname = \"tread\"\nthickness = \"8 mm\"\n"
                "[[a.layer]]\nname = \"belt\"\nthickness = \"3 mm\"\n");
    written.add(
        "case.toml",
        "include = [\"base.toml\"]\n[set]\n\"a.layer.tread.thickness\" = \"7 mm\"\n\"a.x\" = 2\n\"a.b.new\" = true\n");
    InputErrors errors;
    const TomlValue node = document(written, errors);
    EXPECT_EQ(errors.count(), 0U);
    const TomlValue& layers = at(node, {"a", "layer"});
    ASSERT_EQ(layers.items.size(), 2U);
    EXPECT_EQ(layers.items[0].find("thickness")->text, "7 mm");
    EXPECT_EQ(layers.items[1].find("thickness")->text, "3 mm");
    EXPECT_EQ(at(node, {"a", "x"}).number, 2.0);
    EXPECT_TRUE(at(node, {"a", "b", "new"}).truth);
    EXPECT_EQ(node.find("set"), nullptr);
}

TEST(Include, SetSaysAtItsOwnLineWhatItDoesNotFind) {
    const Written written;
    written.add("base.toml", "[[a]]\nname = \"tread\"\nthickness = \"8 mm\"\n");
    written.add("case.toml", "include = [\"base.toml\"]\n[set]\n\"a.tred.thickness\" = \"7 mm\"\n");
    InputErrors errors;
    static_cast<void>(document(written, errors));
    ASSERT_EQ(errors.count(), 1U);
    EXPECT_EQ(errors.in_order()[0].what, "there is no \"tred\" in [[a]]");
    EXPECT_EQ(errors.in_order()[0].line, 3);
    EXPECT_EQ(errors.in_order()[0].remedy, "did you mean `tread`?");
    const Reading alone = read_case(written.add("alone.toml", "set = { \"drive.speed\" = 3 }\n" + std::string(bench)));
    EXPECT_NE(render(alone).find("set gives values to keys of included files, and this file includes none"),
              std::string::npos)
        << render(alone);
}

TEST(Include, TheIncludingFileWinsKeyByKeyAndEveryValueKnowsItsFile) {
    const Written written;
    written.add("base.toml", "[a]\nx = 1\ny = 2\n[a.b]\nz = 3\n");
    written.add("case.toml", "include = [\"base.toml\"]\n[a]\n  y = 20\nnew = 4\n");
    InputErrors errors;
    const TomlValue merged = document(written, errors);
    EXPECT_EQ(at(merged, {"a", "x"}).number, 1.0);
    EXPECT_EQ(at(merged, {"a", "y"}).number, 20.0);
    EXPECT_EQ(at(merged, {"a", "b", "z"}).number, 3.0);
    EXPECT_EQ(at(merged, {"a", "new"}).number, 4.0);
    EXPECT_EQ(place(errors, at(merged, {"a", "x"})), "base.toml:2:5");
    EXPECT_EQ(place(errors, at(merged, {"a", "y"})), "case.toml:3:7");
    EXPECT_EQ(place(errors, at(merged, {"a", "b", "z"})), "base.toml:5:5");
    EXPECT_EQ(merged.find("include"), nullptr);
}

TEST(Include, ALaterFileWinsOverAnEarlierOneAndPathsAreRelativeToTheirFile) {
    const Written written;
    written.add("parts/one.toml", "x = 1\ny = 1\nz = 1\n");
    written.add("parts/two.toml", "include = \"deeper/three.toml\"\ny = 2\n");
    written.add("parts/deeper/three.toml", "w = 3\nz = 3\n");
    written.add("case.toml", "include = [\"parts/one.toml\", \"parts/two.toml\"]\n");
    InputErrors errors;
    const TomlValue merged = document(written, errors);
    EXPECT_EQ(at(merged, {"x"}).number, 1.0);
    EXPECT_EQ(at(merged, {"y"}).number, 2.0);
    EXPECT_EQ(at(merged, {"z"}).number, 3.0);
    EXPECT_EQ(at(merged, {"w"}).number, 3.0);
}

TEST(Include, ListsAndTablesInBracesAreValues) {
    const Written written;
    written.add(
        "base.toml",
        "list = [1, 2, 3]\n[t]\nlaw = { at = 1, value = 2 }\n[[t.layer]]\nname = \"a\"\n[[t.layer]]\nname = \"b\"\n");
    written.add("case.toml",
                "include = \"base.toml\"\nlist = [4]\n[t]\nlaw = { through = 5 }\n[[t.layer]]\nname = \"a\"\n");
    InputErrors errors;
    const TomlValue merged = document(written, errors);
    EXPECT_EQ(at(merged, {"list"}).items.size(), 1U);
    EXPECT_EQ(at(merged, {"t", "law"}).entries.size(), 1U);
    EXPECT_EQ(at(merged, {"t", "layer"}).items.size(), 1U);
}

TEST(Include, NamedListsAtTheTopAreMergedByName) {
    const Written written;
    written.add("base.toml", "[[material]]\nname = \"a\"\nx = 1\ny = 1\n[[material]]\nname = \"b\"\nx = 1\n");
    written.add("case.toml",
                "include = \"base.toml\"\n[[material]]\nname = \"c\"\nx = 3\n[[material]]\nname = \"a\"\nx = 2\n");
    InputErrors errors;
    const TomlValue merged = document(written, errors);
    const std::vector<TomlValue>& list = at(merged, {"material"}).items;
    ASSERT_EQ(list.size(), 3U);
    EXPECT_EQ(at(list[0], {"name"}).text, "a");
    EXPECT_EQ(at(list[0], {"x"}).number, 2.0);
    EXPECT_EQ(at(list[0], {"y"}).number, 1.0);
    EXPECT_EQ(at(list[1], {"name"}).text, "b");
    EXPECT_EQ(at(list[2], {"name"}).text, "c");
    EXPECT_EQ(place(errors, at(list[0], {"y"})), "base.toml:4:5");
}

TEST(Include, ATableThatChangesItsKindIsReplaced) {
    const Written written;
    written.add("base.toml", "[mesh]\nkind = \"block\"\nx = 1\n[other]\nkind = \"same\"\nx = 1\n");
    written.add("case.toml", "include = \"base.toml\"\n[mesh]\nkind = \"layers\"\n[other]\nkind = \"same\"\n");
    InputErrors errors;
    const TomlValue merged = document(written, errors);
    EXPECT_EQ(at(merged, {"mesh"}).find("x"), nullptr);
    EXPECT_NE(at(merged, {"other"}).find("x"), nullptr);
}

// Two branches may include one file; only a circle is refused.
TEST(Include, OneFileMayBeIncludedTwice) {
    const Written written;
    written.add("base.toml", "x = 1\n");
    written.add("one.toml", "include = \"base.toml\"\n");
    written.add("case.toml", "include = [\"one.toml\", \"base.toml\"]\n");
    InputErrors errors;
    EXPECT_EQ(at(document(written, errors), {"x"}).number, 1.0);
    EXPECT_EQ(errors.count(), 0U);
}

TEST(Toml, PlacesCountCharactersAndSurviveEveryKindOfValue) {
    const Written written;
    written.add("case.toml", "\"\u00B5\" = [1, 2.5, true, \"t\", 2020-01-01, { a = 1 }]\n");
    InputErrors errors;
    const TomlValue merged = document(written, errors);
    const std::vector<TomlValue>& items = at(merged, {"\u00B5"}).items;
    ASSERT_EQ(items.size(), 6U);
    EXPECT_EQ(place(errors, items[0]), "case.toml:1:8");
    const std::vector<std::string> expected{"1", "2.5", "true", "\"t\"", "a date", "a table"};
    for (std::size_t i = 0; i < items.size(); ++i) {
        EXPECT_EQ(shown(items[i]), expected[i]);
    }
}

// A key stands once in a table: where it is known it keeps its place in the file, at line 2, and gets the new value.
TEST(Toml, AKeyIsWrittenInThePlaceOfItsOldValueAndTakenAway) {
    const Written written;
    written.add("case.toml", "[drive]\nspeed = 1\n");
    InputErrors errors;
    TomlValue merged = document(written, errors);
    TomlValue two = at(merged, {"drive", "speed"});
    two.number = 2.0;
    ASSERT_NE(merged.find("drive"), nullptr);
    merged.find("drive")->set("speed", two);
    merged.find("drive")->set("camber", two);
    EXPECT_EQ(at(merged, {"drive", "speed"}).number, 2.0);
    EXPECT_EQ(place(errors, at(merged, {"drive", "speed"})), "case.toml:2:9");
    EXPECT_EQ(at(merged, {"drive"}).entries.size(), 2U);
    merged.find("drive")->remove("speed");
    EXPECT_EQ(merged.find({"drive", "speed"}), nullptr);
    EXPECT_EQ(merged.find({"nothing", "speed"}), nullptr);
}

}  // namespace tiretherm::input
