// SPDX-License-Identifier: BSD-3-Clause
// Compares the sign of a correlation with the one that is stated.

#include "input/vehicle/turn_signs.hpp"

#include <cmath>

#include <fmt/format.h>

namespace tiretherm::input {

std::string_view turns(TurnSign sign) { return sign == TurnSign::right ? "right" : "left"; }

Settled settle_sign(std::string_view name, TurnSign stated, double r, const Witness& beside) {
    const TurnSign seen = r < 0.0 ? TurnSign::right : TurnSign::left;
    const bool is_open = stated == TurnSign::automatic;
    if (is_open && beside.is_sure) {
        return {.sign = seen,
                .agrees = 1.0,
                .sentence = fmt::format("{} is taken as positive in {} turns: its correlation with {} is {:.2f}", name,
                                        turns(seen), beside.told.name, r)};
    }
    const TurnSign taken = is_open ? TurnSign::left : stated;
    if (seen == taken) {
        return {.sign = stated, .agrees = 1.0};
    }
    return {
        .sign = stated,
        .agrees = -1.0,
        .sentence =
            beside.is_course
                ? fmt::format("left and right are exchanged: {}_sign says positive in {} turns, and beside {} it is "
                              "positive in {} "
                              "ones (r = {:.2f}): turn the signs of lateral_acceleration, yaw_rate and steering round",
                              name, turns(taken), beside.told.name, turns(seen), r)
                : fmt::format("{}, positive in {} turns, and {} contradict each other (r = {:.2f}): one of {}_sign and "
                              "steering_sign is wrong",
                              name, turns(taken), beside.told.name, -std::abs(r), name)};
}

}  // namespace tiretherm::input
