// SPDX-License-Identifier: BSD-3-Clause
// Ranks relabellings by the model linearised at the case's values, and proves the best of them by full fits.

#include "diagnosis/data_faults/data_faults.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <Eigen/Cholesky>

#include "diagnosis/data_faults/fault_sentence.hpp"
#include "diagnosis/fit/refit.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

/// A fault must leave less than this, and less than this share of what is left with the labels as they are.
constexpr double ordinary = 3.0;
constexpr double falls_to = 1.0 / 3.0;
/// Where a second fault is looked for beside the first, that must leave at most this share.
constexpr double much_less = 0.8;
/// Any other relabelling must leave more than this many times as much: what does nearly as well cannot be told from it.
constexpr double rivals_leave = 1.5;
/// Squared standard deviations of all priors together that a fit without faults may reach.
constexpr double usual_pull = 16.0;
/// An input in another unit may be made up for by a parameter that is far from what was known of it, such as a speed by the loss.
/// The right unit brings the parameters back by this, odds of e^12.5, and the readings are met better by a tenth, though no
/// parameter goes astray any more.
constexpr double pulled_back = 25.0;
constexpr double met_better = 0.9;
constexpr std::size_t most_faults = 3;
/// Relabellings that are fitted in full.
constexpr std::size_t most_fits = 3;
/// In the linear picture a number moves by so many of its standard deviations at most.
constexpr double farthest = 10.0;
constexpr Eigen::Index fewest_rows = 50;

/// Rows of temperatures that sensors of logs have read.
std::vector<Eigen::Index> temperature_rows(const input::Experiment& experiment, const Observations& observations) {
    std::vector<Eigen::Index> rows = sensor_rows(observations);
    std::erase_if(rows, [&](Eigen::Index i) {
        const Observations::Row& row = observations.rows[static_cast<std::size_t>(i)];
        return experiment.runs[row.run].problem.channels[row.channel].quantity != solver::Quantity::temperature;
    });
    return rows;
}

double rms(const Eigen::VectorXd& left, const std::vector<Eigen::Index>& rows) {
    double sum = 0.0;
    double n = 0.0;
    for (const Eigen::Index row : rows) {
        if (!std::isnan(left[row])) {
            sum += left[row] * left[row];
            n += 1.0;
        }
    }
    return n > 0.0 ? std::sqrt(sum / n) : std::numeric_limits<double>::infinity();
}

/// A model linearised at the values of its case.
struct LinearModel {
    Eigen::VectorXd measured;   ///< [n_rows] SI, NaN where nothing is
    Eigen::VectorXd simulated;  ///< [n_rows]
    Eigen::MatrixXd slope;      ///< [n_rows][n] per scale
};

/// What a model leaves, its numbers fitted in the linear picture.
struct LinearFit {
    Eigen::VectorXd left;  ///< [n_rows]
    double pull = 0.0;     ///< squared standard deviations of all priors
};

/// @param noise as stated, so that the data count and not what was known before
LinearFit linear_fit(const LinearModel& model, const Eigen::VectorXd& precision, const Covariance& noise,
                     const Observations& observations) {
    Eigen::VectorXd difference = model.measured - model.simulated;
    const Eigen::VectorXd known = difference.array().isNaN().select(0.0, Eigen::VectorXd::Ones(difference.size()));
    difference = known.array().select(difference, 0.0);
    const Eigen::MatrixXd slope = known.asDiagonal() * model.slope;
    Eigen::MatrixXd all(slope.rows(), slope.cols() + 1);
    all << slope, difference;
    whiten(observations.blocks, noise, all);
    const auto S = all.leftCols(slope.cols());
    Eigen::MatrixXd A = S.transpose() * S;
    A.diagonal() += precision + Eigen::VectorXd::Constant(precision.size(), 1e-9);
    const Eigen::VectorXd step =
        A.ldlt().solve(S.transpose() * all.col(slope.cols())).cwiseMin(farthest).cwiseMax(-farthest);
    const Eigen::VectorXd left = difference - slope * step;
    return {.left = known.array().select(left, std::nan("")), .pull = precision.dot(step.cwiseAbs2())};
}

/// A model fitted with the noise as stated: what it leaves is what no parameter can make up for, however far that is from what was
/// known of it. Noise as large as a gross misfit would hold the parameters where they were known.
struct DataFit {
    bool sound = false;
    double left = std::numeric_limits<double>::infinity();  ///< K, rms of all temperatures
    double pull = 0.0;                                      ///< squared standard deviations of all priors
};

DataFit data_fit(const input::Experiment& experiment, long& simulations) {
    const Observations observations = observe(experiment);
    Fit fit(experiment, observations);
    fit.take_stated_noise();
    DataFit result;
    if (fit.move_to(fit.simulator().start())) {
        const Refit at = refit(fit);
        result.sound = at.status.ok() && at.values.size() > 0;
        result.pull = at.known.squaredNorm();
        result.left = result.sound
                          ? rms(observations.measured - at.simulated, temperature_rows(experiment, observations))
                          : result.left;
    }
    simulations += fit.simulator().simulations();
    return result;
}

