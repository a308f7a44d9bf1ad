// SPDX-License-Identifier: BSD-3-Clause
// [vehicle], [data] and the list [[corner]] of a new case whose log is that of a car.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/new_case/case_tables.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/vehicle/vehicle.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

/// A value of a car that no log gives: of a sports car with one person in it.
struct CarValue {
    std::string_view key;
    std::string_view value;
    std::string_view ground;
};
constexpr std::array car_values{
    CarValue{"mass", "1350 kg", "a sports car; a scale tells, and each axle's share too"},
    CarValue{"wheelbase", "2.6 m", "a sports car; its papers tell"},
    CarValue{"front_weight_share", "0.5", "even; a scale tells"},
    CarValue{"centre_of_gravity_height", "0.48 m", "a sports car"},
    CarValue{"front_track", "1.55 m", "a sports car; its papers tell"},
    CarValue{"front_roll_stiffness_share", "0.55", "a little more in front, as most cars have"},
    CarValue{"drag_area", "0.7 m2", "a car of 2 m2 and 0.35"},
    CarValue{"driven_axle", "rear", "a sports car"},
    CarValue{"front_brake_share", "0.65", "two thirds in front, as most cars have"}};

// Cornering stiffness of a passenger car's tire over its load: 6 to 30 per radian, and the slip stiffness is the larger one
// (Pacejka, Tire and Vehicle Dynamics, chapter 1).
constexpr double cornering_over_load = 15.0;  // 1/rad
constexpr double slip_over_load = 20.0;
constexpr double static_load = 1350.0 * physics::standard_gravity / 4.0;  // N, of the values above
constexpr double friction_margin = 1.1;
constexpr double usual_friction = 1.1;
constexpr double hardest_share = 0.995;  // of the samples below: single peaks are knocks

/// The acceleration in the plane that the car hardly ever exceeds, over that of gravity; 0: the log has none.
double hardest_turn(const Log& log) {
    const LogColumn* lateral = log.find("lateral_acceleration");
    const LogColumn* along = log.find("longitudinal_acceleration");
    std::vector<double> size;
    for (std::size_t i = 0; i < log.time.size(); ++i) {
        const auto of = [i](const LogColumn* column) {
            return column != nullptr && std::isfinite(column->value[i]) ? column->value[i] : 0.0;
        };
        size.push_back(std::hypot(of(lateral), of(along)) / physics::standard_gravity);
    }
    const auto at = static_cast<std::size_t>(hardest_share * static_cast<double>(size.size() - 1));
    return solver::nth_smallest(std::move(size), at);
}

void write_tires(CaseDraft& draft, const Log& log) {
    const auto assume_both = [&](std::string_view key, double over_load, std::string_view unit) {
        const std::string value = fmt::format("{:g} {}", std::round(over_load * static_load / 1e3), unit);
        for (const std::string_view axle : {"front", "rear"}) {
            draft.assume_entry(fmt::format("{}_{}", axle, key), value,
                               fmt::format("{:g} times the load at rest", over_load));
        }
    };
    assume_both("cornering_stiffness", cornering_over_load, "kN/rad");
    assume_both("slip_stiffness", slip_over_load, "kN");
    const double hardest = hardest_turn(log);
    const bool slow = friction_margin * hardest < usual_friction;
    draft.assume_entry(
        "friction", fmt::format("{:.2f}", slow ? usual_friction : friction_margin * hardest),
        slow ? "a dry road" : fmt::format("a tenth above the log's hardest turns and stops, {:.2f} g", hardest));
    draft.writer.suggestion("property_file", "tire.tir", "in the place of stiffnesses and friction");
}

void write_corner(CaseDraft& draft, const Log& log, const std::string& corner) {
    CaseWriter& writer = draft.writer;
    writer.table("corner");
    writer.entry("name", corner);
    if (draft.mesh.name == "section") {
        writer.suggestion("drive", "{ camber = \"-2 deg\" }", "negative: the top leans inboard");
    }
    write_columns(writer, log, "corner", corner);
}

}  // namespace

