// SPDX-License-Identifier: BSD-3-Clause
// channels.csv is read back to its decimals, row by row while it is written; failures name the file.

#include <gtest/gtest.h>

#include "input/tables/data_file.hpp"
#include "physics/celsius.hpp"
#include "post/fields/csv_writer.hpp"
#include "post/laps/computed_inputs.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

/// Load and slip angle of a tire, as a car's model gives them.
class OfACar final : public solver::InputModel {
public:
    void apply(std::span<const double> /*numbers*/, solver::InputSignals& /*into*/) const override {}
    [[nodiscard]] std::vector<const physics::Signal*> signals() const override {
        return {physics::find_signal("vertical_load"), physics::find_signal("slip_angle")};
    }
    void add_to(solver::Digest& /*digest*/) const override {}
};

// 0.1 rad are 5.729578 degrees, 20 m/s would be 72 km/h but are the log's own; the run ends at 1 s.
TEST(Csv, InputsOfACarStandInATableOfTheirOwn) {
    solver::Problem problem = sample::problem();
    problem.settings.end = 1.0;
    EXPECT_EQ(computed_inputs_csv({{"lap", &problem}}), "");
    problem.input_model = std::make_shared<OfACar>();
    const std::vector<double> time{0.0, 1.0, 2.0};
    problem.input_signals.add({physics::find_signal("speed"), std::vector{0.0}, std::vector{20.0}});
    problem.input_signals.add({physics::find_signal("vertical_load"), time, std::vector{1000.0, 2000.0, 3000.0}});
    problem.input_signals.add({physics::find_signal("slip_angle"), time, std::vector{0.1, 0.2, 0.3}});
    EXPECT_EQ(computed_inputs_csv({{"lap", &problem}}),
              "time [s],run,vertical_load [N],slip_angle [\u00b0]\n"
              "0,lap,1000,5.729578\n"
              "1,lap,2000,11.45916\n");
}

TEST(Csv, RowsStandInDegreesCelsiusWithFourDecimals) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    CsvWriter writer(scratch / "channels.csv", problem);
    writer.take(sample::Moment(problem, 0.0, {296.15, 250.0}, true).snapshot);
    // Read while the writer still holds the file: each row is there as soon as it is taken.
    EXPECT_EQ(read_text(scratch / "channels.csv"),
              "time [s],spot [degC],liner [degC]\n"
              "0,23.0000,-23.1500\n");
    writer.take(sample::Moment(problem, 1234567.25, {373.15006, 300.0}, true).snapshot);
    EXPECT_EQ(read_text(scratch / "channels.csv"),
              "time [s],spot [degC],liner [degC]\n"
              "0,23.0000,-23.1500\n"
              "1234567.25,100.0001,26.8500\n");
}

TEST(Csv, ReaderOfCasesTakesTheFileBackInKelvin) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    {
        CsvWriter writer(scratch / "channels.csv", problem);
        writer.take(sample::Moment(problem, 0.0, {296.15, 296.15}, true).snapshot);
        writer.take(sample::Moment(problem, 30.5, {353.15, 303.123456}, true).snapshot);
    }
    input::InputErrors errors;
    const auto csv = input::DataFile::open(scratch / "channels.csv", {}, errors);
    ASSERT_TRUE(csv);
    const auto values =
        csv->read({{.column = csv->find("time"),
                    .name = "time",
                    .spec = {.unit = "s", .low = 0.0, .high = 1e9},
                    .purpose = input::Purpose::clock},
                   {.column = csv->find("liner"), .name = "liner", .spec = {.unit = "K", .low = 0.0, .high = 1e3}}},
                  errors);
    ASSERT_EQ(errors.count(), 0u);
    EXPECT_EQ(values[0], (std::vector<double>{0.0, 30.5}));
    EXPECT_NEAR(values[1][0], 296.15, 1e-9);
    EXPECT_NEAR(values[1][1], 303.123456, 0.5e-4);  // half of the last decimal
}

TEST(Csv, UnwritableFileIsAnErrorWithItsPath) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    EXPECT_THROW(CsvWriter(scratch / "missing/channels.csv", problem), FileError);
}

}  // namespace
}  // namespace tiretherm::post
