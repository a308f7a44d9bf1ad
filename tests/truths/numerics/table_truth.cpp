// SPDX-License-Identifier: BSD-3-Clause
// Writes columns as CSV, and converts the bench's values to the units of a log.

#include "numerics/table_truth.hpp"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace hidden_effects {

namespace {

/// scale x + shift, of every value.
std::vector<double> converted(std::vector<double> x, double scale, double shift = 0.0) {
    for (double& value : x) {
        value = scale * value + shift;
    }
    return x;
}

}  // namespace

std::string written(const std::vector<Column>& columns) {
    std::ostringstream out;
    out << std::fixed;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        out << (c > 0 ? "," : "") << columns[c].heading;
    }
    out << '\n';
    for (std::size_t row = 0; row < columns.front().value.size(); ++row) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const double unit = std::pow(10.0, -columns[c].digits);
            double value = std::round(columns[c].value[row] / unit) * unit;
            value = value == 0.0 ? 0.0 : value;  // no minus before a zero
            out << (c > 0 ? "," : "") << std::setprecision(columns[c].digits) << value;
        }
        out << '\n';
    }
    return out.str();
}

void write(const std::filesystem::path& file, const std::vector<Column>& columns) {
    std::ofstream out(file, std::ios::binary);
    out << written(columns);
    out.close();
    if (!out) {
        throw std::runtime_error("cannot write " + file.string());
    }
}

std::vector<Column> bench_columns(const Programme& programme, const BenchTrace& trace) {
    constexpr double celsius = -273.15;
    return {{"time [s]", 0, programme.time},
            {"speed [km/h]", 2, converted(programme.speed, 3.6)},
            {"vertical_load [N]", 1, programme.vertical_load},
            {"slip_angle [deg]", 4, converted(programme.slip_angle, 180.0 / std::numbers::pi)},
            {"lateral_force [N]", 1, programme.lateral_force},
            {"air_temperature [degC]", 1, converted(programme.air_temperature, 1.0, celsius)},
            {"road_temperature [degC]", 1, converted(programme.road_temperature, 1.0, celsius)},
            {"throttle [-]", 3, programme.throttle},
            {"surface_temperature [degC]", 2, converted(trace.surface, 1.0, celsius)},
            {"bulk_temperature [degC]", 2, converted(trace.bulk, 1.0, celsius)}};
}

}  // namespace hidden_effects
