// SPDX-License-Identifier: BSD-3-Clause
// The tests of a fitted parameter against its prior, its bounds and its plausible range, and their sentences.
#include "diagnosis/findings/parameter_findings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/findings/finding_advice.hpp"
#include "diagnosis/findings/sensor_kind.hpp"

namespace tiretherm::diagnosis {

namespace {

using solver::FreeParameter;

constexpr double least = 2.5;
constexpr double chance_of_any = 0.05;

/// What is the matter with a parameter.
Remarks observations_of(const FreeParameter& parameter, const FittedParameter& fitted, double least_conflict,
                        const physics::PlausibleRange* range) {
    Remarks parts;
    if (fitted.at_bound) {
        parts.push_back(remark::at_bound_of_allowed());
    }
    if (const double conflict = conflict_with_prior(parameter, fitted); std::abs(conflict) > least_conflict) {
        parts.push_back((conflict > 0.0 ? remark::above_prior : remark::below_prior)(
            std::abs(conflict), parameter.prior, parameter.standard_deviation));
    }
    if (range != nullptr) {
        const double beyond = std::max(range->low - fitted.value, fitted.value - range->high);
        if (beyond > 0.0 && beyond > fitted.standard_deviation) {
            parts.push_back(remark::outside_expected(range->low, range->high, std::string(range->source)));
        }
    }
    return parts;
}

}  // namespace

double conflict_with_prior(const FreeParameter& parameter, const FittedParameter& fitted) {
    const double prior = parameter.standard_deviation;
    if (!std::isfinite(prior) || !std::isfinite(fitted.standard_deviation)) {
        return 0.0;
    }
    return (fitted.value - parameter.prior) / prior;
}

double least_conflict(std::size_t n_with_prior) {
    // The chance that one of n independent normal numbers passes z is about n erfc(z / sqrt(2)).
    const auto n = static_cast<double>(std::max<std::size_t>(n_with_prior, 1));
    double low = least;
    double high = 10.0;
    if (n * std::erfc(low / std::numbers::sqrt2) <= chance_of_any) {
        return low;
    }
    while (high - low > 1e-6) {
        const double middle = 0.5 * (low + high);
        (n * std::erfc(middle / std::numbers::sqrt2) > chance_of_any ? low : high) = middle;
    }
    return high;
}

const physics::PlausibleRange* plausible_range_of(const solver::Problem& problem, const FreeParameter& parameter,
                                                  double before) {
    const physics::PlausibleRange* range = nullptr;
    switch (parameter.kind) {
        case FreeParameter::Kind::effect: {
            const physics::ActiveEffect& active = problem.effects[parameter.effect];
            if (active.name.empty()) {
                range = physics::plausible_range(*active.effect, parameter.parameter, sensor_kind(problem, parameter));
            }
            break;
        }
        case FreeParameter::Kind::conductivity:
            range = physics::plausible_range_of_law("conductivity");
            break;
        case FreeParameter::Kind::heat_capacity:
            range = physics::plausible_range_of_law("heat_capacity");
            break;
        case FreeParameter::Kind::link_conductivity:
            range = physics::plausible_range_of_law("link_conductivity");
            break;
        case FreeParameter::Kind::input:
            break;
        case FreeParameter::Kind::initial:
            range = physics::plausible_range(*physics::find_effect("initial_temperature"), 0);
            break;
    }
    return range != nullptr && physics::is_plausible(*range, before) ? range : nullptr;
}

std::vector<ParameterFinding> parameter_findings(const input::Experiment& experiment,
                                                 const std::vector<FittedParameter>& fitted,
                                                 const std::vector<double>& before) {
    const solver::Problem& problem = experiment.runs.front().problem;
    const auto n_with_prior = std::ranges::count_if(
        experiment.parameters, [](const FreeParameter& one) { return std::isfinite(one.standard_deviation); });
    const double limit = least_conflict(static_cast<std::size_t>(n_with_prior));
    std::vector<ParameterFinding> found;
    for (std::size_t j = 0; j < fitted.size(); ++j) {
        const FreeParameter& parameter = experiment.parameters[j];
        const bool is_known = std::isfinite(fitted[j].standard_deviation);
        if (!is_known && !fitted[j].at_bound) {
            continue;
        }
        const physics::PlausibleRange* range = plausible_range_of(problem, parameter, before[j]);
        if (Remarks parts = observations_of(parameter, fitted[j], limit, range); !parts.empty()) {
            const bool is_above =
                fitted[j].value > (std::isfinite(parameter.standard_deviation) ? parameter.prior : before[j]);
            found.push_back({j, remark::parameter_is_unexpected(
                                    parameter.name, fitted[j].value, parameter.unit == "1" ? "" : " " + parameter.unit,
                                    std::move(parts), {advice(experiment, parameter, is_above, range)})});
        }
    }
    return found;
}

}  // namespace tiretherm::diagnosis
