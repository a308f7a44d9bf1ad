// SPDX-License-Identifier: BSD-3-Clause
// Rao's score test (Proc. Cambridge Phil. Soc. 44 (1948) 50) of signatures beside nuisance parameters, which are
// projected out (Frisch and Waugh, Econometrica 1 (1933) 387).
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace tiretherm::diagnosis {

/// Removes from signatures and residuals what the free numbers of a model (nuisance parameters) can explain: the
/// projection that leaves the part orthogonal to them (Frisch and Waugh, Econometrica 1 (1933) 387). What was known of
/// the numbers before counts as further rows of the data.
class NuisanceProjector {
public:
    /// @param slopes [n_rows][n] whitened, in units of the numbers' scales
    /// @param precision [n] of what was known of each number, in the same units; 0: nothing
    NuisanceProjector(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& precision);

    /// @param columns [n_rows][m] whitened  @returns [n_rows + n][m]
    [[nodiscard]] Eigen::MatrixXd project(const Eigen::MatrixXd& columns) const;
    /// @param residual [n_rows] whitened, measured - simulated
    /// @param known [n] what was known of each number less its value, in standard deviations  @returns [n_rows + n]
    [[nodiscard]] Eigen::VectorXd project(const Eigen::VectorXd& residual, const Eigen::VectorXd& known) const;

    /// What of columns the free numbers explain, in an orthonormal basis: the products of two projected columns are less than
    /// those of the columns themselves by the products of these. @param columns [n_rows][m] whitened  @returns [n][m]
    [[nodiscard]] Eigen::MatrixXd explained(const Eigen::MatrixXd& columns) const {
        return basis_.topRows(n_rows_).transpose() * columns;
    }

private:
    Eigen::MatrixXd remove_nuisance(Eigen::MatrixXd columns) const;
    Eigen::MatrixXd basis_;  ///< [n_rows + n][n] orthonormal
    Eigen::Index n_rows_;
};

/// Of a signature that the free numbers leave less than this share of, round-off and nonlinearity are what is seen.
inline constexpr double least_share = 1e-3;

/// How significant each of some signatures is in the data (score test: Rao, Proc. Cambridge Phil. Soc. 44 (1948) 50).
struct Scores {
    Eigen::VectorXd z;       ///< [m] standard deviations; normal with variance 1 where a signature is absent
    Eigen::VectorXd length;  ///< [m] standard deviations per unit of the signature; 0: not to be seen in these data
    Eigen::MatrixXd correlation;  ///< [m][m] of the z, and of the signatures

    /// The amplitude that each signature alone would have, in its unit.
    [[nodiscard]] double amplitude(Eigen::Index k) const { return length[k] > 0.0 ? z[k] / length[k] : 0.0; }
};

/// @param before [m] lengths of the whitened signatures before anything was taken out of them: what keeps less than a
///     thousandth of it cannot be seen
[[nodiscard]] Scores score(const Eigen::MatrixXd& signatures, const Eigen::VectorXd& residual,
                           const Eigen::VectorXd& before);

/// The z that a signature may have: one with a sign (+1, -1; 0: either) counts only with it.
[[nodiscard]] double admitted(double z, int sign);

/// The largest of correlated normal z that chance exceeds with a given probability, by simulation.
/// @param correlation [m][m]  @param sign [m] as of `admitted`
[[nodiscard]] double family_threshold(const Eigen::MatrixXd& correlation, const Eigen::VectorXi& sign,
                                      double probability);

using Pair = std::pair<Eigen::Index, Eigen::Index>;

/// Two signatures fitted together in the linearised model.
struct PairScore {
    double first = 0.0;   ///< amplitude of the first over that which one standard deviation of it alone would have
    double second = 0.0;  ///< the same of the second
    double gain = 0.0;    ///< log likelihood ratio; 0 where one is on the side that its sign forbids
};
[[nodiscard]] PairScore score_of_pair(const Scores& scores, const Eigen::VectorXi& sign, const Pair& pair);

/// The largest gain of any of some pairs that chance exceeds with a given probability, by simulation.
[[nodiscard]] double pair_threshold(const Eigen::MatrixXd& correlation, const Eigen::VectorXi& sign,
                                    const std::vector<Pair>& pairs, double probability);

}  // namespace tiretherm::diagnosis
