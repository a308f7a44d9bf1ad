// SPDX-License-Identifier: BSD-3-Clause
// Whole tire section: limit of flat layers, mirror symmetry, grid convergence, and totals kept by the weights.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "mesh/column_probe.hpp"
#include "solver/system.hpp"
#include "tests/support/order.hpp"
#include "tests/support/tire_section.hpp"

// The section of a whole tire: limits, symmetry, grid convergence.
namespace tiretherm {
namespace {

using std::numbers::pi;

/// Largest difference of two fields. K
double apart(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return a.size() == b.size() ? worst : std::nan("");
}

/// The thesis's tire with cells through its thickness, cornering a little, for ten minutes.
void finish(solver::Problem& problem) {
    problem.materials.assign(2, support::material(physics::Curve::quadratic_about(293.15, 0.29, 0.00943, 0.0), 1100.0,
                                                  physics::Curve::constant(1800.0)));
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"}) {
        support::switch_on(problem, id);
    }
    support::hold(problem, "speed", 100.0 / 3.6);
    support::hold(problem, "vertical_load", 4000.0);
    support::hold(problem, "slip_angle", 0.03);
    support::hold(problem, "lateral_force", 1500.0);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 300.15);
    support::start_at(problem, 296.15);
    problem.settings.end = 600.0;
    problem.settings.fixed_step = 20.0;
    problem.settings.output_interval = 60.0;
    problem.settings.tolerance = 1e-9;
    for (const mesh::Region& region : problem.mesh.regions) {
        support::read(problem, region.name, region.mean);
    }
    support::read(problem, "inside", mesh::over_patch(problem.mesh, problem.mesh.find_patch("inside")));
}

}  // namespace

// A crown alone, straight and one column wide, is the strip of layers: same areas 2 pi R0 W, same cells.
TEST(TireSection, OneColumnIsTheStripOfLayers) {
    const std::vector<mesh::Layer> stack{{"tread", 0.008, 8, 2.0}, {"below", 0.004, 4}};
    solver::Problem section;
    mesh::Section description;
    description.meridian = mesh::Meridian(section.tire.unloaded_radius, {});
    description.layers = stack;
    description.zones = {{"crown", section.tire.width, 1, 1.0, {0, 1}}};
    section.mesh = mesh::build(description);
    finish(section);
    solver::Problem layers;
    layers.mesh = mesh::build(mesh::Layers{.area = layers.tire.outer_area(), .stack = stack});
    finish(layers);

    const support::History a = support::record(section);
    const support::History b = support::record(layers);
    ASSERT_EQ(a.time, b.time);
    double worst = 0.0;
    for (std::size_t i = 0; i < a.time.size(); ++i) {
        worst = std::max(worst, apart(a.channels[i], b.channels[i]));
    }
    // 30 steps of sums in another order at 340 K: 1e-13 each, 1e-9 the tolerance of each step's iteration.
    support::expect_below("section less layers, K", worst, 1e-9);
    EXPECT_GT(a.channels.back()[1], 320.0);
}

// Without camber nothing tells left from right.
TEST(TireSection, IsItsOwnMirrorImageWithoutCamber) {
    solver::Problem problem = support::tire_problem(3);
    support::switch_on(problem, "camber_asymmetry");
    support::hold(problem, "camber", 0.0);
    problem.settings.fixed_step = 20.0;
    problem.settings.tolerance = 1e-9;
    const std::vector<double> T = support::final_field(problem);
    support::expect_below("field less its mirror image, K", apart(T, support::mirrored(problem.mesh, T)), 1e-9);
}

// Leaning the other way makes the mirror image; leaning at all makes a difference, on the side that the top leans to.
TEST(TireSection, OppositeCamberMakesTheMirrorImage) {
    std::vector<std::vector<double>> fields;
    mesh::Mesh mesh;
    for (const double camber : {-1.5 * support::deg, 1.5 * support::deg}) {
        solver::Problem problem = support::tire_problem(3);
        support::switch_on(problem, "camber_asymmetry");
        support::hold(problem, "camber", camber);
        problem.settings.fixed_step = 20.0;
        problem.settings.tolerance = 1e-9;
        fields.push_back(support::final_field(problem));
        mesh = problem.mesh;
    }
    support::expect_below("mirror image, K", apart(fields[0], support::mirrored(mesh, fields[1])), 1e-9);
    const double inside = mesh::over_cells(mesh, -1, mesh.find_zone("inside_shoulder"))(fields[0]);
    const double outside = mesh::over_cells(mesh, -1, mesh.find_zone("outside_shoulder"))(fields[0]);
    EXPECT_GT(inside, outside + 1.0);
}

