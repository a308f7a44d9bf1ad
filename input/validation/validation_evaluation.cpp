// SPDX-License-Identifier: BSD-3-Clause
// Reads how a number is evaluated (case, channel, time, `minus`, `over`) and finds run and channel for each model.

#include <algorithm>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"
#include "input/validation/validation_reader.hpp"
#include "input/validation/validation_request.hpp"

namespace tiretherm::input {

namespace {

/// The reading for one model, or nothing after an error.
std::optional<Readout> resolve(const ReadoutRequest& request, const std::string& model, const TomlTable& table,
                               CaseCache& cache) {
    InputErrors& errors = table.errors();
    const auto own = request.files.find(model);
    const std::optional<LocatedString> file =
        request.case_name || own == request.files.end() ? request.case_name : std::optional(own->second);
    if (!file || !request.channel) {
        if (!file && table.exists()) {
            table.add_error("files", fmt::format("{} has no file for {}", table.title(), model),
                            fmt::format("add {} to files, or leave it out of models", model));
        }
        return std::nullopt;
    }
    const std::string path = request.case_name ? fmt::format("{}_{}.toml", file->text, model) : file->text;
    const std::optional<std::size_t> run = cache.find(path, file->place, errors);
    if (!run) {
        return std::nullopt;
    }
    const solver::Problem& problem = cache.problem(*run);
    const std::vector<std::string> channels = names_of(problem.channels);
    const auto channel = find_name(*request.channel, channels, path + " has no sensor", "sensors", errors);
    if (!channel) {
        return std::nullopt;
    }
    const auto [start, end] = std::pair(problem.settings.start, problem.settings.end);
    const Window window{.take = request.take,
                        .from = request.from.value_or(start),
                        .to = request.to.value_or(end),
                        .share = request.share};
    if (std::min(window.from, window.to) < start || std::max(window.from, window.to) > end) {
        errors.add(request.times, fmt::format("{} goes from {:.6g} s to {:.6g} s", path, start, end),
                   "choose a time within the run");
    } else if (window.take != Window::Take::at && window.from >= window.to) {
        errors.add(request.times, "the time ends before it begins", "let from be before to");
    }
    return Readout{.run = *run, .channel = *channel, .window = window};
}

/// The models that a number is read from, as flags.
std::vector<bool> read_chosen(TomlTable& table, const ReadoutRequest& request,
                              const std::vector<ValidationModel>& models) {
    std::vector<bool> chosen;
    std::vector<std::string> known;
    for (const ValidationModel& model : models) {
        known.push_back(model.key);
        chosen.push_back(!table.has("models") && (request.case_name || request.files.contains(model.key)));
    }
    for (const LocatedString& word : table.texts("models")) {
        if (const auto found = find_name(word, known, "there is no model", "models", table.errors())) {
            chosen[*found] = true;
        }
    }
    return chosen;
}

}  // namespace

Evaluation read_evaluation(TomlTable& table, CaseCache& cache) {
    const std::vector<ValidationModel>& models = cache.models();
    const ReadoutRequest request = read_request(table, {}, models);
    if (!table.has("case") && !table.has("files")) {
        table.text("case", Need::required);
    }
    table.text("channel", Need::required);
    TomlTable minus = table.subtable("minus");
    const ReadoutRequest request_minus = read_request(minus, request, models);
    TomlTable over = table.subtable("over");
    const ReadoutRequest request_over = read_request(over, request, models);
    TomlTable over_minus = over.subtable("minus");
    const ReadoutRequest request_over_minus = read_request(over_minus, request_over, models);

    Evaluation evaluation;
    const bool is_time = request.take == Window::Take::time_to;
    evaluation.meaning = over.exists()    ? Meaning::ratio
                         : is_time        ? Meaning::time
                         : minus.exists() ? Meaning::difference
                                          : Meaning::value;
    const auto quantity = [&](const Readout& readout) {
        return cache.problem(readout.run).channels[readout.channel].quantity;
    };
    const auto difference = [&](const ReadoutRequest& first, const TomlTable& at, const ReadoutRequest& second,
                                const TomlTable& less, const std::string& model) -> std::optional<Difference> {
        const std::optional<Readout> of = resolve(first, model, at, cache);
        const std::optional<Readout> by = less.exists() ? resolve(second, model, less, cache) : std::nullopt;
        if (of && by &&
            (quantity(*of) != quantity(*by) ||
             (of->window.take == Window::Take::time_to) != (by->window.take == Window::Take::time_to))) {
            less.add_error("channel", "this cannot be taken from the reading above it: it has another unit",
                           "read the same quantity in both");
        }
        return of && (by || !less.exists()) ? std::optional(Difference{*of, by}) : std::nullopt;
    };
    const std::vector<bool> chosen = read_chosen(table, request, models);
    evaluation.models.resize(models.size());
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (!chosen[m]) {
            continue;
        }
        const auto of = difference(request, table, request_minus, minus, models[m].key);
        const auto by = over.exists() ? difference(request_over, over, request_over_minus, over_minus, models[m].key)
                                      : std::nullopt;
        if (of) {
            evaluation.quantity = quantity(of->of);
        }
        if (of && (by || !over.exists())) {
            evaluation.models[m] = Expression{*of, by};
        }
    }
    return evaluation;
}

}  // namespace tiretherm::input
