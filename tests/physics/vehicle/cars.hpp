// SPDX-License-Identifier: BSD-3-Clause
// A made-up car with round numbers, for the tests of [vehicle].
#pragma once

#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::physics {

/// 1200 kg, L = 2.5 m, a = 1.4 m, b = 1.1 m, h = 0.5 m, tracks 1.5 m, 60 % of the roll stiffness in front, rear drive.
inline Vehicle round_car() {
    Vehicle car{.mass = 1200.0, .cg_height = 0.5, .yaw_inertia = 1800.0};
    car.axles[0] = {.distance = 1.4, .track = 1.5, .roll_stiffness_share = 0.6, .brake_share = 0.65};
    car.axles[1] = {
        .distance = 1.1, .track = 1.5, .roll_stiffness_share = 0.4, .drive_share = 1.0, .brake_share = 0.35};
    for (Axle& axle : car.axles) {
        axle.tire = {.cornering_stiffness = 80e3, .slip_stiffness = 90e3, .friction = 1.1};
    }
    return car;
}

/// A Magic Formula with the size of a car tire's: friction 1.05, falling with the load; pKy1 < 0 as in most files.
inline MagicFormula made_up_formula() {
    MagicFormula law;
    law.nominal_load = 4000.0;
    law.pCx1 = 1.6;
    law.pDx1 = 1.1;
    law.pDx2 = -0.08;
    law.pEx1 = 0.1;
    law.pKx1 = 22.0;
    law.pCy1 = 1.3;
    law.pDy1 = 1.05;
    law.pDy2 = -0.1;
    law.pEy1 = -0.8;
    law.pEy3 = 0.1;
    law.pKy1 = -18.0;
    law.pKy2 = 1.5;
    law.pHy1 = 0.002;
    law.pVy1 = 0.01;
    return law;
}

}  // namespace tiretherm::physics
