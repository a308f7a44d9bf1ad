// SPDX-License-Identifier: BSD-3-Clause
// VTK files are read back: cells, surface points, folded section, series and every cell shape.

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

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

#include "mesh/ring.hpp"
#include "physics/celsius.hpp"
#include "post/fields/vtk_writer.hpp"
#include "post/report/file.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

constexpr const char* temperature = "temperature [degC]";
constexpr double single = 4e-6;  ///< K: files keep 24 bits, below 64 degC half a unit of the last is 2^-19 K

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
    VtkWriter writer(scratch.path(), problem);
    writer.write(7.5, sample::Moment(problem, 7.5, {}, true).snapshot.temperature);

    const auto reader = read(scratch / "field_0000.vtu");
    vtkUnstructuredGrid* grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfCells(), 2 * problem.mesh.n_cells);  // on both sides of the axis
    EXPECT_EQ(grid->GetCellType(0), VTK_QUAD);
    vtkDataArray* cells = grid->GetCellData()->GetArray(temperature);
    vtkDataArray* layers = grid->GetCellData()->GetArray("layer");
    ASSERT_NE(cells, nullptr);
    ASSERT_NE(layers, nullptr);
    for (int cell = 0; cell < problem.mesh.n_cells; ++cell) {
        const auto at = static_cast<std::size_t>(cell);
        EXPECT_NEAR(cells->GetTuple1(cell), celsius(sample::warmth(problem.mesh.centre[at][2], 7.5)), single);
        EXPECT_EQ(cells->GetTuple1(cell), cells->GetTuple1(problem.mesh.n_cells + cell));
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
    VtkWriter writer(scratch.path(), problem);
    writer.write(0.0, sample::Moment(problem, 0.0, {}, true).snapshot.temperature);

    const auto reader = read(scratch / "field_0000.vtu");
    vtkDataArray* points = reader->GetOutput()->GetPointData()->GetArray(temperature);
    ASSERT_NE(points, nullptr);
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i) {
        const double depth = -reader->GetOutput()->GetPoint(i)[2];
        EXPECT_NEAR(points->GetTuple1(i), celsius(sample::warmth(depth, 0.0)), 4.0 * single);
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
    const solver::Problem problem = sample::problem(mesh);
    VtkWriter(scratch.path(), problem).write(0.0, T);
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
        if (std::abs(place[0] - 0.06) < 1e-7 && std::abs(place[2] - 0.3) < 1e-7) {
            found = true;
            EXPECT_NEAR(points->GetTuple1(i), celsius(306.0), single);
        }
    }
    EXPECT_TRUE(found);
}

TEST(Vtk, SeriesNamesEachFileWithItsTimeAfterEveryWrite) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem);
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
        VtkWriter earlier(scratch.path(), problem);
        earlier.write(0.0, moment.snapshot.temperature);
        earlier.write(1.0, moment.snapshot.temperature);
    }
    VtkWriter writer(scratch.path(), problem);
    writer.write(0.0, moment.snapshot.temperature);
    EXPECT_TRUE(std::filesystem::exists(scratch / "field_0000.vtu"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "field_0001.vtu"));
}

/// What a kind of mesh must look like in a file: the whole tire or specimen.
struct Kind {
    mesh::Mesh mesh;
    int type;
    int copies;     ///< of each cell
    double volume;  ///< m3
    std::array<double, 6> bounds;
};

