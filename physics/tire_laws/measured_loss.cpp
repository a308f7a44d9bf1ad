// SPDX-License-Identifier: BSD-3-Clause
// Multilinear interpolation on the full grid of a drum test, held beyond its ends, or the coast-down regression in the
// units of its fit.

#include "physics/tire_laws/measured_loss.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tiretherm::physics {

namespace {

/// The cell of an axis that holds a value, and how far it lies towards the cell's upper end.
struct Spot {
    std::size_t cell = 0;
    double share = 0.0;
};

Spot spot_on(const std::vector<double>& at, double x) {
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(at, x) - at.begin());
    if (next == 0 || next == at.size()) {
        return {.cell = next == 0 ? 0 : next - 1, .share = 0.0};
    }
    return {.cell = next - 1, .share = (x - at[next - 1]) / (at[next] - at[next - 1])};
}

}  // namespace

double ResistanceTable::value(const Inputs& inputs, double bulk) const {
    double sum = 0.0;
    const std::size_t corners = std::size_t{1} << axes.size();
    for (std::size_t corner = 0; corner < corners; ++corner) {
        double weight = 1.0;
        std::size_t index = 0;
        for (std::size_t a = 0; a < axes.size(); ++a) {
            const Axis& axis = axes[a];
            const Spot spot = spot_on(axis.at, axis.input != nullptr ? inputs.*axis.input : bulk);
            const bool upper = (corner >> a & 1U) != 0;
            weight *= upper ? spot.share : 1.0 - spot.share;
            index = index * axis.at.size() + std::min(spot.cell + (upper ? 1 : 0), axis.at.size() - 1);
        }
        sum += weight > 0.0 ? weight * force[index] : 0.0;
    }
    return sum;
}

double MeasuredLoss::power(const Inputs& inputs, double bulk) const {
    const double speed = std::abs(rolling_speed(inputs));
    if (!coastdown) {
        Inputs forwards = inputs;
        forwards.speed = speed;
        return speed * table.value(forwards, bulk);
    }
    const CoastdownFit& fit = *coastdown;
    const double force = fit.law.force(inputs.inflation_pressure / fit.pressure_unit,
                                       inputs.vertical_load / fit.load_unit, speed / fit.speed_unit);
    return speed * std::max(0.0, force * fit.force_unit);
}

}  // namespace tiretherm::physics