bool removes_nearly_all(const DataFit& before, const DataFit& after) {
    return before.left > gross_misfit && after.left < std::min(ordinary, falls_to * before.left) &&
           after.pull <= std::max(usual_pull, before.pull);
}

bool brings_parameters_back(const DataFit& before, const DataFit& after) {
    return after.pull <= std::min(usual_pull, before.pull - pulled_back) && after.left < met_better * before.left;
}

/// A relabelling in some runs, and what it leaves.
struct FaultTrial {
    const Relabelling* what = nullptr;
    const FaultScope* scope = nullptr;
    double left = 0.0;  ///< K, in the linear picture
};

/// The same with its full fit, and the experiment that it is of.
struct FittedTrial {
    FaultTrial trial;
    DataFit fit;
    input::Experiment experiment;
};

/// The best relabelling, with the experiment read so.
struct LikelyFault {
    DataFault fault;
    input::Experiment experiment;
    bool is_beyond_doubt = false;
};

/// Takes from another model the rows of some runs.
LinearModel in_scope(const LinearModel& base, const LinearModel& other, const FaultScope& scope,
                     const Observations& observations) {
    LinearModel mixed = base;
    for (std::size_t i = 0; i < observations.rows.size(); ++i) {
        if (std::ranges::find(scope.runs, observations.rows[i].run) != scope.runs.end()) {
            const auto row = static_cast<Eigen::Index>(i);
            mixed.measured[row] = other.measured[row];
            mixed.simulated[row] = other.simulated[row];
            mixed.slope.row(row) = other.slope.row(row);
        }
    }
    return mixed;
}

/// An experiment whose labels are in question.
class LabelSearch {
public:
    LabelSearch(const input::Experiment& experiment, const ReadAgain& read_again, const DataCorrections& corrections,
                long& simulations)
        : experiment_(experiment),
          read_again_(read_again),
          corrections_(corrections),
          simulations_(simulations),
          observations_(observe(experiment)),
          rows_(temperature_rows(experiment, observations_)) {}

    /// The likeliest fault; nothing where nothing asks for one.
    [[nodiscard]] std::optional<LikelyFault> find();

private:
    /// @returns nothing where the model fails
    std::optional<LinearModel> linear_model(const input::Experiment& experiment);
    /// The model under inputs that are relabelled in all runs that allow it.
    std::optional<LinearModel> with_other_inputs(const Relabelling& what);
    /// The experiment with one more correction.
    [[nodiscard]] std::optional<input::Experiment> read_with(const Relabelling& what, const FaultScope& scope) const;
    /// All that leave much less, the best first.
    std::vector<FaultTrial> trials(const LinearModel& base, const std::vector<Relabelling>& all,
                                   const std::vector<FaultScope>& scopes, double at_most);
    /// The first of them, fitted in full, the best first.
    std::vector<FittedTrial> fitted(const std::vector<FaultTrial>& ranked);

    const input::Experiment& experiment_;
    const ReadAgain& read_again_;
    const DataCorrections& corrections_;  ///< that have been made already
    long& simulations_;
    Observations observations_;
    std::vector<Eigen::Index> rows_;
    Eigen::VectorXd precision_;
    Covariance noise_;
};

std::optional<LinearModel> LabelSearch::linear_model(const input::Experiment& experiment) {
    Fit fit(experiment, observations_);
    const bool runs = fit.move_to(fit.simulator().start());
    simulations_ += fit.simulator().simulations();
    if (!runs) {
        return std::nullopt;
    }
    fit.take_stated_noise();
    noise_ = fit.covariance();
    precision_ = fit.precision().cwiseProduct(fit.scale().cwiseAbs2());
    return LinearModel{.measured = observations_.measured,
                       .simulated = fit.now().simulated,
                       .slope = fit.now().slope * fit.scale().asDiagonal()};
}

std::optional<LinearModel> LabelSearch::with_other_inputs(const Relabelling& what) {
    FaultScope possible;  // runs without the column stay as they are
    for (std::size_t r = 0; r < experiment_.runs.size(); ++r) {
        if (is_possible(what, {.runs = {r}, .recordings = {}}, experiment_)) {
            possible.runs.push_back(r);
        }
    }
    std::optional<input::Experiment> read = read_with(what, possible);
    if (!read || read->runs.size() != experiment_.runs.size()) {
        return std::nullopt;
    }
    for (std::size_t r = 0; r < read->runs.size(); ++r) {  // what is asked for is the same
        read->runs[r].time = experiment_.runs[r].time;
        read->runs[r].series = experiment_.runs[r].series;
    }
    return linear_model(*read);
}

std::optional<input::Experiment> LabelSearch::read_with(const Relabelling& what, const FaultScope& scope) const {
    DataCorrections all = corrections_;
    all.add(what, scope, experiment_);
    return read_again_(all);
}

