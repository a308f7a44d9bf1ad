// SPDX-License-Identifier: BSD-3-Clause
// Edit distance of suggestions, and the layout of error messages with line, caret and remedy.

#include <gtest/gtest.h>

#include "input/text/input_error.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

TEST(Suggestions, DistanceCountsEdits) {
    EXPECT_EQ(distance("speed", "speed"), 0U);
    EXPECT_EQ(distance("Speed", "speed"), 0U);
    EXPECT_EQ(distance("sped", "speed"), 1U);
    EXPECT_EQ(distance("speeed", "speed"), 1U);
    EXPECT_EQ(distance("spead", "speed"), 1U);
    EXPECT_EQ(distance("sepeed", "speed"), 1U);
    EXPECT_EQ(distance("pseed", "speed"), 1U);  // neighbours swapped
    EXPECT_EQ(distance("kitten", "sitting"), 3U);
    EXPECT_EQ(distance("", "abc"), 3U);
}

TEST(Suggestions, OnlyNearWordsAreSuggested) {
    const std::vector<std::string> known{"speed", "vertical_load", "on"};
    EXPECT_EQ(suggest("vertical_laod", known, "inputs"), "did you mean `vertical_load`?");
    EXPECT_EQ(suggest("weather", known, "inputs"), "the inputs are speed, vertical_load and on");
    EXPECT_EQ(suggest("weather", {"speed"}, "inputs"), "there is only `speed`");
    EXPECT_EQ(suggest("weather", {}, "inputs"), "there are no inputs");
    EXPECT_EQ(nearest(std::string(100000, 'x'), known), "");
}

// The table of all edits of 20 000 letters is 3 GB, and no name is misspelt at such a length; two of its lines are 48 kB
// for 3 000 letters.
TEST(Suggestions, LongNamesTakeNeitherMemoryNorTime) {
    const std::vector<std::string> known{std::string(20'000, 'a'), std::string(20'000, 'b') + "c"};
    EXPECT_EQ(nearest(std::string(20'000, 'a') + "x", known), "");
    EXPECT_EQ(distance(std::string(3'000, 'a'), std::string(3'001, 'a')), 1U);
}

// Of 10 MB of a field a warning shows its ends.
TEST(InputErrors, LongTextsAreCutInErrorsAndWarnings) {
    InputErrors errors;
    const int file = errors.add_file("a.csv", "x\n");
    const std::string field(10'000'000, 'x');
    errors.warn({.file = file, .line = 1}, "the column " + field + " is not used");
    errors.add({.file = file, .line = 1}, "the column " + field, "remove " + field);
    EXPECT_LT(errors.warnings().front().what.size(), 600U);
    EXPECT_LT(render(errors.in_order().front()).size(), 1200U);
}

TEST(Render, ShowsPlaceLineCaretAndRemedy) {
    const InputError error{.file = "a.toml",
                           .line = 3,
                           .column = 7,
                           .length = 4,
                           .what = "no",
                           .remedy = "yes",
                           .source = "\tkey = 1234 # x"};
    EXPECT_EQ(render(error), "a.toml:3:7: no\n    \tkey = 1234 # x\n    \t     ^~~~\n    remedy: yes\n");
}

TEST(Render, AnErrorOfAWholeFileHasNoLine) {
    EXPECT_EQ(render({.file = "a.toml", .what = "the file is empty", .remedy = {}, .source = {}}),
              "a.toml: the file is empty\n");
}

TEST(Render, CaretsCountCharactersNotBytes) {
    const InputError error{
        .file = "a", .line = 1, .column = 4, .length = 2, .what = "w", .remedy = {}, .source = "\u00B5\u00B0\u03A9ab"};
    EXPECT_EQ(render(error), "a:1:4: w\n    \u00B5\u00B0\u03A9ab\n       ^~\n");
}

// Places from outside of a line must not crash the one who reports them.
TEST(Render, SurvivesPlacesBeyondTheLine) {
    EXPECT_EQ(render({.file = "a", .line = 1, .column = 99, .length = 9, .what = "w", .remedy = {}, .source = "ab"}),
              "a:1:99: w\n    ab\n      ^\n");
    EXPECT_EQ(render({.file = "a", .line = 1, .column = 1, .length = 99, .what = "w", .remedy = {}, .source = ""}),
              "a:1:1: w\n");
}

// A file that was read by itself goes by the path of its reader; one beside it whose path begins alike keeps its own.
TEST(InputErrors, AreTakenOverWithTheFileTheyAreOf) {
    InputErrors own;
    const int log = own.add_file("log.csv", "");
    const int beside = own.add_file("log.csv.laps", "");
    own.warn({.file = log, .line = 2}, "short");
    own.warn({.file = beside}, "no laps");
    InputErrors all;
    all.take(own, all.add_file("runs/log.csv", ""));
    EXPECT_EQ(render(all.warnings(), 0), (std::vector<std::string>{"runs/log.csv:2: short", "log.csv.laps: no laps"}));
}

TEST(InputErrors, AreOrderedByPlaceAndNeverTwice) {
    InputErrors errors;
    const int a = errors.add_file("a.toml", "one\r\ntwo\n");
    const int b = errors.add_file("b.csv", "three\n");
    errors.add({.file = b, .line = 1, .column = 1, .length = 1}, "fourth");
    errors.add({.file = a, .line = 2, .column = 1, .length = 1}, "third");
    errors.add({.file = a, .line = 1, .column = 3, .length = 1}, "second");
    errors.add({.file = a}, "first");
    errors.add({.file = a, .line = 2, .column = 1, .length = 1}, "third");
    const std::vector<InputError> found = errors.in_order();
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].what, "first");
    EXPECT_EQ(found[1].what, "second");
    EXPECT_EQ(found[1].source, "one");
    EXPECT_EQ(found[2].what, "third");
    EXPECT_EQ(found[2].source, "two");
    EXPECT_EQ(found[3].source, "three");
}

}  // namespace tiretherm::input
