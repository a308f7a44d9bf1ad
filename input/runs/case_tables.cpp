// SPDX-License-Identifier: BSD-3-Clause
// Calls the readers of all tables: what one needs of another is its argument.

#include "input/runs/case_tables.hpp"

#include <iterator>

#include "input/effects/effects.hpp"
#include "input/effects/user_effects.hpp"
#include "input/model/handling.hpp"
#include "input/model/mesh.hpp"
#include "input/model/sensors.hpp"
#include "input/model/tire.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace {

/// A run that is too long or too finely stored, where the rest of the case is sound: otherwise its size is not known.
void check_size(const TomlTable& root, const solver::Problem& problem, const SizeLimits& limits) {
    if (root.errors().count() > 0) {
        return;
    }
    if (const std::optional<SizeExcess> excess = excess_of(problem, limits)) {
        const TomlValue* time = root.content().find("time");
        const TomlValue* value = time != nullptr ? time->find(excess->key) : nullptr;
        root.errors().add(value != nullptr  ? value->place
                          : time != nullptr ? time->place
                                            : root.place(),
                          excess->what, excess->remedy);
    }
}

}  // namespace

std::vector<std::string> followed_columns(const TomlValue& document) {
    std::vector<std::string> names = followed_names(document);
    add_vehicle_columns(document, names);
    return names;
}

CaseTables read_tables(TomlTable& root, const std::string& name, const RunInputs* run,
                       std::shared_ptr<const CarMotion> car) {
    CaseTables read;
    solver::Problem& problem = read.problem;
    problem.name = name;
    problem.title = root.text("title").value_or(name);
    for (const LocatedString& source : root.texts("sources")) {
        problem.sources.push_back(source.text);
    }
    // Limits before all that they bound: a mesh is refused before its first cell is made.
    read.limits = read_limits(root);
    TireTable tire = read_tire(root);
    read.stock = read_materials(root);
    settle_belt(root, read.stock, tire.handling);
    // Layers take the tire's area and radius where they have none, and a lump's material gives the tire its density.
    MeshTable mesh = read_mesh(root, {.tire = tire, .stock = read.stock, .limits = read.limits});
    problem.tire = tire.tire;
    problem.handling = std::move(tire.handling);
    problem.mesh = std::move(mesh.mesh);
    problem.materials = std::move(mesh.materials);
    problem.link_laws = std::move(mesh.link_laws);
    problem.symmetry = mesh.symmetry;

    std::vector<std::string> followed = followed_columns(root.content());
    DriveTable drive = read_drive(root, run, followed);
    read.span = drive.span;
    // Behind [drive] and the run's file: [vehicle] computes only what neither of them gives.
    const bool unreadable = run != nullptr && run->unreadable;
    VehicleTable vehicle =
        read_vehicle(root, problem.handling.magic_formula, unreadable, std::move(car), drive.signals);
    read.car = std::move(vehicle.car);
    read.course_agrees = vehicle.course_agrees;
    problem.input_model = std::move(vehicle.model);
    problem.input_numbers = std::move(vehicle.numbers);
    problem.input_signals = std::move(drive.signals.inputs);
    const GivenSignals& given = drive.signals.given;
    settle_tire(root, tire.given, given, problem);

    const EffectSurroundings around{.has_tire = tire.given, .signals = drive.signals, .run = run};
    const bool has_valid_effects = read_effects(root, around, problem);
    // The run lasts as long as its logs, which are known now; what follows a signal over the run, or starts by it, waits for that.
    problem.settings = read_time_settings(root, read.span, run);
    problem.input_signals.start_at(problem.settings.start);
    std::ranges::move(read_fields(root, given, problem), std::back_inserter(followed));
    read_travelling(root, tire.given, problem);
    read_user_effects(root, around, problem);
    problem.initial = read_initial(root, problem, given, run);

    problem.channels = read_sensors(root, problem, tire.given, given);
    // The channels of cameras are behind those of all sensors: see Problem::n_sensors.
    read.cameras = read_cameras(root, unreadable ? nullptr : &given, problem);
    bind_readings(root, read.cameras, problem);
    if (has_valid_effects) {
        check_effects(root, given, followed, problem);
    }
    problem.measured = read_measured(root, problem, problem.settings.start + (run != nullptr ? run->lead : 0.0));
    // Initial state and surroundings are known: these are the temperatures at which laws must hold.
    check_laws(root, problem, read.stock);
    check_size(root, problem, read.limits);
    return read;
}

}  // namespace tiretherm::input
