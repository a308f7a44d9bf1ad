// SPDX-License-Identifier: BSD-3-Clause
// Sums of autocorrelations (Geyer's initial monotone sequence, Bartlett's formula), sample-to-sample noise, bins and
// correlation with Fisher's transformation.

#include "diagnosis/compare/comparison_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace tiretherm::diagnosis {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const Pieces& pieces) {
    return std::accumulate(pieces.begin(), pieces.end(), std::size_t{0},
                           [](std::size_t n, const std::vector<double>& piece) { return n + piece.size(); });
}

std::size_t longest_of(const Pieces& pieces) {
    const auto piece = std::ranges::max_element(pieces, {}, &std::vector<double>::size);
    return piece == pieces.end() ? 0 : piece->size();
}

double mean(const Pieces& pieces) {
    double sum = 0.0;
    for (const std::vector<double>& piece : pieces) {
        sum = std::accumulate(piece.begin(), piece.end(), sum);
    }
    return sum / static_cast<double>(count(pieces));
}

/// Sum over all of (a - mean a)(b - mean b), `lag` samples apart.
double joint(const Pieces& a, double mean_a, const Pieces& b, double mean_b, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        for (std::size_t i = lag; i < a[p].size(); ++i) {
            sum += (a[p][i] - mean_a) * (b[p][i - lag] - mean_b);
        }
    }
    return sum;
}

/// Means of groups of neighbours, so that no piece is longer than a thousand, and all their lags cost little: the slow part,
/// which counts, stays.
Pieces coarse(const Pieces& pieces) {
    constexpr std::size_t enough = 1000;
    constexpr double most_products = 1e8;
    const std::size_t longest = longest_of(pieces);
    const double products = static_cast<double>(longest) * static_cast<double>(count(pieces));
    const std::size_t group =
        std::max({std::size_t{1}, longest / enough, static_cast<std::size_t>(std::sqrt(products / most_products))});
    if (group == 1) {
        return pieces;
    }
    Pieces result;
    for (const std::vector<double>& piece : pieces) {
        result.emplace_back();
        for (std::size_t i = 0; i + group <= piece.size(); i += group) {
            const auto begin = piece.begin() + static_cast<std::ptrdiff_t>(i);
            result.back().push_back(std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(group), 0.0) /
                                    static_cast<double>(group));
        }
    }
    return result;
}

/// 1 + 2 sum of the products of two autocorrelations, at least `least`.
double sum_of_correlations(const Pieces& a, const Pieces* b) {
    const double mean_a = mean(a);
    const double mean_b = b == nullptr ? 0.0 : mean(*b);
    const double scale = joint(a, mean_a, a, mean_a, 0) * (b == nullptr ? 1.0 : joint(*b, mean_b, *b, mean_b, 0));
    if (!(scale > 0.0)) {
        return 1.0;
    }
    const std::size_t longest = longest_of(a);
    const auto at = [&](std::size_t lag) {
        return joint(a, mean_a, a, mean_a, lag) * (b == nullptr ? 1.0 : joint(*b, mean_b, *b, mean_b, lag)) / scale;
    };
    // Pairs of neighbouring lags are positive and fall for any stationary reversible process; noise ends the sum.
    double sum = -1.0;
    double before = std::numeric_limits<double>::infinity();
    for (std::size_t lag = 0; lag < longest; lag += 2) {
        const double pair = at(lag) + (lag + 1 < longest ? at(lag + 1) : 0.0);
        if (!(pair > 0.0)) {
            break;
        }
        before = std::min(before, pair);
        sum += 2.0 * before;
    }
    return std::max(sum, 0.0);
}

}  // namespace

double correlated_samples(const Pieces& a) {
    // Var(mean) is that of the coarse means, which hold all that is slow.
    const Pieces groups = coarse(a);
    const double mean_a = mean(a);
    const double mean_g = mean(groups);
    const auto n = static_cast<double>(count(a));
    const auto n_groups = static_cast<double>(count(groups));
    const double variance = joint(a, mean_a, a, mean_a, 0) / n;
    const double group_variance = joint(groups, mean_g, groups, mean_g, 0) / n_groups;
    if (!(variance > 0.0)) {
        return 1.0;
    }
    const double of_mean = group_variance * sum_of_correlations(groups, nullptr) / n_groups;
    return std::clamp(n * of_mean / variance, 1.0, std::max(1.0, n));
}

double correlated_samples(const Pieces& a, const Pieces& b) {
    const Pieces groups_a = coarse(a);
    const Pieces groups_b = coarse(b);
    const double group = static_cast<double>(count(a)) / static_cast<double>(std::max<std::size_t>(1, count(groups_a)));
    return std::clamp(group * sum_of_correlations(groups_a, &groups_b), 1.0,
                      std::max(1.0, static_cast<double>(count(a))));
}

Figures figures(const Pieces& differences) {
    Figures result;
    result.samples = count(differences);
    if (result.samples == 0) {
        return result;
    }
    const auto n = static_cast<double>(result.samples);
    result.bias = mean(differences);
    const double about = joint(differences, result.bias, differences, result.bias, 0);
    result.rmse = std::sqrt(about / n + result.bias * result.bias);
    result.independent = n / correlated_samples(differences);
    result.bias_deviation = std::numeric_limits<double>::infinity();
    if (result.samples > 1) {
        result.scatter = std::sqrt(about / (n - 1.0));
        result.bias_deviation = result.scatter / std::sqrt(result.independent);
    }
    return result;
}

