// SPDX-License-Identifier: BSD-3-Clause
// Interfaces, symmetry, isotherms and colours of pictures against hand calculation, and pixels of the PNG files.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/ring.hpp"
#include "post/pictures/isotherms.hpp"
#include "post/pictures/picture.hpp"
#include "post/report/file.hpp"
#include "solver/celsius.hpp"
#include "tests/post/png_pixels.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

std::vector<double> field(const solver::Problem& problem, double (*kelvin)(const mesh::Point&)) {
    std::vector<double> result;
    for (const mesh::Point& centre : problem.mesh.centre) {
        result.push_back(kelvin(centre));
    }
    return result;
}

/// Width and height from the header of a PNG.
std::pair<unsigned, unsigned> png_size(const std::string& bytes) {
    const auto word = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = at; i < at + 4; ++i) {
            value = value << 8U | static_cast<unsigned char>(bytes[i]);
        }
        return value;
    };
    return {word(16), word(20)};
}

TEST(SectionPlane, ShowsTheSurfaceAndIsStraightBetweenCells) {
    const solver::Problem problem = sample::problem();
    const SectionPlane plane = section_plane(
        problem, field(problem, [](const mesh::Point& p) { return sample::warmth(p[2], 0.0); }), Shading::smooth);
    const std::vector<double> depth{0.0, 0.0005, 0.007, 0.012};
    const std::vector<double> shown = plane.sample(std::vector<double>{0.001}, depth);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        EXPECT_NEAR(shown[i], sample::warmth(depth[i], 0.0), 1e-9);
    }
}

TEST(SectionPlane, LeftHalfMirrorsTheRight) {
    const solver::Problem problem = sample::problem();
    const SectionPlane plane = section_plane(
        problem, field(problem, [](const mesh::Point& p) { return 300.0 + 1e5 * p[0] * p[0]; }), Shading::smooth);
    EXPECT_EQ(plane.left(), -0.02);
    EXPECT_EQ(plane.right(), 0.02);
    const std::vector<double> shown =
        plane.sample(std::vector<double>{-0.013, 0.013, 0.002}, std::vector<double>{0.004});
    EXPECT_EQ(shown[0], shown[1]);
    EXPECT_GT(shown[1], shown[2] + 10.0);
}

TEST(SectionPlane, InterfaceHasTheTemperatureThatMakesTheFluxEqual) {
    // Cells 2 mm deep on both sides of 8 mm, at 360 K and 300 K, k = 0.9 and 0.1: (0.9 * 360 + 0.1 * 300) / 1.0 = 354 K.
    solver::Problem problem = sample::problem();
    problem.materials[0].conductivity.fill(physics::Curve::constant(0.9));
    problem.materials[1].conductivity.fill(physics::Curve::constant(0.1));
    const SectionPlane plane = section_plane(
        problem, field(problem, [](const mesh::Point& p) { return p[2] < 0.008 ? 360.0 : 300.0; }), Shading::smooth);
    EXPECT_NEAR(plane.sample(std::vector<double>{0.01}, std::vector<double>{0.008})[0], 354.0, 1e-9);
}

TEST(SectionPlane, FlatShadingShowsTheCellsThemselves) {
    const solver::Problem problem = sample::problem();
    const SectionPlane plane = section_plane(
        problem, field(problem, [](const mesh::Point& p) { return sample::warmth(p[2], 0.0); }), Shading::cells);
    const std::vector<double> shown =
        plane.sample(std::vector<double>{0.001}, std::vector<double>{0.0, 0.0019, 0.0021});
    EXPECT_EQ(shown[0], sample::warmth(0.001, 0.0));
    EXPECT_EQ(shown[1], shown[0]);
    EXPECT_EQ(shown[2], sample::warmth(0.003, 0.0));
}

TEST(SectionPlane, RimWithoutChangeIsCutAndAHotOneIsNot) {
    const solver::Problem problem = sample::problem(mesh::build(mesh::Axisymmetric{
        .radius = {{.to = 0.06, .cells = 60}}, .stack = {{.name = "tread", .thickness = 0.008, .cells = 4}}}));
    SectionPlane spot = section_plane(
        problem, field(problem, [](const mesh::Point& p) { return 300.0 + 80.0 * std::exp(-1e4 * p[0] * p[0]); }),
        Shading::smooth);
    crop_uniform_rim(spot);
    // 5 % of the range is left at sqrt(ln 20) cm = 17.3 mm; the next column is 1 mm further at most.
    EXPECT_NEAR(spot.right(), 0.0178, 0.0007);
    EXPECT_EQ(spot.kelvin.size(), spot.x.size() * spot.depth.size());

    SectionPlane slope = section_plane(problem, field(problem, [](const mesh::Point& p) { return 300.0 + 1e3 * p[0]; }),
                                       Shading::smooth);
    crop_uniform_rim(slope);
    EXPECT_EQ(slope.right(), 0.06);
}

