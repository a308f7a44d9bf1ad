#include <algorithm>

#include <fmt/format.h>

#include "cases/draft.hpp"
#include "cases/wanted.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

/// Two temperatures, the lower one first.
std::optional<std::array<double, 2>> read_range(Section& section) {
    const std::vector<Word> ends = section.texts("range");
    if (ends.size() != 2) {
        section.mistake("range", "a range has two temperatures", "write range = [\"40 degC\", \"50 degC\"]");
        return std::nullopt;
    }
    std::array<double, 2> range{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Judged judged = quantity(ends[i].text, wanted::temperature, "range");
        if (judged.fault) {
            section.mistakes().add(ends[i].place, *judged.fault);
            return std::nullopt;
        }
        range[i] = judged.value;
    }
    if (range[0] > range[1]) {
        section.mistake("range", "the range begins with its upper end", "swap the two temperatures");
        return std::nullopt;
    }
    return range;
}

}  // namespace

void read_measured(Section& root, Draft& draft) {
    const solver::Settings& settings = draft.problem.settings;
    const std::vector<std::string> channels = names_of(draft.problem.channels);
    root.each("measured", [&](Section& section) {
        solver::Measured measured;
        measured.channel = section.text("channel", Need::required).value_or("");
        if (section.has("channel") && std::find(channels.begin(), channels.end(), measured.channel) == channels.end()) {
            section.mistake("channel", fmt::format("there is no sensor \"{}\"", measured.channel),
                            suggest(measured.channel, channels, "sensors"));
        }
        measured.source = section.text("source").value_or("");
        measured.time = section.quantity("time", wanted::moment).value_or(settings.end);
        if (section.has("time") && (measured.time < settings.start || measured.time > settings.end)) {
            section.mistake("time", fmt::format("the run goes from {:.6g} s to {:.6g} s", settings.start, settings.end),
                            "choose a time within the run");
        }
        const Need need = section.has("range") ? Need::optional : Need::required;
        const std::optional<double> value = section.quantity("value", wanted::temperature, need);
        measured.low = measured.high = value.value_or(0.0);
        if (section.has("range")) {
            if (section.has("value")) {
                section.mistake("value", "both value and range are given", "keep one of them");
            }
            const auto range = read_range(section).value_or(std::array{0.0, 0.0});
            measured.low = range[0];
            measured.high = range[1];
        } else {
            section.know({"range"});
        }
        draft.problem.measured.push_back(std::move(measured));
    });
}

}  // namespace tiretherm::cases
