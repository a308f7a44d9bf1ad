#include "diagnosis/identification.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "diagnosis/least_squares.hpp"
#include "diagnosis/profile.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Turns of fit and noise at most; two are the rule.
constexpr int most_turns = 8;
/// Neither the noise nor a number moves the other further than this: relative, and in standard deviations.
constexpr double settled_noise = 0.01;
constexpr double settled_number = 0.05;
/// A posterior standard deviation below this share of the prior's is the data's doing; above that one, the prior's.
constexpr double data_alone = 0.5;
constexpr double prior_alone = 0.9;

/// A channel that fits worse than before by this factor has been given up; noise this far above the sensor's, in a channel
/// of many samples, holds more than noise.
constexpr double worse = 1.05;
constexpr double swollen = 1.5;
constexpr Eigen::Index many = 100;

/// The fit under way: values, their forecast, the noise.
class Fit {
public:
    Fit(const cases::Experiment& experiment, const Observations& observations)
        : experiment_(experiment),
          observations_(observations),
          simulator_(experiment, observations),
          n_(static_cast<Eigen::Index>(experiment.parameters.size())),
          prior_(n_),
          precision_(n_),
          low_(n_),
          high_(n_) {
        for (Eigen::Index j = 0; j < n_; ++j) {
            const solver::Adjustable& parameter = experiment.parameters[static_cast<std::size_t>(j)];
            prior_[j] = parameter.prior;
            precision_[j] = std::isfinite(parameter.standard_deviation)
                                ? 1.0 / (parameter.standard_deviation * parameter.standard_deviation)
                                : 0.0;
            low_[j] = parameter.low;
            high_[j] = parameter.high;
        }
        scale_ = scales_of(experiment, simulator_.start());
        covariance_.channels.resize(observations.channels.size());
    }

    [[nodiscard]] bool forecast(const Eigen::VectorXd& values) {
        forecast_ = simulator_.at(values);
        values_ = values;
        return forecast_.status.ok();
    }

    void take_stated_noise() {
        for (std::size_t c = 0; c < observations_.channels.size(); ++c) {
            covariance_.channels[c] = {.sigma = stated(c) > 0.0 ? stated(c) : 1.0};
        }
    }

    void find_noise() {
        std::vector<double> sheet;
        for (std::size_t c = 0; c < observations_.channels.size(); ++c) {
            sheet.push_back(stated(c));
        }
        const Eigen::VectorXd residual = forecast_.simulated - observations_.measured;
        const Eigen::MatrixXd span = forecast_.slope * scale_.asDiagonal();
        const Eigen::VectorXd precision = precision_.cwiseProduct(scale_.cwiseAbs2());
        noise_ = estimate_noise({.blocks = observations_.blocks,
                                 .residual = residual,
                                 .span = span,
                                 .precision = precision,
                                 .data_sheet = std::move(sheet),
                                 .model = experiment_.noise == "white" ? NoiseModel::white : NoiseModel::correlated,
                                 .robust = experiment_.robust});
        covariance_ = noise_.covariance;
    }

    /// @returns how far the numbers moved, in standard deviations at most
    double minimise_squares(Identification& into) {
        const LeastSquaresResult result = minimise(question());
        into.iterations += result.iterations;
        into.converged = result.converged;
        const Eigen::VectorXd moved = result.values - values_;
        values_ = result.values;
        forecast_ = simulator_.at(values_);
        const Eigen::MatrixXd information = information_matrix();
        double most = 0.0;
        for (Eigen::Index j = 0; j < n_; ++j) {
            most = std::max(most, std::abs(moved[j] / scale_[j]) * std::sqrt(information(j, j)));
        }
        return most;
    }

    [[nodiscard]] LeastSquares question() {
        return {.residuals = [this](const Eigen::VectorXd& values) { return residuals(values); },
                .n_rows = observations_.measured.size() + n_,
                .start = values_,
                .low = low_,
                .high = high_,
                .scale = scale_};
    }

