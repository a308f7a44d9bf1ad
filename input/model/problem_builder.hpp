// SPDX-License-Identifier: BSD-3-Clause
// The case as far as it has been read, and the readers of its tables; each reader fills in the problem and reports all
// errors.
#pragma once

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/cameras/camera.hpp"
#include "input/effects/user_signals.hpp"
#include "input/laps/course_over_ground.hpp"
#include "input/laps/laps.hpp"
#include "input/materials/cord_rubber.hpp"
#include "input/model/size_limits.hpp"
#include "input/toml/toml_table.hpp"
#include "mesh/builders.hpp"
#include "solver/problem.hpp"

/// The readers of a case's tables. Each reads one table into the builder, reports what is wrong with it and leaves
/// something harmless in its place, so that the tables after it are read as well.
namespace tiretherm::input {

/// A material of the case, whether or not a layer is made of it.
struct Stock {
    physics::Material material;
    const TomlValue* table = nullptr;
    std::optional<CordRubberPly> ply{};  ///< of cords in rubber: its conductivities follow from them
    bool used = false;                   ///< a layer is made of it, or plies are whose rubber it is
};

/// An input that the file of a measured run gives.
struct MeasuredInput {
    const physics::Signal* signal = nullptr;
    SourceLocation place;  ///< of its heading
    std::vector<double> time;
    std::vector<double> value;  ///< [time]; empty after an error
};

/// What a sensor reads that [initial] names in the place of a temperature.
struct StartReading {
    std::string sensor;             ///< or one of an array's channels
    solver::SignalHistory reading;  ///< s, K
};

/// What the file of a measured run gives beside the tables of the case. It wins over them, but not over tables of the
/// run's own.
struct RunInputs {
    const TomlValue* table = nullptr;  ///< the run's own; null for a file given beside the case
    std::string name;
    SourceLocation place;  ///< where the file is mentioned, or the run
    bool has_file = false;
    bool unreadable = false;  ///< which inputs the file would give is unknown: no missing one is reported
    std::vector<MeasuredInput> inputs{};
    std::vector<UserColumn> columns{};    ///< that user effects follow; without points after an error
    std::vector<std::string> headings{};  ///< of all columns of the file
    std::vector<StartReading> start_readings{};
    double file_first = 0.0;            ///< s, of the file's first sample, whether or not it is in the run
    std::optional<double> first{};      ///< s, first time in the run's part of the file, less `lead`
    bool part_of_file = false;          ///< `from` or `laps` choose where it begins
    double lead = 0.0;                  ///< s, for which laps are driven before
    std::vector<LapWindow> left_out{};  ///< whose readings do not count
    std::optional<double> last{};       ///< s, last time in the file
    CourseOverGround course{};          ///< where the case has a car, and its file says where it drives

    /// Whether the file gives anything that acts on the tire.
    [[nodiscard]] bool drives() const { return unreadable || !inputs.empty() || !columns.empty(); }
    /// Whether the run has a value of its own for the key of a table.
    [[nodiscard]] bool says(std::string_view of_table, std::string_view key) const;
    /// Whether a signal that stands in [drive] at this key comes from the file instead.
    [[nodiscard]] bool overrides(std::string_view key, std::string_view signal) const;
};

/// What a reader has found out about its table. Reading it before it is set is a programming error: the order of
/// `read_tables` is wrong.
class Finding {
public:
    Finding& operator=(bool found) {
        found_ = found;
        return *this;
    }
    [[nodiscard]] operator bool() const {
        assert(found_.has_value());
        return *found_;
    }

private:
    std::optional<bool> found_{};
};

struct CarMotion;

/// Builds the problem: a case as far as it has been read.
struct ProblemBuilder {
    solver::Problem problem;
    Finding has_tire{};           ///< by read_tire
    Finding has_tire_density{};   ///< by read_tire: given in [tire], not only by a material
    Finding has_mesh{};           ///< by read_mesh; false after an error: names of patches and layers are unknown
    Finding has_valid_effects{};  ///< by read_effects
    std::vector<Stock> stock;
    std::map<std::string, SourceLocation, std::less<>> given;  ///< signals of [drive], rightly or wrongly written
    std::vector<std::string> constants{};  ///< those of them that [drive] gives as constants and that count
    int case_file = 0;                     ///< number of the case's own file, among those that it includes
    SizeLimits limits{};
    std::optional<double> logged_from;       ///< s, first sample of any log
    std::optional<double> logged_to;         ///< s, last sample of any log
    std::optional<double> driven_from;       ///< s, first row of any schedule or log
    std::optional<double> driven_to;         ///< s, last row of any schedule or log
    std::optional<RunInputs> run{};          ///< the measured run that is being read
    std::vector<std::string> followed{};     ///< what user effects refer to: inputs, columns
    std::vector<UserColumn> columns{};       ///< of them those that a log of [drive] gives
    CourseOverGround course{};               ///< of a car, likewise
    std::shared_ptr<const CarMotion> car{};  ///< of the log, as another tire has found it; out: as this one has
    double course_agrees = 0.0;              ///< with the turns that [vehicle] takes: as MotionHistory has it

