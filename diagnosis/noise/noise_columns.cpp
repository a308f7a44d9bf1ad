// SPDX-License-Identifier: BSD-3-Clause
// Finds the columns of the span that are linearly independent, by Gram-Schmidt orthogonalisation with scaled rows.

#include <cmath>
#include <vector>

#include "diagnosis/noise/noise_likelihood.hpp"

namespace tiretherm::diagnosis {

std::vector<Eigen::Index> independent_columns(const NoiseProblem& problem) {
    // Whether columns depend does not depend on the rows' scales; these only keep round-off of the size of noise.
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(problem.residual.size());
    std::vector<double> squares(problem.data_sheet.size(), 0.0);
    std::vector<double> rows(problem.data_sheet.size(), 0.0);
    for (const NoiseBlock& block : problem.blocks) {
        if (block.channel >= 0) {
            squares[static_cast<std::size_t>(block.channel)] +=
                problem.residual.segment(block.first, block.rows()).squaredNorm();
            rows[static_cast<std::size_t>(block.channel)] += static_cast<double>(block.rows());
        }
    }
    for (const NoiseBlock& block : problem.blocks) {
        for (Eigen::Index i = 0; i < block.rows(); ++i) {
            const double size = block.channel < 0 ? block.standard_deviation[static_cast<std::size_t>(i)]
                                                  : std::sqrt(squares[static_cast<std::size_t>(block.channel)] /
                                                              rows[static_cast<std::size_t>(block.channel)]);
            scale[block.first + i] = size > 0.0 ? 1.0 / size : 1.0;
        }
    }
    constexpr double negligible = 1e-6;
    std::vector<Eigen::Index> kept;
    std::vector<Eigen::VectorXd> directions;
    for (Eigen::Index j = 0; j < problem.span.cols(); ++j) {
        Eigen::VectorXd column = scale.cwiseProduct(problem.span.col(j));
        const double length = column.norm();
        if (problem.precision[j] > negligible * negligible * length * length) {
            kept.push_back(j);
            continue;
        }
        for (int twice = 0; twice < 2; ++twice) {
            for (const Eigen::VectorXd& direction : directions) {
                column -= direction.dot(column) * direction;
            }
        }
        if (column.norm() > negligible * length) {
            kept.push_back(j);
            directions.push_back(column.normalized());
        }
    }
    return kept;
}

}  // namespace tiretherm::diagnosis
