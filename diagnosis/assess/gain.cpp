// SPDX-License-Identifier: BSD-3-Clause
// Cross-validation of the extended model over held-out runs or blocks: share of the removable error removed, with a
// block-bootstrap interval (Kuensch, Ann. Statist. 17 (1989) 1217), and e-values.

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/fit/linearised_model.hpp"

namespace tiretherm::diagnosis {

namespace {

/// What takes no part, and what the rest is.
struct Fold {
    RowIndices test;
    RowIndices rest;
    int run = -1;  ///< whose start is fitted to the test itself; -1: to the rest
};

/// Each run once; of a single run, each of its quarters, with a gap of a twentieth of the run between it and the rest.
std::vector<Fold> folds_of(const Observations& observations) {
    const std::size_t n_runs = observations.times.size();
    std::vector<Fold> folds(n_runs > 1 ? n_runs : 4);
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        const Observations::Row& what = observations.rows[row];
        const std::vector<double>& times = observations.times[what.run];
        const double length = times.back() - times.front();
        for (std::size_t f = 0; f < folds.size(); ++f) {
            bool is_test = what.run == f;
            bool is_rest = !is_test;
            if (n_runs == 1) {
                const double share = length > 0.0 ? (times[what.time] - times.front()) / length : 0.0;
                const double from = 0.25 * static_cast<double>(f);
                is_test = share >= from && (share < from + 0.25 || f == 3);
                is_rest = share < from - 0.05 || share > from + 0.30;
            }
            if (is_test) {
                folds[f].test.push_back(static_cast<Eigen::Index>(row));
            } else if (is_rest) {
                folds[f].rest.push_back(static_cast<Eigen::Index>(row));
            }
        }
    }
    for (std::size_t f = 0; n_runs > 1 && f < folds.size(); ++f) {
        folds[f].run = static_cast<int>(f);
    }
    return folds;
}

/// Log of the e-value of a size that others gave, on rows that took no part: exp(a U - a^2 I / 2) has mean 1 where the
/// cause is absent, whatever the free numbers are.
double log_e_value(const ScoreTestData& score_data, const Eigen::VectorXd& signature, double size,
                   const RowIndices& test) {
    const Refit& base = score_data.base;
    const NuisanceProjector projector(base.slopes(test, Eigen::all), base.precision);
    const Eigen::VectorXd left = projector.project(base.residual(test), base.known);
    const Eigen::VectorXd column = projector.project(Eigen::MatrixXd(signature(test))).col(0);
    return size * column.dot(left) - 0.5 * size * size * column.squaredNorm();
}

/// Squared errors over sigma^2, sample by sample, beyond those of the extended model fitted to everything: what is noise is
/// the same in all of them and falls out.
struct Losses {
    std::vector<double> before;
    std::vector<double> after;
};

/// 1 - after / before with its interval, by drawing blocks of samples with replacement (Kuensch,
/// Ann. Statist. 17 (1989) 1217); each block is as long as the noise takes to be forgotten many times.
void find_share(const Losses& losses, std::size_t block, Gain& gain) {
    const std::size_t n = losses.before.size();
    const std::size_t n_blocks = std::max<std::size_t>(1, n / block);
    std::vector<double> before(n_blocks);
    std::vector<double> after(n_blocks);
    for (std::size_t b = 0; b < n_blocks; ++b) {
        for (std::size_t i = b * n / n_blocks; i < (b + 1) * n / n_blocks; ++i) {
            before[b] += losses.before[i];
            after[b] += losses.after[i];
        }
    }
    const auto share = [&](const auto& pick) {
        double sum_before = 0.0;
        double sum_after = 0.0;
        for (std::size_t b = 0; b < n_blocks; ++b) {
            const std::size_t which = pick(b);
            sum_before += before[which];
            sum_after += after[which];
        }
        return 1.0 - sum_after / sum_before;
    };
    gain.removable_removed = share([](std::size_t b) { return b; });
    std::mt19937_64 engine(1989);
    std::vector<double> drawn;
    for (int draw = 0; draw < 1000; ++draw) {
        drawn.push_back(share([&](std::size_t /*b*/) { return static_cast<std::size_t>(engine() % n_blocks); }));
    }
    std::ranges::sort(drawn);
    gain.low = drawn[25];
    gain.high = drawn[974];
}

/// Which unknown number the extension adds, chosen and sized from some of the runs alone.
struct Trained {
    LinearisedModel model;
    Eigen::VectorXd step;       ///< [n] of the model's numbers
    Eigen::VectorXd signature;  ///< [n_rows] whitened, of what was chosen
    double size = 0.0;
};

/// The extension that these rows alone would have chosen: the hypothesis itself where it is still the best of its kind,
/// otherwise the best signature at the base model.
Trained train(const DiagnosisState& found, const LinearisedModel& base, const LinearisedModel& extended,
              const RowIndices& rows) {
    const ScoreTestData& score_data = found.score_data;
    const Refit& fit = score_data.base;
    const NuisanceProjector projector(fit.slopes(rows, Eigen::all), fit.precision);
    const Eigen::VectorXd left = projector.project(fit.residual(rows), fit.known);
    const auto best_of = [&](const Eigen::MatrixXd& columns, const Eigen::VectorXi* sign) {
        const Eigen::MatrixXd some = columns(rows, Eigen::all);
        const Scores scores = score(projector.project(some), left, some.colwise().norm());
        Eigen::Index best = 0;
        double most = 0.0;
        for (Eigen::Index k = 0; k < scores.z.size(); ++k) {
            const double z = admitted(scores.z[k], sign != nullptr ? (*sign)[k] : 0);
            if (z > most) {
                most = z;
                best = k;
            }
        }
        return best;
    };
    const bool unknown = found.verdict == Verdict::unknown;
    const FittedHypothesis& best = *found.best();
    const Eigen::MatrixXd& columns = unknown ? score_data.unknown_columns : score_data.columns;
    const Eigen::Index chosen = best_of(columns, unknown ? nullptr : &score_data.sign);
    const std::size_t ours = unknown ? found.unknown.term : best.candidates.front();
    const bool same =
        unknown ? static_cast<std::size_t>(chosen) == ours
                : best.candidates.size() > 1 || score_data.candidates[static_cast<std::size_t>(chosen)].cause ==
                                                    score_data.candidates[ours].cause;
    Trained trained;
    const Eigen::Index n = fit.values.size();
    if (same) {
        trained.model = extended;
        trained.step = solve(extended, rows);
        trained.signature = extended.slopes.col(n);
        const double absent = unknown ? 0.0 : score_data.candidates[ours].absent;
        trained.size = (best.fit.values[n] - absent) / best.fit.scale[n] + trained.step[n];
    } else {
        const Eigen::MatrixXd& raw = unknown ? score_data.unknowns.columns : score_data.signatures;
        trained.model = with_column(base, columns.col(chosen), raw.col(chosen));
        trained.step = solve(trained.model, rows);
        trained.signature = columns.col(chosen);
        trained.size = trained.step[n];
    }
    return trained;
}

}  // namespace