// A cell is a ring of its column's length and mean radius, whatever its depth. By Pappus's rule a drawn cell is 2 pi times the radius
// of its centre times its area. Along arcs of curvature k, turned by t, the second is the integral of 2 pi (R - d cos t)(1 - k d)
// over arc length and depth d, worked out apart from this program: the first is 1.0246, 1.1239 and 1.1069 of it in crown,
// shoulders and sidewalls, and 1.0775 in all.
TEST(TireSection, HasMoreVolumeThanItIsDrawnWith) {
    const mesh::Mesh mesh = mesh::build(support::tire_section(physics::Tire{}, 8));
    std::vector<double> cells(mesh.zones.size());
    std::vector<double> drawn(mesh.zones.size());
    for (std::size_t cell = 0; cell < static_cast<std::size_t>(mesh.n_cells); ++cell) {
        double moment = 0.0;  // of the area about the axis, times 6
        for (std::size_t k = 0; k < 4; ++k) {
            const auto corner = [&](std::size_t which) {
                return mesh.drawing.points[static_cast<std::size_t>(mesh.drawing.corners[4 * cell + which % 4])];
            };
            const auto [x, y, r] = corner(k);
            const auto [x_next, y_next, r_next] = corner(k + 1);
            moment += (r + r_next) * (x * r_next - x_next * r);
        }
        const auto zone = static_cast<std::size_t>(mesh.zone[cell]);
        cells[zone] += mesh.volume[cell];
        drawn[zone] += 2.0 * pi * std::abs(moment) / 6.0;
    }
    const std::vector<double> expected{1.1069, 1.1239, 1.0246, 1.1239, 1.1069};
    for (std::size_t zone = 0; zone < expected.size(); ++zone) {
        EXPECT_NEAR(cells[zone] / drawn[zone], expected[zone], 2e-3) << mesh.zones[zone];
    }
    EXPECT_NEAR(mesh.total_volume() / std::accumulate(drawn.begin(), drawn.end(), 0.0), 1.0775, 2e-3);
}

// Heat made evenly between two beads that are cooled, insulated elsewhere, on a profile that turns: from the centre to s
// flows q 2 pi t times the integral of r, through a ring of 2 pi r t. So
//     T(0) - T_air = q/k int_0^L (int_0^s r)/r ds + q (int_0^L r)/(r(L) h).
TEST(TireSection, ConductsAlongTheMeridianAtSecondOrder) {
    constexpr double L = 0.12;
    constexpr double k = 0.3;
    constexpr double q = 2e4;
    constexpr double h = 40.0;
    const mesh::Meridian meridian(0.33, {{0.04, 0.5}, {0.08, 12.0}});
    double swept = 0.0;
    double rise = 0.0;
    constexpr int n = 200'000;  // midpoint rule: 1e-10 of the rise
    for (int i = 0; i < n; ++i) {
        const double ds = L / n;
        const double r = meridian.at((i + 0.5) * ds).radius;
        rise += q / k * (swept + 0.5 * r * ds) / r * ds;
        swept += r * ds;
    }
    rise += q * swept / (meridian.at(L).radius * h);

    std::vector<double> errors;
    for (const int cells : {9, 27, 81}) {  // odd, so that a column stands at the centre
        solver::Problem problem;
        mesh::Section description;
        description.meridian = meridian;
        description.layers = {{"rubber", 0.01, 1}};
        description.zones = {{"crown", 2.0 * L, cells, 1.0, {0}}};
        problem.mesh = mesh::build(description);
        problem.materials = {support::material(k, 1100.0, 1800.0)};
        support::switch_on(problem, "conduction");
        support::switch_on(problem, "uniform_source", {{"power_density", q}});
        support::switch_on(problem, "still_air", {{"h", h}}, {"beads"});
        support::hold(problem, "air_temperature", 300.0);
        support::start_at(problem, 300.0);
        problem.settings.steady = true;
        problem.settings.tolerance = 1e-9;
        support::read(problem, "centre", mesh::at_point(problem.mesh, {0.0, 0.0, 0.005}));
        errors.push_back(support::run_closed(problem).channel_final[0] - 300.0 - rise);
    }
    support::expect_order("centre", errors, 1.9, 2.1, 3.0);
}