    [[nodiscard]] std::optional<Residuals> residuals(const Eigen::VectorXd& values) {
        const Forecast& found = simulator_.at(values);
        if (!found.status.ok()) {
            return std::nullopt;
        }
        Eigen::MatrixXd rows(observations_.measured.size(), n_ + 1);
        rows << found.slope, found.simulated - observations_.measured;
        whiten(observations_.blocks, covariance_, rows);
        Residuals all{.value = Eigen::VectorXd(rows.rows() + n_), .slope = Eigen::MatrixXd(rows.rows() + n_, n_)};
        const Eigen::VectorXd root = precision_.cwiseSqrt();
        all.value << rows.col(n_), root.cwiseProduct(values - prior_);
        all.slope << rows.leftCols(n_), Eigen::MatrixXd(root.asDiagonal());
        return all;
    }

    /// S' V^-1 S + Pi in units of the scales.
    [[nodiscard]] Eigen::MatrixXd information_matrix() const {
        const Eigen::MatrixXd whitened = whitened_slopes();
        Eigen::MatrixXd information = whitened.transpose() * whitened;
        information.diagonal() += precision_.cwiseProduct(scale_.cwiseAbs2());
        return information;
    }

    [[nodiscard]] Eigen::MatrixXd whitened_slopes() const {
        Eigen::MatrixXd whitened = forecast_.slope * scale_.asDiagonal();
        whiten(observations_.blocks, covariance_, whitened);
        return whitened;
    }

    /// @param searched whether a search has ended at these values: only then a bound says something
    void judge(Identification& into, bool searched) const;
    void describe_channels(Identification& into) const;

    [[nodiscard]] double stated(std::size_t c) const {
        const auto& channels = experiment_.runs.front().problem.channels;
        return channels[observations_.channels[c]].standard_deviation.value_or(0.0);
    }

    const cases::Experiment& experiment_;
    const Observations& observations_;
    Simulator simulator_;
    Eigen::Index n_;
    Eigen::VectorXd prior_;
    Eigen::VectorXd precision_;  ///< 0: nothing is known
    Eigen::VectorXd low_;
    Eigen::VectorXd high_;
    Eigen::VectorXd scale_;
    Eigen::VectorXd values_;
    Forecast forecast_;
    Covariance covariance_;
    NoiseEstimate noise_;
};

/// Which combinations the data see, which numbers, with which intervals.
void Fit::judge(Identification& into, bool searched) const {
    const Eigen::MatrixXd whitened = whitened_slopes();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> seen(Eigen::MatrixXd(whitened.transpose() * whitened));
    for (Eigen::Index k = n_ - 1; k >= 0; --k) {
        into.directions.push_back(
            {.strength = std::sqrt(std::max(0.0, seen.eigenvalues()[k])), .share = seen.eigenvectors().col(k)});
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(information_matrix());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n_, n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
        const double variance = 1.0 / std::max(all.eigenvalues()[k], 1e-12 * all.eigenvalues()[n_ - 1] + 1e-300);
        covariance += variance * all.eigenvectors().col(k) * all.eigenvectors().col(k).transpose();
    }
    const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
    into.correlation = deviation.cwiseInverse().asDiagonal() * covariance * deviation.cwiseInverse().asDiagonal();
    constexpr double wide = 1.959964;  // 95 % of a normal distribution
    for (Eigen::Index j = 0; j < n_; ++j) {
        const double sd = deviation[j] * scale_[j];
        Fitted one{.value = values_[j],
                   .before = simulator_.start()[j],
                   .standard_deviation = sd,
                   .low = std::max(low_[j], values_[j] - wide * sd),
                   .high = std::min(high_[j], values_[j] + wide * sd)};
        const double slack = 1e-6 * scale_[j];
        one.low_is_open = values_[j] - wide * sd < low_[j];
        one.high_is_open = values_[j] + wide * sd > high_[j];
        if (searched && (values_[j] <= low_[j] + slack || values_[j] >= high_[j] - slack)) {
            one.sight = Sight::at_bound;
        } else if (precision_[j] == 0.0 && deviation[j] > 1.0) {
            one.sight = Sight::not_determined;
            one.standard_deviation = std::numeric_limits<double>::infinity();
            one.low = one.high = std::numeric_limits<double>::quiet_NaN();
            one.low_is_open = one.high_is_open = true;
        } else if (precision_[j] > 0.0 && deviation[j] > prior_alone) {
            one.sight = Sight::prior_only;
        } else if (precision_[j] > 0.0 && deviation[j] > data_alone) {
            one.sight = Sight::with_prior;
        }
        into.fitted.push_back(one);
    }
    Eigen::MatrixXd left = forecast_.simulated - observations_.measured;
    whiten(observations_.blocks, covariance_, left);
    into.misfit = left.squaredNorm();
    into.freedom = static_cast<double>(left.rows()) - (covariance * whitened.transpose() * whitened).trace();
    into.kinks = forecast_.kinks;
}

