// SPDX-License-Identifier: BSD-3-Clause
// Reads the table file, evaluates readouts, differences and ratios, and selects experiments with the runs that they
// need.

#include "input/validation/validation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/validation/validation_reader.hpp"

namespace tiretherm::input {

namespace {

double read(const Readout& readout, const std::vector<Trace>& traces) {
    return traces[readout.run].read(readout.channel, readout.window);
}

double read(const Difference& difference, const std::vector<Trace>& traces) {
    return read(difference.of, traces) - (difference.minus ? read(*difference.minus, traces) : 0.0);
}

/// [[model]]; without any the two of the case library.
std::vector<ValidationModel> read_models(TomlTable& root) {
    std::vector<ValidationModel> models;
    root.each("model", [&](TomlTable& table) {
        const std::string key = table.text("key", Need::required).value_or("");
        const std::string name = table.text("name").value_or(key);
        if (std::ranges::find(models, key, &ValidationModel::key) != models.end()) {
            table.add_error("key", fmt::format("there are two models \"{}\"", key), "rename one of them");
        } else if (!key.empty()) {
            const std::string of = table.text("of").value_or("");
            const std::string with = table.text("with").value_or("");
            const auto base = std::ranges::find(models, of, &ValidationModel::key);
            if (of.empty() != with.empty()) {
                table.add_error(of.empty() ? "with" : "of", "`of` and `with` are given together or not at all",
                                "write of = \"section\" and with = \"all_heat_paths.toml\"");
            } else if (!of.empty() && (base == models.end() || !base->of.empty())) {
                table.add_error("of", fmt::format("no model \"{}\" with cases of its own stands above this one", of),
                                "give the key of a [[model]] above that has no `of`");
            }
            models.push_back({.key = key, .name = name, .of = of, .with = with});
        }
    });
    return models.empty() ? std::vector<ValidationModel>{{"two_node", "two nodes"}, {"section", "section"}} : models;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

double Expression::value(const std::vector<Trace>& traces) const {
    return read(of, traces) / (over ? read(*over, traces) : 1.0);
}

std::vector<std::size_t> Expression::runs() const {
    std::vector<std::size_t> found;
    visit_readouts(*this, [&](const Readout& readout) { found.push_back(readout.run); });
    return found;
}

double ValidationNumber::total_uncertainty() const {
    double squares = 0.0;
    for (const auto& [name, part] : uncertainty) {
        squares += part * part;
    }
    return std::sqrt(squares);
}

std::vector<std::string> Validation::ids() const {
    std::vector<std::string> found;
    for (const ValidationNumber& number : numbers) {
        if (!has(found, number.id)) {
            found.push_back(number.id);
        }
    }
    return found;
}

std::vector<std::string> Validation::keep(const std::vector<std::string>& wanted) {
    const std::vector<std::string> known = ids();
    std::vector<std::string> unknown;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(unknown),
                 [&](const std::string& id) { return !has(known, id); });
    std::erase_if(numbers, [&](const ValidationNumber& number) { return !has(wanted, number.id); });

    constexpr std::size_t unused = static_cast<std::size_t>(-1);
    std::vector<std::size_t> renumbered(runs.size(), unused);
    std::vector<ValidationRun> kept;
    for (ValidationNumber& number : numbers) {
        const auto renumber = [&](std::vector<std::optional<Expression>>& models) {
            for (std::optional<Expression>& expression : models) {
                if (!expression) {
                    continue;
                }
                visit_readouts(*expression, [&](Readout& readout) {
                    std::size_t& place = renumbered[readout.run];
                    if (place == unused) {
                        place = kept.size();
                        kept.push_back(std::move(runs[readout.run]));
                    }
                    readout.run = place;
                });
            }
        };
        renumber(number.models);
        for (NumberInput& input : number.inputs) {
            std::ranges::for_each(input.at_ends, renumber);
        }
    }
    runs = std::move(kept);
    return unknown;
}

bool is_validation_table(const std::filesystem::path& file) {
    InputErrors unheard;
    const std::optional<TomlValue> document = read_document(file, unheard);
    return document && document->find("number") != nullptr;
}

ValidationReading read_validation(const std::filesystem::path& file) {
    InputErrors errors;
    std::optional<CaseCache> cache;
    Validation validation;
    if (const std::optional<TomlValue> document = read_document(file, errors)) {
        TomlTable root(*document, "the table", errors);
        root.declare_keys({"include", "unset", "set"});
        validation.title = root.text("title").value_or("Validation");
        validation.models = read_models(root);
        cache.emplace(file.parent_path(), validation.models);
        std::vector<InputDefinition> inputs;
        root.each("input", [&](TomlTable& table) {
            inputs.push_back(read_input(table, inputs));
            cache->check_names(inputs.back().cases, errors);
        });
        root.each(
            "number", [&](TomlTable& table) { validation.numbers.push_back(read_number(table, inputs, *cache)); },
            Need::required);
        for (const InputDefinition& input : inputs) {
            validation.inputs.push_back(input.shown);
        }
    }
    ValidationReading reading{
        .table = std::nullopt, .errors = errors.in_order(), .warnings = render(errors.warnings(), 0)};
    if (cache) {
        cache->append_messages(reading);
    }
    if (reading.errors.empty()) {
        validation.runs = cache->take_runs();
        reading.table = std::move(validation);
    }
    return reading;
}

}  // namespace tiretherm::input