std::vector<FaultTrial> LabelSearch::trials(const LinearModel& base, const std::vector<Relabelling>& all,
                                            const std::vector<FaultScope>& scopes, double at_most) {
    std::vector<FaultTrial> found;
    for (const Relabelling& what : all) {
        std::optional<LinearModel> everywhere = what.touches_inputs() ? with_other_inputs(what) : base;
        if (everywhere) {
            everywhere->measured = relabelled(what, experiment_, observations_);
        }
        for (const FaultScope& scope : scopes) {
            if (!everywhere || !is_possible(what, scope, experiment_)) {
                continue;
            }
            const LinearModel mixed = in_scope(base, *everywhere, scope, observations_);
            const LinearFit fit = linear_fit(mixed, precision_, noise_, observations_);
            const double left = rms(fit.left, rows_);
            if (left < at_most) {
                found.push_back({.what = &what, .scope = &scope, .left = left});
            }
        }
    }
    std::ranges::sort(found, {}, &FaultTrial::left);
    return found;
}

std::vector<FittedTrial> LabelSearch::fitted(const std::vector<FaultTrial>& ranked) {
    std::vector<FittedTrial> all;
    for (const FaultTrial& trial : ranked) {
        if (all.size() == most_fits) {
            break;
        }
        std::optional<input::Experiment> read = read_with(*trial.what, *trial.scope);
        const DataFit fit = read ? data_fit(*read, simulations_) : DataFit{};
        if (fit.sound) {
            all.push_back({.trial = trial, .fit = fit, .experiment = std::move(*read)});
        }
    }
    std::ranges::sort(all, {}, [](const FittedTrial& one) { return one.fit.left; });
    return all;
}

std::optional<LikelyFault> LabelSearch::find() {
    const std::vector<Relabelling> all = relabellings(experiment_);
    const std::vector<FaultScope> scopes = fault_scopes(experiment_);
    const auto least = static_cast<std::size_t>(fewest_rows) + 10 * experiment_.parameters.size();
    if (all.empty() || experiment_.parameters.empty() || rows_.size() < least) {
        return std::nullopt;
    }
    const std::optional<LinearModel> base = linear_model(experiment_);
    const LinearFit first = base ? linear_fit(*base, precision_, noise_, observations_) : LinearFit{};
    if (!base || (rms(first.left, rows_) < gross_misfit && first.pull < 0.5 * pulled_back)) {
        return std::nullopt;
    }
    const DataFit as_it_is = data_fit(experiment_, simulations_);
    if (!as_it_is.sound || (as_it_is.left < gross_misfit && as_it_is.pull < pulled_back)) {
        return std::nullopt;
    }
    // The linear picture may miss more than a fit does, and pull less, of the labels as they are and of others.
    const double at_most = std::max(as_it_is.left, rms(first.left, rows_));
    std::vector<FittedTrial> trials_fitted = fitted(trials(*base, all, scopes, at_most));
    if (trials_fitted.empty()) {
        return std::nullopt;
    }
    FittedTrial& best = trials_fitted.front();
    const Relabelling& what = *best.trial.what;
    const bool is_alone = trials_fitted.size() < 2 || trials_fitted[1].fit.left > rivals_leave * best.fit.left;
    LikelyFault likely{.fault = {.what = what,
                                 .scope = *best.trial.scope,
                                 .changes = changes_of(what, *best.trial.scope, experiment_),
                                 .before = as_it_is.left,
                                 .after = best.fit.left,
                                 .pull_before = std::sqrt(as_it_is.pull),
                                 .pull_after = std::sqrt(best.fit.pull),
                                 .remark = remark::more_is_missing()},
                       .experiment = std::move(best.experiment),
                       .is_beyond_doubt = (is_alone && removes_nearly_all(as_it_is, best.fit)) ||
                                          (what.touches_inputs() && brings_parameters_back(as_it_is, best.fit))};
    likely.fault.remark = sentence_of(likely.fault, experiment_);
    return likely;
}

}  // namespace

void DataCorrections::add(const Relabelling& what, const FaultScope& scope, const input::Experiment& experiment) {
    std::ranges::move(changes_of(what, scope, experiment), std::back_inserter(columns));
    if (what.kind == Relabelling::Kind::mirror) {
        std::ranges::copy(scope.runs, std::back_inserter(mirrored));
    }
}

DataFaults find_data_faults(const input::Experiment& experiment, const ReadAgain& read_again) {
    DataFaults faults;
    // Beside a second fault the first may leave too much: it is beyond doubt where the second is, which falls to a third of that.
    DataFaults likely;
    try {
        while (likely.found.size() < most_faults && likely.found.size() < faults.found.size() + 2) {
            const input::Experiment now = likely.corrected ? *likely.corrected : experiment;
            LabelSearch search(now, read_again, likely.corrections, likely.simulations);
            std::optional<LikelyFault> next = search.find();
            if (!next || (!next->is_beyond_doubt && next->fault.after > much_less * next->fault.before)) {
                break;
            }
            likely.corrections.add(next->fault.what, next->fault.scope, now);
            likely.found.push_back(std::move(next->fault));
            likely.corrected = std::move(next->experiment);
            if (next->is_beyond_doubt) {
                faults = likely;
            }
        }
    } catch (const solver::Interrupted&) {  // the diagnosis hears it again, and says so
    }
    faults.simulations = likely.simulations;
    return faults;
}

}  // namespace tiretherm::diagnosis
