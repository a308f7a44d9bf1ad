// SPDX-License-Identifier: BSD-3-Clause
// Sentences about temperatures outside the ranges of the materials' laws.
#include <gtest/gtest.h>

#include "solver/time_integration/law_ranges.hpp"
#include "solver/time_integration/march.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm::solver {
namespace {

constexpr double zero = 273.15;

struct Tread {
    mesh::Mesh mesh;
    physics::MaterialModel model;
};

/// Two layers of rubber whose conductivity is known from 20 to 120 degC, one below of a constant one.
Tread tread() {
    Tread made;
    made.mesh.layers = {"tread", "base", "belt"};
    physics::Material rubber = support::material(0.29, 1100.0, 1800.0);
    rubber.name = "rubber";
    rubber.conductivity.fill(
        physics::Curve::quadratic_about(zero + 20.0, 0.29, 0.00943, 0.0).within(zero + 20.0, zero + 120.0));
    made.model.materials = {rubber, rubber, support::material(0.2, 1150.0, 1600.0)};
    return made;
}

}  // namespace

TEST(LawRanges, SaysWhatWasLeftAndHowFar) {
    const Tread made = tread();
    const std::vector<LayerExtremes> inside{
        {zero + 20.0, zero + 90.0}, {zero + 20.0, zero + 120.0}, {zero - 40.0, zero + 149.0}};
    EXPECT_TRUE(law_range_warnings(made.mesh, made.model, inside).empty());
    const std::vector<LayerExtremes> outside{
        {zero - 30.0, zero + 90.0}, {zero + 20.0, zero + 131.5}, {zero, zero + 100.0}};
    const std::vector<RangeWarning> said = law_range_warnings(made.mesh, made.model, outside);
    ASSERT_EQ(said.size(), 1U) << "two layers of one material share a sentence, three directions alike as well";
    EXPECT_EQ(said.front().text(),
              "the conductivity of \"rubber\" is known from 20 to 120 degC and held beyond; it was between -30.0 and "
              "131.5 degC");
}

TEST(LawRanges, SaysThatRubberReverts) {
    const Tread made = tread();
    const std::vector<LayerExtremes> hot{
        {zero + 20.0, zero + 90.0}, {zero + 20.0, zero + 90.0}, {zero + 20.0, zero + 207.0}};
    const std::vector<RangeWarning> said = law_range_warnings(made.mesh, made.model, hot);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said.front().text(),
              "above 150 degC vulcanised rubber reverts (its cross-links break), and no law here knows that; belt was "
              "between 20.0 and 207.0 degC");
}

// A slab that starts at 160 degC and cools: the report has the sentence, whatever it ends with.
TEST(LawRanges, AreWatchedThroughARun) {
    Problem problem;
    problem.title = "slab";
    problem.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{.name = "rubber", .thickness = 0.01, .cells = 4}}});
    problem.materials = {support::material(0.29, 1100.0, 1800.0)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "still_air");
    support::hold(problem, "air_temperature", 293.15);
    support::start_at(problem, zero + 160.0);
    problem.settings.end = 10000.0;
    const MarchReport report = run(problem, {});
    ASSERT_EQ(report.warnings.size(), 1U);
    const std::string said = report.warnings.front().text();
    EXPECT_NE(said.find("160.0 degC"), std::string::npos) << said;
    support::start_at(problem, zero + 140.0);
    EXPECT_TRUE(run(problem, {}).warnings.empty());
}

}  // namespace tiretherm::solver