    std::vector<Camera> cameras{};

    /// Takes note of the times of a schedule or log. @param time s, ascending
    void take_driven(const std::vector<double>& time) {
        driven_from = std::min(driven_from.value_or(time.front()), time.front());
        driven_to = std::max(driven_to.value_or(time.back()), time.back());
    }
    /// Whether the measured run's file gives a signal that stands in [drive] at this key.
    [[nodiscard]] bool overridden(std::string_view key, std::string_view signal) const {
        return run && run->overrides(key, signal);
    }
};

/// All tables of a case, in the order in which one may refer to another: each reader may ask for the findings of those
/// before it.
void read_tables(TomlTable& root, ProblemBuilder& builder);

void read_tire(TomlTable& root, ProblemBuilder& builder);
void read_materials(TomlTable& root, ProblemBuilder& builder);
void read_mesh(TomlTable& root, ProblemBuilder& builder);
void read_drive(TomlTable& root, ProblemBuilder& builder);
/// The inputs of the tire at a corner of the car: [vehicle].
void read_vehicle(TomlTable& root, ProblemBuilder& builder);
/// Whether the tire's laws follow the pressure, and warnings about inputs outside their range.
void settle_tire(TomlTable& root, ProblemBuilder& builder);
void read_effects(TomlTable& root, ProblemBuilder& builder);
/// Fields of structural codes and measured totals of the effects that are on, when the drive and the run's times are
/// known.
void read_fields(TomlTable& root, ProblemBuilder& builder);
/// The wheel's angle and the moments of contact, where an effect goes round the tire.
void read_travelling(TomlTable& root, ProblemBuilder& builder);
/// The lists [[source]] and [[exchange]], when the drive and the run's times are known.
void read_user_effects(TomlTable& root, ProblemBuilder& builder);
/// The channels of the sensor models; what else they say has been read.
void bind_readings(TomlTable& root, ProblemBuilder& builder);
void read_initial(TomlTable& root, ProblemBuilder& builder);
void read_time_settings(TomlTable& root, ProblemBuilder& builder);
void read_sensors(TomlTable& root, ProblemBuilder& builder);
/// The list [[camera]], behind all sensors.
void read_cameras(TomlTable& root, ProblemBuilder& builder);
void read_measured(TomlTable& root, ProblemBuilder& builder);

/// Laws must be positive wherever the run is sure to go: between the coldest and the hottest temperature that the case
/// gives. Where they would fail on the way up to 150 degC, a warning.
void check_laws(TomlTable& root, const ProblemBuilder& builder);

/// Parts of [mesh], by kind. @returns false after an error
bool read_two_node(TomlTable& mesh, ProblemBuilder& builder);
bool read_layers(TomlTable& mesh, ProblemBuilder& builder);
bool read_cylinder(TomlTable& mesh, ProblemBuilder& builder);
bool read_block(TomlTable& mesh, ProblemBuilder& builder);
bool read_axisymmetric(TomlTable& mesh, ProblemBuilder& builder);
bool read_section(TomlTable& mesh, ProblemBuilder& builder);

/// The list [[mesh.layer]]: name, thickness, cells, ratio, material; fills problem.materials.
/// @param zones out, the words of each layer's key `zones`; null where a mesh has none
[[nodiscard]] std::vector<mesh::Layer> read_stack(TomlTable& mesh, ProblemBuilder& builder,
                                                  std::vector<std::vector<LocatedString>>* zones = nullptr);

/// The material that a key names, null after an error.
[[nodiscard]] const physics::Material* read_material(TomlTable& table, std::string_view key, ProblemBuilder& builder);

/// One [[drive.file]]: a logger's CSV.
void read_logged(TomlTable& table, ProblemBuilder& builder);

/// Whether a signal counts. Of a constant and a series of different files that of the case itself counts, otherwise the
/// series; any other second one is an error at `place`.
/// @param mentioned in the case; that is `place` unless it is in a log
bool register_signal(std::string_view name, const SourceLocation& place, const SourceLocation& mentioned,
                     ProblemBuilder& builder, InputErrors& errors);

}  // namespace tiretherm::input
