// SPDX-License-Identifier: BSD-3-Clause
// The two-node cases of the library give the temperatures that their headers state, to 0.1 K.

#include <array>
#include <vector>

#include "validation/library.hpp"

// What the headers of the two-node cases promise, from this program itself: a change of these numbers must be meant.
// They are printed to 0.1 K.
namespace tiretherm::validation {

namespace {

constexpr const char* bulk_channel = "bulk_temperature";
constexpr const char* surface = "surface_temperature";
constexpr double zero = 273.15;
constexpr double rounding = 0.06;

/// The channel in degC at each of these times.
void expect(const Experiment& run, const char* channel, const std::vector<double>& times,
            const std::vector<double>& degC) {
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_NEAR(run.at(channel, times[i]) - zero, degC[i], rounding) << channel << " at " << times[i] << " s";
    }
}

}  // namespace

TEST(TwoNodeCases, FlatTrac) {
    const Experiment standard("flat_trac/standard_two_node");
    expect(standard, bulk_channel, {90.0, 180.0, 270.0}, {49.6, 55.8, 54.6});
    expect(standard, surface, {90.0, 180.0, 270.0}, {35.7, 36.6, 35.4});
    const Experiment falling("flat_trac/ten_cycles_falling_two_node");
    expect(falling, bulk_channel, {300.0, 600.0, 900.0}, {72.1, 68.2, 56.9});
    expect(falling, surface, {300.0, 600.0, 900.0}, {42.5, 40.9, 36.7});
    const Experiment rising("flat_trac/ten_cycles_rising_two_node");
    expect(rising, bulk_channel, {300.0, 600.0, 900.0}, {41.5, 61.1, 77.2});
    expect(rising, surface, {300.0, 600.0, 900.0}, {31.5, 38.9, 43.8});
    expect(Experiment("flat_trac/warm_up_then_lateral_two_node"), bulk_channel, {300.0}, {72.5});
    const Experiment second("flat_trac/second_test_two_node");
    expect(second, bulk_channel, {1200.0, 2400.0, 3600.0}, {63.8, 80.6, 93.5});
    expect(second, surface, {1200.0, 2400.0, 3600.0}, {38.3, 43.6, 46.6});
}

// The schedules of VI.2, in seconds as printed and in minutes as guessed: the last load's end.
TEST(TwoNodeCases, FlatTracSchedules) {
    for (const auto& [name, degC] :
         {std::pair("load_steps_minutes", 75.4), std::pair("load_steps_seconds", 32.9),
          std::pair("speed_steps_minutes", 73.7), std::pair("speed_steps_seconds", 32.4),
          std::pair("speed_and_load_steps_minutes", 90.7), std::pair("speed_and_load_steps_seconds", 39.1)}) {
        const Experiment run("flat_trac/" + std::string(name) + "_two_node");
        EXPECT_NEAR(run.highest_after(bulk_channel, 0.0) - zero, degC, rounding) << name;
    }
}

TEST(TwoNodeCases, OvalTrackInTheMeanOfTheLastLap) {
    struct Row {
        const char* name;
        double lap;  ///< s
        std::array<double, 3> degC;
    };
    constexpr std::array wheels{"FR", "RL", "RR"};
    for (const Row& row : {Row{"unladen_140", 102.9, {81.5, 69.5, 71.2}}, Row{"laden_140", 102.9, {84.2, 84.9, 87.9}},
                           Row{"laden_80", 180.0, {68.3, 69.1, 71.3}}}) {
        for (std::size_t w = 0; w < wheels.size(); ++w) {
            const Experiment run("oval_track/" + std::string(row.name) + "_" + wheels[w] + "_two_node");
            EXPECT_NEAR(run.mean_of_last(bulk_channel, row.lap) - zero, row.degC[w], rounding)
                << row.name << " " << wheels[w];
        }
    }
}

TEST(TwoNodeCases, Handling) {
    const Experiment stop("handling/panic_stop_two_node");
    expect(stop, bulk_channel, {1205.0, 1208.0}, {76.0, 75.8});
    expect(stop, surface, {1205.0, 1208.0}, {42.8, 49.9});
    const Experiment sweep("handling/sine_sweep_two_node");
    expect(sweep, bulk_channel, {1200.0, 1260.0}, {68.9, 69.2});
    expect(sweep, surface, {1200.0, 1260.0}, {41.0, 43.2});
    const Experiment pad("handling/steering_pad_two_node");
    expect(pad, bulk_channel, {1200.0}, {68.9});
    EXPECT_NEAR(pad.highest_after(bulk_channel, 1200.0) - zero, 71.7, rounding);
    EXPECT_NEAR(pad.highest_after(surface, 1200.0) - zero, 62.1, rounding);
}

// The ends of the first and of the last step.
TEST(TwoNodeCases, Drum) {
    expect(Experiment("drum/205_55_R16_run_flat_two_node"), bulk_channel, {1800.0, 16200.0}, {53.4, 80.9});
    for (const char* name : {"drum/225_50_R17_spec_1_two_node", "drum/225_50_R17_spec_2_two_node"}) {
        expect(Experiment(name), bulk_channel, {1800.0, 21600.0}, {47.0, 85.4});
    }
    expect(Experiment("drum/235_45_R17_two_node"), bulk_channel, {1800.0, 21600.0}, {47.2, 85.6});
    expect(Experiment("drum/245_40_R18_two_node"), bulk_channel, {1800.0, 21600.0}, {46.6, 84.3});
    expect(Experiment("drum/265_65_R16C_two_node"), bulk_channel, {1800.0, 28800.0}, {39.5, 89.0});
}

}  // namespace tiretherm::validation
