// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm diagnose` of a table of measured numbers: what it answers to too few of them, its file, wrong calls.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// Two saturated temperatures of the thesis, an experiment each.
const std::string two_numbers = [] {
    std::string table = "title = \"Two loads\"\n";
    for (const auto& [load, degrees] : {std::pair{"4000", "50"}, std::pair{"7000", "70"}}) {
        table += fmt::format(
            "[[number]]\nid = \"at {0} N\"\nwhat = \"bulk\"\nfiles = {{ two_node = \"{1}/cases/two_node/"
            "{0}N_100kmh.toml\" }}\nchannel = \"bulk_temperature\"\nvalue = \"{2} degC\"\nuncertainty = \"2 "
            "K\"\nsource = "
            "\"a page\"\n",
            load, TIRETHERM_SOURCE_DIR, degrees);
    }
    return table;
}();

}  // namespace

// Both are too hot, by 14.0 and 10.6 K as an independent integration has it, rms 12.4 K; two experiments cannot name anything.
TEST(DiagnoseTable, TwoExperimentsCannotTell) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", two_numbers);
    const Call found = call("diagnose table.toml --out out --json", scratch.path());
    ASSERT_EQ(found.exit_code, 0) << found.err;
    const Json json = Json::parse(found.out);
    EXPECT_EQ(json["verdict"], "cannot_tell");
    EXPECT_TRUE(json["set"].empty());
    EXPECT_FALSE(json["gain"]["confirmed"].get<bool>());
    EXPECT_NEAR(json["decidable"]["rms_K"].get<double>(), 12.4, 0.1);
    EXPECT_NE(json["reason"].get<std::string>().find("cannot name a cause"), std::string::npos);
    EXPECT_GT(json["causes"].size(), 10U);
    EXPECT_EQ(Json::parse(post::read_text(scratch / "out/diagnosis.json"))["verdict"], "cannot_tell");
}

TEST(DiagnoseTable, WrongCallsAreExplained) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", two_numbers);
    const Call data = call("diagnose table.toml --data log.csv", scratch.path());
    EXPECT_EQ(data.exit_code, 1);
    EXPECT_EQ(data.err,
              "tiretherm: a table of measured numbers has no place for --data; name a case with [[run]] to diagnose a "
              "log, or call it without --data\n");
    const Call model = call("diagnose table.toml --model section", scratch.path());
    EXPECT_EQ(model.exit_code, 1);
    EXPECT_EQ(model.err,
              "tiretherm: table.toml: no measured number is read from the model section; take --model two_node\n");
    const Call unknown = call("diagnose table.toml --model sectoin", scratch.path());
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_EQ(unknown.err, "tiretherm: table.toml has no model \"sectoin\"; did you mean `section`?\n");
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(DiagnoseTable, ErrorsOfTheTableAreReportedAtOnce) {
    const Call wrong = call("diagnose cases.toml", TIRETHERM_SOURCE_DIR "/tests/bad_cases/validation");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("cases.toml:5:8: there is no case standrad_two_node.toml"), std::string::npos)
        << wrong.err;
    EXPECT_NE(wrong.err.find(" errors; nothing was diagnosed\n"), std::string::npos) << wrong.err;
}

}  // namespace tiretherm::app_test
