// SPDX-License-Identifier: BSD-3-Clause
// Names and meanings of driving phases; diagnosis/compare/phase.cpp has the thresholds that they state.
#include "post/report/phase_text.hpp"

namespace tiretherm::post {

using diagnosis::Phase;

std::string_view name_of(Phase phase) {
    switch (phase) {
        case Phase::standing:
            return "standing";
        case Phase::slipping:
            return "slipping";
        case Phase::slowing:
            return "slowing";
        case Phase::free_rolling:
            return "free rolling";
        case Phase::cornering:
            return "cornering";
        case Phase::braking:
            return "braking";
        case Phase::driving:
            return "driving";
        case Phase::straight:
            return "straight";
    }
    return "";
}

std::string_view meaning_of(Phase phase) {
    switch (phase) {
        case Phase::standing:
            return "speed below 0.1 m/s";
        case Phase::slipping:
            return "slip angle from 0.3 deg or slip ratio from 0.5 % on";
        case Phase::slowing:
            return "straight, speed falling faster than 0.01 g";
        case Phase::free_rolling:
            return "straight, speed steady or rising";
        case Phase::cornering:
            return "forces from 15 % of the load on, mostly lateral";
        case Phase::braking:
            return "forces from 15 % of the load on, mostly of braking";
        case Phase::driving:
            return "forces from 15 % of the load on, mostly of driving";
        case Phase::straight:
            return "forces below 15 % of the load";
    }
    return "";
}

}  // namespace tiretherm::post
