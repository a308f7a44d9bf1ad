// SPDX-License-Identifier: BSD-3-Clause
// A conductivity fitted on a coarse grid: what the error of the grid does to it, and what its correction leaves of that.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "diagnosis/fit/identification.hpp"
#include "diagnosis/fit/refinement.hpp"
#include "input/runs/read_experiment.hpp"
#include "support/written.hpp"

namespace tiretherm::diagnosis {

namespace {

/// A disc under a laser on 8 x 5 cells; sensors over the spot and behind it.
constexpr std::string_view coarse_laser = R"([mesh]
kind = "axisymmetric"
radius = [{ to = "5 mm", cells = 4 }, { to = "20 mm", cells = 4 }]
[[mesh.layer]]
name = "tread"
thickness = "5 mm"
cells = 5
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.5 W/mK"
[effects.laser]
radius = "5 mm"
absorptivity = 0.95
[effects.still_air]
patches = ["top", "bottom"]
[drive]
laser_power = "2 W"
air_temperature = "23 degC"
[initial]
temperature = "23 degC"
[[sensor]]
name = "spot"
kind = "spot"
patch = "top"
radius = "5 mm"
standard_deviation = "0.05 K"
[[sensor]]
name = "back"
kind = "point"
depth = "5 mm"
standard_deviation = "0.05 K"
[[parameter]]
material = "rubber"
law = "conductivity"
at = "60 degC"
[[run]]
file = "heating.csv"
)";

/// The case with readings that are to be replaced. @param finer times as many cells each way
input::Experiment heated_disc(int finer) {
    std::string log = "time [s],spot [degC],back [degC]\n";
    for (int i = 0; i <= 40; ++i) {
        log += fmt::format("{},{:.2f},{:.2f}\n", 6 * i, 23.0 + 1.1 * i, 23.0 + 0.7 * i);
    }
    const input::Written written;
    written.add("heating.csv", log);
    input::ExperimentReading reading =
        input::read_experiment(written.add("case.toml", coarse_laser), {}, input::ReadMode::measured, {.finer = finer});
    for (const input::InputError& error : reading.errors) {
        ADD_FAILURE() << render(error);
    }
    return reading.experiment.value_or(input::Experiment{});
}

/// What a grid of 32 x 20 cells and steps held to 0.1 mK give at 0.55 W/mK, with white noise of 0.02 K.
void measure_on_a_fine_grid(input::Experiment& experiment, double truth) {
    const input::Experiment fine = heated_disc(4);
    const Observations observations = observe(fine);
    const Simulator simulator(fine, observations);
    solver::Problem problem = simulator.problem(0, Eigen::VectorXd::Constant(1, truth));
    problem.settings.tolerance = 1e-4;
    input::MeasuredRun& run = experiment.runs.front();
    const solver::Prediction prediction = solver::predict(problem, {.times = run.time});
    std::mt19937_64 engine(5);
    std::normal_distribution<double> noise(0.0, 0.02);
    for (input::MeasuredSeries& series : run.series) {
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            series.value[i] = prediction.value[i * prediction.n_channels + series.channel] + noise(engine);
        }
    }
}

}  // namespace

// The data are those of a grid four times as fine. On the coarse grid the conductivity makes up for its error and lies off by
// more than a tenth, which passes for slow noise of the sensors; corrected by a grid twice as fine, at second order, no more than a quarter of that is left,
// and the truth lies within the interval, to which a quarter of the correction belongs.
TEST(IdentificationGrid, TheCorrectionBringsAConductivityBackToTheTruth) {
    constexpr double truth = 0.55;
    input::Experiment experiment = heated_disc(1);
    const input::Experiment finer = heated_disc(2);
    measure_on_a_fine_grid(experiment, truth);
    const Observations observations = observe(experiment);
    const Identification rough = identify(experiment, observations);
    const Identification corrected = identify(experiment, observations, {.finer = &finer});
    ASSERT_TRUE(rough.status.ok()) << rough.status.message;
    ASSERT_TRUE(corrected.status.ok()) << corrected.status.message;
    const double off = std::abs(rough.fitted.front().value - truth);
    EXPECT_GT(off, 0.1 * truth);
    EXPECT_LT(std::abs(corrected.fitted.front().value - truth), 0.25 * off);
    EXPECT_LT(corrected.fitted.front().low, truth);
    EXPECT_GT(corrected.fitted.front().high, truth);
    EXPECT_NEAR(corrected.fitted.front().by_grid, corrected.fitted.front().value - rough.fitted.front().value, 1e-12);
    EXPECT_GT(corrected.channels.front().grid_error, 0.05);
}

// The same error without a fit, of the case at its own 0.5 W/mK: what grids once and twice as fine differ by, carried on at second
// order, is four thirds of it.
TEST(IdentificationGrid, TheErrorOfACaseAsItStandsIsFourThirdsOfWhatTheFinerGridShows) {
    const input::Experiment experiment = heated_disc(1);
    const input::Experiment finer = heated_disc(2);
    const std::vector<GridError> errors = grid_errors(experiment, finer);
    ASSERT_EQ(errors.size(), 2U);
    const std::vector<double>& time = experiment.runs.front().time;
    const auto readings = [&](const input::Experiment& of) {
        solver::Problem problem = of.runs.front().problem;
        problem.settings.tolerance = 1e-4;
        return solver::predict(problem, {.times = time}).value;
    };
    const std::vector<double> coarse = readings(experiment);
    const std::vector<double> fine = readings(finer);
    for (const GridError& error : errors) {
        double largest = 0.0;
        for (std::size_t i = error.channel; i < coarse.size(); i += experiment.runs.front().problem.channels.size()) {
            largest = std::max(largest, 4.0 / 3.0 * std::abs(fine[i] - coarse[i]));
        }
        EXPECT_NEAR(error.largest, largest, 0.1 * largest + 0.02) << error.channel;
    }
}

}  // namespace tiretherm::diagnosis
