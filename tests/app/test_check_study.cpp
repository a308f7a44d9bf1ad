// SPDX-License-Identifier: BSD-3-Clause
// `check` of what is no case: studies and tables of measured numbers; and the keys of both by their titles.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

const std::string tree = TIRETHERM_SOURCE_DIR;

// un_r30_pressure.toml varies the pressure of the case durability/un_r30_load_speed.
TEST(CheckStudy, ReadsAStudyAsTheStudyCommandDoes) {
    const Call good = call("check " + tree + "/cases/studies/un_r30_pressure.toml");
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(good.out.find(": no errors in the study\n"), std::string::npos) << good.out;
    EXPECT_NE(good.out.find("durability/un_r30_load_speed"), std::string::npos) << good.out;
    EXPECT_NE(good.out.find("drive.inflation_pressure: "), std::string::npos) << good.out;
    const auto json = nlohmann::json::parse(call("check --json " + tree + "/cases/studies/un_r30_pressure.toml").out);
    EXPECT_EQ(json["errors"], nlohmann::json::array());
    EXPECT_GT(json["runs"], 1);
    const Call wrong = call("check " + tree + "/tests/bad_cases/study/count.toml");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("the study cannot be run"), std::string::npos) << wrong.err;
    const Call numbers = call("check " + tree + "/cases/validation.toml");
    EXPECT_EQ(numbers.exit_code, 1);
    EXPECT_NE(numbers.err.find("is a table of measured numbers, and no case; tiretherm validate "), std::string::npos)
        << numbers.err;
}

TEST(CheckStudy, KeysAreFoundByTheTitlesThatTheListHas) {
    const Call list = call("keys");
    for (const std::string title : {"top of a case", "top of a study", "top of a table of measured numbers"}) {
        EXPECT_NE(list.out.find(title), std::string::npos);
        EXPECT_EQ(call("keys '" + title + "'").exit_code, 0) << title;
    }
    EXPECT_NE(call("keys 'top of a studdy'").err.find("top of a study"), std::string::npos);
}

}  // namespace
}  // namespace tiretherm::app_test
