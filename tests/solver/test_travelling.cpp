// SPDX-License-Identifier: BSD-3-Clause
// Simulated travelling contact against the contact averaged over revolutions, on a strip and on a ring.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/ring.hpp"
#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/travelling.hpp"
#include "solver/wheel_angle.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm::solver {

namespace {

constexpr double road_temperature = 296.15;
constexpr double k = 0.29;
constexpr double capacity = 1.98e6;

/// The strip of tread that passes through the contact: all of it touches the road once a turn. m2
double strip(const physics::Tire& tire) {
    const double circumference = 2.0 * std::numbers::pi * tire.rolling_radius(4000.0);
    return tire.contact_area(4000.0) / tire.contact_length(4000.0) * circumference;
}

/// 10 mm of tread whose outer cells resolve what a contact of milliseconds reaches, sqrt(alpha t) = 23 um, at 60 degC on
/// a road of 23 degC; 4 kN, 100 km/h. The tread is insulated but for the road.
Problem tread(std::string_view contact, double end, int refinement = 1) {
    Problem problem;
    problem.title = std::string(contact);
    problem.mesh = mesh::build(
        mesh::Layers{.area = strip(problem.tire),
                     .stack = {{"skin", 0.4e-3, 30 * refinement, 8.0}, {"tread", 9.6e-3, 30 * refinement, 20.0}}});
    problem.materials = {support::material(k, 1100.0, 1800.0), support::material(k, 1100.0, 1800.0)};
    support::switch_on(problem, "conduction");
    if (!contact.empty()) {
        support::switch_on(problem, contact);
    }
    support::hold(problem, "speed", 100.0 / 3.6);
    support::hold(problem, "vertical_load", 4000.0);
    support::hold(problem, "road_temperature", road_temperature);
    support::read(problem, "surface", mesh::over_patch(problem.mesh, problem.mesh.find_patch("outside")));
    support::read(problem, "tread",
                  problem.mesh.regions[static_cast<std::size_t>(problem.mesh.find_region("bulk"))].mean);
    support::start_at(problem, 333.15);
    problem.settings.end = end;
    problem.settings.tolerance = 0.003;
    problem.settings.output_interval = 0.0;
    return problem;
}

void turn_wheel(Problem& problem) { problem.input_signals.add(wheel_angle(problem, 1'000'000).value()); }

/// Of the last whole revolution: the surface when it meets the road and when it leaves it, and its mean in time.
struct Revolution {
    double entry = 0.0;
    double exit = 0.0;
    double mean = 0.0;
    double tread = 0.0;
};

Revolution last_revolution(const Problem& problem) {
    const support::History rows = support::record(problem);
    const double period = 1.0 / problem.tire.revolutions(100.0 / 3.6, 4000.0);
    const double end = rows.time.back();
    Revolution found{.entry = 0.0, .exit = 1e9, .mean = 0.0, .tread = rows.channels.back()[1]};
    double last_time = end - period;
    double last_value = 0.0;
    for (std::size_t i = 0; i < rows.time.size(); ++i) {
        if (rows.time[i] < end - period) {
            last_value = rows.channels[i][0];
            continue;
        }
        const double now = rows.channels[i][0];
        found.mean += 0.5 * (now + last_value) * (rows.time[i] - last_time) / period;
        found.entry = std::max(found.entry, now);  // the surface recovers from the exit to the next entry
        found.exit = std::min(found.exit, now);
        last_time = rows.time[i];
        last_value = now;
    }
    return found;
}

}  // namespace

// Forty turns simulated one by one against the periodic contact, whose slow field carries the mean of a revolution. What is
// left, 0.06 K of the 17 K between tread and road, is the start, which the periodic contact has forgotten, and the steps.
TEST(TravellingContact, AgreesWithTheContactAveragedOverItsRevolutions) {
    Problem turning = tread("travelling_contact", 3.0, 2);
    turning.settings.tolerance = 0.001;
    turn_wheel(turning);
    const Revolution brute = last_revolution(turning);

    Problem averaged = tread("resolved_contact", 3.0, 2);
    averaged.settings.tolerance = 0.0001;
    const Revolution slow = last_revolution(averaged);
    const physics::ContactInRevolutions contact = *physics::contact_in_revolutions(
        averaged.effects.back(), std::sqrt(0.29 * 1.98e6), averaged.tire, averaged.input_signals.constants());
    const double above = slow.mean - road_temperature;
    EXPECT_GT(brute.entry - brute.exit, 10.0) << "the surface swings in each revolution";
    EXPECT_NEAR(brute.mean, slow.mean, 0.1);
    EXPECT_NEAR(brute.entry, slow.mean + above * contact.at_entry(), 0.1);
    EXPECT_NEAR(brute.exit, slow.mean + above * contact.at_exit(), 0.1);
    EXPECT_NEAR(brute.tread, slow.tread, 0.01);
}

