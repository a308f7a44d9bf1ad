// SPDX-License-Identifier: BSD-3-Clause
// The adjoint of the steps of a record, from the last to the first.
#include <algorithm>

#include "mesh/index.hpp"
#include "solver/sensitivity/adjoint_record.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::solver {

namespace {

/// A matrix that stands for its transpose as long as this lives.
class Transposed {
public:
    explicit Transposed(Matrix& matrix) : matrix_(&matrix) { matrix_->transposed = true; }
    Transposed(const Transposed&) = delete;
    Transposed& operator=(const Transposed&) = delete;
    ~Transposed() { matrix_->transposed = false; }

    const Matrix& operator*() const { return *matrix_; }
    const Matrix* operator->() const { return matrix_; }

private:
    Matrix* matrix_;
};

}  // namespace

/// Backwards: w_s = J_ss^-T adjoint_s goes to the heat and, through J_sc, to the cells.
/// @param adjoint, heat, w, product [n_sums][n_nodes]
void AdjointRecord::settle_back(std::span<double> adjoint, std::span<double> heat, double tolerance,
                                std::span<double> w, std::span<double> product) {
    const System& system = stepper_.system();
    std::ranges::fill(w, 0.0);
    {
        const Transposed J(now_.J.front());
        note(settling_.settle(*J, adjoint, 1.0, of_surfaces(tolerance), w));
        J->multiply_block(w, product, adjoint.size() / n_);
    }
    for (std::size_t first = 0; first < w.size(); first += n_) {
        for (std::size_t i = 0; i < n_; ++i) {
            if (system.has_capacity(i)) {
                adjoint[first + i] -= product[first + i];
            } else {
                heat[first + i] += now_.s * w[first + i];
                adjoint[first + i] = 0.0;
            }
        }
    }
}

/// Every stage of a step is   J S = known + s heat   with dq = (C S - known)/s   and   known = C S_0 + dt sum a dq;   `of_x` is
/// the derivative of the weighted outputs with x.
class AdjointRecord::BackwardSweep {
public:
    BackwardSweep(AdjointRecord& record, std::size_t n_sums, double tolerance)
        : record_(&record),
          n_sums_(n_sums),
          n_(record.n_),
          tolerance_(tolerance),
          solver_(static_cast<int>(record.n_)) {
        const std::size_t all = n_sums * n_;
        const std::size_t stages = at(record.stepper_.method().stages);
        for (std::vector<std::vector<double>>* blocks : {&of_S_, &of_dq_, &z_}) {
            blocks->assign(stages, std::vector<double>(all));
        }
        for (std::vector<double>* block : {&heat_, &of_end_, &of_begin_, &product_}) {
            block->resize(all);
        }
        of_lagged_.resize(n_sums * record.places_.size());
        of_lagged_before_.resize(of_lagged_.size());
    }

    /// Takes one step back. @param weights [n_sums][n_samples] of the outputs
    /// @returns [n_sums][n_nodes] derivatives with the heat of the step, valid until the next call
    std::span<const double> step_back(std::size_t k, std::span<const double> weights) {
        const Step& step = record_->steps_[k];
        record_->linearise(step);
        weigh_outputs(k, weights);
        std::ranges::fill(heat_, 0.0);
        std::ranges::fill(of_begin_, 0.0);
        for (std::vector<double>& block : of_dq_) {
            std::ranges::fill(block, 0.0);
        }
        for (std::size_t i = 0; i < of_end_.size(); ++i) {
            of_S_.back()[i] += of_end_[i];
        }
        for (std::size_t stage = of_S_.size() - 1; stage > 0; --stage) {
            take_implicit_stage(stage, step.dt, k);
        }
        take_explicit_stage();
        of_end_ = of_S_.front();
        return heat_;
    }

private:
    /// Calls use(i, node, i of the first sum) for all entries of a block, sum by sum.
    template <typename Use>
    void for_all(const Use& use) const {
        for (std::size_t first = 0; first < n_sums_ * n_; first += n_) {
            for (std::size_t node = 0; node < n_; ++node) {
                use(first + node, node);
            }
        }
    }