void Fit::describe_channels(Identification& into) const {
    const std::vector<solver::Channel>& channels = experiment_.runs.front().problem.channels;
    for (std::size_t c = 0; c < observations_.channels.size(); ++c) {
        ChannelFit fit;
        fit.channel = observations_.channels[c];
        fit.noise = covariance_.channels[c];
        fit.found = c < noise_.channels.size() ? noise_.channels[c] : ChannelNoise{};
        for (const Block& block : observations_.blocks) {
            if (block.channel != static_cast<int>(c)) {
                continue;
            }
            const auto rows = Eigen::seqN(block.first, block.rows());
            fit.samples += block.rows();
            fit.rmse_before += (into.before(rows) - observations_.measured(rows)).squaredNorm();
            fit.rmse_after += (into.after(rows) - observations_.measured(rows)).squaredNorm();
        }
        fit.rmse_before = std::sqrt(fit.rmse_before / static_cast<double>(fit.samples));
        fit.rmse_after = std::sqrt(fit.rmse_after / static_cast<double>(fit.samples));
        const solver::Channel& channel = channels[fit.channel];
        fit.cautions =
            cautions(channel.name, std::string(solver::unit_of(channel.quantity)), fit.noise, fit.found, stated(c), {});
        const std::string rose = fmt::format("{}: its rms rose with the fit, from {:.2g} to {:.2g} {}", channel.name,
                                             fit.rmse_before, fit.rmse_after, solver::unit_of(channel.quantity));
        const bool eats = fit.noise.white_share < 1.0 && stated(c) > 0.0 && fit.samples > many &&
                          fit.noise.sigma > swollen * stated(c);
        if (fit.rmse_after > worse * fit.rmse_before) {
            fit.cautions.push_back(rose +
                                   ": what the model lacks passes for slow noise, and the numbers and intervals "
                                   "are not to be trusted; see compare, and fit with noise = \"white\" beside it");
        } else if (eats) {
            fit.cautions.push_back(
                fmt::format("{}: its noise is {:.1f} times what the sensor is said to have: part of "
                            "it may be what the model lacks",
                            channel.name, fit.noise.sigma / stated(c)));
        }
        into.channels.push_back(std::move(fit));
    }
    for (const Block& block : observations_.blocks) {
        for (Eigen::Index i = 0; block.channel < 0 && i < block.rows(); ++i) {
            const Eigen::Index row = block.first + i;
            into.numbers.push_back({.row = static_cast<std::size_t>(row),
                                    .before = into.before[row],
                                    .after = into.after[row],
                                    .standard_deviation = block.standard_deviation[static_cast<std::size_t>(i)]});
        }
    }
}

/// Largest relative change of a sigma, or change of a correlation over one second.
double change(const Covariance& before, const Covariance& after) {
    double most = 0.0;
    for (std::size_t c = 0; c < after.channels.size(); ++c) {
        most = std::max({most, std::abs(after.channels[c].sigma / before.channels[c].sigma - 1.0),
                         std::abs(after.channels[c].rho_1s() - before.channels[c].rho_1s())});
    }
    return most;
}

using Clock = std::chrono::steady_clock;

}  // namespace

std::string_view word_of(Sight sight) {
    switch (sight) {
        case Sight::determined:
            return "determined";
        case Sight::with_prior:
            return "with prior";
        case Sight::prior_only:
            return "prior only";
        case Sight::not_determined:
            return "not determined";
        case Sight::at_bound:
            return "at bound";
    }
    return "";
}

