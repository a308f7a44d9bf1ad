// SPDX-License-Identifier: BSD-3-Clause
// The tangent of the steps of a record, several groups of heats at the same time.
#include <algorithm>
#include <string>
#include <utility>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
#include "solver/sensitivity/adjoint_record.hpp"
#include "solver/sensitivity/stage_guess.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::solver {

/// The tangent of the steps of a record for some heats that stand together: several such sweeps take a step at the
/// same time. All but the first have a factor of their own.
class AdjointRecord::ForwardSweep {
public:
    /// @param first, n_heats of the heats
    ForwardSweep(const AdjointRecord& record, std::size_t first, std::size_t n_heats, double tolerance)
        : record_(&record),
          first_(first),
          n_(record.n_),
          tolerance_(tolerance),
          solver_(static_cast<int>(n_)),
          settling_(record.stepper_.system()),
          factor_(first > 0 ? record.factor_->alike() : nullptr),
          lagged_(n_heats * record.places_.size()) {
        const std::size_t all = n_heats * n_;
        const std::size_t stages = at(record.stepper_.method().stages);
        for (std::vector<std::vector<double>>* blocks : {&S_, &dq_}) {
            blocks->assign(stages, std::vector<double>(all));
        }
        for (std::vector<double>* block : {&before_, &known_, &right_}) {
            block->resize(all);
        }
    }

    /// Of the step that is linearised. @param all_heat [all heats][n_nodes] W  @param answer adds what the outputs read
    void take_step(std::size_t k, std::span<const double> all_heat, std::span<double> answer) {
        const std::span<const double> heat = all_heat.subspan(first_ * n_, right_.size());
        n_begun_ = std::max(n_begun_, begun(heat));
        if (n_begun_ == 0 || !status_.ok()) {
            return;
        }
        before_ = S_[S_.size() - 2];
        S_.front() = S_.back();
        take_explicit_stage(heat);
        Factor& factor = factor_ ? *factor_ : *record_->factor_;
        if (factor_) {
            if (std::string wrong = factor_->factorise_again(record_->factor_->values()); !wrong.empty()) {
                status_ = {Outcome::not_positive_definite, std::move(wrong)};
            }
        }
        for (std::size_t stage = 1; stage < S_.size() && status_.ok(); ++stage) {
            take_implicit_stage(stage, k, heat, factor);
        }
        read_outputs(k, answer);
    }

    [[nodiscard]] const Status& status() const { return status_; }

private:
    /// @returns the number of the last heat that is not zero, counted from 1
    [[nodiscard]] std::size_t begun(std::span<const double> heat) const {
        std::size_t i = heat.size();
        while (i > 0 && heat[i - 1] == 0.0) {
            --i;
        }
        return (i + n_ - 1) / n_;
    }

    void take_explicit_stage(std::span<const double> heat) {
        const System& system = record_->stepper_.system();
        const Operator& now = record_->now_;
        const std::size_t all = n_begun_ * n_;
        const double per_s = 1.0 / now.s;
        status_ = settling_.settle(now.J.front(), heat, now.s, of_surfaces(tolerance_), std::span(S_[0]).first(all));
        now.J[0].multiply_block(S_[0], right_, n_begun_);
        for (std::size_t first = 0; first < all; first += n_) {
            for (std::size_t i = 0; i < n_; ++i) {
                const std::size_t at = first + i;
                const double flow = per_s * (now.capacity[0][i] * S_[0][at] - right_[at]) + heat[at];
                dq_[0][at] = system.has_capacity(i) ? flow : 0.0;
            }
        }
    }

