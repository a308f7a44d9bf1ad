// SPDX-License-Identifier: BSD-3-Clause
// A grid as a VTK file. VTK is in a module of its own that is opened for the first grid: it brings some 20 libraries, which would
// be loaded at every start of the program.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::post {

/// Points and cells, and what does not change in time.
struct VtkGridParts {
    /// Which layer or zone a cell belongs to, or what volume it has.
    template <typename Value>
    struct OfCells {
        std::string name;
        std::vector<Value> value;  ///< [n_cells]
    };
    struct Texts {
        std::string name;
        std::vector<std::string> text;
    };

    mesh::CellShape shape = mesh::CellShape::vertex;
    std::vector<mesh::Point> points;  ///< m
    std::vector<int> corners;         ///< [n_cells * corners of a cell] into points
    std::vector<OfCells<int>> integers{};
    std::vector<OfCells<float>> numbers{};
    std::vector<Texts> texts{};
    std::string field{};           ///< name of what changes in time; empty: nothing does
    bool field_at_points = false;  ///< as well as in the cells
};

class VtkGrid {
public:
    VtkGrid() = default;
    VtkGrid(const VtkGrid&) = delete;
    VtkGrid& operator=(const VtkGrid&) = delete;
    virtual ~VtkGrid() = default;

    /// Where the field is to be written: [n_cells], and [n_points] where it is at points.
    [[nodiscard]] virtual std::span<float> in_cells() = 0;
    [[nodiscard]] virtual std::span<float> at_points() = 0;
    /// The bytes of a file of format .vtu, compressed. They are made in memory, so that writing them fails with the system's reason.
    /// @param time s; nothing: the grid stands for all times
    [[nodiscard]] virtual std::string file_text(std::optional<double> time) = 0;
};

/// @errors std::runtime_error with the linker's reason where the module or VTK is not there
[[nodiscard]] std::unique_ptr<VtkGrid> make_vtk_grid(const VtkGridParts& parts);

}  // namespace tiretherm::post
