// SPDX-License-Identifier: BSD-3-Clause
// The tables [[parameter]], [identify] and [diagnose].
#include "input/parameters/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

#include "input/parameters/effect_names.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

using solver::FreeParameter;

bool is_law(const FreeParameter& number) { return !number.knots.empty(); }

/// Whether a value is beyond the bounds by more than rounding: a case may hold what a fit has left at one of them.
bool is_below(double value, double low) { return value < low - 1e-9 * std::abs(value); }
bool is_above(double value, double high) { return value > high + 1e-9 * std::abs(value); }

/// Values as messages show them: "0.29 W m-1 K-1".
std::string shown(double value, std::string_view unit) {
    return unit == "1" ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

/// The key `expected`: one value, or of a law that is free at several temperatures one for each of them.
void read_expected(TomlTable& table, FreeParameters& freed) {
    std::vector<FreeParameter>& numbers = freed.numbers;
    if (!is_law(numbers.front()) || numbers.size() == 1) {
        if (const auto value = table.quantity("expected", freed.spec)) {
            for (FreeParameter& number : numbers) {
                number.prior = *value;
            }
        }
        return;
    }
    const std::vector<LocatedString> words = table.texts("expected");
    if (!table.has("expected")) {
        return;
    }
    if (words.size() != numbers.size()) {
        table.add_error("expected", fmt::format("expected has {} of {} values", words.size(), numbers.size()),
                        "give one for each temperature of at, in their order");
        return;
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
        numbers[i].prior = read_quantity(words[i], freed.spec, "expected", table.errors()).value_or(numbers[i].prior);
    }
}

/// What is known of the numbers beforehand, and how far they may go.
void read_prior(TomlTable& table, const solver::Problem& of_first, const std::vector<RunOfParameter>& runs,
                FreeParameters& freed) {
    const QuantitySpec deviation{.unit = freed.spec.unit, .scale = Scale::difference, .low = 0.0, .above = true};
    const auto sigma = table.quantity("standard_deviation", deviation);
    const std::size_t before = table.errors().count();
    std::vector<double> now;
    for (FreeParameter& number : freed.numbers) {
        const solver::Problem& problem = number.runs.empty() ? of_first : *runs[number.runs.front()].problem;
        now.push_back(solver::value_of(problem, number));
        number.prior = now.back();
    }
    read_expected(table, freed);
    const auto low = table.quantity("low", freed.spec);
    const auto high = table.quantity("high", freed.spec);
    const bool sound = table.errors().count() == before;
    for (std::size_t i = 0; i < freed.numbers.size(); ++i) {
        FreeParameter& number = freed.numbers[i];
        if (is_law(number)) {  // bounds that the user did not ask for shall not stand in the way of what he expects
            number.low *= std::min(1.0, number.prior / now[i]);
            number.high *= std::max(1.0, number.prior / now[i]);
        }
        number.standard_deviation = sigma.value_or(number.standard_deviation);
        number.low = low.value_or(number.low);
        number.high = high.value_or(number.high);
        if (!sound) {
            continue;
        }
        const std::string bounds =
            fmt::format("{} to {}", shown(number.low, number.unit), shown(number.high, number.unit));
        if (number.low >= number.high) {
            table.add_error(high ? "high" : "low", fmt::format("the bounds {} are empty", bounds),
                            "let low be smaller than high");
            return;
        }
        const auto report_outside = [&](std::string_view key, std::string_view whose, double value) {
            table.add_error(key,
                            fmt::format("{} {} lies outside the bounds {}", whose, shown(value, number.unit), bounds),
                            key == "expected" ? "widen the bounds" : "widen the bounds, or change the case's value");
        };
        if (is_below(number.prior, number.low) || is_above(number.prior, number.high)) {
            const std::string_view bound = low && is_below(number.prior, number.low) ? "low" : "high";
            const bool given = table.has("expected");
            report_outside(given ? "expected" : bound, given ? "expected" : "the case's value", number.prior);
            return;
        }
        if (is_below(now[i], number.low) || is_above(now[i], number.high)) {
            report_outside(low && is_below(now[i], number.low) ? "low" : "high", "the case's value", now[i]);
            return;
        }
        number.prior = std::clamp(number.prior, number.low, number.high);
    }
}

template <typename Index>
bool meet(const std::vector<Index>& a, const std::vector<Index>& b) {
    return std::any_of(a.begin(), a.end(), [&](Index i) { return std::find(b.begin(), b.end(), i) != b.end(); });
}

/// Whether two entries move the same number, or numbers that lie in each other.
bool same(const FreeParameter& a, const FreeParameter& b) {
    const auto address = [](const FreeParameter& number) {
        return std::tie(number.effect, number.parameter, number.everywhere, number.scope, number.place);
    };
    const bool share_a_run = a.runs.empty() || b.runs.empty() || meet(a.runs, b.runs);
    if (a.kind != b.kind || !share_a_run) {
        return false;
    }
    if (a.kind == FreeParameter::Kind::input) {
        return a.parameter == b.parameter;
    }
    return a.kind == FreeParameter::Kind::effect
               ? address(a) == address(b)
               : a.kind == FreeParameter::Kind::link_conductivity || meet(a.layers, b.layers) || meet(a.nodes, b.nodes);
}

/// Whether a number is free everywhere and again at a place that has no value of its own.
bool follows(const solver::Problem& problem, const FreeParameter& everywhere, const FreeParameter& here) {
    if (everywhere.kind != FreeParameter::Kind::effect || here.kind != FreeParameter::Kind::effect ||
        everywhere.effect != here.effect || everywhere.parameter != here.parameter || !everywhere.everywhere ||
        here.everywhere) {
        return false;
    }
    const auto& own = problem.effects[here.effect].overrides;
    return std::none_of(own.begin(), own.end(), [&](const auto& value) {
        return value.scope == here.scope && value.index == here.place && value.parameter == here.parameter;
    });
}

/// Adds the numbers of an entry, unless one of them is free already.
/// @param places of the entries that freed those before
void add(const TomlTable& table, const solver::Problem& problem, const FreeParameters& freed,
         std::vector<SourceLocation>& places, std::vector<FreeParameter>& into) {
    const std::size_t before = into.size();
    const auto refuse = [&](std::string what, std::string remedy) {
        table.errors().add(table.place(), std::move(what), std::move(remedy));
    };
    for (const FreeParameter& number : freed.numbers) {
        // The values of one law at its temperatures are distinguished by its knots.
        for (std::size_t i = 0; i < (is_law(number) ? before : into.size()); ++i) {
            const FreeParameter& other = into[i];
            const std::string where = i < before ? ", at " + table.errors().spell(places[i]) : " in this [[parameter]]";
            if (same(number, other)) {
                const bool alike = number.name == other.name;
                refuse(fmt::format("{} is already a free parameter{}{}", number.name,
                                   alike ? "" : " with " + other.name, where),
                       is_law(number) ? "name all temperatures of a law in one [[parameter]]" : "remove one");
                return;
            }
            const bool general = follows(problem, number, other);
            if (general || follows(problem, other, number)) {
                const FreeParameter& here = general ? other : number;
                const physics::ActiveEffect& active = problem.effects[here.effect];
                refuse(
                    fmt::format("{} follows {}: both are free{}", here.name, general ? number.name : other.name, where),
                    fmt::format("give the place a value of its own, {}{} in [effects.{}], or free one of them",
                                active.effect->parameters[here.parameter].key, key_ending(here.scope), active.title()));
                return;
            }
        }
        into.push_back(number);
        places.push_back(table.place());
    }
}

/// The one of these keys that says what is free, or an error. A key with dots in it is a path by itself.
std::string_view read_subject(const TomlTable& table) {
    std::string_view found;
    for (const ParameterKind& kind : parameter_kinds()) {
        for (const std::string_view subject : kind.subjects) {
            if (table.has(subject) && !found.empty()) {
                table.add_error(subject, fmt::format("both {} and {} are given", found, subject),
                                "keep one of them: a [[parameter]] for each");
                return {};
            }
            found = table.has(subject) ? subject : found;
        }
    }
    const TomlValue* key = table.content().find("key");
    if (found.empty() && key != nullptr && key->text.find('.') != std::string::npos) {
        return "key";
    }
    if (found.empty()) {
        table.errors().add(table.place(), "[[parameter]] does not say what is free",
                           "add effect = \"...\", source = \"...\", material = \"...\", link = \"conductivity\" or "
                           "initial = \"temperature\"");
    }
    return found;
}

/// The kind of parameter that a [[parameter]] frees by one of its subjects.
const ParameterKind& kind_of(std::string_view subject) {
    return *std::ranges::find_if(parameter_kinds(), [&](const ParameterKind& kind) {
        return std::ranges::find(kind.subjects, subject) != kind.subjects.end();
    });
}

/// The paths that a [[parameter]] names: several of initial temperatures only. None after an error.
std::vector<ParameterPath> read_paths(TomlTable& table, std::string_view subject, const TomlValue& document) {
    if (subject != "key") {
        return kind_of(subject).paths_of_table(table, subject, document);
    }
    const auto path = ParameterPath::parse(located(table, "key"), document, table.errors());
    return path ? std::vector{*path} : std::vector<ParameterPath>{};
}

}  // namespace

