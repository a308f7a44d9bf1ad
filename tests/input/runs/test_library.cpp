// SPDX-License-Identifier: BSD-3-Clause
// Every case of the library is sound, and its numbers arrive in SI as computed by hand.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "solver/system.hpp"
#include "support/written.hpp"

// The library's cases in SI: the numbers that a user wrote must arrive.
namespace tiretherm::input {

namespace {

constexpr double ice_point = 273.15;
using std::numbers::pi;

solver::Problem read_library(std::string_view name) {
    Reading reading = read_case(source_folder() / "cases" / (std::string(name) + ".toml"));
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    solver::Problem problem = reading.problem ? std::move(*reading.problem) : solver::Problem{};
    EXPECT_EQ(problem.name, name);
    EXPECT_FALSE(problem.sources.empty());
    EXPECT_NE(problem.title, problem.name);
    return problem;
}

std::vector<std::string> effects(const solver::Problem& problem) {
    std::vector<std::string> ids;
    for (const physics::ActiveEffect& active : problem.effects) {
        ids.emplace_back(active.effect->id);
    }
    return ids;
}

std::vector<std::string> channels(const solver::Problem& problem) {
    std::vector<std::string> names;
    for (const solver::Channel& channel : problem.channels) {
        names.push_back(channel.name);
        EXPECT_FALSE(channel.meaning.empty()) << channel.name;
        double sum = 0.0;
        for (const double weight : channel.where.weights) {
            sum += weight;
        }
        EXPECT_NEAR(sum, 1.0, 1e-12) << channel.name;
    }
    return names;
}

/// The shares of an effect over its nodes, as the solver places it.
std::vector<double> placed_weights(const solver::Problem& problem, std::string_view id) {
    const solver::System system(problem);
    for (const physics::ActiveEffect& active : system.effects()) {
        if (active.effect->id == id) {
            return active.weights;
        }
    }
    return {};
}

/// A case as it is compared with what was measured.
Experiment read_measured(std::string_view name) {
    ExperimentReading reading = read_experiment(source_folder() / "cases" / (std::string(name) + ".toml"));
    EXPECT_TRUE(reading.experiment.has_value()) << (reading.errors.empty() ? "" : render(reading.errors.front()));
    EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.front();
    return reading.experiment ? std::move(*reading.experiment) : Experiment{};
}

std::vector<std::string> free_numbers(const Experiment& experiment) {
    std::vector<std::string> names;
    for (const solver::FreeParameter& number : experiment.parameters) {
        names.push_back(number.name);
    }
    return names;
}

const physics::ActiveEffect& effect(const solver::Problem& problem, std::string_view id) {
    const auto found = std::find_if(problem.effects.begin(), problem.effects.end(),
                                    [&](const physics::ActiveEffect& active) { return active.effect->id == id; });
    EXPECT_NE(found, problem.effects.end()) << id;
    return *found;
}

}  // namespace

// Whatever stands in the library can be run; files that only hold a common part say so by their name or folder.
TEST(Library, EveryCaseIsSound) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "cases")) {
        const std::filesystem::path& file = entry.path();
        const std::string stem = file.stem().string();
        const bool lies_over_cases = stem == "all_heat_paths" || stem == "literature_conductivities" ||
                                     stem == "as_printed" || stem == "manoeuvres";
        const bool part = stem.ends_with("common") || lies_over_cases || file.parent_path().filename() == "tires";
        const bool table = file.filename() == "validation.toml";
        const bool study = file.parent_path().filename() == "studies";
        if (file.extension() == ".toml" && !part && !table && !study) {
            const Reading reading = read_case(file);
            EXPECT_TRUE(reading.problem.has_value()) << render(reading);
            // The bench of a section logs camber, of which its model knows nothing; [vehicle] says what it computes, for each tire.
            const bool has_vehicle = file.parent_path().filename() == "car";
            const bool knows_all = file.stem() != "section_bench";
            if (!has_vehicle) {
                EXPECT_EQ(reading.warnings.size(), knows_all ? 0U : 1U) << render(reading);
            }
            ++count;
        }
    }
    EXPECT_GE(count, 9U);
}

