// SPDX-License-Identifier: BSD-3-Clause
// What the columns of a data logger's file are to a new case: its time, inputs, what its sensors read, or nothing yet.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/case_text/mesh_template.hpp"
#include "input/laps/laps.hpp"
#include "input/new_case/column_words.hpp"
#include "input/tables/data_file.hpp"

namespace tiretherm::input {

/// A column of the log and what the case makes of it.
struct LogColumn {
    int column = 0;
    Heading heading;       ///< as the file has it
    std::string name;      ///< what it is taken for; empty: not used
    std::string corner{};  ///< FL, FR, RL, RR: of one tire of a car, used or not
    bool is_input = false;
    bool is_sensor = false;
    std::string unit{};            ///< taken in place of the heading's; empty: the heading's
    bool unit_is_given = false;    ///< by the user; else it is assumed
    std::string unit_ground{};     ///< why it is assumed, where there is more to say: "the rows are 50 apart"
    std::string suggestion{};      ///< a name that it may have, of one that is not used
    std::string suggested_unit{};  ///< a unit that the case must say then; empty: the heading's will do
    std::string reason{};          ///< why it is not used
    bool is_foreign = false;       ///< not used, as nothing of the model goes by such a name
    bool must_ignore = false;      ///< not used, although the reader would know its name
    std::string_view other_use{};  ///< not used but for the "laps" of the log, or for the "course" of the car
    bool is_dropped = false;       ///< not used, although it is the suggestion: too little in it
    std::vector<double> value{};   ///< [n_samples] SI, NaN where missing; of a used column

    [[nodiscard]] bool is_used() const { return !name.empty(); }
    /// Takes it for nothing any more; it stays a suggestion. @param why a sentence
    void drop(std::string why);
    /// "given", "assumed", "assumed: the rows are 50 apart": of `unit`, for the case's comment.
    [[nodiscard]] std::string unit_remark() const;
    /// "surface_temperature of FL".
    [[nodiscard]] std::string full_name() const;
    /// The same of what is suggested; empty without a suggestion.
    [[nodiscard]] std::string full_suggestion() const;
    /// "speed [km/h]", for comments and messages.
    [[nodiscard]] std::string title() const;
    /// The first value that is not missing; nothing where there is none.
    [[nodiscard]] std::optional<double> first_value() const;
};

/// What a column does that is no signal. @param use "laps", "course"
[[nodiscard]] std::string_view text_of_other_use(std::string_view use);

/// How a case can use a log.
enum class LogUse : std::uint8_t {
    run,      ///< a measured run: a sensor of the case reads one of its columns
    drive,    ///< inputs alone: [[drive.file]]
    nothing,  ///< it gives its span of time alone
};

/// A log that has been read.
struct Log {
    std::string path;            ///< as the user would type it
    std::vector<double> time{};  ///< [n_samples] s
    std::vector<LogColumn> columns{};
    LogUse use = LogUse::nothing;
    bool is_car = false;     ///< columns were also taken by what loggers of cars call them
    int infrared_zones = 0;  ///< readings of an array across the tread of each tire, infrared_1 ...; 0: no array
    Laps laps{};
    bool has_course = false;  ///< of a car: a GPS heading or positions tell where it turns

    [[nodiscard]] const LogColumn* find(std::string_view name) const;  ///< that is used under this name; null: none
    [[nodiscard]] bool has_motion() const;                             ///< a column tells the turns of a car
    /// Those at which something is measured or given, front before rear and left before right.
    [[nodiscard]] std::vector<std::string> corners() const;
    /// Those of them at which a sensor reads.
    [[nodiscard]] std::vector<std::string> corners_measured() const;
};

/// A unit that the user gives columns whose headings have none, or a wrong one.
struct GivenUnit {
    std::string column;  ///< of the heading without its unit; * and ? stand for other characters
    std::string unit;
};

/// Reads the log's headings and the columns that have standard names; what is wrong with them goes to `errors`, with the
/// line. A name is recognised without regard to capitals, blanks and underscores. A column of time goes by its unit
/// where none goes by its name. In the log of a car (it has accelerations, yaw rate, steering, a heading or positions, or
/// readings of several tires, and no load of one tire) columns are also taken by the names that loggers give them.
/// Of several columns that may be one thing the first is taken that says anything: no sensor is connected to what stands at one
/// value while the car moves. What a temperature or a speed says while nothing is measured is missing.
/// A car's time without unit whose rows are five or more apart, in whole numbers, is in milliseconds.
/// @param mesh that the case is to have: its sensors are what may have been measured
/// @param units of columns; one that no column has, or that is no unit, is an error
/// @returns nothing after an error
[[nodiscard]] std::optional<Log> read_log(const std::filesystem::path& path, const MeshTemplate& mesh,
                                          const std::vector<GivenUnit>& units, InputErrors& errors);

/// Leaves out an input of a log that has been read, and what is of no use without it.
void leave_out(Log& log, const std::string& name, const std::string& reason);

}  // namespace tiretherm::input
