#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/model/channel_value.hpp"
#include "input/model/draft.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

/// A range's two ends, the lower one first.
std::optional<std::array<double, 2>> read_range(Section& section, const Wanted& wanted) {
    const std::vector<Word> ends = section.texts("range");
    const std::string_view values = wanted.unit == "K" ? "temperatures" : "values";
    if (ends.size() != 2) {
        const std::string example = wanted.unit == "K" ? "[\"40 degC\", \"50 degC\"]" : "[\"...\", \"...\"]";
        section.mistake("range", fmt::format("a range has two {}", values), "write range = " + example);
        return std::nullopt;
    }
    std::array<double, 2> range{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Judged judged = quantity(ends[i].text, wanted, "range");
        if (judged.fault) {
            section.mistakes().add(ends[i].place, *judged.fault);
            return std::nullopt;
        }
        range[i] = judged.value;
    }
    if (range[0] > range[1]) {
        section.mistake("range", "the range begins with its upper end", fmt::format("swap the two {}", values));
        return std::nullopt;
    }
    return range;
}

/// Standard uncertainty: what the source says, and the width of a range as that of a flat distribution.
std::optional<double> combined(std::optional<double> stated, double width) {
    const double flat = width / std::sqrt(12.0);
    return stated || width > 0.0 ? std::optional(std::hypot(stated.value_or(0.0), flat)) : std::nullopt;
}

void read_value(Section& section, solver::Quantity reads, solver::Measured& measured) {
    const Wanted wanted = wanted_value(reads);
    const Need need = section.has("range") ? Need::optional : Need::required;
    const std::optional<double> value = section.quantity("value", wanted, need);
    measured.low = measured.high = value.value_or(0.0);
    if (section.has("range")) {
        if (section.has("value")) {
            section.mistake("value", "both value and range are given", "keep one of them");
        }
        const auto range = read_range(section, wanted).value_or(std::array{0.0, 0.0});
        measured.low = range[0];
        measured.high = range[1];
    } else {
        section.know({"range"});
    }
    measured.uncertainty =
        combined(section.quantity("uncertainty", wanted_deviation(reads)), measured.high - measured.low);
}

}  // namespace

void read_measured(Section& root, Draft& draft) {
    const solver::Settings& settings = draft.problem.settings;
    const std::vector<std::string> channels = names_of(draft.problem.channels);
    root.each("measured", [&](Section& section) {
        solver::Measured measured;
        measured.channel = section.text("channel", Need::required).value_or("");
        const auto channel = std::find(channels.begin(), channels.end(), measured.channel);
        solver::Quantity reads = solver::Quantity::temperature;
        if (channel != channels.end()) {
            reads = draft.problem.channels[static_cast<std::size_t>(channel - channels.begin())].quantity;
        } else if (section.has("channel")) {
            section.mistake("channel", fmt::format("there is no sensor \"{}\"", measured.channel),
                            suggest(measured.channel, channels, "sensors"));
            section.know({"value", "range", "uncertainty"});  // in the unit of nobody knows what
        }
        measured.source = section.text("source").value_or("");
        measured.time = section.quantity("time", wanted::moment).value_or(settings.end);
        if (section.has("time") && (measured.time < settings.start || measured.time > settings.end)) {
            section.mistake("time", fmt::format("the run goes from {:.6g} s to {:.6g} s", settings.start, settings.end),
                            "choose a time within the run");
        }
        if (channel != channels.end() || !section.has("channel")) {
            read_value(section, reads, measured);
        }
        draft.problem.measured.push_back(std::move(measured));
    });
}

}  // namespace tiretherm::input
