#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/cameras/camera.hpp"
#include "input/effects/own_signals.hpp"
#include "input/text/section.hpp"
#include "mesh/builders.hpp"
#include "solver/problem.hpp"

/// The readers of a case's tables. Each reads one table into the draft, reports what is wrong with it and leaves
/// something harmless in its place, so that the tables after it are read as well.
namespace tiretherm::input {

/// A material of the case, whether or not a layer is made of it.
struct Stock {
    physics::Material material;
    const Node* table = nullptr;
    bool used = false;
};

/// An input that the file of a measured run gives.
struct MeasuredInput {
    const physics::Signal* signal = nullptr;
    Place place;  ///< of its heading
    std::vector<double> time;
    std::vector<double> value;  ///< [time]; empty after a mistake
};

/// What the file of a measured run gives beside the tables of the case. It wins over them, but not over tables of the
/// run's own.
struct RunInputs {
    const Node* table = nullptr;  ///< the run's own; null for a file given beside the case
    std::string name;
    Place place;  ///< where the file is mentioned, or the run
    bool has_file = false;
    bool unreadable = false;  ///< nobody knows which inputs the file would give: none is missed
    std::vector<MeasuredInput> inputs{};
    std::vector<OwnColumn> columns{};     ///< that effects of the user's own follow; without points after a mistake
    std::vector<std::string> headings{};  ///< of all columns of the file
    std::optional<double> first{};        ///< s, first time in the file
    std::optional<double> last{};         ///< s, last time in the file

    /// Whether the run has a value of its own for the key of a table.
    [[nodiscard]] bool says(std::string_view of_table, std::string_view key) const;
    /// Whether a signal that stands in [drive] at this key comes from the file instead.
    [[nodiscard]] bool outranks(std::string_view key, std::string_view signal) const;
};

/// A case as far as it has been read.
struct Draft {
    solver::Problem problem;
    bool has_tire = false;
    bool has_tire_density = false;  ///< given in [tire], not only by a material
    bool has_sound_effects = false;
    bool has_mesh = false;  ///< false after a mistake in [mesh]: names of patches and layers are unknown
    std::vector<Stock> stock;
    std::map<std::string, Place, std::less<>> given;  ///< signals of [drive], rightly or wrongly written
    std::optional<double> logged_from;                ///< s, first sample of any log
    std::optional<double> logged_to;                  ///< s, last sample of any log
    std::optional<RunInputs> run{};                   ///< the measured run that is being read
    std::vector<std::string> followed{};              ///< what effects of the user's own speak of: inputs, columns
    std::vector<OwnColumn> columns{};                 ///< of them those that a log of [drive] gives

    std::vector<Camera> cameras{};

    /// Whether the measured run's file gives a signal that stands in [drive] at this key.
    [[nodiscard]] bool outranked(std::string_view key, std::string_view signal) const {
        return run && run->outranks(key, signal);
    }
};

/// All tables of a case, in the order in which one may speak about another.
void read_tables(Section& root, Draft& draft);

void read_tire(Section& root, Draft& draft);
void read_materials(Section& root, Draft& draft);
void read_mesh(Section& root, Draft& draft);
void read_drive(Section& root, Draft& draft);
void read_effects(Section& root, Draft& draft);
/// Fields of structural codes and measured totals of the effects that are on, when the drive and the run's times are
/// known.
void read_fields(Section& root, Draft& draft);
/// The wheel's angle and the moments of contact, where an effect goes round the tire.
void read_travelling(Section& root, Draft& draft);
/// The lists [[source]] and [[exchange]], when the drive and the run's times are known.
void read_own_effects(Section& root, Draft& draft);
/// The channels of the effects that are readings; what else they say has been read.
void bind_readings(Section& root, Draft& draft);
void read_initial(Section& root, Draft& draft);
void read_times(Section& root, Draft& draft);
void read_sensors(Section& root, Draft& draft);
/// The list [[camera]], behind all sensors.
void read_cameras(Section& root, Draft& draft);
void read_measured(Section& root, Draft& draft);

/// Laws must be positive wherever the run is sure to go: between the coldest and the hottest temperature that the case
/// gives. Where they would fail on the way up to 150 degC, a warning.
void check_laws(Section& root, const Draft& draft);

/// Parts of [mesh], by kind. @returns false after a mistake
bool read_two_node(Section& mesh, Draft& draft);
bool read_layers(Section& mesh, Draft& draft);
bool read_block(Section& mesh, Draft& draft);
bool read_axisymmetric(Section& mesh, Draft& draft);
bool read_section(Section& mesh, Draft& draft);

/// The list [[mesh.layer]]: name, thickness, cells, ratio, material; fills problem.materials.
/// @param zones out, the words of each layer's key `zones`; null where a mesh has none
[[nodiscard]] std::vector<mesh::Layer> read_stack(Section& mesh, Draft& draft,
                                                  std::vector<std::vector<Word>>* zones = nullptr);

/// The material that a key names, null after a mistake.
[[nodiscard]] const physics::Material* read_material(Section& section, std::string_view key, Draft& draft);

/// One [[drive.file]]: a logger's CSV.
void read_logged(Section& section, Draft& draft);

/// Whether a signal is new; a second one is a mistake at `place`.
bool claim_signal(std::string_view name, const Place& place, Draft& draft, Mistakes& mistakes);

}  // namespace tiretherm::input
