// SPDX-License-Identifier: BSD-3-Clause
// Columns of the linearised model that act in some runs alone, tested by their scatter within the runs and by prediction.

#include "diagnosis/assess/run_changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/assess/linear_prediction.hpp"
#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr std::size_t most_changes = 3;
/// A number of the case that differs by less is no finding.
constexpr double least_share_of_number = 0.05;
/// Nor is a change that moves no reading of its runs by this share of the sensor's noise (rms).
constexpr double least_of_noise = 0.5;
/// Blocks of time of each run at least.
constexpr long fewest_blocks_of_run = 4;
/// What a change must remove of the mean square, on blocks that were left out and on other runs.
constexpr double least_removed_within = 0.03;
/// What any cause that all runs have leaves there must be larger by this share: both are chosen, and the better one by chance.
constexpr double behind_change = 0.1;

constexpr double unbounded = std::numeric_limits<double>::infinity();

RowIndices all_rows(const Observations& observations) {
    RowIndices rows(observations.rows.size());
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

Eigen::MatrixXd whitened_by(const Covariance& noise, const Observations& observations, Eigen::MatrixXd columns) {
    whiten(observations.blocks, noise, columns);
    return columns;
}

/// An instrument may be replaced or moved between runs, and rubber is worn off.
bool may_differ(const Candidate& candidate) {
    const bool is_sensor = candidate.effect->sensor_model() != nullptr && candidate.channels.size() == 1;
    const physics::InputCorrection* input = candidate.effect->input_correction();
    const bool is_input = input != nullptr && input->delay == nullptr;
    return candidate.on < 0 && candidate.held.empty() && candidate.by_slope() &&
           (is_sensor || is_input || candidate.effect->id == "tread_wear");
}

/// The patterns of a number over the runs: in each run alone, of two in the last, as nobody knows which is the odd one; and from run to
/// run. @param slope [n_rows] of the number in all runs
void add_patterns(const Observations& observations, const RunChange& number, const Eigen::VectorXd& slope, double size,
                  std::vector<RunColumn>& all) {
    const std::size_t n = observations.times.size();
    const auto add = [&](std::vector<std::size_t> runs, bool is_trend) {
        RunColumn one{.change = number, .raw = slope, .size = size};
        for (std::size_t row = 0; row < observations.rows.size(); ++row) {
            const std::size_t run = observations.rows[row].run;
            const bool is_own = std::ranges::find(runs, run) != runs.end();
            const double weight = is_trend ? static_cast<double>(run) - static_cast<double>(n - 1) : 1.0;
            one.raw[static_cast<Eigen::Index>(row)] *= is_own ? weight : 0.0;
        }
        one.change.runs = std::move(runs);
        one.change.is_trend = is_trend;
        if (one.raw.squaredNorm() > 0.0) {
            all.push_back(std::move(one));
        }
    };
    for (std::size_t run = n == 2 ? 1 : 0; run < n; ++run) {
        add({run}, false);
    }
    if (n > 2) {
        std::vector<std::size_t> but_the_last(n - 1);
        std::iota(but_the_last.begin(), but_the_last.end(), 0);
        add(std::move(but_the_last), true);
    }
}

/// A length within which what is left is forgotten.
double length_to_forget(const Eigen::VectorXd& left, const Observations& observations) {
    constexpr double forgotten = 3.0;
    constexpr double most = 40.0;  // blocks of a run
    double slowest = 0.0;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        slowest = std::max(slowest, time_scale(left, observations.blocks, static_cast<int>(c)));
    }
    double longest = 0.0;
    for (std::size_t recording = 0; recording < observations.n_recordings(); ++recording) {
        const auto [from, to] = observations.span_of(recording);
        longest = std::max(longest, to - from);
    }
    return std::max(forgotten * slowest, longest / most);
}

/// Student's t as a normal number.
double normal_of(double t, double freedom) {
    return (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) * std::sqrt(freedom * std::log1p(t * t / freedom));
}

/// A linearised model in which every channel counts alike, numbers at a bound held, and its noise.
struct EvenModel {
    LinearisedModel model;
    Covariance noise;
};

