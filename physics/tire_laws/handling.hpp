// SPDX-License-Identifier: BSD-3-Clause
// The laws by which temperature reaches vehicle dynamics: cornering stiffness, lateral force and friction (thesis (30),
// (52), (58)-(60), (69)-(71)).
#pragma once

#include <optional>
#include <vector>

#include "physics/tire_laws/cornering_stiffness.hpp"
#include "physics/tire_laws/grid_table.hpp"
#include "physics/tire_laws/grip.hpp"
#include "physics/tire_laws/magic_formula.hpp"

namespace tiretherm::physics {

/// A measured cornering stiffness.
struct StiffnessPoint {
    double load = 0.0;         ///< N
    double temperature = 0.0;  ///< K, of the bulk
    double stiffness = 0.0;    ///< N/rad
};

/// What was measured of a tire, to stand beside its laws; nothing computes with it.                    thesis V.4.7, V.4.9
struct MeasuredLaws {
    std::optional<Curve> contact_length{};  ///< m against N
    std::optional<Curve> contact_area{};    ///< m2 against N
    std::optional<Curve> loaded_radius{};   ///< m against N
    std::optional<Curve> rolling_radius{};  ///< m against N
    std::vector<StiffnessPoint> cornering_stiffness{};
};

/// The laws by which temperature reaches vehicle dynamics.
struct Handling {
    EquivalentModulus modulus;                  ///< of the cornering stiffness
    double lambda_CP = 1.0;                     ///< scale of the cornering stiffness
    std::optional<MagicFormula> magic_formula;  ///< of a property file
    /// K, of the bulk at which the property file's cornering stiffness holds: the moduli say how it changes from there.
    double reference_temperature = 343.15;
    bool replaces_stiffness =
        false;  ///< the moduli are those of the property file's tire: their stiffness is taken for its own
    std::optional<GridTable>
        stiffness_table{};                  ///< N/rad, measured: in the place of the moduli and of the property file
    std::optional<PeakCurve> peak_curve{};  ///< of the lateral force, where there is no property file
    std::optional<Grip> grip{};
    bool is_given = false;  ///< the case says something of the cornering stiffness
    MeasuredLaws measured{};

    /// At the temperature of the bulk, lambda_CP included: the table, the moduli, or of a property file's tire its own
    /// stiffness, which the moduli let follow the temperature. @param T_bulk K  @returns N/rad >= 0; 0 without contact
    [[nodiscard]] double cornering_stiffness(const Tire& tire, const Inputs& inputs, double T_bulk) const;
    /// Lateral force in pure slip with that stiffness.                                            thesis (59), or (4)-(7)
    /// @param friction over that of the property file or of the peak: `grip` at the surface's temperature  @pre can_corner()
    [[nodiscard]] PureSlip lateral(const Tire& tire, const Inputs& inputs, double T_bulk, double friction) const;
    [[nodiscard]] bool can_corner() const { return magic_formula || peak_curve; }
    /// Of the property file, at its own temperature. @pre magic_formula  @returns N/rad
    [[nodiscard]] double stiffness_of_file(const Inputs& inputs) const;
};

/// What a Magic Formula's lateral force needs to know of the inputs.
[[nodiscard]] PureSlipState side_slip(const Inputs& inputs);

}  // namespace tiretherm::physics
