// SPDX-License-Identifier: BSD-3-Clause
// Chooses between measured table, moduli and property file, and between property file and the curve through a peak.

#include "physics/tire_laws/handling.hpp"

#include <cmath>

namespace tiretherm::physics {

double Handling::stiffness_of_file(const Inputs& inputs) const {
    return std::abs(magic_formula->cornering_stiffness(inputs.vertical_load, inputs.camber, inputs.inflation_pressure));
}

double Handling::cornering_stiffness(const Tire& tire, const Inputs& inputs, double T_bulk) const {
    const double load = tire.reference_load(inputs);
    if (stiffness_table) {
        // A table that knows no pressure is that at the pressure where the laws of the load hold.
        Inputs at = inputs;
        at.vertical_load = stiffness_table->find(&Inputs::inflation_pressure) != nullptr ? inputs.vertical_load : load;
        return tire.touches(inputs.vertical_load) ? lambda_CP * stiffness_table->value(at, T_bulk) : 0.0;
    }
    const auto by_moduli = [&](double T) { return physics::cornering_stiffness(modulus, tire, load, T).value; };
    const double CP = lambda_CP * by_moduli(T_bulk);
    if (!magic_formula || replaces_stiffness || CP == 0.0) {
        return CP;
    }
    return stiffness_of_file(inputs) * CP / by_moduli(reference_temperature);
}

PureSlip Handling::lateral(const Tire& tire, const Inputs& inputs, double T_bulk, double friction) const {
    const double CP = cornering_stiffness(tire, inputs, T_bulk);
    if (magic_formula) {
        const double lambda_Tb = bulk_temperature_factor(CP, stiffness_of_file(inputs));
        return magic_formula->lateral(side_slip(inputs), lambda_Tb, friction);
    }
    return peak_curve->force(inputs.vertical_load, CP, inputs.slip_angle, friction);
}

PureSlipState side_slip(const Inputs& inputs) {
    return {.load = inputs.vertical_load,
            .slip = inputs.slip_angle,
            .camber = inputs.camber,
            .speed = inputs.speed,
            .sliding_speed = std::abs(inputs.speed * std::tan(inputs.slip_angle)),
            .pressure = inputs.inflation_pressure};
}

}  // namespace tiretherm::physics
