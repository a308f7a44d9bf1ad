// SPDX-License-Identifier: BSD-3-Clause
// The first sentences of a fit and of a plan, and the figures by lap that a fit leaves.
#include "post/identification/identification_headline.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "post/report/file.hpp"
#include "tests/diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {
namespace {

using post::identification_headline;
using post::IdentificationRecord;
using post::read_text;
using post::write_identification;

/// A fit of the practice bench that nobody made: it came to what was known before, and to 0.5 K below all readings.
struct MadeUpFit {
    input::Experiment experiment = sample::practice_bench();
    Observations observations = observe(experiment);
    Identification result;

    MadeUpFit() {
        for (const solver::FreeParameter& one : experiment.parameters) {
            const double width = 0.1 * one.standard_deviation;
            result.fitted.push_back({.value = one.prior,
                                     .before = one.prior,
                                     .standard_deviation = 0.5 * width,
                                     .low = one.prior - width,
                                     .high = one.prior + width});
        }
        result.channels.resize(2);
        result.channels[0].name = "surface_temperature";
        result.channels[0].stated = 0.5;
        result.channels[0].rmse_after = 0.98;
        result.channels[1].channel = 1;
        result.channels[1].name = "bulk_temperature";
        result.channels[1].rmse_after = 0.31;
        result.before = result.after = observations.measured.array() - 0.5;
        result.values.setZero(static_cast<Eigen::Index>(result.fitted.size()));
    }
    [[nodiscard]] IdentificationRecord record(bool planned = false) const {
        return {.experiment = experiment,
                .observations = observations,
                .result = result,
                .case_file = sample::practice() / "two_node_bench.toml",
                .data = {},
                .warnings = {},
                .findings = {},
                .planned = planned};
    }
    /// A parameter with an interval of +- 0.04 about 1.09.
    Fitted& film(Identifiability what) {
        Fitted& one = result.fitted[sample::index_of(experiment, sample::film)];
        one = {.value = 1.09, .before = 1.0, .standard_deviation = 0.02, .low = 1.05, .high = 1.13};
        one.identifiability = what;
        return one;
    }
};

/// What the first sentence says of the parameter, without the full stop.
std::string of_film(const std::vector<std::string>& sentences) {
    const std::string& values = sentences.front();
    const std::size_t from = values.find("air_convection.lambda_h");
    return from == std::string::npos ? ""
                                     : values.substr(from, std::min(values.find(';', from), values.size() - 1) - from);
}

}  // namespace

// The first sentence has the values with their intervals; then come the counts, and how the channels fit, beside the data
// sheet where there is one.
TEST(IdentificationHeadline, IsTheValuesTheCountAndTheMisfit) {
    MadeUpFit fit;
    fit.film(Identifiability::determined);
    const std::vector<std::string> sentences = identification_headline(fit.record());
    const std::size_t n = fit.result.fitted.size();
    EXPECT_EQ(sentences[1], fmt::format("{} of {} parameters are determined by the data.", n, n));
    EXPECT_EQ(of_film(sentences), "air_convection.lambda_h 1.090 (95 %: 1.050 to 1.130)");
    EXPECT_EQ(sentences.back(),
              "rms after the fit: surface_temperature 0.98 K (data sheet 0.5), bulk_temperature 0.31 K.");
}

// What the data do not determine is named with what it is, and comes behind what they do; without an interval none is shown.
TEST(IdentificationHeadline, SaysWhatTheDataDoNotDetermine) {
    MadeUpFit fit;
    fit.film(Identifiability::doubtful);
    const std::size_t n = fit.result.fitted.size();
    const std::vector<std::string> doubtful = identification_headline(fit.record());
    EXPECT_EQ(doubtful[1], fmt::format("{} of {} parameters are determined by the data, 1 doubtful.", n - 1, n));
    EXPECT_EQ(of_film(doubtful), "air_convection.lambda_h 1.090 (95 %: 1.050 to 1.130), doubtful");
    EXPECT_FALSE(doubtful.front().starts_with("air_convection.lambda_h")) << doubtful.front();
    fit.film(Identifiability::not_determined);
    EXPECT_EQ(of_film(identification_headline(fit.record())).find("95 %"), std::string::npos);
    fit.film(Identifiability::at_bound).high_is_open = true;
    EXPECT_EQ(of_film(identification_headline(fit.record())),
              "air_convection.lambda_h 1.090 (95 %: 1.050 to > 1.130), at bound");
}

// Of a plan there is no value and no misfit, but the width that the interval would have.
TEST(IdentificationHeadline, OfAPlanIsTheWidthThatIntervalsWouldHave) {
    MadeUpFit fit;
    fit.film(Identifiability::determined);
    const std::vector<std::string> sentences = identification_headline(fit.record(true));
    const std::size_t n = fit.result.fitted.size();
    EXPECT_EQ(sentences[1], fmt::format("{} of {} parameters would be determined by the data.", n, n));
    EXPECT_EQ(of_film(sentences), "air_convection.lambda_h +- 0.040 (95 %)");
    EXPECT_EQ(sentences.back().find("rms"), std::string::npos);
}

// The grid moves the surface by 0.2 K, two fifths of its noise, and the gauge by 50 Pa, a twentieth of its own.
TEST(FitSection, NamesTheGridErrorOfTheChannelThatItMovesMost) {
    MadeUpFit fit;
    fit.experiment.runs.front().problem.channels[1].quantity = solver::Quantity::gas_pressure;
    fit.result.channels[0].grid_error = 0.2;
    fit.result.channels[0].noise.sigma = 0.5;
    fit.result.channels[1].grid_error = 50.0;
    fit.result.channels[1].noise.sigma = 1000.0;
    const post::Report report = post::identification_report(fit.record(), {});
    EXPECT_NE(post::page_text(report, false).find("at most 0.2 K of"), std::string::npos)
        << post::page_text(report, false);
}

// Two laps of the first run: a row for each, and one for each run as a whole, of two channels in three runs. Of runs without laps
// there is no such file.
TEST(IdentificationFiles, LapsAreWrittenWhereThereAreAny) {
    MadeUpFit fit;
    const input::Written written;
    const auto names = [&] {
        std::vector<std::string> all;
        for (const std::filesystem::path& file : write_identification(fit.record(), written.folder() / "out")) {
            all.push_back(file.filename().string());
        }
        return all;
    };
    EXPECT_EQ(std::ranges::count(names(), "laps.csv"), 0);
    fit.experiment.runs.front().laps = {{.number = 1, .start = 0.0, .end = 600.0},
                                        {.number = 2, .start = 600.0, .end = 1200.0}};
    EXPECT_EQ(std::ranges::count(names(), "laps.csv"), 1);
    const std::string laps = read_text(written.folder() / "out/laps.csv");
    EXPECT_EQ(std::ranges::count(laps, '\n'), 1 + 2 * (2 + 3)) << laps;
}

}  // namespace tiretherm::diagnosis
