// SPDX-License-Identifier: BSD-3-Clause
// Output format "vtk": temperature fields as a time series for ParaView (.vtu files and field.pvd).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "post/fields/output_format.hpp"
#include "post/pictures/drawn_field.hpp"

namespace tiretherm::post {

/// A series of fields for ParaView: field_0000.vtu, field_0001.vtu ... and field.pvd with their times.
///
/// Cells carry "temperature [degC]", "layer" and, on a section, "zone"; a mesh with places carries "temperature [degC]" at
/// its points too. z is upwards, the outer surface at 0. An axisymmetric mesh is the half plane y = 0, x = radius:
/// ParaView's filters "Extract Surface" and then "Rotational Extrusion" make the body of it. A section is drawn folded:
/// x is the distance from the centre plane, inboard positive, z the radius.
///
/// Each file is renamed into place when it is whole, and field.pvd names only files that are.
class VtkWriter final : public RunOutput {
public:
    /// Removes the series of an earlier run from the directory.
    /// @param mesh must outlive the writer   @errors FileError
    VtkWriter(std::filesystem::path directory, const mesh::Mesh& mesh);

    /// field.pvd and all field_*.vtu of an earlier run.
    [[nodiscard]] static std::vector<std::string> names_in(const std::filesystem::path& directory);

    /// @param time s  @param temperature [n_nodes] K   @errors FileError
    void write(double time, std::span<const double> temperature);

    /// Writes the field of a snapshot that has one. @errors FileError
    void take(const solver::Snapshot& snapshot) override;
    [[nodiscard]] std::vector<std::filesystem::path> files() const override { return {series()}; }

    [[nodiscard]] std::filesystem::path series() const;

private:
    void write_series() const;

    std::filesystem::path directory_;
    const mesh::Mesh& mesh_;
    DrawnField drawn_;
    std::vector<double> times_;
};

}  // namespace tiretherm::post