double sample_to_sample_noise(const Pieces& time, const Pieces& value) {
    double squares = 0.0;
    double weights = 0.0;
    for (std::size_t p = 0; p < value.size(); ++p) {
        for (std::size_t i = 1; i + 1 < value[p].size(); ++i) {
            const double share = (time[p][i + 1] - time[p][i]) / (time[p][i + 1] - time[p][i - 1]);
            const double line = share * value[p][i - 1] + (1.0 - share) * value[p][i + 1];
            const double off = value[p][i] - line;
            // White noise of variance s^2 makes this s^2 (1 + share^2 + (1 - share)^2).
            squares += off * off / (1.0 + share * share + (1.0 - share) * (1.0 - share));
            weights += 1.0;
        }
    }
    return weights > 0.0 ? std::sqrt(squares / weights) : nothing;
}

ModelUncertainty model_uncertainty(const Figures& figures, std::span<const double> measured,
                                   std::span<const double> simulated, double sensor) {
    ModelUncertainty result;
    result.scatter = std::sqrt(std::max(0.0, figures.scatter * figures.scatter - sensor * sensor));
    result.removable = std::sqrt(std::max(0.0, figures.rmse * figures.rmse - sensor * sensor));
    result.below_sensor = figures.scatter < sensor;
    // A rise of ten standard deviations is measured to 10 %; below, the logarithm of the ratio is mostly noise.
    constexpr double large = 10.0;
    double sum = 0.0;
    double squares = 0.0;
    double of_sensor = 0.0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        if (measured[i] > large * sensor && measured[i] > 0.0 && simulated[i] > 0.0) {
            const double x = std::log(simulated[i] / measured[i]);
            sum += x;
            squares += x * x;
            of_sensor += std::pow(sensor / measured[i], 2);
            ++result.compared;
        }
    }
    if (result.compared < 2) {
        result.compared = 0;
        return result;
    }
    // ln(M/E) has the variance relative^2 + sensor^2 and, M and E being normal about their means, the mean
    // ln(factor) - relative^2 / 2 + sensor^2 / 2.
    const auto n = static_cast<double>(result.compared);
    const double variance = std::max(0.0, (squares - sum * sum / n) / (n - 1.0));
    of_sensor /= n;
    const double relative2 = std::max(0.0, variance - of_sensor);
    result.relative = std::sqrt(relative2);
    result.factor = std::exp(sum / n + relative2 / 2.0 - of_sensor / 2.0);
    return result;
}

std::vector<Bin> bins(const Pieces& regressor, const Pieces& differences, double together) {
    std::vector<std::pair<double, double>> samples;
    for (std::size_t p = 0; p < regressor.size(); ++p) {
        for (std::size_t i = 0; i < regressor[p].size(); ++i) {
            samples.emplace_back(regressor[p][i], differences[p][i]);
        }
    }
    constexpr std::size_t fifths = 5;
    std::vector<Bin> result;
    auto first = samples.begin();
    for (std::size_t k = 1; k <= fifths; ++k) {
        auto end = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() * k / fifths);
        if (end <= first) {  // equal values have taken this fifth already
            continue;
        }
        const auto regressor_of = [](const auto& sample) { return sample.first; };
        std::ranges::nth_element(first, end - 1, samples.end(), {}, regressor_of);
        const double high = (end - 1)->first;
        end = std::partition(end, samples.end(), [&](const auto& sample) { return sample.first == high; });
        const auto n = static_cast<double>(end - first);
        double low = high;
        double sum = 0.0;
        double squares = 0.0;
        for (auto sample = first; sample != end; ++sample) {
            low = std::min(low, sample->first);
            sum += sample->second;
        }
        for (auto sample = first; sample != end; ++sample) {
            squares += (sample->second - sum / n) * (sample->second - sum / n);
        }
        const double scatter = end - first > 1 ? std::sqrt(squares / (n - 1.0)) : 0.0;
        result.push_back({.low = low,
                          .high = high,
                          .samples = static_cast<std::size_t>(end - first),
                          .mean = sum / n,
                          .deviation = scatter / std::sqrt(std::max(1.0, n / together))});
        first = end;
    }
    return result;
}

Association association(const Pieces& regressor, const Pieces& differences) {
    Association result;
    const std::size_t samples = count(differences);
    if (samples < 2) {
        return result;
    }
    const double mean_r = mean(regressor);
    const double mean_d = mean(differences);
    const double squares = joint(regressor, mean_r, regressor, mean_r, 0);
    const double scale2 = squares * joint(differences, mean_d, differences, mean_d, 0);
    // A constant's differences from its own mean are round-off.
    const double size = std::abs(mean_r) * std::sqrt(static_cast<double>(samples));
    if (!(scale2 > 0.0) || squares <= 1e-24 * size * size) {
        return result;
    }
    result.correlation = std::clamp(joint(regressor, mean_r, differences, mean_d, 0) / std::sqrt(scale2), -1.0, 1.0);
    result.independent = static_cast<double>(samples) / correlated_samples(regressor, differences);
    if (result.independent > 3.0) {
        result.sigmas =
            std::atanh(std::clamp(result.correlation, -1.0 + 1e-15, 1.0 - 1e-15)) * std::sqrt(result.independent - 3.0);
        result.chance = std::erfc(std::abs(result.sigmas) / std::numbers::sqrt2);
    }
    return result;
}

bool is_gap(std::span<const double> time, std::size_t later) {
    constexpr double usual = 20.0;
    constexpr double least_share = 0.02;
    const double before = later > 1 ? time[later - 1] - time[later - 2] : 0.0;
    const double after = later + 1 < time.size() ? time[later + 1] - time[later] : 0.0;
    const double beside = std::max(before, after);  // both 0: of two samples
    return beside > 0.0 &&
           time[later] - time[later - 1] > std::max(usual * beside, least_share * (time.back() - time.front()));
}

}  // namespace tiretherm::diagnosis
