// SPDX-License-Identifier: BSD-3-Clause
// Fits the case with correlated and with white noise, and compares both and the case as it stands by what they predict.

#include <cmath>
#include <optional>
#include <utility>

#include "diagnosis/assess/extension.hpp"
#include "diagnosis/assess/prediction_search.hpp"

namespace tiretherm::diagnosis {

namespace {

/// White noise is taken where it predicts the temperatures better by this share of the rms.
constexpr double better_by = 0.02;

/// Mean over the channels of the logarithm of the mean square: half of its differences is the relative change of the rms.
double log_error(const PredictedModel& model, const Observations& observations) {
    double sum = 0.0;
    int counted = 0;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const double square = model.out.mean_square(observations, c);
        if (square > 0.0) {
            sum += std::log(square);
            ++counted;
        }
    }
    return counted > 0 ? sum / counted : 0.0;
}

}  // namespace

PredictionSearch choose_base(ScoreTestData& score_data) {
    PredictionSearch search;
    const Observations& observations = *score_data.observations;
    FittedHypothesis slow;
    slow.model = *score_data.experiment;
    slow.fit = score_data.base;
    slow.sound = true;

    PredictedModel correlated = predicted(score_data, slow, score_data.noise);
    correlated.base = BaseModel::correlated_noise;
    std::optional<PredictedModel> white;
    Covariance even = alike(slow, observations);
    for (int turn = 0; turn < 2; ++turn) {
        FittedHypothesis flat = counted(score_data, refitted(score_data, white ? white->hypothesis : slow, even));
        if (!flat.sound) {
            break;
        }
        white = PredictedModel{.hypothesis = std::move(flat), .noise = even, .base = BaseModel::white_noise};
        even = alike(white->hypothesis, observations);
    }
    if (white) {
        white->out = predicted(score_data, white->hypothesis, white->noise).out;
    }
    const Covariance& its_noise = white ? white->noise : even;
    FittedHypothesis plain = counted(score_data, as_it_stands(score_data, its_noise));
    PredictedModel stands = predicted(score_data, std::move(plain), its_noise, false);
    stands.base = BaseModel::as_it_stands;

    const double of_correlated = log_error(correlated, observations);
    const double by_white = white && white->out.ok ? log_error(*white, observations) : 1e30;
    const double of_case = stands.out.ok ? log_error(stands, observations) : 1e30;
    search.white = 0.5 * (of_correlated - by_white) > better_by;
    search.base = search.white ? std::move(*white) : std::move(correlated);
    if (0.5 * ((search.white ? by_white : of_correlated) - of_case) > better_by) {
        search.base = std::move(stands);
        search.white = true;
    }
    return search;
}

}  // namespace tiretherm::diagnosis
