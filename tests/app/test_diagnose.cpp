// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm diagnose` on made-up logs whose hidden cause is known: it is named, nothing is named where nothing is
// hidden, bad input is refused.

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string practice = TIRETHERM_SOURCE_DIR "/cases/practice/";
const std::string diagnosed_bench = practice + "two_node_bench.toml";
const std::string puzzle =
    "--data " + practice + "puzzle1.csv --data " + practice + "puzzle2.csv --data " + practice + "puzzle3.csv";

/// A folder, and diagnoses whose files go there.
struct Diagnoses {
    input::Written written;

    [[nodiscard]] std::string file(const std::string& name) const { return (written.folder() / name).string(); }
    [[nodiscard]] Call diagnose(const std::string& case_file, const std::string& arguments = "") const {
        return call("diagnose " + case_file + " --out " + file("out") + " " + arguments);
    }
};

/// Root mean square of extended - measured of a channel in residuals.csv.
double rms_of_extended(const std::string& rows, const std::string& channel) {
    std::istringstream lines(rows);
    double sum = 0.0;
    double n = 0.0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, ',');) {
            row.push_back(cell);
        }
        if (row.at(2) == channel) {
            sum += std::pow(std::stod(row.at(6)) - std::stod(row.at(4)), 2);
            n += 1.0;
        }
    }
    return std::sqrt(sum / n);
}

// What the puzzle hides is sidewall_convection, 0.8 W/K (the end of cases/practice/README.md). Gas in the cavity takes
// next to the same heat from the bulk, so that both may be left; nothing else may, and the first has to be right.
TEST(Diagnose, FindsWhatThePuzzleHides) {
    const Diagnoses diagnoses;
    const Call page = diagnoses.diagnose(diagnosed_bench, puzzle + " --by-run");
    ASSERT_EQ(page.exit_code, 0) << page.err;
    // On a slow machine how far it is, and what all runs say together before each has been diagnosed alone.
    const std::size_t note = page.err.find("tiretherm:");
    EXPECT_TRUE(note == std::string::npos || note == page.err.find("tiretherm: all runs together: ")) << page.err;
    EXPECT_FALSE(has(page.out, "\033"));
    // 2 numbers of effects and 2 starts for each of 3 runs; 601 samples of 2 channels in each
    EXPECT_TRUE(
        page.out.starts_with("Bench of two nodes, runs of forty minutes\n3 runs, 3 606 values, 8 free parameters; "))
        << page.out;
    for (const char* section : {"\nVerdict\n", "\nWhere it shows\n", "\nCandidate causes\n", "\nFiles\n"}) {
        EXPECT_TRUE(has(page.out, section)) << section << page.out;
    }
    for (const char* name :
         {"diagnosis.json", "extended.toml", "residuals.csv", "missing_heat.csv", "report.html", "page.txt"}) {
        EXPECT_GT(std::filesystem::file_size(diagnoses.written.folder() / "out" / name), 100u) << name;
        EXPECT_TRUE(has(page.out, name)) << name;
    }

    const Json json = Json::parse(post::read_text(diagnoses.file("out/diagnosis.json")));
    ASSERT_FALSE(json["set"].empty()) << json["reason"];
    EXPECT_EQ(json["set"][0], Json::parse(R"(["sidewall_convection"])")) << json["reason"];
    for (const Json& hypothesis : json["set"]) {
        EXPECT_TRUE(hypothesis[0] == "sidewall_convection" || hypothesis[0] == "inner_gas") << hypothesis;
    }
    EXPECT_EQ(json["verdict"], json["set"].size() == 1 ? "named" : "confounded");
    EXPECT_TRUE(json["unknown"].is_null());
    // All three runs hide the same, each some 10 sigma of it: it is in the set of each alone.
    ASSERT_EQ(json["runs"].size(), 3U);
    for (const Json& run : json["runs"]) {
        EXPECT_TRUE(std::ranges::any_of(run["causes"], [](const Json& cause) {
            return cause["id"] == "sidewall_convection";
        })) << run;
    }
    EXPECT_TRUE(has(page.out, "\nEach run alone\n"));
    EXPECT_TRUE(has(page.out, "All runs agree on ")) << page.out;
    const Json& conductance = json["causes"][0]["parameters"]["conductance"];
    EXPECT_EQ(conductance["unit"], "W/K");
    EXPECT_LT(conductance["low"], 0.8);
    EXPECT_GT(conductance["high"], 0.8);
    EXPECT_LT(conductance["high"].get<double>() - conductance["low"].get<double>(),
              0.4);  // 1.96 to either side: 8 sigma

    // The extended case runs as it is and gives what the diagnosis has seen of it; steps are its own, 0.01 K each.
    const std::string extended = diagnoses.file("out/extended.toml");
    EXPECT_EQ(call("run " + extended + " --out " + diagnoses.file("run")).exit_code, 0);
    const Call compare = call("compare " + extended + " --json --out " + diagnoses.file("again"));
    ASSERT_EQ(compare.exit_code, 0) << compare.err;
    const Json compared = Json::parse(compare.out);
    const std::string rows = post::read_text(diagnoses.file("out/residuals.csv"));
    for (const Json& channel : compared["channels"]) {
        EXPECT_NEAR(channel["rmse"].get<double>(), rms_of_extended(rows, channel["name"]), 0.01) << channel["name"];
    }
}

