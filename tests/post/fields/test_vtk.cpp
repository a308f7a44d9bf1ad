// SPDX-License-Identifier: BSD-3-Clause
// VTK files are read back: cells, surface points, folded section, series and every cell shape.

#include <cmath>

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "post/fields/vtk_writer.hpp"
#include "post/report/file.hpp"
#include "solver/celsius.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

constexpr const char* temperature = "temperature [degC]";

vtkNew<vtkXMLUnstructuredGridReader> read(const std::filesystem::path& path) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader;
}

/// Times and files that field.pvd names; empty when it is not well-formed XML.
std::vector<std::pair<double, std::string>> series(const std::filesystem::path& path) {
    vtkNew<vtkXMLDataParser> parser;
    parser->SetFileName(path.c_str());
    std::vector<std::pair<double, std::string>> found;
    if (parser->Parse() == 0) {
        return found;
    }
    vtkXMLDataElement* collection = parser->GetRootElement()->FindNestedElementWithName("Collection");
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* entry = collection->GetNestedElement(i);
        double time = -1.0;
        entry->GetScalarAttribute("timestep", time);
        found.emplace_back(time, entry->GetAttribute("file"));
    }
    return found;
}

TEST(Vtk, CellsAreReadBackInDegreesCelsius) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem.mesh);
    writer.write(7.5, sample::Moment(problem, 7.5, {}, true).snapshot.temperature);

    const auto reader = read(scratch / "field_0000.vtu");
    vtkUnstructuredGrid* grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfCells(), problem.mesh.n_cells);
    EXPECT_EQ(grid->GetCellType(0), VTK_QUAD);
    vtkDataArray* cells = grid->GetCellData()->GetArray(temperature);
    vtkDataArray* layers = grid->GetCellData()->GetArray("layer");
    ASSERT_NE(cells, nullptr);
    ASSERT_NE(layers, nullptr);
    for (int cell = 0; cell < problem.mesh.n_cells; ++cell) {
        const auto at = static_cast<std::size_t>(cell);
        EXPECT_EQ(cells->GetTuple1(cell), solver::celsius(sample::warmth(problem.mesh.centre[at][2], 7.5)));
        EXPECT_EQ(layers->GetTuple1(cell), problem.mesh.layer[at]);
    }
    auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("layer names"));
    ASSERT_NE(names, nullptr);
    EXPECT_EQ(names->GetValue(0), "tread");
    EXPECT_EQ(names->GetValue(1), "bulk");
    EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 7.5);
}

TEST(Vtk, PointsOfTheSurfaceShowTheSurfaceNotTheOutermostCells) {
    // The sample is straight in depth, so every point must carry exactly its depth's temperature: 26.85 degC on top.
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem.mesh);
    writer.write(0.0, sample::Moment(problem, 0.0, {}, true).snapshot.temperature);

    const auto reader = read(scratch / "field_0000.vtu");
    vtkDataArray* points = reader->GetOutput()->GetPointData()->GetArray(temperature);
    ASSERT_NE(points, nullptr);
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i) {
        const double depth = -reader->GetOutput()->GetPoint(i)[2];
        EXPECT_NEAR(points->GetTuple1(i), solver::celsius(sample::warmth(depth, 0.0)), 1e-10);
        EXPECT_EQ(reader->GetOutput()->GetPoint(i)[1], 0.0);  // or turning the half plane about z would make a tube
    }
}

