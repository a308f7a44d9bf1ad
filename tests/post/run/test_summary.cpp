// SPDX-License-Identifier: BSD-3-Clause
// The summary of a run as text, line by line, and as JSON, for hand-made results.

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/run/run_report.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

/// The summary of the sample, after changes to the problem and the report.
struct MadeUpRun {
    solver::Problem problem = sample::problem();
    solver::MarchReport report = sample::report();

    [[nodiscard]] RunRecord record(const History& history) const {
        return {.problem = problem,
                .report = report,
                .history = history,
                .provenance = {.version = "9.9", .case_file = "", .case_text = ""},
                .seconds = 0.02,
                .warnings = {"spot.toml:3: 8 m is an unusual thickness"},
                .files = {"out/results.h5", "out/channels.csv"}};
    }
    [[nodiscard]] std::string text() const {
        const History history = sample::history(problem);
        return page_text(run_report(record(history)), false);
    }
    [[nodiscard]] nlohmann::json json() const {
        const History history = sample::history(problem);
        return nlohmann::json::parse(json_text(run_report(record(history)).data));
    }
};

TEST(Summary, TextIsThisLineByLine) {
    // spot: 97.5 - 85 = 12.5 K. liner at 30 s: 30 degC simulated, 37 to 47 measured, 7 K below the nearer end.
    EXPECT_EQ(MadeUpRun().text(),
              "A warm spot (sample/spot)\n"
              "Hottest: 97.5 degC in tread, after 60 s.\n"
              "Simulated - measured: spot +12.5 K, liner -7 K.\n"
              "\n"
              "Sensors\n"
              "  channel  unit  final    min    max          measured  sim - meas  source\n"
              "  spot     degC  97.50  23.00  97.50                85      +12.50  camera\n"
              "  liner    degC  40.00  23.00  40.00  37 to 47 at 30 s       -7.00  thermocouple\n"
              "  hottest  97.50 degC  at 60 s  tread, on top, radius 2.50 mm, depth 0.00 mm\n"
              "  coldest  23.00 degC  at 0 s   bulk, radius 17.50 mm, depth 11.00 mm\n"
              "\n"
              "Heat budget\n"
              "  heat into it  W at the end  kJ in all\n"
              "  laser               1.0000     0.0600\n"
              "  still_air          -0.2500    -0.0060\n"
              "  sum                 0.7500     0.0540\n"
              "  stored                         0.0540\n"
              "  energy balance error 1.2e-13 (stored minus sum, relative to all heat exchanged)\n"
              "\n"
              "Cost\n"
              "  mesh    patch about its axis, 24 cells, layers tread, bulk\n"
              "  steps   1 234, 5 rejected, 6 factorisations\n"
              "  solver  CHOLMOD simplicial, 99 entries in the factor\n"
              "  time    0.020 s for 60 s, 3 000 x real time; assembly 0.001, factor 0.002, solve 0.003, output 0.004\n"
              "\n"
              "Warnings\n"
              "  spot.toml:3: 8 m is an unusual thickness\n"
              "  air_convection is known up to 50 degC; it was between 20.0 and 57.0 degC\n"
              "\n"
              "Cite\n"
              "  A thesis, chapter III\n"
              "  A paper\n"
              "\n"
              "Files\n"
              "  out/results.h5\n"
              "  out/channels.csv\n");
}

TEST(Summary, HeatOfAQuarterIsToldOfTheWholeSpecimen) {
    MadeUpRun made_up;
    made_up.problem.symmetry = 4.0;
    const std::string text = made_up.text();
    EXPECT_NE(text.find("Heat budget of the whole specimen, 4 times the mesh\n"), std::string::npos) << text;
    const nlohmann::json json = made_up.json();
    EXPECT_EQ(json["budget"][1]["watts_final"], 4.0);
    EXPECT_EQ(json["budget"][1]["joules"], 240.0);
    EXPECT_EQ(json["stored_joules"], 216.0);
}