TEST(Vtk, EveryKindIsWrittenWholeWithItsVolume) {
    // Volumes by hand: two nodes 11 l; 1 m2 x 12 mm; a disc of radius 20 mm, a quarter of a block and a quarter of a plane
    // 40 mm x 40 mm across, each 12 mm thick; the section's is the mesh's, which has no planes of symmetry, and so is the
    // ring's. Bounds are those of the whole; the ring has a radius of 300 mm and a border of sectors at +-3.75 degrees.
    const std::vector<mesh::Layer> stack{{.name = "tread", .thickness = 0.008, .cells = 2},
                                         {.name = "bulk", .thickness = 0.004, .cells = 1}};
    const std::vector<mesh::Segment> side{{.to = 0.02, .cells = 2}};
    const mesh::Mesh section = sample::section();
    const double turned = 0.3 * std::cos(std::numbers::pi / 48.0);
    const double bead = 0.06 + 0.16 / std::numbers::pi;
    const double low = 0.3 - 0.16 / std::numbers::pi;
    const std::vector<Kind> kinds{
        {mesh::build(mesh::TwoNode{.area = 1.0, .surface_volume = 1e-3, .bulk_volume = 1e-2, .bulk_depth = 0.01}),
         VTK_VERTEX,
         1,
         0.011,
         {0.0, 0.0, 0.0, 0.0, -0.01, 0.0}},
        {mesh::build(mesh::Layers{.area = 1.0, .stack = stack}), VTK_LINE, 1, 0.012, {0.5, 0.5, 0.5, 0.5, -0.012, 0.0}},
        {mesh::build(mesh::Axisymmetric{.radius = side, .stack = stack}),
         VTK_QUAD,
         2,
         std::numbers::pi * 4e-4 * 0.012,
         {-0.02, 0.02, 0.0, 0.0, -0.012, 0.0}},
        {mesh::build(mesh::Block{.x = side, .y = {{.to = 0.02, .cells = 1}}, .stack = stack}),
         VTK_QUAD,
         2,
         16e-4 * 0.012,
         {-0.02, 0.02, 0.0, 0.0, -0.012, 0.0}},
        {mesh::build(mesh::Block{.x = side, .y = side, .stack = stack}),
         VTK_HEXAHEDRON,
         4,
         16e-4 * 0.012,
         {-0.02, 0.02, -0.02, 0.02, -0.012, 0.0}},
        {mesh::build(mesh::Block{.x = side, .y = side, .stack = stack, .quarter = false}),
         VTK_HEXAHEDRON,
         1,
         16e-4 * 0.012,
         {-0.02, 0.02, -0.02, 0.02, -0.012, 0.0}},
        {section, VTK_QUAD, 1, section.total_volume(), {-bead, bead, 0.0, 0.0, low, 0.3}},
        {mesh::ring(section, 48),
         VTK_HEXAHEDRON,
         1,
         section.total_volume(),
         {-bead, bead, -turned, turned, -turned, turned}}};
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.mesh.kind);
        const sample::Scratch scratch;
        const solver::Problem problem = sample::problem(kind.mesh);
        VtkWriter writer(scratch.path(), problem);
        std::vector<double> T;
        for (int node = 0; node < kind.mesh.n_nodes; ++node) {
            T.push_back(300.0 + 0.125 * node);
        }
        writer.write(0.0, T);
        writer.finish();
        const auto reader = read(scratch / "field_0000.vtu");
        vtkUnstructuredGrid* grid = reader->GetOutput();
        ASSERT_EQ(grid->GetNumberOfCells(), kind.copies * kind.mesh.n_cells);
        vtkDataArray* volumes = grid->GetCellData()->GetArray("volume [m3]");
        vtkDataArray* cells = grid->GetCellData()->GetArray(temperature);
        vtkDataArray* layers = grid->GetCellData()->GetArray("layer");
        ASSERT_TRUE(volumes != nullptr && cells != nullptr && layers != nullptr);
        double volume = 0.0;
        for (int cell = 0; cell < kind.copies * kind.mesh.n_cells; ++cell) {
            const int of_mesh = cell % kind.mesh.n_cells;
            EXPECT_EQ(grid->GetCellType(cell), kind.type);
            EXPECT_NEAR(cells->GetTuple1(cell), celsius(300.0 + 0.125 * of_mesh), 8e-6 + 1e-7 * of_mesh);
            EXPECT_EQ(layers->GetTuple1(cell), kind.mesh.layer[static_cast<std::size_t>(of_mesh)]);
            volume += volumes->GetTuple1(cell);
        }
        EXPECT_NEAR(volume / kind.volume, 1.0, 1e-6);  // single precision
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_NEAR(grid->GetBounds()[i], kind.bounds[i], 1e-7);
        }
        EXPECT_EQ(grid->GetFieldData()->HasArray("layer names"), 1);
        const bool has_borders = kind.type == VTK_QUAD || kind.type == VTK_HEXAHEDRON;
        EXPECT_EQ(std::filesystem::exists(scratch / "field_borders.vtu"), has_borders);
    }
}

TEST(Vtk, MirroredCellsHaveTheirInsideInside) {
    // A hexahedron whose corners were mirrored without being put in order has a negative volume for every filter of VTK.
    const std::vector<mesh::Segment> side{{.to = 0.02, .cells = 2}};
    const mesh::Mesh mesh =
        mesh::build(mesh::Block{.x = side, .y = side, .stack = {{.name = "tread", .thickness = 0.01, .cells = 1}}});
    const WholeDrawing whole = whole_drawing(mesh);
    ASSERT_EQ(whole.cell.size(), 16u);
    EXPECT_EQ(whole.points.size(), 50u);  // 5 x 5 x 2: those on the planes of symmetry are shared
    for (std::size_t cell = 0; cell < 16; ++cell) {
        const auto corner = [&](std::size_t i) {
            return whole.points[static_cast<std::size_t>(whole.corners[8 * cell + i])];
        };
        const mesh::Point o = corner(0);
        const mesh::Point x = corner(1);
        const mesh::Point y = corner(3);
        const mesh::Point z = corner(4);
        const double volume = (x[0] - o[0]) * (y[1] - o[1]) * (z[2] - o[2]);  // edges along the axes
        EXPECT_NEAR(volume, 1e-6, 1e-15);
    }
}