// Thesis-notes section 2: S_tot = 2 pi 0.3308 0.225 = 0.46766 m2, m = 1100 S_tot 0.012 = 6.173 kg, 15 % of it outside.
TEST(Library, TwoNodeIsTheThesissTire) {
    const solver::Problem problem = read_library("two_node/4000N_100kmh");
    const double area = 2.0 * pi * 0.3308 * 0.225;
    EXPECT_NEAR(problem.tire.outer_area(), area, 1e-12);
    EXPECT_NEAR(problem.tire.band_mass(), 6.173, 0.0005);
    // Its members are by default the thesis's. 330.8 mm is one ulp from 0.3308.
    const physics::Tire thesis;
    EXPECT_DOUBLE_EQ(problem.tire.unloaded_radius, thesis.unloaded_radius);
    EXPECT_DOUBLE_EQ(problem.tire.area_ratio(), thesis.area_ratio());
    EXPECT_DOUBLE_EQ(physics::strain_power(problem.tire, 27.0, 4500.0), physics::strain_power(thesis, 27.0, 4500.0));
    EXPECT_DOUBLE_EQ(problem.tire.contact_area(4500.0), thesis.contact_area(4500.0));
    ASSERT_EQ(problem.mesh.n_cells, 2);
    EXPECT_NEAR(problem.mesh.volume[0] * 1100.0, 0.15 * 6.173, 1e-4);
    EXPECT_NEAR(problem.mesh.volume[1] * 1100.0, 0.85 * 6.173, 5e-4);
    EXPECT_NEAR(problem.mesh.links.at(0).length, 0.010, 1e-15);
    ASSERT_EQ(problem.link_laws.size(), 1U);
    EXPECT_NEAR(problem.link_laws[0].value(ice_point + 20.0), 0.29, 1e-12);
    EXPECT_NEAR(problem.link_laws[0].value(ice_point + 90.0), 0.29 + 70.0 * 0.00943, 1e-12);
    ASSERT_EQ(problem.materials.size(), 2U);
    EXPECT_DOUBLE_EQ(problem.materials[1].density, 1100.0);
    EXPECT_DOUBLE_EQ(problem.materials[1].heat_capacity.value(300.0), 1800.0);
    EXPECT_EQ(effects(problem), (std::vector<std::string>{"conduction", "strain_energy_loss", "sliding_friction",
                                                          "air_convection", "road_contact"}));
    EXPECT_EQ(channels(problem), (std::vector<std::string>{"surface_temperature", "bulk_temperature"}));
    EXPECT_EQ(problem.channels[1].where.nodes, std::vector<int>{1});
    EXPECT_EQ(problem.initial, (std::vector<double>{ice_point + 23.0, ice_point + 23.0}));
    EXPECT_DOUBLE_EQ(problem.settings.end, 3600.0);
    EXPECT_DOUBLE_EQ(problem.settings.output_interval, 10.0);
    EXPECT_DOUBLE_EQ(problem.symmetry, 1.0);
}

// 100 km/h = 27.778 m/s, 150 km/h = 41.667 m/s; the measured bulk of thesis III.2.5.
TEST(Library, TwoNodeCasesDifferInLoadSpeedAndMeasurement) {
    struct Row {
        std::string_view name;
        double load;
        double speed;
        double bulk;
    };
    for (const Row& row : {Row{"two_node/4000N_100kmh", 4000.0, 100.0 / 3.6, 50.0},
                           Row{"two_node/7000N_100kmh", 7000.0, 100.0 / 3.6, 70.0},
                           Row{"two_node/7500N_150kmh", 7500.0, 150.0 / 3.6, 80.0}}) {
        const solver::Problem problem = read_library(row.name);
        const physics::Inputs inputs = problem.input_signals.at(1800.0, solver::JumpSide::after);
        EXPECT_NEAR(inputs.speed, row.speed, 1e-13);
        EXPECT_DOUBLE_EQ(inputs.vertical_load, row.load);
        EXPECT_DOUBLE_EQ(inputs.air_temperature, ice_point + 23.0);
        EXPECT_DOUBLE_EQ(inputs.road_temperature, ice_point + 23.0);
        ASSERT_EQ(problem.measured.size(), 1U);
        EXPECT_EQ(problem.measured[0].channel, "bulk_temperature");
        EXPECT_DOUBLE_EQ(problem.measured[0].low, ice_point + row.bulk);
        EXPECT_DOUBLE_EQ(problem.measured[0].high, ice_point + row.bulk);
        EXPECT_DOUBLE_EQ(problem.measured[0].time, 3600.0);
    }
}