TEST(SectionPlane, NeedsASecondDimension) {
    EXPECT_TRUE(has_section(sample::axisymmetric()));
    EXPECT_FALSE(has_section(
        mesh::build(mesh::Layers{.area = 1.0, .stack = {{.name = "tread", .thickness = 0.012, .cells = 3}}})));
    EXPECT_FALSE(has_section(
        mesh::build(mesh::TwoNode{.area = 1.0, .surface_volume = 1e-3, .bulk_volume = 1e-2, .bulk_depth = 0.01})));
}

/// 0 at the left to 100 at the right.
Raster slope() {
    Raster raster{.width = 201, .height = 100, .value = {}, .low = 0.0, .high = 100.0};
    for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            raster.value.push_back(0.5 * x);
        }
    }
    return raster;
}

TEST(Isotherms, LineStandsWhereTheFieldHasItsLevel) {
    const Raster raster = slope();
    EXPECT_NEAR(raster.distance(100, 50, 50.0), 0.0, 1e-9);
    EXPECT_NEAR(raster.distance(110, 50, 50.0), 10.0, 1e-9);
    const std::vector<double> levels{50.0};
    const std::vector<Colour> with = shade(raster, levels);
    const std::vector<Colour> without = shade(raster, {});
    EXPECT_NE(with[100].green, without[100].green);
    EXPECT_EQ(with[104].green, without[104].green);
}

TEST(Isotherms, NumbersStandOnTheirLinesAndApart) {
    const std::vector<double> levels{50.0, 75.0};
    const std::vector<LevelMark> marks = level_marks(slope(), levels, 20.0);
    ASSERT_EQ(marks.size(), 2u);
    for (const LevelMark& mark : marks) {
        EXPECT_NEAR(0.5 * mark.place.x, mark.level, 1.0);
    }
    EXPECT_TRUE(level_marks(slope(), levels, 150.0).empty());  // no room in a raster 100 px high
}

TEST(Colours, GetBrighterAllTheWayFromColdToHot) {
    for (int i = 0; i < 100; ++i) {
        EXPECT_LT(luminance(heat_colour(i / 100.0)), luminance(heat_colour((i + 1) / 100.0))) << i;
    }
    EXPECT_EQ(heat_colour(-1.0).blue, heat_colour(0.0).blue);
    EXPECT_EQ(heat_colour(2.0).blue, heat_colour(1.0).blue);
}

// Ends and quarters of "inferno" as published (R package viridis, inferno(5)); each is met to 2/255.
TEST(Colours, AreThoseOfInferno) {
    const double published[5][3] = {
        {0, 0, 4}, {0x56, 0x10, 0x6e}, {0xbb, 0x37, 0x54}, {0xf9, 0x8c, 0x0a}, {0xfc, 0xff, 0xa4}};
    for (int i = 0; i < 5; ++i) {
        const Colour colour = heat_colour(0.25 * i);
        EXPECT_NEAR(255.0 * colour.red, published[i][0], 2.0) << i;
        EXPECT_NEAR(255.0 * colour.green, published[i][1], 2.0) << i;
        EXPECT_NEAR(255.0 * colour.blue, published[i][2], 2.0) << i;
    }
}

/// Sum of red, green and blue, by which "inferno" rises from cold to hot.
unsigned brightness(std::uint32_t rgb) { return (rgb >> 16U) + (rgb >> 8U & 0xFFU) + (rgb & 0xFFU); }

// Both ends of "inferno".
constexpr std::uint32_t coldest = 0x000004;
constexpr std::uint32_t hottest = 0xfcffa4;

TEST(Picture, OfTheFieldHasEqualScales) {
    // 40 mm by 12 mm on 1420 px: 426 px high, and 380 px for title, axis and colour bar.
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    const std::vector<double> kelvin = field(problem, [](const mesh::Point& p) { return sample::warmth(p[2], 0.0); });
    draw_field(scratch / "smooth.png", problem, 0.0, kelvin);
    EXPECT_EQ(png_size(read_text(scratch / "smooth.png")), (std::pair{1600u, 806u}));

    // Each of the six rows of cells is 2 mm or 71 px high and 1420 px wide, the coldest outside, the hottest inside. The
    // frame covers up to 2 px of an edge.
    draw_field(scratch / "cells.png", problem, 0.0, kelvin, {.shading = Shading::cells});
    const sample::Pixels picture = sample::pixels(scratch / "cells.png");
    const int column = 120 + 1300;  // right of the names of the layers
    const int top = 165;            // below the title
    EXPECT_NEAR(picture.in_column(column, coldest), 71, 2);
    EXPECT_NEAR(picture.in_row(top + 35, coldest), 1420, 4);
    EXPECT_NEAR(picture.in_row(top + 5 * 71 + 35, hottest), 1420, 4);
    for (int row = 0; row < 6; ++row) {
        // 2 K/mm between cells of 2 mm: 304 K, 308 K, ... are at 0, 1/5, ... of the scale.
        const Colour expected = heat_colour(row / 5.0);
        const std::uint32_t shown = picture.at(column, top + 71 * row + 35);
        EXPECT_NEAR(255.0 * expected.red, shown >> 16U, 1.0) << row;
        EXPECT_NEAR(255.0 * expected.green, shown >> 8U & 0xFFU, 1.0) << row;
        EXPECT_NEAR(255.0 * expected.blue, shown & 0xFFU, 1.0) << row;
    }
}

