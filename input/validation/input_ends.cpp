// SPDX-License-Identifier: BSD-3-Clause
// How a number is read where an input of its experiment is at an end of its range: in a changed case, at a moved moment,
// from another sensor, from another case or at another share.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/validation/validation_reader.hpp"

namespace tiretherm::input {

namespace {

bool changes_cases(const InputDefinition& input) {
    return input.action == InputAction::keys || input.action == InputAction::signal ||
           input.action == InputAction::parts;
}

/// Changes readouts; collects what is wrong with the words of an input.
class EndReader {
public:
    EndReader(const InputDefinition& input, CaseCache& cache, InputErrors& errors)
        : input_(input), cache_(cache), errors_(errors) {}

    /// Whether the input acts on a readout.
    [[nodiscard]] bool acts(const Readout& readout) {
        switch (input_.action) {
            case InputAction::none:
                return false;
            case InputAction::channel:
                return belongs(readout) && name_of(readout) == input_.shown.value;
            case InputAction::of_case:
                return cache_.is_case(readout.run, input_.shown.value);
            case InputAction::time_to:
                return belongs(readout) && readout.window.take == Window::Take::time_to &&
                       std::abs(readout.window.share - si(input_.value)) < 1e-9;
            case InputAction::keys:
            case InputAction::signal:
            case InputAction::parts:
                return cache_.acts(input_, readout.run, errors_);
        }
        return false;
    }

    /// @returns false after an error   @pre acts(readout)
    bool change(Readout& readout, std::size_t end, std::string_view model) {
        switch (input_.action) {
            case InputAction::channel:
                return set_channel(readout, input_.words[end]);
            case InputAction::of_case:
                return set_case(readout, input_.words[end], model);
            case InputAction::time_to:
                readout.window.share = si(input_.ends[end]);
                return true;
            case InputAction::none:
                return true;
            case InputAction::keys:
            case InputAction::signal:
            case InputAction::parts:
                break;
        }
        const std::optional<std::size_t> run = cache_.at_end(input_, end, readout.run, errors_);
        readout.run = run.value_or(readout.run);
        if (input_.action == InputAction::parts) {
            const double length = length_of(input_, end);
            readout.window.from = moved_moment(readout.window.from, input_.parts, length);
            readout.window.to = moved_moment(readout.window.to, input_.parts, length);
        }
        return run.has_value();
    }

private:
    static double si(const Measure& measure) {
        InputErrors unheard;
        return in_unit(measure, "1", false, "value", unheard).value_or(measure.number);
    }
    [[nodiscard]] bool belongs(const Readout& readout) const {
        return input_.cases.empty() || std::ranges::any_of(input_.cases, [&](const LocatedString& name) {
                   return cache_.is_case(readout.run, name.text);
               });
    }
    [[nodiscard]] const std::string& name_of(const Readout& readout) const {
        return cache_.problem(readout.run).channels[readout.channel].name;
    }

    bool set_channel(Readout& readout, const LocatedString& name) {
        const std::vector<std::string> channels = names_of(cache_.problem(readout.run).channels);
        const auto found =
            find_name(name, channels, cache_.problem(readout.run).name + " has no sensor", "sensors", errors_);
        readout.channel = found.value_or(readout.channel);
        return found.has_value();
    }

    bool set_case(Readout& readout, const LocatedString& word, std::string_view model) {
        const std::string channel = name_of(readout);
        const std::optional<std::size_t> run =
            cache_.find(fmt::format("{}_{}.toml", word.text, model), word.place, errors_);
        if (!run) {
            return false;
        }
        const solver::Settings& settings = cache_.problem(*run).settings;
        readout.run = *run;
        if (readout.window.from < settings.start || readout.window.to > settings.end) {
            errors_.add(word.place,
                        fmt::format("{} goes from {:.6g} s to {:.6g} s", cache_.problem(*run).name, settings.start,
                                    settings.end),
                        "name a case that has the times of the number");
            return false;
        }
        return set_channel(readout, {channel, word.place});
    }

    const InputDefinition& input_;
    CaseCache& cache_;
    InputErrors& errors_;
};

/// The number at all ends of an input. @returns whether it acts on any model
bool read_ends(const InputDefinition& definition, const Evaluation& evaluation,
               const std::vector<ValidationModel>& models, EndReader& reader, NumberInput& input) {
    const std::size_t n_ends = std::max(definition.ends.size(), definition.words.size());
    bool acts = false;
    for (std::size_t m = 0; m < models.size(); ++m) {
        bool here = false;
        if (evaluation.models[m]) {
            visit_readouts(*evaluation.models[m], [&](const Readout& readout) { here = reader.acts(readout) || here; });
        }
        acts = acts || here;
        for (std::size_t end = 0; here && end < n_ends; ++end) {
            input.at_ends.resize(n_ends, std::vector<std::optional<Expression>>(models.size()));
            Expression changed = *evaluation.models[m];
            bool sound = true;
            visit_readouts(changed, [&](Readout& readout) {
                sound = (!reader.acts(readout) || reader.change(readout, end, models[m].key)) && sound;
            });
            if (sound) {
                input.at_ends[end][m] = changed;
            }
        }
    }
    return acts;
}

}  // namespace

std::vector<NumberInput> read_number_inputs(TomlTable& table, const std::vector<InputDefinition>& inputs,
                                            const Evaluation& evaluation, CaseCache& cache) {
    const std::vector<std::string> names =
        names_of(inputs, [](const InputDefinition& input) { return input.shown.name; });
    std::vector<NumberInput> found;
    const auto read = [&](const LocatedString& word, bool inferred_from_it) {
        const auto name = std::ranges::find(names, word.text);
        if (name == names.end()) {
            table.errors().add(word.place, fmt::format("there is no input \"{}\"", word.text),
                               names.empty() ? "add [[input]]" : suggest(word.text, names, "inputs"));
            return;
        }
        const auto index = static_cast<std::size_t>(name - names.begin());
        const InputDefinition& definition = inputs[index];
        NumberInput input{.input = index, .inferred_from_it = inferred_from_it, .at_ends = {}};
        if (std::ranges::find(found, index, &NumberInput::input) != found.end()) {
            table.errors().add(word.place, fmt::format("the input \"{}\" is named twice", word.text),
                               "keep it in one of inputs and inferred_from_it");
            return;
        }
        if (inferred_from_it && definition.shown.standing != Standing::inferred) {
            table.errors().add(word.place,
                               fmt::format("the input \"{}\" is {}, not inferred", word.text,
                                           standing_names[static_cast<std::size_t>(definition.shown.standing)]),
                               "name it in inputs");
        }
        EndReader reader(definition, cache, table.errors());
        const bool any_model =
            std::ranges::any_of(evaluation.models, [](const auto& model) { return model.has_value(); });
        if (!read_ends(definition, evaluation, cache.models(), reader, input) && any_model &&
            definition.action != InputAction::none) {
            table.errors().add(word.place,
                               fmt::format("the input \"{}\" acts on nothing that this number is read from", word.text),
                               changes_cases(definition) ? "name cases that give what it changes"
                                                         : "let its value be what the number is read from");
        }
        found.push_back(std::move(input));
    };
    for (const LocatedString& word : table.texts("inputs")) {
        read(word, false);
    }
    for (const LocatedString& word : table.texts("inferred_from_it")) {
        read(word, true);
    }
    return found;
}

}  // namespace tiretherm::input
