// SPDX-License-Identifier: BSD-3-Clause
// Quantiles of the distributions; random numbers from std::seed_seq and std::mt19937_64, the same on every machine.

#include "input/studies/study_draw.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <unsupported/Eigen/SpecialFunctions>

namespace tiretherm::input {

namespace {

/// Of the standard normal distribution.
double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// Mean and standard deviation of the logarithm, from those of the quantity.
struct Logarithm {
    double mean;
    double deviation;
    Logarithm(double m, double s)
        : mean(std::log(m) - 0.5 * std::log1p((s / m) * (s / m))),
          deviation(std::sqrt(std::log1p((s / m) * (s / m)))) {}
};

}  // namespace

double Distribution::below(double x) const {
    switch (spread) {
        case Spread::normal:
            return normal_below((x - a) / b);
        case Spread::lognormal:
            return x > 0.0 ? normal_below((std::log(x) - Logarithm(a, b).mean) / Logarithm(a, b).deviation) : 0.0;
        case Spread::uniform:
            return std::clamp((x - a) / (b - a), 0.0, 1.0);
    }
    return 0.0;
}

double Distribution::quantile(double share) const {
    const double p = below(low) + share * kept();
    double x = 0.0;
    switch (spread) {
        case Spread::normal:
            x = a + b * Eigen::numext::ndtri(p);
            break;
        case Spread::lognormal:
            x = std::exp(Logarithm(a, b).mean + Logarithm(a, b).deviation * Eigen::numext::ndtri(p));
            break;
        case Spread::uniform:
            x = a + p * (b - a);
            break;
    }
    return std::clamp(x, low, high);
}

double draw(std::uint64_t seed, std::uint64_t sample, std::string_view key) {
    std::vector<std::uint32_t> words;
    for (const std::uint64_t number : {seed, sample}) {
        words.push_back(static_cast<std::uint32_t>(number));
        words.push_back(static_cast<std::uint32_t>(number >> 32U));
    }
    for (const char c : key) {
        words.push_back(static_cast<unsigned char>(c));
    }
    // Both are laid down by the standard to the bit, so a study draws the same numbers everywhere.
    std::seed_seq seeds(words.begin(), words.end());
    std::mt19937_64 generator(seeds);
    return (static_cast<double>(generator() >> 11U) + 0.5) * 0x1p-53;
}

}  // namespace tiretherm::input
