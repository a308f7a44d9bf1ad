// SPDX-License-Identifier: BSD-3-Clause
// Standard deviations and Wald intervals from the information matrix, its eigenvectors as combinations that the data
// determine, and cautions about each channel's noise.

#include "diagnosis/fit/fit_assessment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

namespace tiretherm::diagnosis {

namespace {

/// A posterior standard deviation below this share of the prior's is the data's doing; above that one, the prior's.
constexpr double data_alone = 0.5;
constexpr double prior_alone = 0.9;

/// A channel that fits worse than before by this factor has been given up; noise this far above the sensor's, in a channel
/// of many samples, holds more than noise.
constexpr double worse = 1.05;
constexpr double swollen = 1.5;
constexpr Eigen::Index many = 100;

constexpr double wide = 1.959964;  // 95 % of a normal distribution

/// A number after the fit. @param deviation its standard deviation, in its scale
Fitted assess_parameter(const Fit& fit, Eigen::Index j, double deviation, bool searched) {
    const double value = fit.values()[j];
    const double sd = deviation * fit.scale()[j];
    const double low = fit.low()[j];
    const double high = fit.high()[j];
    const double slack = 1e-6 * fit.scale()[j];
    const bool has_prior = fit.precision()[j] > 0.0;
    Fitted one{.value = value,
               .before = fit.simulator().start()[j],
               .standard_deviation = sd,
               .low = std::max(low, value - wide * sd),
               .high = std::min(high, value + wide * sd),
               .low_is_open = value - wide * sd<low, .high_is_open = value + wide * sd> high};
    if (searched && (value <= low + slack || value >= high - slack)) {
        one.identifiability = Identifiability::at_bound;
    } else if (!has_prior && deviation > 1.0) {
        one.identifiability = Identifiability::not_determined;
        one.standard_deviation = std::numeric_limits<double>::infinity();
        one.low = one.high = std::numeric_limits<double>::quiet_NaN();
        one.low_is_open = one.high_is_open = true;
    } else if (has_prior && deviation > prior_alone) {
        one.identifiability = Identifiability::prior_only;
    } else if (has_prior && deviation > data_alone) {
        one.identifiability = Identifiability::with_prior;
    }
    return one;
}

/// Whether a fit has left a channel alone that the case had right: what its numbers cannot explain it takes for noise. Within
/// the data sheet there is nothing to explain.
bool is_given_up(const ChannelFit& fit) {
    return fit.rmse_after > worse * fit.rmse_before && fit.rmse_after > fit.stated;
}

/// What is to be said where a fit takes an error of the model for noise; nothing where it has not.
std::optional<Remark> remark_on(const ChannelFit& fit, const solver::Channel& channel) {
    const double stated = fit.stated;
    const std::string unit(solver::unit_of(channel.quantity));
    if (fit.is_missed() && fit.noise.sigma <= far_above_data_sheet * stated) {
        return remark::channel_is_missed(fit.name, fit.rmse_after, unit, fit.rmse_after / stated, stated);
    }
    if (is_given_up(fit)) {
        return remark::rms_rose(fit.name, fit.rmse_before, fit.rmse_after, unit);
    }
    if (fit.noise.white_share < 1.0 && stated > 0.0 && fit.samples > many && fit.noise.sigma > swollen * stated &&
        fit.noise.sigma <= far_above_data_sheet * stated) {  // beyond that `cautions` says it
        return remark::noise_above_stated(fit.name, fit.noise.sigma / stated);
    }
    return std::nullopt;
}

/// What is to be said of the noise of one band of a camera's frames.
/// @param finest the finest band of the same camera; null: this one
Remarks cautions_of_band(const ChannelFit& band, const ChannelFit* finest) {
    if (finest == nullptr) {
        return band.stated > 0.0 && band.noise.sigma > swollen * band.stated
                   ? Remarks{remark::band_above_data_sheet(band.name, band.noise.sigma, band.noise.sigma / band.stated)}
                   : Remarks{};
    }
    return band.noise.sigma > swollen * finest->noise.sigma
               ? Remarks{remark::band_above_pixels(band.name, band.noise.sigma / finest->noise.sigma)}
               : Remarks{};
}

}  // namespace

std::string_view word_of(Identifiability identifiability) {
    switch (identifiability) {
        case Identifiability::determined:
            return "determined";
        case Identifiability::doubtful:
            return "doubtful";
        case Identifiability::with_prior:
            return "with prior";
        case Identifiability::prior_only:
            return "prior only";
        case Identifiability::not_determined:
            return "not determined";
        case Identifiability::at_bound:
            return "at bound";
    }
    return "";
}

void assess_parameters(const Fit& fit, Identification& into, bool searched) {
    const Eigen::MatrixXd whitened = fit.whitened_slopes();
    const Eigen::Index n = whitened.cols();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> seen(Eigen::MatrixXd(whitened.transpose() * whitened));
    into.directions.clear();
    into.fitted.clear();
    for (Eigen::Index k = n - 1; k >= 0; --k) {
        into.directions.push_back(
            {.strength = std::sqrt(std::max(0.0, seen.eigenvalues()[k])), .share = seen.eigenvectors().col(k)});
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(fit.information());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const double variance = 1.0 / std::max(all.eigenvalues()[k], 1e-12 * all.eigenvalues()[n - 1] + 1e-300);
        covariance += variance * all.eigenvectors().col(k) * all.eigenvectors().col(k).transpose();
    }
    const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
    into.correlation = deviation.cwiseInverse().asDiagonal() * covariance * deviation.cwiseInverse().asDiagonal();
    for (Eigen::Index j = 0; j < n; ++j) {
        into.fitted.push_back(assess_parameter(fit, j, deviation[j], searched));
    }
    into.misfit = fit.whitened_residuals().squaredNorm();
    into.freedom = static_cast<double>(whitened.rows()) - (covariance * whitened.transpose() * whitened).trace();
    into.non_smooth_parameters = fit.now().non_smooth_parameters;
}

void assess_channels(const Fit& fit, Identification& into) {
    const Observations& observations = fit.observations();
    const std::vector<solver::Channel>& channels = fit.experiment().runs.front().problem.channels;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const solver::Channel& channel = channels[observations.channels[c]];
        ChannelFit found;
        found.channel = observations.channels[c];
        found.name = observations.names[c];
        found.stated = fit.stated(c);
        found.noise = fit.covariance().channels[c];
        found.found = fit.noise().channels[c];
        bool is_image = false;
        for (const NoiseBlock& block : observations.blocks) {
            if (block.channel == static_cast<int>(c)) {
                is_image = observations.rows[static_cast<std::size_t>(block.first)].image >= 0;
                const auto rows = Eigen::seqN(block.first, block.rows());
                found.samples += block.rows();
                found.rmse_before += (into.before(rows) - observations.measured(rows)).squaredNorm();
                found.rmse_after += (into.after(rows) - observations.measured(rows)).squaredNorm();
            }
        }
        found.rmse_before = std::sqrt(found.rmse_before / static_cast<double>(found.samples));
        found.rmse_after = std::sqrt(found.rmse_after / static_cast<double>(found.samples));
        if (is_image) {
            const auto finest = std::ranges::find(into.channels, found.channel, &ChannelFit::channel);
            found.cautions = cautions_of_band(found, finest == into.channels.end() ? nullptr : &*finest);
        } else {
            found.cautions = cautions(found.name, std::string(solver::unit_of(channel.quantity)), found.noise,
                                      found.found, found.stated, {});
            if (std::optional<Remark> caution = remark_on(found, channel)) {
                found.cautions.push_back(std::move(*caution));
            }
            found.is_in_doubt =
                is_in_doubt(found.noise, found.found, found.stated) || is_given_up(found) || found.is_missed();
        }
        into.channels.push_back(std::move(found));
    }
    for (const NoiseBlock& block : observations.blocks) {
        for (Eigen::Index i = 0; block.channel < 0 && i < block.rows(); ++i) {
            const Eigen::Index row = block.first + i;
            into.numbers.push_back({.row = static_cast<std::size_t>(row),
                                    .measured = observations.measured[row],
                                    .before = into.before[row],
                                    .after = into.after[row],
                                    .standard_deviation = block.standard_deviation[static_cast<std::size_t>(i)]});
        }
    }
}

}  // namespace tiretherm::diagnosis
