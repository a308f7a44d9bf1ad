// SPDX-License-Identifier: BSD-3-Clause
// Prepares effects that go round the tire with the contact: computes the wheel angle over the run and checks mesh, run
// time and contact width.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "input/effects/effects.hpp"
#include "physics/contact/travelling.hpp"
#include "solver/wheel_angle.hpp"

namespace tiretherm::input {

namespace {

/// Some fifteen hours of a column at 100 km/h, half an hour of a ring of 60 sectors, and days of steps.
constexpr std::size_t most_points = 3'000'000;

/// Where the case switches a travelling effect on.
struct Mention {
    std::string_view id;
    std::string_view key;  ///< of the choice; empty where the effect has none
    SourceLocation place;
};

/// How much of the rubber that passes the contact as the mesh has it is touched at the end of the run: 1 where the strip
/// is as wide as S_cont / l.
double coverage(const solver::Problem& problem, physics::ActiveEffect contact) {
    const physics::Inputs inputs = problem.input_signals.at(problem.settings.end, solver::JumpSide::before);
    const physics::TravellingContact where(problem.tire, inputs);
    if (!where.touches()) {
        return 1.0;
    }
    const physics::MaterialModel material_model{
        .materials = problem.materials, .link_laws = problem.link_laws, .tire = problem.tire};
    contact.effect->place({.mesh = problem.mesh, .material_model = material_model, .effects = problem.effects},
                          contact);
    std::size_t i = 0;
    double densest = 0.0;  // weight per area, 1/m2
    for (const int patch : contact.patches) {
        for (const mesh::PatchFace& face : problem.mesh.patches[static_cast<std::size_t>(patch)].faces) {
            densest = std::max(densest, contact.weights[i++] / face.area);
        }
    }
    return densest * problem.tire.contact_area(inputs.vertical_load) * 2.0 * std::numbers::pi / where.length();
}

void warn_of_width(const solver::Problem& problem, const physics::ActiveEffect& contact, const Mention& mention,
                   InputErrors& errors) {
    const double touched = coverage(problem, contact);
    if (std::abs(touched - 1.0) > 0.15) {
        errors.warn(mention.place,
                    "the strip of tread that passes the contact is {:.3g} times as wide as the contact "
                    "area over its length: its cells exchange with {:.3g} of the interface's conductance; "
                    "give {} a profile of the contact's width, or layers its area",
                    1.0 / touched, touched, mention.id);
    }
}

/// Where the contact goes round and the heat of sliding does not.
void warn_of_heat_spread_evenly(const solver::Problem& problem, const Mention& contact, InputErrors& errors) {
    const auto gives = [&](std::string_view signal) {
        return problem.input_signals.gives(*physics::find_signal(signal));
    };
    const auto spread = std::ranges::find_if(problem.effects, [](const physics::ActiveEffect& active) {
        return active.effect->id == "sliding_friction" && !physics::travels(active);
    });
    if (spread != problem.effects.end() && (gives("slip_angle") || gives("slip_ratio"))) {
        errors.warn(contact.place,
                    "{} goes round the tire, but the heat of sliding is spread around it: the tread is not "
                    "heated in the contact, and the road takes no share of that heat; write around = "
                    "\"in_contact\" in [effects.sliding_friction]",
                    contact.id);
    }
}

}  // namespace

void read_travelling(TomlTable& root, bool has_tire, solver::Problem& problem) {
    InputErrors& errors = root.errors();
    std::optional<Mention> mention;
    for (physics::ActiveEffect& active : problem.effects) {
        if (!physics::travels(active)) {
            continue;
        }
        const std::string_view id = active.effect->id;
        const TomlValue* table = root.content().find({"effects", id});
        const TomlValue* key = table != nullptr ? table->find(physics::around_key) : nullptr;
        mention = {.id = id,
                   .key = key != nullptr ? physics::around_key : std::string_view(),
                   .place = key != nullptr     ? key->place
                            : table != nullptr ? table->place
                                               : root.place()};
        if (problem.mesh.n_nodes > 0 && problem.mesh.is_lumped() && key != nullptr) {
            errors.add(mention->place, "two lumps do not see a contact go round", "take layers or section");
        }
        if (active.field) {
            errors.add(mention->place, fmt::format("{} has a field, which does not go round the tire", id),
                       "remove the field, or spread the heat evenly");
        }
        if (problem.mesh.is_ring()) {
            active.effect = &physics::in_frames(*active.effect);
        }
    }
    if (!mention) {
        return;
    }
    if (problem.settings.steady) {
        errors.add(mention->place, fmt::format("a tire in which {} goes round has no steady state", mention->id),
                   "let it run with end, or take resolved_contact, whose revolutions are averaged");
        return;
    }
    if (!has_tire || problem.mesh.n_nodes == 0 || problem.settings.end <= problem.settings.start) {
        return;
    }
    std::optional<solver::Series> angle = solver::wheel_angle(problem, most_points);
    if (!angle) {
        errors.add(mention->place,
                   fmt::format("in {:.6g} s the contact passes more than {} million places of the tire",
                               problem.settings.end - problem.settings.start, most_points / 1'000'000),
                   "shorten the run or take fewer sectors; resolved_contact averages the revolutions of long ones");
        return;
    }
    problem.input_signals.add(std::move(*angle));
    for (const physics::ActiveEffect& active : problem.effects) {
        if (const physics::HeatEffect* heat = active.effect->heat_effect();
            heat != nullptr && heat->travels && errors.count() == 0) {
            warn_of_width(problem, active, *mention, errors);
            warn_of_heat_spread_evenly(problem, *mention, errors);
        }
    }
}

}  // namespace tiretherm::input
