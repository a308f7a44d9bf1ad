// SPDX-License-Identifier: BSD-3-Clause
// Additions judged on experiments left out, by hand: numbers without any simulation.
#include <gtest/gtest.h>

#include "diagnosis/quoted/held_out.hpp"

namespace tiretherm::diagnosis::quoted {
namespace {

/// A row in an experiment of its own, measured 0 +- 1 K.
QuotedResult row(double value, std::size_t experiment) {
    return {.number = experiment,
            .id = "",
            .what = "",
            .unit = "K",
            .low = 0.0,
            .high = 0.0,
            .uncertainty = 1.0,
            .spread = 0.0,
            .value = value,
            .is_open = false,
            .decidable = true,
            .experiment = experiment};
}

Numbers numbers_of(const std::vector<double>& values) {
    Numbers numbers;
    for (std::size_t i = 0; i < values.size(); ++i) {
        numbers.rows.push_back(row(values[i], i));
        numbers.experiments.push_back("");
    }
    return numbers;
}

/// Shifts every row by its number, of -6 to 6.
Addition shift(std::size_t rows) {
    Addition addition;
    addition.id = "shift";
    addition.low = -6.0;
    addition.high = 6.0;
    addition.nodes = {-6.0, 0.0, 6.0};
    for (const double node : addition.nodes) {
        addition.changes.emplace_back(rows, node);
    }
    return addition;
}

}  // namespace

// All four rows are 3 K too large. Without one of them, t minimises 3 (3 + t)^2 + 4 t^2/36: t (3 + 1/9) = -9, t = -2.893.
// It leaves 0.107 K of 3, so 96.4 % are removed, in every draw of experiments alike. Values are looked up in steps of 0.1: 3 %.
TEST(HeldOut, WhatIsCommonToAllExperimentsIsRemoved) {
    const Numbers numbers = numbers_of({3.0, 3.0, 3.0, 3.0});
    const std::vector<Addition> additions{shift(4)};
    const Judge judge(numbers, std::vector<bool>(4, true), additions);
    const HeldOut found = judge.held_out({0});
    EXPECT_NEAR(found.rms_before, 3.0, 1e-12);
    EXPECT_NEAR(found.removed.value, 0.964, 0.034);
    EXPECT_NEAR(found.removed.low, found.removed.value, 1e-9);
    EXPECT_EQ(found.better.size(), 4U);
    EXPECT_NEAR(judge.held_out_choice([](std::size_t) { return AdditionSet{0}; }).removed.value, found.removed.value,
                1e-9);
}

// Only one experiment is off: without it nothing asks for a shift, and it keeps its 4 K. With it, the others are made worse.
TEST(HeldOut, OneExperimentAloneProvesNothing) {
    const Numbers numbers = numbers_of({4.0, 0.0, 0.0, 0.0});
    const std::vector<Addition> additions{shift(4)};
    const Judge judge(numbers, std::vector<bool>(4, true), additions);
    const HeldOut found = judge.held_out({0});
    EXPECT_LE(found.removed.value, 0.0);
    EXPECT_LE(found.removed.low, 0.0);
    EXPECT_EQ(judge.off(std::vector<double>(4, 0.0)), std::vector<std::size_t>{0});
}

// Two rows of one experiment that share an unknown input, +-3 K in both: their difference is known to 1.4 K, their mean is not.
// Even over -3 to 3 K in 21 steps the mean square is 9 * (21 + 1)/(3 * (21 - 1)) = 3.3 K2.
TEST(HeldOut, RowsThatShareAnInputAreCorrelated) {
    Numbers numbers = numbers_of({0.0, 0.0});
    numbers.rows[1].experiment = 0;
    UnknownInput input{.name = "air", .unit = "K", .at = {}, .changes = {}};
    for (int i = 0; i < 21; ++i) {
        const double change = -3.0 + 0.3 * i;
        input.at.push_back(change);
        input.changes.push_back({change, change});
    }
    numbers.inputs.push_back(input);
    const Eigen::MatrixXd covariance = numbers.covariance({0, 1}, {});
    EXPECT_NEAR(covariance(0, 1), 3.3, 1e-9);
    EXPECT_NEAR(covariance(0, 0), 4.3, 1e-9);
    EXPECT_NEAR(numbers.covariance({0, 1}, {0})(0, 1), 0.0, 1e-12);
}

// Parabolas pass through uneven nodes exactly: t^2 - t at all values.
TEST(Addition, ChangesBetweenNodesAreExactForAParabola) {
    Addition addition;
    addition.low = -1.0;
    addition.high = 3.0;
    addition.nodes = {-1.0, 0.0, 1.2, 3.0};
    for (const double t : addition.nodes) {
        addition.changes.push_back({t * t - t});
    }
    const std::vector<std::vector<double>> table = addition.table();
    ASSERT_EQ(table.size(), Addition::n_values);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double t = addition.value(i);
        EXPECT_NEAR(table[i][0], t * t - t, 1e-12);
    }
}

}  // namespace tiretherm::diagnosis::quoted