    void take_implicit_stage(std::size_t stage, std::size_t k, std::span<const double> heat, Factor& factor) {
        const Tableau& method = record_->stepper_.method();
        const Operator& now = record_->now_;
        const double dt = record_->steps_[k].dt;
        const std::size_t all = n_begun_ * n_;
        for (std::size_t first = 0; first < all; first += n_) {
            for (std::size_t i = 0; i < n_; ++i) {
                known_[first + i] = now.capacity[0][i] * S_[0][first + i];
            }
        }
        for (std::size_t j = 0; j < stage; ++j) {
            const double weight = dt * method.a[stage][j];
            for (std::size_t i = 0; i < all; ++i) {
                known_[i] += weight * dq_[j][i];
            }
        }
        for (std::size_t i = 0; i < all; ++i) {
            right_[i] = known_[i] + now.s * heat[i];
        }
        guess_stage(method, static_cast<int>(stage), dt, k > 0 ? record_->steps_[k - 1].dt : 0.0, S_, before_);
        const double per_s = 1.0 / now.s;
        status_ = record_->solve(solver_, factor, now.J[stage], right_, std::span(S_[stage]).first(all), tolerance_, k);
        for (std::size_t first = 0; first < all; first += n_) {
            for (std::size_t i = 0; i < n_; ++i) {
                const double stored = now.capacity[stage][i] * S_[stage][first + i];
                dq_[stage][first + i] = per_s * (stored - known_[first + i]);
            }
        }
    }

    void read_outputs(std::size_t k, std::span<double> answer) {
        const std::size_t channels = record_->places_.size();
        const auto read = [&](const SensorOutputs::Form& form, std::size_t channel, std::size_t h) {
            double value = form.lagged * lagged_[h * channels + channel];
            for (std::size_t i = 0; i < S_.size(); ++i) {
                value += form.stage[i] * record_->places_[channel](std::span(S_[i]).subspan(h * n_, n_));
            }
            return value;
        };
        for (std::size_t r = record_->first_sample_[k]; r < record_->first_sample_[k + 1]; ++r) {
            const OutputSample& sample = record_->samples_[r];
            for (std::size_t h = 0; h < n_begun_; ++h) {
                answer[(first_ + h) * record_->n_samples_ + sample.place] += read(sample.form, sample.channel, h);
            }
        }
        for (std::size_t h = 0; h < n_begun_; ++h) {
            for (std::size_t c = 0; c < channels; ++c) {
                lagged_[h * channels + c] = read(record_->steps_[k].carry[c], c, h);
            }
        }
    }

    const AdjointRecord* record_;
    std::size_t first_;
    std::size_t n_;
    double tolerance_;
    Status status_;
    BlockSolver solver_;
    SurfaceSettling settling_;
    std::unique_ptr<Factor> factor_;  ///< null: the record's
    std::size_t n_begun_ = 0;         ///< heats that have been other than zero, and all before them
    std::vector<double> lagged_;      ///< [n_heats][n_channels] what lagging sensors gave at the end of the step
    // Blocks [n_heats][n_nodes], those of a stage each [stages].
    std::vector<std::vector<double>> S_;
    std::vector<std::vector<double>> dq_;
    std::vector<double> before_;
    std::vector<double> known_;
    std::vector<double> right_;
};

std::vector<double> AdjointRecord::forward(std::size_t n_heats, const Heats& heats, double tolerance) {
    // By their number alone, so that the digits are the same for any number of threads.
    constexpr std::size_t of_sweep = 6 * panel_width;
    constexpr std::size_t most_sweeps = 8;
    // An incomplete factor is not copied.
    const std::size_t n_sweeps = factor_->is_exact() ? std::clamp<std::size_t>(n_heats / of_sweep, 1, most_sweeps) : 1;
    const std::size_t panels = (n_heats + panel_width - 1) / panel_width;
    std::vector<ForwardSweep> sweeps;
    for (std::size_t i = 0; i < n_sweeps; ++i) {
        const std::size_t first = i * panels / n_sweeps * panel_width;
        const std::size_t last = std::min(n_heats, (i + 1) * panels / n_sweeps * panel_width);
        sweeps.emplace_back(*this, first, last - first, tolerance);
    }
    std::vector<double> answer(n_heats * n_samples_);
    std::vector<double> heat(n_heats * n_);
    for (std::size_t k = 0; k < steps_.size() && status_.ok(); ++k) {
        leave_if_stopped();
        linearise(steps_[k]);
        if (!status_.ok()) {
            break;
        }
        heats(k, heat);
        in_parallel(n_sweeps, [&](std::size_t i) { sweeps[i].take_step(k, heat, answer); });
        for (const ForwardSweep& sweep : sweeps) {
            note(sweep.status());
        }
    }
    return answer;
}

}  // namespace tiretherm::solver