EvenModel even_model(const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    EvenModel even{.model = linearise(score_data.base, observations), .noise = {}};
    for (Eigen::Index j = 0; j < even.model.precision.size(); ++j) {
        if (score_data.base.at_bound[static_cast<std::size_t>(j)]) {
            even.model.precision[j] = 1e30;
            even.model.known[j] = 0.0;
        }
    }
    Eigen::VectorXd left = even.model.left;
    const RowIndices rows = all_rows(observations);
    for (int turn = 0; turn < 2; ++turn) {
        even.noise = white_noise_of(left, observations.blocks, observations.channels.size());
        even.model.slopes = whitened_by(even.noise, observations, even.model.raw);
        even.model.residual = whitened_by(even.noise, observations, even.model.left).col(0);
        left = even.model.left - even.model.raw * solve(even.model, rows);
    }
    return even;
}

/// A model with a column more, of which nothing is known.
LinearisedModel with_column(LinearisedModel model, const Eigen::VectorXd& white, const Eigen::VectorXd& raw) {
    const Eigen::Index n = model.slopes.cols();
    model.slopes.conservativeResize(Eigen::NoChange, n + 1);
    model.raw.conservativeResize(Eigen::NoChange, n + 1);
    model.precision.conservativeResize(n + 1);
    model.known.conservativeResize(n + 1);
    model.slopes.col(n) = white;
    model.raw.col(n) = raw;
    model.precision[n] = model.known[n] = 0.0;
    return model;
}

/// All that changes compete with: every cause and every unknown source that all runs have.
Signatures common_signatures(const ScoreTestData& score_data, const EvenModel& even) {
    const Eigen::MatrixXd& followers = score_data.unknowns.columns;
    const Eigen::Index n = score_data.signatures.cols();
    Signatures common;
    common.raw.resize(score_data.signatures.rows(), n + score_data.unknowns.n_followers);
    common.raw << score_data.signatures, followers.leftCols(score_data.unknowns.n_followers);
    common.white = whitened_by(even.noise, *score_data.observations, common.raw);
    for (const Candidate& candidate : score_data.candidates) {
        const auto [low, high] = plausible_bounds(candidate);
        common.bounds.emplace_back(low - candidate.absent, high - candidate.absent);
    }
    common.bounds.resize(static_cast<std::size_t>(common.raw.cols()), {-unbounded, unbounded});
    return common;
}

/// The search for changes in one linearised model, to which those that were found are added.
class RunComparison {
public:
    explicit RunComparison(const ScoreTestData& score_data)
        : score_data_(score_data),
          observations_(*score_data.observations),
          even_(even_model(score_data)),
          columns_(run_columns(score_data)) {}

    std::vector<RunChange> find() {
        while (found_.size() < most_changes && !columns_.empty()) {
            const std::optional<std::size_t> best = best_of_all();
            if (!best) {
                break;
            }
            const RunColumn one = columns_[*best];
            even_.model = with_column(std::move(even_.model), white_of(one), one.raw);
            found_.push_back(one.change);
            std::erase_if(columns_, [&](const RunColumn& other) {
                return is_same_number(other.change, one.change) &&
                       (one.change.is_trend || other.change.is_trend || other.change.runs == one.change.runs);
            });
        }
        return found_;
    }

private:
    static bool is_same_number(const RunChange& one, const RunChange& other) {
        return one.number == other.number && one.candidate.has_value() == other.candidate.has_value() &&
               (!one.candidate || (one.candidate->cause == other.candidate->cause));
    }

    [[nodiscard]] Eigen::VectorXd white_of(const RunColumn& one) const {
        return whitened_by(even_.noise, observations_, one.raw).col(0);
    }

    /// Whether readings of its runs are moved by as much as a sensor's noise can show.
    [[nodiscard]] bool is_visible(const RunColumn& one, double amplitude) const {
        const std::vector<int> noise_of = noise_of_rows(observations_);
        std::vector<double> square(observations_.channels.size(), 0.0);
        std::vector<double> count(square.size(), 0.0);
        for (std::size_t row = 0; row < noise_of.size(); ++row) {
            if (noise_of[row] >= 0 && one.raw[static_cast<Eigen::Index>(row)] != 0.0) {
                square[static_cast<std::size_t>(noise_of[row])] +=
                    std::pow(amplitude * one.raw[static_cast<Eigen::Index>(row)], 2);
                count[static_cast<std::size_t>(noise_of[row])] += 1.0;
            }
        }
        for (std::size_t c = 0; c < square.size(); ++c) {
            const double noise =
                observations_.stated[c] > 0.0 ? observations_.stated[c] : score_data_.noise.channels[c].sigma;
            if (count[c] > 0.0 && std::sqrt(square[c] / count[c]) > least_of_noise * noise) {
                return true;
            }
        }
        return false;
    }

