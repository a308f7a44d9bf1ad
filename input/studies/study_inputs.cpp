// SPDX-License-Identifier: BSD-3-Clause
// Reads [[vary]] (list or range of values), [[draw]] (distribution) and [sample] (number of samples, seed) of a study.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/studies/study.hpp"

namespace tiretherm::input {

namespace {

LocatedString read_key(TomlTable& table) {
    const std::optional<std::string> key = table.text("key", Need::required);
    return {key.value_or(""), table.place("key")};
}

/// values = ["80 km/h", "120 km/h"]
void read_values(TomlTable& table, StudyInput& input) {
    const TomlValue* list = table.value("values");
    if (list->kind != TomlValue::Kind::array || list->items.empty()) {
        table.add_error("values", fmt::format("values is {}; a list of values is wanted", shown(*list)),
                        "write values = [\"80 km/h\", \"120 km/h\"]");
        return;
    }
    for (const TomlValue& item : list->items) {
        const bool value =
            item.kind == TomlValue::Kind::text || item.kind == TomlValue::Kind::boolean || item.is_number();
        if (!value) {
            table.errors().add(item.place, fmt::format("values has {}; a quantity or a word is wanted", shown(item)));
            continue;
        }
        input.values.push_back(study_value(item));
        input.is_number = input.is_number && std::isfinite(input.values.back().number);
    }
    if (input.values.empty() || !input.is_number) {
        return;
    }
    // The column has one unit; the case gets each value as it is written, and says itself what is wrong with a unit.
    input.unit = unit_of(list->items.front());
    InputErrors unheard;
    for (StudyValue& value : input.values) {
        const Measure measure{.number = value.number, .unit = unit_of(value.node), .whole = false, .place = {}};
        if (is_unit(measure.unit) && is_unit(input.unit)) {
            value.number = in_unit(measure, input.unit, false, "", unheard).value_or(value.number);
        }
    }
}

/// from = "60 km/h", to = "140 km/h", count = 5
void read_range(TomlTable& table, StudyInput& input) {
    const std::optional<Measure> from = read_measure(table, "from", Need::required);
    const std::optional<Measure> to = read_measure(table, "to", Need::required);
    const std::optional<int> count = table.count("count", Need::required);
    const std::optional<double> end = from && to ? in_unit(*to, from->unit, false, "to", table.errors()) : std::nullopt;
    if (!end || !count) {
        return;
    }
    input.unit = from->unit;
    for (int i = 0; i < *count; ++i) {
        const double share = static_cast<double>(i) / (*count - 1);
        const double number = (1.0 - share) * from->number + share * *end;
        const bool whole = from->whole && to->whole && number == std::round(number);
        input.values.push_back(study_value(number, from->unit, whole, i + 1 == *count ? to->place : from->place));
    }
}

StudyInput read_vary(TomlTable& table) {
    StudyInput input{.key = read_key(table), .unit = {}, .values = {}};
    if (table.has("values")) {
        for (const char* other : {"from", "to", "count"}) {
            if (table.has(other)) {
                table.add_error(other, fmt::format("both values and {} are given", other),
                                "keep values, or from, to and count");
            }
        }
        table.declare_keys({"from", "to", "count"});
        read_values(table, input);
    } else if (table.has("from") || table.has("to") || table.has("count")) {
        table.declare_keys({"values"});
        read_range(table, input);
    } else {
        table.declare_keys({"from", "to", "count"});
        static_cast<void>(table.value("values", Need::required, "values = [\"80 km/h\", \"120 km/h\"]"));
    }
    return input;
}

/// The numbers of one [[draw]], each in the unit of the first.
struct Drawn {
    Distribution distribution;
    std::string unit;
    SourceLocation place;
    bool sound = false;
};

Drawn read_distribution(TomlTable& table) {
    Drawn drawn;
    const std::optional<std::string_view> word = table.word("distribution");
    table.declare_keys({"mean", "standard_deviation", "from", "to", "low", "high"});
    if (!word) {
        return drawn;
    }
    const bool uniform = *word == "uniform";
    drawn.distribution.spread = uniform ? Spread::uniform : *word == "normal" ? Spread::normal : Spread::lognormal;
    for (const char* other : uniform ? std::array{"mean", "standard_deviation"} : std::array{"from", "to"}) {
        if (table.has(other)) {
            table.add_error(other, fmt::format("a {} distribution has no {}", *word, other),
                            uniform ? "write from and to" : "write mean and standard_deviation");
        }
    }
    const std::size_t before = table.errors().count();
    const char* first = uniform ? "from" : "mean";
    const char* second = uniform ? "to" : "standard_deviation";
    const std::optional<Measure> a = read_measure(table, first, Need::required);
    const std::optional<Measure> b = read_measure(table, second, Need::required);
    const std::optional<Measure> low = read_measure(table, "low", Need::optional);
    const std::optional<Measure> high = read_measure(table, "high", Need::optional);
    if (!a || !b) {
        return drawn;
    }
    drawn.unit = a->unit;
    drawn.place = a->place;
    const auto convert = [&](const std::optional<Measure>& from, const char* key, bool difference, double& into) {
        if (from) {
            into = in_unit(*from, a->unit, difference, key, table.errors()).value_or(into);
        }
    };
    drawn.distribution.a = a->number;
    convert(b, second, !uniform, drawn.distribution.b);
    convert(low, "low", false, drawn.distribution.low);
    convert(high, "high", false, drawn.distribution.high);
    if (table.errors().count() > before) {
        return drawn;
    }
    const Distribution& d = drawn.distribution;
    if (uniform ? d.b <= d.a : d.b <= 0.0) {
        table.add_error(
            second, uniform ? "the distribution ends before it begins" : "the standard deviation is not positive",
            uniform ? "let from be smaller than to" : "write a positive one, or use [[vary]] with one value");
    } else if (d.spread == Spread::lognormal && d.a <= 0.0) {
        table.add_error("mean", "a lognormal quantity is positive, and its mean is not", "use a normal distribution");
    } else if (!(d.kept() > 1e-9)) {
        table.add_error(table.has("low") ? "low" : "high",
                        "hardly anything of the distribution lies between low and high", "widen the bounds");
    }
    drawn.sound = table.errors().count() == before;
    return drawn;
}

StudyInput read_draw(TomlTable& table, std::size_t samples, std::uint64_t seed) {
    StudyInput input{.key = read_key(table), .unit = {}, .is_drawn = true, .values = {}};
    const Drawn drawn = read_distribution(table);
    input.unit = drawn.unit;
    for (std::size_t s = 0; drawn.sound && s < samples; ++s) {
        const double number = drawn.distribution.quantile(draw(seed, s, input.key.text));
        input.values.push_back(study_value(number, drawn.unit, false, drawn.place));
    }
    return input;
}

}  // namespace

std::vector<StudyInput> read_study_inputs(TomlTable& root, std::size_t& samples, std::uint64_t& seed) {
    TomlTable sample = root.subtable("sample");
    if (sample.exists()) {
        samples = static_cast<std::size_t>(sample.count("count").value_or(1));
        seed = static_cast<std::uint64_t>(sample.count("seed").value_or(1));
    }
    std::vector<StudyInput> inputs;
    root.each("vary", [&](TomlTable& table) { inputs.push_back(read_vary(table)); });
    root.each("draw", [&](TomlTable& table) { inputs.push_back(read_draw(table, samples, seed)); });
    for (auto input = inputs.begin(); input != inputs.end(); ++input) {
        const auto same = std::find_if(inputs.begin(), input,
                                       [&](const StudyInput& other) { return other.key.text == input->key.text; });
        if (same != input && !input->key.text.empty()) {
            root.errors().add(input->key.place,
                              fmt::format("\"{}\" is varied twice, here and at {}", input->key.text,
                                          root.errors().spell(same->key.place)),
                              "keep one of them");
        }
    }
    const bool draws = root.has("draw");
    if (!root.has("vary") && !draws) {
        root.add_error("", "the study varies nothing", "add [[vary]] with key and values, or [[draw]] and [sample]");
    } else if (draws && !sample.exists()) {
        root.add_error("draw", "[[draw]] without [sample]: how many samples?", "add [sample] with count = 200");
    } else if (!draws && sample.exists()) {
        root.add_error("sample", "[sample] without [[draw]]: nothing is drawn", "add [[draw]], or remove [sample]");
    }
    return inputs;
}

}  // namespace tiretherm::input
