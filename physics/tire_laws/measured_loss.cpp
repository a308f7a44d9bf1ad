// SPDX-License-Identifier: BSD-3-Clause
// Force of the drum's table, or of the coast-down regression in the units of its fit, times the speed.

#include "physics/tire_laws/measured_loss.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::physics {

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
