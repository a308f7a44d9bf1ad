// SPDX-License-Identifier: BSD-3-Clause
// Dense logs thinned to block means: fitted numbers, their intervals and a delay stay; short logs, slow sensors, gaps.

#include <numbers>

#include "diagnosis/observations/thinning.hpp"

#include "diagnosis/noise/noise_sample.hpp"
#include "diagnosis/practice_bench.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::diagnosis {

namespace {

using std::numbers::pi;

/// Laps of 80 s with corners every 13 s, on the bench.
sample::Log laps(double rate, double length) {
    sample::Log log{.headings = {"time [s]", "speed [m/s]", "vertical_load [N]", "slip_angle [rad]",
                                 "lateral_force [N]", "air_temperature [K]", "road_temperature [K]", "throttle [-]",
                                 "surface_temperature [K]", "bulk_temperature [K]"},
                    .columns = {}};
    log.columns.resize(log.headings.size());
    for (int i = 0; i < static_cast<int>(rate * length); ++i) {
        const double t = i / rate;
        const double corner = std::pow(std::sin(2.0 * pi * t / 26.0), 3);
        const double row[] = {t,
                              25.0 + 14.0 * std::sin(2.0 * pi * t / 80.0),
                              4000.0,
                              0.05 * corner,
                              -2500.0 * corner,
                              289.15,
                              291.15,
                              0.5 + 0.5 * std::sin(2.0 * pi * t / 80.0),
                              293.0 + 0.001 * t,
                              293.0};
        for (std::size_t c = 0; c < log.columns.size(); ++c) {
            log.columns[c].push_back(row[c]);
        }
    }
    return log;
}

/// The bench with such a log, whose camera may be late; its sensors still say nothing of use.
input::Experiment bench_on_laps(double rate, double length) {
    std::string text = sample::practice_text();
    text = text.substr(0, text.find("[[run]]")) +
           "[effects.clock_delay]\nchannels = [\"surface_temperature\"]\ndelay = \"0.1 s\"\n"
           "[[parameter]]\neffect = \"clock_delay\"\nkey = \"delay\"\nexpected = \"0.1 s\"\nstandard_deviation = \"1 "
           "s\"\n";
    const input::Written written;
    return sample::read_bench(written.add("bench.toml", text), {written.add("laps.csv", laps(rate, length).text())});
}

/// What the sensors would read without noise, of a tire whose film and loss are a little off and whose camera is 0.2 s late.
void read_truth(input::MeasuredRun& run, const input::Experiment& experiment) {
    solver::Problem truth = run.problem;
    for (const solver::FreeParameter& parameter : experiment.parameters) {
        const double now = solver::value_of(run.problem, parameter);
        if (parameter.name == sample::film || parameter.name == sample::loss) {
            solver::move(truth, parameter, now, 1.03 * now);
        } else if (parameter.name == "clock_delay.delay") {
            solver::move(truth, parameter, now, 0.2);
        }
    }
    const solver::Prediction read = solver::predict(truth, {.times = run.time});
    ASSERT_TRUE(read.status.ok()) << read.status.message;
    for (input::MeasuredSeries& series : run.series) {
        series.frozen = false;
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            series.value[i] = read.at(i, series.channel);
        }
    }
}

void add_noise(input::MeasuredRun& run, const std::vector<Noise>& noise) {
    for (std::size_t s = 0; s < run.series.size(); ++s) {
        const std::vector<double> drawn = sample::draw(noise[s], run.time, 77 + s);
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            run.series[s].value[i] += drawn[i];
        }
    }
}

/// 12 min at 8 Hz, 5 760 samples: 3.84 times 1 500, so four of them make a value, and 2 Hz are left.
input::Experiment twelve_minutes() {
    input::Experiment experiment = bench_on_laps(8.0, 720.0);
    read_truth(experiment.runs.front(), experiment);
    return experiment;
}

void expect_the_same_fit(const input::Experiment& dense) {
    const Thinned few = thinned(dense);
    ASSERT_EQ(few.runs.front().samples, 4U);
    ASSERT_EQ(few.experiment.runs.front().time.size(), 1440U);
    const Identification all = sample::fit(dense);
    const Identification some = sample::fit(few.experiment);
    for (std::size_t j = 0; j < all.fitted.size(); ++j) {
        const double sd = all.fitted[j].standard_deviation;
        EXPECT_NEAR(some.fitted[j].value, all.fitted[j].value, 0.1 * sd) << dense.parameters[j].name;
        EXPECT_NEAR(some.fitted[j].standard_deviation, sd, 0.1 * sd) << dense.parameters[j].name;
    }
    const std::size_t delay = sample::index_of(dense, "clock_delay.delay");
    EXPECT_NEAR(some.fitted[delay].value, 0.2, 3.0 * some.fitted[delay].standard_deviation);
}

}  // namespace

// Four values of white noise have a mean of half its sigma: as many values of it say the same as the samples. What is lost
// is what the temperatures do within half a second. An estimate from fewer data differs from that of all by a standard
// deviation of sqrt(sd2^2 - sd1^2), 0.1 sd for a loss of 1 % of the variance in the numbers that see slow changes; the
// intervals follow the estimated noise, which 1 440 values give to 1 / sqrt(2 * 1440) = 2 %.
TEST(Thinning, NumbersAndIntervalsStayInWhiteNoise) {
    input::Experiment dense = twelve_minutes();
    add_noise(dense.runs.front(), {{.sigma = 0.5}, {.sigma = 0.3}});
    expect_the_same_fit(dense);
}

