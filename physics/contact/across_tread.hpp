// SPDX-License-Identifier: BSD-3-Clause
// How an effect of the contact is shared over its nodes across the tread: by the contact pressure of the moment, whose
// skew and crown the laws give.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// Coefficients that an effect of the contact keeps for this, its last: skew and crown, times what they go with.
inline constexpr int across_coefficients = 2;

/// Fills nodes and weights of an effect in the contact, by the profile of its table where it has one, its share of a drum
/// that it heats, and where each node lies across the tread. A field of a structural code says all of the pressure
/// itself: the laws then change nothing.
void place_contact(const PlacementContext& context, ActiveEffect& active, const std::optional<Curve>& profile);

/// Fills the last coefficients. @param whole what the effect gives at the moment, >= 0, so that an average over a step is
/// that of what it gives; 1 where it has no one number
void note_across_tread(const Laws& laws, double whole, std::span<double> coefficients);

/// Of what a place gives or takes in the contact, the power of its contact pressure over the mean: the friction power, and a
/// lumped film on an area that follows the load, are in proportion; half-spaces that meet exchange with the root of the
/// time that they touch, which is the longer the more load a place has.
enum class FollowsPressure : std::uint8_t { in_proportion, by_root };

/// Weights of an effect's nodes at a moment: those of its place times the contact pressure, or its root. They sum to what those
/// of its place sum to, and none is negative: a place that the laws would draw off the road carries nothing, and the
/// others carry all.
class AcrossTread {
public:
    /// @param skew, crown as in Laws
    AcrossTread(const ActiveEffect& active, double skew, double crown,
                FollowsPressure follows = FollowsPressure::in_proportion);
    /// At an effect's coefficients. @param whole its coefficient that note_across_tread was given, > 0
    AcrossTread(const EvaluationState& state, double whole, FollowsPressure follows = FollowsPressure::in_proportion)
        : AcrossTread(state.active, state.coefficients[state.coefficients.size() - 2] / whole,
                      state.coefficients.back() / whole, follows) {}

    /// @param i position of the node in the effect
    [[nodiscard]] double weight(std::size_t i) const { return even_ ? active_->weights[i] : scale_ * loaded(i); }

private:
    [[nodiscard]] double loaded(std::size_t i) const {
        const double pressure = std::max(0.0, 1.0 + skew_ * active_->skew[i] + crown_ * active_->crown[i]);
        return (by_root_ ? std::sqrt(pressure) : pressure) * active_->weights[i];
    }

    const ActiveEffect* active_;
    double skew_;
    double crown_;
    bool even_;
    bool by_root_;
    double scale_ = 1.0;
};

/// Contact pressure in a zone of the tread over that of the whole tread, as effects in the contact are shared out.
/// @returns 1 where nothing is in contact or the mesh has no such zone
[[nodiscard]] double relative_contact_pressure(const mesh::Mesh& mesh, std::span<const ActiveEffect> effects,
                                               const Laws& laws, std::string_view zone);

}  // namespace tiretherm::physics
