// SPDX-License-Identifier: BSD-3-Clause
// cases/contact_fields: the made-up files of a structural code and the cases that use them.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "input/effects/brush_fields.hpp"
#include "input/tables/field_file.hpp"
#include "solver/system.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

constexpr double zero = 273.15;

fs::path folder() { return source_folder() / "cases" / "contact_fields"; }

const std::vector<std::pair<std::string, brush_fields::Columns>>& shipped() {
    static const std::vector<std::pair<std::string, brush_fields::Columns>> all{
        {"contact", brush_fields::contact()}, {"ramp", brush_fields::ramp()}, {"loss", brush_fields::loss()}};
    return all;
}

std::string text_of_table(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

FieldFile read_field(const fs::path& file, physics::FieldOf of, bool watts) {
    InputErrors errors;
    auto field = read_field_file(file, {}, of, watts, true, errors);
    EXPECT_TRUE(field.has_value()) << (errors.in_order().empty() ? "" : render(errors.in_order().front()));
    return field ? std::move(*field) : FieldFile{};
}

solver::Problem shipped_problem(std::string_view name) {
    Reading reading = read_case(folder() / (std::string(name) + ".toml"));
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    return reading.problem ? std::move(*reading.problem) : solver::Problem{};
}

const physics::ActiveEffect& effect(const solver::Problem& problem, std::string_view id) {
    return *std::ranges::find_if(problem.effects, [&](const auto& active) { return active.effect->id == id; });
}

solver::MarchReport run(const solver::Problem& problem) {
    solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_LE(report.energy_closure, 1e-10);
    return report;
}

double channel(const solver::Problem& problem, const solver::MarchReport& report, std::string_view name) {
    const auto found = std::ranges::find(problem.channels, name, &solver::Channel::name);
    return report.channel_final[static_cast<std::size_t>(found - problem.channels.begin())] - zero;
}

/// The thesis's share of 0.6 in the place of that of the effusivities.
void take_number(physics::ActiveEffect& sliding) {
    sliding.choices[static_cast<std::size_t>(physics::find_choice(*sliding.effect, "partition"))] = 0;
}

}  // namespace

// With TIRETHERM_WRITE_FIELDS set the files are written; otherwise those of the library must be these.
TEST(ContactFields, FilesAreThoseOfTheBrushModel) {
    const bool write = std::getenv("TIRETHERM_WRITE_FIELDS") != nullptr;
    for (const auto& [name, columns] : shipped()) {
        const fs::path csv = folder() / (name + ".csv");
        const fs::path hdf5 = folder() / (name + ".h5");
        if (write) {
            std::ofstream(csv, std::ios::binary) << columns.csv();
            fs::remove(hdf5);
            columns.write_hdf5(hdf5);
        }
        EXPECT_EQ(text_of_table(csv), columns.csv()) << name;
        EXPECT_LT(fs::file_size(csv), 200000U);
        EXPECT_LT(fs::file_size(hdf5), 200000U);
    }
}

// Both dialects hold the same numbers; units are applied to both alike.
TEST(ContactFields, BothDialectsAreOneField) {
    using physics::FieldOf;
    for (const auto& [name, of] : {std::pair("contact", FieldOf::friction), std::pair("contact", FieldOf::pressure),
                                   std::pair("ramp", FieldOf::friction), std::pair("loss", FieldOf::loss)}) {
        const FieldFile csv = read_field(folder() / (std::string(name) + ".csv"), of, true);
        const FieldFile hdf5 = read_field(folder() / (std::string(name) + ".h5"), of, true);
        ASSERT_EQ(csv.frames.size(), hdf5.frames.size()) << name;
        EXPECT_EQ(csv.against, hdf5.against);
        for (std::size_t k = 0; k < csv.frames.size(); ++k) {
            EXPECT_EQ(csv.frames[k].at, hdf5.frames[k].at);
            EXPECT_EQ(csv.frames[k].points, hdf5.frames[k].points);
            EXPECT_EQ(csv.frames[k].density, hdf5.frames[k].density);
        }
    }
}

// The points of a rib stand 5 mm apart, so that shear stress times sliding speed, summed over the contact, is the brush's
// own sliding power up to the square of that: 2 % where a rib slides over 20 mm.
TEST(ContactFields, WattsAreTheSlidingPowerOfTheBrush) {
    const double slip = std::tan(4.0 * std::numbers::pi / 180.0);
    double power = 0.0;
    for (int j = 0; j < brush_fields::ribs; ++j) {
        power += brush_fields::rib(brush_fields::middle_of(j)).sliding_power(slip, brush_fields::rolling);
    }
    const FieldFile field = read_field(folder() / "contact.h5", physics::FieldOf::friction, true);
    const solver::Problem problem = shipped_problem("cornering");
    const std::vector<int> patches{problem.mesh.find_patch("outside")};
    const auto transfer = physics::onto_faces(problem.mesh, patches, field.frames.front().points);
    EXPECT_NEAR(transfer.total(field.frames.front().density), power, 0.02 * power);
}

// Two numbers of each case as this program gives them, printed to 0.1 K: a change must be meant. Each total of the laws is
// untouched by the fields, and the ledger closes.
TEST(ContactFields, CorneringWarmsTheOutsideShoulderMore) {
    const solver::Problem problem = shipped_problem("cornering");
    const solver::MarchReport report = run(problem);
    EXPECT_NEAR(channel(problem, report, "outside_shoulder_bulk_temperature"), 52.4, 0.06);
    EXPECT_NEAR(channel(problem, report, "inside_shoulder_bulk_temperature"), 48.9, 0.06);
    // 3000 N 27.78 m/s tan(4 deg) = 5827 W of sliding, whatever the shape. Of it the tread takes e/(e + 1576): 0.325 at 20 degC,
    // 0.29 W/mK and e = 758, 0.45 at 75 degC, 0.81 W/mK and e = 1265.
    const double sliding = 3000.0 / 3.6 * 100.0 * std::tan(4.0 * std::numbers::pi / 180.0);
    const auto friction = static_cast<std::size_t>(&effect(problem, "sliding_friction") - problem.effects.data());
    EXPECT_GT(report.watts[friction] / sliding, 0.325);
    EXPECT_LT(report.watts[friction] / sliding, 0.45);
    solver::Problem of_thesis = problem;
    take_number(of_thesis.effects[friction]);
    EXPECT_NEAR(run(of_thesis).watts[friction], 0.6 * sliding, 1e-8);
}

TEST(ContactFields, RampGivesTheFilesWatts) {
    solver::Problem problem = shipped_problem("ramp");
    const solver::MarchReport shipped = run(problem);
    EXPECT_NEAR(channel(problem, shipped, "surface_temperature"), 50.65, 0.06);
    EXPECT_NEAR(channel(problem, shipped, "outside_shoulder_bulk_temperature"), 47.3, 0.06);
    const physics::ActiveEffect& active = effect(problem, "sliding_friction");
    const auto friction = static_cast<std::size_t>(&active - problem.effects.data());
    take_number(problem.effects[friction]);
    const solver::MarchReport report = run(problem);
    EXPECT_NEAR(report.watts[friction], 0.6 * active.field->watts.back(), 1e-9);
    // Straight between the frames of 0, 10, ... 60 s, then held to 300 s: the trapezia, to round-off of the run's steps.
    double joules = 240.0 * active.field->watts.back();
    for (std::size_t k = 0; k < 6; ++k) {
        joules += 5.0 * (active.field->watts[k] + active.field->watts[k + 1]);
    }
    EXPECT_NEAR(report.joules[friction], 0.6 * joules, 1e-10 * joules);
}

}  // namespace tiretherm::input
