#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Cholesky>

#include "diagnosis/findings.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Rows of the data, some of whose blocks are looked at.
using Rows = std::vector<Eigen::Index>;

/// Straight picture of a model: what it leaves, and how its numbers would change that.
struct Picture {
    Eigen::MatrixXd slopes;     ///< [n_rows][n] whitened
    Eigen::MatrixXd raw;        ///< [n_rows][n] SI
    Eigen::VectorXd residual;   ///< [n_rows] whitened
    Eigen::VectorXd left;       ///< [n_rows] SI, measured - simulated
    Eigen::VectorXd precision;  ///< [n]
    Eigen::VectorXd known;      ///< [n]
};

Picture picture_of(const Refit& fit, const Observations& observations) {
    return {.slopes = fit.slopes,
            .raw = fit.raw,
            .residual = fit.residual,
            .left = observations.measured - fit.simulated,
            .precision = fit.precision,
            .known = fit.known};
}

/// The picture with one more number, of a signature taken at the base model.
Picture with_column(Picture picture, const Eigen::VectorXd& whitened, const Eigen::VectorXd& raw) {
    const Eigen::Index n = picture.slopes.cols();
    picture.slopes.conservativeResize(Eigen::NoChange, n + 1);
    picture.raw.conservativeResize(Eigen::NoChange, n + 1);
    picture.slopes.col(n) = whitened;
    picture.raw.col(n) = raw;
    picture.precision.conservativeResize(n + 1);
    picture.known.conservativeResize(n + 1);
    picture.precision[n] = picture.known[n] = 0.0;
    return picture;
}

/// Least squares of some rows and of what was known.
struct Solved {
    Eigen::VectorXd step;  ///< [n] from where the picture was taken
    double gain = 0.0;     ///< log likelihood over no step
};

Solved solve(const Picture& picture, const Rows& rows, const Eigen::VectorXd& precision, const Eigen::VectorXd& pull) {
    const Eigen::MatrixXd S = picture.slopes(rows, Eigen::all);
    Eigen::MatrixXd A = S.transpose() * S;
    A.diagonal() += precision;
    const Eigen::VectorXd b = S.transpose() * picture.residual(rows) + pull;
    Eigen::VectorXd diagonal = A.diagonal();
    for (double& entry : diagonal) {
        entry = entry > 0.0 ? 1.0 / std::sqrt(entry) : 0.0;
    }
    Eigen::MatrixXd unit = diagonal.asDiagonal() * A * diagonal.asDiagonal();
    unit.diagonal().array() += 1e-9;
    Solved solved;
    solved.step = diagonal.asDiagonal() * unit.ldlt().solve(diagonal.cwiseProduct(b));
    solved.gain = 0.5 * solved.step.dot(b);
    return solved;
}

/// What takes no part, and what the rest is.
struct Fold {
    Rows test;
    Rows rest;
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

/// What is left of a run that took no part, SI: numbers of all runs as the others gave them, its own (how it started)
/// from itself.
/// @param own [n] whether a number belongs to the run
Eigen::VectorXd left_of_run(const Picture& picture, const Solved& trained, const Rows& test,
                            const std::vector<bool>& own) {
    Eigen::VectorXd step = trained.step;
    Picture there = picture;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        step[j] = own[static_cast<std::size_t>(j)] ? 0.0 : step[j];
    }
    there.residual -= picture.slopes * step;
    Eigen::VectorXd precision = picture.precision;
    Eigen::VectorXd pull = picture.precision.cwiseSqrt().cwiseProduct(picture.known);
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        if (!own[static_cast<std::size_t>(j)]) {
            precision[j] = 1e30;
            pull[j] = 0.0;
        }
    }
    const Solved settled = solve(there, test, precision, pull);
    return picture.left(test) - picture.raw(test, Eigen::all) * (step + settled.step);
}

/// Log of the e-value of a size that others gave, on rows that took no part: exp(a U - a^2 I / 2) has mean 1 where the
/// cause is absent, whatever the free numbers are.
double log_e_value(const Evidence& evidence, const Eigen::VectorXd& signature, double size, const Rows& test) {
    const Refit& base = evidence.base;
    const Remainder remainder(base.slopes(test, Eigen::all), base.precision);
    const Eigen::VectorXd left = remainder.of(base.residual(test), base.known);
    const Eigen::VectorXd column = remainder.of(Eigen::MatrixXd(signature(test))).col(0);
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
    Picture picture;
    Solved solved;
    Eigen::VectorXd signature;  ///< [n_rows] whitened, of what was chosen
    double size = 0.0;
};