TEST(Picture, OfAnEvenFieldIsEven) {
    // One temperature is the cold end of the scale, on all 426 px of a column but the frame and the line between layers.
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    draw_field(scratch / "picture.png", problem, 0.0, field(problem, [](const mesh::Point&) { return 296.15; }));
    const sample::Pixels picture = sample::pixels(scratch / "picture.png");
    EXPECT_NEAR(picture.in_column(120 + 1300, coldest), 423, 3);
    EXPECT_EQ(picture.in_column(120 + 1300, hottest), 0);
}

TEST(Picture, OfASectionIsFolded) {
    // 120 mm of flat crown and a quarter circle of 80 mm length, radius 50.93 mm, on either side: 221.9 mm wide and
    // 50.93 mm high at the outside, on 1600 px less 110 px of margin twice. 150 px above, 215 px below.
    const sample::Scratch scratch;
    solver::Problem problem = sample::problem();
    problem.mesh = sample::section();
    const auto kelvin = [](const mesh::Point& p) { return 300.0 + 100.0 * p[0]; };
    draw_folded(scratch / "folded.png", problem, 60.0, field(problem, kelvin));
    const auto [width, height] = png_size(read_text(scratch / "folded.png"));
    EXPECT_EQ(width, 1600U);
    const double radius = 0.16 / 3.14159265358979;
    EXPECT_NEAR(height, 150.0 + 1380.0 * radius / (0.12 + 2.0 * radius) + 215.0, 4.0);
}

TEST(Picture, OfARingIsItsTreadUnrolledAndItsMeanFolded) {
    const sample::Scratch scratch;
    solver::Problem problem = sample::problem();
    problem.mesh = mesh::ring(sample::section(), 12);
    const auto around = [](const mesh::Point& p) { return 300.0 + 10.0 * std::cos(p[1]); };
    draw_tread(scratch / "tread.png", problem, 0.0, field(problem, around));
    const std::string tread = read_text(scratch / "tread.png");
    EXPECT_EQ(png_size(tread), (std::pair{1600U, 825U}));
    // Each of the twelve sectors is a twelfth of the 1410 px between the ends, the first with a half at either end; the way
    // around is 0 to 1.73 m at the middles of the sectors, where the cosine falls.
    const sample::Pixels picture = sample::pixels(scratch / "tread.png");
    int row = 0;
    while (row < picture.height && picture.in_row(row, hottest) < 100) {
        ++row;
    }
    ASSERT_LT(row + 20, picture.height);
    row += 20;
    const int left = 130;
    int seen = left;
    for (int sector = 0; sector <= 12; ++sector) {
        const int end = static_cast<int>(std::lround(left + (sector + 0.5) * 1410.0 / 12.0));
        const std::uint32_t middle = picture.at(std::min(end, left + 1410) - 30, row);
        EXPECT_NEAR(picture.in_row(row, middle), 1410.0 / 12.0, 2.0) << sector;
        if (sector > 0 && sector < 12) {
            EXPECT_LT(brightness(middle), brightness(picture.at(seen - 30, row))) << sector;
        }
        seen = end;
    }
    EXPECT_EQ(picture.at(left + 10, row), hottest);
    EXPECT_EQ(picture.at(left + 1400, row), hottest);
    // A field turned by some way looks different, one moved along the depth the same: only the surface shows.
    draw_tread(scratch / "turned.png", problem, 0.0,
               field(problem, [](const mesh::Point& p) { return 300.0 + 10.0 * std::cos(p[1] + 1.0); }));
    EXPECT_NE(read_text(scratch / "turned.png"), tread);
    draw_tread(scratch / "warm.png", problem, 0.0,
               field(problem, [](const mesh::Point& p) { return 300.0 + 10.0 * std::cos(p[1]) + 1e4 * p[2]; }));
    EXPECT_EQ(read_text(scratch / "warm.png"), tread);

    // What differs around the tire only is even in the mean, as a section without differences is but for its heading.
    draw_folded(scratch / "ring.png", problem, 0.0, field(problem, [](const mesh::Point& p) { return 300.0 + p[0]; }));
    problem.mesh = sample::section();
    draw_folded(scratch / "section.png", problem, 0.0,
                field(problem, [](const mesh::Point& p) { return 300.0 + p[0]; }));
    const sample::Pixels ring = sample::pixels(scratch / "ring.png");
    const sample::Pixels section = sample::pixels(scratch / "section.png");
    ASSERT_EQ(ring.rgb.size(), section.rgb.size());
    const auto below_heading = static_cast<std::ptrdiff_t>(ring.width) * 150;
    EXPECT_TRUE(std::equal(ring.rgb.begin() + below_heading, ring.rgb.end(), section.rgb.begin() + below_heading));
}

}  // namespace
}  // namespace tiretherm::post
