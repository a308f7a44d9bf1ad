#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace tiretherm::support {

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
    /// An end of Wilson's 95 % interval of the share. Wilson, JASA 22 (1927) 209
    [[nodiscard]] double wilson(int side) const {
        constexpr double z = 1.959964;
        const double n = count_;
        const double p = share();
        return (p + z * z / (2.0 * n) + side * z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n))) /
               (1.0 + z * z / n);
    }
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

/// Misses of n independent 95 % intervals that are exceeded once in a thousand times: the 99.9 % quantile of the
/// binomial distribution of n trials of 1 in 20.
inline int most_misses(int n) {
    double probability = std::pow(0.95, n);  // of no miss
    double up_to = probability;
    int k = 0;
    while (up_to < 0.999) {
        probability *= static_cast<double>(n - k) / (k + 1) * (0.05 / 0.95);
        up_to += probability;
        ++k;
    }
    return k;
}

}  // namespace tiretherm::support