    /// Share that a change removes of the errors on runs that do not have it, each predicted from the others; a trend's on all runs.
    [[nodiscard]] double removed_of_other_runs(const RunColumn& one) const {
        std::vector<Fold> folds = folds_of(observations_);
        std::erase_if(folds, [&](const Fold& fold) { return !one.change.is_trend && fold.runs == one.change.runs; });
        std::vector<std::vector<bool>> own;
        for (const Fold& fold : folds) {
            std::vector<bool>& of_fold = own.emplace_back();
            for (const solver::FreeParameter& parameter : score_data_.experiment->parameters) {
                of_fold.push_back(fold.alone_has(parameter));
            }
            for (const RunChange& change : found_) {
                of_fold.push_back(change.runs == fold.runs);
            }
        }
        // What was known before of a number that is far from it would pull it the more the fewer runs are left.
        LinearisedModel free = even_.model;
        for (std::size_t j = 0; j < score_data_.experiment->parameters.size(); ++j) {
            const auto i = static_cast<Eigen::Index>(j);
            const bool is_start = score_data_.experiment->parameters[j].kind == solver::FreeParameter::Kind::initial;
            if (!is_start && !score_data_.base.at_bound[j]) {
                free.precision[i] = free.known[i] = 0.0;
            }
        }
        const LinearPrediction prediction(free,
                                          {.raw = one.raw, .white = white_of(one), .bounds = {{-unbounded, unbounded}}},
                                          folds, own, noise_of_rows(observations_), observations_.channels.size());
        return share_removed(prediction.with({}), prediction.with({0}));
    }

    /// Predictions of the quarters of all runs, each from the rest.
    [[nodiscard]] LinearPrediction within_runs(const Signatures& beside) const {
        const std::vector<Fold> folds = folds_within_recordings(observations_);
        const std::vector<bool> none(static_cast<std::size_t>(even_.model.slopes.cols()), false);
        return {even_.model,
                beside,
                folds,
                std::vector(folds.size(), none),
                noise_of_rows(observations_),
                observations_.channels.size()};
    }

    /// The most that any cause or unknown source which all runs have removes there.
    [[nodiscard]] double removed_by_common_cause() const {
        const Signatures common = common_signatures(score_data_, even_);
        const LinearPrediction prediction = within_runs(common);
        const LinearPrediction::MeanSquares before = prediction.with({});
        double most = 0.0;
        for (Eigen::Index k = 0; k < common.raw.cols(); ++k) {
            most = std::max(most, share_removed(before, prediction.with({k})));
        }
        return most;
    }

    /// The change that predicts blocks within the runs best, if it is one.
    [[nodiscard]] std::optional<std::size_t> best_of_all() const {
        const auto m = static_cast<Eigen::Index>(columns_.size());
        Signatures all;
        all.raw.resize(static_cast<Eigen::Index>(observations_.rows.size()), m);
        for (Eigen::Index k = 0; k < m; ++k) {
            all.raw.col(k) = columns_[static_cast<std::size_t>(k)].raw;
        }
        all.white = whitened_by(even_.noise, observations_, all.raw);
        all.bounds.resize(columns_.size(), {-unbounded, unbounded});
        const std::vector<RunChangeTest> tests = test_run_changes(even_.model, all.white, observations_);
        const LinearPrediction prediction = within_runs(all);
        const LinearPrediction::MeanSquares before = prediction.with({});
        // The simplest first: an own number of the case in one run, which others must clearly beat.
        const auto handicap = [](const RunChange& change) {
            return (change.candidate ? behind_change : 0.0) + (change.is_trend ? behind_change : 0.0);
        };
        std::optional<std::size_t> best;
        double most = least_removed_within;
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            const RunColumn& one = columns_[k];
            if (std::abs(tests[k].z) < least_of_run_changes(columns_.size()) ||
                std::abs(tests[k].amplitude) < one.size || !is_visible(one, tests[k].amplitude)) {
                continue;
            }
            const double whole = share_removed(before, prediction.with({static_cast<Eigen::Index>(k)}));
            const double removed = whole - handicap(one.change) * (1.0 - whole);
            if (removed > most &&
                (observations_.n_recordings() == 2 || removed_of_other_runs(one) > least_removed_within)) {
                best = k;
                most = removed;
            }
        }
        const bool is_it = best && 1.0 - most < (1.0 - behind_change) * (1.0 - removed_by_common_cause());
        return is_it ? best : std::nullopt;
    }

    const ScoreTestData& score_data_;
    const Observations& observations_;
    EvenModel even_;
    std::vector<RunColumn> columns_;
    std::vector<RunChange> found_;
};

}  // namespace

