// SPDX-License-Identifier: BSD-3-Clause
// Reports of diagnoses of every verdict: what the page, the JSON, the residual files and the extended case say.

#include "post/diagnosis/diagnosis_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "input/runs/reader.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/diagnosis/tried_sections.hpp"
#include "post/report/file.hpp"
#include "post/report/number_text.hpp"
#include "tests/diagnosis/made_up_diagnosis.hpp"
#include "tests/support/report_cells.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::diagnosis {
namespace {

using namespace post;
using Json = nlohmann::json;
using sample::MadeUp;

std::string page(const MadeUp& made_up) { return page_text(diagnosis_report(made_up.record(), {}), false); }
Json json(const MadeUp& made_up) { return Json::parse(json_text(diagnosis_report(made_up.record(), {}).data)); }
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The same words, however they are broken into lines.
std::string on_one_line(const std::string& text) {
    std::istringstream words(text);
    std::string line;
    for (std::string word; words >> word;) {
        line += (line.empty() ? "" : " ") + word;
    }
    return line;
}

// A loss that run3 has for itself: 1.2 times the 2.14e15 of the others.
TEST(DiagnosisReport, ACauseOfOneRunIsSaidWithTheRunAndTheOthersNumber) {
    MadeUp made_up = sample::named();
    made_up.result.causes.front() = {.id = "strain_energy_loss",
                                     .run = "run3",
                                     .numbers = {{.key = "tan_delta_a", .unit = "1", .value = 2.568e15}},
                                     .instead_of = 2.14e15,
                                     .sigma = 20.0,
                                     .in_set = true,
                                     .rank = 1};
    made_up.result.cannot_see = {{.cause = "load_input_gain", .key = "gain", .value = 0.8}};
    const std::string reason = reason_of(made_up.record());
    EXPECT_TRUE(has(reason, "strain_energy_loss in run3, tan_delta_a 2.568e+15")) << reason;
    EXPECT_TRUE(has(reason, "20.0 standard deviations from the 2.14e+15 of the other runs")) << reason;
    const Json data = json(made_up);
    EXPECT_EQ(data["causes"][0]["run"], "run3");
    EXPECT_EQ(data["cannot_see"][0]["cause"], "load_input_gain");
}

TEST(DiagnosisReport, ANamedCauseIsSaidWithItsSizeAndWhatItIs) {
    const MadeUp made_up = sample::named();
    EXPECT_EQ(reason_of(made_up.record()),
              "One cause explains what the model gets wrong: sidewall_convection, conductance 8.10 W/K (7.20 to 9.00), "
              "17.6 standard deviations from no effect.");
    const std::string text = on_one_line(page(made_up));
    EXPECT_TRUE(has(text, "Heat that leaves through the sidewalls")) << text;
    // Its confounded groups: what it cannot be distinguished from in principle, and what would discriminate
    EXPECT_TRUE(has(text, "Confounded with inner_gas, radiation. What separates them: a channel in the gas")) << text;
    EXPECT_TRUE(has(text, "Confounded with sensor_offset.")) << text;
    EXPECT_FALSE(has(text, "clock_delay")) << "sensor_lag is not in the set: " << text;
    EXPECT_TRUE(
        has(text, "97 % of the error that a model could remove (mean square) is removed (95 %: 93 to 99 %); confirmed"))
        << text;
}

TEST(DiagnosisReport, APairIsOneExplanationOfTwoCauses) {
    const MadeUp made_up = sample::pair();
    EXPECT_EQ(reason_of(made_up.record()),
              "Two causes together explain what the model gets wrong, none of them alone: sidewall_convection, "
              "conductance 8.10 W/K (7.20 to 9.00), 17.6 standard deviations from no effect; and sensor_lag of "
              "bulk_temperature, tau 12.0 s (9.0 to 15.0), 7.8 standard deviations from no effect.");
    EXPECT_EQ(json(made_up)["set"], Json::parse(R"([["sidewall_convection", "sensor_lag"]])"));
}

TEST(DiagnosisReport, ConfoundedListsAllWithTheirSizesAndWhatWouldTell) {
    const MadeUp made_up = sample::confounded();
    EXPECT_EQ(reason_of(made_up.record()),
              "Something is missing, and these data cannot tell apart: sidewall_convection, conductance 8.10 W/K (7.20 "
              "to 9.00); or inner_gas, liner 9.0 W/K (8.0 to 10.0), rim 4.00 W/K (3.60 to 4.40); or inner_gas, liner "
              "9.0 W/K (8.0 to 10.0), rim 4.00 W/K (3.60 to 4.40) with sensor_lag of bulk_temperature, tau 12.0 s (9.0 "
              "to 15.0). To tell them apart: coast-down from 150 km/h, 5 min. This additional test would raise their "
              "separation from 1.2 to 7 standard deviations (2 to 3 are needed).");
    const Json said = json(made_up);
    EXPECT_EQ(said["set"], Json::parse(R"([["sidewall_convection"], ["inner_gas"], ["inner_gas", "sensor_lag"]])"));
    EXPECT_EQ(said["next_experiment"], "coast-down from 150 km/h, 5 min: from 1.2 to 7 sigma");
}

// Members of a search by prediction are alike in what they predict: 16 standard deviations of the noise are no "2 to 3 are needed".
TEST(DiagnosisReport, MembersThatPredictAlikeAreNotAskedForASeparationThatTheyHave) {
    MadeUp made_up = sample::confounded();
    made_up.result.next = {{.name = "coast-down from 150 km/h, 5 min", .now = 16.0, .then = 36.0}};
    made_up.result.held_out_gains = {{.causes = {0}, .removed = 0.5, .low = 0.4, .high = 0.6}};
    const std::string reason = reason_of(made_up.record());
    EXPECT_TRUE(has(
        reason,
        "They predict left-out data alike, as an error of the model stands beside them, though the sensors' noise "
        "alone "
        "would tell them apart (16 standard deviations). coast-down from 150 km/h, 5 min would set them further apart, "
        "by 36."))
        << reason;
    EXPECT_FALSE(has(reason, "are needed")) << reason;
}

// The surface, with a sensor of 0.5 K, falls from 0.94 to 0.85 K: 0.16 of the 0.63 K2 beyond its noise.
TEST(DiagnosisReport, AnAnswerThatLeavesTheGreaterPartMayStandForIt) {
    MadeUp made_up = sample::named();
    made_up.result.gain.confirmed = false;
    made_up.result.gain.removed = 0.5;
    made_up.result.channels[0].heldout_before = 0.94;
    made_up.result.channels[0].heldout_after = 0.85;
    EXPECT_TRUE(has(certainty_of(made_up.record()).front(),
                    "The greater part of what is wrong with surface_temperature is left"));
    made_up.result.channels[0].heldout_after = 0.5;
    EXPECT_FALSE(has(certainty_of(made_up.record()).front(), "The greater part"));
}

TEST(DiagnosisReport, AnUnknownSourceMayStandBesideACause) {
    MadeUp made_up = sample::unknown();
    made_up.result.verdict = Verdict::confounded;
    made_up.result.causes = {sample::sidewalls()};
    made_up.result.hypotheses = {{0}};
    EXPECT_EQ(
        reason_of(made_up.record()),
        "Something is missing, and these data cannot tell apart: sidewall_convection, conductance 8.10 W/K (7.20 "
        "to 9.00); or, what no effect of the catalogue is, heat at surface that follows throttle: 310 W where that "
        "is largest (250 to 370).");
    const Json said = json(made_up);
    EXPECT_EQ(said["set"], Json::parse(R"([["sidewall_convection"]])"));
    EXPECT_EQ(said["unknown"]["follows"], "throttle");
}

TEST(DiagnosisReport, ANumberThatIsWrongIsSaidBesideTheCases) {
    MadeUp made_up = sample::named();
    made_up.result.causes.front().instead_of = 4.0;
    EXPECT_TRUE(has(reason_of(made_up.record()), "17.6 standard deviations from the case's 4."))
        << reason_of(made_up.record());
    EXPECT_EQ(json(made_up)["causes"][0]["instead_of"], 4.0);
    EXPECT_TRUE(json(sample::named())["causes"][0]["instead_of"].is_null());
}

TEST(DiagnosisReport, AnUnknownSourceHasPlaceSignalAndWatts) {
    MadeUp made_up = sample::unknown();
    EXPECT_EQ(reason_of(made_up.record()),
              "Something is missing that no effect of the catalogue is: heat at surface that follows throttle: 310 W "
              "where that is largest (250 to 370); 12.0 standard deviations. Equally consistent with the data: bulk, "
              "throttle.");
    const Json said = json(made_up)["unknown"];
    EXPECT_EQ(said["place"], "surface");
    EXPECT_EQ(said["follows"], "throttle");
    EXPECT_EQ(said["watts"], 310.0);
    EXPECT_EQ(said["signal_unit"], "1");
    EXPECT_TRUE(has(on_one_line(page(made_up)), "310 W per 1 of throttle.")) << page(made_up);
    EXPECT_FALSE(said.contains("window"));

    made_up.result.unknown->follows = "time window";
    made_up.result.unknown->run = "run2";
    made_up.result.unknown->from = 120.0;
    made_up.result.unknown->to = 150.0;
    EXPECT_TRUE(has(reason_of(made_up.record()), "heat at surface from 120 s to 150 s of run2: 310 W (250 to 370)"))
        << reason_of(made_up.record());
    EXPECT_EQ(json(made_up)["unknown"]["window"], Json::parse(R"({"run": "run2", "from": 120.0, "to": 150.0})"));
}

// What a sensor adds is no heat: it has no watts but the unit of its channel.
TEST(DiagnosisReport, AnUnknownReadingHasNoWatts) {
    MadeUp made_up = sample::unknown();
    made_up.result.unknown->sensor = true;
    made_up.result.unknown->place = "bulk_temperature";
    made_up.result.unknown->watts = 1.5;
    made_up.result.unknown->low = 1.2;
    made_up.result.unknown->high = 1.8;
    EXPECT_TRUE(has(reason_of(made_up.record()),
                    "an error in the reading of bulk_temperature that follows throttle, not "
                    "by heat: 1.50 K where that is largest (1.20 to 1.80)"))
        << reason_of(made_up.record());
    const Json said = json(made_up)["unknown"];
    EXPECT_TRUE(said["watts"].is_null());
    EXPECT_EQ(said["size"]["unit"], "K");
    EXPECT_EQ(said["size"]["value"], 1.5);
}

TEST(DiagnosisReport, ConsistentQuotesUpperLimits) {
    const MadeUp made_up = sample::consistent();
    const std::string text = on_one_line(page(made_up));
    // Timing first, then sensors, then the rest; what has one side begins at none.
    EXPECT_TRUE(has(text,
                    "- sensor_lag tau: surface_temperature at most 0.60 s; bulk_temperature at most 2.1 s - "
                    "sensor_offset kelvin: bulk_temperature -0.20 to 0.30 K - sidewall_convection conductance: at "
                    "most 0.80 W/K 95 %, each cause alone beside the free parameters. All 4 stand in"))
        << text;
    EXPECT_FALSE(has(text, "extended")) << "nothing was added: " << text;
    const Json said = json(made_up);
    EXPECT_EQ(said["verdict"], "consistent");
    EXPECT_TRUE(said["set"].empty());
    EXPECT_TRUE(said["unknown"].is_null());
    EXPECT_EQ(said["limits"].size(), 4u);
}

// 36 % of the mean square are 1 - sqrt(0.64) = 20 % of the rms; -4 and 51 % of it are -2 and 30 %.
TEST(DiagnosisReport, WhereNoCauseIsCertainTheBestOfWhatWasTriedIsTheHeadline) {
    MadeUp made_up = sample::nothing_predicts();
    EXPECT_EQ(reason_of(made_up.record()),
              "No cause is certain. Best of 42 candidates: sensor_lag of surface_temperature, tau 1.40 s (0.90 to "
              "1.90). It would remove 20 % of the error (rms) on data that were left out (95 %: -2 to 30 %); that may "
              "be chance.");
    made_up.result.tried.clear();
    EXPECT_EQ(reason_of(made_up.record()),
              "No cause is certain: none of 42 candidates predicts data that were left out better.");
}

// 2.1 to 1.7 K is a gain of 0.4 K. What was not tested is known to first order: 9.75 % of the mean square are 5 % of the rms.
TEST(DiagnosisReport, ThreeImprovementsThatWereNotTakenHaveTheirGainAndWhatIsAgainstThem) {
    const MadeUp made_up = sample::nothing_predicts();
    const std::string text = on_one_line(page(made_up));
    EXPECT_TRUE(has(text,
                    "- sensor_lag of surface_temperature, tau 1.40 s (0.90 to 1.90): surface_temperature 2.10 to "
                    "1.70 K rms, gain 0.40 (95 %: -0.10 to 0.60) on left-out data; that may be chance."))
        << text;
    EXPECT_TRUE(has(text, "(95 %: 0.020 to 0.150) on left-out data; another sensor is predicted worse.")) << text;
    EXPECT_TRUE(has(text, "emissivity 0.8: about 5 % of the rms; it wants the end of what is plausible.")) << text;
    EXPECT_FALSE(has(text, "inner_gas, liner")) << "a fourth: " << text;
    const Json tried = json(made_up)["tried"];
    ASSERT_EQ(tried.size(), 4u);
    EXPECT_EQ(tried[0]["causes"][0]["channel"], "surface_temperature");
    EXPECT_EQ(tried[0]["removed"], 0.36);
    EXPECT_EQ(tried[3]["against"], "it promised too little to be tested");
}

// The model is 0.5 K too cold in all samples, whatever was driven.
TEST(DiagnosisReport, WhatIsLeftIsSaidWithPhaseAndSignalAndWhatWouldTell) {
    const MadeUp made_up = sample::nothing_predicts();
    const std::vector<std::string> said = certainty_of(made_up.record());
    ASSERT_EQ(said.size(), 2u);
    EXPECT_EQ(said[0],
              "Remaining error: surface_temperature differs by 1.2 K rms beyond its noise: -0.50 K while free rolling "
              "and -0.50 K while slipping.");  // a constant follows nothing
    EXPECT_EQ(said[1],
              "Next measurement: coast-down from 150 km/h, 5 min. It would tell sensor_lag of surface_temperature from "
              "convection_exponent by 3.1 standard deviations, now 0.4.");
}

// Layers gain what two nodes cannot: it is said in kelvin, with the free numbers that they give, but not the starts.
TEST(DiagnosisReport, TwoNodesThatAreTooFewAreSaidToBeSo) {
    MadeUp made_up = sample::nothing_predicts();
    made_up.result.richer_meshes = {
        {.name = "layers",
         .is_better = true,
         .removed = 0.3,
         .low = 0.1,
         .high = 0.4,
         .change = ChannelChange{.channel = 1, .before = 2.1, .after = 1.7, .low = 0.1, .high = 0.6},
         .numbers = {{.name = "film", .unit = "1", .value = 1.05, .low = 0.98, .high = 1.12},
                     {.name = "initial bulk, run run1", .unit = "K", .value = 0.0, .low = -1.0, .high = 1.0}}}};
    EXPECT_EQ(richer_mesh_sentence(made_up.record()),
              "Two nodes are too few: layers predict better without any cause: bulk_temperature 2.10 to 1.70 K rms, "
              "gain 0.40 (95 %: 0.10 to 0.60). On them: film 1.050 (0.980 to 1.120).");
    made_up.result.richer_meshes.front().is_better = false;
    EXPECT_EQ(richer_mesh_sentence(made_up.record()), "");
}

TEST(DiagnosisReport, CannotTellSaysWhyAndWhatHelps) {
    MadeUp made_up = sample::cannot_tell();
    EXPECT_TRUE(has(reason_of(made_up.record()),
                    "its discretisation error (steps and grid) is 5.3 standard deviations, and 3 are allowed. It falls "
                    "with the square "
                    "of the spacing: 1.3 times as many cells in every direction would do."))  // sqrt(5.3 / 3) = 1.33
        << reason_of(made_up.record());
    made_up.result.reason = remark::no_sensor_changes({remark::sensor_of_run("bulk", "run1")});
    EXPECT_EQ(reason_of(made_up.record()), "These data do not allow a diagnosis: no sensor changes (bulk of run1).");
}

// The gauge gains a tenth, 10 of 100 kPa; the surface gains half, 0.5 of 1 K: a share is the same in every unit.
TEST(DiagnosisReport, TheChannelThatGainsTheLargestShareIsNamed) {
    MadeUp made_up = sample::named();
    made_up.result.channels[0].heldout_before = 1e5;
    made_up.result.channels[0].heldout_after = 0.9e5;
    made_up.result.channels[1].heldout_before = 1.0;
    made_up.result.channels[1].heldout_after = 0.5;
    EXPECT_TRUE(has(on_one_line(page(made_up)), "bulk_temperature: rms from 1 to 0.5 K)")) << page(made_up);
}

// The surface is off by 2 K, four of its standard deviations; the gauge by 500 Pa, half of one of its own.
TEST(DiagnosisReport, TheRemainingErrorIsThatOfTheChannelThatIsMostStandardDeviationsOff) {
    MadeUp made_up = sample::named();
    made_up.experiment.runs.front().problem.channels[1].quantity = solver::Quantity::gas_pressure;
    made_up.result.model_error = {{.channel = 0, .size = 2.0, .time_scale = 30.0, .noise = 0.5},
                                  {.channel = 1, .size = 500.0, .time_scale = 30.0, .noise = 1000.0}};
    EXPECT_TRUE(
        has(on_one_line(page(made_up)), "Remaining error: surface_temperature differs by 2 K rms beyond its noise"))
        << page(made_up);
}

TEST(DiagnosisReport, AStoppedDiagnosisSaysAfterHowLongAndWhatIsBest) {
    MadeUp made_up = sample::cannot_tell();
    made_up.result.stopped = Part::causes;
    made_up.result.reason = remark::best_so_far("inner_gas, sensor_lag");
    made_up.result.seconds = 1500.0;
    made_up.result.stopped_at = {.doing = Work::candidate, .of = "rim_conduction", .number = 3, .count = 14};
    made_up.result.rest_of_stage = 800.0;
    EXPECT_EQ(reason_of(made_up.record()),
              "No answer after 1500 s: stopped during the search of causes, at candidate 3 of 14 (rim_conduction). "
              "This stage "
              "needs about 800 s more. Best so far, not fitted: inner_gas, sensor_lag.");
}

// The base model is 0.5 K too cold everywhere, the extended one right; a mean of equal values has no uncertainty.
TEST(DiagnosisReport, ThePageShowsWhereAndWhatIsLeft) {
    const MadeUp made_up = sample::named();
    const Report report = diagnosis_report(made_up.record(), {});
    const ReportSection& where = section(report, "Where it shows");
    EXPECT_EQ(post::row_texts(where, 0), (std::vector<std::string>{"surface_temperature", "K", "all", "", "-0.50",
                                                                   "0.00", "0.50", "+0.00", "0.00", "0.00"}));
    EXPECT_EQ(post::cell_text(where, 1, "while"), "standing");  // a phase of the bench's programme
}

TEST(DiagnosisReport, NoLineIsWiderThanThePage) {
    for (const MadeUp& made_up : {sample::named(), sample::pair(), sample::confounded(), sample::unknown(),
                                  sample::consistent(), sample::cannot_tell(), sample::nothing_predicts()}) {
        std::istringstream lines(page(made_up));
        for (std::string line; std::getline(lines, line);) {
            EXPECT_LE(line.size(), 100u) << line;
        }
    }
}

TEST(DiagnosisReport, JsonHasTheKeysThatProgramsRead) {
    const Json said = json(sample::named());
    for (const char* key : {"verdict", "causes", "set", "unknown", "reason", "next_experiment", "channels", "gain",
                            "numerical_error_sigma", "noise", "simulations", "seconds"}) {
        EXPECT_TRUE(said.contains(key)) << key;
    }
    EXPECT_EQ(said["verdict"], "named");
    EXPECT_EQ(said["set"], Json::parse(R"([["sidewall_convection"]])"));
    EXPECT_TRUE(said["unknown"].is_null());
    EXPECT_EQ(said["next_experiment"], "");
    const Json& cause = said["causes"][0];
    EXPECT_EQ(cause["id"], "sidewall_convection");
    EXPECT_TRUE(cause["channel"].is_null());
    EXPECT_EQ(cause["parameters"]["conductance"],
              Json::parse(R"({"value": 8.1, "unit": "W/K", "low": 7.2, "high": 9.0})"));
    EXPECT_EQ(cause["sigma"], 17.64);
    EXPECT_EQ(cause["in_set"], true);
    EXPECT_EQ(cause["rank"], 1);
    EXPECT_EQ(said["causes"][1]["channel"], "bulk_temperature");
    EXPECT_EQ(said["causes"][1]["in_set"], false);
    EXPECT_EQ(said["channels"][1],
              Json::parse(R"({"name": "bulk_temperature", "unit": "K", "rmse_before": 1.9, "rmse_after": 0.31,
                              "heldout_before": 2.0, "heldout_after": 0.33})"));
    EXPECT_EQ(said["gain"]["removable_error_removed"], 0.97);
    EXPECT_EQ(said["gain"]["confirmed"], true);
    EXPECT_EQ(said["noise"][0]["channel"], "surface_temperature");
    EXPECT_EQ(said["noise"][0]["sigma"], 0.5);
    EXPECT_EQ(said["noise"][0]["rho_1s"], 0.0);  // white
    EXPECT_EQ(said["simulations"], 22);
}

// Without runs to hold out there is no gain to quote: null, not 0.
TEST(DiagnosisReport, WhatWasNotMeasuredIsNull) {
    MadeUp made_up = sample::named();
    made_up.result.gain = {};
    made_up.result.channels[0].heldout_before = std::numeric_limits<double>::quiet_NaN();
    const Json said = json(made_up);
    EXPECT_TRUE(said["gain"]["removable_error_removed"].is_null());
    EXPECT_EQ(said["gain"]["confirmed"], false);
    EXPECT_TRUE(said["channels"][0]["heldout_before"].is_null());
}

// The numbers that programs compare, and their units, written out: a change of the catalogue must not change them.
TEST(DiagnosisReport, UnitsAreThoseThatProgramsCompare) {
    struct Compared {
        const char* effect;
        const char* key;
        const char* unit;
    };
    constexpr std::array compared{
        Compared{"sidewall_convection", "conductance", "W/K"},
        Compared{"inner_gas", "liner", "W/K"},
        Compared{"inner_gas", "rim", "W/K"},
        Compared{"inflation_pressure_rise", "exponent", "1"},
        Compared{"cornering_loss", "coefficient", "1/N"},
        Compared{"convection_exponent", "exponent", "1"},
        Compared{"partition_speed", "slope", "s/m"},
        Compared{"loss_tangent_slope", "slope", "1/K"},
        Compared{"load_exponent_of_loss", "exponent", "1"},
        Compared{"standing_wave", "gain", "1/(km/h)^2"},
        Compared{"standing_wave", "critical_speed", "km/h"},
        Compared{"road_temperature_drift", "rate", "K/h"},
        Compared{"air_temperature_drift", "rate", "K/h"},
        Compared{"sensor_lag", "tau", "s"},
        Compared{"sensor_offset", "kelvin", "K"},
        Compared{"sensor_gain", "excess", "1"},
        Compared{"camera_emissivity", "emissivity", "1"},
        Compared{"layer_heat_capacity", "scale", "1"},
        Compared{"layer_conductivity", "scale", "1"},
        Compared{"slip_input_gain", "gain", "1"},
    };
    for (const Compared& one : compared) {
        const physics::Effect* effect = physics::find_effect(one.effect);
        ASSERT_NE(effect, nullptr) << one.effect;
        const int key = physics::find_parameter(*effect, one.key);
        ASSERT_GE(key, 0) << one.effect << " " << one.key;
        EXPECT_EQ(slashed_unit(effect->parameters[static_cast<std::size_t>(key)].unit), one.unit) << one.effect;
    }
}

TEST(DiagnosisReport, AUnitIsWrittenAsAFraction) {
    EXPECT_EQ(slashed_unit("W m-2 K-1"), "W/(m2 K)");
    EXPECT_EQ(slashed_unit("N-1"), "1/N");
    EXPECT_EQ(slashed_unit("J m-3 K-1"), "J/(m3 K)");
    EXPECT_EQ(slashed_unit("1/(km/h)^2"), "1/(km/h)^2");
    EXPECT_EQ(slashed_unit("N m"), "N m");
    EXPECT_EQ(slashed_unit("-"), "-");
    EXPECT_EQ(slashed_unit(""), "");
}

// 3 runs of 601 samples of 2 channels. In white noise of 0.5 and 0.3 K, 0.5 K too cold are
// -1 and -5/3 standard deviations.
TEST(DiagnosisReport, ResidualsAreWritten) {
    const MadeUp made_up = sample::named();
    const input::Written written;
    DiagnosisRecord record = made_up.record();
    const std::vector<std::filesystem::path> files = write_diagnosis(record, written.folder() / "out");
    ASSERT_EQ(files.size(), 2u);
    const std::string rows = post::read_text(written.folder() / "out" / "residuals.csv");
    EXPECT_EQ(std::ranges::count(rows, '\n'), 1 + 3606);
    std::istringstream lines(rows);
    std::string heading;
    std::string first;
    std::getline(lines, heading);
    std::getline(lines, first);
    EXPECT_EQ(heading, "time [s],run,channel,unit,measured,base,extended,whitened_base [1],whitened_extended [1]");
    EXPECT_TRUE(first.starts_with("0,run1,surface_temperature,degC,")) << first;
    EXPECT_TRUE(first.ends_with(",-1,0")) << first;
    EXPECT_TRUE(has(rows, ",-1.6667,0\n"));
    const Json said = Json::parse(post::read_text(written.folder() / "out" / "diagnosis.json"));
    EXPECT_EQ(said["outputs"].size(), 2u);
    for (const std::filesystem::path& file : files) {
        EXPECT_GT(std::filesystem::file_size(file), 100u) << file;
    }
}

TEST(DiagnosisReport, TheExtendedCaseHoldsTheCauseAtItsFittedValue) {
    MadeUp made_up = sample::named();
    const std::vector<Candidate> all = candidates_of(made_up.experiment, {"sidewall_convection"});
    ASSERT_EQ(all.size(), 1u);
    made_up.result.extended_model = with(made_up.experiment, all, {1.0});
    const Simulator simulator(*made_up.result.extended_model, made_up.observations);
    made_up.result.extended_values = simulator.start();
    made_up.result.extended_values[made_up.result.extended_values.size() - 1] = 8.1;
    const input::Written written;
    DiagnosisRecord record = made_up.record();
    const std::vector<std::filesystem::path> files = write_diagnosis(record, written.folder());
    EXPECT_TRUE(record.warnings.empty()) << record.warnings.front();
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[1], written.folder() / "extended.toml");
    const input::Reading reading = input::read_case(files[1]);
    ASSERT_TRUE(reading.problem) << input::error_report(reading);
    const auto& effects = reading.problem->effects;
    const auto found =
        std::ranges::find_if(effects, [](const auto& one) { return one.effect->id == "sidewall_convection"; });
    ASSERT_NE(found, effects.end());
    EXPECT_DOUBLE_EQ(found->parameters.front(), 8.1);
    EXPECT_EQ(reading.problem->settings.tolerance, made_up.experiment.runs.front().problem.settings.tolerance);
    EXPECT_TRUE(has(post::read_text(files[1]), "# One cause explains what the model gets wrong"))
        << post::read_text(files[1]);
}

