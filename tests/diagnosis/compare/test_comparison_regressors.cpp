// SPDX-License-Identifier: BSD-3-Clause
// Which signals the differences of a comparison may follow.
#include "diagnosis/compare/comparison_regressors.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::diagnosis {

// Of two columns that the model does not use a throttle may drive what is wrong. The temperature of the carcass is a reading: it
// moves with the others because it is as warm as they are.
TEST(ComparisonRegressors, AReadingIsNoCauseOfAnother) {
    std::string log =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],throttle [-],"
        "carcass temperature [degC],surface_temperature [degC]\n";
    for (int i = 0; i < 40; ++i) {
        log += fmt::format("{},72,4000,20,25,{:.3f},{:.2f},{:.2f}\n", 2 * i, 0.5 + 0.4 * std::sin(0.7 * i),
                           25.0 + 0.3 * i + std::sin(0.2 * i), 25.0 + 0.2 * i + std::cos(0.3 * i));
    }
    const input::Written written;
    written.add("run.csv", log);
    const input::ExperimentReading reading =
        input::read_experiment(written.add("case.toml", std::string(input::bench) + "[[run]]\nfile = \"run.csv\"\n"));
    ASSERT_TRUE(reading.experiment) << input::error_report(reading);
    ASSERT_EQ(reading.experiment->runs.front().unused.size(), 2U);
    const std::vector<Regressor> regressors = regressors_of(*reading.experiment);
    const auto follows = [&](std::string_view name) {
        return std::ranges::find(regressors, name, &Regressor::name) != regressors.end();
    };
    EXPECT_TRUE(follows("throttle"));
    EXPECT_FALSE(follows("carcass temperature"));
    EXPECT_TRUE(follows("speed"));
}

}  // namespace tiretherm::diagnosis
