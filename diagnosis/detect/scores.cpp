// SPDX-License-Identifier: BSD-3-Clause
// Projection by a QR factorisation, scores of single signatures and of pairs, and simulated family-wise thresholds for
// correlated normal scores.

#include "diagnosis/detect/scores.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "mesh/parallel.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::diagnosis {

namespace {

/// One in two hundred is exceeded by a hundred of these: the threshold is known to 0.02.
constexpr int draws = 20'000;

/// What a statistic of correlated normal z exceeds with a given probability.
template <typename Statistic>
double exceeded_by_chance(const Eigen::MatrixXd& correlation, double probability, const Statistic& statistic) {
    if (correlation.size() == 0) {  // no cause can act: no score can be significant
        return 0.0;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(correlation);
    // Directions that carry nothing are left out: many signatures of one family are few normals.
    const double largest = parts.eigenvalues()[parts.eigenvalues().size() - 1];
    const Eigen::Index first = (parts.eigenvalues().array() < 1e-6 * largest).cast<Eigen::Index>().sum();
    const Eigen::Index n = parts.eigenvalues().size() - first;
    const Eigen::MatrixXd root =
        parts.eigenvectors().rightCols(n) * parts.eigenvalues().tail(n).cwiseSqrt().asDiagonal();
    std::mt19937_64 engine(20'14);
    const auto uniform = [&] { return (static_cast<double>(engine() >> 11U) + 0.5) * 0x1p-53; };
    constexpr int block = 500;
    constexpr int at_a_time = 8 * block;  // more are not kept
    static_assert(draws % at_a_time == 0);
    Eigen::MatrixXd normal(n, at_a_time);
    std::vector<double> drawn(draws);
    for (int begin = 0; begin < draws; begin += at_a_time) {
        for (Eigen::Index i = 0; i + 1 < normal.size(); i += 2) {  // Box and Muller: alike on every library
            const double radius = std::sqrt(-2.0 * std::log(uniform()));
            const double angle = 2.0 * std::numbers::pi * uniform();
            normal.data()[i] = radius * std::cos(angle);
            normal.data()[i + 1] = radius * std::sin(angle);
        }
        in_parallel(at_a_time / block, [&](std::size_t i) {
            const auto first_of_block = static_cast<Eigen::Index>(i) * block;
            const Eigen::MatrixXd z = root * normal.middleCols(first_of_block, block);
            for (Eigen::Index column = 0; column < block; ++column) {
                drawn[static_cast<std::size_t>(begin + first_of_block + column)] = statistic(z.col(column));
            }
        });
    }
    return solver::nth_smallest(std::move(drawn), static_cast<std::size_t>((1.0 - probability) * draws));
}

/// Two signatures of which each alone has z and whose correlation is c, fitted together.
PairScore together(double za, double zb, double c, int sign_a, int sign_b) {
    const double left = 1.0 - c * c;
    const double a = (za - c * zb) / left;
    const double b = (zb - c * za) / left;
    const bool possible = admitted(a, sign_a) > 0.0 && admitted(b, sign_b) > 0.0;
    return {.first = a, .second = b, .gain = possible ? 0.5 * (a * za + b * zb) : 0.0};
}

}  // namespace

NuisanceProjector::NuisanceProjector(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& precision)
    : n_rows_(slopes.rows()) {
    const Eigen::Index n = slopes.cols();
    Eigen::MatrixXd rows(n_rows_ + n, n);
    rows << slopes, Eigen::MatrixXd(precision.cwiseSqrt().asDiagonal());
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows);
    const Eigen::Index rank = qr.rank();  // numbers that nothing sees take nothing out
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(rows.rows(), rank);
}

Eigen::MatrixXd NuisanceProjector::remove_nuisance(Eigen::MatrixXd columns) const {
    const Eigen::MatrixXd along = basis_.transpose() * columns;
    columns.noalias() -= basis_ * along;
    return columns;
}

Eigen::MatrixXd NuisanceProjector::project(const Eigen::MatrixXd& columns) const {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(basis_.rows(), columns.cols());
    rows.topRows(n_rows_) = columns;
    return remove_nuisance(std::move(rows));
}

Eigen::VectorXd NuisanceProjector::project(const Eigen::VectorXd& residual, const Eigen::VectorXd& known) const {
    Eigen::MatrixXd rows(basis_.rows(), 1);
    rows << residual, known;
    return remove_nuisance(std::move(rows)).col(0);
}

Scores score(const Eigen::MatrixXd& signatures, const Eigen::VectorXd& residual, const Eigen::VectorXd& before) {
    Scores scores;
    const Eigen::MatrixXd products = signatures.transpose() * signatures;
    scores.length = products.diagonal().cwiseSqrt();
    for (Eigen::Index k = 0; k < scores.length.size(); ++k) {
        if (!(scores.length[k] > least_share * before[k])) {
            scores.length[k] = 0.0;
        }
    }
    const Eigen::VectorXd inverse = scores.length.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
    scores.z = inverse.cwiseProduct(signatures.transpose() * residual);
    scores.correlation = inverse.asDiagonal() * products * inverse.asDiagonal();
    return scores;
}

double admitted(double z, int sign) { return sign == 0 ? std::abs(z) : std::max(0.0, sign * z); }

double family_threshold(const Eigen::MatrixXd& correlation, const Eigen::VectorXi& sign, double probability) {
    return exceeded_by_chance(correlation, probability, [&](const auto& z) {
        double most = 0.0;
        for (Eigen::Index k = 0; k < z.size(); ++k) {
            most = std::max(most, admitted(z[k], sign[k]));
        }
        return most;
    });
}

PairScore score_of_pair(const Scores& scores, const Eigen::VectorXi& sign, const Pair& pair) {
    const auto [a, b] = pair;
    return together(scores.z[a], scores.z[b], scores.correlation(a, b), sign[a], sign[b]);
}

double pair_threshold(const Eigen::MatrixXd& correlation, const Eigen::VectorXi& sign, const std::vector<Pair>& pairs,
                      double probability) {
    return exceeded_by_chance(correlation, probability, [&](const auto& z) {
        double most = 0.0;
        for (const auto& [a, b] : pairs) {
            most = std::max(most, together(z[a], z[b], correlation(a, b), sign[a], sign[b]).gain);
        }
        return most;
    });
}

}  // namespace tiretherm::diagnosis