TEST(Vtk, BordersAreTheOutlineAndWhereLayersMeet) {
    // 4 x 1 mm across (mirrored: 8), 4 + 2 cells deep: outline 2 x (8 + 6), between the layers 8.
    const solver::Problem problem = sample::problem();
    const WholeDrawing whole = whole_drawing(problem.mesh);
    const auto lines = borders(whole, problem.mesh);
    EXPECT_EQ(lines.size(), 36u);
    int between = 0;
    for (const auto& [a, b] : lines) {
        const mesh::Point& from = whole.points[static_cast<std::size_t>(a)];
        const mesh::Point& to = whole.points[static_cast<std::size_t>(b)];
        between += std::abs(from[2] + 0.008) < 1e-12 && std::abs(to[2] + 0.008) < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(between, 8);
}

TEST(Vtk, ViewNamesFilesAndArraysThatAreThereAndTheRangeOfAllTimes) {
    // The sample is coldest at the outer surface at 0 s, 26.85 degC, and hottest 12 mm deep at 60 s: 24 + 60 K more.
    const sample::Scratch scratch;
    solver::Problem problem = sample::problem();
    problem.title = "A \"warm\" spot";
    VtkWriter writer(scratch.path(), problem);
    for (const double time : {0.0, 60.0, 30.0}) {
        writer.write(time, sample::Moment(problem, time, {}, true).snapshot.temperature);
    }
    EXPECT_EQ(writer.files(), std::vector{scratch / "field.pvd"});
    writer.take_hottest(60.0, sample::Moment(problem, 60.0, {}, true).snapshot.temperature);
    EXPECT_FALSE(std::filesystem::exists(scratch / "field_0003.vtu"));  // its moment has one
    writer.finish();
    EXPECT_EQ(writer.files(), (std::vector{scratch / "field.pvd", scratch / "field_view.py"}));
    const std::string view = read_text(writer.view());
    for (const char* line :
         {"TITLE = \"A \\\"warm\\\" spot\"\n", "KIND = \"disc\"\n", "LOWEST = 26.85 ", "HIGHEST = 110.85 ",
          "HOTTEST_TIME = 60 ", "END = 30 ", "LAYERS = [\"tread\",\"bulk\"]\n", "ZONES = []\n"}) {
        EXPECT_NE(view.find(line), std::string::npos) << line << view.substr(0, 1200);
    }
    EXPECT_NE(view.find("TEMPERATURE = \"" + std::string(temperature) + "\""), std::string::npos);
    for (const char* file : {"field.pvd", "field_borders.vtu"}) {
        EXPECT_NE(view.find('"' + std::string(file) + '"'), std::string::npos) << file;
        EXPECT_TRUE(std::filesystem::exists(scratch / file)) << file;
    }
    EXPECT_EQ(view.find(scratch.path().string()), std::string::npos);  // the folder may be moved
    const std::string compiles = fmt::format("python3 -m py_compile '{}'", writer.view().string());
    EXPECT_EQ(std::system(compiles.c_str()), 0);
}

TEST(Vtk, FullOrMissingDirectoryIsAnErrorWithItsPath) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem);
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
// Rows at 0 and 60 s, the hottest step between them: a third file, which stands second in the series; the peak lies between cells.
TEST(Vtk, TheHottestStepIsAddedInItsPlace) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    VtkWriter writer(scratch.path(), problem);
    for (const double time : {0.0, 60.0}) {
        writer.write(time, sample::Moment(problem, time, {}, true).snapshot.temperature);
    }
    writer.take_hottest(45.0, sample::Moment(problem, 100.0, {}, true).snapshot.temperature);
    writer.finish();
    const std::string series = read_text(writer.series());
    EXPECT_LT(series.find("timestep=\"45\" file=\"field_0002.vtu\""), series.find("timestep=\"60\"")) << series;
    const std::string view = read_text(writer.view());
    EXPECT_NE(view.find("HOTTEST_TIME = 45 "), std::string::npos);
    EXPECT_NE(view.find("HIGHEST = 150.85 "), std::string::npos);  // 26.85 + 24 + 100
    EXPECT_NE(view.find("END = 60 "), std::string::npos);
}

}  // namespace tiretherm::post