// A contact of no length touches nothing: not one temperature differs from the run without it.
TEST(TravellingContact, OfNoLengthIsNoContact) {
    Problem without = tread("", 0.5);
    Problem with = tread("travelling_contact", 0.5);
    with.tire.contact_length_table = physics::Curve::constant(0.0);
    support::start_at(without, 333.15);
    turn_wheel(with);
    for (Problem* problem : {&without, &with}) {
        for (int i = 0; i < 30; ++i) {  // something to conduct
            problem->initial[static_cast<std::size_t>(i)] = 300.0;
        }
        problem->settings.fixed_step = 0.01;
    }
    const support::History a = support::record(without);
    const support::History b = support::record(with);
    EXPECT_NEAR(a.channels.back()[0], b.channels.back()[0], 1e-3);
    EXPECT_EQ(b.report.joules.back(), 0.0);
}

namespace {

/// One column of tread, its skin resolved, around the tire; `sectors` = 1 leaves it a section.
Problem column_around(int sectors, double end) {
    mesh::Section section;
    Problem problem = tread("", end);
    section.meridian = mesh::Meridian(problem.tire.unloaded_radius, {{0.1, 1e-6}});
    section.layers = {{"skin", 0.4e-3, 12, 8.0}, {"tread", 9.6e-3, 10, 20.0}};
    const double around = 2.0 * std::numbers::pi * problem.tire.unloaded_radius;
    section.zones = {{"crown", strip(problem.tire) / around, 1, 1.0, {0, 1}, true}};
    problem.mesh = mesh::build(section);
    if (sectors > 1) {
        problem.mesh = mesh::ring(problem.mesh, sectors);
    }
    problem.effects.clear();
    support::switch_on(problem, "conduction");
    problem.channels.clear();
    support::start_at(problem, 333.15);
    return problem;
}

}  // namespace

// Where nothing goes round, and nothing bends with temperature, the mean around a ring is the section: each node's sum over
// its copies obeys the section's equations, whatever the start.
TEST(Ring, IsTheSectionInTheMeanAroundItsCircumference) {
    Problem ring = column_around(9, 20.0);
    Problem section = column_around(1, 20.0);
    for (Problem* problem : {&ring, &section}) {
        support::switch_on(*problem, "resolved_contact");
        problem->settings.fixed_step = 0.05;
    }
    for (int node = 0; node < ring.mesh.n_nodes; ++node) {
        const int sector = mesh::sector_of(ring.mesh, node);
        ring.initial[static_cast<std::size_t>(node)] +=
            5.0 * (sector - 4) + 900.0 * ring.mesh.centre[static_cast<std::size_t>(node)][2];
    }
    for (int node = 0; node < section.mesh.n_nodes; ++node) {
        section.initial[static_cast<std::size_t>(node)] +=
            900.0 * section.mesh.centre[static_cast<std::size_t>(node)][2];
    }
    const std::vector<double> around = mesh::around(ring.mesh, support::final_field(ring));
    const std::vector<double> flat = support::final_field(section);
    for (std::size_t i = 0; i < flat.size(); ++i) {
        EXPECT_NEAR(around[i], flat[i], 1e-8) << i;
    }
}

// A contact on sectors of finite width: a sector is cooled as a whole while its leading part touches, so that coarse ones
// give the road too much, 21 % with 8 and 1.0 % with 64; from one number to its double the error falls by a factor that
// itself grows from 2, the first order, to 4. In 64 sectors 15 s, here 3.
TEST(Ring, ComesToTheAveragedContactAsItsSectorsShrink) {
    Problem section = column_around(1, 0.36);
    section.settings.tolerance = 1e-4;
    support::switch_on(section, "resolved_contact");
    const double averaged = support::run_closed(section).joules.back();
    std::vector<double> errors;
    for (const int sectors : {8, 16, 32}) {
        Problem ring = column_around(sectors, 0.36);
        ring.settings.tolerance = 0.02;
        const physics::Effect& contact = physics::in_frames(*physics::find_effect("travelling_contact"));
        solver::switch_on(ring, physics::activate(contact, ring.mesh), road_temperature);
        turn_wheel(ring);
        errors.push_back(support::run_closed(ring).joules.back() / averaged - 1.0);
    }
    EXPECT_GT(errors[0] / errors[1], 1.9);
    EXPECT_GT(errors[1] / errors[2], 2.5);
    EXPECT_NEAR(errors[2], 0.0, 0.05);
}

}  // namespace tiretherm::solver
