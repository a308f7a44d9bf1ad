// SPDX-License-Identifier: BSD-3-Clause
// Every experiment of the library closes its energy balance and ends where an independent integration of its inputs ends.

#include <vector>

#include "support/section_thesis.hpp"
#include "validation/library.hpp"

// Each experiment of the library as a user runs it. The heat stored is that of the effects, to round-off. It ends
// where the model written a second time ends, two nodes or the section, with nothing of the program but the
// case's inputs against time.
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
support::TwoNodeThesis inputs_of(const solver::Problem& problem, const support::ThesisTire& tire, double from,
                                 double to) {
    const physics::Inputs in = problem.input_signals.at(0.5 * (from + to), solver::JumpSide::after);
    support::TwoNodeThesis thesis{.tire = tire};
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

/// A tire beside the thesis's, written a second time.
struct DrumTire {
    std::string_view name;
    support::ThesisTire tire;
};

using Kind = support::SectionThesis::Kind;

/// The tires of cases/tires/drum_*.toml, which scale the thesis's by size and stiffness.
const std::array drum_tires{
    DrumTire{"205_55_R16_run_flat", {0.205, 0.11275, 0.3183, 0.012, 0.015, 0.154, 0.334e-3, 2.333e-6, 4.01e-6, 0.3351}},
    DrumTire{"235_45_R17", {0.235, 0.10575, 0.3240, 0.012, 0.009, 0.157, 0.343e-3, 2.333e-6, 4.12e-6, 0.3411}},
    DrumTire{"245_40_R18", {0.245, 0.098, 0.3290, 0.012, 0.009, 0.159, 0.331e-3, 2.333e-6, 3.98e-6, 0.3464}},
    DrumTire{"265_65_R16C", {0.265, 0.17225, 0.3778, 0.015, 0.011, 0.183, 0.166e-3, 1.141e-6, 1.99e-6, 0.3978}},
};

support::ThesisTire tire_of(std::string_view name) {
    const auto other = std::find_if(drum_tires.begin(), drum_tires.end(),
                                    [&](const DrumTire& one) { return name.find(one.name) != std::string_view::npos; });
    return other != drum_tires.end() ? other->tire : support::ThesisTire{};
}

Kind kind_of(std::string_view name) {
    for (const auto& [end, kind] :
         {std::pair("_cords", Kind::section_of_cords), std::pair("_disk", Kind::disks),
          std::pair("_resolved_contact", Kind::rolling_contact), std::pair("_all_heat_paths", Kind::all_heat_paths)}) {
        if (name.ends_with(end)) {
            return kind;
        }
    }
    return Kind::section;
}

constexpr double step = 0.1;  // s, of two nodes

/// Equations (31) from the case's first temperatures to its end. @returns surface and bulk, K
std::pair<double, double> two_nodes_after(const std::string& name, const solver::Problem& problem) {
    const support::ThesisTire tire = tire_of(name);
    double surface = problem.initial.at(0);
    double bulk = problem.initial.at(1);
    for (double t = problem.settings.start; t < problem.settings.end - 0.5 * step; t += step) {
        const support::TwoNodeThesis thesis = inputs_of(problem, tire, t, t + step);
        const support::TwoNodeThesis::Flow flow = thesis.flow(surface, bulk);
        surface += step * flow.surface / thesis.capacity_surface();
        bulk += step * flow.bulk / thesis.capacity_bulk();
    }
    return {surface, bulk};
}

/// The section from the case's first temperature to its end; gas and rim begin at that of the air. Six hours on a drum go
/// in cells of twice the size.
support::SectionThesis section_after(const std::string& name, const solver::Problem& problem) {
    const support::ThesisTire tire = tire_of(name);
    support::SectionThesis thesis(kind_of(name), problem.initial.at(0), tire, name.starts_with("drum/") ? 2 : 1);
    const double start = problem.settings.start;
    thesis.gas = thesis.rim = inputs_of(problem, tire, start, start + thesis.seconds).T_air;
    for (double t = start; t < problem.settings.end - 0.5 * thesis.seconds; t += thesis.seconds) {
        const double camber = problem.input_signals.at(t + 0.5 * thesis.seconds, solver::JumpSide::after).camber;
        thesis.step(inputs_of(problem, tire, t, t + thesis.seconds), camber);
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
// The program's columns are coarser, which moves the liner's mean by 0.07 K, and its stepper is good to 0.01 K a step. Where
// a thick sidewall makes a liner of 81 and 97 degC, 16 and 30 columns of each sidewall instead of 8 lower it by 0.14 and
// 0.20 K, and the coarse cells of the second model by 0.03 K.
TEST_P(ShippedExperiment, EndsWhereAnIndependentModelDoes) {
    const Experiment run(GetParam());
    constexpr double tolerance = 0.1;
    if (run.problem().mesh.n_nodes == 2) {
        const auto [surface, bulk] = two_nodes_after(GetParam(), run.problem());
        EXPECT_NEAR(run.at("surface_temperature", 1e9), surface, tolerance);
        EXPECT_NEAR(run.at("bulk_temperature", 1e9), bulk, tolerance);
        return;
    }
    const support::SectionThesis thesis = section_after(GetParam(), run.problem());
    EXPECT_NEAR(run.at("surface_temperature", 1e9), thesis.surface(), tolerance);
    EXPECT_NEAR(run.at("outside_shoulder_bulk_temperature", 1e9), thesis.outside_probe(), tolerance);
    EXPECT_NEAR(run.at("inside_shoulder_bulk_temperature", 1e9), thesis.inside_probe(), tolerance);
    EXPECT_NEAR(run.at("bulk_temperature", 1e9), 0.5 * (thesis.outside_probe() + thesis.inside_probe()), tolerance);
    const double liner_tolerance = GetParam().starts_with("drum/") ? 0.23 : tolerance;
    EXPECT_NEAR(run.at("inner_liner_temperature", 1e9), thesis.liner(), liner_tolerance);
    EXPECT_NEAR(run.at("gas_temperature", 1e9), thesis.gas, tolerance);
}
INSTANTIATE_TEST_SUITE_P(All, ShippedExperiment, testing::ValuesIn(experiments()), test_name);

}  // namespace tiretherm::validation
