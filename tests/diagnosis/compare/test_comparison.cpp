// SPDX-License-Identifier: BSD-3-Clause
// Figures, phases, signals, single numbers, sentences and files of a comparison against values computed by hand.

#include "diagnosis/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/comparison/comparison_report.hpp"
#include "post/report/file.hpp"
#include "tests/diagnosis/compare/compared_bench.hpp"
#include "tests/support/report_cells.hpp"

namespace tiretherm::diagnosis {
namespace {

struct Idle {
    input::Written written;
    Comparison comparison;

    Idle() {
        written.add("first.csv", sample::first_log);
        written.add("second.csv", sample::second_log);
        const input::ExperimentReading reading = input::read_experiment(written.add("idle.toml", sample::idle_bench));
        EXPECT_TRUE(reading.experiment.has_value()) << input::error_report(reading);
        if (reading.experiment) {
            comparison = compare(*reading.experiment, "idle");
        }
    }
    [[nodiscard]] const ComparedChannel& channel(const std::string& name) const {
        for (const ComparedChannel& one : comparison.channels) {
            if (one.name == name) {
                return one;
            }
        }
        throw std::out_of_range(name);
    }
};

TEST(Comparison, OfEveryChannelAndRun) {
    // Bulk +1, -1, 0, +1 and +3, +3: mean 7/6, squares 1 + 1 + 0 + 1 + 9 + 9 = 21. Surface -2, -2, -2, -1, -1: mean -1.6.
    const Idle idle;
    ASSERT_TRUE(idle.comparison.status.ok()) << idle.comparison.status.message;
    ASSERT_EQ(idle.comparison.channels.size(), 2u);
    const ComparedChannel& bulk = idle.channel("bulk_temperature");
    EXPECT_EQ(bulk.figures.samples, 6u);
    EXPECT_NEAR(bulk.figures.bias, 7.0 / 6.0, 1e-9);
    EXPECT_NEAR(bulk.figures.rmse, std::sqrt(21.0 / 6.0), 1e-9);
    ASSERT_EQ(bulk.runs.size(), 2u);
    EXPECT_NEAR(bulk.runs[0].figures.bias, 0.25, 1e-9);
    EXPECT_NEAR(bulk.runs[1].figures.bias, 3.0, 1e-9);
    const ComparedChannel& surface = idle.channel("surface_temperature");
    EXPECT_EQ(surface.figures.samples, 5u);
    EXPECT_NEAR(surface.figures.bias, -1.6, 1e-9);
    EXPECT_EQ(surface.runs.size(), 1u);
}

TEST(Comparison, TheSensorsWordCountsWhereItIsGiven) {
    // Bulk: 0.4 K is stated; removable rms sqrt(21/6 - 0.16). Surface: nothing is; its second differences off the line are 0, -0.5
    // and +0.5 K on an even clock, squares over 1.5: 0, 1/6, 1/6, mean 1/9.
    const Idle idle;
    const ComparedChannel& bulk = idle.channel("bulk_temperature");
    EXPECT_TRUE(bulk.sensor_is_stated);
    EXPECT_NEAR(bulk.model.removable, std::sqrt(21.0 / 6.0 - 0.16), 1e-9);
    const ComparedChannel& surface = idle.channel("surface_temperature");
    EXPECT_FALSE(surface.sensor_is_stated);
    EXPECT_NEAR(surface.noise, 1.0 / 3.0, 1e-9);
    EXPECT_EQ(surface.sensor, surface.noise);
}

TEST(Comparison, ByWhatTheTireDoes) {
    // First run: 0 and 2 s at rest (+1, -1), 4 s rolling (0), 6 s slipping (+1); 8 s has no reading. Times of the four: 1, 2, 2,
    // 1 s. The second run rolls, 5 and 5 s (+3, +3). Rolling: 0, 3, 3 in 12 of 16 s.
    const Idle idle;
    const std::vector<PhaseFigures>& phases = idle.channel("bulk_temperature").phases;
    ASSERT_EQ(phases.size(), 3u);
    EXPECT_EQ(phases[0].phase, Phase::standing);
    EXPECT_NEAR(phases[0].share, 3.0 / 16.0, 1e-12);
    EXPECT_NEAR(phases[0].figures.bias, 0.0, 1e-9);
    EXPECT_NEAR(phases[0].figures.rmse, 1.0, 1e-9);
    EXPECT_EQ(phases[1].phase, Phase::slipping);
    EXPECT_NEAR(phases[1].share, 1.0 / 16.0, 1e-12);
    EXPECT_NEAR(phases[1].figures.bias, 1.0, 1e-9);
    EXPECT_EQ(phases[2].phase, Phase::free_rolling);
    EXPECT_NEAR(phases[2].share, 12.0 / 16.0, 1e-12);
    EXPECT_NEAR(phases[2].figures.bias, 2.0, 1e-9);
}

TEST(Comparison, AgainstSignalsThatVaryAndThoseTheModelDoesNotKnow) {
    // Slip power: 1000 N * 10 m/s * tan(1 deg) = 174.55 W at 6 s only. Load and air never change and are no signals.
    const Idle idle;
    const std::vector<RegressorFigures>& signals = idle.channel("surface_temperature").regressors;
    const auto find = [&](const std::string& name) {
        return std::find_if(signals.begin(), signals.end(), [&](const auto& r) { return r.name == name; });
    };
    ASSERT_NE(find("slip power"), signals.end());
    EXPECT_NEAR(find("slip power")->bins.back().high, 174.55, 0.01);
    ASSERT_NE(find("throttle"), signals.end());
    // Throttle 0.1 ... 0.5 with -2, -2, -2, -1, -1: sums 0.3 about the means, of sqrt(0.1 * 1.2).
    EXPECT_NEAR(find("throttle")->association.correlation, 0.3 / std::sqrt(0.1 * 1.2), 1e-9);
    EXPECT_EQ(find("vertical load"), signals.end());
    EXPECT_EQ(find("air temperature"), signals.end());
    EXPECT_NEAR(idle.channel("surface_temperature").significant, 0.05 / static_cast<double>(signals.size()), 1e-15);
}

TEST(Comparison, SingleNumbersInTheirUncertainty) {
    // (23 - 25) / 0.5 at the end of the first run.
    const Idle idle;
    ASSERT_EQ(idle.comparison.numbers.size(), 1u);
    const ComparedNumber& number = idle.comparison.numbers.front();
    EXPECT_NEAR(number.in_uncertainties(), -4.0, 1e-9);
    EXPECT_TRUE(number.at_end);
    const post::Report report = post::comparison_report(idle.comparison, {});
    const post::ReportSection& numbers = post::section(report, "Single values");
    EXPECT_EQ(post::cell_text(numbers, 0, "measured"), "25 degC");
    EXPECT_EQ(post::cell_text(numbers, 0, "+-"), "0.5");
    EXPECT_EQ(post::cell_text(numbers, 0, "simulated"), "23.00");
    EXPECT_EQ(post::cell_text(numbers, 0, "off by"), "-4.0 u, too cold");
    EXPECT_EQ(post::cell_text(numbers, 0, "source"), "needle");
}

TEST(Comparison, TheJsonSaysTheSameInKelvin) {
    const Idle idle;
    const nlohmann::json json =
        nlohmann::json::parse(post::json_text(post::comparison_report(idle.comparison, {"a/compare.csv"}).data));
    EXPECT_EQ(json["difference"], "simulated - measured");
    EXPECT_EQ(json["runs"][1]["name"], "second");
    EXPECT_EQ(json["outputs"][0], "a/compare.csv");
    const nlohmann::json& bulk =
        json["channels"][0]["name"] == "bulk_temperature" ? json["channels"][0] : json["channels"][1];
    EXPECT_EQ(bulk["difference_unit"], "K");
    EXPECT_NEAR(bulk["bias"].get<double>(), 7.0 / 6.0, 1e-9);
    EXPECT_NEAR(bulk["removable_rmse"].get<double>(), std::sqrt(21.0 / 6.0 - 0.16), 1e-9);
    EXPECT_TRUE(bulk["sensor_is_stated"].get<bool>());
    EXPECT_EQ(bulk["phases"][0]["phase"], "standing");
    EXPECT_TRUE(bulk["phases"][1]["bias_deviation"].is_null());  // a single sample
}

TEST(Comparison, FilesHaveARowForEachSampleAndEachFigure) {
    const Idle idle;
    const std::vector<std::filesystem::path> files =
        post::write_comparison(idle.comparison, {}, idle.written.folder() / "out");
    ASSERT_EQ(files.size(), 2u);
    const std::string samples = post::read_text(files[0]);
    EXPECT_EQ(std::count(samples.begin(), samples.end(), '\n'), 1 + 6 + 5);
    EXPECT_TRUE(samples.starts_with("time [s],run,channel,unit,measured,simulated,difference\n")) << samples;
    EXPECT_NE(samples.find("\n2,first,bulk_temperature,degC,24,23,-1\n"), std::string::npos) << samples;
    const std::string statistics = post::read_text(files[1]);
    EXPECT_NE(statistics.find("\nbulk_temperature,degC,run,second,,,2,3,0,3,0,2\n"), std::string::npos) << statistics;
    EXPECT_NE(statistics.find("\nbulk_temperature,degC,phase,slipping,,,1,1,,1,0,1\n"), std::string::npos)
        << statistics;
}

/// A channel whose differences are an offset and a slow part that follows a signal.
ComparedChannel made_up(double offset, double share, double noise) {
    ComparedChannel channel;
    channel.name = "bulk";
    channel.unit = solver::shown_unit(solver::Quantity::temperature);
    channel.sensor = 0.3;
    channel.sensor_is_stated = true;
    ComparedSeries series;
    series.regressor.resize(2);
    for (int i = 0; i < 1000; ++i) {
        const double t = i;
        const double signal = std::sin(t / 7.0) + std::sin(t / 11.0);
        series.time.push_back(t);
        series.measured.push_back(320.0);
        series.simulated.push_back(320.0 + offset + share * signal + noise * std::sin(1e3 * t * t));
        series.surroundings.push_back(290.0);
        series.phase.push_back(Phase::free_rolling);
        series.regressor[0].push_back(signal);
        series.regressor[1].push_back(std::sin(t / 3.0));
    }
    channel.series.push_back(series);
    evaluate(channel, {{"slip power", "W"}, {"speed", "km/h"}});
    return channel;
}

TEST(Comparison, SaysInWordsWhatItFinds) {
    // 2 K too hot and 0.5 K that follow slip power, whose mean over 1000 s is (7 * 1.085 + 11 * 1.981) / 1000 = 0.029: 2.01 K,
    // and 32.01 / 30 = 1.067 of the rise.
    const ComparedChannel channel = made_up(2.0, 0.5, 0.3);
    const std::vector<std::string> said = post::sentences(channel);
    ASSERT_EQ(said.size(), 4u);
    EXPECT_NE(said[0].find("2.01 +- "), std::string::npos) << said[0];
    EXPECT_NE(said[0].find(" K too hot on the whole"), std::string::npos) << said[0];
    EXPECT_NE(said[2].find("the simulated rise over the air is 1.067 times the measured one"), std::string::npos)
        << said[2];
    EXPECT_EQ(said[3].find("of 2 signals the differences follow slip power closest"), 0u) << said[3];
}

TEST(Comparison, SaysSoWhereNothingShows) {
    const ComparedChannel channel = made_up(0.0, 0.0, 0.2);
    const std::vector<std::string> said = post::sentences(channel);
    EXPECT_EQ(said[0].find("no significant bias: "), 0u) << said[0];
    EXPECT_EQ(said[1].find("the differences scatter by 0.14 K, less than the sensor may by itself, 0.30 K (stated)"),
              0u)
        << said[1];
    EXPECT_EQ(said[3].find("the differences follow none of 2 signals beyond chance"), 0u) << said[3];
}

TEST(Comparison, ARunThatFailsIsNamed) {
    const input::Written written;
    written.add("first.csv", sample::first_log);
    const input::ExperimentReading reading = input::read_experiment(written.add("hot.toml", sample::burning_bench));
    ASSERT_TRUE(reading.experiment.has_value()) << input::error_report(reading);
    const Comparison comparison = compare(*reading.experiment, "hot");
    EXPECT_FALSE(comparison.status.ok());
    EXPECT_EQ(comparison.status.message.find("run \"first\": "), 0u) << comparison.status.message;
    EXPECT_TRUE(comparison.channels.empty());
}

}  // namespace
}  // namespace tiretherm::diagnosis
