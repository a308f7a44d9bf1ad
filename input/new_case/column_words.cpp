// SPDX-License-Identifier: BSD-3-Clause
// Guesses what a column of a log may be. A guess is written as a comment only, for the user to judge.
#include "input/new_case/column_words.hpp"

#include <algorithm>
#include <array>

#include "input/loggers/logger_units.hpp"
#include "input/text/characters.hpp"
#include "input/text/column_names.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace {

/// Words by which loggers call a quantity. A heading is the more likely the quantity, the more of them it has.
struct Vocabulary {
    std::string_view ending;  ///< of the names that it is about
    std::string_view words;
};
constexpr std::array vocabularies{
#define COLUMN_GUESS(name, words) Vocabulary{name, words},
#include "input/text/column_names.list"
};
constexpr std::array zone_words{
    std::pair<std::string_view, std::string_view>{"outside_shoulder_", "outside outboard outer"},
    std::pair<std::string_view, std::string_view>{"inside_shoulder_", "inboard inside"},
    std::pair<std::string_view, std::string_view>{"crown_", "crown centre center middle mid"}};

/// How many words of a heading speak for a meaning; a side counts half, so that it decides between equals.
double score(const std::vector<std::string>& words, std::string_view name) {
    double points = 0.0;
    for (const auto& [zone, list] : zone_words) {
        if (name.starts_with(zone)) {
            const bool named = std::ranges::any_of(
                words, [&words_of_zone = list](const auto& word) { return has_word(words_of_zone, word); });
            if (!named) {
                return 0.0;
            }
            points += 0.5;
            name.remove_prefix(zone.size());
        }
    }
    const auto found = std::ranges::find(vocabularies, name, &Vocabulary::ending);
    if (found == vocabularies.end()) {
        return 0.0;
    }
    const auto hits =
        std::ranges::count_if(words, [&](const std::string& word) { return has_word(found->words, word); });
    return hits == 0 ? 0.0 : points + static_cast<double>(hits);
}

bool suits(const Heading& heading, const QuantitySpec& spec) {
    if (!heading.unit || trim(*heading.unit).empty() || trim(*heading.unit) == "-") {
        return !heading.unit || spec.is_pure();
    }
    return !read_heading_unit(heading, spec).error || !guess_unit(*heading.unit, spec.unit, spec.scale).empty();
}

}  // namespace

bool is_pressure(const Heading& heading) { return heading.unit && !read_heading_unit(heading, {.unit = "Pa"}).error; }

std::vector<ColumnMeaning> meanings_of(const MeshTemplate& mesh) {
    std::vector<ColumnMeaning> all{{.name = "time", .spec = quantity_specs::moment}};
    for (const physics::Signal& signal : physics::signals()) {
        all.push_back({.name = std::string(signal.name), .spec = quantity_specs::of(signal), .is_input = true});
    }
    for (const TemplateSensor& sensor : mesh.sensors) {
        all.push_back({.name = sensor.name, .spec = sensor.spec, .is_sensor = true});
    }
    for (const VehicleSignal& signal : vehicle_signals()) {
        all.push_back({.name = std::string(signal.name),
                       .spec = {.unit = signal.unit.empty() ? "1" : signal.unit},
                       .is_input = true,
                       .any_unit = signal.unit.empty()});
    }
    return all;
}

const ColumnMeaning* find_meaning(const std::vector<ColumnMeaning>& meanings, std::string_view name) {
    const auto found = std::ranges::find(meanings, name, &ColumnMeaning::name);
    return found == meanings.end() ? nullptr : &*found;
}

std::string usual_unit(const QuantitySpec& spec) {
    const std::string example = dimension(spec.unit, spec.scale).example;
    const std::size_t blank = example.find(' ');
    return blank == std::string::npos ? std::string(spec.unit) : example.substr(blank + 1);
}

const ColumnMeaning* guess_meaning(const Heading& heading, const std::vector<ColumnMeaning>& meanings) {
    const std::vector<std::string> words = words_of(heading.name);
    const ColumnMeaning* best = nullptr;
    double most = 0.0;
    std::vector<std::string> near_names;
    for (const ColumnMeaning& meaning : meanings) {
        if (!suits(heading, meaning.spec)) {
            continue;
        }
        near_names.push_back(meaning.name);
        if (const double points = score(words, meaning.name); points > most) {
            most = points;
            best = &meaning;
        }
    }
    const std::string near = nearest(heading.name, near_names);
    // A slip of the pen in a standard name says more than any number of words.
    if (!near.empty()) {
        return find_meaning(meanings, near);
    }
    return best;
}

}  // namespace tiretherm::input
