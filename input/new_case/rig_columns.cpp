// SPDX-License-Identifier: BSD-3-Clause
// Table of a test machine's symbols; signs are judged by the data.
#include "input/new_case/rig_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"
#include "input/loggers/logger_units.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array symbols{
#define RIG_SYMBOL(symbol, name) RigColumn{symbol, name},
#include "input/text/column_names.list"
};
constexpr std::ptrdiff_t fewest_symbols = 5;
constexpr double leans = 0.3;  ///< correlation of the inclination with the hotter shoulder that tells its side

void turn(LogColumn& column, std::string_view si, std::string ground) {
    const std::string written = column.unit.empty() ? column.heading.unit.value_or("") : column.unit;
    column.unit = fmt::format("{}{}", turned_sign, meant_unit(written, si));
    column.unit_ground = std::move(ground);
    std::ranges::for_each(column.value, [](double& value) { value = -value; });
}

}  // namespace

const RigColumn* find_rig_column(std::string_view heading) {
    const auto found = std::ranges::find(symbols, bare_name(heading), &RigColumn::symbol);
    return found == symbols.end() ? nullptr : &*found;
}

bool is_rig_file(const std::vector<LogColumn>& columns) {
    const auto is_load = [](const LogColumn& column) { return bare_name(column.heading.name) == "fz"; };
    const auto is_known = [](const LogColumn& column) { return find_rig_column(column.heading.name) != nullptr; };
    return std::ranges::any_of(columns, is_load) && std::ranges::count_if(columns, is_known) >= fewest_symbols;
}

void turn_signs(Log& log) {
    const LogColumn* inside = log.find("inside_shoulder_surface_temperature");
    const LogColumn* outside = log.find("outside_shoulder_surface_temperature");
    for (LogColumn& column : log.columns) {
        if (column.unit_is_given) {
            continue;
        }
        if (column.name == "vertical_load") {
            double sum = 0.0;
            std::ranges::for_each(column.value, [&](double value) { sum += std::isnan(value) ? 0.0 : value; });
            if (sum < 0.0) {
                turn(column, "N", "negative where the road presses, as in SAE J670");
            }
        } else if (column.name == "camber" && !log.is_car && inside != nullptr && outside != nullptr) {
            std::vector<double> excess(inside->value.size());
            std::ranges::transform(inside->value, outside->value, excess.begin(), std::minus{});
            if (correlation(column.value, excess) > leans) {
                turn(column, "rad",
                     fmt::format("where it is positive {} is the hotter shoulder", inside->heading.name));
            }
        }
    }
}

}  // namespace tiretherm::input
