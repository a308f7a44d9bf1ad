// SPDX-License-Identifier: BSD-3-Clause
// The temperature field of a run at several moments, for the page's chart with a slider.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diagnosis/hot_spot/hot_spots.hpp"
#include "mesh/mesh.hpp"
#include "post/page/drawn_field.hpp"
#include "post/page/folded_section.hpp"
#include "post/page/moments.hpp"
#include "post/page/tread_chart.hpp"
#include "post/report/value.hpp"
#include "solver/problem.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// Keeps stored fields as they will be drawn: the folded section of a tire, or the plane through a specimen's thickness; of a
/// ring its tread as well. The field at the hottest step is added.
class FieldFrames {
public:
    explicit FieldFrames(const solver::Problem& problem);

    /// A row of the run; a field is kept where it is due for storing.
    void take(const solver::Snapshot& snapshot);
    /// The field at the hottest step of the run. @param time s  @param temperature [n_nodes] K
    void take_hottest(double time, std::span<const double> temperature);
    /// Whether the mesh has something to draw and a field was taken.
    [[nodiscard]] bool empty() const { return moments_.empty(); }
    /// @param hot_spots marked with their names where they are at each moment; null: none  @pre !empty()
    [[nodiscard]] Value chart(const diagnosis::HotSpots* hot_spots = nullptr) const;
    /// How the chart is read, and the layers from the outside in.
    [[nodiscard]] std::string caption(const diagnosis::HotSpots* hot_spots = nullptr) const;
    /// Of a ring its tread, unrolled; null of others.
    [[nodiscard]] const TreadFrames* tread() const { return tread_ ? &*tread_ : nullptr; }

private:
    [[nodiscard]] bool is_drawn() const;
    [[nodiscard]] Moment moment_of(double time, std::span<const double> temperature) const {
        return folded_ ? of_section(time, temperature) : of_plane(time, temperature);
    }
    [[nodiscard]] Moment of_plane(double time, std::span<const double> temperature) const;
    [[nodiscard]] Moment of_section(double time, std::span<const double> temperature) const;
    [[nodiscard]] const mesh::Mesh& drawn_mesh() const { return problem_.mesh.is_ring() ? section_ : problem_.mesh; }
    [[nodiscard]] Value::List spots(const diagnosis::HotSpots& hot_spots, const std::vector<Moment>& shown) const;

    const solver::Problem& problem_;
    bool folded_ = false;
    mesh::Mesh section_;  ///< of a ring, or empty
    DrawnField drawn_;
    std::optional<FoldedSection> section_shape_;
    solver::HotSpotFinder finder_;  ///< of what is not folded
    Moments moments_;
    std::optional<TreadFrames> tread_;
};

}  // namespace tiretherm::post
