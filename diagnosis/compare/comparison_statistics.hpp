// SPDX-License-Identifier: BSD-3-Clause
// Statistics of correlated differences: bias with its standard deviation (Geyer, Stat. Sci. 7 (1992) 473), model
// uncertainty (McGrattan and Toman, Metrologia 48 (2011) 173), association with a signal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tiretherm::diagnosis {

/// A value along time, a piece for each run; neighbours in a piece are neighbours in time.
using Pieces = std::vector<std::vector<double>>;

/// How far simulated and measured values are apart. Differences are simulated - measured.
struct Figures {
    std::size_t samples = 0;
    double bias = 0.0;            ///< mean difference
    double rmse = 0.0;            ///< root of the mean squared difference
    double scatter = 0.0;         ///< standard deviation of the differences about their mean
    double independent = 0.0;     ///< how many independent samples would leave the bias as uncertain
    double bias_deviation = 0.0;  ///< standard deviation of the bias; infinite for a single sample

    friend bool operator==(const Figures&, const Figures&) = default;
};
[[nodiscard]] Figures figures(const Pieces& differences);

/// How many samples stand for one, 1 + 2 sum of the autocorrelations, 1 or more. The sum ends where it no longer falls
/// towards zero (Geyer, Statistical Science 7 (1992) 473: initial monotone sequence); differences that keep their sign over
/// a whole run so count as few samples, whatever the logger's rate.
[[nodiscard]] double correlated_samples(const Pieces& a);

/// Sums of the products of values about their mean and those some samples before, each lag's worked out once. The values are
/// means of groups of neighbours where a piece is long.
class Autocovariance {
public:
    explicit Autocovariance(const Pieces& pieces);

    [[nodiscard]] double at(std::size_t lag);
    [[nodiscard]] std::size_t samples() const { return samples_; }  ///< or groups of them
    [[nodiscard]] std::size_t longest() const;                      ///< piece, in samples or groups

private:
    Pieces pieces_;  ///< about their mean
    std::size_t samples_ = 0;
    std::vector<double> products_{};  ///< by the lag
};

/// Standard deviation of what changes from one sample to the next: of each sample about the line between its neighbours.
/// It is the whole noise where that is white, less of it the slower it is, and nothing of what is smooth over three samples.
/// @param time pieces like those of the values   @returns NaN with fewer than three samples in every piece
[[nodiscard]] double sample_to_sample_noise(const Pieces& time, const Pieces& value);

/// How far the model itself is off, the sensor's uncertainty removed: McGrattan and Toman, "Quantifying the predictive
/// uncertainty of complex numerical models", Metrologia 48 (2011) 173, as in the FDS Validation Guide.
struct ModelUncertainty {
    double scatter = 0.0;       ///< in the values' unit: sqrt(max(0, scatter^2 - sensor^2))
    double removable = 0.0;     ///< sqrt(max(0, rmse^2 - sensor^2)): the rmse that a better model could take away
    bool below_sensor = false;  ///< the differences scatter less than the sensor may
    std::size_t compared = 0;   ///< samples for the ratio below; 0: none is large enough beside the sensor
    double factor = 1.0;        ///< simulated rise = factor * true rise, on the whole
    double relative = 0.0;      ///< standard deviation of that ratio
};
/// @param measured, simulated rises above the surroundings, or values that have a natural zero
/// @param sensor standard deviation of a measured value, >= 0
[[nodiscard]] ModelUncertainty model_uncertainty(const Figures& figures, std::span<const double> measured,
                                                 std::span<const double> simulated, double sensor);

/// Differences where a regressor is in one of its fifths.
struct Bin {
    double low = 0.0;   ///< smallest value of the regressor in it
    double high = 0.0;  ///< largest
    std::size_t samples = 0;
    double mean = 0.0;
    double deviation = 0.0;  ///< of the mean, with as many correlated samples as in the whole
};
/// Five bins of equally many samples; equal values share a bin, so that there may be fewer.
/// @param together `correlated_samples` of the differences
[[nodiscard]] std::vector<Bin> bins(const Pieces& regressor, const Pieces& differences, double together);

/// How closely differences follow a regressor.
struct Association {
    double correlation = 0.0;  ///< of the two, over all runs
    double independent = 0.0;  ///< samples, as many as two unrelated signals as slow as these would need
    double sigmas = 0.0;       ///< Fisher's atanh(r) sqrt(independent - 3), standard normal without a relation
    double chance = 1.0;       ///< that unrelated signals give as large a correlation, either sign
};
/// As many samples stand for one as the product of both autocorrelations says (Bartlett).
/// @returns nothing (correlation 0) where either does not vary
[[nodiscard]] Association association(const Pieces& regressor, const Pieces& differences,
                                      Autocovariance& of_differences);
[[nodiscard]] inline Association association(const Pieces& regressor, const Pieces& differences) {
    Autocovariance own(differences);
    return association(regressor, differences, own);
}

/// Whether nothing was measured between two samples that follow one another, as in laps that do not count: their interval is more than
/// twenty times those beside it and a fiftieth of the whole. A logger that goes on more slowly has no gap.
/// @param time ascending  @param later index of the second sample, not 0
[[nodiscard]] bool is_gap(std::span<const double> time, std::size_t later);

}  // namespace tiretherm::diagnosis
