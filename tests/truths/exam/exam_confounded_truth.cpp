// SPDX-License-Identifier: BSD-3-Clause
// Least-squares search over single causes and pairs with physical signs; the nearest few are compared again with steps
// of their own size.

#include "exam/exam_confounded_truth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "exam/exam_hiding_truth.hpp"

namespace hidden_effects {

namespace {

/// A cause, a step of it from absent, and what that leaves behind.
struct Direction {
    const Variant* variant = nullptr;
    double step = 0.0;
    Eigen::VectorXd left{};
};

/// Two causes, in parts of their directions' steps. A single cause is twice the same.
struct Fit {
    const Direction* one = nullptr;
    const Direction* other = nullptr;
    double part = 0.0;
    double other_part = 0.0;
    double apart = 0.0;  ///< standard deviations that it misses
};

bool is_possible(const Variant& variant, double step) {
    return variant.both_ways() || step * (variant.high > variant.absent ? 1.0 : -1.0) > 0.0;
}

/// The sizes that leave least of the target, by least squares. @returns nothing where they are the wrong way round
std::optional<Fit> best_fit(const Direction& one, const Direction& other, const Eigen::VectorXd& target) {
    Fit fit{.one = &one, .other = &other};
    if (&one == &other) {
        fit.part = one.left.dot(target) / one.left.squaredNorm();
    } else {
        const double both = one.left.dot(other.left);
        Eigen::Matrix2d G;
        G << one.left.squaredNorm(), both, both, other.left.squaredNorm();
        const Eigen::Vector2d parts = G.inverse() * Eigen::Vector2d(one.left.dot(target), other.left.dot(target));
        fit.part = parts[0];
        fit.other_part = parts[1];
        if (!is_possible(*other.variant, fit.other_part * other.step)) {
            return std::nullopt;
        }
    }
    fit.apart = (target - fit.part * one.left - fit.other_part * other.left).norm();
    return is_possible(*one.variant, fit.part * one.step) ? std::optional(fit) : std::nullopt;
}

bool is_truth(const ExamDataSet& data_set, const Fit& fit) {
    const auto hides = [&](const Direction& direction) {
        return std::ranges::any_of(data_set.hidden, [&](const Cause& cause) {
            return name_of(cause) == direction.variant->name() && cause.parameters.contains(direction.variant->key);
        });
    };
    return hides(*fit.one) && hides(*fit.other) && (fit.one != fit.other) == (data_set.hidden.size() == 2);
}

}  // namespace

std::optional<ConfoundedHypothesis> nearest_confounded(const ExamDataSet& data_set) {
    const auto direction = [&](const Variant& variant, double step) {
        const double furthest = std::clamp(step, variant.low - variant.absent, variant.high - variant.absent);
        return Direction{.variant = &variant, .step = furthest, .left = left_beside(data_set, variant, furthest)};
    };
    std::vector<Direction> directions;
    for (const Variant& variant : *data_set.runs.rig->variants) {
        Direction typical = direction(variant, variant.typical);
        if (typical.left.norm() > 1e-3) {
            directions.push_back(std::move(typical));
        }
    }
    std::vector<Fit> fits;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t j = i; j < directions.size(); ++j) {
            const std::optional<Fit> fit = best_fit(directions[i], directions[j], data_set.left);
            if (fit && !is_truth(data_set, *fit)) {
                fits.push_back(*fit);
            }
        }
    }
    std::ranges::sort(fits, {}, &Fit::apart);
    // Causes are nearly linear: the nearest few are compared with the target once more, with steps of their own size.
    std::optional<ConfoundedHypothesis> nearest;
    for (std::size_t i = 0; i < std::min<std::size_t>(6, fits.size()); ++i) {
        const Direction one = direction(*fits[i].one->variant, fits[i].part * fits[i].one->step);
        const bool is_single = fits[i].one == fits[i].other;
        const Direction other =
            is_single ? one : direction(*fits[i].other->variant, fits[i].other_part * fits[i].other->step);
        const std::optional<Fit> again = best_fit(one, is_single ? one : other, data_set.left);
        if (again && (!nearest || again->apart < nearest->apart)) {
            nearest = ConfoundedHypothesis{
                .name = one.variant->name() + (is_single ? "" : " + " + other.variant->name()), .apart = again->apart};
        }
    }
    return nearest;
}

}  // namespace hidden_effects
