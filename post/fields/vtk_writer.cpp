// SPDX-License-Identifier: BSD-3-Clause
// Builds the VTK grid of a mesh with layers and zones, writes field files and the series file, and registers the format
// "vtk".

#include "post/fields/vtk_writer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "post/report/file.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr const char* series_name = "field.pvd";
constexpr const char* temperature_name = "temperature [degC]";

std::string field_name(std::size_t index) { return fmt::format("field_{:04}.vtu", index); }

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

/// Which layer or zone each cell belongs to, and what these are called.
/// @param of_node [n_nodes] index into names
void add_parts(vtkUnstructuredGrid* grid, const std::string& what, const std::vector<int>& of_node,
               const std::vector<std::string>& names) {
    if (names.empty()) {
        return;
    }
    vtkNew<vtkIntArray> index;
    index->SetName(what.c_str());
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
        index->InsertNextValue(of_node[static_cast<std::size_t>(cell)]);
    }
    vtkNew<vtkStringArray> words;
    words->SetName((what + " names").c_str());
    for (const std::string& name : names) {
        words->InsertNextValue(name);
    }
    grid->GetCellData()->AddArray(index);
    grid->GetFieldData()->AddArray(words);
}

vtkNew<vtkUnstructuredGrid> drawing(const mesh::Mesh& mesh) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    // The mesh draws its half plane in the middle of its cells; turned about z it must stand at y = 0.
    const bool round = mesh.grid && mesh.grid->metric == mesh::Metric::axisymmetric;
    for (const auto& [x, y, z] : mesh.drawing.points) {
        points->InsertNextPoint(x, round ? 0.0 : y, z);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    const int n = mesh::corners_per_cell(mesh.drawing.shape);
    grid->Allocate(mesh.n_cells);
    std::vector<vtkIdType> corners(static_cast<std::size_t>(n));
    for (auto next = mesh.drawing.corners.begin(); next != mesh.drawing.corners.end(); next += n) {
        std::copy_n(next, n, corners.begin());
        grid->InsertNextCell(cell_type(mesh.drawing.shape), n, corners.data());
    }
    add_parts(grid, "layer", mesh.layer, mesh.layers);
    add_parts(grid, "zone", mesh.zone, mesh.zones);
    return grid;
}

/// The file's bytes are made in memory, so that writing them fails with the system's reason.
std::string file_text(vtkUnstructuredGrid* grid) {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    writer->SetCompressionLevel(1);
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
}

}  // namespace

VtkWriter::VtkWriter(std::filesystem::path directory, const mesh::Mesh& mesh)
    : directory_(std::move(directory)), mesh_(mesh), drawn_(mesh) {
    for (const std::string& name : names_in(directory_)) {
        std::error_code error;
        std::filesystem::remove(directory_ / name, error);
        if (error) {
            throw FileError("remove the earlier fields in", directory_, error.message());
        }
    }
}

std::vector<std::string> VtkWriter::names_in(const std::filesystem::path& directory) {
    std::vector<std::string> names{series_name};
    std::error_code error;
    for (std::size_t i = 0; std::filesystem::exists(symlink_status(directory / field_name(i), error)); ++i) {
        names.push_back(field_name(i));
    }
    return names;
}

void VtkWriter::write(double time, std::span<const double> temperature) {
    const vtkNew<vtkUnstructuredGrid> grid = drawing(mesh_);
    vtkNew<vtkDoubleArray> in_cells;
    in_cells->SetName(temperature_name);
    for (int cell = 0; cell < mesh_.n_cells; ++cell) {
        in_cells->InsertNextValue(solver::celsius(temperature[static_cast<std::size_t>(cell)]));
    }
    grid->GetCellData()->SetScalars(in_cells);
    if (drawn_.exists()) {
        vtkNew<vtkDoubleArray> in_points;
        in_points->SetName(temperature_name);
        for (const double kelvin : drawn_.at_points(temperature)) {
            in_points->InsertNextValue(solver::celsius(kelvin));
        }
        grid->GetPointData()->SetScalars(in_points);
    }
    vtkNew<vtkDoubleArray> moment;
    moment->SetName("TimeValue");  // the name under which readers look for it
    moment->InsertNextValue(time);
    grid->GetFieldData()->AddArray(moment);

    replace_file(directory_ / field_name(times_.size()), file_text(grid));
    times_.push_back(time);
    write_series();
}

void VtkWriter::take(const solver::Snapshot& snapshot) {
    if (snapshot.field) {
        write(snapshot.time, snapshot.temperature);
    }
}

std::filesystem::path VtkWriter::series() const { return directory_ / series_name; }

void VtkWriter::write_series() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\">\n"
        "  <Collection>\n";
    for (std::size_t index = 0; index < times_.size(); ++index) {
        fmt::format_to(std::back_inserter(text), "    <DataSet timestep=\"{:.12g}\" file=\"{}\"/>\n", times_[index],
                       field_name(index));
    }
    text += "  </Collection>\n</VTKFile>\n";
    replace_file(series(), text);
}

namespace formats {

extern const OutputFormat vtk;
const OutputFormat vtk{.name = "vtk",
                       .use = OutputFormat::Use::unless_refused,
                       .help = "No field_*.vtu and field.pvd for ParaView",
                       .open = [](const RunTarget& target) -> std::unique_ptr<RunOutput> {
                           return std::make_unique<VtkWriter>(target.directory, target.problem.mesh);
                       },
                       .names_in = &VtkWriter::names_in};

}  // namespace formats

}  // namespace tiretherm::post