// The case's own runs hide nothing.
TEST(Diagnose, FindsNothingWhereNothingIsHidden) {
    const Diagnoses diagnoses;
    const Call call = diagnoses.diagnose(diagnosed_bench, "--json --no-by-run");
    ASSERT_EQ(call.exit_code, 0) << call.err;
    const Json json = Json::parse(call.out);
    EXPECT_EQ(json["verdict"], "consistent") << json["reason"];
    EXPECT_TRUE(json["set"].empty());
    EXPECT_TRUE(json["runs"].empty());
    EXPECT_TRUE(json["unknown"].is_null());
    EXPECT_EQ(json, Json::parse(post::read_text(diagnoses.file("out/diagnosis.json"))));
    EXPECT_FALSE(std::filesystem::exists(diagnoses.written.folder() / "out" / "extended.toml"));
    // Made up with noise of 0.5 and 0.3 K; 10 % are beyond three standard deviations of what such runs tell (as in
    // Identify.FindsTheNumbersOfTheBenchAgain).
    EXPECT_NEAR(json["noise"][0]["sigma"], 0.5, 0.05);
    EXPECT_NEAR(json["noise"][1]["sigma"], 0.3, 0.03);
}

TEST(Diagnose, ACaseThatFreesNothingIsRefused) {
    const Diagnoses diagnoses;
    std::string text = post::read_text(diagnosed_bench);
    const std::size_t first = text.find("[[parameter]]");
    text.erase(first, text.find("[identify]") - first);
    text.replace(text.find("../tires"), 8, TIRETHERM_SOURCE_DIR "/cases/tires");
    for (std::size_t at = text.find("file = \""); at != std::string::npos; at = text.find("file = \"", at + 1)) {
        text.insert(at + 8, practice);
    }
    const std::string file = diagnoses.written.add("nothing_free.toml", text).string();
    const Call call = diagnoses.diagnose(file);
    EXPECT_EQ(call.exit_code, 1);
    EXPECT_EQ(call.out, "");
    EXPECT_EQ(call.err, "tiretherm: " + file +
                            ": no parameter of the case is free; name those to be fitted: [[parameter]], see "
                            "cases/README.md\n");
}

TEST(Diagnose, ACaseThatMeasuresNothingIsRefused) {
    const Call none = call("diagnose " + two_node);
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_TRUE(has(none.err, two_node + ": the case has no measured run\n    remedy: add [[run]]")) << none.err;
    EXPECT_TRUE(has(none.err, "1 error; nothing was diagnosed\n")) << none.err;
}

TEST(Diagnose, MissingFilesAreToldAndEndWith1) {
    const Diagnoses diagnoses;
    const Call no_data = diagnoses.diagnose(diagnosed_bench, "--data " + diagnoses.file("missing.csv"));
    EXPECT_EQ(no_data.exit_code, 1);
    EXPECT_EQ(no_data.out, "");
    EXPECT_TRUE(has(no_data.err, "missing.csv: the file cannot be read: No such file or directory")) << no_data.err;
    EXPECT_TRUE(has(no_data.err, "nothing was diagnosed")) << no_data.err;
    const Call no_case = diagnoses.diagnose(diagnoses.file("missing.toml"), "--json");
    EXPECT_EQ(no_case.exit_code, 1);
    EXPECT_EQ(no_case.err, "");
    EXPECT_EQ(Json::parse(no_case.out)["errors"].size(), 1u) << no_case.out;
    EXPECT_FALSE(std::filesystem::exists(diagnoses.written.folder() / "out"));
}

TEST(Diagnose, ACandidateThatIsNoEffectIsRefusedWithItsPlace) {
    const Diagnoses diagnoses;
    const std::string file = diagnoses.written
                                 .add("misspelt.toml", "include = [\"" + diagnosed_bench +
                                                           "\"]\n[diagnose]\ncandidates = [\"side_wall_convection\"]\n")
                                 .string();
    const Call call = diagnoses.diagnose(file);
    EXPECT_EQ(call.exit_code, 1);
    EXPECT_TRUE(has(call.err, "misspelt.toml:3:15: ")) << call.err;
    EXPECT_TRUE(has(call.err, "sidewall_convection")) << call.err;
}

TEST(Diagnose, ARunThatFailsEndsWith2) {
    const Diagnoses diagnoses;
    const std::string file = diagnoses.written
                                 .add("exploding.toml", exploding + R"(
[[measured]]
channel = "inside"
value = "60 degC"
uncertainty = "1 K"
[[parameter]]
effect = "radiation"
key = "emissivity"
standard_deviation = 0.05
)")
                                 .string();
    const Call call = diagnoses.diagnose(file);
    EXPECT_EQ(call.exit_code, 2) << call.out << call.err;
    EXPECT_TRUE(has(call.err, "nothing was diagnosed")) << call.err;
    EXPECT_EQ(call.out, "");
}

TEST(Diagnose, RunsAloneAreWantedOrNot) {
    const Call call = app_test::call("diagnose " + diagnosed_bench + " --by-run --no-by-run");
    EXPECT_EQ(call.exit_code, 1);
    EXPECT_TRUE(has(call.err, "--no-by-run") && has(call.err, "--by-run")) << call.err;
}

TEST(Diagnose, HelpHasAnExample) {
    const Call help = call("diagnose --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_TRUE(has(help.out, "tiretherm diagnose cases/practice/two_node_bench.toml")) << help.out;
}

}  // namespace
}  // namespace tiretherm::app_test
