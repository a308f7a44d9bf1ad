// SPDX-License-Identifier: BSD-3-Clause
// Builds the VTK grid of a mesh with layers and zones once, writes it with each field, and registers the format "vtk".

#include "post/fields/vtk_writer.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <system_error>
#include <utility>

#include <fmt/format.h>
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

#include "physics/celsius.hpp"
#include "post/fields/field_view.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

constexpr const char* series_name = "field.pvd";
constexpr const char* borders_name = "field_borders.vtu";
constexpr const char* view_name = "field_view.py";
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

void add_texts(vtkUnstructuredGrid* grid, const std::string& name, const std::vector<std::string>& texts) {
    vtkNew<vtkStringArray> words;
    words->SetName(name.c_str());
    for (const std::string& text : texts) {
        words->InsertNextValue(text);
    }
    grid->GetFieldData()->AddArray(words);
}

/// Which layer or zone each cell belongs to, and what these are called.
/// @param of_node [n_nodes] index into names
void add_parts(vtkUnstructuredGrid* grid, const WholeDrawing& whole, const std::string& what,
               const std::vector<int>& of_node, const std::vector<std::string>& names) {
    if (names.empty()) {
        return;
    }
    vtkNew<vtkIntArray> index;
    index->SetName(what.c_str());
    for (const int cell : whole.cell) {
        index->InsertNextValue(of_node[static_cast<std::size_t>(cell)]);
    }
    grid->GetCellData()->AddArray(index);
    add_texts(grid, what + " names", names);
}

/// Points and cells, in numbers as short as they may be.
/// @param corners [n_cells * of_a_cell]
void fill(vtkUnstructuredGrid* grid, const std::vector<mesh::Point>& places, int type, std::span<const int> corners,
          std::size_t of_a_cell) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    for (const auto& [x, y, z] : places) {
        points->InsertNextPoint(x, y, z);
    }
    grid->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    cells->Use32BitStorage();
    std::vector<vtkIdType> ids(of_a_cell);
    for (auto next = corners.begin(); next != corners.end(); next += static_cast<std::ptrdiff_t>(of_a_cell)) {
        std::copy_n(next, of_a_cell, ids.begin());
        cells->InsertNextCell(static_cast<vtkIdType>(of_a_cell), ids.data());
    }
    grid->SetCells(type, cells);
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

struct VtkWriter::Grid {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkFloatArray> in_cells;   ///< degC
    vtkNew<vtkFloatArray> in_points;  ///< degC
    vtkNew<vtkDoubleArray> time;      ///< s
};

VtkWriter::VtkWriter(std::filesystem::path directory, const solver::Problem& problem)
    : directory_(std::move(directory)),
      problem_(problem),
      drawn_(problem.mesh),
      whole_(whole_drawing(problem.mesh)),
      grid_(std::make_unique<Grid>()),
      finder_(problem.mesh, solver::nodes_of_layers(problem.mesh)) {
    for (const std::string& name : names_in(directory_)) {
        std::error_code error;
        std::filesystem::remove(directory_ / name, error);
        if (error) {
            throw FileError("remove the earlier fields in", directory_, error.message());
        }
    }
    vtkUnstructuredGrid* grid = grid_->grid;
    const mesh::Mesh& mesh = problem.mesh;
    fill(grid, whole_.points, cell_type(whole_.shape), whole_.corners,
         static_cast<std::size_t>(mesh::corners_per_cell(whole_.shape)));
    add_parts(grid, whole_, "layer", mesh.layer, mesh.layers);
    add_parts(grid, whole_, "zone", mesh.zone, mesh.zones);
    vtkNew<vtkFloatArray> volume;
    volume->SetName("volume [m3]");
    for (const double cell : whole_.volume) {
        volume->InsertNextValue(static_cast<float>(cell));
    }
    grid->GetCellData()->AddArray(volume);
    grid_->in_cells->SetName(temperature_name);
    grid_->in_cells->SetNumberOfValues(grid->GetNumberOfCells());
    grid->GetCellData()->SetScalars(grid_->in_cells);
    if (drawn_.exists()) {
        grid_->in_points->SetName(temperature_name);
        grid_->in_points->SetNumberOfValues(grid->GetNumberOfPoints());
        grid->GetPointData()->SetScalars(grid_->in_points);
    }
    grid_->time->SetName("TimeValue");  // the name under which readers look for it
    grid_->time->SetNumberOfValues(1);
    grid->GetFieldData()->AddArray(grid_->time);
    add_texts(grid, "title", {problem.title.empty() ? problem.name : problem.title});
}

