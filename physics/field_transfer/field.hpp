// SPDX-License-Identifier: BSD-3-Clause
// Field of a structural code on the nodes of a mesh (contact pressure, friction power or loss): how a total power is
// distributed, at one time or several.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tiretherm::physics {

/// What an effect takes from a field of a structural code.
enum class FieldOf : std::uint8_t {
    nothing,
    pressure,  ///< of the contact: where an exchange with the road happens
    friction,  ///< power per area of the contact
    loss       ///< power per volume
};

/// Frames of one effect's field; more would only make every step dearer.
inline constexpr int most_frames = 256;

/// A field of a structural code on the nodes of a mesh: how a total is shared out, at one time or at several.
struct Field {
    std::vector<int> nodes;
    std::vector<double> time;  ///< [n_frames] s since the run's start, ascending; empty: one for all times
    std::vector<std::vector<double>> weights;  ///< [n_frames][nodes], each frame sums to 1
    std::vector<double> watts;                 ///< [n_frames] W of the file; empty: the total is the effect's own law's

    [[nodiscard]] std::size_t frames() const { return weights.size(); }
    /// How far each frame counts at a moment: straight between two frames, held beyond the first and the last.
    /// @param moment s since the run's start  @param out [>= n_frames], sums to 1; what is left over becomes 0
    void shares_at(double moment, std::span<double> out) const;
    /// Power of the file at a moment, that of each frame apart. @pre watts are given  @param out as above, W
    void watts_at(double moment, std::span<double> out) const;
};

}  // namespace tiretherm::physics
