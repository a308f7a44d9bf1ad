#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/studies/study.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

constexpr int most_values = 10'000;
constexpr int most_samples = 100'000;

Word read_key(Section& section) {
    const std::optional<std::string> key = section.text("key", Need::required);
    return {key.value_or(""), section.place("key")};
}

/// values = ["80 km/h", "120 km/h"]
void read_values(Section& section, StudyInput& input) {
    const Node* list = section.value("values");
    if (list->kind != Node::Kind::array || list->items.empty()) {
        section.mistake("values", fmt::format("values is {}; a list of values is wanted", shown(*list)),
                        "write values = [\"80 km/h\", \"120 km/h\"]");
        return;
    }
    for (const Node& item : list->items) {
        const bool value = item.kind == Node::Kind::text || item.kind == Node::Kind::boolean || item.is_number();
        if (!value) {
            section.mistakes().add(item.place,
                                   fmt::format("values has {}; a quantity or a word is wanted", shown(item)));
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
    Mistakes unheard;
    for (StudyValue& value : input.values) {
        const Measure measure{.number = value.number, .unit = unit_of(value.node), .whole = false, .place = {}};
        if (is_unit(measure.unit) && is_unit(input.unit)) {
            value.number = in_unit(measure, input.unit, false, "", unheard).value_or(value.number);
        }
    }
}

/// from = "60 km/h", to = "140 km/h", count = 5
void read_range(Section& section, StudyInput& input) {
    const std::optional<Measure> from = read_measure(section, "from", Need::required);
    const std::optional<Measure> to = read_measure(section, "to", Need::required);
    const std::optional<int> count = section.count("count", 2, most_values, Need::required);
    const std::optional<double> end =
        from && to ? in_unit(*to, from->unit, false, "to", section.mistakes()) : std::nullopt;
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

StudyInput read_vary(Section& section) {
    StudyInput input{.key = read_key(section), .unit = {}, .values = {}};
    if (section.has("values")) {
        for (const char* other : {"from", "to", "count"}) {
            if (section.has(other)) {
                section.mistake(other, fmt::format("both values and {} are given", other),
                                "keep values, or from, to and count");
            }
        }
        section.know({"from", "to", "count"});
        read_values(section, input);
    } else if (section.has("from") || section.has("to") || section.has("count")) {
        section.know({"values"});
        read_range(section, input);
    } else {
        section.know({"from", "to", "count"});
        static_cast<void>(section.value("values", Need::required, "values = [\"80 km/h\", \"120 km/h\"]"));
    }
    return input;
}

/// The numbers of one [[draw]], each in the unit of the first.
struct Drawn {
    Distribution distribution;
    std::string unit;
    Place place;
    bool sound = false;
};

Drawn read_distribution(Section& section) {
    constexpr std::array<std::string_view, 3> words{"normal", "lognormal", "uniform"};
    constexpr std::array spreads{Spread::normal, Spread::lognormal, Spread::uniform};
    Drawn drawn;
    const std::optional<std::size_t> word = section.choice("distribution", words, Need::required);
    section.know({"mean", "standard_deviation", "from", "to", "low", "high"});
    if (!word) {
        return drawn;
    }
    drawn.distribution.spread = spreads[*word];
    const bool uniform = drawn.distribution.spread == Spread::uniform;
    for (const char* other : uniform ? std::array{"mean", "standard_deviation"} : std::array{"from", "to"}) {
        if (section.has(other)) {
            section.mistake(other, fmt::format("a {} distribution has no {}", words[*word], other),
                            uniform ? "write from and to" : "write mean and standard_deviation");
        }
    }
    const std::size_t before = section.mistakes().count();
    const char* first = uniform ? "from" : "mean";
    const char* second = uniform ? "to" : "standard_deviation";
    const std::optional<Measure> a = read_measure(section, first, Need::required);
    const std::optional<Measure> b = read_measure(section, second, Need::required);
    const std::optional<Measure> low = read_measure(section, "low", Need::optional);
    const std::optional<Measure> high = read_measure(section, "high", Need::optional);
    if (!a || !b) {
        return drawn;
    }
    drawn.unit = a->unit;
    drawn.place = a->place;
    const auto convert = [&](const std::optional<Measure>& from, const char* key, bool difference, double& into) {
        if (from) {
            into = in_unit(*from, a->unit, difference, key, section.mistakes()).value_or(into);
        }
    };
    drawn.distribution.a = a->number;
    convert(b, second, !uniform, drawn.distribution.b);
    convert(low, "low", false, drawn.distribution.low);
    convert(high, "high", false, drawn.distribution.high);
    if (section.mistakes().count() > before) {
        return drawn;
    }
    const Distribution& d = drawn.distribution;
    if (uniform ? d.b <= d.a : d.b <= 0.0) {
        section.mistake(
            second, uniform ? "the distribution ends before it begins" : "the standard deviation is not positive",
            uniform ? "let from be smaller than to" : "write a positive one, or use [[vary]] with one value");
    } else if (d.spread == Spread::lognormal && d.a <= 0.0) {
        section.mistake("mean", "a lognormal quantity is positive, and its mean is not", "use a normal distribution");
    } else if (!(d.kept() > 1e-9)) {
        section.mistake(section.has("low") ? "low" : "high",
                        "hardly anything of the distribution lies between low and high", "widen the bounds");
    }
    drawn.sound = section.mistakes().count() == before;
    return drawn;
}

StudyInput read_draw(Section& section, std::size_t samples, std::uint64_t seed) {
    StudyInput input{.key = read_key(section), .unit = {}, .is_drawn = true, .values = {}};
    const Drawn drawn = read_distribution(section);
    input.unit = drawn.unit;
    for (std::size_t s = 0; drawn.sound && s < samples; ++s) {
        const double number = drawn.distribution.quantile(draw(seed, s, input.key.text));
        input.values.push_back(study_value(number, drawn.unit, false, drawn.place));
    }
    return input;
}

}  // namespace

std::vector<StudyInput> read_study_inputs(Section& root, std::size_t& samples, std::uint64_t& seed) {
    Section sample = root.section("sample");
    if (sample.exists()) {
        samples = static_cast<std::size_t>(sample.count("count", 1, most_samples, Need::required).value_or(1));
        seed = static_cast<std::uint64_t>(sample.count("seed", 0, 2'000'000'000).value_or(1));
    }
    std::vector<StudyInput> inputs;
    root.each("vary", [&](Section& section) { inputs.push_back(read_vary(section)); });
    root.each("draw", [&](Section& section) { inputs.push_back(read_draw(section, samples, seed)); });
    for (auto input = inputs.begin(); input != inputs.end(); ++input) {
        const auto same = std::find_if(inputs.begin(), input,
                                       [&](const StudyInput& other) { return other.key.text == input->key.text; });
        if (same != input && !input->key.text.empty()) {
            root.mistakes().add(input->key.place,
                                fmt::format("\"{}\" is varied twice, here and at {}", input->key.text,
                                            root.mistakes().spell(same->key.place)),
                                "keep one of them");
        }
    }
    const bool draws = root.has("draw");
    if (!root.has("vary") && !draws) {
        root.mistake("", "the study varies nothing", "add [[vary]] with key and values, or [[draw]] and [sample]");
    } else if (draws && !sample.exists()) {
        root.mistake("draw", "[[draw]] without [sample]: how many samples?", "add [sample] with count = 200");
    } else if (!draws && sample.exists()) {
        root.mistake("sample", "[sample] without [[draw]]: nothing is drawn", "add [[draw]], or remove [sample]");
    }
    return inputs;
}

}  // namespace tiretherm::input
