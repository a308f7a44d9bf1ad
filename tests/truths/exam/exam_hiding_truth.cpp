// SPDX-License-Identifier: BSD-3-Clause
// Draws causes until one has a physical size at which it shows as wanted, and computes its correlation with all others.

#include "exam/exam_hiding_truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "exam/exam_signals_truth.hpp"

namespace hidden_effects {

namespace {

constexpr double least_apart = 0.9;  ///< a correlation beyond which two things are one to the exam

/// Share of all samples that are faster than a speed. @param speed km/h
double faster_than(const BenchRuns& runs, double speed) {
    double faster = 0.0;
    double all = 0.0;
    for (const RigProgramme& programme : runs.programmes) {
        for (const double V : programme.speed) {
            faster += 3.6 * V > speed ? 1.0 : 0.0;
            all += 1.0;
        }
    }
    return faster / all;
}

/// Where a standing wave begins, km/h, so that a twentieth of the samples is 10 km/h beyond; 0 where there is none.
double draw_critical_speed(const BenchRuns& runs, Random& random) {
    for (int i = 0; i < 20; ++i) {
        const double speed = std::round(random.uniform(100.0, 170.0));
        if (faster_than(runs, speed + 10.0) >= 0.05) {
            return speed;
        }
    }
    return 0.0;
}

/// A cause with the number at which it shows as wanted, and what it leaves behind.
struct Sized {
    Cause cause;
    Eigen::VectorXd left;
};

/// Draws a cause. @returns nothing, with the reason in `rejected`, where that size is not physical
std::optional<Sized> draw_cause(const Oracle& oracle, double sigma, Random& random,
                                std::vector<std::string>& rejected) {
    const std::vector<Variant>& variants = *oracle.runs().rig->variants;
    const Variant& variant =
        variants[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(variants.size())))];
    const double sign = random.uniform() < 0.5 || !variant.both_ways() ? 1.0 : -1.0;
    const bool waves = std::ranges::find(variants, "standing_wave", &Variant::id) != variants.end();
    const double critical_speed = waves ? draw_critical_speed(oracle.runs(), random) : 0.0;
    if (variant.id == "standing_wave" && critical_speed == 0.0) {
        rejected.push_back(variant.name() + ": too slow for a wave");
        return std::nullopt;
    }
    std::optional<Size> size = size_for(oracle, variant, sign, sigma, critical_speed);
    if (!size) {
        rejected.push_back(variant.name() + ": not physical at that size");
        return std::nullopt;
    }
    return Sized{.cause = cause_of(variant, size->number, critical_speed), .left = std::move(size->left)};
}

double critical_speed_of(const std::vector<Cause>& hidden) {
    for (const Cause& cause : hidden) {
        if (cause.id == "standing_wave") {
            return cause.parameters.at("critical_speed");
        }
    }
    return 140.0;
}

/// Every single cause beside what is hidden; those that do not show at all are like nothing.
std::vector<Likeness> likenesses(const ExamDataSet& data_set) {
    std::vector<Likeness> alike;
    for (const Variant& variant : *data_set.runs.rig->variants) {
        if (const Likeness one = likeness(data_set, variant); one.correlation != 0.0) {
            alike.push_back(one);
        }
    }
    std::ranges::sort(alike, {}, [](const Likeness& one) { return -one.strength(); });
    return alike;
}
}  // namespace

Eigen::VectorXd left_beside(const ExamDataSet& data_set, const Variant& variant, double step) {
    return data_set.oracle_of_runs->left_by(
        {cause_of(variant, variant.absent + step, critical_speed_of(data_set.hidden))});
}

Likeness likeness(const ExamDataSet& data_set, const Variant& variant) {
    Eigen::VectorXd left = left_beside(data_set, variant, variant.typical);
    if (left.norm() < 1e-3) {
        return {.variant = &variant, .correlation = 0.0};
    }
    if (!data_set.runs.rig->costly) {
        const double room = (variant.typical > 0.0 ? variant.high : variant.low) - variant.absent;
        const double step = variant.typical * data_set.left.norm() / left.norm();
        left = left_beside(data_set, variant, std::abs(step) < std::abs(room) ? step : room);
    }
    return {.variant = &variant, .correlation = correlation(data_set.left, left)};
}

bool hide_causes(ExamDataSet& data_set, Random& random) {
    const Oracle& oracle = *data_set.oracle_of_runs;
    std::vector<Sized> drawn;
    for (std::size_t i = 0; i < (data_set.kind == Kind::pair ? 2U : 1U); ++i) {
        std::optional<Sized> one = draw_cause(oracle, data_set.sigma, random, data_set.rejected);
        if (!one) {
            return false;
        }
        drawn.push_back(std::move(*one));
    }
    Eigen::VectorXd left = drawn.front().left;
    if (drawn.size() == 2) {
        if (std::abs(correlation(left, drawn.back().left)) >= least_apart) {
            data_set.rejected.push_back(name_of(drawn[0].cause) + " and " + name_of(drawn[1].cause) + ": look alike");
            return false;
        }
        left = oracle.left_by({drawn[0].cause, drawn[1].cause});
    }
    for (const Sized& one : drawn) {
        data_set.hidden.push_back(one.cause);
        data_set.oracle.push_back(one.left.norm());
    }
    data_set.left = std::move(left);
    if (!data_set.runs.rig->costly) {
        data_set.alike = likenesses(data_set);
    }
    return true;
}

bool hide_source(ExamDataSet& data_set, Random& random) {
    HiddenSource source = draw_source(*data_set.runs.rig, data_set.kind, data_set.runs.programmes.size(), random);
    const Variant watts{.id = source.id, .key = "watts", .typical = 30.0, .high = 2000.0};
    BenchRuns driven = data_set.runs;
    driven.programmes = driven_by(source, data_set.runs.programmes);
    std::optional<Size> size = size_for(*data_set.oracle_of_runs, watts, 1.0, data_set.sigma, 0.0, &driven);
    if (!size) {
        data_set.rejected.emplace_back("a source: not physical at that size");
        return false;
    }
    data_set.left = std::move(size->left);
    std::vector<Likeness> alike = likenesses(data_set);
    if (std::abs(alike.front().correlation) >= least_apart) {
        data_set.rejected.push_back("a source: looks like " + alike.front().variant->name());
        return false;
    }
    source.watts = size->number;
    data_set.source = std::move(source);
    data_set.oracle = {data_set.left.norm()};
    data_set.alike = std::move(alike);
    return true;
}
}  // namespace hidden_effects