Eigen::VectorXd scales_of(const cases::Experiment& experiment, const Eigen::VectorXd& values) {
    Eigen::VectorXd scale(values.size());
    for (Eigen::Index j = 0; j < values.size(); ++j) {
        const solver::Adjustable& parameter = experiment.parameters[static_cast<std::size_t>(j)];
        double size = parameter.standard_deviation;
        if (!std::isfinite(size)) {
            size = parameter.kind == solver::Adjustable::Kind::initial ? 10.0 : std::abs(values[j]);
        }
        if (size == 0.0) {
            size = std::isfinite(parameter.high - parameter.low) ? 0.1 * (parameter.high - parameter.low) : 1.0;
        }
        scale[j] = size;
    }
    return scale;
}

Identification identify(const cases::Experiment& experiment, const Observations& observations,
                        const IdentificationChoice& choice) {
    const Clock::time_point begin = Clock::now();
    Identification result;
    Fit fit(experiment, observations);
    fit.simulator_.tell(choice.progress);
    const auto failed = [&] {
        result.status = fit.forecast_.status;
        return result;
    };
    if (!fit.forecast(fit.simulator_.start())) {
        return failed();
    }
    result.before = fit.forecast_.simulated;
    fit.take_stated_noise();
    for (int turn = 0; turn < most_turns; ++turn) {
        double moved = fit.minimise_squares(result);
        if (!fit.forecast_.status.ok()) {
            return failed();
        }
        if (turn == 0) {  // steps as the fitted values want them
            fit.simulator_.forget_steps();
            if (!fit.forecast(fit.values_)) {
                return failed();
            }
            moved = std::numeric_limits<double>::infinity();
        }
        const Covariance before = fit.covariance_;
        fit.find_noise();
        if (moved <= settled_number && change(before, fit.covariance_) <= settled_noise) {
            break;
        }
    }
    result.values = fit.values_;
    result.after = fit.forecast_.simulated;
    fit.judge(result, true);
    fit.describe_channels(result);
    if (choice.profile) {
        profile_intervals(fit.question(), result);
    }
    result.simulations = fit.simulator_.simulations();
    result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return result;
}

cases::Experiment planned(cases::Experiment experiment) {
    for (cases::MeasuredRun& run : experiment.runs) {
        const solver::Settings& settings = run.problem.settings;
        if (run.time.empty() && settings.steady) {
            run.time = {settings.end};
        }
        if (run.time.empty()) {
            const double length = settings.end - settings.start;
            const double interval = settings.output_interval > 0.0 ? settings.output_interval : 0.01 * length;
            for (int i = 0; i * interval <= length * (1.0 + 1e-12); ++i) {
                run.time.push_back(settings.start + i * interval);
            }
        }
        run.series.clear();
        for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
            if (run.problem.channels[c].standard_deviation) {
                run.series.push_back({.channel = c, .value = std::vector<double>(run.time.size())});
            }
        }
    }
    return experiment;
}

std::vector<Noise> stated_noise(const cases::Experiment& experiment, const Observations& observations,
                                double correlation_time, double white_share) {
    std::vector<Noise> noise;
    for (const std::size_t channel : observations.channels) {
        const solver::Channel& sensor = experiment.runs.front().problem.channels[channel];
        noise.push_back({.sigma = sensor.standard_deviation.value_or(1.0),
                         .correlation_time = correlation_time,
                         .white_share = correlation_time > 0.0 ? white_share : 1.0});
    }
    return noise;
}

Identification plan(const cases::Experiment& experiment, const Observations& observations,
                    const std::vector<Noise>& noise) {
    const Clock::time_point begin = Clock::now();
    Identification result;
    Fit fit(experiment, observations);
    if (!fit.forecast(fit.simulator_.start())) {
        result.status = fit.forecast_.status;
        return result;
    }
    fit.covariance_.channels = noise;
    result.converged = true;
    result.values = fit.values_;
    result.before = result.after = fit.forecast_.simulated;
    fit.judge(result, false);
    result.simulations = fit.simulator_.simulations();
    result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
