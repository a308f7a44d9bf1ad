// SPDX-License-Identifier: BSD-3-Clause
// Every file that fuzzing has found worth keeping is read again: seeds, inputs that reach their own part of a reader, and
// those that once broke a promise.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "fuzz/promises.hpp"
#include "fuzz/targets.hpp"

namespace tiretherm::fuzz {

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus(std::string_view target) {
    std::vector<fs::path> files;
    const fs::path folder = fs::path(TIRETHERM_SOURCE_DIR) / "tests/fuzz/corpus" / target;
    if (fs::is_directory(folder)) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class FuzzCorpus : public testing::TestWithParam<Target> {};

TEST_P(FuzzCorpus, KeepsThePromises) {
    for (const fs::path& file : corpus(GetParam().name)) {
        EXPECT_NO_THROW(GetParam().take(bytes_of(file))) << file;
    }
}

/// A reader that refuses everything keeps its promises, too: each kind has a sound seed.
TEST_P(FuzzCorpus, HasASoundSeed) {
    std::size_t sound = 0;
    for (const fs::path& file : corpus(GetParam().name)) {
        if (file.filename().string().starts_with("seed_")) {
            const bool accepted = GetParam().take(bytes_of(file));
            sound += accepted ? 1 : 0;
            RecordProperty(file.filename().string(), accepted ? "accepted" : "refused");
        }
    }
    EXPECT_GT(sound, 0U);
}

/// Each seed and each start of it: files are cut off where a disk was full.
TEST_P(FuzzCorpus, KeepsThePromisesWhereAFileIsCutOff) {
    const std::vector<fs::path> files = corpus(GetParam().name);
    std::size_t tried = 0;
    for (std::size_t at = 0; at < files.size() && tried < 40; at += 1 + files.size() / 8) {
        const std::string whole = bytes_of(files[at]);
        for (std::size_t eighths = 0; eighths < 8; ++eighths, ++tried) {
            EXPECT_NO_THROW(GetParam().take(whole.substr(0, whole.size() * eighths / 8)))
                << files[at] << ", " << eighths << " eighths of it";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, FuzzCorpus, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& about) { return std::string(about.param.name); });

std::vector<input::InputError> one_error(std::string what) {
    input::InputError error;
    error.file = "case.toml";
    error.what = std::move(what);
    return {error};
}

/// A target that cannot fail proves nothing: what it is told to promise, it tells when it is broken.
TEST(FuzzPromises, AreNoticedWhenTheyAreBroken) {
    EXPECT_THROW(promise(false, "broken"), BrokenPromise);
    EXPECT_THROW(check_outcome(false, {}, {}), BrokenPromise);
    EXPECT_THROW(check_outcome(true, one_error("b"), {}), BrokenPromise);
    EXPECT_THROW(check_messages(one_error(std::string(5000, 'x')), {}), BrokenPromise);
    EXPECT_THROW(check_messages({}, {""}), BrokenPromise);
    EXPECT_NO_THROW(check_outcome(false, one_error("b"), {"c"}));
}

}  // namespace
}  // namespace tiretherm::fuzz
