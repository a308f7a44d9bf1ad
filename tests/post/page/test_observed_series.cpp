// SPDX-License-Identifier: BSD-3-Clause
// The stack of observations as series for a chart: each row lands in the series of its run and channel.
#include "post/page/observed_series.hpp"

#include <gtest/gtest.h>

#include "diagnosis/made_up_diagnosis.hpp"

namespace tiretherm::post {
namespace {

// Two runs of the bench with two sensors each: four series that hold all rows. A model that is 0.5 above every value stays so.
TEST(ObservedSeries, EachRunAndChannelHasItsOwnRows) {
    const diagnosis::sample::MadeUp made_up = diagnosis::sample::named();
    const Eigen::VectorXd model = made_up.observations.measured.array() + 0.5;
    const std::vector<MeasuredSeries> all =
        observed_series(made_up.experiment, made_up.observations, {{"base", &model}});
    ASSERT_EQ(all.size(), 2 * made_up.experiment.runs.size());
    std::size_t rows = 0;
    for (const MeasuredSeries& one : all) {
        ASSERT_EQ(one.models.size(), 1U);
        EXPECT_EQ(one.models[0].name, "base");
        ASSERT_EQ(one.time.size(), one.measured.size());
        EXPECT_TRUE(std::ranges::is_sorted(one.time)) << one.channel;
        EXPECT_STREQ(one.unit.name, "degC");
        for (std::size_t i = 0; i < one.time.size(); ++i) {
            EXPECT_NEAR(one.models[0].simulated[i] - one.measured[i], 0.5, 1e-9);
        }
        rows += one.time.size();
    }
    EXPECT_EQ(rows, made_up.observations.rows.size());
    EXPECT_EQ(all[0].channel, "surface_temperature");
    EXPECT_EQ(all[1].channel, "bulk_temperature");
}

}  // namespace
}  // namespace tiretherm::post
