// SPDX-License-Identifier: BSD-3-Clause
// Made-up contact fields of cases/contact_fields: nine ribs, each a brush model, cornering at 100 km/h.
#pragma once

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "physics/tire_laws/brush.hpp"
#include "post/fields/hdf5_file.hpp"

/// The made-up fields of cases/contact_fields: nine ribs, each a brush of its own, that corner at 100 km/h.
namespace tiretherm::input::brush_fields {

/// Columns of one length with their units, as the format wants them.
struct Columns {
    std::vector<std::pair<std::string, std::string>> heads;  ///< name, unit
    std::vector<std::vector<double>> values;                 ///< [heads][rows]

    explicit Columns(std::vector<std::pair<std::string, std::string>> names)
        : heads(std::move(names)), values(heads.size()) {}
    void row(const std::vector<double>& numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            // Six digits are what a text shows; both dialects hold the same numbers.
            values[i].push_back(std::stod(fmt::format("{:.6g}", numbers[i])));
        }
    }
    [[nodiscard]] std::string csv() const {
        std::string text;
        for (std::size_t i = 0; i < heads.size(); ++i) {
            text += fmt::format("{}{} [{}]", i > 0 ? "," : "", heads[i].first, heads[i].second);
        }
        for (std::size_t row = 0; row < values.front().size(); ++row) {
            for (std::size_t i = 0; i < heads.size(); ++i) {
                text += fmt::format("{}{:.6g}", i > 0 ? "," : "\n", values[i][row]);
            }
        }
        return text + "\n";
    }
    void write_hdf5(const std::filesystem::path& path) const {
        post::Hdf5File file(path);
        for (std::size_t i = 0; i < heads.size(); ++i) {
            file.write("/" + heads[i].first, values[i], 0,
                       {.units = heads[i].second, .long_name = "", .source = "", .coordinates = ""});
        }
    }
};

inline constexpr int ribs = 9;
inline constexpr double rib_width = 0.020;    // m
inline constexpr double rolling = 100 / 3.6;  // m/s
inline constexpr double longest = 0.060;      // m, half the contact of the middle rib at 4000 N

/// The rib at y, m: cornering loads the outside (negative y); the contact is shorter towards the edges.
inline physics::Brush rib(double y) {
    const double part = y / (0.5 * ribs * rib_width);
    return {.half_length = longest * std::sqrt(1.0 - 0.5 * part * part),
            .tread_stiffness = 6.0e7 / ribs / 4.0,
            .friction = 1.0,
            .load = 4000.0 / ribs * (1.0 - 0.5 * part)};
}

inline double middle_of(int j) { return (j - 0.5 * (ribs - 1)) * rib_width; }

/// Pressure, speed of sliding and shear stress where the rib slides, along the contact.
struct State {
    double pressure = 0.0;  ///< Pa
    double sliding = 0.0;   ///< m/s
    double shear = 0.0;     ///< Pa
};
inline State state(const physics::Brush& brush, double x, double slip) {
    const double a = brush.half_length;
    if (std::abs(x) >= a) {
        return {};
    }
    const double line = 0.75 * brush.load / a * (1.0 - x * x / (a * a));  // N/m, q
    const double rise = -1.5 * brush.load * x / (a * a * a);              // dq/dx
    const bool slides = x < brush.adhesion_end(slip);
    const double shear = slides ? brush.friction * line : brush.tread_stiffness * slip * (a - x);
    const double sliding = slides ? rolling * std::abs(slip + brush.friction * rise / brush.tread_stiffness) : 0.0;
    return {line / rib_width, sliding, shear / rib_width};
}

/// The contact at a slip, x by y; against time where that is given. m, Pa, m/s in mm, kPa, m/s
inline void add_contact(Columns& into, double slip, const std::vector<double>& before = {}) {
    for (int j = 0; j < ribs; ++j) {
        for (int i = 0; i <= 24; ++i) {
            const double x = 0.005 * (i - 12);
            const State s = state(rib(middle_of(j)), x, slip);
            std::vector<double> row = before;
            for (const double v : {1e3 * x, 1e3 * middle_of(j), 1e-3 * s.pressure, s.sliding, 1e-3 * s.shear}) {
                row.push_back(v);
            }
            into.row(row);
        }
    }
}

/// At a slip angle of 4 degrees.
inline Columns contact() {
    Columns columns(
        {{"x", "mm"}, {"y", "mm"}, {"pressure", "kPa"}, {"sliding_velocity", "m/s"}, {"shear_stress", "kPa"}});
    add_contact(columns, std::tan(4.0 * std::numbers::pi / 180.0));
    return columns;
}

/// The slip angle grows from 0 to 6 degrees in 60 s, a frame every 10 s.
inline Columns ramp() {
    Columns columns({{"time", "s"},
                     {"x", "mm"},
                     {"y", "mm"},
                     {"pressure", "kPa"},
                     {"sliding_velocity", "m/s"},
                     {"shear_stress", "kPa"}});
    for (int k = 0; k <= 6; ++k) {
        add_contact(columns, std::tan(k * std::numbers::pi / 180.0), {10.0 * k});
    }
    return columns;
}

/// Power lost against the wheel angle: a tenth of the compression's power, 3e5 W/m3 where the tread is pressed by 300 kPa,
/// half of that 10 mm deep; and a little all the way round.
inline Columns loss() {
    Columns columns({{"wheel_angle", "deg"}, {"y", "mm"}, {"depth", "mm"}, {"loss_density", "W/m3"}});
    for (int k = 0; k < 36; ++k) {
        const double angle = 10.0 * k;  // 180: in the middle of the contact
        for (int j = 0; j < ribs; ++j) {
            const double x = 0.3308 * std::sin((angle - 180.0) * std::numbers::pi / 180.0);
            const double pressure = std::abs(angle - 180.0) < 45.0 ? state(rib(middle_of(j)), x, 0.0).pressure : 0.0;
            for (const double depth : {0.001, 0.005, 0.009}) {
                columns.row({angle, 1e3 * middle_of(j), 1e3 * depth, (2e4 + pressure) * (1.0 - 50.0 * depth)});
            }
        }
    }
    return columns;
}

}  // namespace tiretherm::input::brush_fields
