#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "cases/reader.hpp"
#include "cases/validation.hpp"

// Each table tests/bad_cases/validation/NAME.toml is wrong in many ways; NAME.txt holds what the user must then read,
// to the character.
namespace tiretherm::cases {

namespace {

namespace fs = std::filesystem;

fs::path folder() { return fs::path(TIRETHERM_SOURCE_DIR) / "tests" / "bad_cases" / "validation"; }

std::vector<std::string> names() {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder())) {
        if (entry.path().extension() == ".toml") {
            found.push_back(entry.path().stem().string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Paths as if the checker had been started in the folder of the bad cases.
std::string relative(std::string text) {
    const std::string prefix = folder().parent_path().generic_string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) {
        text.erase(at, prefix.size());
    }
    return text;
}

class BadTable : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadTable, IsExplainedToTheCharacter) {
    const ValidationReading reading = read_validation(folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.table.has_value());
    const std::string told = render(Reading{.problem = {}, .mistakes = reading.mistakes, .warnings = reading.warnings});
    EXPECT_EQ(relative(told), text_of(folder() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadTable, testing::ValuesIn(names()), [](const auto& bad) { return bad.param; });

TEST(BadTableFile, ThatIsNotThere) {
    const ValidationReading reading = read_validation("/no/such/table.toml");
    ASSERT_EQ(reading.mistakes.size(), 1U);
    EXPECT_EQ(reading.mistakes[0].what, "the file cannot be read: No such file or directory");
}

}  // namespace tiretherm::cases
