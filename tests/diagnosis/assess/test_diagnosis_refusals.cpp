// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis must not conclude: nothing from a dead sensor, nothing from as many values as free numbers, and no
// cause at the bound of what is allowed for it.

#include <algorithm>

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The first practice run with a column held at 30 degC.
sample::Log with_dead(sample::Log log, std::string_view sensor) {
    for (std::size_t c = 0; c < log.headings.size(); ++c) {
        if (log.headings[c].starts_with(sensor)) {
            std::ranges::fill(log.columns[c], 30.0);
        }
    }
    return log;
}

Diagnosis refused_diagnosis_of(const input::Experiment& experiment) {
    Diagnosis result =
        diagnose(experiment, observe(experiment), {.measure_gain = false, .finer = nullptr, .only_verdict = true});
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    return result;
}

}  // namespace

// The bulk's probe reads 30 degC for forty minutes. With it, a cause that hides the bulk from all heat would fit best;
// the surface's sensor alone knows of nothing missing: the run was made by the model.
TEST(DiagnosisRefusal, LeavesADeadSensorOut) {
    const input::Experiment experiment =
        sample::practice_bench({with_dead(sample::read_log(sample::practice() / "run1.csv"), "bulk_temperature")});
    const Observations observations = observe(experiment);
    EXPECT_EQ(observations.names, std::vector<std::string>{"surface_temperature"});
    const Diagnosis result = refused_diagnosis_of(experiment);
    EXPECT_EQ(result.verdict, Verdict::consistent);
    EXPECT_TRUE(result.hypotheses.empty());
}

TEST(DiagnosisRefusal, SaysNothingWhereAllSensorsAreDead) {
    sample::Log log = with_dead(sample::read_log(sample::practice() / "run1.csv"), "bulk_temperature");
    const Diagnosis result =
        refused_diagnosis_of(sample::practice_bench({with_dead(std::move(log), "surface_temperature")}));
    EXPECT_EQ(result.verdict, Verdict::cannot_tell);
    EXPECT_EQ(result.reason, remark::no_sensor_changes({remark::sensor_of_run("surface_temperature", "run1"),
                                                        remark::sensor_of_run("bulk_temperature", "run1")}));
}

// Two samples of two sensors, four free numbers: any model passes through four points.
TEST(DiagnosisRefusal, SaysNothingWithAsManyValuesAsNumbers) {
    sample::Log log = sample::read_log(sample::practice() / "run1.csv");
    for (std::vector<double>& column : log.columns) {
        column = {column.front(), column.back()};
    }
    const Diagnosis result = refused_diagnosis_of(sample::practice_bench({log}));
    EXPECT_EQ(result.verdict, Verdict::cannot_tell);
    EXPECT_EQ(result.reason, remark::too_few_values(4, 4, 2));
    EXPECT_EQ(result.extended, result.base);
}

// The bulk, as the probe reads it, at a quarter of its rise: less than any scale of a heat capacity or a film explains.
// What explains it best ends at a bound, and is in no verdict.
TEST(DiagnosisRefusal, NamesNoCauseAtItsBound) {
    sample::Log log = sample::read_log(sample::practice() / "run1.csv");
    for (std::size_t c = 0; c < log.headings.size(); ++c) {
        if (log.headings[c].starts_with("bulk_temperature")) {
            const double start = log.columns[c].front();
            for (double& value : log.columns[c]) {
                value = start + 0.02 * (value - start);
            }
        }
    }
    const Diagnosis result = refused_diagnosis_of(sample::practice_bench({log}));
    for (const std::vector<std::size_t>& hypothesis : result.hypotheses) {
        for (const std::size_t cause : hypothesis) {
            EXPECT_FALSE(result.causes[cause].at_bound) << result.causes[cause].id;
            EXPECT_GT(result.causes[cause].sigma, 2.0) << result.causes[cause].id;
        }
    }
    for (const Cause& cause : result.causes) {
        EXPECT_FALSE(cause.in_set && cause.at_bound) << cause.id;
    }
}

}  // namespace tiretherm::diagnosis