void write_vehicle(CaseDraft& draft) {
    const Log* log = draft.log();
    if (log == nullptr || !log->is_car || !log->has_motion()) {
        return;
    }
    CaseWriter& writer = draft.writer;
    writer.table("vehicle", "gives each tire its load, forces and slips: replace what is assumed");
    if (log->corners().empty()) {
        draft.assume_entry("corner", "FL", "the log does not say whose temperatures it has");
    }
    for (const CarValue& value : car_values) {
        draft.assume_entry(value.key, std::string(value.value), std::string(value.ground));
    }
    // Steering alone tells how a car turns only with the ratio of its steering.
    const bool has_turns =
        log->has_course || draft.column("lateral_acceleration") != nullptr || draft.column("yaw_rate") != nullptr;
    if (!has_turns) {
        draft.assume_entry("steering_ratio", "15", "a sports car");
    }
    write_tires(draft, *log);
    writer.suggestion("downforce_area", "0.5 m2", "-C_L A, with front_downforce_share = 0.45");
    writer.remark(
        "Left and right are exchanged where both signs are wrong. SAE J670 has both positive in right turns.");
    writer.suggestion("yaw_rate_sign", "right");
    writer.suggestion("lateral_acceleration_sign", "right");
}

void write_car_columns(CaseDraft& draft, const Log& log) {
    write_columns(draft.writer, log, "data", "");
    for (const std::string& corner : log.corners()) {
        write_corner(draft, log, corner);
    }
    suggest_corners(draft, log);
}

void suggest_corners(CaseDraft& draft, const Log& log) {
    const std::vector<std::string> known = log.corners();
    for (const std::string_view corner : physics::corner_names) {
        if (std::ranges::find(known, corner) != known.end()) {
            continue;
        }
        std::string columns;
        for (const LogColumn& column : log.columns) {
            if (column.corner == corner && !column.is_used() && !column.suggestion.empty()) {
                columns += fmt::format("{}{} = {}", columns.empty() ? "" : ", ", toml_text::key(column.heading.name),
                                       toml_text::in_quotes(column.suggestion));
            }
        }
        if (!columns.empty()) {
            draft.writer.caption("Which of these is what the tire reads? Keep it, and take the # away.");
            draft.writer.comment_out(true);
            draft.writer.table("corner");
            draft.writer.entry("name", corner);
            draft.writer.entry("columns", fmt::format("{{ {} }}", columns));
            draft.writer.comment_out(false);
        }
    }
}

bool all_have(const Log& log, std::string_view sensor) {
    const std::vector<std::string> corners = log.corners();
    return !corners.empty() && std::ranges::all_of(corners, [&](const std::string& corner) {
        return std::ranges::any_of(log.columns, [&](const LogColumn& column) {
            return column.name == sensor && column.corner == corner && column.first_value();
        });
    });
}

std::string first_sensor_of_all(const Log& log) {
    constexpr std::array<std::string_view, 7> names{"bulk_temperature",
                                                    "surface_temperature",
                                                    "crown_surface_temperature",
                                                    "inside_shoulder_surface_temperature",
                                                    "outside_shoulder_surface_temperature",
                                                    "infrared_1",
                                                    "gas_temperature"};
    const auto found = std::ranges::find_if(names, [&](std::string_view name) { return all_have(log, name); });
    return found == names.end() ? "" : *found == "infrared_1" ? "infrared" : std::string(*found);
}

std::string shown_laps(const Log& log) {
    const auto is_flying = [](const Lap& lap) { return lap.kind == LapKind::flying; };
    const auto first = std::ranges::find_if(log.laps.laps, is_flying);
    if (first == log.laps.laps.end()) {
        return {};
    }
    const auto count = std::ranges::count_if(log.laps.laps, is_flying);
    const int last = first->number + static_cast<int>(count) - 1;
    return count == 1 ? fmt::format("{}", first->number) : fmt::format("{}-{}", first->number, last);
}

}  // namespace tiretherm::input
