// SPDX-License-Identifier: BSD-3-Clause
// Intervals by profile likelihood: to either side the value at which chi-square, minimised over all other numbers, has
// risen by 3.84.
#include <Eigen/Cholesky>

#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Chi-square of single numbers and of what was known before, by nothing but simulations.
class ChiSquare {
public:
    explicit ChiSquare(const input::Experiment& experiment)
        : experiment_(experiment), observations_(observe(experiment)), simulator_(experiment, observations_) {}

    Eigen::VectorXd residuals(const Eigen::VectorXd& values) {
        const ModelPrediction& predicted = simulator_.at(values);
        EXPECT_TRUE(predicted.status.ok()) << predicted.status.message;
        const Eigen::Index n_rows = observations_.measured.size();
        Eigen::VectorXd all(n_rows + values.size());
        for (const NoiseBlock& block : observations_.blocks) {
            for (Eigen::Index i = 0; i < block.rows(); ++i) {
                const Eigen::Index row = block.first + i;
                all[row] = (predicted.simulated[row] - observations_.measured[row]) /
                           block.standard_deviation.at(static_cast<std::size_t>(i));
            }
        }
        for (Eigen::Index j = 0; j < values.size(); ++j) {
            const solver::FreeParameter& parameter = experiment_.parameters[static_cast<std::size_t>(j)];
            all[n_rows + j] = (values[j] - parameter.prior) / parameter.standard_deviation;  // 0 without a prior
        }
        return all;
    }

    /// The least chi-square with one number held: Gauss and Newton with central differences, the step halved until it
    /// helps.
    double least(Eigen::VectorXd values, Eigen::Index held) {
        double best = residuals(values).squaredNorm();
        for (int turn = 0; turn < 30; ++turn) {
            const Eigen::VectorXd now = residuals(values);
            Eigen::MatrixXd slope(now.size(), values.size());
            for (Eigen::Index j = 0; j < values.size(); ++j) {
                Eigen::VectorXd other = values;
                const double step = 1e-3 * std::abs(values[j]) + 1e-6;
                other[j] = values[j] + step;
                const Eigen::VectorXd above = residuals(other);
                other[j] = values[j] - step;
                slope.col(j) = (above - residuals(other)) / (2.0 * step) * std::abs(values[j]);
            }
            slope.col(held).setZero();
            Eigen::MatrixXd information = slope.transpose() * slope;
            information(held, held) = 1.0;
            const Eigen::VectorXd whole =
                -information.ldlt().solve(slope.transpose() * now).cwiseProduct(values.cwiseAbs());
            double share = 1.0;
            double found = residuals(values + whole).squaredNorm();
            for (; found > best && share > 1e-3; found = residuals(values + share * whole).squaredNorm()) {
                share *= 0.5;
            }
            if (best - found < 1e-6) {
                break;
            }
            values += share * whole;
            best = found;
        }
        return best;
    }

private:
    const input::Experiment& experiment_;
    Observations observations_;
    Simulator simulator_;
};

}  // namespace

// Over intervals of half a percent the bench is a straight line in its scales.
TEST(IdentificationProfile, EqualsTheSymmetricIntervalWhereTheModelIsNearlyLinear) {
    input::Experiment experiment = sample::practice_bench();
    experiment.parameters.resize(2);  // film and loss; where the runs start is taken as known
    const Identification profile = sample::fit(experiment, {.profile = true});
    for (std::size_t j = 0; j < 2; ++j) {
        const double half = 1.96 * profile.fitted[j].standard_deviation;
        EXPECT_TRUE(profile.fitted[j].profiled);
        EXPECT_NEAR(profile.fitted[j].high - profile.fitted[j].value, half, 0.05 * half);
        EXPECT_NEAR(profile.fitted[j].value - profile.fitted[j].low, half, 0.05 * half);
    }
}

// k of the link stands below the line of a fraction: the more it conducts, the less a little more of it matters, and the
// interval reaches further up than down. A search of its own finds chi-square 3.84 above its least at both ends; they
// were looked for to a hundredth of a standard deviation, where chi-square rises by 2 * 1.96 * 0.01 = 0.04.
TEST(IdentificationProfile, ChiSquareHasRisenBy384AtBothEnds) {
    const input::Experiment experiment =
        sample::read_bench(input::source_folder() / "cases/two_node/identify_saturation.toml");
    const Identification wald = sample::fit(experiment);
    const Identification profile = sample::fit(experiment, {.profile = true});
    const std::size_t link = sample::index_of(experiment, "link.conductivity at 70 degC");
    const Fitted& one = profile.fitted[link];
    ASSERT_FALSE(one.low_is_open);
    ASSERT_FALSE(one.high_is_open);
    EXPECT_GT(one.high - one.value, 1.2 * (one.value - one.low));
    EXPECT_GT(one.high, wald.fitted[link].high);
    ChiSquare chi_square(experiment);
    const auto held = static_cast<Eigen::Index>(link);
    const double least = chi_square.residuals(profile.values).squaredNorm();
    for (const double end : {one.low, one.high}) {
        Eigen::VectorXd values = profile.values;
        values[held] = end;
        EXPECT_NEAR(chi_square.least(values, held) - least, 3.841, 0.1) << end;
    }
}

}  // namespace tiretherm::diagnosis
