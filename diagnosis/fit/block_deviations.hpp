// SPDX-License-Identifier: BSD-3-Clause
// Standard deviations of fitted numbers that hold where the model has errors of its own: from the scatter between blocks
// of time instead of from the noise alone.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/fit/refit.hpp"
#include "diagnosis/observations/observations.hpp"

namespace tiretherm::diagnosis {

/// Standard deviations with the factor of a 95 % interval.
struct BlockDeviations {
    Eigen::VectorXd deviation;  ///< [n] in the unit of each number, at least those of the noise; 0 at a bound
    double wide = 1.959964;     ///< Student's t of as many blocks
    int blocks = 0;
};

/// The covariance A^-1 (sum over blocks of g g') A^-1 with A = S'S + Pi and g = S'r of one block (White, Econometrica 48
/// (1980) 817; of blocks: Liang and Zeger, Biometrika 73 (1986) 13), times n / (n - 1). What the model gets wrong differs
/// from block to block and shows in it, which it does not in A^-1.
/// @param seconds length of a block; a recording is divided into whole blocks, each of which has all tires of a car
[[nodiscard]] BlockDeviations block_deviations(const Refit& fit, const Observations& observations, double seconds);

/// Length of a block: slow errors are forgotten within it, but there are so many of them at least, and 60 at most.
/// @returns s
[[nodiscard]] double length_of_blocks(const Observations& observations, const std::vector<Noise>& noise,
                                      int fewest = 8);

/// The block of time that each row is in, counted over all recordings: each is divided into whole blocks of about this length.
/// @param seconds > 0, also infinite  @param fewest blocks of a recording  @returns [n_rows]
[[nodiscard]] std::vector<std::size_t> blocks_of_rows(const Observations& observations, double seconds,
                                                      long fewest = 1);

/// Half of a 95 % interval of every number from how far it moves when a fold is left out: the jackknife (Quenouille, Biometrika
/// 43 (1956) 353; Tukey 1958), with Student's t of as many folds.
/// @param values [n_folds][n]  @returns [n]; empty with fewer than two folds
[[nodiscard]] Eigen::VectorXd jackknife_half_widths(const std::vector<Eigen::VectorXd>& values);

/// Student's t of a two-sided 95 % interval. @param freedom >= 1
[[nodiscard]] double student(int freedom);

}  // namespace tiretherm::diagnosis
