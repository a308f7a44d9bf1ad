#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "exam_causes_truth.hpp"
#include "random_truth.hpp"
#include "two_node_truth.hpp"

namespace hidden_effects {

/// Three runs of one bench before anything is hidden in it.
struct BenchRuns {
    double lambda_h = 1.0;
    double lambda_sel = 1.0;
    std::vector<double> surface_start;  ///< [n_runs] K
    std::vector<double> bulk_start;
    std::vector<Programme> programmes;  ///< what drives them; its throttle is what an unknown source follows
};

/// What the sensors give without noise, surface and then bulk of each run. K
using Readings = std::vector<BenchTrace>;
/// @param tolerance K, local error of a step
[[nodiscard]] Readings readings_of(const BenchRuns& runs, const std::vector<Cause>& hidden, double tolerance = 1e-6);

/// A sensor's values in units of what its noise lets nobody foresee: the innovations of a Kalman filter of one state
/// (AR(1) + white), over their standard deviations. White noise of variance 1 if the values are that noise.
/// @param times s, ascending  @param values in the unit of the noise's standard deviation
[[nodiscard]] Eigen::VectorXd whitened(const Noise& noise, const std::vector<double>& times,
                                       const std::vector<double>& values);

/// Noise of the camera and of the probe.
inline constexpr Noise camera_noise{.standard_deviation = 0.5};
inline constexpr Noise probe_noise{.standard_deviation = 0.3};

/// What somebody would see who knows the noise, the numbers of the bench and what to look for: a difference of readings
/// in standard deviations, after all that the user's free numbers can imitate has been taken off it.
///
/// With whitened readings y, columns S of the free numbers (scales of film and loss, prior 0.1; six temperatures at the
/// start, prior 3 K; by central differences) and their prior precision P, a difference d leaves the vector
///     [ d - S c ; -P^(1/2) c ],   c = (S'S + P)^-1 S'd
/// whose length is the number of standard deviations at which d shows, lambda^2 = d'd - d'S (S'S + P)^-1 S'd. The
/// cosine between two such vectors is the correlation of the two causes.
class Oracle {
public:
    explicit Oracle(BenchRuns runs);

    [[nodiscard]] const BenchRuns& runs() const { return runs_; }
    /// What causes leave behind, [n_readings + 8].
    [[nodiscard]] Eigen::VectorXd left_by(const std::vector<Cause>& causes) const;
    /// What any readings, less those of the bench with nothing hidden, leave behind.
    [[nodiscard]] Eigen::VectorXd left_of(const Readings& readings) const;
    /// The readings with nothing hidden; with other values of the free numbers, to first order. @param off [8]
    [[nodiscard]] const Readings& plain() const { return plain_; }
    [[nodiscard]] Eigen::VectorXd left_of_whitened(const Eigen::VectorXd& difference) const;
    [[nodiscard]] Eigen::VectorXd whitened_difference(const Readings& readings) const;
    /// Whitened columns of the free numbers, [n_readings][8], and the prior standard deviation of each.
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

/// The number at which a cause shows at so many standard deviations, by the secant method.
/// @param sign of the step from absent to it, counted in the direction of Variant::typical
/// @returns nothing where that number is beyond what is physical, or nothing shows
[[nodiscard]] std::optional<double> number_for(const Oracle& oracle, const Variant& variant, double sign, double sigma,
                                               double critical_speed);

}  // namespace hidden_effects
