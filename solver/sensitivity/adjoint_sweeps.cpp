// Tangent and adjoint sweeps through the steps of a record.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "solver/sensitivity/adjoint_record.hpp"

namespace tiretherm::solver {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void AdjointRecord::linearise(const Step& step) {
    System& system = stepper_.system();
    const std::size_t stages = step.T.size();
    now_.s = step.dt * stepper_.method().diagonal;
    now_.J.resize(stages);
    now_.slopes.resize(stages);
    now_.capacity.assign(stages, std::vector<double>(n_));
    for (std::size_t i = 0; i < stages; ++i) {
        system.evaluate(step.T[i], step.coefficients[i]);
        system.matrices(now_.s, false, now_.A, now_.J[i]);
        // The outer products point into the terms, which the next stage overwrites.
        now_.slopes[i] = system.terms().region_slope;
        for (Matrix::Outer& outer : now_.J[i].outer) {
            const auto offset = outer.row.data() - system.terms().region_slope.data();
            outer.row = std::span(now_.slopes[i]).subspan(static_cast<std::size_t>(offset), n_);
        }
        for (std::size_t k = 0; k < n_; ++k) {
            now_.capacity[i][k] = system.has_capacity(k) ? system.capacity(k, step.T[i][k]) : 0.0;
        }
    }
    if (const std::string wrong = factor_->factorise(now_.A); !wrong.empty()) {
        status_ = {Outcome::not_positive_definite, wrong};
    }
}

void AdjointRecord::solve(BlockSolver& solver, const Matrix& J, std::span<const double> B, std::span<double> X,
                          double tolerance, std::size_t step) {
    if (!solver.solve(J, *factor_, B, X, tolerance).converged) {
        status_ = {Outcome::not_converged,
                   fmt::format("the answers to heat did not converge at t = {:.6g} s", end(step))};
    }
}

/// Surfaces without capacity: J_ss x_s = scale right_s - J_sc x_c, by the diagonal of J_ss, which has little beside it.
/// J is that of the explicit stage, or its transpose. @param x, right, product [n_columns][n_nodes]
void AdjointRecord::settle_surfaces(std::span<double> x, std::span<const double> right, double scale,
                                    std::span<double> product) {
    const Matrix& J = now_.J.front();
    const System& system = stepper_.system();
    for (int iteration = 0; iteration < 60; ++iteration) {
        J.multiply_block(x, product, x.size() / n_);
        bool settled = true;
        for (std::size_t first = 0; first < x.size(); first += n_) {
            double change = 0.0;
            double largest = 0.0;
            for (std::size_t i = 0; i < n_; ++i) {
                if (!system.has_capacity(i)) {
                    const double by =
                        (scale * right[first + i] - product[first + i]) / J.value[at(J.pattern->diagonal[i])];
                    x[first + i] += by;
                    change = std::max(change, std::abs(by));
                    largest = std::max(largest, std::abs(x[first + i]));
                }
            }
            settled = settled && change <= 1e-15 * largest;
        }
        if (settled) {
            return;
        }
    }
}

/// The same backwards: w_s = J_ss^-T adjoint_s goes to the heat and, through J_sc, to the cells.
/// @param adjoint, heat, w, product [n_sums][n_nodes]
void AdjointRecord::settle_surfaces_back(std::span<double> adjoint, std::span<double> heat, std::span<double> w,
                                         std::span<double> product) {
    Matrix& J = now_.J.front();
    const System& system = stepper_.system();
    J.transposed = true;
    std::ranges::fill(w, 0.0);
    settle_surfaces(w, adjoint, 1.0, product);
    J.multiply_block(w, product, adjoint.size() / n_);
    J.transposed = false;
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

std::vector<double> AdjointRecord::forward(std::size_t n_heats, const Heats& heats, double tolerance) {
    const Tableau& method = stepper_.method();
    const System& system = stepper_.system();
    const std::size_t stages = at(method.stages);
    const std::size_t all = n_heats * n_;
    const std::size_t channels = places_.size();
    BlockSolver solver(static_cast<int>(n_), n_heats);
    std::vector<double> answer(n_heats * n_samples_);
    std::vector<std::vector<double>> S(stages, std::vector<double>(all));
    std::vector<std::vector<double>> dq(stages, std::vector<double>(all));
    std::vector<double> heat(all);
    std::vector<double> known(all);
    std::vector<double> right(all);
    std::vector<double> lagged(n_heats * channels);
    const auto read = [&](const SensorOutputs::Form& form, std::size_t channel, std::size_t h) {
        double value = form.lagged * lagged[h * channels + channel];
        for (std::size_t i = 0; i < stages; ++i) {
            value += form.stage[i] * places_[channel](std::span(S[i]).subspan(h * n_, n_));
        }
        return value;
    };
    for (std::size_t k = 0; k < steps_.size() && status_.ok(); ++k) {
        const Step& step = steps_[k];
        linearise(step);
        heats(k, heat);
        std::swap(S.front(), S.back());
        settle_surfaces(S[0], heat, now_.s, right);
        now_.J[0].multiply_block(S[0], right, n_heats);
        for (std::size_t i = 0; i < n_; ++i) {
            const bool moves = system.has_capacity(i);
            for (std::size_t at = i; at < all; at += n_) {
                dq[0][at] = moves ? (now_.capacity[0][i] * S[0][at] - right[at]) / now_.s + heat[at] : 0.0;
            }
        }
        for (std::size_t stage = 1; stage < stages; ++stage) {
            const std::vector<double>& capacity = now_.capacity[stage];
            for (std::size_t first = 0; first < all; first += n_) {
                for (std::size_t i = 0; i < n_; ++i) {
                    known[first + i] = now_.capacity[0][i] * S[0][first + i];
                }
            }
            for (std::size_t j = 0; j < stage; ++j) {
                const double weight = step.dt * method.a[stage][j];
                for (std::size_t i = 0; i < all; ++i) {
                    known[i] += weight * dq[j][i];
                }
            }
            for (std::size_t i = 0; i < all; ++i) {
                right[i] = known[i] + now_.s * heat[i];
            }
            S[stage] = S[stage - 1];
            solve(solver, now_.J[stage], right, S[stage], tolerance, k);
            for (std::size_t first = 0; first < all; first += n_) {
                for (std::size_t i = 0; i < n_; ++i) {
                    dq[stage][first + i] = (capacity[i] * S[stage][first + i] - known[first + i]) / now_.s;
                }
            }
        }
        for (std::size_t r = first_sample_[k]; r < first_sample_[k + 1]; ++r) {
            const OutputSample& sample = samples_[r];
            for (std::size_t h = 0; h < n_heats; ++h) {
                answer[h * n_samples_ + sample.place] += read(sample.form, sample.channel, h);
            }
        }
        for (std::size_t h = 0; h < n_heats; ++h) {
            for (std::size_t c = 0; c < channels; ++c) {
                lagged[h * channels + c] = read(step.carry[c], c, h);
            }
        }
    }
    return answer;
}

void AdjointRecord::backward(std::size_t n_sums, std::span<const double> weights, const Slopes& slopes,
                             double tolerance) {
    const Tableau& method = stepper_.method();
    const System& system = stepper_.system();
    const std::size_t stages = at(method.stages);
    const std::size_t all = n_sums * n_;
    const std::size_t channels = places_.size();
    BlockSolver solver(static_cast<int>(n_), n_sums);
    std::vector<double> heat(all);
    std::vector<std::vector<double>> of_S(stages, std::vector<double>(all));
    std::vector<std::vector<double>> of_dq(stages, std::vector<double>(all));
    std::vector<double> of_end(all);  // of the state at the end of the step
    std::vector<double> of_begin(all);
    std::vector<std::vector<double>> z(stages, std::vector<double>(all));
    std::vector<double> product(all);
    std::vector<double> lagged(n_sums * channels);
    std::vector<double> lagged_before(n_sums * channels);
    const auto read = [&](const SensorOutputs::Form& form, std::size_t channel, std::size_t sum, double weight) {
        lagged_before[sum * channels + channel] += form.lagged * weight;
        const mesh::Functional& place = places_[channel];
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t m = 0; m < place.nodes.size(); ++m) {
                of_S[i][sum * n_ + at(place.nodes[m])] += form.stage[i] * weight * place.weights[m];
            }
        }
    };
    for (std::size_t k = steps_.size(); k-- > 0 && status_.ok();) {
        const Step& step = steps_[k];
        linearise(step);
        std::ranges::fill(heat, 0.0);
        for (std::size_t i = 0; i < stages; ++i) {
            std::ranges::fill(of_S[i], 0.0);
            std::ranges::fill(of_dq[i], 0.0);
        }
        std::ranges::fill(lagged_before, 0.0);
        for (std::size_t sum = 0; sum < n_sums; ++sum) {
            for (std::size_t c = 0; c < channels; ++c) {
                read(step.carry[c], c, sum, lagged[sum * channels + c]);
            }
            for (std::size_t r = first_sample_[k]; r < first_sample_[k + 1]; ++r) {
                const OutputSample& sample = samples_[r];
                read(sample.form, sample.channel, sum, weights[sum * n_samples_ + sample.place]);
            }
        }
        lagged = lagged_before;
        std::ranges::fill(of_begin, 0.0);
        for (std::size_t i = 0; i < all; ++i) {
            of_S[stages - 1][i] += of_end[i];
        }
        for (std::size_t stage = stages - 1; stage > 0; --stage) {
            for (std::size_t first = 0; first < all; first += n_) {
                for (std::size_t i = 0; i < n_; ++i) {
                    of_S[stage][first + i] += now_.capacity[stage][i] * of_dq[stage][first + i] / now_.s;
                }
            }
            Matrix& J = now_.J[stage];
            J.transposed = true;
            solve(solver, J, of_S[stage], z[stage], tolerance, k);  // from that of the step after
            J.transposed = false;
            for (std::size_t first = 0; first < all; first += n_) {
                for (std::size_t i = 0; i < n_; ++i) {
                    const std::size_t at = first + i;
                    const double of_known = z[stage][at] - of_dq[stage][at] / now_.s;
                    heat[at] += now_.s * z[stage][at];
                    of_begin[at] += now_.capacity[0][i] * of_known;
                    for (std::size_t j = 0; j < stage; ++j) {
                        of_dq[j][at] += step.dt * method.a[stage][j] * of_known;
                    }
                }
            }
        }
        // The explicit stage: dq = dq/dT S + f in the cells, 0 at surfaces; S of the cells that of the step's begin.
        for (std::size_t first = 0; first < all; first += n_) {
            for (std::size_t i = 0; i < n_; ++i) {
                of_dq[0][first + i] = system.has_capacity(i) ? of_dq[0][first + i] : 0.0;
                heat[first + i] += of_dq[0][first + i];
            }
        }
        now_.J[0].transposed = true;
        now_.J[0].multiply_block(of_dq[0], product, n_sums);
        now_.J[0].transposed = false;
        for (std::size_t first = 0; first < all; first += n_) {
            for (std::size_t i = 0; i < n_; ++i) {
                of_S[0][first + i] +=
                    (now_.capacity[0][i] * of_dq[0][first + i] - product[first + i]) / now_.s + of_begin[first + i];
            }
        }
        settle_surfaces_back(of_S[0], heat, of_end, product);
        of_end = of_S[0];
        slopes(k, heat);
    }
}

}  // namespace tiretherm::solver
