// SPDX-License-Identifier: BSD-3-Clause
// The temperature field of a run at several moments, for the page's chart with a slider.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diagnosis/hot_spot/hot_spots.hpp"
#include "mesh/mesh.hpp"
#include "post/pictures/drawn_field.hpp"
#include "post/pictures/folded_section.hpp"
#include "post/report/value.hpp"
#include "solver/problem.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// Keeps stored fields as they will be drawn: the folded section of a tire, or the plane through a specimen's thickness. Where
/// there are too many for a page, every second one is left out, but for the last. The field at the hottest step is added.
class FieldFrames {
public:
    explicit FieldFrames(const solver::Problem& problem);

    /// A row of the run; a field is kept where it is due for storing.
    void take(const solver::Snapshot& snapshot);
    /// The field at the hottest step of the run. @param time s  @param temperature [n_nodes] K
    void take_hottest(double time, std::span<const double> temperature);
    /// Whether the mesh has something to draw and a field was taken.
    [[nodiscard]] bool empty() const { return frames_.empty(); }
    /// @param hot_spots marked with their names where they are at each moment; null: none  @pre !empty()
    [[nodiscard]] Value chart(const diagnosis::HotSpots* hot_spots = nullptr) const;
    /// How the chart is read, and the layers from the outside in.
    [[nodiscard]] std::string caption(const diagnosis::HotSpots* hot_spots = nullptr) const;

private:
    struct Frame {
        double time = 0.0;           ///< s
        std::vector<float> celsius;  ///< [polygons]
        double hottest = 0.0;        ///< degC
        std::array<double, 2> at{};  ///< mm, where it is that hot
    };
    [[nodiscard]] bool is_drawn() const;
    [[nodiscard]] Frame frame_of(double time, std::span<const double> temperature) const;
    [[nodiscard]] const mesh::Mesh& drawn_mesh() const { return problem_.mesh.sectors > 1 ? section_ : problem_.mesh; }
    [[nodiscard]] Value outline() const;
    [[nodiscard]] Value::List spots(const diagnosis::HotSpots& hot_spots, const std::vector<const Frame*>& shown) const;
    void thin();

    const solver::Problem& problem_;
    bool folded_ = false;
    mesh::Mesh section_;  ///< of a ring, or empty
    DrawnField drawn_;
    std::optional<FoldedSection> section_shape_;
    solver::HotSpotFinder finder_;  ///< of what is not folded
    std::vector<Frame> frames_;
    std::optional<Frame> hottest_;
    std::size_t stride_ = 1;  ///< of the fields that are kept
    std::size_t seen_ = 0;
    Frame last_;
};

}  // namespace tiretherm::post
