// SPDX-License-Identifier: BSD-3-Clause
// Missing heat in windows of time, of made-up runs of the practice bench.

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

/// What the bench of three runs would have read with a source in it, in white noise of the data sheets.
Observations made_up(const input::Experiment& bench, const std::string& source, unsigned seed) {
    const input::Written written;
    const input::Experiment truth = sample::read_bench(written.add("truth.toml", sample::practice_text() + source));
    Observations read = observe(bench);
    Simulator simulator(truth, read);
    const ModelPrediction& predicted = simulator.at(simulator.start());
    EXPECT_TRUE(predicted.status.ok()) << predicted.status.message;
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> noise;
    for (const NoiseBlock& block : read.blocks) {
        const double sigma = read.stated[static_cast<std::size_t>(block.channel)];
        for (Eigen::Index row = block.first; row < block.first + block.rows(); ++row) {
            read.measured[row] = predicted.simulated[row] + sigma * noise(engine);
        }
    }
    return read;
}

std::vector<MissingHeat> missing_heat_of(const input::Experiment& bench, const Observations& read) {
    DiagnosisState state;
    state.score_data = prepare_score_tests(bench, read, {});
    EXPECT_TRUE(state.score_data.status.ok()) << state.score_data.status.message;
    Diagnosis result;
    estimate_missing_heat(state, result);
    EXPECT_EQ(result.missing_heat.size(), 3U * 2U * 40U);  // runs, places, windows
    return result.missing_heat;
}

/// Of the windows at a place whose interval holds a heat; all of them where no place is named.
struct Windows {
    double holding = 0.0;
    double widest = 0.0;  ///< W, standard deviation
};
Windows windows_holding(const std::vector<MissingHeat>& windows, double watts, const std::string& place) {
    Windows found;
    double all = 0.0;
    for (const MissingHeat& one : windows) {
        if (place.empty() || one.place == place) {
            found.holding += one.low() <= watts && watts <= one.high() ? 1.0 : 0.0;
            found.widest = std::max(found.widest, one.deviation);
            all += 1.0;
        }
    }
    found.holding /= all;
    return found;
}

}  // namespace

// 78 W in the bulk throughout. A bulk of 18 kJ/K that loses some 30 W/K forgets in 600 s, ten windows of 60 s: a window fitted alone
// has to make up for what all of them did, several times as many watts. Films and losses known to 10 % could hide a third of it.
TEST(MissingHeatWindows, HoldAConstantSourceOfTheBulk) {
    const input::Experiment bench = sample::practice_bench();
    double holding = 0.0;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Observations read =
            made_up(bench, "\n[[source]]\nname = \"hidden\"\nfollows = \"1\"\nat = \"bulk\"\nwatts = \"78 W\"\n", seed);
        const Windows found = windows_holding(missing_heat_of(bench, read), 78.0, "bulk");
        holding += found.holding / 5.0;
        EXPECT_LT(found.widest, 78.0) << seed;
    }
    EXPECT_GT(holding, 0.93);
}

// Nothing is missing: the intervals hold none, at either place, and three standard deviations mark no window.
TEST(MissingHeatWindows, HoldNoneWhereNothingIsMissing) {
    const input::Experiment bench = sample::practice_bench();
    double holding = 0.0;
    for (unsigned seed = 11; seed <= 15; ++seed) {
        const std::vector<MissingHeat> found = missing_heat_of(bench, made_up(bench, "", seed));
        holding += windows_holding(found, 0.0, "").holding / 5.0;
        for (const MissingHeat& one : found) {
            EXPECT_LT(std::abs(one.sigma()), 3.0) << seed << " " << one.run << " " << one.place << " " << one.from;
        }
    }
    EXPECT_GT(holding, 0.95);
}

}  // namespace tiretherm::diagnosis
