// SPDX-License-Identifier: BSD-3-Clause
// The table [vehicle]: inputs that a car's motion gives to one of its tires.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"
#include "physics/tire_laws/magic_formula.hpp"
#include "solver/input_model.hpp"

namespace tiretherm::input {

struct CarMotion;

/// What [vehicle] makes of a run; empty without it.
struct VehicleTable {
    std::shared_ptr<const solver::InputModel> model{};  ///< by which inputs follow the car's numbers
    std::vector<double> numbers{};                      ///< SI
    std::shared_ptr<const CarMotion> car{};             ///< of the log
    double course_agrees = 0.0;                         ///< as MotionHistory has it
};

/// @param law of [tire]  @param unreadable whether what the run's file gives is unknown
/// @param known of the car, as another tire of it has found it; null: nothing  @param signals with those of the car, gets the tire's
[[nodiscard]] VehicleTable read_vehicle(TomlTable& root, const std::optional<physics::MagicFormula>& law,
                                        bool unreadable, std::shared_ptr<const CarMotion> known,
                                        DrivenSignals& signals);

}  // namespace tiretherm::input
