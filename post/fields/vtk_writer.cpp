// SPDX-License-Identifier: BSD-3-Clause
// Describes a mesh with layers and zones to VTK once, has it written with each field, and registers the format "vtk".

#include "post/fields/vtk_writer.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <system_error>
#include <utility>

#include <fmt/format.h>

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

/// Which layer or zone each cell belongs to, and what these are called.
/// @param of_node [n_nodes] index into names
void add_parts(VtkGridParts& grid, const WholeDrawing& whole, const std::string& what, const std::vector<int>& of_node,
               const std::vector<std::string>& names) {
    if (names.empty()) {
        return;
    }
    std::vector<int> index;
    for (const int cell : whole.cell) {
        index.push_back(of_node[static_cast<std::size_t>(cell)]);
    }
    grid.integers.push_back({.name = what, .value = std::move(index)});
    grid.texts.push_back({.name = what + " names", .text = names});
}

VtkGridParts parts_of(const WholeDrawing& whole, const solver::Problem& problem, bool has_points) {
    VtkGridParts grid{.shape = whole.shape,
                      .points = whole.points,
                      .corners = whole.corners,
                      .field = temperature_name,
                      .field_at_points = has_points};
    add_parts(grid, whole, "layer", problem.mesh.layer, problem.mesh.layers);
    add_parts(grid, whole, "zone", problem.mesh.zone, problem.mesh.zones);
    grid.numbers.push_back({.name = "volume [m3]", .value{whole.volume.begin(), whole.volume.end()}});
    grid.texts.push_back({.name = "title", .text = {problem.title.empty() ? problem.name : problem.title}});
    return grid;
}

}  // namespace

VtkWriter::VtkWriter(std::filesystem::path directory, const solver::Problem& problem)
    : directory_(std::move(directory)),
      problem_(problem),
      drawn_(problem.mesh),
      whole_(whole_drawing(problem.mesh)),
      grid_(make_vtk_grid(parts_of(whole_, problem, drawn_.exists()))),
      finder_(problem.mesh, solver::nodes_of_layers(problem.mesh)) {
    for (const std::string& name : names_in(directory_)) {
        std::error_code error;
        std::filesystem::remove(directory_ / name, error);
        if (error) {
            throw FileError("remove the earlier fields in", directory_, error.message());
        }
    }
}

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
    std::ranges::transform(whole_.cell, grid_->in_cells().begin(),
                           [&](int cell) { return see(celsius(temperature[static_cast<std::size_t>(cell)])); });
    if (drawn_.exists()) {
        const std::vector<double> at_points = drawn_.at_points(temperature);
        std::ranges::transform(whole_.point, grid_->at_points().begin(),
                               [&](int point) { return see(celsius(at_points[static_cast<std::size_t>(point)])); });
    }
    replace_file(directory_ / field_name(times_.size()), grid_->file_text(time));
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
        const auto lines =
            make_vtk_grid({.shape = mesh::CellShape::line, .points = std::move(places), .corners = std::move(ends)});
        replace_file(directory_ / borders_name, lines->file_text({}));
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
