// SPDX-License-Identifier: BSD-3-Clause
// Compares the inputs of a case with the ranges of the tire's laws: inflation pressure against the reference, deflection
// against the section's height; and slip that is given twice.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/model/problem_builder.hpp"

namespace tiretherm::input {

namespace {

/// Shares of the reference pressure between which Rhyne's stiffness and SAE J2452 were fitted, recalled: 140 to 370 kPa of
/// tires inflated to 220 kPa.
constexpr double least_pressure = 0.5;
constexpr double most_pressure = 1.7;
/// Of the section's height; beyond it the sidewalls fold and the rim comes near the road.
constexpr double most_deflection = 0.4;

/// Extremes of what the run gives, as far as the inputs bend: at their samples and stops.
struct Seen {
    double least_pressure = 0.0;
    double most_pressure = 0.0;
    double deflection = 0.0;
    double load = 0.0;  ///< at the largest deflection
    double time = 0.0;
};

Seen look_at(const solver::Problem& problem) {
    std::vector<double> times{problem.settings.start};
    times.insert(times.end(), problem.input_signals.stops().begin(), problem.input_signals.stops().end());
    times.insert(times.end(), problem.input_signals.samples().begin(), problem.input_signals.samples().end());
    Seen seen;
    bool first = true;
    for (const double t : times) {
        for (const solver::JumpSide side : {solver::JumpSide::before, solver::JumpSide::after}) {
            const physics::Inputs in = problem.input_signals.at(t, side);
            const double p = in.inflation_pressure;
            seen.least_pressure = first ? p : std::min(seen.least_pressure, p);
            seen.most_pressure = first ? p : std::max(seen.most_pressure, p);
            first = false;
            const double deflection =
                problem.tire.touches(in.vertical_load) ? problem.tire.unloaded_radius - problem.tire.loaded_radius(in)
                                                       : 0.0;
            if (deflection > seen.deflection) {
                seen.deflection = deflection;
                seen.load = in.vertical_load;
                seen.time = t;
            }
        }
    }
    return seen;
}

}  // namespace

void settle_tire(TomlTable& root, ProblemBuilder& builder) {
    InputErrors& errors = root.errors();
    if (builder.given.contains("slip_ratio") && builder.given.contains("slip_speed")) {
        errors.add(builder.given.find("slip_speed")->second, "slip_ratio and slip_speed are both given",
                   "keep one: both are the slip along the heading");
    }
    const auto pressure = builder.given.find("inflation_pressure");
    physics::Tire& tire = builder.problem.tire;
    if (!builder.has_tire || pressure == builder.given.end()) {
        tire.reference_pressure = 0.0;
        if (!builder.has_tire) {
            return;
        }
    }
    const Seen seen = look_at(builder.problem);
    if (tire.reference_pressure > 0.0 && (seen.least_pressure < least_pressure * tire.reference_pressure ||
                                          seen.most_pressure > most_pressure * tire.reference_pressure)) {
        const bool low = seen.least_pressure < least_pressure * tire.reference_pressure;
        errors.warn(pressure->second,
                    fmt::format("the inflation pressure is {:.4g} kPa, and the tire's laws hold at {:.4g} kPa: how they "
                                "follow the pressure is known from {:.4g} to {:.4g} kPa",
                                1e-3 * (low ? seen.least_pressure : seen.most_pressure), 1e-3 * tire.reference_pressure,
                                1e-3 * least_pressure * tire.reference_pressure,
                                1e-3 * most_pressure * tire.reference_pressure));
    }
    if (seen.deflection > most_deflection * tire.section_height) {
        const auto load = builder.given.find("vertical_load");
        errors.warn(load != builder.given.end() ? load->second : root.place("drive"),
                    fmt::format("{:.4g} N at {:.4g} s deflect the tire by {:.1f} mm, {:.0f} % of its section's height: "
                                "the laws of the load know no more than {:.0f} %",
                                seen.load, seen.time, 1e3 * seen.deflection,
                                100.0 * seen.deflection / tire.section_height, 100.0 * most_deflection));
    }
}

}  // namespace tiretherm::input