// The effect's nodes share the power on 1 cm2: the shares sum to 1 where the whole spot is meshed.
TEST(Library, LaserCasesAreAxisymmetricWithTwoLayers) {
    for (const auto& [name, power, low, high] :
         {std::tuple("laser/one_watt", 1.0, 40.0, 50.0), std::tuple("laser/three_watts", 3.0, 60.0, 80.0)}) {
        const solver::Problem problem = read_library(name);
        ASSERT_TRUE(problem.mesh.grid.has_value());
        EXPECT_EQ(problem.mesh.grid->metric, mesh::Metric::axisymmetric);
        EXPECT_NEAR(problem.mesh.grid->edge[0].back(), 0.060, 1e-15);
        EXPECT_NEAR(problem.mesh.grid->edge[2].back(), 0.012, 1e-15);
        EXPECT_EQ(problem.mesh.layers, (std::vector<std::string>{"tread", "bulk"}));
        EXPECT_NEAR(problem.mesh.total_volume(), pi * 0.06 * 0.06 * 0.012, 1e-12);
        const physics::Curve& K1 = problem.materials[0].along(mesh::Axis::through);
        const physics::Curve& K2 = problem.materials[1].along(mesh::Axis::meridian);
        EXPECT_NEAR(K1.value(ice_point + 20.0), 0.29, 1e-12);
        EXPECT_NEAR(K1.value(ice_point + 90.0), 0.95, 1e-12);
        EXPECT_NEAR(K2.value(ice_point + 20.0), 0.06, 1e-12);
        EXPECT_NEAR(K2.value(ice_point + 90.0), 0.075, 1e-12);
        EXPECT_EQ(effects(problem), (std::vector<std::string>{"conduction", "laser", "still_air"}));
        EXPECT_NEAR(effect(problem, "laser")[0], std::sqrt(1e-4 / pi), 1e-7);
        double shares = 0.0;
        for (const double weight : placed_weights(problem, "laser")) {
            shares += weight;
        }
        EXPECT_NEAR(shares, 1.0, 1e-12);
        EXPECT_DOUBLE_EQ(effect(problem, "still_air")[0], 10.0);
        EXPECT_DOUBLE_EQ(problem.input_signals.at(0.0, solver::JumpSide::after).laser_power, power);
        EXPECT_EQ(channels(problem), (std::vector<std::string>{"spot_centre_temperature", "spot_mean_temperature",
                                                               "inner_liner_temperature"}));
        EXPECT_DOUBLE_EQ(problem.settings.end, 1800.0);
        ASSERT_EQ(problem.measured.size(), 2U);
        EXPECT_DOUBLE_EQ(problem.measured[1].low, ice_point + low);
        EXPECT_DOUBLE_EQ(problem.measured[1].high, ice_point + high);
    }
}

// A film and a loss of 10 %, two lumps that start within 3 K of the air in each of three runs of 601 samples.
TEST(Library, BenchToPractiseOnFreesEightNumbers) {
    const Experiment bench = read_measured("practice/two_node_bench");
    ASSERT_EQ(bench.runs.size(), 3U);
    for (const MeasuredRun& run : bench.runs) {
        EXPECT_EQ(run.time.size(), 601U);
        EXPECT_DOUBLE_EQ(run.time.back(), 2400.0);
        EXPECT_EQ(run.series.size(), 2U);
    }
    EXPECT_EQ(
        free_numbers(bench),
        (std::vector<std::string>{"air_convection.lambda_h", "strain_energy_loss.tan_delta_a",
                                  "initial surface, run run1", "initial surface, run run2", "initial surface, run run3",
                                  "initial bulk, run run1", "initial bulk, run run2", "initial bulk, run run3"}));
    EXPECT_DOUBLE_EQ(bench.parameters[0].standard_deviation, 0.1);
    EXPECT_DOUBLE_EQ(bench.parameters[1].prior, 2.14e15);
    EXPECT_DOUBLE_EQ(bench.parameters[1].standard_deviation, 0.214e15);
    EXPECT_DOUBLE_EQ(bench.parameters[7].standard_deviation, 3.0);
    const std::vector<solver::Channel>& sensors = bench.runs[0].problem.channels;
    EXPECT_DOUBLE_EQ(sensors[0].standard_deviation.value_or(0.0), 0.5);
    EXPECT_DOUBLE_EQ(sensors[1].standard_deviation.value_or(0.0), 0.3);
}

