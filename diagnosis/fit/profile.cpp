// SPDX-License-Identifier: BSD-3-Clause
// Searches each end of an interval by a root search on the minimised sum of squares, starting from the previous
// minimum.

#include "diagnosis/fit/profile.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::diagnosis {

namespace {

constexpr double rise = 3.841459;  // 95 % of chi-square with one degree of freedom
constexpr int most_trials = 12;
/// How nearly the end of an interval is found, in standard deviations.
constexpr double near = 0.01;

/// One side of one number's profile.
class ProfileSide {
public:
    ProfileSide(const LeastSquares& least_squares, Eigen::Index number, double least, double step)
        : least_squares_(least_squares), number_(number), least_(least), step_(step) {}

    /// @returns the end; `open` when the bound or the last trial is reached first
    double find(bool& open) {
        const double bound = step_ > 0.0 ? least_squares_.high[number_] : least_squares_.low[number_];
        const double fitted = least_squares_.start[number_];
        double inside = 0.0;  // in steps; the root of the rise is nearly linear through 0
        double root_inside = 0.0;
        double outside = 0.0;
        double root_outside = 0.0;
        const double wanted = std::sqrt(rise);
        double at = wanted;
        for (int trial = 0; trial < most_trials; ++trial) {
            const double limit = (bound - fitted) / step_;
            const bool cut = at >= limit;
            at = std::min(at, limit);
            const double root = root_of_rise(fitted + at * step_);
            if (root >= wanted) {
                outside = at;
                root_outside = root;
            } else {
                inside = at;
                root_inside = root;
                if (cut) {
                    open = true;
                    return bound;
                }
            }
            if (outside > 0.0 && outside - inside <= near) {
                break;
            }
            if (outside == 0.0) {
                at = root > 0.0 ? at * std::min(2.0, 1.05 * wanted / root) : 2.0 * at;
                continue;
            }
            const double share = (wanted - root_inside) / (root_outside - root_inside);
            const double next = inside + std::clamp(share, 0.1, 0.9) * (outside - inside);
            if (std::abs(next - at) <= near && trial > 1) {
                at = next;
                break;
            }
            at = next;
        }
        open = outside == 0.0;
        return fitted + at * step_;
    }

private:
    double root_of_rise(double value) {
        LeastSquares least_squares = least_squares_;
        least_squares.start[number_] = value;
        least_squares.held = number_;
        if (last_.size() > 0) {  // the others go on from where they were
            least_squares.start = last_;
            least_squares.start[number_] = value;
        }
        const LeastSquaresResult result = minimise(least_squares);
        if (!std::isfinite(result.sum_of_squares)) {
            return 1e3;
        }
        last_ = result.values;
        return std::sqrt(std::max(0.0, result.sum_of_squares - least_));
    }

    const LeastSquares& least_squares_;
    Eigen::Index number_;
    double least_;
    double step_;  ///< one standard deviation to the side that is looked at
    Eigen::VectorXd last_;
};

}  // namespace

void profile_intervals(const LeastSquares& least_squares, Identification& result) {
    const std::optional<Residuals> at_fit = least_squares.residuals(least_squares.start);
    if (!at_fit) {
        return;
    }
    const double least = at_fit->value.squaredNorm();
    for (std::size_t j = 0; j < result.fitted.size(); ++j) {
        Fitted& one = result.fitted[j];
        const auto number = static_cast<Eigen::Index>(j);
        const double step =
            std::isfinite(one.standard_deviation) ? one.standard_deviation : least_squares.scale[number];
        one.high_is_open = one.low_is_open = false;
        one.high = ProfileSide(least_squares, number, least, step).find(one.high_is_open);
        one.low = ProfileSide(least_squares, number, least, -step).find(one.low_is_open);
        one.profiled = true;
        if (one.identifiability == Identifiability::not_determined && !one.low_is_open && !one.high_is_open) {
            one.identifiability = Identifiability::determined;  // the linear interval saw no end, the profile does
        }
    }
}

}  // namespace tiretherm::diagnosis
