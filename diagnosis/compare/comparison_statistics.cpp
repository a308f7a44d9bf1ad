// SPDX-License-Identifier: BSD-3-Clause
// Sums of autocorrelations (Geyer's initial monotone sequence, Bartlett's formula), sample-to-sample noise, bins and
// correlation with Fisher's transformation.

#include "diagnosis/compare/comparison_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "solver/order_statistics.hpp"

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

/// Sum over all of (a - mean a)(b - mean b).
double joint(const Pieces& a, double mean_a, const Pieces& b, double mean_b) {
    double sum = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        for (std::size_t i = 0; i < a[p].size(); ++i) {
            sum += (a[p][i] - mean_a) * (b[p][i] - mean_b);
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
double sum_of_correlations(Autocovariance& a, Autocovariance* b) {
    const double scale = a.at(0) * (b == nullptr ? 1.0 : b->at(0));
    if (!(scale > 0.0)) {
        return 1.0;
    }
    const std::size_t longest = a.longest();
    const auto at = [&](std::size_t lag) { return a.at(lag) * (b == nullptr ? 1.0 : b->at(lag)) / scale; };
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

Autocovariance::Autocovariance(const Pieces& pieces) : pieces_(coarse(pieces)), samples_(count(pieces_)) {
    const double middle = mean(pieces_);
    for (std::vector<double>& piece : pieces_) {
        std::ranges::for_each(piece, [&](double& value) { value -= middle; });
    }
}

double Autocovariance::at(std::size_t lag) {
    constexpr std::size_t at_once = 4;  // sums that do not wait for one another
    while (products_.size() <= lag) {
        const std::size_t first = products_.size();
        std::array<double, at_once> sums{};
        for (const std::vector<double>& piece : pieces_) {
            for (std::size_t i = first; i < std::min(first + at_once, piece.size()); ++i) {
                for (std::size_t k = 0; k <= i - first; ++k) {
                    sums[k] += piece[i] * piece[i - first - k];
                }
            }
            for (std::size_t i = first + at_once; i < piece.size(); ++i) {
                for (std::size_t k = 0; k < at_once; ++k) {
                    sums[k] += piece[i] * piece[i - first - k];
                }
            }
        }
        products_.insert(products_.end(), sums.begin(), sums.end());
    }
    return products_[lag];
}

std::size_t Autocovariance::longest() const { return longest_of(pieces_); }

double correlated_samples(const Pieces& a) {
    // Var(mean) is that of the coarse means, which hold all that is slow.
    Autocovariance groups(a);
    const double mean_a = mean(a);
    const auto n = static_cast<double>(count(a));
    const auto n_groups = static_cast<double>(groups.samples());
    const double variance = joint(a, mean_a, a, mean_a) / n;
    const double group_variance = groups.at(0) / n_groups;
    if (!(variance > 0.0)) {
        return 1.0;
    }
    const double of_mean = group_variance * sum_of_correlations(groups, nullptr) / n_groups;
    return std::clamp(n * of_mean / variance, 1.0, std::max(1.0, n));
}

Figures figures(const Pieces& differences) {
    Figures result;
    result.samples = count(differences);
    if (result.samples == 0) {
        return result;
    }
    const auto n = static_cast<double>(result.samples);
    result.bias = mean(differences);
    const double about = joint(differences, result.bias, differences, result.bias);
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
    constexpr std::size_t fifths = 5;
    std::vector<double> all;
    all.reserve(count(regressor));
    for (const std::vector<double>& piece : regressor) {
        all.insert(all.end(), piece.begin(), piece.end());
    }
    std::vector<std::size_t> places;
    for (std::size_t k = 1; k <= fifths; ++k) {
        if (const std::size_t end = all.size() * k / fifths; end > 0) {
            places.push_back(end - 1);
        }
    }
    std::vector<double> highs = solver::smallest_at(all, places);
    highs.erase(std::unique(highs.begin(), highs.end()), highs.end());  // equal values take several fifths

    constexpr double most = std::numeric_limits<double>::infinity();
    std::array<double, fifths - 1> limits;  // between two bins
    limits.fill(most);
    std::copy_n(highs.begin(), highs.empty() ? 0 : highs.size() - 1, limits.begin());
    const auto bin_of = [&](double value) {
        return std::size_t{value > limits[0]} + std::size_t{value > limits[1]} + std::size_t{value > limits[2]} +
               std::size_t{value > limits[3]};
    };
    std::array<Bin, fifths> found;
    std::ranges::fill(found, Bin{.low = most});
    for (std::size_t p = 0; p < regressor.size(); ++p) {
        for (std::size_t i = 0; i < regressor[p].size(); ++i) {
            Bin& bin = found[bin_of(regressor[p][i])];
            bin.low = std::min(bin.low, regressor[p][i]);
            bin.mean += differences[p][i];
            ++bin.samples;
        }
    }
    for (std::size_t k = 0; k < highs.size(); ++k) {
        found[k].high = highs[k];
        found[k].mean /= static_cast<double>(found[k].samples);
    }
    for (std::size_t p = 0; p < regressor.size(); ++p) {
        for (std::size_t i = 0; i < regressor[p].size(); ++i) {
            Bin& bin = found[bin_of(regressor[p][i])];
            bin.deviation += (differences[p][i] - bin.mean) * (differences[p][i] - bin.mean);
        }
    }
    for (std::size_t k = 0; k < highs.size(); ++k) {
        const auto n = static_cast<double>(found[k].samples);
        const double scatter = n > 1.0 ? std::sqrt(found[k].deviation / (n - 1.0)) : 0.0;
        found[k].deviation = scatter / std::sqrt(std::max(1.0, n / together));
    }
    return {found.begin(), found.begin() + std::ssize(highs)};
}

Association association(const Pieces& regressor, const Pieces& differences, Autocovariance& of_differences) {
    Association result;
    const std::size_t samples = count(differences);
    if (samples < 2) {
        return result;
    }
    const double mean_r = mean(regressor);
    const double mean_d = mean(differences);
    const double squares = joint(regressor, mean_r, regressor, mean_r);
    const double scale2 = squares * joint(differences, mean_d, differences, mean_d);
    // A constant's differences from its own mean are round-off.
    const double size = std::abs(mean_r) * std::sqrt(static_cast<double>(samples));
    if (!(scale2 > 0.0) || squares <= 1e-24 * size * size) {
        return result;
    }
    result.correlation = std::clamp(joint(regressor, mean_r, differences, mean_d) / std::sqrt(scale2), -1.0, 1.0);
    Autocovariance groups(regressor);
    const auto n = static_cast<double>(samples);
    const double group = n / static_cast<double>(std::max<std::size_t>(1, groups.samples()));
    result.independent = n / std::clamp(group * sum_of_correlations(groups, &of_differences), 1.0, n);
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
