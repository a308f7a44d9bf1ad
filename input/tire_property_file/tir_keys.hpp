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

/// A key of a property file and where its number belongs.
struct Coefficient {
    std::string_view key;
    double Law::*member;
    Use use = Use::both;
};

struct ScalingFactor {
    std::string_view key;
    double Law::Scaling::*member;
    Use use = Use::both;
};

// clang-format off
inline constexpr std::array coefficients{
    Coefficient{"PCX1", &Law::pCx1},
    Coefficient{"PDX1", &Law::pDx1}, Coefficient{"PDX2", &Law::pDx2},
    Coefficient{"PDX3", &Law::pDx3},
    Coefficient{"PEX1", &Law::pEx1}, Coefficient{"PEX2", &Law::pEx2},
    Coefficient{"PEX3", &Law::pEx3}, Coefficient{"PEX4", &Law::pEx4},
    Coefficient{"PKX1", &Law::pKx1}, Coefficient{"PKX2", &Law::pKx2},
    Coefficient{"PKX3", &Law::pKx3},
    Coefficient{"PHX1", &Law::pHx1}, Coefficient{"PHX2", &Law::pHx2},
    Coefficient{"PVX1", &Law::pVx1}, Coefficient{"PVX2", &Law::pVx2},
    Coefficient{"PCY1", &Law::pCy1},
    Coefficient{"PDY1", &Law::pDy1}, Coefficient{"PDY2", &Law::pDy2},
    Coefficient{"PDY3", &Law::pDy3},
    Coefficient{"PEY1", &Law::pEy1}, Coefficient{"PEY2", &Law::pEy2},
    Coefficient{"PEY3", &Law::pEy3}, Coefficient{"PEY4", &Law::pEy4},
    Coefficient{"PEY5", &Law::pEy5, Use::only_61},
    Coefficient{"PKY1", &Law::pKy1}, Coefficient{"PKY2", &Law::pKy2},
    Coefficient{"PKY3", &Law::pKy3},
    Coefficient{"PKY4", &Law::pKy4, Use::only_61},
    Coefficient{"PKY5", &Law::pKy5, Use::only_61},
    Coefficient{"PKY6", &Law::pKy6, Use::only_61},
    Coefficient{"PKY7", &Law::pKy7, Use::only_61},
    Coefficient{"PHY1", &Law::pHy1}, Coefficient{"PHY2", &Law::pHy2},
    Coefficient{"PHY3", &Law::pHy3, Use::only_52},
    Coefficient{"PVY1", &Law::pVy1}, Coefficient{"PVY2", &Law::pVy2},
    Coefficient{"PVY3", &Law::pVy3}, Coefficient{"PVY4", &Law::pVy4},
};

inline constexpr std::array scaling_factors{
    ScalingFactor{"LFZO", &Law::Scaling::Fz0},
    ScalingFactor{"LCX", &Law::Scaling::Cx}, ScalingFactor{"LMUX", &Law::Scaling::mux},
    ScalingFactor{"LEX", &Law::Scaling::Ex}, ScalingFactor{"LKX", &Law::Scaling::Kx},
    ScalingFactor{"LHX", &Law::Scaling::Hx}, ScalingFactor{"LVX", &Law::Scaling::Vx},
    ScalingFactor{"LCY", &Law::Scaling::Cy}, ScalingFactor{"LMUY", &Law::Scaling::muy},
    ScalingFactor{"LEY", &Law::Scaling::Ey}, ScalingFactor{"LKY", &Law::Scaling::Ky},
    ScalingFactor{"LHY", &Law::Scaling::Hy}, ScalingFactor{"LVY", &Law::Scaling::Vy},
    ScalingFactor{"LKYC", &Law::Scaling::Kygamma, Use::only_61},
    ScalingFactor{"LGAX", &Law::Scaling::gammax, Use::only_52},
    ScalingFactor{"LGAY", &Law::Scaling::gammay, Use::only_52},
    ScalingFactor{"LMUV", &Law::Scaling::muV, Use::only_61},
};

/// Scaling factors of what is not pure slip: known, and passed over.
inline constexpr std::array<std::string_view, 17> other_scaling_factors{
    "LTR", "LRES", "LGAZ", "LXAL", "LYKA", "LVYKA", "LS", "LSGKP", "LSGAL", "LGYR", "LMX", "LVMX", "LMY", "LMP", "LKZC",
    "LCZ", "LIP",
};
// clang-format on

}  // namespace tiretherm::input::tir