// The most significant windows, whatever their sign, the most significant first.
TEST(DiagnosisReport, WindowsOfMissingHeatAreReportedAndWritten) {
    MadeUp made_up = sample::unknown();
    for (int i = 0; i < 7; ++i) {
        made_up.result.missing_heat.push_back(
            {.run = 1, .place = "bulk", .from = 30.0 * i, .to = 30.0 * (i + 1), .watts = 10.0 * i, .deviation = 20.0});
    }
    made_up.result.missing_heat.push_back(
        {.run = 2, .place = "surface", .from = 600.0, .to = 630.0, .watts = -85.0, .deviation = 20.0});
    const Report report = diagnosis_report(made_up.record(), {});
    const ReportSection& inferred = section(report, "Inferred heat source");
    // -85 W and 60 W with 1.96 standard deviations of 20 W to either side
    EXPECT_EQ(post::row_texts(inferred, 0),
              (std::vector<std::string>{"run3", "surface", "600", "630", "-85", "-124", "-46", "-4.2"}));
    EXPECT_EQ(post::row_texts(inferred, 1),
              (std::vector<std::string>{"run2", "bulk", "180", "210", "60", "21", "99", "+3.0"}));
    EXPECT_EQ(json(made_up)["missing_heat"].size(), 5u);
    EXPECT_EQ(post::row_count(inferred), 5u);
    const input::Written written;
    DiagnosisRecord record = made_up.record();
    EXPECT_EQ(write_diagnosis(record, written.folder()).size(), 3u);
    EXPECT_TRUE(
        has(post::read_text(written.folder() / "missing_heat.csv"), "run3,surface,600,630,-85,-124.2,-45.8,-4.25\n"));
}