// Two user effects beside the bench's eight numbers, on the puzzle's runs.
TEST(Library, OwnEffectsOfTheBenchAreFree) {
    const Experiment own = read_measured("practice/two_node_own_effects");
    ASSERT_EQ(own.runs.size(), 3U);
    EXPECT_EQ(own.runs[0].name, "puzzle1");
    ASSERT_EQ(own.parameters.size(), 10U);
    EXPECT_EQ(own.parameters[0].name, "throttle_heat.watts");
    EXPECT_EQ(own.parameters[1].name, "wall.conductance");
    EXPECT_FALSE(std::isfinite(own.parameters[1].standard_deviation));
}

// 50, 70 and 80 degC (M7) against the link's k, of which nothing is known, and three numbers with priors.
TEST(Library, SaturationHoldsThreeNumbersAgainstFour) {
    const Experiment saturation = read_measured("two_node/identify_saturation");
    ASSERT_EQ(saturation.runs.size(), 3U);
    const std::vector<double> bulk{50.0, 70.0, 80.0};
    const std::vector<double> uncertainty{2.8, 2.8, 3.6};
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(saturation.runs[i].numbers.size(), 1U);
        EXPECT_NEAR(saturation.runs[i].numbers[0].value, ice_point + bulk[i], 1e-12);
        EXPECT_DOUBLE_EQ(saturation.runs[i].numbers[0].standard_deviation, uncertainty[i]);
        EXPECT_DOUBLE_EQ(saturation.runs[i].numbers[0].time, 3600.0);
    }
    EXPECT_EQ(free_numbers(saturation),
              (std::vector<std::string>{"link.conductivity at 70 degC", "air_convection.lambda_h",
                                        "strain_energy_loss.tan_delta_a", "road_contact.Hc"}));
    EXPECT_FALSE(std::isfinite(saturation.parameters[0].standard_deviation));
    EXPECT_DOUBLE_EQ(saturation.parameters[3].standard_deviation, 350.0);
}

// A range of 10 K is a flat distribution of 10 K/sqrt(12) about its middle, beside the reading's 2.8 K.
TEST(Library, QuotedLaserNumbersAreFour) {
    const Experiment quoted = read_measured("laser/quoted_numbers");
    ASSERT_EQ(quoted.runs.size(), 2U);
    ASSERT_EQ(quoted.runs[0].numbers.size(), 2U);
    EXPECT_NEAR(quoted.runs[0].numbers[0].value, ice_point + 85.0, 1e-12);
    EXPECT_NEAR(quoted.runs[0].numbers[1].value, ice_point + 45.0, 1e-12);
    EXPECT_NEAR(quoted.runs[0].numbers[1].standard_deviation, std::hypot(2.8, 10.0 / std::sqrt(12.0)), 1e-12);
    EXPECT_DOUBLE_EQ(quoted.runs[1].problem.input_signals.at(0.0, solver::JumpSide::after).laser_power, 3.0);
    EXPECT_EQ(free_numbers(quoted),
              (std::vector<std::string>{"K1.conductivity at 90 degC", "K2.conductivity at 90 degC",
                                        "laser.absorptivity", "still_air.h"}));
}