// Noise that lasts 7 and 11 s hardly differs within half a second, and its mean keeps its sigma.
TEST(Thinning, NumbersAndIntervalsStayInCorrelatedNoise) {
    input::Experiment dense = twelve_minutes();
    add_noise(dense.runs.front(), {{.sigma = 0.5, .correlation_time = 7.0, .white_share = 0.3},
                                   {.sigma = 0.3, .correlation_time = 11.0, .white_share = 0.3}});
    expect_the_same_fit(dense);
}

// The mean of what the case says over a block is taken off, what it says in the middle is put back: where the readings are
// those of the case itself, the values are the case's at those times, however bent they are. Steps are the same.
TEST(Thinning, ReadingsOfTheModelStayOnTheModel) {
    input::Experiment dense = bench_on_laps(8.0, 720.0);
    input::MeasuredRun& run = dense.runs.front();
    const solver::Prediction read = solver::predict(run.problem, {.times = run.time});
    for (input::MeasuredSeries& series : run.series) {
        series.frozen = false;
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            series.value[i] = read.at(i, series.channel);
        }
    }
    const Thinned all = thinned(dense);
    const input::MeasuredRun& few = all.experiment.runs.front();
    const solver::Prediction then = solver::predict(run.problem, {.times = few.time});
    EXPECT_NEAR(few.time[1] - few.time[0], 0.5, 1e-9);
    EXPECT_NEAR(few.time[0], 1.5 * 0.125, 1e-9);  // the mean of 0, 1, 2 and 3 intervals
    for (const input::MeasuredSeries& series : few.series) {
        for (std::size_t i = 0; i < few.time.size(); ++i) {
            ASSERT_NEAR(series.value[i], then.at(i, series.channel), 1e-9) << i;
        }
    }
}

// 11 000 samples of 550 s at 20 Hz are 7.3 times 1 500, but blocks longer than 0.2 s are for runs of more than 600 s: 4
// samples. A run of 100 s at 20 Hz has 2 000, nearer to one times 1 500 than to two: it stays.
TEST(Thinning, ShortRunsKeepFiveHertz) {
    EXPECT_EQ(thinned(bench_on_laps(20.0, 550.0)).runs.front().samples, 4U);
    const input::Experiment brief = bench_on_laps(20.0, 100.0);
    const Thinned same = thinned(brief);
    EXPECT_EQ(same.runs.front().samples, 1U);
    EXPECT_TRUE(same.remarks.empty());
    EXPECT_EQ(same.experiment.runs.front().time, brief.runs.front().time);
}

// A camera in which 3 of 4 samples of a block are missing has no value there, with 2 it has one. A probe that is logged
// every 40 samples, 5 s, keeps its 144 values at their own times: blocks of 4 would hide when they were read.
TEST(Thinning, SlowSensorsAndGapsStayWhereTheyAre) {
    input::Experiment dense = twelve_minutes();
    input::MeasuredRun& run = dense.runs.front();
    std::vector<double>& camera = run.series[0].value;
    std::vector<double>& probe = run.series[1].value;
    camera[401] = camera[402] = camera[403] = camera[800] = camera[801] = std::nan("");
    for (std::size_t i = 0; i < probe.size(); ++i) {
        probe[i] = i % 40 == 7 ? probe[i] : std::nan("");
    }
    const Thinned few = thinned(dense);
    const input::MeasuredRun& after = few.experiment.runs.front();
    ASSERT_EQ(after.time.size(), 1440U + 144U);
    EXPECT_TRUE(std::ranges::is_sorted(after.time));
    const auto at = [&](double t, std::size_t series) {
        const auto found = std::ranges::lower_bound(after.time, t - 1e-9) - after.time.begin();
        return after.series[series].value[static_cast<std::size_t>(found)];
    };
    EXPECT_TRUE(std::isnan(at(401.5 * 0.125, 0)));
    EXPECT_FALSE(std::isnan(at(801.5 * 0.125, 0)));
    EXPECT_DOUBLE_EQ(at(47 * 0.125, 1), probe[47]);
    EXPECT_EQ(std::ranges::count_if(after.series[1].value, [](double v) { return !std::isnan(v); }), 144);
    ASSERT_FALSE(after.unused.empty());
    EXPECT_EQ(after.unused.front().value.size(), after.time.size());
}

// "8 Hz thinned to 2 Hz": the page says how far.
TEST(Thinning, IsSaid) {
    const Thinned few = thinned(twelve_minutes());
    ASSERT_EQ(few.remarks.size(), 1U);
    EXPECT_EQ(few.remarks.front(), remark::thinned(few.experiment.runs.front().name, 8.0, 2.0, 4));
}

// The inputs are those of the log, sample by sample: the solver averages their products itself.
TEST(Thinning, InputsStayAsLogged) {
    const input::Experiment dense = twelve_minutes();
    const Thinned few = thinned(dense);
    EXPECT_EQ(few.experiment.runs.front().problem.input_signals.samples(),
              dense.runs.front().problem.input_signals.samples());
    EXPECT_EQ(dense.runs.front().problem.input_signals.samples().size(), 5760U);
}

}  // namespace tiretherm::diagnosis
