// SPDX-License-Identifier: BSD-3-Clause
// The inputs of one tire of a car as a model of the car's numbers, so that studies and fits may move them.
#pragma once

#include <span>
#include <vector>

#include "input/vehicle/corner_signals.hpp"
#include "solver/input_model.hpp"

namespace tiretherm::input {

/// An input of the tire that the model of the car gives.
struct ComputedInput {
    const physics::Signal* signal = nullptr;
    double physics::CornerInputs::*member = nullptr;
};
/// Load, slips and forces; the speed is another matter, for the car's is given.
[[nodiscard]] std::span<const ComputedInput> computed_inputs();

/// From the log of a car to the inputs of one of its tires. The log, its signs and its smoothing stay as they are.
class VehicleInputModel final : public solver::InputModel {
public:
    /// @param inputs of the case and its run, before anything is computed: the car's speed, camber, air, measured load
    /// @param computed those that it gives  @param has_disc it gives the temperature of the brake disc as well
    VehicleInputModel(VehicleSettings settings, VehicleLog log, const solver::InputSignals& inputs,
                      std::vector<ComputedInput> computed, bool has_disc);

    void apply(std::span<const double> numbers, solver::InputSignals& into) const override;
    [[nodiscard]] std::vector<const physics::Signal*> signals() const override;
    void add_to(solver::Digest& digest) const override;

    /// This tire and the other one of its axle, of a car with these numbers. @param motion of its log
    [[nodiscard]] AxleHistory axle(const VehicleNumbers& numbers, const MotionHistory& motion) const;
    /// A digest of all that the axle follows from beside the motion.
    [[nodiscard]] solver::Digest::Value axle_origin() const;
    /// Its side of the axle.
    [[nodiscard]] const CornerHistory& own(const AxleHistory& axle) const;
    /// Puts what this tire gets in the place of what is there. @param corner of the same numbers and motion
    void put(const VehicleNumbers& numbers, const MotionHistory& motion, const CornerHistory& corner,
             solver::InputSignals& into) const;

private:
    VehicleSettings settings_;
    VehicleLog log_;
    MeasuredWheelHistories measured_;
    solver::SignalHistory air_;  ///< K
    std::vector<ComputedInput> computed_;
    bool has_disc_;
};

}  // namespace tiretherm::input