// The hottest cell on three grids, each twice as fine, with an estimate of what the finest lacks: a third of its last
// change at second order. Where the sidewall joins the thicker tread, the grid has a re-entrant corner, and the order is
// lower there; the hot spot must converge all the same.
TEST(TireSection, HottestCellConvergesWithTheGrid) {
    std::vector<double> hottest;
    for (const int refinement : {2, 4, 8}) {
        solver::Problem problem = support::tire_problem(refinement);
        problem.settings.steady = true;
        problem.settings.end = 3600.0;
        hottest.push_back(support::run_closed(problem).hottest.temperature);
    }
    const double change = hottest[1] - hottest[0];
    const double last = hottest[2] - hottest[1];
    const double order = std::log2(std::abs(change / last));
    support::expect_below("change of the hottest cell, 8 against 4, K", last, 0.5);
    RecordProperty("observed order", support::formatted({order}));
    EXPECT_GT(order, 0.8) << support::formatted(hottest);
}

namespace {

/// Heat of every effect at an even 330 K under given inputs. @returns [n_effects] W
std::vector<double> watts_at_330K(const solver::Problem& problem) {
    solver::System system(problem);
    std::vector<double> coefficients(system.n_coefficients());
    system.evaluate_coefficients(problem.input_signals.at(0.0, solver::JumpSide::after), coefficients);
    const std::vector<double> T(static_cast<std::size_t>(problem.mesh.n_nodes), 330.0);
    system.evaluate(T, coefficients);
    return system.terms().watts;
}

physics::ActiveEffect& effect(solver::Problem& problem, std::string_view id) {
    return *std::find_if(problem.effects.begin(), problem.effects.end(),
                         [&](const physics::ActiveEffect& active) { return active.effect->id == id; });
}

void set(physics::ActiveEffect& active, std::string_view key, double value) {
    active.parameters[static_cast<std::size_t>(physics::find_parameter(*active.effect, key))] = value;
}

void override_at(physics::ActiveEffect& active, std::string_view key, physics::Scope scope, int index, double value) {
    active.overrides.push_back({.scope = scope,
                                .index = index,
                                .parameter = static_cast<std::size_t>(physics::find_parameter(*active.effect, key)),
                                .value = value});
}

}  // namespace

// However the loss is shared out - by layers, zones, the belt's edges, a profile, camber - its total is the law's: with
// T_eq = 330 K + shift, power times tan delta. The same for friction, partition 0.6 of Fy V tan(alpha), and for the
// contact, Hc S_cont (T_road - T).
TEST(TireSection, EveryWeightKeepsTheTotalOfItsLaw) {
    constexpr double V = 100.0 / 3.6;
    constexpr double Fz = 4000.0;
    solver::Problem problem = support::tire_problem(2);
    support::switch_on(problem, "camber_asymmetry");
    support::hold(problem, "camber", -2.0 * support::deg);
    support::hold(problem, "slip_angle", 2.0 * support::deg);
    support::hold(problem, "lateral_force", 2500.0);
    const mesh::Mesh& mesh = problem.mesh;
    const physics::Curve profile = physics::Curve::table({-0.1, -0.05, 0.0, 0.1}, {0.5, 1.4, 1.0, 0.2});

    physics::ActiveEffect& loss = effect(problem, "strain_energy_loss");
    override_at(loss, "strain_energy_share", physics::Scope::layer, mesh.find_layer("belt"), 3.0);
    override_at(loss, "loss_tangent_share", physics::Scope::layer, mesh.find_layer("tread"), 0.7);
    override_at(loss, "strain_energy_share", physics::Scope::zone, mesh.find_zone("inside_sidewall"), 0.4);
    set(loss, "belt_edge_gain", 2.0);
    loss.tables[0] = profile;
    effect(problem, "sliding_friction").tables[0] = profile;
    effect(problem, "road_contact").tables[0] = profile;

    const physics::Tire& tire = problem.tire;
    const physics::LossTangent law;
    const double expected_loss =
        physics::strain_power(tire, V, Fz) * law.value(330.0 + law.shift(tire.revolutions(V, Fz)));
    const double expected_friction = 0.6 * 2500.0 * V * std::tan(2.0 * support::deg);
    const double expected_contact = 500.0 * tire.contact_area(Fz) * (296.15 - 330.0);
    const std::vector<double> watts = watts_at_330K(problem);
    support::expect_below("loss, relative", watts[1] / expected_loss - 1.0, 1e-13);
    support::expect_below("friction, relative", watts[2] / expected_friction - 1.0, 1e-13);
    support::expect_below("contact, relative", watts[4] / expected_contact - 1.0, 1e-13);
    // At an even temperature the local loss tangent is the mean's.
    loss.choices[0] = 1;
    support::expect_below("local loss, relative", watts_at_330K(problem)[1] / expected_loss - 1.0, 1e-13);
}

