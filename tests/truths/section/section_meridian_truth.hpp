// SPDX-License-Identifier: BSD-3-Clause
// Outer profile of the section bench over its arc length.
#pragma once

namespace hidden_effects {

inline constexpr double centre_radius = 0.3308;  ///< m, of the outer profile in the centre plane
inline constexpr double crown_edge = 0.0675;     ///< m along the profile
inline constexpr double tread_edge = 0.1125;     ///< m
inline constexpr double shoulder_middle = 0.09;  ///< m

/// Radius of the section's outer profile at an arc length from the centre plane, m: three arcs on either side.
[[nodiscard]] double section_radius(double s);
/// Arc length from the centre plane to a bead, m.
[[nodiscard]] double section_reach();

}  // namespace hidden_effects