TEST(Vtk, SectionIsFoldedWithItsLayersAndZones) {
    // Crown and two sidewalls at 300 K + 100 K/m along the meridian: the point 60 mm inboard of the centre, where the crown
    // ends, stands at 306 K, 27.85 + 5 degC; x is the distance from the centre plane, z the radius.
    const sample::Scratch scratch;
    const mesh::Mesh mesh = sample::section();
    std::vector<double> T;
    for (const mesh::Point& centre : mesh.centre) {
        T.push_back(300.0 + 100.0 * centre[0]);
    }
    VtkWriter(scratch.path(), mesh).write(0.0, T);
    const auto reader = read(scratch / "field_0000.vtu");
    vtkUnstructuredGrid* grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfCells(), mesh.n_cells);
    vtkDataArray* zones = grid->GetCellData()->GetArray("zone");
    ASSERT_NE(zones, nullptr);
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        EXPECT_EQ(zones->GetTuple1(cell), mesh.zone[static_cast<std::size_t>(cell)]);
    }
    auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("zone names"));
    ASSERT_NE(names, nullptr);
    EXPECT_EQ(names->GetValue(1), "crown");
    EXPECT_NE(grid->GetFieldData()->GetAbstractArray("layer names"), nullptr);
    vtkDataArray* points = grid->GetPointData()->GetArray(temperature);
    ASSERT_NE(points, nullptr);
    bool found = false;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
        const double* place = grid->GetPoint(i);
        if (std::abs(place[0] - 0.06) < 1e-9 && std::abs(place[2] - 0.3) < 1e-9) {
            found = true;
            EXPECT_NEAR(points->GetTuple1(i), solver::celsius(306.0), 1e-6);
        }
    }
    EXPECT_TRUE(found);
}

TEST(Vtk, SeriesNamesEachFileWithItsTimeAfterEveryWrite) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem.mesh);
    std::vector<std::pair<double, std::string>> expected;
    for (int i = 0; i < 3; ++i) {
        const double time = 0.1 * i;
        writer.write(time, sample::Moment(problem, time, {}, true).snapshot.temperature);
        expected.emplace_back(time, fmt::format("field_000{}.vtu", i));
        EXPECT_EQ(series(writer.series()), expected);
        EXPECT_TRUE(std::filesystem::exists(scratch / expected.back().second));
    }
    EXPECT_FALSE(std::filesystem::exists(scratch / "field.pvd.part"));
}

TEST(Vtk, SeriesOfALongerEarlierRunIsRemoved) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    const sample::Moment moment(problem, 0.0, {}, true);
    {
        VtkWriter earlier(scratch.path(), problem.mesh);
        earlier.write(0.0, moment.snapshot.temperature);
        earlier.write(1.0, moment.snapshot.temperature);
    }
    VtkWriter writer(scratch.path(), problem.mesh);
    writer.write(0.0, moment.snapshot.temperature);
    EXPECT_TRUE(std::filesystem::exists(scratch / "field_0000.vtu"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "field_0001.vtu"));
}

TEST(Vtk, EveryShapeOfCellIsWritten) {
    const std::vector<mesh::Layer> stack{{.name = "tread", .thickness = 0.012, .cells = 3}};
    const std::vector<mesh::Segment> side{{.to = 0.02, .cells = 2}};
    const std::vector<std::pair<mesh::Mesh, int>> meshes{
        {mesh::build(mesh::TwoNode{.area = 1.0, .surface_volume = 1e-3, .bulk_volume = 1e-2, .bulk_depth = 0.01}),
         VTK_VERTEX},
        {mesh::build(mesh::Layers{.area = 1.0, .stack = stack}), VTK_LINE},
        {mesh::build(mesh::Axisymmetric{.radius = side, .stack = stack}), VTK_QUAD},
        {mesh::build(mesh::Block{.x = side, .y = side, .stack = stack}), VTK_HEXAHEDRON}};
    for (const auto& [mesh, type] : meshes) {
        const sample::Scratch scratch;
        VtkWriter writer(scratch.path(), mesh);
        writer.write(0.0, std::vector<double>(static_cast<std::size_t>(mesh.n_nodes), 300.0));
        const auto reader = read(scratch / "field_0000.vtu");
        EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), mesh.n_cells);
        EXPECT_EQ(reader->GetOutput()->GetCellType(mesh.n_cells - 1), type);
    }
}

TEST(Vtk, FullOrMissingDirectoryIsAnErrorWithItsPath) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem.mesh);
    std::filesystem::remove_all(scratch.path());
    try {
        writer.write(0.0, sample::Moment(problem, 0.0, {}, true).snapshot.temperature);
        FAIL() << "a field was written into a directory that is gone";
    } catch (const FileError& error) {
        EXPECT_EQ(error.what(), fmt::format("cannot create {}: No such file or directory",
                                            (scratch / "field_0000.vtu.part").string()));
    }
}

}  // namespace
}  // namespace tiretherm::post