/// The extension that these rows alone would have chosen: the explanation itself where it is still the best of its kind,
/// otherwise the best signature at the base model.
Trained train(const Findings& found, const Picture& base, const Picture& extended, const Rows& rows) {
    const Evidence& evidence = found.evidence;
    const Refit& fit = evidence.base;
    const Eigen::VectorXd pull = base.precision.cwiseSqrt().cwiseProduct(base.known);
    const Remainder remainder(fit.slopes(rows, Eigen::all), fit.precision);
    const Eigen::VectorXd left = remainder.of(fit.residual(rows), fit.known);
    const auto best_of = [&](const Eigen::MatrixXd& columns, const Eigen::VectorXi* sign) {
        const Eigen::MatrixXd some = columns(rows, Eigen::all);
        const Scores scores = score(remainder.of(some), left, some.colwise().norm());
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
    const Explanation& best = *found.best();
    const Eigen::MatrixXd& columns = unknown ? evidence.unknown_columns : evidence.columns;
    const Eigen::Index chosen = best_of(columns, unknown ? nullptr : &evidence.sign);
    const std::size_t ours = unknown ? found.unknown.term : best.candidates.front();
    const bool same = unknown
                          ? static_cast<std::size_t>(chosen) == ours
                          : best.candidates.size() > 1 || evidence.candidates[static_cast<std::size_t>(chosen)].cause ==
                                                              evidence.candidates[ours].cause;
    Trained trained;
    const Eigen::Index n = fit.values.size();
    if (same) {
        trained.picture = extended;
        trained.solved =
            solve(extended, rows, extended.precision, extended.precision.cwiseSqrt().cwiseProduct(extended.known));
        trained.signature = extended.slopes.col(n);
        const double absent = unknown ? 0.0 : evidence.candidates[ours].absent;
        trained.size = (best.fit.values[n] - absent) / best.fit.scale[n] + trained.solved.step[n];
    } else {
        const Eigen::MatrixXd& raw = unknown ? evidence.unknowns.columns : evidence.signatures;
        trained.picture = with_column(base, columns.col(chosen), raw.col(chosen));
        Eigen::VectorXd longer(n + 1);
        longer << pull, 0.0;
        trained.solved = solve(trained.picture, rows, trained.picture.precision, longer);
        trained.signature = columns.col(chosen);
        trained.size = trained.solved.step[n];
    }
    return trained;
}

}  // namespace

void measure_gain(const Findings& found, Diagnosis& into) {
    const Evidence& evidence = found.evidence;
    const Observations& observations = *evidence.observations;
    const std::size_t n_noises = observations.channels.size();
    const Explanation* best = found.best();
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
        const Picture base = picture_of(evidence.base, observations);
        const Picture extended = picture_of(best->fit, observations);
        const Eigen::VectorXd pull = base.precision.cwiseSqrt().cwiseProduct(base.known);
        std::vector<double> log_e;
        for (const Fold& fold : folds_of(observations)) {
            const auto& [test, rest, run] = fold;
            if (test.empty() || rest.empty()) {
                continue;
            }
            const Trained trained = train(found, base, extended, rest);
            std::vector<bool> own(static_cast<std::size_t>(trained.picture.slopes.cols()), false);
            for (std::size_t j = 0; j < evidence.experiment->parameters.size(); ++j) {
                own[j] = run >= 0 && evidence.experiment->parameters[j].run == run;
            }
            after(test) = left_of_run(trained.picture, trained.solved, test, own);
            own.resize(static_cast<std::size_t>(base.slopes.cols()));
            before(test) = left_of_run(base, solve(base, rest, base.precision, pull), test, own);
            log_e.push_back(log_e_value(evidence, trained.signature, trained.size, test));
        }
        Losses losses;
        double longest = 1.0;
        for (std::size_t row = 0; row < n_rows; ++row) {
            const auto i = static_cast<Eigen::Index>(row);
            if (noise_of[row] >= 0 && std::isfinite(before[i])) {
                const Noise& noise = evidence.noise.channels[static_cast<std::size_t>(noise_of[row])];
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