    /// What the outputs of a step, and what lagging sensors carry out of it, weigh on its stages and on what lagging
    /// sensors brought into it.
    void weigh_outputs(std::size_t k, std::span<const double> weights) {
        for (std::vector<double>& block : of_S_) {
            std::ranges::fill(block, 0.0);
        }
        std::ranges::fill(of_lagged_before_, 0.0);
        const std::size_t channels = record_->places_.size();
        for (std::size_t sum = 0; sum < n_sums_; ++sum) {
            for (std::size_t c = 0; c < channels; ++c) {
                weigh_form(record_->steps_[k].carry[c], c, sum, of_lagged_[sum * channels + c]);
            }
            for (std::size_t r = record_->first_sample_[k]; r < record_->first_sample_[k + 1]; ++r) {
                const OutputSample& sample = record_->samples_[r];
                weigh_form(sample.form, sample.channel, sum, weights[sum * record_->n_samples_ + sample.place]);
            }
        }
        of_lagged_ = of_lagged_before_;
    }

    void weigh_form(const SensorOutputs::Form& form, std::size_t channel, std::size_t sum, double weight) {
        of_lagged_before_[sum * record_->places_.size() + channel] += form.lagged * weight;
        const mesh::Functional& place = record_->places_[channel];
        for (std::size_t i = 0; i < of_S_.size(); ++i) {
            for (std::size_t m = 0; m < place.nodes.size(); ++m) {
                of_S_[i][sum * n_ + at(place.nodes[m])] += form.stage[i] * weight * place.weights[m];
            }
        }
    }

    void take_implicit_stage(std::size_t stage, double dt, std::size_t k) {
        const Tableau& method = record_->stepper_.method();
        const Operator& now = record_->now_;
        std::vector<double>& of_S = of_S_[stage];
        std::vector<double>& of_dq = of_dq_[stage];
        std::vector<double>& z = z_[stage];  // starts from that of the step after
        for_all([&](std::size_t i, std::size_t node) { of_S[i] += now.capacity[stage][node] * of_dq[i] / now.s; });
        {
            const Transposed J(record_->now_.J[stage]);
            record_->note(record_->solve(solver_, *record_->factor_, *J, of_S, z, tolerance_, k));
        }
        for_all([&](std::size_t i, std::size_t node) {
            const double of_known = z[i] - of_dq[i] / now.s;
            heat_[i] += now.s * z[i];
            of_begin_[i] += now.capacity[0][node] * of_known;
            for (std::size_t j = 0; j < stage; ++j) {
                of_dq_[j][i] += dt * method.a[stage][j] * of_known;
            }
        });
    }

    /// The explicit stage: dq = dq/dT S + f in the cells, 0 at surfaces; S of the cells that of the step's begin.
    void take_explicit_stage() {
        const System& system = record_->stepper_.system();
        const Operator& now = record_->now_;
        std::vector<double>& of_dq = of_dq_.front();
        std::vector<double>& of_S = of_S_.front();
        for_all([&](std::size_t i, std::size_t node) {
            of_dq[i] = system.has_capacity(node) ? of_dq[i] : 0.0;
            heat_[i] += of_dq[i];
        });
        Transposed(record_->now_.J.front())->multiply_block(of_dq, product_, n_sums_);
        for_all([&](std::size_t i, std::size_t node) {
            of_S[i] += (now.capacity[0][node] * of_dq[i] - product_[i]) / now.s + of_begin_[i];
        });
        record_->settle_back(of_S, heat_, tolerance_, of_end_, product_);
    }

    AdjointRecord* record_;
    std::size_t n_sums_;
    std::size_t n_;
    double tolerance_;
    BlockSolver solver_;
    // Blocks [n_sums][n_nodes], those of a stage each [stages].
    std::vector<std::vector<double>> of_S_;
    std::vector<std::vector<double>> of_dq_;
    std::vector<std::vector<double>> z_;  ///< solutions of the transposed stage equations
    std::vector<double> heat_;
    std::vector<double> of_end_;    ///< of the state at the end of the step
    std::vector<double> of_begin_;  ///< of the state at its begin
    std::vector<double> product_;
    // [n_sums][n_channels]: of what lagging sensors gave at the end of the step, and at its begin.
    std::vector<double> of_lagged_;
    std::vector<double> of_lagged_before_;
};

void AdjointRecord::backward(std::size_t n_sums, std::span<const double> weights, const Slopes& slopes,
                             double tolerance) {
    BackwardSweep sweep(*this, n_sums, tolerance);
    for (std::size_t k = steps_.size(); k-- > 0 && status_.ok();) {
        leave_if_stopped();
        slopes(k, sweep.step_back(k, weights));
    }
}

}  // namespace tiretherm::solver
