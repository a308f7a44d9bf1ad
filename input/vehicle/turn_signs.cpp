// SPDX-License-Identifier: BSD-3-Clause
// Compares the sign of a correlation with the one that is stated.

#include "input/vehicle/turn_signs.hpp"

#include <cmath>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"

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

std::optional<ErrorText> wrong_size(std::string_view name, const std::vector<double>& acceleration,
                                    const std::vector<double>& expected, std::string_view what, double least) {
    constexpr double alike = 0.8;  // correlation from which the ratio means something
    constexpr double most = 2.0;
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        products += acceleration[i] * expected[i];
        squares += expected[i] * expected[i];
    }
    const double ratio = squares > 0.0 ? std::abs(products / squares) : 1.0;
    if (std::abs(correlation(acceleration, expected)) < alike || (ratio < most && ratio > least)) {
        return std::nullopt;
    }
    return ErrorText{
        .what = fmt::format("{} is {:.3g} times {}", name, ratio, what),
        .remedy = fmt::format(
            "correct the unit of the column, as in units = {{ COLUMN = \"g\" }}, or that of {}: a g is 9.81 m/s2",
            what),
        .about = std::string(name)};
}

}  // namespace tiretherm::input
