// SPDX-License-Identifier: BSD-3-Clause
// Chooses the factor of the nearest step length; replaces the one of the same length, or the one longest out of use.

#include "solver/time_integration/kept_factors.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

/// Above this many nodes one factor is kept: four would cost more memory than they save time.
constexpr int most_nodes_of_four = 50000;
constexpr std::size_t most_kept = 4;
/// While steps only grow, the factors of the shorter ones would not be used again: their memory is.
constexpr std::size_t most_growing = 2;
/// Step lengths nearer than this share one factor. Ratio
constexpr double alike = 1.3;
/// What an evaluation of all effects costs, in solves.
constexpr double solves_of_an_evaluation = 1.0;

double distance(double a, double b) { return std::abs(std::log(a / b)); }

}  // namespace

KeptFactors::KeptFactors(const Pattern& pattern, LinearSolver wanted) : pattern_(&pattern), kept_(1) {
    kept_.front().factor = make_factor(pattern, wanted);
    kept_.resize(kept_.front().factor->is_exact() && pattern.n <= most_nodes_of_four ? most_kept : 1);
    now_ = &kept_.front();
}

void KeptFactors::make_current(Kept& kept) {
    now_ = &kept;
    kept.last_used = ++uses_;
}

bool KeptFactors::select(double s) {
    Kept* best = nullptr;
    for (Kept& kept : kept_) {
        if (reaches(kept, s) && (best == nullptr || distance(kept.s, s) < distance(best->s, s))) {
            best = &kept;
        }
    }
    if (best == nullptr) {
        return false;
    }
    alternates_ = alternates_ || best != now_;
    make_current(*best);
    return true;
}

void KeptFactors::count_solves(int solves) {
    now_->least_solves = now_->least_solves == 0 ? std::max(1, solves) : now_->least_solves;
    now_->excess_solves += std::max(0, solves - now_->least_solves);
}

void KeptFactors::count_corrections(int corrections) {
    now_->least_corrections = now_->least_corrections == 0 ? std::max(1, corrections) : now_->least_corrections;
    now_->excess_solves += (1.0 + solves_of_an_evaluation) * std::max(0, corrections - now_->least_corrections);
}

std::string KeptFactors::renew(const Matrix& A, double s, std::span<const double> compliance) {
    const auto is_alike = [s](const Kept& kept) { return kept.s > 0.0 && distance(kept.s, s) < std::log(alike); };
    auto place = std::ranges::find_if(kept_, is_alike);
    if (place == kept_.end()) {
        const auto in_use =
            static_cast<std::ptrdiff_t>(alternates_ ? kept_.size() : std::min(kept_.size(), most_growing));
        place = std::ranges::min_element(kept_.begin(), kept_.begin() + in_use, {}, &Kept::last_used);
        if (kept_.size() > 1 && now_->s > 0.0) {
            now_->excess_solves = 0.0;  // it was out of its range, not too old
        }
    }
    if (!place->factor) {
        place->factor = kept_.front().factor->alike();
    }
    place->s = 0.0;
    make_current(*place);
    if (std::string problem = place->factor->factorise(A); !problem.empty()) {
        return problem;
    }
    place->s = s;
    place->compliance.resize(compliance.size());
    copy_nodes(compliance, place->compliance);
    place->least_solves = place->least_corrections = 0;
    place->excess_solves = 0.0;
    return {};
}

void KeptFactors::visit(Archive& archive) {
    archive(uses_);
    archive(reach_);
    archive(alternates_);
    long current = now_ - kept_.data();
    archive(current);
    now_ = &kept_[static_cast<std::size_t>(std::clamp(current, 0L, static_cast<long>(kept_.size()) - 1))];
    for (Kept& kept : kept_) {
        archive(static_cast<Use&>(kept));
        if (!(kept.s > 0.0)) {
            continue;
        }
        if (!kept.factor) {
            kept.factor = kept_.front().factor->alike();
        }
        kept.compliance.resize(static_cast<std::size_t>(pattern_->n));
        if (!archive.is_reading()) {
            archive.write(kept.factor->values());
            archive(kept.compliance);
            continue;
        }
        std::vector<double> values(kept.factor->values().size());
        archive(values);
        archive(kept.compliance);
        if (!kept.factor->factorise_again(values).empty()) {
            kept.s = 0.0;
        }
    }
}

}  // namespace tiretherm::solver
