// SPDX-License-Identifier: BSD-3-Clause
// Qualitative findings of the thesis's measurements (orders and signs) hold in the two-node model and in the section.

#include "validation/library.hpp"

// What the thesis found, as far as both of its own model and the section show it. Orders and signs only; how far the
// numbers are from the measured ones is reported by `tiretherm validate`.
namespace tiretherm::validation {

namespace {

constexpr const char* bulk = "bulk_temperature";
constexpr const char* stiffness = "cornering_stiffness";

class Finding : public testing::TestWithParam<const char*> {
protected:
    static Experiment run(const std::string& name) { return Experiment(name + "_" + GetParam()); }
};

/// Inside less outside shoulder in the mean of the last lap of 103 s at 140 km/h.
double inside_less_outside(const Experiment& run) {
    return run.mean_of_last("inside_shoulder_bulk_temperature", 102.9) -
           run.mean_of_last("outside_shoulder_bulk_temperature", 102.9);
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Both, Finding, testing::Values("two_node", "section"),
                         [](const auto& model) { return model.param; });

// M13: 3 s of friction heat a surface that is 10 mm away from the probes. 1 K is what a reader of the figure would see.
TEST_P(Finding, PanicStopLeavesTheBulk) {
    const Experiment stop = run("handling/panic_stop");
    EXPECT_NEAR(stop.at(bulk, 1208.0), stop.at(bulk, 1205.0), 1.0);
    EXPECT_GT(stop.at("surface_temperature", 1208.0), stop.at("surface_temperature", 1205.0) + 5.0);
}

// M12 against M11: 30 s up to 6 deg of slip lift the bulk by more than a sweep of 60 s to 0.4 g does. (The
// measured 15 K cannot be judged: how long the ramp takes is not printed.)
TEST_P(Finding, RampSteerLiftsTheBulkMoreThanASweep) {
    const Experiment ramp = run("handling/steering_pad");
    const Experiment sweep = run("handling/sine_sweep");
    const double rise = ramp.highest_after(bulk, 1200.0) - ramp.at(bulk, 1200.0);
    EXPECT_GT(rise, 1.0);
    EXPECT_GT(rise, 2.0 * std::abs(sweep.at(bulk, 1260.0) - sweep.at(bulk, 1200.0)));
}

// M4, M5: the bulk falls as soon as the load has become small, and follows it where each load has 5 min.
TEST_P(Finding, BulkFollowsTheLoad) {
    const Experiment standard = run("flat_trac/standard");
    EXPECT_LT(standard.at(bulk, 270.0), standard.at(bulk, 180.0));
    const Experiment falling = run("flat_trac/ten_cycles_falling");
    EXPECT_GT(falling.at(bulk, 300.0), falling.at(bulk, 600.0));
    EXPECT_GT(falling.at(bulk, 600.0), falling.at(bulk, 900.0));
    const Experiment rising = run("flat_trac/ten_cycles_rising");
    EXPECT_LT(rising.at(bulk, 300.0), rising.at(bulk, 600.0));
    EXPECT_LT(rising.at(bulk, 600.0), rising.at(bulk, 900.0));
}

// M7: saturation rises with load and speed.
TEST_P(Finding, BulkSaturatesHigherWithLoadAndSpeed) {
    const Experiment warm_ups = run("flat_trac/second_test");
    EXPECT_LT(warm_ups.at(bulk, 1200.0), warm_ups.at(bulk, 2400.0));
    EXPECT_LT(warm_ups.at(bulk, 2400.0), warm_ups.at(bulk, 3600.0));
}

// M14: the same load, 4500 N, after the procedure that leaves the bulk colder and after the one that leaves it hotter.
TEST_P(Finding, ColderProcedureGivesTheStifferTire) {
    const Experiment cold = run("flat_trac/standard");
    const Experiment hot = run("flat_trac/ten_cycles_falling");
    EXPECT_LT(cold.at(bulk, 178.0), hot.at(bulk, 598.0) - 5.0);
    EXPECT_GT(cold.at(stiffness, 178.0), 1.02 * hot.at(stiffness, 598.0));
}

// M8, M9: under the negative camber of the rear axle the inside shoulder is hotter, and more so with the larger camber
// of the laden car, which is hotter throughout.
TEST(SectionFinding, InsideShoulderIsHotterUnderNegativeCamber) {
    const Experiment unladen("oval_track/unladen_140_RR_section");
    const Experiment laden("oval_track/laden_140_RR_section");
    EXPECT_GT(inside_less_outside(unladen), 5.0);
    EXPECT_GT(inside_less_outside(laden), inside_less_outside(unladen));
    EXPECT_GT(laden.mean_of_last(bulk, 102.9), unladen.mean_of_last(bulk, 102.9));
}

// M10: colder at 80 km/h, and the shoulders closer together.
TEST(SectionFinding, SlowLapsAreColderAndMoreEven) {
    const Experiment fast("oval_track/laden_140_RR_section");
    const Experiment slow("oval_track/laden_80_RR_section");
    EXPECT_LT(slow.mean_of_last(bulk, 102.9), fast.mean_of_last(bulk, 102.9));
    EXPECT_LT(inside_less_outside(slow), inside_less_outside(fast));
}

}  // namespace tiretherm::validation