VtkWriter::~VtkWriter() = default;

std::vector<std::string> VtkWriter::names_in(const std::filesystem::path& directory) {
    std::vector<std::string> names{series_name, borders_name, view_name};
    std::error_code error;
    for (std::size_t i = 0; std::filesystem::exists(symlink_status(directory / field_name(i), error)); ++i) {
        names.push_back(field_name(i));
    }
    return names;
}

void VtkWriter::write(double time, std::span<const double> temperature) {
    const auto see = [&](double celsius) {
        low_ = std::min(low_, celsius);
        high_ = std::max(high_, celsius);
        return static_cast<float>(celsius);
    };
    hottest_time_ = end_ = time;  // until the run says otherwise
    for (std::size_t cell = 0; cell < whole_.cell.size(); ++cell) {
        grid_->in_cells->SetValue(static_cast<vtkIdType>(cell),
                                  see(celsius(temperature[static_cast<std::size_t>(whole_.cell[cell])])));
    }
    if (drawn_.exists()) {
        const std::vector<double> at_points = drawn_.at_points(temperature);
        for (std::size_t point = 0; point < whole_.point.size(); ++point) {
            grid_->in_points->SetValue(static_cast<vtkIdType>(point),
                                       see(celsius(at_points[static_cast<std::size_t>(whole_.point[point])])));
        }
    }
    grid_->time->SetValue(0, time);
    replace_file(directory_ / field_name(times_.size()), file_text(grid_->grid));
    times_.push_back(time);
    write_series();
}

void VtkWriter::take(const solver::Snapshot& snapshot) {
    if (snapshot.field) {
        write(snapshot.time, snapshot.temperature);
    }
}

void VtkWriter::take_hottest(double time, std::span<const double> temperature) {
    const double end = end_;
    if (std::ranges::find(times_, time) == times_.end()) {
        write(time, temperature);
    }
    end_ = end;
    hottest_time_ = time;
    // The peak lies between the centres of cells.
    high_ = std::max(high_, celsius(finder_.find(temperature).temperature));
}

void VtkWriter::finish() {
    if (times_.empty()) {
        return;
    }
    std::vector<int> ends;
    for (const auto& line : borders(whole_, problem_.mesh)) {
        ends.insert(ends.end(), line.begin(), line.end());
    }
    std::vector<mesh::Point> places;
    std::vector<int> number(whole_.points.size(), -1);
    for (int& end : ends) {
        int& known = number[static_cast<std::size_t>(end)];
        if (known < 0) {
            known = static_cast<int>(places.size());
            places.push_back(whole_.points[static_cast<std::size_t>(end)]);
        }
        end = known;
    }
    if (!ends.empty()) {
        vtkNew<vtkUnstructuredGrid> lines;
        fill(lines, places, VTK_LINE, ends, 2);
        replace_file(directory_ / borders_name, file_text(lines));
    }
    write_view();
    has_view_ = true;
}

std::filesystem::path VtkWriter::series() const { return directory_ / series_name; }
std::filesystem::path VtkWriter::view() const { return directory_ / view_name; }

std::vector<std::filesystem::path> VtkWriter::files() const {
    std::vector<std::filesystem::path> all{series()};
    if (has_view_) {
        all.push_back(view());
    }
    return all;
}

void VtkWriter::write_series() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\">\n"
        "  <!-- timestep: s -->\n"
        "  <Collection>\n";
    std::vector<std::size_t> order(times_.size());  // the hottest field is written last
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::size_t index) { return times_[index]; });
    for (const std::size_t index : order) {
        fmt::format_to(std::back_inserter(text), "    <DataSet timestep=\"{:.12g}\" file=\"{}\"/>\n", times_[index],
                       field_name(index));
    }
    text += "  </Collection>\n</VTKFile>\n";
    replace_file(series(), text);
}

void VtkWriter::write_view() const {
    replace_file(view(), field_view({.problem = problem_,
                                     .shape = whole_.shape,
                                     .low = low_,
                                     .high = high_,
                                     .hottest_time = hottest_time_,
                                     .end = end_}));
}

namespace formats {

extern const OutputFormat vtk;
const OutputFormat vtk{.name = "vtk",
                       .use = OutputFormat::Use::unless_refused,
                       .help = "No field_*.vtu, field.pvd and field_view.py for ParaView",
                       .open = [](const RunTarget& target) -> std::unique_ptr<RunOutput> {
                           return std::make_unique<VtkWriter>(target.directory, target.problem);
                       },
                       .names_in = &VtkWriter::names_in};

}  // namespace formats

}  // namespace tiretherm::post