void read_parameters(TomlTable& root, const CaseAsRead& in, const std::vector<RunOfParameter>& runs,
                     std::vector<FreeParameter>& into) {
    std::vector<SourceLocation> places;
    root.each("parameter", [&](TomlTable& table) {
        table.declare_keys({"expected", "standard_deviation", "low", "high", "each"});
        const std::string_view subject = read_subject(table);
        if (subject.empty()) {
            table.allow_unknown_keys();
            return;
        }
        const std::vector<ParameterPath> paths = read_paths(table, subject, in.document);
        const bool is_law = subject == "material" || subject == "link" || (!paths.empty() && paths.front().is_law());
        const Knots knots = is_law ? read_knots(table) : Knots{};
        FreeParameters freed{.numbers = {}, .spec = {}};
        for (const ParameterPath& path : paths) {
            std::optional<FreeParameters> found = find_parameters(path, in, knots);
            if (!found) {
                return;
            }
            freed.spec = found->spec;
            std::ranges::move(found->numbers, std::back_inserter(freed.numbers));
        }
        if (!freed.numbers.empty()) {
            if (!give_each_group_its_own(table, in.problem, runs, freed.numbers)) {
                return;
            }
            read_prior(table, in.problem, runs, freed);
            add(table, in.problem, freed, places, into);
        }
    });
}

