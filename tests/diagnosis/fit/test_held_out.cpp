// SPDX-License-Identifier: BSD-3-Clause
// Cross-validation by refits: folds, rows that are left out, and intervals from the scatter between blocks.

#include "diagnosis/fit/held_out.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/fit/identification.hpp"
#include "diagnosis/fit/left_out.hpp"
#include "tests/diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis::sample {
namespace {

struct Fitted3 {
    input::Experiment experiment = with_fine_steps(practice_bench());
    Observations observations = observe(experiment);
    Covariance noise{.channels = {{.sigma = 0.5}, {.sigma = 0.3}}, .weight = {}};
    std::vector<std::vector<double>> steps;
    Refit full;

    Fitted3() {
        Fit fit(experiment, observations);
        fit.take_covariance(noise);
        EXPECT_TRUE(fit.move_to(fit.simulator().start()));
        full = refit(fit);
        steps = fit.simulator().steps();
    }
};

TEST(HeldOut, EveryRunIsLeftOutOnce) {
    const Fitted3 made;
    const std::vector<Fold> folds = folds_of(made.observations);
    ASSERT_EQ(folds.size(), 3U);
    std::size_t tested = 0;
    for (const Fold& fold : folds) {
        EXPECT_EQ(fold.test.size() + fold.rest.size(), made.observations.rows.size());
        tested += fold.test.size();
    }
    EXPECT_EQ(tested, made.observations.rows.size());
}

TEST(HeldOut, QuartersOfASingleRunKeepADistance) {
    input::Experiment experiment = practice_bench();
    experiment.runs.resize(1);
    const Observations observations = observe(experiment);
    const std::vector<Fold> folds = folds_of(observations);
    ASSERT_EQ(folds.size(), 4U);
    for (const Fold& fold : folds) {
        const auto time = [&](Eigen::Index row) {
            return observations.times[0][observations.rows[static_cast<std::size_t>(row)].time];
        };
        double nearest = 1e9;
        for (const Eigen::Index test : {fold.test.front(), fold.test.back()}) {
            for (const Eigen::Index rest : fold.rest) {
                nearest = std::min(nearest, std::abs(time(test) - time(rest)));
            }
        }
        EXPECT_GE(nearest, 0.05 * 2400.0);  // runs of forty minutes
    }
}

/// Two recordings of a car's two front tires, or one of them: the practice bench's runs under the names of corners.
input::Experiment car_of(std::size_t recordings) {
    const input::Experiment bench = practice_bench();
    input::Experiment car = bench;
    car.runs.clear();
    for (std::size_t r = 0; r < recordings; ++r) {
        for (const char* corner : {"FL", "FR"}) {
            car.runs.push_back(bench.runs[r]);
            car.runs.back().recording = bench.runs[r].name;
            car.runs.back().corner = corner;
            car.runs.back().name = bench.runs[r].name + "_" + corner;
        }
    }
    return car;
}

/// When the last sample of a fold's test was taken. s
double last_of_test(const Observations& observations, const Fold& fold) {
    double last = 0.0;
    for (const Eigen::Index row : fold.test) {
        const Observations::Row& what = observations.rows[static_cast<std::size_t>(row)];
        last = std::max(last, observations.times[what.run][what.time]);
    }
    return last;
}

/// Runs of forty minutes cut into laps of ten.
input::Experiment bench_of_laps(std::size_t runs) {
    input::Experiment experiment = with_fine_steps(practice_bench());
    experiment.runs.resize(runs);
    for (std::size_t j = experiment.parameters.size(); j-- > 0;) {
        const std::vector<std::size_t>& of = experiment.parameters[j].runs;
        if (std::ranges::any_of(of, [&](std::size_t run) { return run >= runs; })) {
            experiment.parameters.erase(experiment.parameters.begin() + static_cast<std::ptrdiff_t>(j));
        }
    }
    for (input::MeasuredRun& run : experiment.runs) {
        for (int lap = 0; lap < 4; ++lap) {
            run.laps.push_back({.number = lap + 1, .start = 600.0 * lap, .end = 600.0 * (lap + 1)});
        }
    }
    return experiment;
}

// Of two runs of four laps there are eight, or the two themselves; of one run no run can be left out.
TEST(LeftOut, IsEachLapOrEachRun) {
    const input::Experiment two = bench_of_laps(2);
    const Observations observations = observe(two);
    const std::vector<NamedFold> laps = named_folds(two, observations, LeaveOut::lap);
    ASSERT_EQ(laps.size(), 8U);
    EXPECT_EQ(laps[5].name, two.runs[1].name + ", lap 2");
    for (const Eigen::Index row : laps[5].fold.test) {
        const Observations::Row& what = observations.rows[static_cast<std::size_t>(row)];
        const double time = observations.times[what.run][what.time];
        EXPECT_TRUE(what.run == 1 && time >= 600.0 && time < 1200.0);
    }
    EXPECT_EQ(named_folds(two, observations, LeaveOut::run).size(), 2U);
    const input::Experiment one = bench_of_laps(1);
    EXPECT_EQ(named_folds(one, observe(one), LeaveOut::lap).front().name, "lap 1");
    EXPECT_TRUE(named_folds(one, observe(one), LeaveOut::run).empty());
    EXPECT_TRUE(named_folds(one, observe(one), LeaveOut::nothing).empty());
}

// The model of the bench is that of its data: what was left out is predicted as well as it is fitted, to 10 % (chance: hundreds of
// independent samples leave 5 %). With a lap that is 3 K too hot that lap is predicted badly, and the fit to the others does not
// know of it.
TEST(LeftOut, ALapThatIsWrongIsPredictedBadly) {
    input::Experiment experiment = bench_of_laps(1);
    const auto leave_out = [&] {
        const Observations observations = observe(experiment);
        return identify(experiment, observations, {.leave_out = named_folds(experiment, observations, LeaveOut::lap)});
    };
    const Identification sound = leave_out();
    ASSERT_EQ(sound.left_out.size(), 4U);
    for (const LeftOut& one : sound.left_out) {
        ASSERT_EQ(one.channels.size(), 2U);
        if (one.name != "lap 1") {  // where the start is, which the others know least of
            EXPECT_NEAR(one.channels[0].rms_predicted, one.channels[0].rms_fitted, 0.1 * one.channels[0].rms_fitted)
                << one.name;
            // Some 80 independent samples of a lap have an rms to 8 %, those of the rest to 5 %: three of the 9 % of both.
            EXPECT_NEAR(one.channels[0].rms_expected, one.channels[0].rms_predicted, 0.27 * one.channels[0].rms_fitted)
                << one.name;
        }
        EXPECT_LT(one.moves.cwiseAbs().maxCoeff(), least_move(sound.left_out)) << one.name;
    }
    for (std::size_t i = 0; i < experiment.runs[0].time.size(); ++i) {
        const double time = experiment.runs[0].time[i];
        for (input::MeasuredSeries& series : experiment.runs[0].series) {
            series.value[i] += time >= 1200.0 && time < 1800.0 ? 3.0 : 0.0;
        }
    }
    const Identification wrong = leave_out();
    ASSERT_EQ(wrong.left_out.size(), 4U);
    for (const LeftOutChannel& channel : wrong.left_out[2].channels) {
        EXPECT_NEAR(channel.rms_predicted, 3.0, 0.5);
        EXPECT_LT(channel.rms_fitted, channel.rms_predicted);
    }
    EXPECT_EQ(wrong.left_out[2].channels[1].samples, 150);  // every 4 s
}

// Two runs, of which the second has its first five minutes alone. Without the long one the parameters move by many of the standard
// deviations of the fit to both, as they must: that fit knows them by the long run. The move itself is no more than chance.
TEST(LeftOut, ARunThatCarriesTheInformationMayMoveTheParameters) {
    input::Experiment experiment = bench_of_laps(2);
    for (input::MeasuredSeries& series : experiment.runs[1].series) {
        for (std::size_t i = 0; i < series.value.size(); ++i) {
            series.value[i] = experiment.runs[1].time[i] > 300.0 ? std::nan("") : series.value[i];
        }
    }
    const Observations observations = observe(experiment);
    const Identification found =
        identify(experiment, observations, {.leave_out = named_folds(experiment, observations, LeaveOut::run)});
    ASSERT_EQ(found.left_out.size(), 2U);
    double most = 0.0;  // in standard deviations of the fit to both
    for (std::size_t j = 0; j < experiment.parameters.size(); ++j) {
        if (experiment.parameters[j].kind != solver::FreeParameter::Kind::initial) {
            const Fitted& both = found.fitted[j];
            most = std::max(most, std::abs(found.left_out[0].values[static_cast<Eigen::Index>(j)] - both.value) /
                                      both.standard_deviation);
        }
    }
    EXPECT_GT(most, 4.0);
    EXPECT_LT(found.left_out[0].moves.cwiseAbs().maxCoeff(), least_move(found.left_out));
}

TEST(HeldOut, TheTiresOfACarAreLeftOutTogether) {
    const Observations observations = observe(car_of(2));
    EXPECT_EQ(observations.recordings, (std::vector<std::size_t>{0, 0, 1, 1}));
    const std::vector<Fold> folds = folds_of(observations);
    ASSERT_EQ(folds.size(), 2U);
    EXPECT_EQ(folds[1].runs, (std::vector<std::size_t>{2, 3}));
    for (const Eigen::Index row : folds[1].test) {
        EXPECT_GE(observations.rows[static_cast<std::size_t>(row)].run, 2U);
    }
    const auto has = [&](std::vector<std::size_t> runs, solver::FreeParameter::Kind kind,
                         double known = std::numeric_limits<double>::infinity()) {
        solver::FreeParameter parameter;
        parameter.kind = kind;
        parameter.standard_deviation = known;
        parameter.runs = std::move(runs);
        return folds[1].alone_has(parameter);
    };
    EXPECT_TRUE(has({2, 3}, solver::FreeParameter::Kind::initial));
    EXPECT_FALSE(has({0, 2}, solver::FreeParameter::Kind::initial));
    EXPECT_FALSE(has({}, solver::FreeParameter::Kind::initial));
    // A coefficient of which something was known before is predicted as it was known; of another the rest says nothing.
    EXPECT_FALSE(has({2, 3}, solver::FreeParameter::Kind::effect, 0.1));
    EXPECT_TRUE(has({2, 3}, solver::FreeParameter::Kind::effect));
}

// A run of 2400 s with laps that end at 500, 1000, 1500, 2000 and 2400 s: cut at 500, 1000 and 2000 s, the ends next to 600, 1200
// and 1800 s, for both tires at once. Without laps at the quarters.
TEST(HeldOut, ASingleSessionIsCutAtLaps) {
    input::Experiment car = car_of(1);
    const Observations plain = observe(car);
    EXPECT_NEAR(last_of_test(plain, folds_of(plain).at(0)), 600.0, 10.0);
    double start = 0.0;
    for (const double end : {500.0, 1000.0, 1500.0, 2000.0, 2400.0}) {
        for (input::MeasuredRun& run : car.runs) {
            run.laps.push_back({.start = start, .end = end});
        }
        start = end;
    }
    const Observations observations = observe(car);
    const std::vector<Fold> folds = folds_of(observations);
    ASSERT_EQ(folds.size(), 4U);
    const std::array<double, 3> cuts{500.0, 1000.0, 2000.0};
    for (std::size_t f = 0; f < cuts.size(); ++f) {
        EXPECT_NEAR(last_of_test(observations, folds[f]), cuts.at(f), 10.0);
        EXPECT_TRUE(folds[f].runs.empty());
        EXPECT_LT(observations.rows[static_cast<std::size_t>(folds[f].test.front())].run, 1U);
        EXPECT_EQ(observations.rows[static_cast<std::size_t>(folds[f].test.back())].run, 1U);
    }
}

// All laps end after 60 % of 2400 s. None is within 300 s of the first quarter, 600 s, which stays; 1440 s takes the place of the
// second. No sample is tested twice.
TEST(HeldOut, LapsThatLieFarFromAQuarterDoNotMoveIt) {
    input::Experiment car = car_of(1);
    double start = 0.0;
    for (const double end : {1440.0, 1680.0, 1920.0, 2160.0}) {
        for (input::MeasuredRun& run : car.runs) {
            run.laps.push_back({.start = start, .end = end});
        }
        start = end;
    }
    const Observations observations = observe(car);
    std::size_t tested = 0;
    for (const Fold& fold : folds_of(observations)) {
        tested += fold.test.size();
    }
    EXPECT_EQ(tested, observations.rows.size());
    const std::vector<Fold> folds = folds_of(observations);
    ASSERT_EQ(folds.size(), 4U);
    EXPECT_NEAR(last_of_test(observations, folds[0]), 600.0, 10.0);
    EXPECT_NEAR(last_of_test(observations, folds[1]), 1440.0, 10.0);
}

TEST(HeldOut, ASubsetIsSimulatedAsTheWhole) {
    const Fitted3 made;
    const Fold fold = folds_of(made.observations).at(1);
    const Observations some = subset(made.observations, fold.test);
    Simulator simulator(made.experiment, some);
    simulator.take_steps(made.steps);
    const ModelPrediction& there = simulator.at(made.full.values);
    ASSERT_TRUE(there.status.ok());
    EXPECT_EQ(simulator.simulations(), 1);  // runs without rows are not simulated
    EXPECT_LT((there.simulated - made.full.simulated(fold.test)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(some.measured, made.observations.measured(fold.test));
}

// The model that made the runs predicts a run that was left out as well as its noise allows: 0.5 and 0.3 K with two numbers
// and two starts of 1 202 values (0.3 %), a scatter of 2 % of an rms of 600 correlated values of 7 s in steps of 4 s.
TEST(HeldOut, TheTrueModelIsLeftWithItsNoise) {
    const Fitted3 made;
    const HeldOutErrors out = held_out(made.experiment, made.observations, made.noise, made.steps, made.full);
    ASSERT_TRUE(out.ok);
    EXPECT_TRUE(out.left.allFinite());
    EXPECT_NEAR(std::sqrt(out.mean_square(made.observations, 0)), 0.5, 0.05);
    EXPECT_NEAR(std::sqrt(out.mean_square(made.observations, 1)), 0.3, 0.03);
}

// Folds are fitted by the slopes of the fit to everything. They come to where a fit with slopes of its own comes to, which stops
// within a twentieth of a standard deviation itself.
TEST(HeldOut, AFoldComesToWhereAFitWithItsOwnSlopesDoes) {
    const Fitted3 made;
    const HeldOutErrors out = held_out(made.experiment, made.observations, made.noise, made.steps, made.full);
    const std::vector<Fold> folds = folds_of(made.observations);
    ASSERT_EQ(out.values.size(), folds.size());
    for (std::size_t f = 0; f < folds.size(); ++f) {
        const Observations rest = subset(made.observations, folds[f].rest);
        Fit fit(made.experiment, rest);
        fit.simulator().take_steps(made.steps);
        fit.take_covariance(subset(made.noise, folds[f].rest));
        ASSERT_TRUE(fit.move_to(made.full.values));
        const Refit own = refit(fit);
        const Eigen::VectorXd deviation = own.deviations();
        for (Eigen::Index j = 0; j < 2; ++j) {
            EXPECT_NEAR(out.values[f][j], own.values[j], 0.1 * deviation[j])
                << made.experiment.parameters[static_cast<std::size_t>(j)].name;
        }
    }
}

// Not fitted, the case's own numbers stay: a film 5 % and a loss 7 % off leave more than a degree in the bulk.
TEST(HeldOut, TheCaseAsItStandsIsNotFitted) {
    const Fitted3 made;
    Fit fit(made.experiment, made.observations);
    fit.simulator().take_steps(made.steps);
    fit.take_covariance(made.noise);
    ASSERT_TRUE(fit.move_to(fit.simulator().start()));
    const Refit plain = refit(fit, 0);
    const HeldOutErrors out = held_out(made.experiment, made.observations, made.noise, made.steps, plain, false);
    ASSERT_TRUE(out.ok);
    EXPECT_GT(std::sqrt(out.mean_square(made.observations, 1)), 1.0);
}

// A straight line y = a x of 40 blocks, whose error is one number a block: the noise of a sample says sigma / |x|, the blocks
// say sqrt(10) times as much, ten samples of a block being one. 40 blocks know it to a tenth.
TEST(BlockDeviations, SeeErrorsThatBlocksShare) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    double square = 0.0;
    double formal = 0.0;
    constexpr int draws = 40;
    for (int draw = 0; draw < draws; ++draw) {
        Observations observations;
        observations.times.resize(1);
        observations.recordings = {0};
        Refit fit;
        fit.values = Eigen::VectorXd::Zero(1);
        fit.scale = Eigen::VectorXd::Ones(1);
        fit.precision = Eigen::VectorXd::Zero(1);
        fit.at_bound = {false};
        fit.slopes = Eigen::MatrixXd::Ones(400, 1);
        fit.residual.resize(400);
        for (int i = 0; i < 400; ++i) {
            observations.times[0].push_back(i);
            observations.rows.push_back({.time = static_cast<std::size_t>(i)});
            fit.residual[i] = i % 10 == 0 ? normal(random) : fit.residual[i - 1];
        }
        const BlockDeviations found = block_deviations(fit, observations, 10.0);
        EXPECT_EQ(found.blocks, 40);
        square += std::pow(found.deviation[0], 2) / draws;
        formal = fit.deviations()[0];
    }
    EXPECT_NEAR(formal, 0.05, 1e-6);  // 1 / sqrt(400)
    EXPECT_NEAR(std::sqrt(square) / formal, std::sqrt(10.0), 0.3);
}

// Means of three numbers with one left out: those of 1, 2, 6 are 4, 3.5, 1.5, whose jackknife is the standard error of the
// mean, sqrt(7 / 3) = 1.5275; Student's t of two is 4.303.
TEST(Jackknife, OfAMeanIsItsStandardError) {
    const auto value = [](double x) { return Eigen::VectorXd(Eigen::VectorXd::Constant(1, x)); };
    const Eigen::VectorXd half = jackknife_half_widths({value(4.0), value(3.5), value(1.5)});
    EXPECT_NEAR(half[0], 4.303 * std::sqrt(7.0 / 3.0), 1e-3);
    EXPECT_EQ(jackknife_half_widths({value(4.0)}).size(), 0);
}

TEST(BlockDeviations, StudentFollowsItsTable) {
    EXPECT_NEAR(student(1), 12.706, 1e-3);
    EXPECT_NEAR(student(10), 2.228, 1e-3);
    EXPECT_NEAR(student(20), 2.086, 0.005);  // tables of Student's t
    EXPECT_NEAR(student(60), 2.000, 0.003);
    EXPECT_NEAR(student(100000), 1.960, 1e-3);
}

}  // namespace
}  // namespace tiretherm::diagnosis::sample
