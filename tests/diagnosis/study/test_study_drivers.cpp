// SPDX-License-Identifier: BSD-3-Clause
// What drives the hottest temperature of a study's samples: a straight line by least squares.
#include "diagnosis/study/study_drivers.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "post/study/study_report.hpp"

namespace tiretherm::diagnosis {
namespace {

constexpr double zero = 273.15;

StudyColumn drawn(const std::string& key, std::vector<double> numbers) {
    return {.key = key,
            .unit = "W/K",
            .udunits = "W/K",
            .is_drawn = true,
            .texts = std::vector<std::string>(numbers.size(), "-"),
            .numbers = std::move(numbers)};
}

StudyRecord sampled(std::vector<StudyColumn> columns, const std::vector<double>& hottest) {
    StudyRecord study;
    study.title = "Samples";
    study.columns = std::move(columns);
    study.samples = hottest.size();
    study.is_sampled = true;
    for (const double celsius : hottest) {
        StudyOutcome outcome;
        outcome.hottest = zero + celsius;
        study.outcomes.push_back(outcome);
    }
    return study;
}

}  // namespace

// x = 0 ... 9, y = 2 x + (1, -1, 1, ...): Sxx = 82.5, Sxy = 160, slope 1.939394; SSE = 10 - 25/82.5 = 9.696970, so that
// the slope's standard error is sqrt(9.696970/8/82.5) = 0.121212; R2 = 1 - 9.696970/320. x has a deviation of
// sqrt(82.5/9) = 3.027650.
TEST(StudyDrivers, AreThoseOfTheTextbook) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < 10; ++i) {
        x.push_back(i);
        y.push_back(2.0 * i + (i % 2 == 0 ? 1.0 : -1.0));
    }
    const StudyRegression line = regression(sampled({drawn("film", x)}, y), 0);
    ASSERT_EQ(line.drivers.size(), 1U);
    EXPECT_NEAR(line.drivers[0].standard_deviation, 3.027650, 1e-6);
    EXPECT_NEAR(line.drivers[0].kelvin, 1.939394 * 3.027650, 1e-5);
    EXPECT_NEAR(line.drivers[0].uncertainty, 1.959964 * 0.121212 * 3.027650, 1e-5);
    EXPECT_NEAR(line.r_squared, 1.0 - 9.696970 / 320.0, 1e-6);
    EXPECT_NEAR(line.residual, std::sqrt(9.696970 / 8.0), 1e-6);
    EXPECT_NEAR(line.mean, zero + 9.0, 1e-9);
    // The line's 5.8718 K and what it leaves, 1.1010 K, are 5.9741 K: 16 % lie beyond one of them.
    EXPECT_NEAR(line.chance_above(zero + 9.0 + 5.9741), 0.158655, 1e-5);
    EXPECT_NEAR(line.drivers[0].share, 1.0, 1e-12);
}

// y = 50 - 4 a + 3 b exactly, a and b of deviation 1 and without correlation: -4 and +3 K, 5 K together, 64 and 36 %.
TEST(StudyDrivers, ShareTheVarianceOfAnExactPlane) {
    const double u = std::sqrt(15.0 / 16.0);
    std::vector<double> a;
    std::vector<double> b;
    std::vector<double> y;
    for (int i = 0; i < 16; ++i) {
        a.push_back(i % 2 == 0 ? u : -u);
        b.push_back(i % 4 < 2 ? u : -u);
        y.push_back(50.0 - 4.0 * a.back() + 3.0 * b.back());
    }
    StudyRecord study = sampled({drawn("b", b), drawn("a", a), drawn("idle", std::vector<double>(16, 7.0))}, y);
    const StudyRegression line = regression(study, 0);
    ASSERT_EQ(line.drivers.size(), 2U);  // without what is the same in all samples
    EXPECT_EQ(line.drivers[0].key, "a");
    EXPECT_NEAR(line.drivers[0].kelvin, -4.0, 1e-9);
    EXPECT_NEAR(line.drivers[1].kelvin, 3.0, 1e-9);
    EXPECT_NEAR(line.drivers[0].share, 0.64, 1e-9);
    EXPECT_NEAR(line.standard_deviation, 5.0, 1e-9);
    EXPECT_NEAR(line.r_squared, 1.0, 1e-12);
    const std::string text = post::page_text(post::study_report(study, {}), false);
    EXPECT_NE(text.find("What drives it"), std::string::npos) << text;
    EXPECT_NE(text.find("explains 100.0 % of the variance"), std::string::npos) << text;
    // A run that failed does not count.
    study.outcomes[3].failure = "it burns";
    study.outcomes[3].hottest = 0.0;
    EXPECT_NEAR(regression(study, 0).r_squared, 1.0, 1e-12);
}

// Two numbers, the plane's own value and a coefficient each take five samples: fewer say nothing.
TEST(StudyDrivers, NeedFiveSamplesForEachNumber) {
    const std::vector<double> nine{1, 2, 3, 4, 5, 6, 7, 8, 9};
    const StudyRecord study = sampled({drawn("film", nine)}, nine);
    EXPECT_FALSE(regression(study, 0).exists());
    const post::Report report = post::study_report(study, {});
    EXPECT_TRUE(post::section(report, "What drives it").blocks().empty());
    EXPECT_NE(post::json_text(report.data).find("\"drivers\": null"), std::string::npos);
}

}  // namespace tiretherm::diagnosis
