// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm validate`: table and JSON of a small table against an independent integration; each case runs once,
// failures keep their row.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string folder = TIRETHERM_SOURCE_DIR "/cases/two_node/";

/// Three numbers of two cases of the library, for the two-node model alone.
const std::string numbers = R"(title = "Two loads"
[[number]]
id = "light"
what = "bulk at 4000 N"
files = { two_node = ")" + folder +
                            R"(4000N_100kmh.toml" }
channel = "bulk_temperature"
value = "50 degC"
uncertainty = "2 K"
source = "a page"
[[number]]
id = "light"
what = "surface at 4000 N"
files = { two_node = ")" + folder +
                            R"(4000N_100kmh.toml" }
channel = "surface_temperature"
below = "40 degC"
source = "a page"
[[number]]
id = "heavy"
what = "bulk at 7000 N less that at 4000 N"
files = { two_node = ")" + folder +
                            R"(7000N_100kmh.toml" }
channel = "bulk_temperature"
minus = { files = { two_node = ")" +
                            folder + R"(4000N_100kmh.toml" } }
value = "20 K"
uncertainty = "2 K"
source = "a page"
)";

/// The load of the light case is not known: at one end of its range it is that of the heavy one.
const std::string unknown_load = R"([[input]]
name = "load"
meaning = "not printed"
standing = "assumed"
keys = ["drive.vertical_load"]
value = "4000 N"
range = ["4000 N", "7000 N"]
[[number]]
id = "light"
what = "bulk"
files = { two_node = ")" + folder +
                                 R"(4000N_100kmh.toml" }
channel = "bulk_temperature"
value = "70 degC"
uncertainty = "2 K"
source = "a page"
inputs = ["load"]
)";

/// A table with a case that the solver cannot carry to its end, beside one that it can.
const std::string burning = numbers + R"([[number]]
id = "fire"
what = "inside of a strip that burns"
files = { section = "exploding.toml" }
channel = "inside"
value = "50 degC"
uncertainty = "2 K"
source = "a page"
)";

}  // namespace

// 64.0 and 80.6 degC, as an independent integration gives them: 14 K and thus 7.0 u above 50 degC; 16.6 K apart.
TEST(Validate, TellsEachNumberBesideItsModelAndRunsEachCaseOnce) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", numbers);
    const Call call_text = call("validate table.toml", scratch.path());
    EXPECT_EQ(call_text.exit_code, 0);
    EXPECT_EQ(call_text.err, "");
    const Json json = Json::parse(call("validate --json table.toml", scratch.path()).out);
    EXPECT_EQ(json["runs"], 2);
    const Json& bulk = json["numbers"][0]["models"]["two_node"];
    EXPECT_NEAR(bulk["value"].get<double>(), 64.0, 0.06);
    EXPECT_NEAR(bulk["in_uncertainties"].get<double>(), 7.0, 0.03);
    const Json& between = json["numbers"][2]["models"]["two_node"];
    EXPECT_NEAR(between["value"].get<double>(), 80.6 - 64.0, 0.1);
    EXPECT_EQ(json["numbers"][1]["models"]["two_node"]["verdict"], "holds");
    EXPECT_TRUE(json["numbers"][1]["models"]["section"].is_null());
    EXPECT_LT(json["energy_closure"], 1e-10);
    EXPECT_NE(call("validate --markdown table.toml", scratch.path()).out.find("| 50.0 ± 2.0 °C | 64.0 |"),
              std::string::npos);
}

// An independent integration gives 64.0 degC at 4000 N and 80.6 degC at 7000 N: 16.6 K over 3000 N, 0.0055 K/N. Measured
// are 70 +- 2 degC, whose limits of 66 and 74 degC lie between.
TEST(Validate, NumberIsSimulatedAtBothEndsOfAnUnknownInput) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", unknown_load);
    const Json json = Json::parse(call("validate --json table.toml", scratch.path()).out);
    EXPECT_EQ(json["runs"], 3);
    const Json& bulk = json["numbers"][0]["models"]["two_node"];
    EXPECT_NEAR(bulk["low"].get<double>(), 64.0, 0.06);
    EXPECT_NEAR(bulk["high"].get<double>(), 80.6, 0.06);
    EXPECT_EQ(bulk["verdict"], "not decidable (load)");
    EXPECT_NEAR(json["numbers"][0]["inputs"][0]["models"]["two_node"]["sensitivity"].get<double>(), 16.6 / 3000.0,
                5e-5);
    const Call page = call("validate --inputs table.toml", scratch.path());
    EXPECT_EQ(page.exit_code, 0);
    EXPECT_NE(page.out.find("load 0.0 to +16."), std::string::npos) << page.out;
    const std::string markdown = call("validate --inputs --markdown table.toml --out told", scratch.path()).out;
    EXPECT_LT(markdown.find("| measured |"), markdown.find("| load | assumed | 4000 N | 4000 N, 7000 N |"));
    EXPECT_EQ(Json::parse(post::read_text(scratch / "told/validation.json"))["numbers"], json["numbers"]);
}

TEST(Validate, ResultDoesNotDependOnTheNumberOfThreads) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", numbers);
    const auto found = [&](const char* threads) {
        return Json::parse(
            call(fmt::format("validate table.toml --json --threads {}", threads), scratch.path()).out)["numbers"];
    };
    EXPECT_EQ(found("1"), found("3"));
}

TEST(Validate, OnlyTheExperimentsThatAreAskedForAreRun) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", numbers);
    const Json json = Json::parse(call("validate --only light table.toml --json", scratch.path()).out);
    EXPECT_EQ(json["runs"], 1);
    EXPECT_EQ(json["numbers"].size(), 2U);
    const Call wrong = call("validate table.toml --only light,havy", scratch.path());
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.err, "tiretherm: there is no experiment \"havy\"; did you mean `heavy`?\n");
}

TEST(Validate, RunThatFailsIsToldInItsRowAndTheOthersStand) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "table.toml", burning);
    post::replace_file(scratch / "exploding.toml", exploding);
    const Call failed = call("validate table.toml --json", scratch.path());
    EXPECT_EQ(failed.exit_code, 2);
    const Json rows = Json::parse(failed.out)["numbers"];
    EXPECT_NEAR(rows[0]["models"]["two_node"]["value"].get<double>(), 64.0, 0.06);
    const Json& fire = rows.back();
    EXPECT_EQ(fire["id"], "fire");
    EXPECT_TRUE(fire["models"]["section"]["value"].is_null());
    EXPECT_TRUE(fire["models"]["section"].contains("error"));
}

TEST(Validate, ErrorsOfTheTableAndItsCasesAreReportedAtOnce) {
    const Call wrong = call("validate cases.toml", TIRETHERM_SOURCE_DIR "/tests/bad_cases/validation");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.out, "");
    EXPECT_NE(wrong.err.find("cases.toml:5:8: there is no case standrad_two_node.toml"), std::string::npos)
        << wrong.err;
    EXPECT_NE(wrong.err.find("bare_number.toml:6:9: "), std::string::npos) << wrong.err;
    EXPECT_NE(wrong.err.find(" errors; nothing was run\n"), std::string::npos) << wrong.err;
}

TEST(Validate, ShippedTableIsSoughtInTheCurrentFolder) {
    const sample::Scratch scratch;
    const Call wrong = call("validate", scratch.path());
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(
        wrong.err,
        "tiretherm: there is no cases/validation.toml here; call it in the folder of the source, or give a table: "
        "tiretherm validate EXPERIMENTS\n");
}

}  // namespace tiretherm::app_test
