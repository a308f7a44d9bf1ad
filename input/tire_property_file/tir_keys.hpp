// SPDX-License-Identifier: BSD-3-Clause
// Keys of the Magic Formula for pure slip in .tir files (PCX1, PDY1, LMUY ...), with the version that uses each: MF
// 5.2, MF 6.1 or both.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "physics/tire_laws/magic_formula.hpp"

/// The keys of pure slip in a `.tir` property file, and where their numbers belong.
namespace tiretherm::input::tir {

using Law = physics::MagicFormula;

/// Which versions of the Magic Formula use a coefficient.
enum class Use : std::uint8_t { both, only_52, only_61 };

/// Values that a key may have. They take in everything from bicycles to trucks and racing slicks, and exclude slips of the pen,
/// lost decimal points and signs that turn a force off.
struct Bounds {
    double low;
    double high;
    bool by_magnitude;      ///< the sign is that of the file's axis system
    std::string_view what;  ///< the key's meaning, with its usual size
};
inline constexpr Bounds shape{0.1, 3.0, false, "a shape factor C, 1 to 2 for tires"};
inline constexpr Bounds friction{0.1, 5.0, true, "the friction at the nominal load, 0.7 to 3 for tires"};
inline constexpr Bounds stiffness{1.0, 500.0, true, "a stiffness over the nominal load, 5 to 100 for tires"};
inline constexpr Bounds stiffest_load{
    0.05, 50.0, true, "the load over the nominal one at which the stiffness is largest, 1 to 5 for tires"};
inline constexpr Bounds factor{0.01, 10.0, false, "a scaling factor, 1 for the tire as it was measured"};
inline constexpr Bounds decay{0.0, 10.0, false, "the decay of friction with the sliding speed, 0 without one"};
inline constexpr Bounds signed_factor{-10.0, 10.0, false, "a scaling factor, 1 for the tire as it was measured"};
inline constexpr Bounds slip_shift{-1.0, 1.0, false, "a shift of the slip, some thousandths for tires"};
inline constexpr Bounds force_shift{-10.0, 10.0, false, "a shift of the force over the load, some hundredths"};
inline constexpr Bounds change{-100.0, 100.0, false, "a change with load or camber"};
inline constexpr Bounds with_pressure{-20.0, 20.0, false, "a change with the pressure over the nominal one, -2 to 2"};
inline constexpr Bounds any{-1000.0, 1000.0, false, "a coefficient of a tire"};

/// A key of a property file and where its number belongs.
struct Coefficient {
    std::string_view key;
    double& (*at)(Law& law);
    const Bounds& bounds;
    Use use = Use::both;
};

/// A coefficient, or a scaling factor among them.
template <auto member>
[[nodiscard]] double& of(Law& law) {
    if constexpr (requires { law.*member; }) {
        return law.*member;
    } else {
        return law.lambda.*member;
    }
}

// clang-format off
inline constexpr Coefficient coefficients[] = {
    {"PCX1", of<&Law::pCx1>, shape},
    {"PDX1", of<&Law::pDx1>, friction}, {"PDX2", of<&Law::pDx2>, change},
    {"PDX3", of<&Law::pDx3>, change},
    {"PEX1", of<&Law::pEx1>, any}, {"PEX2", of<&Law::pEx2>, any}, {"PEX3", of<&Law::pEx3>, any},
    {"PEX4", of<&Law::pEx4>, any},
    {"PKX1", of<&Law::pKx1>, stiffness}, {"PKX2", of<&Law::pKx2>, any}, {"PKX3", of<&Law::pKx3>, change},
    {"PHX1", of<&Law::pHx1>, slip_shift}, {"PHX2", of<&Law::pHx2>, slip_shift},
    {"PVX1", of<&Law::pVx1>, force_shift}, {"PVX2", of<&Law::pVx2>, force_shift},
    {"PPX1", of<&Law::pPx1>, with_pressure, Use::only_61}, {"PPX2", of<&Law::pPx2>, with_pressure, Use::only_61},
    {"PPX3", of<&Law::pPx3>, with_pressure, Use::only_61}, {"PPX4", of<&Law::pPx4>, with_pressure, Use::only_61},
    {"PCY1", of<&Law::pCy1>, shape},
    {"PDY1", of<&Law::pDy1>, friction}, {"PDY2", of<&Law::pDy2>, change}, {"PDY3", of<&Law::pDy3>, change},
    {"PEY1", of<&Law::pEy1>, any}, {"PEY2", of<&Law::pEy2>, any}, {"PEY3", of<&Law::pEy3>, any},
    {"PEY4", of<&Law::pEy4>, any}, {"PEY5", of<&Law::pEy5>, any, Use::only_61},
    {"PKY1", of<&Law::pKy1>, stiffness}, {"PKY2", of<&Law::pKy2>, stiffest_load}, {"PKY3", of<&Law::pKy3>, change},
    {"PKY4", of<&Law::pKy4>, change, Use::only_61}, {"PKY5", of<&Law::pKy5>, any, Use::only_61},
    {"PKY6", of<&Law::pKy6>, any, Use::only_61}, {"PKY7", of<&Law::pKy7>, any, Use::only_61},
    {"PHY1", of<&Law::pHy1>, slip_shift}, {"PHY2", of<&Law::pHy2>, slip_shift},
    {"PHY3", of<&Law::pHy3>, slip_shift, Use::only_52},
    {"PVY1", of<&Law::pVy1>, force_shift}, {"PVY2", of<&Law::pVy2>, force_shift},
    {"PVY3", of<&Law::pVy3>, force_shift}, {"PVY4", of<&Law::pVy4>, force_shift},
    {"PPY1", of<&Law::pPy1>, with_pressure, Use::only_61}, {"PPY2", of<&Law::pPy2>, with_pressure, Use::only_61},
    {"PPY3", of<&Law::pPy3>, with_pressure, Use::only_61}, {"PPY4", of<&Law::pPy4>, with_pressure, Use::only_61},
    {"PPY5", of<&Law::pPy5>, with_pressure, Use::only_61},
    {"LFZO", of<&Law::Scaling::Fz0>, factor},
    {"LCX", of<&Law::Scaling::Cx>, factor}, {"LMUX", of<&Law::Scaling::mux>, factor},
    {"LEX", of<&Law::Scaling::Ex>, signed_factor}, {"LKX", of<&Law::Scaling::Kx>, factor},
    {"LHX", of<&Law::Scaling::Hx>, signed_factor}, {"LVX", of<&Law::Scaling::Vx>, signed_factor},
    {"LCY", of<&Law::Scaling::Cy>, factor}, {"LMUY", of<&Law::Scaling::muy>, factor},
    {"LEY", of<&Law::Scaling::Ey>, signed_factor}, {"LKY", of<&Law::Scaling::Ky>, factor},
    {"LHY", of<&Law::Scaling::Hy>, signed_factor}, {"LVY", of<&Law::Scaling::Vy>, signed_factor},
    {"LKYC", of<&Law::Scaling::Kygamma>, signed_factor, Use::only_61},
    {"LGAX", of<&Law::Scaling::gammax>, signed_factor, Use::only_52},
    {"LGAY", of<&Law::Scaling::gammay>, signed_factor, Use::only_52},
    {"LMUV", of<&Law::Scaling::muV>, decay, Use::only_61},
};

/// Scaling factors of what is not pure slip: known, and passed over.
inline constexpr std::array<std::string_view, 17> other_scaling_factors{
    "LTR", "LRES", "LGAZ", "LXAL", "LYKA", "LVYKA", "LS", "LSGKP", "LSGAL", "LGYR", "LMX", "LVMX", "LMY", "LMP", "LKZC",
    "LCZ", "LIP",
};
// clang-format on

}  // namespace tiretherm::input::tir
