// SPDX-License-Identifier: BSD-3-Clause
// Every experiment of the library closes its energy balance and ends where an independent integration of its inputs ends.

#include <vector>

#include "support/section_thesis.hpp"
#include "validation/library.hpp"
#include "validation/section_ends.hpp"

// Each experiment of the library as a user runs it. The heat stored is that of the effects, to round-off. On the thesis's
// tire it ends where the model written a second time ends, two nodes or the section, with nothing of the program but the
// case's inputs against time. On other tires and with another contact it ends where it did.
namespace tiretherm::validation {

namespace {

namespace fs = std::filesystem;

/// Every case of the experiments, on whatever mesh.
std::vector<std::string> experiments() {
    std::vector<std::string> found;
    for (const char* folder : {"flat_trac", "drum", "oval_track", "handling", "section"}) {
        for (const auto& entry : fs::directory_iterator(library() / folder)) {
            const std::string stem = entry.path().stem().string();
            // What a diagnosis is given is no experiment of its own, nor is what lies over cases.
            const bool lies_over_cases = stem == "all_heat_paths" || stem == "literature_conductivities";
            if (entry.path().extension() == ".toml" && !stem.ends_with("common") && !stem.starts_with("diagnose") &&
                !lies_over_cases) {
                found.push_back(std::string(folder) + "/" + stem);
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == '-'; }, '_');
    return name;
}

/// The thesis's model with the inputs of a case, in the middle of a step.
support::TwoNodeThesis inputs_of(const solver::Problem& problem, double from, double to) {
    const physics::Inputs in = problem.input_signals.at(0.5 * (from + to), solver::JumpSide::after);
    support::TwoNodeThesis thesis;
    thesis.V = in.speed;
    thesis.Fz = in.vertical_load;
    thesis.alpha = in.slip_angle;
    thesis.kappa = in.slip_ratio;
    thesis.Fx = in.longitudinal_force;
    thesis.Fy = in.lateral_force;
    thesis.T_air = in.air_temperature;
    thesis.T_track = in.road_temperature;
    return thesis;
}

constexpr double step = support::SectionThesis::seconds;

/// Equations (31) from the case's first temperatures to its end. @returns surface and bulk, K
std::pair<double, double> two_nodes_after(const solver::Problem& problem) {
    double surface = problem.initial.at(0);
    double bulk = problem.initial.at(1);
    for (double t = problem.settings.start; t < problem.settings.end - 0.5 * step; t += step) {
        const support::TwoNodeThesis::Flow flow = inputs_of(problem, t, t + step).flow(surface, bulk);
        surface += step * flow.surface / support::TwoNodeThesis::capacity_surface();
        bulk += step * flow.bulk / support::TwoNodeThesis::capacity_bulk();
    }
    return {surface, bulk};
}

/// The section from the case's first temperature to its end; gas and rim begin at that of the air.
support::SectionThesis section_after(const solver::Problem& problem) {
    using Kind = support::SectionThesis::Kind;
    const bool of_cords = problem.name.ends_with("_cords");
    support::SectionThesis thesis(of_cords ? Kind::section_of_cords : Kind::section, problem.initial.at(0));
    thesis.gas = thesis.rim = inputs_of(problem, problem.settings.start, problem.settings.start + step).T_air;
    for (double t = problem.settings.start; t < problem.settings.end - 0.5 * step; t += step) {
        const double camber = problem.input_signals.at(t + 0.5 * step, solver::JumpSide::after).camber;
        thesis.step(inputs_of(problem, t, t + step), camber);
    }
    return thesis;
}

class ShippedExperiment : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(ShippedExperiment, ClosesItsEnergy) {
    const Experiment run(GetParam());
    EXPECT_LE(run.report().energy_closure, 1e-10);
    EXPECT_GT(run.report().steps, 0);
}

// Explicit steps of 0.1 s on cells of 0.2 and 0.4 mm in 78 columns: half the cells' size, or half the columns' width,
// changes a probe by less than 0.03 K and the mean over the liner by 0.05 K.
// The program's columns are coarser, which moves the liner's mean by 0.07 K, and its stepper is good to 0.01 K a step.
TEST_P(ShippedExperiment, EndsWhereAnIndependentModelDoes) {
    const Experiment run(GetParam());
    const auto end = std::find_if(section_ends.begin(), section_ends.end(),
                                  [](const SectionEnd& one) { return one.name == GetParam(); });
    if (end != section_ends.end()) {
        constexpr double rounding = 0.06;  // of 0.1 K, and the stepper's tolerance
        EXPECT_NEAR(run.at("bulk_temperature", 1e9) - 273.15, end->final_bulk, rounding);
        EXPECT_NEAR(run.at("inner_liner_temperature", 1e9) - 273.15, end->final_liner, rounding);
        return;
    }
    if (GetParam().starts_with("drum/")) {
        ASSERT_TRUE(GetParam().ends_with("_two_node")) << "add its numbers to section_ends.hpp";
        return;  // in test_two_node_cases.cpp
    }
    constexpr double tolerance = 0.1;
    if (GetParam().ends_with("_two_node")) {
        const auto [surface, bulk] = two_nodes_after(run.problem());
        EXPECT_NEAR(run.at("surface_temperature", 1e9), surface, tolerance);
        EXPECT_NEAR(run.at("bulk_temperature", 1e9), bulk, tolerance);
        return;
    }
    const support::SectionThesis thesis = section_after(run.problem());
    EXPECT_NEAR(run.at("surface_temperature", 1e9), thesis.surface(), tolerance);
    EXPECT_NEAR(run.at("outside_shoulder_bulk_temperature", 1e9), thesis.outside_probe(), tolerance);
    EXPECT_NEAR(run.at("inside_shoulder_bulk_temperature", 1e9), thesis.inside_probe(), tolerance);
    EXPECT_NEAR(run.at("bulk_temperature", 1e9), 0.5 * (thesis.outside_probe() + thesis.inside_probe()), tolerance);
    EXPECT_NEAR(run.at("inner_liner_temperature", 1e9), thesis.liner(), tolerance);
    EXPECT_NEAR(run.at("gas_temperature", 1e9), thesis.gas, tolerance);
}
INSTANTIATE_TEST_SUITE_P(All, ShippedExperiment, testing::ValuesIn(experiments()), test_name);

}  // namespace tiretherm::validation
