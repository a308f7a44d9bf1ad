// SPDX-License-Identifier: BSD-3-Clause
// The page's field against time: which moments it has, what its hottest moment is, and which cells are drawn where; the tread of a
// ring and its contact.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "input/runs/reader.hpp"
#include "mesh/ring.hpp"
#include "post/page/field_chart.hpp"
#include "post/report/base64.hpp"
#include "post/report/value.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

/// A chart of one moment of a field that is given at the middles of the cells and on the surfaces.
nlohmann::json chart_of(const solver::Problem& problem, double (*kelvin)(const mesh::Point&), bool tread = false) {
    std::vector<double> temperature;
    for (const mesh::Point& centre : problem.mesh.centre) {
        temperature.push_back(kelvin(centre));
    }
    FieldFrames frames(problem);
    sample::Moment moment(problem, 0.0, {}, true);
    moment.snapshot.temperature = temperature;
    frames.take(moment.snapshot);
    return nlohmann::json::parse(json_text(tread ? frames.tread()->chart() : frames.chart()));
}

/// Temperatures of the polygons of a chart of one moment. degC
std::vector<double> values_of(const nlohmann::json& chart) {
    const std::string bytes = from_base64(chart["values"].get<std::string>()).value();
    const double low = chart["low"].get<double>();
    const double high = chart["high"].get<double>();
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const unsigned step = static_cast<unsigned char>(bytes[i]) + 256U * static_cast<unsigned char>(bytes[i + 1]);
        values.push_back(low + step / 65535.0 * (high - low));
    }
    return values;
}

}  // namespace

// Fields are stored at 0 and 60 s alone, and the tire is hottest at 45 s: the button leads there. 26.85 degC at the surface, 24 K
// more 12 mm deep, 100 K of warming: a peak of 150.85 degC, which is the top of the scale as well.
TEST(FieldFrames, TheHottestMomentIsThatOfTheRunAndNotOfTheStoredFields) {
    const solver::Problem problem = sample::problem();
    FieldFrames frames(problem);
    frames.take(sample::Moment(problem, 0.0, {}, true).snapshot);
    frames.take(sample::Moment(problem, 60.0, {}, true).snapshot);
    frames.take_hottest(45.0, sample::Moment(problem, 100.0, {}, true).snapshot.temperature);
    const nlohmann::json chart = nlohmann::json::parse(json_text(frames.chart()));
    ASSERT_EQ(chart["times"].size(), 3U);
    EXPECT_EQ(chart["hottest"], 1);
    EXPECT_NEAR(chart["marks"][1][2].get<double>(), 150.85, 1e-3);
    EXPECT_NEAR(chart["high"].get<double>(), 150.85, 1e-3);
}

// A moment that is stored anyway is not shown twice.
TEST(FieldFrames, AHottestMomentThatIsStoredIsShownOnce) {
    const solver::Problem problem = sample::problem();
    FieldFrames frames(problem);
    frames.take(sample::Moment(problem, 0.0, {}, true).snapshot);
    frames.take(sample::Moment(problem, 60.0, {}, true).snapshot);
    frames.take_hottest(60.0, sample::Moment(problem, 60.0, {}, true).snapshot.temperature);
    const nlohmann::json chart = nlohmann::json::parse(json_text(frames.chart()));
    EXPECT_EQ(chart["times"].size(), 2U);
    EXPECT_EQ(chart["hottest"], 1);
}

// A disc of 20 mm in 4 columns and 6 rows, mirrored to 8 columns from -20 to 20 mm: the cells stand row by row from the left, and
// the first and the last of a row have the temperature of x = 17.5 mm, 300 K + 1e5 x 0.0175^2 = 330.625 K or 57.475 degC.
TEST(FieldFrames, AMirroredSpecimenIsDrawnWholeRowByRow) {
    const nlohmann::json chart =
        chart_of(sample::problem(), [](const mesh::Point& p) { return 300.0 + 1e5 * p[0] * p[0]; });
    ASSERT_EQ(chart["columns"], 8);
    const std::vector<double> values = values_of(chart);
    ASSERT_EQ(values.size(), 48U);
    EXPECT_EQ(chart["polygons"][0], -20.0);
    EXPECT_EQ(chart["polygons"][8 * 7 + 2], 20.0);  // the right end of the eighth cell
    EXPECT_NEAR(values[0], 57.475, 1e-3);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(values[i], values[7 - i]) << i;
        EXPECT_EQ(values[i], values[8 + i]) << i;
    }
}

