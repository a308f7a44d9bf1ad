// SPDX-License-Identifier: BSD-3-Clause
// Hashes a problem with what is asked of it, and turns a prediction into numbers and back.

#include "solver/sensitivity/kept_results.hpp"

#include <algorithm>
#include <atomic>

#include "physics/tire_laws/measured_loss.hpp"
#include "solver/field_digest.hpp"

namespace tiretherm::solver {

namespace {

std::atomic<KeptResults*> in_use = nullptr;

}  // namespace

UseOfKeptResults::UseOfKeptResults(KeptResults& results) { in_use = &results; }

UseOfKeptResults::~UseOfKeptResults() { in_use = nullptr; }

KeptResults* kept_results() { return in_use; }

Digest::Value key_of(const Problem& problem, const PredictionRequest& request) {
    Digest digest;
    digest.add("prediction");
    add_fields(digest, problem);
    add_fields(digest, request);
    return digest.value();
}

std::vector<double> numbers_of(const Prediction& prediction, const PredictionRequest& request) {
    std::vector<double> numbers{static_cast<double>(prediction.step_ends.size()),
                                static_cast<double>(prediction.non_smooth_parameters.size())};
    for (const std::vector<double>* values : {&prediction.step_ends, &prediction.value, &prediction.slope}) {
        numbers.insert(numbers.end(), values->begin(), values->end());
    }
    for (const std::string& name : prediction.non_smooth_parameters) {
        const auto found = std::ranges::find(request.parameters, name, &FreeParameter::name);
        numbers.push_back(static_cast<double>(found - request.parameters.begin()));
    }
    return numbers;
}

std::optional<Prediction> prediction_of(std::span<const double> numbers, const Problem& problem,
                                        const PredictionRequest& request) {
    Prediction prediction;
    prediction.n_times = request.times.size();
    prediction.n_channels = problem.channels.size();
    const std::size_t values = prediction.n_times * prediction.n_channels;
    const std::size_t slopes = request.parameters.size() * values;
    const auto most = static_cast<double>(numbers.size());
    if (numbers.size() < 2 || !(numbers[0] >= 0.0 && numbers[0] <= most) ||
        !(numbers[1] >= 0.0 && numbers[1] <= most)) {
        return std::nullopt;
    }
    const auto steps = static_cast<std::size_t>(numbers[0]);
    const auto kinks = static_cast<std::size_t>(numbers[1]);
    if (numbers.size() != 2 + steps + values + slopes + kinks) {
        return std::nullopt;
    }
    std::size_t at = 2;
    const auto take = [&](std::vector<double>& into, std::size_t n) {
        into.assign(numbers.begin() + static_cast<std::ptrdiff_t>(at),
                    numbers.begin() + static_cast<std::ptrdiff_t>(at + n));
        at += n;
    };
    take(prediction.step_ends, steps);
    take(prediction.value, values);
    take(prediction.slope, slopes);
    for (std::size_t k = 0; k < kinks; ++k) {
        const double parameter = numbers[at + k];
        if (!(parameter >= 0.0 && parameter < static_cast<double>(request.parameters.size()))) {
            return std::nullopt;
        }
        prediction.non_smooth_parameters.push_back(request.parameters[static_cast<std::size_t>(parameter)].name);
    }
    return prediction;
}

}  // namespace tiretherm::solver