// Two laps of the first of three runs, of two channels: a row for each lap and for each run as a whole.
TEST(DiagnosisReport, LapsAreWrittenWhereThereAreAny) {
    MadeUp made_up = sample::named();
    made_up.experiment.runs.front().laps = {{.number = 1, .start = 0.0, .end = 600.0},
                                            {.number = 2, .start = 600.0, .end = 1200.0}};
    const input::Written written;
    DiagnosisRecord record = made_up.record();
    EXPECT_EQ(write_diagnosis(record, written.folder()).size(), 3u);
    const std::string laps = post::read_text(written.folder() / "laps.csv");
    EXPECT_EQ(std::ranges::count(laps, '\n'), 1 + 2 * (2 + 3)) << laps;
}

// An extended case of an earlier diagnosis would pass for this one's.
TEST(DiagnosisReport, WithoutACauseNoExtendedCaseIsLeft) {
    const MadeUp made_up = sample::consistent();
    const input::Written written;
    const std::filesystem::path old = written.add("extended.toml", "title = \"old\"\n");
    DiagnosisRecord record = made_up.record();
    EXPECT_EQ(write_diagnosis(record, written.folder()).size(), 2u);
    EXPECT_FALSE(std::filesystem::exists(old));
}

}  // namespace
}  // namespace tiretherm::diagnosis