void read_identify(TomlTable& root, Experiment& into) {
    TomlTable table = root.subtable("identify");
    into.noise = table.word("noise").value_or("automatic");
    into.robust = table.flag("robust").value_or(into.robust);
}

SignalChoice read_diagnose(TomlTable& root, const solver::Problem& problem, Experiment& into) {
    TomlTable table = root.subtable("diagnose");
    table.declare_keys({"possible"});  // read when all runs are known
    std::vector<std::string> known;
    for (const physics::Effect* effect : physics::catalogue()) {
        known.emplace_back(effect->id);
        const bool is_on =
            std::ranges::find(problem.effects, effect, &physics::ActiveEffect::effect) != problem.effects.end();
        for (std::size_t p = 0; p < effect->parameters.size(); ++p) {
            if (is_on || !std::isnan(effect->parameters[p].absent)) {
                known.push_back(CatalogueEntry{.effect = effect, .parameter = p}.text());
            }
        }
    }
    for (const LocatedString& word : table.texts("candidates")) {
        const std::optional<CatalogueEntry> entry = find_in_catalogue(word.text);
        if (!entry || std::ranges::find(known, entry->text()) == known.end()) {
            root.errors().add(
                word.place,
                fmt::format("there is no effect \"{}\" that may be missing or have a wrong number", word.text),
                suggest(word.text, known, "effects"));
        } else {
            into.candidates.push_back(entry->text());
        }
    }
    return read_signal_choice(table);
}

}  // namespace tiretherm::input
