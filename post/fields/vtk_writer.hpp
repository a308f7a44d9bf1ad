// SPDX-License-Identifier: BSD-3-Clause
// Output format "vtk": temperature fields as a time series for ParaView (.vtu files and field.pvd), with a view of it.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "post/fields/output_format.hpp"
#include "post/fields/vtk_grid.hpp"
#include "post/fields/whole_drawing.hpp"
#include "post/page/drawn_field.hpp"
#include "solver/hot_spot_finder.hpp"

namespace tiretherm::post {

/// A series of fields for ParaView: field_0000.vtu, field_0001.vtu ... and field.pvd with their times in s; field_borders.vtu
/// with the lines where layers and zones meet; field_view.py, a state file that shows all of it.
///
/// What is drawn is the whole tire or specimen in metres: a section folded (x is the distance from the centre plane, inboard
/// positive, z the radius), a ring about its axis x, a quarter of a block with its mirror images, a disc as the plane through
/// its axis. Elsewhere z is upwards, the outer surface at 0.
///
/// Cells carry "temperature [degC]", "volume [m3]", "layer" and, on a section, "zone"; "layer names" and "zone names" among
/// the field data say what these numbers mean. A mesh with places carries "temperature [degC]" at its points too. Numbers
/// are of single precision: 8 microkelvin at 100 degC.
///
/// Each file is renamed into place when it is whole, and field.pvd names only files that are.
class VtkWriter final : public RunOutput {
public:
    /// Removes the series of an earlier run from the directory.
    /// @param problem must outlive the writer   @errors FileError
    VtkWriter(std::filesystem::path directory, const solver::Problem& problem);

    /// All files that an earlier run has left.
    [[nodiscard]] static std::vector<std::string> names_in(const std::filesystem::path& directory);

    /// @param time s  @param temperature [n_nodes] K   @errors FileError
    void write(double time, std::span<const double> temperature);

    /// Writes the field of a snapshot that has one. @errors FileError
    void take(const solver::Snapshot& snapshot) override;
    /// Writes the field of the hottest step, where its moment has none yet. @errors FileError
    void take_hottest(double time, std::span<const double> temperature) override;
    /// Writes borders and view. @errors FileError
    void finish() override;
    [[nodiscard]] std::vector<std::filesystem::path> files() const override;

    [[nodiscard]] std::filesystem::path series() const;
    [[nodiscard]] std::filesystem::path view() const;

private:
    void write_series() const;
    void write_view() const;

    std::filesystem::path directory_;
    const solver::Problem& problem_;
    DrawnField drawn_;
    WholeDrawing whole_;
    std::unique_ptr<VtkGrid> grid_;
    std::vector<double> times_;
    double low_ = 1e300;  ///< degC, of all that is drawn at all times
    double high_ = -1e300;
    double hottest_time_ = 0.0;
    double end_ = 0.0;  ///< s, of the last row with a field
    solver::HotSpotFinder finder_;
    bool has_view_ = false;
};

}  // namespace tiretherm::post