// Two quadratics by three values each, four numbers of the bench, three starts; 15 minutes at every 5 s.
TEST(Library, LaserToIdentifyFreesTwoQuadraticsAndTheBench) {
    const Experiment laser = read_measured("laser/identify");
    ASSERT_EQ(laser.runs.size(), 3U);
    const std::vector<double> power{0.5, 1.5, 3.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(laser.runs[i].time.size(), 181U);
        EXPECT_DOUBLE_EQ(laser.runs[i].problem.input_signals.at(0.0, solver::JumpSide::after).laser_power, power[i]);
    }
    EXPECT_EQ(laser.runs[0].problem.mesh.n_cells, 58 * 34);
    ASSERT_EQ(laser.parameters.size(), 13U);
    EXPECT_EQ(laser.parameters[5].name, "K2.conductivity at 140 degC");
    EXPECT_DOUBLE_EQ(laser.parameters[6].prior, 0.93);
    EXPECT_DOUBLE_EQ(laser.parameters[7].standard_deviation, 1e-4);
}

// Performance page, section 1: 30 x 30 x 15 mm of a quarter, K1 above 3 mm; K1(40) = 0.29 + 0.0094 20 = 0.478,
// K2(40) = 0.060 + 0.0002 20 = 0.064.
TEST(Library, SlabsAreTheReferenceProblem) {
    const solver::Problem linear = read_library("reference/slab_linear");
    EXPECT_EQ(linear.mesh.n_cells, 16 * 16 * 58);
    EXPECT_DOUBLE_EQ(linear.symmetry, 4.0);
    EXPECT_NEAR(linear.mesh.total_volume(), 0.03 * 0.03 * 0.015, 1e-15);
    EXPECT_NEAR(linear.mesh.grid->edge[2][8], 0.003, 1e-15);
    EXPECT_TRUE(linear.materials[0].conductivity[0].is_constant());
    EXPECT_DOUBLE_EQ(linear.materials[0].conductivity[0].value(300.0), 0.478);
    EXPECT_DOUBLE_EQ(linear.materials[1].conductivity[2].value(300.0), 0.064);
    EXPECT_EQ(channels(linear), (std::vector<std::string>{"top", "bottom", "centre"}));
    // A quarter of the disc lies on the mesh.
    double shares = 0.0;
    for (const double weight : placed_weights(linear, "laser")) {
        shares += weight;
    }
    EXPECT_NEAR(shares, 0.25, 1e-12);

    const solver::Problem nonlinear = read_library("reference/slab_nonlinear");
    EXPECT_NEAR(nonlinear.materials[0].conductivity[2].value(ice_point + 100.0), 0.29 + 0.0094 * 80.0, 1e-12);
    EXPECT_NEAR(nonlinear.materials[1].conductivity[2].value(ice_point + 100.0), 0.060 + 0.0002 * 80.0, 1e-12);
    EXPECT_DOUBLE_EQ(nonlinear.settings.end, 600.0);

    const solver::Problem round = read_library("reference/slab_axisymmetric");
    EXPECT_EQ(round.materials, nonlinear.materials);
    EXPECT_NEAR(round.mesh.total_volume(), 0.06 * 0.06 * 0.015, 3e-5 * 5.4e-5);  // the radius is rounded to 1e-5
    EXPECT_DOUBLE_EQ(round.symmetry, 1.0);
}

// Performance page, section 2. A metre along y, so that joules are those per metre.
TEST(Library, SectionHasItsOwnCoefficientOnEachSide) {
    const solver::Problem problem = read_library("reference/section");
    EXPECT_EQ(problem.mesh.n_cells, 450 * 60);
    EXPECT_NEAR(problem.mesh.total_volume(), 0.225 * 0.015, 1e-12);
    EXPECT_DOUBLE_EQ(effect(problem, "uniform_source")[0], 1e5);
    const physics::ActiveEffect& air = effect(problem, "still_air");
    ASSERT_EQ(air.patches.size(), 4U);
    const std::vector<double> expected{60.0, 10.0, 20.0, 20.0};
    const std::vector<std::string> names{"top", "bottom", "left", "right"};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(problem.mesh.patches[static_cast<std::size_t>(air.patches[i])].name, names[i]);
        EXPECT_DOUBLE_EQ(air.on_patch(0, i), expected[i]);
    }
    EXPECT_EQ(channels(problem), (std::vector<std::string>{"top", "bottom", "centre", "top_corner"}));
}

}  // namespace tiretherm::input
