#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/validation/validation_asked.hpp"
#include "input/validation/validation_reader.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

/// The reading for one model, or nothing after a mistake.
std::optional<Readout> resolve(const Asked& asked, std::size_t model, const Section& section, CaseShelf& shelf) {
    Mistakes& mistakes = section.mistakes();
    const std::optional<Word>& file = asked.case_name ? asked.case_name : asked.files[model];
    if (!file || !asked.channel) {
        if (!file && section.exists()) {
            section.mistake("files", fmt::format("{} has no file for {}", section.title(), model_names[model]),
                            fmt::format("add {} to files, or leave it out of models", model_names[model]));
        }
        return std::nullopt;
    }
    const std::string path = asked.case_name ? fmt::format("{}_{}.toml", file->text, model_names[model]) : file->text;
    const std::optional<std::size_t> run = shelf.find(path, file->place, mistakes);
    if (!run) {
        return std::nullopt;
    }
    const solver::Problem& problem = shelf.problem(*run);
    const std::vector<std::string> channels = names_of(problem.channels);
    const auto channel = std::find(channels.begin(), channels.end(), asked.channel->text);
    if (channel == channels.end()) {
        mistakes.add(asked.channel->place, fmt::format("{} has no sensor \"{}\"", path, asked.channel->text),
                     suggest(asked.channel->text, channels, "sensors"));
        return std::nullopt;
    }
    const auto [start, end] = std::pair(problem.settings.start, problem.settings.end);
    const Window window{
        .take = asked.take, .from = asked.from.value_or(start), .to = asked.to.value_or(end), .share = asked.share};
    if (std::min(window.from, window.to) < start || std::max(window.from, window.to) > end) {
        mistakes.add(asked.times, fmt::format("{} goes from {:.6g} s to {:.6g} s", path, start, end),
                     "choose a time within the run");
    } else if (window.take != Window::Take::at && window.from >= window.to) {
        mistakes.add(asked.times, "the time ends before it begins", "let from be before to");
    }
    return Readout{.run = *run, .channel = static_cast<std::size_t>(channel - channels.begin()), .window = window};
}

/// The models that a number is read from, as flags.
std::array<bool, n_models> read_models(Section& section, const Asked& asked) {
    std::array<bool, n_models> chosen{};
    const std::vector<std::string> known(model_names.begin(), model_names.end());
    for (const Word& word : section.texts("models")) {
        const auto found = std::find(known.begin(), known.end(), word.text);
        if (found == known.end()) {
            section.mistakes().add(word.place, fmt::format("there is no model \"{}\"", word.text),
                                   suggest(word.text, known, "models"));
        } else {
            chosen[static_cast<std::size_t>(found - known.begin())] = true;
        }
    }
    for (std::size_t m = 0; m < n_models && !section.has("models"); ++m) {
        chosen[m] = asked.case_name || asked.files[m];
    }
    return chosen;
}

}  // namespace

Reckoning read_reckoning(Section& section, CaseShelf& shelf) {
    const Asked asked = read_asked(section, {});
    if (!section.has("case") && !section.has("files")) {
        section.text("case", Need::required);
    }
    section.text("channel", Need::required);
    Section minus = section.section("minus");
    const Asked asked_minus = read_asked(minus, asked);
    Section over = section.section("over");
    const Asked asked_over = read_asked(over, asked);
    Section over_minus = over.section("minus");
    const Asked asked_over_minus = read_asked(over_minus, asked_over);

    Reckoning reckoning;
    const bool is_time = asked.take == Window::Take::time_to;
    reckoning.meaning = over.exists()    ? Meaning::ratio
                        : is_time        ? Meaning::time
                        : minus.exists() ? Meaning::difference
                                         : Meaning::value;
    const auto quantity = [&](const Readout& readout) {
        return shelf.problem(readout.run).channels[readout.channel].quantity;
    };
    const auto difference = [&](const Asked& first, const Section& at, const Asked& second, const Section& less,
                                std::size_t model) -> std::optional<Difference> {
        const std::optional<Readout> of = resolve(first, model, at, shelf);
        const std::optional<Readout> by = less.exists() ? resolve(second, model, less, shelf) : std::nullopt;
        if (of && by &&
            (quantity(*of) != quantity(*by) ||
             (of->window.take == Window::Take::time_to) != (by->window.take == Window::Take::time_to))) {
            less.mistake("channel", "this cannot be taken from the reading above it: it has another unit",
                         "read the same quantity in both");
        }
        return of && (by || !less.exists()) ? std::optional(Difference{*of, by}) : std::nullopt;
    };
    const std::array<bool, n_models> chosen = read_models(section, asked);
    for (std::size_t m = 0; m < n_models; ++m) {
        if (!chosen[m]) {
            continue;
        }
        const auto of = difference(asked, section, asked_minus, minus, m);
        const auto by = over.exists() ? difference(asked_over, over, asked_over_minus, over_minus, m) : std::nullopt;
        if (of) {
            reckoning.quantity = quantity(of->of);
        }
        if (of && (by || !over.exists())) {
            reckoning.models[m] = Expression{*of, by};
        }
    }
    return reckoning;
}

}  // namespace tiretherm::input