std::string RunChange::name(const input::Experiment& experiment) const {
    return candidate ? name_of(*candidate, experiment) : experiment.parameters[number].name;
}

std::vector<RunColumn> run_columns(const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    std::vector<RunColumn> all;
    if (observations.n_recordings() < 2 || observations.n_recordings() != observations.times.size() ||
        !observations.images.empty() || observations.channels.empty()) {
        return all;
    }
    const std::vector<solver::FreeParameter>& parameters = score_data.experiment->parameters;
    for (std::size_t j = 0; j < parameters.size(); ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        if (parameters[j].kind != solver::FreeParameter::Kind::initial && parameters[j].runs.empty() &&
            !score_data.base.at_bound[j]) {
            add_patterns(observations, {.number = j}, score_data.base.raw.col(i),
                         least_share_of_number * std::abs(score_data.base.values[i]) / score_data.base.scale[i], all);
        }
    }
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        if (may_differ(score_data.candidates[k])) {
            add_patterns(observations, {.candidate = score_data.candidates[k]},
                         score_data.signatures.col(static_cast<Eigen::Index>(k)), 0.0, all);
        }
    }
    return all;
}

std::vector<RunChangeTest> test_run_changes(const LinearisedModel& model, const Eigen::MatrixXd& white,
                                            const Observations& observations) {
    const NuisanceProjector projector(model.slopes, model.precision);
    const Eigen::MatrixXd columns = projector.project(white);
    const Eigen::VectorXd residual = projector.project(model.residual, model.known);
    std::vector<RunChangeTest> tests;
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
        RunChangeTest& test = tests.emplace_back();
        const double square = columns.col(k).squaredNorm();
        if (!(square > least_share * least_share * white.col(k).squaredNorm())) {
            continue;
        }
        test.amplitude = columns.col(k).dot(residual) / square;
        const Eigen::VectorXd left = (residual - test.amplitude * columns.col(k)).head(white.rows());
        const std::vector<std::size_t> block =
            blocks_of_rows(observations, length_to_forget(left, observations), fewest_blocks_of_run);
        const std::size_t n_blocks = *std::ranges::max_element(block) + 1;
        Eigen::VectorXd score = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n_blocks));
        for (std::size_t row = 0; row < block.size(); ++row) {
            const auto i = static_cast<Eigen::Index>(row);
            score[static_cast<Eigen::Index>(block[row])] += columns(i, k) * left[i];
        }
        const auto n = static_cast<double>(n_blocks);
        const double variance = n / (n - 1.0) * score.squaredNorm() / (square * square);
        const double t = test.amplitude / std::sqrt(variance);
        test.z = std::copysign(normal_of(t, n - 1.0), t);
    }
    return tests;
}

double least_of_run_changes(std::size_t n) {
    // The chance of |z| beyond a limit is less than exp(-z^2 / 2).
    constexpr double chance = 0.002;
    return std::sqrt(2.0 * std::log(static_cast<double>(std::max<std::size_t>(1, n)) / chance));
}

std::vector<RunChange> find_run_changes(const ScoreTestData& score_data) { return RunComparison(score_data).find(); }

}  // namespace tiretherm::diagnosis
