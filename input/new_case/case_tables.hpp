// SPDX-License-Identifier: BSD-3-Clause
// The tables of a new case, a function for each.
#pragma once

#include <fmt/format.h>

#include "input/case_text/case_writer.hpp"
#include "input/new_case/new_case.hpp"
#include "physics/tire_laws/scaled_tire.hpp"

namespace tiretherm::input {

/// What every table of the case is written from, and what is noted on the way.
struct CaseDraft {
    const NewCaseRequest& request;
    MeshTemplate mesh;
    double tread_thickness = 0.0;     ///< m
    double sidewall_thickness = 0.0;  ///< m
    double inflation_pressure = 0.0;  ///< Pa above the atmosphere
    std::string pressure_ground{};    ///< where it is from; empty: given, or that of the thesis's tire
    NewCase& result;                  ///< its log, and what is assumed and missing
    CaseWriter writer{};
    InputErrors errors{};  ///< of the log, whose table the case is checked with

    [[nodiscard]] bool is_specimen() const { return mesh.name == specimen_mesh; }
    [[nodiscard]] const Log* log() const { return result.log ? &*result.log : nullptr; }
    [[nodiscard]] physics::TireOutline outline() const {
        return {.width = request.size.width,
                .section_height = request.size.section_height,
                .rim_diameter = request.size.rim_diameter,
                .inflation_pressure = inflation_pressure};
    }
    /// The column that the case takes for an input or a sensor; null: none.
    [[nodiscard]] const LogColumn* column(std::string_view name) const {
        return log() != nullptr && log()->use != LogUse::nothing ? log()->find(name) : nullptr;
    }
    void assume(std::string key, std::string value, std::string reason) const {
        result.assumed.push_back({std::move(key), std::move(value), std::move(reason)});
    }
    /// Writes an entry of the current table: what it means, and on what ground it is assumed, as noted.
    /// @param lacking why nothing better is known, with "; " at its end
    void assume_entry(std::string_view key, const std::string& value, const std::string& ground,
                      const std::string& lacking = "") {
        const std::string meaning = writer.meaning(key);
        writer.entry(key, value,
                     fmt::format("{}{}{}assumed: {}", meaning, meaning.empty() ? "" : "; ", lacking, ground));
        assume(fmt::format("{}.{}", writer.path(), key), value, lacking + ground);
    }
};

/// [tire]: dimensions and laws of the load, scaled from the thesis's tire.
void write_tire(CaseDraft& draft);
/// [mesh], [[mesh.layer]] and [[material]] of the library's case, tread and sidewall as thick as the tire's.
void write_mesh(CaseDraft& draft);
/// [effects.NAME]: the numbers that users adjust, at the values of the catalogue.
void write_effects(CaseDraft& draft);
/// [drive], [initial] and [time]: constants, or what the log says.
void write_drive(CaseDraft& draft);
void write_initial(CaseDraft& draft);
void write_time(CaseDraft& draft);
/// [vehicle] where the log says how a car moves: values of a usual car, each of them assumed.
void write_vehicle(CaseDraft& draft);
/// [data] with the columns of a car, and a [[corner]] for each tire of which there is something.
void write_car_columns(CaseDraft& draft, const Log& log);
/// Behind a #: corners of which nothing is known yet but columns that the user must tell apart.
void suggest_corners(CaseDraft& draft, const Log& log);
/// Whether every corner of the log has readings of a sensor.
[[nodiscard]] bool all_have(const Log& log, std::string_view sensor);
/// A sensor that every corner of the log has, of the inside before the surface; empty: none.
[[nodiscard]] std::string first_sensor_of_all(const Log& log);
/// The whole laps of a log, "1-8"; empty: none are known.
[[nodiscard]] std::string shown_laps(const Log& log);
/// The same of a durability test, with the effects of a drum, and [[critical]] with what is not known.
void write_drum_drive(CaseDraft& draft, const DrumTest& test);
void write_drum_effects(CaseDraft& draft, const DrumTest& test);
void write_drum_critical(CaseDraft& draft);
/// [TABLE.columns] and [TABLE.units]: what holds of the log's columns, and behind a # what may hold.
/// @param table "run", "drive.file", "data", "corner"  @param corner whose columns, empty: of the car; none: all
void write_columns(CaseWriter& writer, const Log& log, const std::string& table,
                   const std::optional<std::string>& corner = std::nullopt);
/// A [[parameter]] of an effect. @param ground of the standard deviation, which is assumed
void write_parameter(CaseWriter& writer, std::string_view effect, std::string_view key, std::string_view deviation,
                     std::string_view ground, std::string_view meaning = "");
/// The list [[sensor]].
void write_sensors(CaseDraft& draft);
/// [[run]] or [[drive.file]] with the log's columns, and what a fit may move.
void write_log(CaseDraft& draft);

/// "23.4 degC" of a temperature in K, to a hundredth.
[[nodiscard]] std::string shown_celsius(double kelvin);
/// A number of seconds as a case writes it: "2400 s".
[[nodiscard]] std::string shown_seconds(double seconds);

}  // namespace tiretherm::input
