// SPDX-License-Identifier: BSD-3-Clause
// Independent truth of the section bench, cases/practice/section_bench.md: parameters, hidden causes and noise-free
// sensors.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "section/section_programme_truth.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

/// The sensors of the bench, in the order of SectionTrace::channel.
inline constexpr std::array<std::string_view, 5> section_channels{
    "surface_temperature", "outside_shoulder_bulk_temperature", "inside_shoulder_bulk_temperature",
    "inner_liner_temperature", "gas_temperature"};

/// The sensors of the bench of layers.
inline constexpr std::array<std::string_view, 3> layers_channels{"surface_temperature", "bulk_temperature",
                                                                 "inner_liner_temperature"};

/// A tire's section on the bench of cases/practice/section_bench.md: the scales that its user does not know, its
/// temperature at the start, and what else is going on. A cause on one layer names it ("tread", "carcass") as its
/// channel. Not in the catalogue: unknown_inside_shoulder.watts (on the surface), unknown_crown.watts (in the crown's
/// volume) and unknown_surface.watts (on the tread), each times the throttle, and unknown_inside_sidewall.conductance, W/K to the air.
struct SectionBench {
    double lambda_h = 1.0;    ///< scale of air convection
    double lambda_sel = 1.0;  ///< scale of the strain-energy loss
    double start = 296.15;    ///< K, of all rubber
    double gas_start = 0.0;   ///< K; 0: the first air temperature
    std::vector<Cause> causes{};
};

/// How finely the truth is computed.
struct SectionResolution {
    int refinement = 1;       ///< 1: 22 x 6 biquadratic elements; 2: twice as many each way
    double tolerance = 1e-4;  ///< K, local error of a step
};

/// What the sensors give at the programme's times, without noise. [channel][sample] K
struct SectionTrace {
    std::vector<std::vector<double>> channel{};
    int n_steps = 0;
};

/// Biquadratic finite elements over arc length and depth, RODAS in time, which stops at every sample and at every switch
/// of the inputs between two samples.
/// @errors std::invalid_argument names a cause, a parameter or a channel that is not known
[[nodiscard]] SectionTrace drive_section(const SectionBench& bench, const SectionProgramme& programme,
                                         const SectionResolution& resolution = {});

/// The crown band alone, cases/practice/section_bench.md: no sidewalls, no gas, and the programme's camber counts for
/// nothing.
[[nodiscard]] SectionTrace drive_layers(const SectionBench& bench, const SectionProgramme& programme,
                                        const SectionResolution& resolution = {});

}  // namespace hidden_effects