// A lean so large that one shoulder would have to give more than it has: it gives all, and the total stays.
TEST(TireSection, CamberKeepsTheTotalHoweverLarge) {
    const double straight = watts_at_330K(support::tire_problem(2))[1];
    for (const double degrees : {-2.0, 8.0, 40.0}) {
        solver::Problem problem = support::tire_problem(2);
        support::switch_on(problem, "camber_asymmetry");
        support::hold(problem, "camber", degrees * support::deg);
        support::expect_below("loss under camber, relative", watts_at_330K(problem)[1] / straight - 1.0, 1e-13);
    }
}

// Where the weight of a layer is three times, its heat per mass is three times that of its neighbour; belt edges stand
// at 0.8 of half the tread, where the excess is the gain, and the profile multiplies.
TEST(TireSection, WeightsGoWhereTheyAreSaidTo) {
    solver::Problem problem = support::tire_problem(8);
    physics::ActiveEffect& loss = effect(problem, "strain_energy_loss");
    override_at(loss, "strain_energy_share", physics::Scope::layer, problem.mesh.find_layer("belt"), 3.0);
    set(loss, "belt_edge_gain", 2.0);
    const solver::System system(problem);
    const physics::ActiveEffect& placed = system.effects()[1];
    const auto per_mass = [&](const mesh::Column& column, std::string_view layer) {
        for (int cell = column.first_cell; cell < column.first_cell + column.cells(); ++cell) {
            const auto c = static_cast<std::size_t>(cell);
            if (problem.mesh.layers[static_cast<std::size_t>(problem.mesh.layer[c])] == layer) {
                const double density = problem.materials[static_cast<std::size_t>(problem.mesh.layer[c])].density;
                return placed.weights[c] / (problem.mesh.volume[c] * density);
            }
        }
        return std::nan("");
    };
    const auto column = [&](double s) {
        return problem.mesh.columns[static_cast<std::size_t>(mesh::column_at(problem.mesh, s))];
    };
    EXPECT_NEAR(per_mass(column(0.001), "belt") / per_mass(column(0.001), "tread"), 3.0, 1e-12);
    // The column that holds 0.8 of 112.5 mm has its middle within half a column, 2.8 mm: exp(-(2.8/10)^2/...) >= 0.98.
    EXPECT_NEAR(per_mass(column(0.09), "tread") / per_mass(column(0.001), "tread"), 3.0, 0.05);
}

// An even density of rubber and an even share: the loss in the tread's band is its share of the mass, which by Pappus is
// that of length times mean radius times thickness.
TEST(TireSection, SharesTheLossByMass) {
    solver::Problem problem = support::tire_problem(2);
    const solver::MarchReport report = support::run_closed(problem);
    const double power = physics::strain_power(problem.tire, 100.0 / 3.6, 4000.0);
    const physics::LossTangent law;
    const double T_bulk = problem.mesh.regions[1].mean(support::final_field(problem));
    const double tangent = law.value(T_bulk + law.shift(problem.tire.revolutions(100.0 / 3.6, 4000.0)));
    EXPECT_NEAR(report.watts[1], power * tangent, 1e-9 * power);
}

}  // namespace tiretherm
