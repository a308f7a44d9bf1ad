// SPDX-License-Identifier: BSD-3-Clause
// Counts how often confidence intervals contain the truth, with Wilson's interval (JASA 22 (1927) 209) and binomial
// bounds.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace tiretherm::support {

/// An end of Wilson's 95 % interval of a share of which `held` of `count` were seen. Wilson, JASA 22 (1927) 209
/// @param side -1 or +1
inline double wilson(int held, int count, int side) {
    constexpr double z = 1.959964;
    const double n = count;
    const double p = held / n;
    return (p + z * z / (2.0 * n) + side * z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n))) /
           (1.0 + z * z / n);
}

/// How often the 95 % intervals of a number hold what is true, and how far the number is off on average.
class Coverage {
public:
    void add(double truth, double value, double low, double high) {
        ++count_;
        held_ += low <= truth && truth <= high ? 1 : 0;
        const double off = (value - truth) / (high - low);
        sum_ += off;
        squares_ += off * off;
    }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int missed() const { return count_ - held_; }
    [[nodiscard]] double share() const { return static_cast<double>(held_) / count_; }
    /// Mean of (value - truth) / width of the interval.
    [[nodiscard]] double bias() const { return sum_ / count_; }
    [[nodiscard]] double standard_error_of_bias() const {
        return std::sqrt((squares_ / count_ - bias() * bias()) / count_);
    }
    /// An end of Wilson's 95 % interval of the share.
    [[nodiscard]] double wilson(int side) const { return support::wilson(held_, count_, side); }
    [[nodiscard]] std::string row(const std::string& name) const {
        char text[200];
        std::snprintf(text, sizeof text, "%-32s %4d of %4d  %5.1f %% (%4.1f to %4.1f)  bias/width %+.3f +- %.3f\n",
                      name.c_str(), held_, count_, 100.0 * share(), 100.0 * wilson(-1), 100.0 * wilson(+1), bias(),
                      standard_error_of_bias());
        return text;
    }

private:
    int count_ = 0;
    int held_ = 0;
    double sum_ = 0.0;
    double squares_ = 0.0;
};

/// Misses of n independent trials, each missed with a probability of `rate`, that are exceeded with a probability of less
/// than 1 - kept: a quantile of the binomial distribution. As it stands, those of 95 % intervals, once in a thousand times.
inline int most_misses(int n, double rate = 0.05, double kept = 0.999) {
    double probability = std::pow(1.0 - rate, n);  // of no miss
    double up_to = probability;
    int k = 0;
    while (up_to < kept) {
        probability *= static_cast<double>(n - k) / (k + 1) * (rate / (1.0 - rate));
        up_to += probability;
        ++k;
    }
    return k;
}

}  // namespace tiretherm::support
