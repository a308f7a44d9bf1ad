// SPDX-License-Identifier: BSD-3-Clause
// Building blocks of reports: tables, wrapping, histories, comparisons and safe file replacement.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mesh/place.hpp"
#include "post/report/file.hpp"
#include "post/report/number_text.hpp"
#include "post/report/table.hpp"
#include "post/run/measured_values.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

// 2 + 4 + 2 + 2 = 10 columns are taken by indent, name and number; of 30 columns, 2 of them between, 18 are left to text.
TEST(TextTable, TextIsWrappedInItsColumnWhereThePageIsTooNarrow) {
    TextTable table({true, false, true});
    table.add({"name", "22", "measured by a camera in 2014"});
    table.add({"bulk", "3", "short"});
    EXPECT_EQ(table.text(2, 30),
              "  name  22  measured by a\n"
              "            camera in 2014\n"
              "  bulk   3  short\n");
}

// A name of 20 characters without a blank keeps its column, though half of the page of 30 is less: the rest goes below.
TEST(TextTable, ANameThatCannotBeBrokenKeepsItsColumn) {
    TextTable table({true, false, false});
    table.add({"abcdefghijklmnopqrst", "22", "333333"});
    table.add({"b", "3", "4"});
    EXPECT_EQ(table.text(2, 30),
              "  abcdefghijklmnopqrst  22\n"
              "  b                      3\n"
              "\n"
              "  abcdefghijklmnopqrst  333333\n"
              "  b                          4\n");
}

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCellInCharacters) {
    TextTable table({true, false, true});
    table.add({"a", "1", "x"});
    table.add({"°C", "22", ""});  // two characters, three bytes
    table.add({"abc", "333", "y"});
    EXPECT_EQ(table.lines(1), (std::vector<std::string>{" a      1  x", " °C    22", " abc  333  y"}));
}

// A title and the name of a file may hold line ends: rows stay rows.
TEST(TextTable, RowIsALine) {
    TextTable table({true});
    table.add({"a\nb"});
    EXPECT_EQ(table.lines(0), (std::vector<std::string>{"a b"}));
}

TEST(NumberText, LargeNumbersAreWrittenByPowersOfTen) {
    EXPECT_EQ(with_decimals(-123456789.126, 2), "-123456789.13");
    EXPECT_EQ(with_decimals(2345624805945.1, 1), "2.346e+12");
    EXPECT_EQ(with_decimals(-1e300, 1), "-1e+300");
    EXPECT_EQ(with_decimals(std::nan(""), 1), "-");
    EXPECT_EQ(with_decimals(-std::numeric_limits<double>::infinity(), 1), "-");
}

// The folders are made with the file. Where the file cannot be written, since a folder stands in its place, none of them
// is left; a folder that was there stays.
TEST(WriteWithFolder, LeavesNoFolderWithoutItsFile) {
    const sample::Scratch scratch;
    write_with_folder(scratch / "a/b/c.txt", "text");
    EXPECT_EQ(read_text(scratch / "a/b/c.txt"), "text");
    std::filesystem::create_directories(scratch / "there");
    const std::string too_long(300, 'x');
    EXPECT_THROW(write_with_folder(scratch / "there/new/newer" / too_long, "text"), FileError);
    EXPECT_TRUE(std::filesystem::exists(scratch / "there"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "there/new"));
    replace_file(scratch / "file", "mine");
    EXPECT_THROW(write_with_folder(scratch / "file/x/y", "text"), FileError);
    EXPECT_EQ(read_text(scratch / "file"), "mine");
}

TEST(TextTable, ThousandsStandInGroups) {
    EXPECT_EQ(grouped(0.0), "0");
    EXPECT_EQ(grouped(999.4), "999");
    EXPECT_EQ(grouped(1000.0), "1 000");
    EXPECT_EQ(grouped(1234567.0), "1 234 567");
    EXPECT_EQ(grouped(-4321.0), "-4 321");
}

TEST(TextTable, LongTextIsBrokenAtBlanks) {
    EXPECT_EQ(wrap("one two three", 2, 9), "  one two\n  three\n");
    EXPECT_EQ(wrap("", 2, 9), "");
}

TEST(History, IsStraightBetweenRowsAndHeldBeyond) {
    const solver::Problem problem = sample::problem();
    const History history = sample::history(problem);
    EXPECT_DOUBLE_EQ(history.at(0, 15.0), 0.5 * (296.15 + 353.15));
    EXPECT_EQ(history.at(1, -5.0), 296.15);
    EXPECT_EQ(history.at(1, 99.0), 313.15);
}

TEST(Comparison, DifferenceIsSimulatedLessMeasuredFromTheNearerEnd) {
    const solver::Problem problem = sample::problem();
    const std::vector<Comparison> found = compare(problem, sample::history(problem));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].difference, 12.5, 1e-9);
    EXPECT_TRUE(found[0].at_end);
    EXPECT_NEAR(found[1].simulated, 303.15, 1e-9);
    EXPECT_NEAR(found[1].difference, -7.0, 1e-9);
    EXPECT_FALSE(found[1].at_end);
}

TEST(Place, OfABlockHasThreeCoordinates) {
    const std::vector<mesh::Segment> side{{.to = 0.02, .cells = 2}};
    const mesh::Mesh block =
        mesh::build(mesh::Block{.x = side, .y = side, .stack = {{.name = "tread", .thickness = 0.012, .cells = 3}}});
    EXPECT_EQ(describe_place(block, 0), "tread, x 5.00 mm, y 5.00 mm, depth 2.00 mm");
    EXPECT_EQ(describe_place(block, -1), "");
}

TEST(File, IsReplacedAsAWhole) {
    const sample::Scratch scratch;
    replace_file(scratch / "text", "a long first version");
    replace_file(scratch / "text", "short");
    EXPECT_EQ(read_text(scratch / "text"), "short");
    EXPECT_FALSE(std::filesystem::exists(scratch / "text.part"));
}

TEST(File, FullDiskIsAnErrorWithTheReasonOfTheSystem) {
    AppendFile full("/dev/full");
    try {
        full.append("one line\n");
        FAIL() << "/dev/full took a line";
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "cannot write /dev/full: No space left on device");
    }
}

}  // namespace
}  // namespace tiretherm::post
