// SPDX-License-Identifier: BSD-3-Clause
// Formulas over the time of a run: their points against integrals in closed form.

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "input/effects/user_signals.hpp"

namespace tiretherm::input {
namespace {

constexpr double hour = 3600.0;

FormulaSamples samples_of(const std::string& text, double end = hour) {
    Formula::Wrong wrong;
    const std::optional<Formula> formula = Formula::read(text, "follows", wrong);
    EXPECT_TRUE(formula.has_value()) << wrong.error.what;
    solver::Settings settings;
    settings.end = end;
    return formula ? signal_history_of(*formula, {}, {}, settings) : FormulaSamples{};
}

double integral(const solver::SignalHistory& history) {
    double sum = 0.0;
    for (std::size_t i = 1; i < history.time.size(); ++i) {
        EXPECT_GE(history.time[i], history.time[i - 1]);
        sum += 0.5 * (history.time[i] - history.time[i - 1]) * (history.value[i] + history.value[i - 1]);
    }
    return sum;
}

struct Expected {
    std::string formula;
    double integral;
    double accuracy;
};

// A comparison's edges are found to round-off, so rectangular pulses are exact. sin(w t) > c holds for acos(c)/pi of
// each period. What is curved is right to 1e-4 of the integral.
TEST(FormulaSampling, KeepsTheIntegralOfPulses) {
    const double turns = hour / std::numbers::pi;
    const std::vector<Expected> table{
        {"1000*(time>1000.3 && time<1300)", 299.7e3, 1e-9},
        {"1000*(time>1000 && time<1002)", 2000.0, 1e-9},
        {"1000*(time>1000.3 && time<1000.301)", 1.0, 1e-7},
        {"1000*(time>600 && time<1200)", 600e3, 1e-9},
        {"(time>=60 || time<30) ? 2 : 5", 2.0 * hour + 90.0, 1e-9},
        {"1000*(sin(2*_pi*time/60)>0.99)", 1000.0 * turns * std::acos(0.99), 1e-9},
        {"1000*(sin(2*_pi*time/90)>0.9)", 1000.0 * turns * std::acos(0.9), 1e-9},
        {"1000*(sin(2*_pi*time/90)>0.99999)", 1000.0 * turns * std::acos(0.99999), 1e-7},
        {"sin(2*_pi*time/3600)>0.99999999", turns * std::acos(0.99999999), 1e-6},
        {"1000*abs(sin(2*_pi*time))", 1000.0 * hour * 2.0 / std::numbers::pi, 1e-4},
        {"abs(time-1234.5)", 0.5 * (1234.5 * 1234.5 + 2365.5 * 2365.5), 1e-12},
        {"max(0, 1 - abs(time - 2000.25))", 1.0, 1e-9},
        {"min(time, 7.3)", 7.3 * 7.3 / 2.0 + 7.3 * (hour - 7.3), 1e-12},
        {"rint(time/1000)", 1000.0 + 2000.0 + 3.0 * 1000.0 + 400.0, 1e-9},
        {"exp(-time/10)", 10.0 * (1.0 - std::exp(-360.0)), 1e-4},
        {"time^2", hour * hour * hour / 3.0, 1e-4},
        {"0*time", 0.0, 0.0},
    };
    for (const Expected& row : table) {
        const FormulaSamples samples = samples_of(row.formula);
        EXPECT_FALSE(samples.too_fast) << row.formula;
        EXPECT_EQ(samples.undefined, 0.0) << row.formula;
        EXPECT_NEAR(integral(samples.history), row.integral, row.accuracy * row.integral) << row.formula;
    }
}

// Towards t = 0 numbers get finer without end; pieces of an hour do not. time^p is 3600^(p+1)/(p+1).
TEST(FormulaSampling, WhatIsSteepAtTheStartComesToAnEnd) {
    const std::vector<Expected> table{
        {"time ? 1 : 2", hour, 1e-6},
        {"time == 0 ? 2 : 1", hour, 1e-6},
        {"time^1e-6", std::pow(hour, 1.0 + 1e-6) / (1.0 + 1e-6), 1e-4},
        {"time^0.01", std::pow(hour, 1.01) / 1.01, 1e-4},
        {"1 + 0^time", hour, 1e-6},
        {"sqrt(time)", std::pow(hour, 1.5) / 1.5, 1e-4},
        {"exp(-1e6*time) + 1", hour, 1e-4},
    };
    for (const Expected& row : table) {
        const FormulaSamples samples = samples_of(row.formula);
        EXPECT_FALSE(samples.too_fast) << row.formula;
        EXPECT_NEAR(integral(samples.history), row.integral, row.accuracy * row.integral) << row.formula;
    }
    // Nothing but its first point, infinitely many turns, and no number at the start: an answer or "too fast", but an end.
    for (const std::string formula : {"0^time", "sin(1/time)", "sin(1/time) ? 1 : 0", "sin(1/time) > 0", "ln(time)",
                                      "1/time", "time^-0.5", "rint(1/time)", "sin(time) ? 1 : 0", "abs(sin(1/time))",
                                      "sin(1/(time-1800)) > 0", "(time-1800) ? 1 : 2", "0^abs(time-1800)"}) {
        static_cast<void>(samples_of(formula));
    }
}

// rint(time/1000): 0 up to 500 s, then 1, 2 and 3 for 1000 s each up to 3500 s, 4 for the last 100 s: the sum above.

// Trains of pulses of all lengths and pauses: on time = pulses * width.
TEST(FormulaSampling, FindsEveryPulseOfATrain) {
    std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same trains each time
    for (int i = 0; i < 40; ++i) {
        const double period = std::exp(std::uniform_real_distribution(std::log(4.0), std::log(900.0))(random));
        const double share = std::exp(std::uniform_real_distribution(std::log(1e-3), std::log(0.9))(random));
        const int pulses = static_cast<int>(hour / period);
        const std::string text =
            fmt::format("1000*(sin(2*_pi*time/{0:.17g}) > {1:.17g})", period, std::cos(std::numbers::pi * share));
        const FormulaSamples samples = samples_of(text, pulses * period);
        EXPECT_FALSE(samples.too_fast) << text;
        const double on = 1000.0 * pulses * period * share;
        EXPECT_NEAR(integral(samples.history), on, 1e-6 * on) << text;
    }
}

// What turns faster than the points are is refused, and never taken as what its samples happen to show.
TEST(FormulaSampling, RefusesWhatIsTooFast) {
    for (const char* text : {"1000*(sin(2*_pi*time*1000)>0)", "1/(time-1000.1)"}) {
        EXPECT_TRUE(samples_of(text).too_fast) << text;
    }
}

// sqrt(time - 1800) is no number for the first half, ln(time) at 0 alone.
TEST(FormulaSampling, CountsWhatIsNoNumber) {
    const FormulaSamples half = samples_of("100*sqrt(time-1800)");
    EXPECT_NEAR(half.undefined, 1800.0, 1e-6);
    EXPECT_NEAR(half.longest_gap, 1800.0, 1e-6);
    EXPECT_EQ(half.gap_from, 0.0);
    // 100 * 2/3 * 1800^1.5, the part where it is a number
    EXPECT_NEAR(integral(half.history), 100.0 * 2.0 / 3.0 * std::pow(1800.0, 1.5), 1e-4 * 5.1e6);
    const FormulaSamples gap = samples_of("time>100 && time<130.5 ? sqrt(0-1) : 3");
    EXPECT_NEAR(gap.undefined, 30.5, 1e-6);
    EXPECT_NEAR(gap.gap_from, 100.0, 1e-6);
    EXPECT_NEAR(integral(gap.history), 3.0 * hour, 1e-6);  // bridged
    EXPECT_TRUE(samples_of("exp(exp(exp(exp(time+9))))").history.time.empty());
    EXPECT_GT(samples_of("exp(time)").undefined, 2000.0);  // exp(709.8) is the largest
    solver::Settings settings;
    settings.end = hour;
    EXPECT_TRUE(formula_error(half, settings).has_value());
    EXPECT_FALSE(formula_error(gap, settings).has_value());
}

}  // namespace
}  // namespace tiretherm::input
