// SPDX-License-Identifier: BSD-3-Clause
// What the practice benches' own runs hold is found again: the tables of cases/practice/section_bench.md and laser_bench.md.
// The runs are fixed, so that these fits are as well; how often intervals hold the truth at all is asked elsewhere
// (BenchRecoveryLong).
#include <gtest/gtest.h>

#include "diagnosis/fit/identification.hpp"
#include "input/measurements/measured_bench.hpp"

namespace hidden_effects {

namespace {

namespace input = tiretherm::input;
namespace diagnosis = tiretherm::diagnosis;

/// Fits a case of cases/practice to its own runs. @param truth [n_parameters] in their order and units
void expect_recovered(const std::string& name, const std::vector<double>& truth) {
    SCOPED_TRACE(name);
    const input::ExperimentReading reading =
        input::read_experiment(input::source_folder() / "cases/practice" / (name + ".toml"));
    ASSERT_TRUE(reading.experiment) << input::error_report(reading);
    const input::Experiment& experiment = *reading.experiment;
    const diagnosis::Identification fit = diagnosis::identify(experiment, diagnosis::observe(experiment));
    ASSERT_TRUE(fit.status.ok()) << fit.status.message;
    EXPECT_TRUE(fit.converged);
    ASSERT_EQ(fit.fitted.size(), truth.size());
    for (std::size_t j = 0; j < truth.size(); ++j) {
        const diagnosis::Fitted& one = fit.fitted[j];
        EXPECT_EQ(one.identifiability, diagnosis::Identifiability::determined) << experiment.parameters[j].name;
        EXPECT_LT(one.low, truth[j]) << experiment.parameters[j].name;
        EXPECT_GT(one.high, truth[j]) << experiment.parameters[j].name;
    }
}

}  // namespace

TEST(PracticeRecovery, TheCrownInLayersGivesItsNumbersBack) {
    expect_recovered("layers_bench", {0.96, 1.05 * 2.14e15, -0.877, -3.431, -2.680});
}

TEST(PracticeRecovery, TheSectionGivesItsNumbersBack) {
    expect_recovered("section_bench", {1.04, 0.95 * 2.14e15, -0.028, -3.738, 1.381});
}

TEST(PracticeRecovery, TheLasersBenchGivesItsNumbersBack) {
    expect_recovered("laser_bench", {0.95, 11.5, 8.5, 1.703, -0.609, 0.884});
}

}  // namespace hidden_effects
