#pragma once

#include "solver/celsius.hpp"
#include "solver/problem.hpp"

namespace tiretherm::solver {

/// How users see a channel's values.
struct ShownUnit {
    const char* name;
    double factor = 1.0;
    double zero = 0.0;  ///< SI value that is shown as 0

    [[nodiscard]] constexpr double value(double si) const { return factor * (si - zero); }
    /// Of a difference of two values.
    [[nodiscard]] constexpr double difference(double si) const { return factor * si; }
};

[[nodiscard]] constexpr ShownUnit shown_unit(solver::Quantity quantity) {
    switch (quantity) {
        case solver::Quantity::temperature:
        case solver::Quantity::surface_at_entry:
        case solver::Quantity::surface_at_exit:
            return {.name = "degC", .zero = zero_celsius};
        case solver::Quantity::drag_force:
            return {.name = "N"};
        case solver::Quantity::rolling_moment:
            return {.name = "N m"};
        case solver::Quantity::loaded_radius:
            return {.name = "mm", .factor = 1e3};
        case solver::Quantity::cornering_stiffness:
            return {.name = "N/rad"};
        case solver::Quantity::gas_pressure:
            return {.name = "kPa", .factor = 1e-3};
        case solver::Quantity::bulk_temperature_factor:
            return {.name = "-"};
        case solver::Quantity::lateral_force:
        case solver::Quantity::reference_lateral_force:
        case solver::Quantity::longitudinal_force:
            return {.name = "N"};
    }
    return {.name = "1"};
}

}  // namespace tiretherm::solver
