// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm report A B`: two results on one page, and what cannot stand beside each other.

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/diagnosis/compare/compared_bench.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// The same tire at 100 km/h in `slow` and at 120 km/h in `fast`.
struct Pair {
    input::Written written;

    Pair() {
        written.add("fast.toml", "include = [\"" + two_node + "\"]\n[drive]\nspeed = \"120 km/h\"\n");
        EXPECT_EQ(in_folder("run --no-vtk --quiet --out slow " + two_node).exit_code, 0);
        EXPECT_EQ(in_folder("run --no-vtk --quiet --out fast fast.toml").exit_code, 0);
    }
    [[nodiscard]] Call in_folder(const std::string& arguments) const { return call(arguments, written.folder()); }
};

TEST(ReportPair, NamesTheKeysThatDifferAndWhatFollows) {
    const Pair pair;
    const Call run = pair.in_folder("report slow fast --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["inputs"].size(), 1u) << json["inputs"];
    EXPECT_EQ(json["inputs"][0]["key"], "drive.speed");
    EXPECT_EQ(json["inputs"][0]["a"], "100 km/h");
    EXPECT_EQ(json["inputs"][0]["b"], "120 km/h");
    const Json& bulk = json["channels"][1];
    EXPECT_EQ(bulk["channel"], "bulk_temperature");
    EXPECT_NEAR(bulk["final_a"], 64.0, 0.06);  // as an independent integration gives it
    EXPECT_GT(bulk["final_difference"], 1.0);
    EXPECT_NEAR(bulk["final_difference"], bulk["final_b"].get<double>() - bulk["final_a"].get<double>(), 1e-9);
    EXPECT_EQ(json["hottest"][0]["layer_a"], "bulk");
    const auto loss =
        std::ranges::find_if(json["heat"], [](const Json& effect) { return effect["effect"] == "strain_energy_loss"; });
    ASSERT_NE(loss, json["heat"].end());
    EXPECT_GT((*loss)["watts_difference"], 0.0);
    EXPECT_TRUE(std::filesystem::exists(pair.written.folder() / "out/slow_against_fast/report.html"));
    const Call text = pair.in_folder("report slow fast --out both");
    EXPECT_NE(text.out.find("Inputs that differ"), std::string::npos) << text.out;
    const std::string answer =
        fmt::format("\nhottest place, degC: {:.2f} in A, {:.2f} in B, B - A {:+.2f} K.\n",
                    json["hottest"][0]["hottest_a"].get<double>(), json["hottest"][0]["hottest_b"].get<double>(),
                    json["hottest"][0]["hottest_difference"].get<double>());
    EXPECT_EQ(text.out.find(answer), text.out.find('\n')) << text.out;  // right below the title
    EXPECT_EQ(text.out, post::read_text(pair.written.folder() / "both/page.txt"));
}

TEST(ReportPair, TheSameResultTwiceDiffersInNothing) {
    const Pair pair;
    const Json json = Json::parse(pair.in_folder("report slow slow --json").out);
    EXPECT_TRUE(json["inputs"].empty());
    for (const Json& channel : json["channels"]) {
        EXPECT_EQ(channel["max_difference"], 0.0);
        EXPECT_EQ(channel["mean_difference"], 0.0);
    }
}

TEST(ReportPair, ResultsWithoutAnythingInCommonAreRefused) {
    const Pair pair;
    pair.written.add("first.csv", diagnosis::sample::first_log);
    pair.written.add("second.csv", diagnosis::sample::second_log);
    pair.written.add("idle.toml", diagnosis::sample::idle_bench);
    ASSERT_EQ(pair.in_folder("compare idle.toml --out compared").exit_code, 0);
    ASSERT_EQ(pair.in_folder("run --no-report --quiet --out bare " + two_node).exit_code, 0);
    for (const auto& [arguments, words] :
         {std::pair("slow compared", "slow is a result of run, compared one of compare"),
          std::pair("slow nowhere", "there is no folder nowhere"),
          std::pair("slow bare", "there is no report.html in bare")}) {
        const Call refused = pair.in_folder(std::string("report ") + arguments);
        EXPECT_EQ(refused.exit_code, 1) << arguments;
        EXPECT_NE(refused.err.find(words), std::string::npos) << refused.err;
    }
    EXPECT_EQ(pair.in_folder("report compared compared --json").exit_code, 0);
}

}  // namespace
}  // namespace tiretherm::app_test