// Effects of the user's own share an entry of the catalogue; each is reported by its own name.
TEST(Summary, EffectsOfTheUsersOwnAreToldApart) {
    MadeUpRun made_up;
    made_up.problem.effects[1] = made_up.problem.effects[2] =
        physics::activate(*physics::find_effect("own_source"), made_up.problem.mesh);
    made_up.problem.effects[1].name = "throttle_heat";
    made_up.problem.effects[2].name = "brake_heat";
    const nlohmann::json budget = made_up.json()["budget"];
    EXPECT_EQ(budget[1]["effect"], "throttle_heat");
    EXPECT_EQ(budget[1]["watts_final"], 1.0);
    EXPECT_EQ(budget[1]["joules"], 60.0);
    EXPECT_EQ(budget[2]["effect"], "brake_heat");
    EXPECT_EQ(budget[2]["watts_final"], -0.25);
    EXPECT_EQ(budget[2]["joules"], -6.0);
}

TEST(Summary, ValueInsideAMeasuredRangeIsWithinIt) {
    MadeUpRun made_up;
    made_up.problem.measured = {{.channel = "liner", .time = 60.0, .low = 312.15, .high = 314.15, .source = "camera"}};
    EXPECT_NE(made_up.text().find("39 to 41      within  camera\n"), std::string::npos) << made_up.text();
}

TEST(Summary, MeasuredValueBeyondTheEndIsLeftOut) {
    MadeUpRun made_up;
    made_up.problem.measured[0].time = 61.0;
    EXPECT_EQ(made_up.text().find("camera"), std::string::npos);
    EXPECT_EQ(made_up.json()["measured"].size(), 1u);
}

TEST(Summary, SteadyStateHasNoSumsOverTime) {
    MadeUpRun made_up;
    made_up.problem.settings.steady = true;
    const std::string text = made_up.text();
    EXPECT_EQ(text.find("kJ"), std::string::npos) << text;
    EXPECT_EQ(text.find("stored"), std::string::npos) << text;
    EXPECT_NE(text.find("steady state"), std::string::npos) << text;
}

// The sample's spot reads 23 to 97.5 degC in its rows. Steps between them that reach 103.5 degC miss 6 K of 80.5 K, more than
// 5 %; 101 degC miss 3.5 K of 78 K, less.
TEST(Summary, PeaksBetweenTheRowsOfOutputAreNamed) {
    MadeUpRun made_up;
    made_up.problem.settings.output_interval = 30.0;
    made_up.report.channel_max[0] = 103.5 + 273.15;
    EXPECT_NE(made_up.text().find("The output interval of 30 s misses peaks of spot by up to 6.0 K"), std::string::npos)
        << made_up.text();
    made_up.report.channel_max[0] = 101.0 + 273.15;
    EXPECT_EQ(made_up.text().find("further"), std::string::npos) << made_up.text();
}

TEST(Summary, EarlyEndIsToldFirst) {
    MadeUpRun made_up;
    made_up.report.status = {.outcome = solver::Outcome::not_converged, .message = "cell 3 did not settle"};
    EXPECT_TRUE(made_up.text().starts_with("A warm spot (sample/spot)\nended early: cell 3 did not settle\n"))
        << made_up.text();
    EXPECT_EQ(made_up.json()["error"], "cell 3 did not settle");
}

