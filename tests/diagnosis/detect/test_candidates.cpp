// SPDX-License-Identifier: BSD-3-Clause
// Which candidates an experiment has: strips that a camera sees, instruments as groups, late inputs, and what is said of
// those that were listed and not tried.

#include "diagnosis/detect/candidates.hpp"

#include "tests/diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis::sample {
namespace {

std::vector<std::string> names(const input::Experiment& experiment, const std::vector<std::string>& chosen) {
    std::vector<std::string> all;
    for (const Candidate& candidate : candidates_of(experiment, chosen)) {
        const std::string name = name_of(candidate, experiment);
        if (all.empty() || all.back() != name) {
            all.push_back(name);
        }
    }
    return all;
}

TEST(Candidates, ACameraOnAStripHasAnEmissivity) {
    const input::Experiment experiment = read_bench(practice() / "section_bench.toml");
    EXPECT_EQ(names(experiment, {"camera_emissivity"}),
              std::vector<std::string>{"camera_emissivity of surface_temperature"});
    EXPECT_TRUE(untried(experiment).empty());
}

TEST(Candidates, SayWhatWasListedAndNotTried) {
    input::Experiment experiment = practice_bench();
    experiment.candidates = {"sensor_lag", "tread_wear", "pressure_reading_speed"};
    EXPECT_EQ(untried(experiment),
              (Remarks{remark::not_tried("tread_wear", {remark::needs_grid()}),
                       remark::not_tried("pressure_reading_speed", {remark::no_sensor_of_its_kind()})}));
}

// The logs of the bench have speed, load and slip angle that change; camber does not.
TEST(Candidates, OfLateInputsAreThoseThatAreLoggedAndChange) {
    const std::vector<std::string> late = names(practice_bench(), {"input_delay"});
    EXPECT_NE(std::ranges::find(late, "input_delay.vertical_load"), late.end());
    EXPECT_NE(std::ranges::find(late, "input_delay.slip_angle"), late.end());
    EXPECT_EQ(std::ranges::find(late, "input_delay.laser_power"), late.end());
}

// What one logger writes is late together: slip and force of handling, and all that is logged and changes. One number moves them, so that
// the case has the same delay for each; beside a delay of one of its inputs of its own there is no place for it.
TEST(Candidates, InputsOfOneLoggerAreLateTogether) {
    const input::Experiment experiment = practice_bench();
    const std::vector<Candidate> late = candidates_of(experiment, {"input_delay"});
    const auto common = std::ranges::find_if(late, is_common_delay);
    ASSERT_NE(common, late.end());
    const Candidate& all = late.back();
    ASSERT_TRUE(is_common_delay(all));
    EXPECT_TRUE(name_of(all, experiment).starts_with("input_delay of speed, vertical_load, "))
        << name_of(all, experiment);
    const physics::ActiveEffect active = active_at(all, experiment.runs.front().problem.mesh, 1.5);
    EXPECT_EQ(std::ranges::count(active.parameters, 1.5), static_cast<long>(all.companions.size() + 1));
    EXPECT_FALSE(can_stand_beside(all, late.front()));
    EXPECT_FALSE(can_stand_beside(late.front(), all));
    EXPECT_FALSE(can_stand_beside(*common, all));
}

TEST(Candidates, AnInstrumentComesBeforeItsSensors) {
    input::Experiment experiment = practice_bench();
    experiment.instruments = {{.name = "logger", .channels = {0, 1}}};
    EXPECT_EQ(names(experiment, {"clock_delay"}),
              (std::vector<std::string>{"clock_delay of surface_temperature and bulk_temperature",
                                        "clock_delay of surface_temperature", "clock_delay of bulk_temperature"}));
    const std::vector<Candidate> candidates = candidates_of(experiment, {"clock_delay"});
    EXPECT_EQ(candidates.front().channels, (std::vector<int>{0, 1}));
}

// A case has one table for each effect: it can hold both where their places or inputs differ.
TEST(Candidates, OfOneEffectStandBesideEachOtherOnlyAtPlacesOfTheirOwn) {
    input::Experiment experiment = practice_bench();
    experiment.instruments = {{.name = "logger", .channels = {0, 1}}};
    const std::vector<Candidate> clocks = candidates_of(experiment, {"clock_delay"});  // both, the first, the second
    ASSERT_EQ(clocks.size(), 3U);
    EXPECT_FALSE(can_stand_beside(clocks[0], clocks[1]));
    EXPECT_TRUE(can_stand_beside(clocks[1], clocks[2]));
    const std::vector<Candidate> late = candidates_of(experiment, {"input_delay"});
    ASSERT_GT(late.size(), 1U);
    EXPECT_TRUE(can_stand_beside(late[0], late[1]));
    EXPECT_FALSE(can_stand_beside(late[0], late[0]));
    EXPECT_TRUE(can_stand_beside(late[0], clocks[0]));
    // Gas and rim of one volume of gas are no two volumes.
    const std::vector<Candidate> gas = candidates_of(experiment, {"inner_gas"});
    ASSERT_GT(gas.size(), 1U);
    EXPECT_FALSE(can_stand_beside(gas.front(), gas.back()));
}

TEST(Candidates, ADrumThatTheTireHeatsIsOneWhereItIsListedOrTheCaseRunsOnADrum) {
    input::Experiment experiment = practice_bench();
    const auto tries = [&](const std::vector<std::string>& chosen) {
        const std::vector<std::string> all = names(experiment, chosen);
        return std::ranges::count(all, "drum_heating") > 0;
    };
    EXPECT_FALSE(tries({}));
    EXPECT_TRUE(tries({"drum_heating"}));
    for (input::MeasuredRun& run : experiment.runs) {
        const physics::Effect& curvature = *physics::find_effect("drum_curvature");
        solver::switch_on(run.problem, physics::activate(curvature, run.problem.mesh), 0.0);
    }
    EXPECT_TRUE(tries({}));
    // It starts with the road, not with the air.
    const std::vector<Candidate> drum = candidates_of(experiment, {"drum_heating"});
    const solver::Problem heated = with(experiment, drum, {1.0}).runs.front().problem;
    const physics::Inputs first = heated.input_signals.at(heated.settings.start, solver::JumpSide::after);
    ASSERT_NE(first.road_temperature, first.air_temperature);
    EXPECT_EQ(heated.initial[static_cast<std::size_t>(heated.mesh.find_lumped_node("drum"))], first.road_temperature);
}

// A loss from a drum of 2 m: curvature 1/m is that of its law.
TEST(Candidates, TheDrumOfTheLawIsWhereItsCurvatureIsAbsent) {
    input::Experiment experiment = practice_bench();
    EXPECT_EQ(candidates_of(experiment, {"drum_curvature"}).front().absent, 0.0);
    for (input::MeasuredRun& run : experiment.runs) {
        run.problem.tire.loss_drum_diameter = 2.0;
    }
    EXPECT_EQ(candidates_of(experiment, {"drum_curvature"}).front().absent, 1.0);
}

// The wave's speed is tried from 80 to 245 km/h and moves as far as the next values: below 80 km/h no tire has a wave, and the first
// distance of 15 km/h would allow 65.
TEST(Candidates, AValueThatIsHeldMovesWithinWhatIsPlausible) {
    double lowest = 1e9;
    double highest = 0.0;
    for (const Candidate& one : candidates_of(practice_bench(), {"standing_wave"})) {
        ASSERT_EQ(one.held.size(), 1U);
        EXPECT_LT(one.held.front().low, one.held.front().value + 1e-9);
        lowest = std::min(lowest, one.held.front().low);
        highest = std::max(highest, one.held.front().high);
    }
    EXPECT_EQ(lowest, 80.0);
    EXPECT_EQ(highest, 275.0);  // 245 and the last distance
}

}  // namespace
}  // namespace tiretherm::diagnosis::sample
