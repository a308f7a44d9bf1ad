// SPDX-License-Identifier: BSD-3-Clause
// A parameter fit under way: the values, the prediction and its slopes, the noise, and least squares with the noise
// held.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/fit/least_squares.hpp"
#include "diagnosis/noise/noise_estimate.hpp"
#include "diagnosis/observations/observations.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// A fit under way: the values, what is simulated with them, the noise.
class Fit {
public:
    /// @param experiment, observations live longer
    Fit(const input::Experiment& experiment, const Observations& observations);

    /// Moves to these values. @returns false when the model fails there: `now` says why
    [[nodiscard]] bool move_to(const Eigen::VectorXd& values);
    /// The noise as the sensors' data sheets say; 1 where they say nothing.
    void take_stated_noise();
    void take_noise(std::vector<Noise> channels) { covariance_.channels = std::move(channels); }
    void take_covariance(Covariance covariance) { covariance_ = std::move(covariance); }
    /// The noise that is most likely at the present values, whatever size the columns of `also` have in the residuals.
    /// @param also [n_rows][any number] SI; may be empty
    void find_noise(const Eigen::MatrixXd& also = {});

    struct Turn {
        double moved = 0.0;  ///< of any number, in standard deviations at most
        int iterations = 0;
        bool converged = false;
    };
    /// Least squares from the present values on, with the noise held.
    [[nodiscard]] Turn minimise_squares();
    /// The same as a problem, which refers to this fit.
    [[nodiscard]] LeastSquares least_squares();

    /// S' V^-1 S + Pi in units of the scales. @returns [n_parameters][n_parameters]
    [[nodiscard]] Eigen::MatrixXd information() const;
    /// V^-1/2 S in units of the scales. @returns [n_rows][n_parameters]
    [[nodiscard]] Eigen::MatrixXd whitened_slopes() const;
    /// V^-1/2 (simulated - measured). @returns [n_rows]
    [[nodiscard]] Eigen::VectorXd whitened_residuals() const;
    /// A sensor's standard deviation as its data sheet says, 0 where it says nothing. @param c noise of Block::channel
    [[nodiscard]] double stated(std::size_t c) const;

    [[nodiscard]] const input::Experiment& experiment() const { return experiment_; }
    [[nodiscard]] const Observations& observations() const { return observations_; }
    [[nodiscard]] Simulator& simulator() { return simulator_; }
    [[nodiscard]] const Simulator& simulator() const { return simulator_; }
    [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }
    [[nodiscard]] const ModelPrediction& now() const { return prediction_; }
    [[nodiscard]] const Covariance& covariance() const { return covariance_; }
    [[nodiscard]] const NoiseEstimate& noise() const { return noise_; }
    [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }
    /// What was expected of each number.
    [[nodiscard]] const Eigen::VectorXd& prior() const { return prior_; }
    /// 1 / variance of what was known of each number, 0 where nothing was.
    [[nodiscard]] const Eigen::VectorXd& precision() const { return precision_; }
    [[nodiscard]] const Eigen::VectorXd& low() const { return low_; }
    [[nodiscard]] const Eigen::VectorXd& high() const { return high_; }

private:
    [[nodiscard]] std::optional<Residuals> residuals(const Eigen::VectorXd& values);

    const input::Experiment& experiment_;
    const Observations& observations_;
    Simulator simulator_;
    Eigen::Index n_;
    Eigen::VectorXd prior_;
    Eigen::VectorXd precision_;
    Eigen::VectorXd low_;
    Eigen::VectorXd high_;
    Eigen::VectorXd scale_;
    Eigen::VectorXd values_;
    ModelPrediction prediction_;
    Covariance covariance_;
    NoiseEstimate noise_;
};

/// The same experiment with steps whose local error is 1 mK at most. The 10 mK of a run leave as much in the temperatures,
/// which a fit takes into its numbers.
[[nodiscard]] input::Experiment with_fine_steps(input::Experiment experiment);

/// The same experiment with one more number: the conductivity of the outermost layer's material, and of all layers that share
/// its law. The link of two lumps stands for a path of its own, and its law says little of the rubber that takes its place.
[[nodiscard]] input::Experiment with_free_conductivity(input::Experiment experiment);

/// The unit in which a number is measured against the data: its prior's standard deviation, or its size.
[[nodiscard]] Eigen::VectorXd scales_of(const input::Experiment& experiment, const Eigen::VectorXd& values);

}  // namespace tiretherm::diagnosis