void measure_gain(const DiagnosisState& found, Diagnosis& into) {
    const ScoreTestData& score_data = found.score_data;
    const Observations& observations = *score_data.observations;
    const std::size_t n_noises = observations.channels.size();
    const FittedHypothesis* best = found.best();
    const auto n_rows = static_cast<std::size_t>(observations.measured.size());
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<int> noise_of(n_rows, -1);
    for (const Block& block : observations.blocks) {
        for (Eigen::Index i = block.first; i < block.first + block.rows(); ++i) {
            noise_of[static_cast<std::size_t>(i)] = block.channel;
        }
    }
    const auto rms = [&](const Eigen::VectorXd& left, std::size_t noise) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t row = 0; row < n_rows; ++row) {
            if (noise_of[row] == static_cast<int>(noise) && std::isfinite(left[static_cast<Eigen::Index>(row)])) {
                sum += left[static_cast<Eigen::Index>(row)] * left[static_cast<Eigen::Index>(row)];
                ++count;
            }
        }
        return count > 0 ? std::sqrt(sum / count) : none;
    };
    Eigen::VectorXd before = Eigen::VectorXd::Constant(observations.measured.size(), none);
    Eigen::VectorXd after = before;
    if (best != nullptr && n_noises > 0) {
        const LinearisedModel base = linearise(score_data.base, observations);
        const LinearisedModel extended = linearise(best->fit, observations);
        std::vector<double> log_e;
        for (const Fold& fold : folds_of(observations)) {
            const auto& [test, rest, run] = fold;
            if (test.empty() || rest.empty()) {
                continue;
            }
            const Trained trained = train(found, base, extended, rest);
            std::vector<bool> own(static_cast<std::size_t>(trained.model.slopes.cols()), false);
            for (std::size_t j = 0; j < score_data.experiment->parameters.size(); ++j) {
                own[j] = run >= 0 && score_data.experiment->parameters[j].run == run;
            }
            after(test) = left_of(trained.model, trained.step, test, own);
            own.resize(static_cast<std::size_t>(base.slopes.cols()));
            before(test) = left_of(base, solve(base, rest), test, own);
            log_e.push_back(log_e_value(score_data, trained.signature, trained.size, test));
        }
        Losses losses;
        double longest = 1.0;
        for (std::size_t row = 0; row < n_rows; ++row) {
            const auto i = static_cast<Eigen::Index>(row);
            if (noise_of[row] >= 0 && std::isfinite(before[i])) {
                const Noise& noise = score_data.noise.channels[static_cast<std::size_t>(noise_of[row])];
                const double least = std::pow(observations.measured[i] - into.extended[i], 2);
                losses.before.push_back((before[i] * before[i] - least) / (noise.sigma * noise.sigma));
                losses.after.push_back((after[i] * after[i] - least) / (noise.sigma * noise.sigma));
                longest = std::max(longest, noise.correlation_time);
            }
        }
        if (!losses.before.empty()) {
            const Observations::Row& first = observations.rows.front();
            const std::vector<double>& times = observations.times[first.run];
            const double interval =
                times.size() > 1 ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 1.0;
            const auto block = static_cast<std::size_t>(std::max(10.0, 10.0 * longest / interval));
            into.gain.measured = true;
            into.gain.within_run = observations.times.size() == 1;
            find_share(losses, block, into.gain);
            // The folds share their training runs: the mean of e-values is one, their product is not.
            const double most = *std::ranges::max_element(log_e);
            double sum = 0.0;
            for (const double one : log_e) {
                sum += std::exp(one - most);
            }
            into.gain.log_e = most + std::log(sum / static_cast<double>(log_e.size()));
            into.gain.confirmed = into.gain.log_e >= std::log(100.0);
        }
    }
    for (std::size_t c = 0; c < n_noises; ++c) {
        into.channels.push_back({.channel = observations.channels[c],
                                 .rmse_before = rms(observations.measured - into.base, c),
                                 .rmse_after = rms(observations.measured - into.extended, c),
                                 .heldout_before = rms(before, c),
                                 .heldout_after = rms(after, c)});
    }
}

}  // namespace tiretherm::diagnosis