// A spot of 80 K exp(-(x/1 cm)^2) on a disc of 60 mm: beyond sqrt(ln 20) cm = 17.3 mm less than 5 % of the range is left, and the
// chart ends one or two columns of 1 mm further. A straight slope is drawn to its end.
TEST(FieldFrames, ARimWithoutChangeIsCutAndASlopeIsNot) {
    const solver::Problem problem = sample::problem(mesh::build(mesh::Axisymmetric{
        .radius = {{.to = 0.06, .cells = 60}}, .stack = {{.name = "tread", .thickness = 0.008, .cells = 4}}}));
    const nlohmann::json spot =
        chart_of(problem, [](const mesh::Point& p) { return 300.0 + 80.0 * std::exp(-1e4 * p[0] * p[0]); });
    EXPECT_NEAR(spot["x"]["max"].get<double>(), 18.5, 0.8);
    EXPECT_EQ(spot["x"]["min"].get<double>(), -spot["x"]["max"].get<double>());
    EXPECT_NE(spot["x"]["name"].get<std::string>().find("of 60"), std::string::npos) << spot["x"];
    const nlohmann::json slope = chart_of(problem, [](const mesh::Point& p) { return 300.0 + 1e3 * p[0]; });
    EXPECT_EQ(slope["x"]["max"], 60.0);
}

// Twelve sectors of 30 degrees, the first about 0: a field of cos(angle) is highest in the sectors about 0 and equal in those that
// lie on either side of it; 1e4 K/m along the depth changes nothing, for the surface alone is drawn.
TEST(FieldFrames, ATreadIsUnrolledByItsSectors) {
    solver::Problem problem = sample::problem();
    problem.mesh = mesh::ring(sample::section(), 12);
    const auto around = [](const mesh::Point& p) { return 300.0 + 10.0 * std::cos(p[1] / 0.3) + 1e4 * p[2]; };
    const nlohmann::json chart = chart_of(problem, around, true);
    EXPECT_EQ(chart["x"]["min"], -15.0);
    EXPECT_EQ(chart["x"]["max"], 345.0);
    const std::vector<double> values = values_of(chart);
    std::vector<double> of_sector(12, -1e300);
    for (std::size_t face = 0; face < values.size(); ++face) {
        const double from = chart["polygons"][8 * face].get<double>();
        EXPECT_NEAR(chart["polygons"][8 * face + 2].get<double>() - from, 30.0, 1e-9);
        double& highest = of_sector[static_cast<std::size_t>(std::lround((from + 15.0) / 30.0))];
        highest = std::max(highest, values[face]);
    }
    EXPECT_NEAR(of_sector[0], 300.0 + 10.0 - 273.15, 0.01);
    EXPECT_EQ(std::ranges::max_element(of_sector), of_sector.begin());
    EXPECT_TRUE(chart["contacts"][0].is_null());  // no effect goes round
}

// A wheel that turns five times in 0.366 s: the middle of the contact is half a turn from what is at the top, at 180 degrees at
// first and a quarter turn later, after 18.3 ms, at 270.
TEST(FieldFrames, TheContactIsWhereTheWheelHasTurnedTo) {
    const input::Reading reading = input::read_case(TIRETHERM_SOURCE_DIR "/cases/rotation/ring.toml");
    ASSERT_TRUE(reading.problem);
    FieldFrames frames(*reading.problem);
    for (const double time : {0.0, 0.0183}) {
        frames.take(sample::Moment(*reading.problem, time, {}, true).snapshot);
    }
    const nlohmann::json chart = nlohmann::json::parse(json_text(frames.tread()->chart()));
    for (const auto& [moment, middle] : {std::pair(0, 180.0), std::pair(1, 270.0)}) {
        const nlohmann::json& contact = chart["contacts"][static_cast<std::size_t>(moment)];
        EXPECT_NEAR(0.5 * (contact[0].get<double>() + contact[1].get<double>()), middle, 0.5) << contact;
    }
}

}  // namespace tiretherm::post
