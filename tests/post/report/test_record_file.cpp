// SPDX-License-Identifier: BSD-3-Clause
// Records of numbers come back bit by bit; what was cut off, damaged or belongs to another call does not.

#include "post/report/record_file.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "post/report/file.hpp"
#include "tests/post/scratch.hpp"

namespace tiretherm::post {
namespace {

const solver::Digest::Value file_identity{1, 2};
const std::vector<double> first{1.0 / 3.0, -0.0, std::numeric_limits<double>::infinity()};
const std::vector<double> second{5e-324};

std::filesystem::path written(const sample::Scratch& scratch) {
    RecordFile file(scratch / "records", file_identity);
    file.append(first);
    file.append({second, first});
    return scratch / "records";
}

}  // namespace

TEST(RecordFile, GivesBackEveryBit) {
    const sample::Scratch scratch;
    const RecordFile file(written(scratch), file_identity);
    ASSERT_EQ(file.size(), 2U);
    EXPECT_EQ(file.read(0), first);
    EXPECT_TRUE(std::signbit(file.read(0)[1]));
    EXPECT_EQ(file.read(1), (std::vector<double>{second[0], first[0], first[1], first[2]}));
}

TEST(RecordFile, EveryCutLeavesTheWholeRecordsBeforeIt) {
    const sample::Scratch scratch;
    const std::string whole = read_text(written(scratch));
    const std::size_t one = 24 + 16 + 8 * first.size();
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        replace_file(scratch / "records", whole.substr(0, length));
        RecordFile file(scratch / "records", file_identity);
        ASSERT_EQ(file.size(), length == whole.size() ? 2U : length >= one ? 1U : 0U) << length;
        file.append(second);  // goes on behind them
        EXPECT_EQ(file.read(file.size() - 1), second);
    }
}

TEST(RecordFile, EveryDamagedByteEndsItThereAtTheLatest) {
    const sample::Scratch scratch;
    const std::string whole = read_text(written(scratch));
    const std::size_t one = 24 + 16 + 8 * first.size();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        replace_file(scratch / "records", damaged);
        EXPECT_EQ(RecordFile(scratch / "records", file_identity).size(), at < one ? 0U : 1U) << at;
    }
}

// Whoever is told nothing would believe that everything went on. A file of another call is not damaged but not ours.
TEST(RecordFile, SaysHowManyBytesWereNoWholeRecord) {
    const sample::Scratch scratch;
    const std::string whole = read_text(written(scratch));
    const std::size_t one = 24 + 16 + 8 * first.size();
    EXPECT_EQ(RecordFile(scratch / "records", file_identity).dropped(), 0U);
    replace_file(scratch / "records", whole.substr(0, whole.size() - 3));
    EXPECT_EQ(RecordFile(scratch / "records", file_identity).dropped(), whole.size() - 3 - one);
    std::string damaged = whole;
    damaged[30] = '!';
    replace_file(scratch / "records", damaged);
    EXPECT_EQ(RecordFile(scratch / "records", file_identity).dropped(), whole.size() - 24);
    replace_file(scratch / "records", "short");
    EXPECT_EQ(RecordFile(scratch / "records", file_identity).dropped(), 5U);
    EXPECT_EQ(RecordFile(written(scratch), {1, 3}).dropped(), 0U);
    EXPECT_EQ(RecordFile(scratch / "new", file_identity).dropped(), 0U);
}

TEST(RecordFile, RecordsOfAnotherIdentityAreForgotten) {
    const sample::Scratch scratch;
    EXPECT_EQ(RecordFile(written(scratch), {1, 3}).size(), 0U);
    EXPECT_EQ(RecordFile(scratch / "records", file_identity).size(), 0U);
}

TEST(RecordFile, CanBeShortened) {
    const sample::Scratch scratch;
    RecordFile file(written(scratch), file_identity);
    file.truncate(1);
    file.append(second);
    EXPECT_EQ(file.read(1), second);
    EXPECT_EQ(RecordFile(scratch / "records", file_identity).size(), 2U);
}

TEST(Digest, TellsApartWhatDiffersInABitAnOrderOrABorder) {
    const auto of = [](const auto&... parts) {
        solver::Digest digest;
        (digest.add(parts), ...);
        return digest.value();
    };
    const std::vector<double> one{1.0, 2.0};
    EXPECT_EQ(of(one), of(std::vector<double>{1.0, 2.0}));
    EXPECT_NE(of(one), of(std::vector<double>{1.0, std::nextafter(2.0, 3.0)}));
    EXPECT_NE(of(one), of(std::vector<double>{2.0, 1.0}));
    EXPECT_NE(of(0.0), of(-0.0));
    EXPECT_NE(of(std::vector<double>{1.0}, std::vector<double>{}), of(std::vector<double>{}, std::vector<double>{1.0}));
    EXPECT_NE(of(std::string_view("ab"), std::string_view("c")), of(std::string_view("a"), std::string_view("bc")));
}

}  // namespace tiretherm::post
