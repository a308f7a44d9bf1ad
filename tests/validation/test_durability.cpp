// SPDX-License-Identifier: BSD-3-Clause
// cases/durability: what each test's page promises, on the grid it is shipped with and on one twice as fine.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/runs/continued_schedule.hpp"
#include "input/studies/study.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

constexpr double zero = 273.15;
constexpr double minute = 60.0;

std::filesystem::path file(const std::string& name) { return source_folder() / "cases/durability" / (name + ".toml"); }

/// The courses of a case's hot spots, in the order of its [[critical]].
struct Histories {
    std::vector<solver::HotSpotHistory> all;
    double energy_closure = 0.0;

    [[nodiscard]] double hottest(std::size_t i) const { return all[i].temperature()[all[i].hottest_row()] - zero; }
};

Histories run(const std::filesystem::path& path) {
    const Reading reading = read_case(path);
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    const std::optional<HotSpotCase> asked = HotSpotCase::read(path);
    Histories histories;
    if (!reading.problem || !asked) {
        return histories;
    }
    for (const solver::Critical& critical : asked->critical) {
        histories.all.emplace_back(reading.problem->mesh, critical);
    }
    const solver::MarchReport report = solver::run(*reading.problem, [&](const solver::Snapshot& now) {
        for (solver::HotSpotHistory& history : histories.all) {
            history.take(now);
        }
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    histories.energy_closure = report.energy_closure;
    return histories;
}

}  // namespace

// What the page says of each (docs/figures compares its numbers): heat is kept to round-off, the whole tire is at least as hot as
// its belt's edge but for 0.2 K, which the parabolas through the nodes are worth, and both are far above the room.
TEST(Durability, CasesKeepTheirHeatAndTheWholeTireHasTheBeltsEdge) {
    for (const char* name : {"fmvss_139_high_speed", "fmvss_139_endurance", "fmvss_139_low_pressure",
                             "un_r30_load_speed", "sae_j1561_step_speed", "sae_j1561_standing_wave"}) {
        SCOPED_TRACE(name);
        const Histories histories = run(file(name));
        ASSERT_EQ(histories.all.size(), 2U);
        EXPECT_EQ(histories.all[0].critical().name, "belt edge");
        EXPECT_GT(histories.hottest(1), histories.hottest(0) - 0.2);
        EXPECT_GT(histories.hottest(0), 70.0);
        EXPECT_LE(histories.energy_closure, 1e-10);
    }
}

// At the same load, speed and room 140 kPa heat more than 180 kPa: the loss goes with pressure^-0.45, and the laws of the load are
// those of a higher one.
TEST(Durability, LowPressureIsHotter) {
    EXPECT_GT(run(file("fmvss_139_low_pressure")).hottest(0), run(file("fmvss_139_endurance")).hottest(0) + 1.0);
}

// Cells halved in both directions, 6 144 of them, in the steady state of the last step: the hot spot moves by less than
// 0.5 K, and by less than the rise from step to step that it is meant to tell.
TEST(DurabilityGrid, HotSpotMovesByLessThanHalfAKelvinOnAGridTwiceAsFine) {
    const Written written;
    const std::string include =
        "include = [\"" + file("fmvss_139_high_speed").string() + "\"]\n[time]\nsteady = true\n";
    const Histories shipped = run(written.add("shipped.toml", include));
    const Histories fine = run(written.add("fine.toml", include + R"([mesh]
crown_cells = 56
shoulder_cells = 20
sidewall_cells = 16
[[mesh.layer]]
name = "tread"
zones = ["crown", "shoulders"]
thickness = "8 mm"
cells = 24
material = "tread rubber"
[[mesh.layer]]
name = "belt"
zones = ["crown", "shoulders"]
thickness = "2 mm"
cells = 10
material = "below"
[[mesh.layer]]
name = "sidewall"
zones = ["sidewalls"]
thickness = "7 mm"
cells = 34
material = "tread rubber"
[[mesh.layer]]
name = "carcass"
thickness = "1.2 mm"
cells = 8
material = "below"
[[mesh.layer]]
name = "liner"
thickness = "0.8 mm"
cells = 6
material = "below"
)"));
    ASSERT_EQ(fine.all.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        RecordProperty("kelvin_" + std::to_string(i), std::to_string(fine.hottest(i) - shipped.hottest(i)));
        EXPECT_LT(std::abs(fine.hottest(i) - shipped.hottest(i)), 0.5) << fine.hottest(i) << ", " << shipped.hottest(i);
    }
}

// The study draws what the case says is uncertain: mean and deviation of 400 samples lie within 4 deviations of their own
// of the case's value and standard deviation, 4/sqrt(400) of it and 4/sqrt(800) of it.
TEST(DurabilityStudy, DrawsWhatTheCaseSaysIsUncertain) {
    const StudyReading reading = read_study(source_folder() / "cases/studies/fmvss_139_hot_spot.toml");
    ASSERT_TRUE(reading.study.has_value());
    const Study& study = *reading.study;
    ASSERT_EQ(study.samples, 400U);
    const std::optional<HotSpotCase> asked = HotSpotCase::read(file("fmvss_139_high_speed"));
    ASSERT_TRUE(asked.has_value());
    struct Known {
        std::string key;
        double value;
        double deviation;
    };
    std::vector<Known> known;
    for (const solver::FreeParameter& number : asked->known) {
        known.push_back({"effects." + number.name, number.prior, number.standard_deviation});
    }
    for (const UncertainKey& key : asked->uncertain) {
        if (key.alternative.empty()) {  // the study draws none
            known.push_back({key.path.text(), key.number, key.standard_deviation});
        }
    }
    ASSERT_EQ(study.inputs.size(), known.size());
    for (const Known& one : known) {
        const auto input = std::ranges::find_if(study.inputs, [&](const auto& i) { return i.key.text == one.key; });
        ASSERT_NE(input, study.inputs.end()) << one.key;
        double sum = 0.0;
        double squares = 0.0;
        for (const StudyValue& value : input->values) {
            sum += value.number - one.value;
            squares += (value.number - one.value) * (value.number - one.value);
        }
        EXPECT_LT(std::abs(sum / 400.0), 4.0 / 20.0 * one.deviation) << one.key;
        EXPECT_NEAR(std::sqrt(squares / 400.0), one.deviation, 4.0 / std::sqrt(800.0) * one.deviation) << one.key;
    }
}

// Run 101 of the study: after two hours in the steady state the speed falls to zero within no time, and steps shrink from half
// an hour to a fraction of a second. What the long step left at the surfaces must not come back there as kelvin.
TEST(DurabilityStudy, ShortStepsFollowLongOnes) {
    const Written written;
    const Reading reading = read_case(written.add("run_101.toml", fmt::format(R"(include = ["{}"]
[effects.strain_energy_loss]
tan_delta_a = 2.67153959e15
belt_edge_gain = 1.11238517
[effects.air_convection]
lambda_h = 0.859508588
[effects.sidewall_convection]
disk_scale = 0.65571823
[effects.resolved_contact]
scale = 0.941584836
[effects.layer_conductivity]
scale = 0.935282777
[effects.load_input_gain]
gain = 1.01970576
[drive]
inflation_pressure = "200.860525 kPa"
air_temperature = "36.1321294 degC"
road_temperature = "42.088251 degC"
)",
                                                                              file("fmvss_139_high_speed").string())));
    ASSERT_TRUE(reading.problem.has_value());
    const solver::MarchReport report = solver::run(*reading.problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_LT(report.rejected, report.steps);
    EXPECT_LT(report.energy_closure, 1e-12);
}

// A softer tire loses more: pressure^-0.45 alone is 24 % from 120 to 220 kPa and 19 % from there to 350 kPa, and a rise of 60 K above
// the room that follows half of that is worth more than 5 K.
TEST(DurabilityPressure, HotSpotFallsWithThePressure) {
    const Written written;
    double last = 1e3;
    for (const char* pressure : {"120 kPa", "220 kPa", "350 kPa"}) {
        const Histories histories =
            run(written.add("pressure.toml", "include = [\"" + file("un_r30_load_speed").string() +
                                                 "\"]\n[drive]\ninflation_pressure = \"" + pressure + "\"\n"));
        ASSERT_EQ(histories.all.size(), 2U);
        EXPECT_LT(histories.hottest(1), last - 5.0) << pressure;
        last = histories.hottest(1);
    }
}

// Broken off at 190 km/h and run on by 10 km/h every 10 min, the belt edge passes 84 degC at 200 km/h, when the whole test does.
TEST(DurabilityFurther, StepSpeedTestGoesOnToWhereTheBeltEdgePasses) {
    const Written written;
    const std::filesystem::path path =
        written.add("short.toml", "include = [\"" + file("sae_j1561_step_speed").string() + R"("]
[[drive.schedule]]
columns = ["time [min]", "speed [km/h]"]
rows = [[0, 170], [10, 170], [10, 180], [20, 180], [20, 190], [30, 190]]
[time]
end = "30 min"
)");
    const HotSpotCase asked = *HotSpotCase::read(path);
    const solver::Problem problem = *read_case(path).problem;
    const ContinuedSchedule further =
        continue_schedule(asked, problem.settings,
                          solver::schedule_steps(problem.input_signals, problem.settings.start, problem.settings.end));
    ASSERT_TRUE(further.problem.has_value()) << further.refusal;
    solver::HotSpotHistory history(further.problem->mesh, asked.critical[0]);
    const solver::MarchReport report = solver::run(*further.problem, [&](const solver::Snapshot& now) {
        history.take(now);
        return now.time < 4000.0;
    });
    const auto passing = [](const solver::HotSpotHistory& spot) {
        return solver::passing_time(spot.time(), spot.temperature(), zero + 84.0);
    };
    const double passed = passing(history);
    EXPECT_NEAR(passed, passing(run(file("sae_j1561_step_speed")).all[0]), 0.15 * minute);
    EXPECT_NEAR(further.problem->input_signals.at(passed, solver::JumpSide::before).speed * 3.6, 200.0, 1e-6);
}

}  // namespace tiretherm::input
