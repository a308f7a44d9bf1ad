#include "diagnosis/scores.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace tiretherm::diagnosis {

namespace {

/// One in two hundred is exceeded by a hundred of these: the threshold is known to 0.02.
constexpr int draws = 20'000;

}  // namespace

Remainder::Remainder(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& precision) : n_rows_(slopes.rows()) {
    const Eigen::Index n = slopes.cols();
    Eigen::MatrixXd rows(n_rows_ + n, n);
    rows << slopes, Eigen::MatrixXd(precision.cwiseSqrt().asDiagonal());
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows);
    const Eigen::Index rank = qr.rank();  // numbers that nothing sees take nothing out
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(rows.rows(), rank);
}

Eigen::MatrixXd Remainder::take_out(Eigen::MatrixXd columns) const {
    const Eigen::MatrixXd along = basis_.transpose() * columns;
    columns.noalias() -= basis_ * along;
    return columns;
}

Eigen::MatrixXd Remainder::of(const Eigen::MatrixXd& columns) const {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(basis_.rows(), columns.cols());
    rows.topRows(n_rows_) = columns;
    return take_out(std::move(rows));
}

Eigen::VectorXd Remainder::of(const Eigen::VectorXd& residual, const Eigen::VectorXd& known) const {
    Eigen::MatrixXd rows(basis_.rows(), 1);
    rows << residual, known;
    return take_out(std::move(rows)).col(0);
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
    if (correlation.size() == 0) {  // no cause can act: no score can be loud
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
    Eigen::MatrixXd normal(n, block);
    std::vector<double> largest_z;
    largest_z.reserve(draws);
    for (int drawn = 0; drawn < draws; drawn += block) {
        for (Eigen::Index i = 0; i + 1 < normal.size(); i += 2) {  // Box and Muller: alike on every library
            const double radius = std::sqrt(-2.0 * std::log(uniform()));
            const double angle = 2.0 * std::numbers::pi * uniform();
            normal.data()[i] = radius * std::cos(angle);
            normal.data()[i + 1] = radius * std::sin(angle);
        }
        const Eigen::MatrixXd z = root * normal;
        for (int column = 0; column < block; ++column) {
            double most = 0.0;
            for (Eigen::Index k = 0; k < z.rows(); ++k) {
                most = std::max(most, admitted(z(k, column), sign[k]));
            }
            largest_z.push_back(most);
        }
    }
    const auto at = largest_z.begin() + static_cast<std::ptrdiff_t>((1.0 - probability) * draws);
    std::nth_element(largest_z.begin(), at, largest_z.end());
    return *at;
}

}  // namespace tiretherm::diagnosis