TEST(Summary, RunThatFailedBeforeItsFirstRowStillHasASummary) {
    MadeUpRun made_up;
    made_up.report = {};
    made_up.report.status = {.outcome = solver::Outcome::not_converged, .message = "no steady state"};
    const History nothing;
    EXPECT_NE(page_text(run_report(made_up.record(nothing)), false).find("no steady state"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(json_text(run_report(made_up.record(nothing)).data))["error"], "no steady state");
}

TEST(Summary, CaseWithoutATitleIsNamedOnce) {
    MadeUpRun made_up;
    made_up.problem.title = made_up.problem.name;
    EXPECT_TRUE(made_up.text().starts_with("sample/spot\nHottest: ")) << made_up.text();
}

TEST(Summary, HeadingsAreBoldOnATerminalOnly) {
    const MadeUpRun made_up;
    const History history = sample::history(made_up.problem);
    EXPECT_TRUE(page_text(run_report(made_up.record(history)), true)
                    .starts_with("\033[1mA warm spot (sample/spot)\033[0m\nHottest: "));
    EXPECT_EQ(made_up.text().find('\033'), std::string::npos);
}

TEST(Summary, JsonHasTheAgreedKeys) {
    const nlohmann::json json = MadeUpRun().json();
    EXPECT_EQ(json["case"], "sample/spot");
    EXPECT_EQ(json["cells"], 24);
    EXPECT_EQ(json["steps"], 1234);
    EXPECT_EQ(json["factorisations"], 6);
    EXPECT_EQ(json["seconds"], 0.02);
    EXPECT_EQ(json["simulated_seconds"], 60.0);
    EXPECT_EQ(json["energy_closure"], 1.25e-13);
    EXPECT_EQ(json["channels"][0]["name"], "spot");
    EXPECT_EQ(json["channels"][0]["unit"], "degC");
    EXPECT_DOUBLE_EQ(json["channels"][0]["final"], 97.5);
    EXPECT_DOUBLE_EQ(json["channels"][0]["min"], 23.0);
    EXPECT_DOUBLE_EQ(json["channels"][0]["max"], 97.5);
    EXPECT_EQ(json["budget"][2]["effect"], "still_air");
    EXPECT_EQ(json["budget"][2]["watts_final"], -0.25);
    EXPECT_EQ(json["budget"][2]["joules"], -6.0);
    EXPECT_DOUBLE_EQ(json["hottest"]["temperature"], 97.5);
    EXPECT_EQ(json["hottest"]["unit"], "degC");
    EXPECT_EQ(json["hottest"]["time"], 60.0);
    EXPECT_EQ(json["hottest"]["layer"], "tread");
    EXPECT_TRUE(json["hottest"].contains("zone"));
    EXPECT_EQ(json["outputs"], (std::vector<std::string>{"out/results.h5", "out/channels.csv"}));
    EXPECT_FALSE(json.contains("error"));
}

TEST(Summary, HeatOfADrumIsToldWhereItCounts) {
    MadeUpRun made_up;
    made_up.problem.effects[2] = physics::activate(*physics::find_effect("drum_heating"), made_up.problem.mesh);
    EXPECT_NE(made_up.text().find("drum_heating is what the drum loses to the air"), std::string::npos)
        << made_up.text();
    EXPECT_EQ(made_up.text().find("for a share of"), std::string::npos);
    made_up.problem.effects[2].parameters[0] = 0.25;
    EXPECT_NE(made_up.text().find("for a share of 0.25"), std::string::npos) << made_up.text();
}

TEST(Summary, TireIsComparedWithATwoNodeModelWhereThatHasAMeaning) {
    MadeUpRun made_up;
    made_up.problem.effects[2] = physics::activate(*physics::find_effect("air_convection"), made_up.problem.mesh);
    // k = G dZ / S_tot = 0.125 * 0.010 / (2 pi 0.3308 0.225) = 0.00267
    EXPECT_NE(made_up.text().find("k = 0.00267 W/mK"), std::string::npos) << made_up.text();
    EXPECT_EQ(made_up.json()["effective_two_node_conductance"], 0.125);
    // The bulk lies from 8 to 12 mm; everything 1.5 times as deep, its mean depth is 15 mm and k 1.5 times as large.
    EXPECT_NE(made_up.text().find("over 10 mm, the mean depth of the bulk\n"), std::string::npos) << made_up.text();
    std::ranges::for_each(made_up.problem.mesh.centre, [](mesh::Point& centre) { centre[2] *= 1.5; });
    EXPECT_NE(made_up.text().find("k = 0.00401 W/mK over 15 mm, the mean"), std::string::npos) << made_up.text();
    // A link says itself how long it is.
    made_up.problem.mesh.links = {{.name = "bulk_to_surface", .length = 0.02, .region = 1}};
    EXPECT_NE(made_up.text().find("k = 0.00535 W/mK over 20 mm\n"), std::string::npos) << made_up.text();
    made_up.report.effective_two_node_conductance = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(made_up.text().find("two-node"), std::string::npos);
    EXPECT_TRUE(made_up.json()["effective_two_node_conductance"].is_null());
}

TEST(Summary, LumpHasALayerButNoPosition) {
    MadeUpRun made_up;
    made_up.problem.mesh =
        mesh::build(mesh::TwoNode{.area = 1.0, .surface_volume = 1e-3, .bulk_volume = 1e-2, .bulk_depth = 0.01});
    made_up.report.hottest.node = 1;
    const nlohmann::json hottest = made_up.json()["hottest"];
    EXPECT_EQ(hottest["layer"], "bulk");
    EXPECT_DOUBLE_EQ(hottest["temperature"], 97.5);
    EXPECT_EQ(hottest["time"], 60.0);
    EXPECT_TRUE(hottest["position"].is_null());
}

/// The chart of a report with this title; null where there is none.
nlohmann::json chart_of(const Report& report, std::string_view title) {
    for (const ReportSection& section : report.sections) {
        for (const PageItem& block : section.blocks()) {
            if (block.kind == PageItem::Kind::chart && block.text == title) {
                return nlohmann::json::parse(compact_json(block.chart));
            }
        }
    }
    return {};
}

// Each moment of the sample has 0, 1 and -0.25 W: conduction has no heat of its own, the sum is 0.75 W. With a quarter of the
// specimen in the mesh all of it is four times as much.
TEST(Summary, HeatOfEachPathStandsAtEveryRow) {
    MadeUpRun run;
    run.problem.symmetry = 4.0;
    const History history = sample::history(run.problem);
    const nlohmann::json chart = chart_of(run_report(run.record(history)), "Heat of each path against time");
    ASSERT_FALSE(chart.is_null());
    const nlohmann::json& series = chart["panels"][0]["series"];
    ASSERT_EQ(series.size(), 3u);
    EXPECT_EQ(series[0]["name"], "laser");
    EXPECT_EQ(series[0]["points"], nlohmann::json::parse("[[0.0,4.0],[30.0,4.0],[60.0,4.0]]"));
    EXPECT_EQ(series[1]["points"], nlohmann::json::parse("[[0.0,-1.0],[30.0,-1.0],[60.0,-1.0]]"));
    EXPECT_EQ(series[2]["points"], nlohmann::json::parse("[[0.0,3.0],[30.0,3.0],[60.0,3.0]]"));
    EXPECT_EQ(chart["panels"][0]["unit"], "W");
}

// 370.65 K are 97.5 degC, 12.5 K above 85; the liner's 30 degC at 30 s are 7 K below the range's 37 degC.
TEST(Summary, ThePageBeginsWithTheHottestPlaceAndEndsWithWhatToCite) {
    const MadeUpRun run;
    const History history = sample::history(run.problem);
    const Report report = run_report(run.record(history));
    EXPECT_EQ(report.verdict, (std::vector<std::string>{"Hottest: 97.5 degC in tread, after 60 s.",
                                                        "Simulated - measured: spot +12.5 K, liner -7 K."}));
    ASSERT_EQ(report.appendix.size(), 1u);
    std::string cited;
    for (const PageItem& block : report.appendix.front().blocks()) {
        cited += block.text + "\n";
    }
    EXPECT_NE(cited.find("A paper (this case)"), std::string::npos);
    EXPECT_NE(cited.find(std::string(physics::find_effect("laser")->source)), std::string::npos);
}

}  // namespace
}  // namespace tiretherm::post
