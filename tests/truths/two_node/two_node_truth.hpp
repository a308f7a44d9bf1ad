// SPDX-License-Identifier: BSD-3-Clause
// Independent truth of the two-node bench, cases/practice/README.md, by Dormand and Prince's method of order 5(4).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "two_node/programme_truth.hpp"

namespace hidden_effects {

/// Something that the bench does and the model does not: its id in the catalogue of effects with its parameters in the
/// catalogue's units, and the channel of a sensor's effect. Not in the catalogue: unknown_surface and unknown_bulk,
/// `watts` times the throttle.
struct Cause {
    std::string id;
    std::map<std::string, double> parameters;
    std::string channel{};
};

/// A tire on the bench of two nodes, cases/practice/README.md: the scales that its user does not know, its temperatures
/// at the start, and what else is going on.
struct Bench {
    double lambda_h = 1.0;          ///< scale of air convection
    double lambda_sel = 1.0;        ///< scale of the strain-energy loss
    double surface_start = 296.15;  ///< K
    double bulk_start = 296.15;     ///< K
    std::vector<Cause> causes{};
};

/// What the sensors give at the programme's times, without noise. K
struct BenchTrace {
    std::vector<double> surface;
    std::vector<double> bulk;
};

/// Integrates the bench over a programme by Dormand and Prince's pair of order 5(4), stopping at every sample and at
/// every switch of the inputs between two samples.
/// @param tolerance K, local error of a step
/// @errors std::invalid_argument names a cause, a parameter or a channel that is not known
[[nodiscard]] BenchTrace drive_bench(const Bench& bench, const Programme& programme, double tolerance = 1e-9);

}  // namespace hidden_effects
