// SPDX-License-Identifier: BSD-3-Clause
// The oracle of the exam: at how many standard deviations a difference shows to somebody who knows the noise, after the
// free parameters are projected out.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "exam/exam_rig_truth.hpp"

namespace hidden_effects {

/// Three runs of one bench before anything is hidden in it.
struct BenchRuns {
    const Rig* rig = nullptr;
    std::vector<double> of_bench{};             ///< what its user does not know, as the rig lists it
    std::vector<std::vector<double>> of_run{};  ///< [n_runs], K
    std::vector<RigProgramme> programmes{};     ///< what drives them; its throttle is what an unknown source follows
};

/// What the sensors give without noise, [run][channel][sample].
using Readings = std::vector<RigTrace>;
/// @param tolerance K, local error of a step
[[nodiscard]] RigTrace readings_of_run(const BenchRuns& runs, std::size_t run, const std::vector<Cause>& hidden,
                                       double tolerance);
[[nodiscard]] Readings readings_of(const BenchRuns& runs, const std::vector<Cause>& hidden, double tolerance);

/// A sensor's values in units of what its noise lets nobody foresee: the innovations of a Kalman filter of one state
/// (AR(1) + white), over their standard deviations. White noise of variance 1 if the values are that noise.
/// @param times s, ascending  @param values in the unit of the noise's standard deviation
[[nodiscard]] Eigen::VectorXd whitened(const Noise& noise, const std::vector<double>& times,
                                       const std::vector<double>& values);

/// What somebody would see who knows the noise, the numbers of the bench and what to look for: a difference of readings
/// in standard deviations, after all that the user's free numbers can imitate has been taken off it.
///
/// With whitened readings y, columns S of the free numbers (those of the bench, then those of each run, by central
/// differences) and their prior precision P, a difference d leaves the vector
///     [ d - S c ; -P^(1/2) c ],   c = (S'S + P)^-1 S'd
/// whose length is the number of standard deviations at which d shows, lambda^2 = d'd - d'S (S'S + P)^-1 S'd. The
/// cosine between two such vectors is the correlation of the two causes.
class Oracle {
public:
    explicit Oracle(BenchRuns runs);

    [[nodiscard]] const BenchRuns& runs() const { return runs_; }
    /// What causes leave behind, [n_readings + n_numbers].
    [[nodiscard]] Eigen::VectorXd left_by(const std::vector<Cause>& causes) const;
    /// The same where what is not logged differs: what stands in the throttle's place.
    [[nodiscard]] Eigen::VectorXd left_by(const std::vector<Cause>& causes, const BenchRuns& driven) const;
    /// What any readings, less those of the bench with nothing hidden, leave behind.
    [[nodiscard]] Eigen::VectorXd left_of(const Readings& readings) const;
    /// The readings with nothing hidden.
    [[nodiscard]] const Readings& plain() const { return plain_; }
    [[nodiscard]] Eigen::VectorXd left_of_whitened(const Eigen::VectorXd& difference) const;
    [[nodiscard]] Eigen::VectorXd whitened_difference(const Readings& readings) const;
    /// Whitened columns of the free numbers, [n_readings][n_numbers], and the prior standard deviation of each.
    [[nodiscard]] const Eigen::MatrixXd& columns() const { return columns_; }
    [[nodiscard]] const Eigen::VectorXd& prior() const { return prior_; }

private:
    BenchRuns runs_;
    Readings plain_;
    Eigen::MatrixXd columns_;
    Eigen::VectorXd prior_;
    Eigen::MatrixXd inverse_;  ///< (S'S + P)^-1
};

[[nodiscard]] double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// A number at which a cause shows as wanted, and what it leaves behind.
struct Size {
    double number = 0.0;
    Eigen::VectorXd left{};
};

/// The number at which a cause shows at so many standard deviations, by the secant method.
/// @param sign of the step from absent to it, counted in the direction of Variant::typical
/// @param driven what stands in the throttle's place, as Oracle::left_by takes it; null: what is logged
/// @returns nothing where that number is beyond what is physical, or nothing shows
[[nodiscard]] std::optional<Size> size_for(const Oracle& oracle, const Variant& variant, double sign, double sigma,
                                           double critical_speed, const BenchRuns* driven = nullptr);

}  // namespace hidden_effects
