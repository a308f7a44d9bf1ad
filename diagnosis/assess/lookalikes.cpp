// SPDX-License-Identifier: BSD-3-Clause
// Projects each signature on the free numbers alone and looks at what is left of it.

#include "diagnosis/assess/lookalikes.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

namespace tiretherm::diagnosis {

namespace {

constexpr double alike_from = 0.99;  // correlation
constexpr double not_seen = 2.0;     // standard deviations
constexpr std::size_t most_said = 2;

/// A free number other than a start, with its part in making up a signature.
struct NumberShare {
    Eigen::Index number = -1;
    double per_unit = 0.0;  ///< of the cause, in the number's unit
};

NumberShare largest_part(const ScoreTestData& score_data, const Eigen::VectorXd& share) {
    NumberShare part;
    double most = 0.0;
    for (Eigen::Index j = 0; j < share.size(); ++j) {
        const solver::FreeParameter& number = score_data.experiment->parameters[static_cast<std::size_t>(j)];
        const double size = std::abs(share[j]) * score_data.base.slopes.col(j).norm();
        if (number.kind != solver::FreeParameter::Kind::initial && number.runs.empty() && size > most) {
            most = size;
            part = {.number = j, .per_unit = share[j] * score_data.base.scale[j]};
        }
    }
    return part;
}

}  // namespace

std::vector<Lookalike> lookalikes_of(const ScoreTestData& score_data) {
    const Refit& base = score_data.base;
    std::vector<Lookalike> found;
    const bool is_stopped = static_cast<std::size_t>(score_data.columns.cols()) < score_data.candidates.size();
    if (base.slopes.cols() == 0 || is_stopped) {
        return found;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> numbers(base.slopes);
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        const Candidate& candidate = score_data.candidates[k];
        const auto signature = score_data.columns.col(static_cast<Eigen::Index>(k));
        if (!candidate.by_slope() || !(signature.norm() > 0.0)) {
            continue;
        }
        const Eigen::VectorXd share = numbers.solve(signature);
        const double left = (signature - base.slopes * share).norm();
        const NumberShare part = largest_part(score_data, share);
        if (part.number < 0 || part.per_unit == 0.0) {
            continue;
        }
        const solver::FreeParameter& number = score_data.experiment->parameters[static_cast<std::size_t>(part.number)];
        Lookalike one{.cause = name_of(candidate, *score_data.experiment),
                      .key = std::string(candidate.number().key),
                      .number = number.name,
                      .fitted = base.values[part.number],
                      .known = number.prior,
                      .correlation = std::sqrt(std::max(0.0, 1.0 - std::pow(left / signature.norm(), 2))),
                      .is_input = candidate.effect->input_correction() != nullptr};
        const double amplitude = (one.fitted - one.known) / part.per_unit;
        one.value = candidate.absent + amplitude;
        one.is_far = std::abs(one.fitted - one.known) > number.standard_deviation;
        const bool is_possible = one.value > candidate.low && one.value < candidate.high;
        if (is_possible && (one.correlation > alike_from || (one.is_far && std::abs(amplitude) * left < not_seen))) {
            found.push_back(std::move(one));
        }
    }
    std::ranges::stable_sort(found, [](const Lookalike& a, const Lookalike& b) {
        return a.is_input != b.is_input ? a.is_input : a.correlation > b.correlation;
    });
    return found;
}

void remark_on_lookalikes(Diagnosis& into) {
    std::size_t said = 0;
    for (const Lookalike& one : into.cannot_see) {
        if (into.verdict == Verdict::consistent && one.is_input && one.is_far && said < most_said) {
            into.remarks.push_back(
                remark::looks_like_number(one.cause, one.key, one.value, one.number, one.fitted, one.known));
            ++said;
        }
    }
}

}  // namespace tiretherm::diagnosis
