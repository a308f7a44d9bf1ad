// SPDX-License-Identifier: BSD-3-Clause
// The module with VTK in it: builds a grid once and writes it with each field.

#include <algorithm>
#include <memory>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "post/fields/vtk_grid.hpp"

namespace tiretherm::post {

namespace {

int cell_type(mesh::CellShape shape) {
    switch (shape) {
        case mesh::CellShape::vertex:
            return VTK_VERTEX;
        case mesh::CellShape::line:
            return VTK_LINE;
        case mesh::CellShape::quadrilateral:
            return VTK_QUAD;
        case mesh::CellShape::hexahedron:
            return VTK_HEXAHEDRON;
    }
    return VTK_EMPTY_CELL;
}

template <typename Array, typename Value>
void add_to_cells(vtkUnstructuredGrid* grid, const VtkGridParts::OfCells<Value>& of_cells) {
    vtkNew<Array> values;
    values->SetName(of_cells.name.c_str());
    for (const Value value : of_cells.value) {
        values->InsertNextValue(value);
    }
    grid->GetCellData()->AddArray(values);
}

/// Points and cells are written in numbers as short as they may be.
class Grid final : public VtkGrid {
public:
    explicit Grid(const VtkGridParts& parts) {
        vtkNew<vtkPoints> points;
        points->SetDataTypeToFloat();
        for (const auto& [x, y, z] : parts.points) {
            points->InsertNextPoint(x, y, z);
        }
        grid_->SetPoints(points);
        vtkNew<vtkCellArray> cells;
        cells->Use32BitStorage();
        const int of_a_cell = mesh::corners_per_cell(parts.shape);
        std::vector<vtkIdType> ids(static_cast<std::size_t>(of_a_cell));
        for (auto next = parts.corners.begin(); next != parts.corners.end(); next += of_a_cell) {
            std::copy_n(next, of_a_cell, ids.begin());
            cells->InsertNextCell(of_a_cell, ids.data());
        }
        grid_->SetCells(cell_type(parts.shape), cells);
        for (const auto& integers : parts.integers) {
            add_to_cells<vtkIntArray>(grid_, integers);
        }
        for (const auto& numbers : parts.numbers) {
            add_to_cells<vtkFloatArray>(grid_, numbers);
        }
        for (const VtkGridParts::Texts& texts : parts.texts) {
            vtkNew<vtkStringArray> words;
            words->SetName(texts.name.c_str());
            for (const std::string& text : texts.text) {
                words->InsertNextValue(text);
            }
            grid_->GetFieldData()->AddArray(words);
        }
        time_->SetName("TimeValue");  // the name under which readers look for it
        if (!parts.field.empty()) {
            in_cells_->SetName(parts.field.c_str());
            in_cells_->SetNumberOfValues(grid_->GetNumberOfCells());
            grid_->GetCellData()->SetScalars(in_cells_);
        }
        if (parts.field_at_points) {
            at_points_->SetName(parts.field.c_str());
            at_points_->SetNumberOfValues(grid_->GetNumberOfPoints());
            grid_->GetPointData()->SetScalars(at_points_);
        }
    }

    [[nodiscard]] std::span<float> in_cells() override { return values_of(*in_cells_.Get()); }
    [[nodiscard]] std::span<float> at_points() override { return values_of(*at_points_.Get()); }

    [[nodiscard]] std::string file_text(std::optional<double> time) override {
        if (time) {
            time_->SetNumberOfValues(1);
            time_->SetValue(0, *time);
            grid_->GetFieldData()->AddArray(time_);
        }
        in_cells_->Modified();
        at_points_->Modified();
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->SetInputData(grid_);
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
        writer->SetCompressorTypeToZLib();
        writer->SetCompressionLevel(1);
        writer->WriteToOutputStringOn();
        writer->Write();
        return writer->GetOutputString();
    }

private:
    static std::span<float> values_of(vtkFloatArray& array) {
        return {array.GetPointer(0), static_cast<std::size_t>(array.GetNumberOfValues())};
    }

    vtkNew<vtkUnstructuredGrid> grid_;
    vtkNew<vtkFloatArray> in_cells_;
    vtkNew<vtkFloatArray> at_points_;
    vtkNew<vtkDoubleArray> time_;  ///< s
};

}  // namespace

}  // namespace tiretherm::post

/// @returns to be deleted by the caller
extern "C" __attribute__((visibility("default"))) tiretherm::post::VtkGrid* tiretherm_make_vtk_grid(
    const tiretherm::post::VtkGridParts& parts) {
    return std::make_unique<tiretherm::post::Grid>(parts).release();
}
