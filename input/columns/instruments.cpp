// SPDX-License-Identifier: BSD-3-Clause
// Reads [[instrument]] and assumes instruments by the names, quantities and places of sensors.

#include "input/columns/instruments.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "input/files/wildcard.hpp"
#include "input/text/column_names.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

/// Words by which sensors of one array differ.
constexpr std::array<std::string_view, 14> places{"inside", "outside", "inboard",  "outboard", "inner",
                                                  "outer",  "centre",  "center",   "middle",   "left",
                                                  "right",  "crown",   "shoulder", "zone"};

std::vector<std::string> sensors_of(const solver::Problem& problem) {
    std::vector<std::string> names = names_of(problem.channels);
    names.resize(problem.n_sensors());
    return names;
}

/// What is left of a name without numbers and words for a place: "ir" of ir_3, "surface" of surface_inside. inner_liner is a
/// place of its own.
std::string stem_of(const std::string& name) {
    std::vector<std::string> words = words_of(name);
    std::string stem;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool is_liner = i + 1 < words.size() && words[i + 1] == "liner";
        const bool differs = std::isdigit(static_cast<unsigned char>(words[i].front())) != 0 ||
                             (std::ranges::find(places, words[i]) != places.end() && !is_liner);
        stem += differs ? "" : words[i] + " ";
    }
    return stem;
}

/// Whether a sensor reads nodes of surfaces alone.
bool looks_at_surface(const mesh::Mesh& mesh, const solver::Channel& channel) {
    if (channel.quantity != solver::Quantity::temperature || channel.where.nodes.empty()) {
        return false;
    }
    for (std::size_t i = 0; i < channel.where.nodes.size(); ++i) {
        const bool on_surface = std::ranges::any_of(mesh.patches, [&](const mesh::Patch& patch) {
            return patch.name != "inside" &&
                   std::ranges::find(patch.faces, channel.where.nodes[i], &mesh::PatchFace::node) != patch.faces.end();
        });
        if (!on_surface && channel.where.weights[i] != 0.0) {
            return false;
        }
    }
    return true;
}

/// Sensors that may be of one array where their keys are equal.
struct Likeness {
    std::string stem;
    solver::Quantity quantity;
    bool surface;
    double standard_deviation;  ///< 0 where it is not stated

    auto operator<=>(const Likeness&) const = default;
};

std::string named_after(const solver::Problem& problem, const std::vector<std::size_t>& channels) {
    const std::string& first = problem.channels[channels.front()].name;
    const std::string& last = problem.channels[channels.back()].name;
    return channels.size() == 2 ? fmt::format("{} and {}", first, last)
                                : fmt::format("{} to {}, {} sensors", first, last, channels.size());
}

/// Adds a group for each key that several channels share and takes these channels out.
template <typename Key, typename Of>
void assume(const solver::Problem& problem, std::vector<std::size_t>& free, Of key_of, std::vector<Instrument>& into) {
    std::map<Key, std::vector<std::size_t>> groups;
    for (const std::size_t channel : free) {
        if (const std::optional<Key> key = key_of(channel)) {
            groups[*key].push_back(channel);
        }
    }
    std::vector<std::vector<std::size_t>> several;
    for (auto& [key, channels] : groups) {
        if (channels.size() > 1) {
            several.push_back(std::move(channels));
        }
    }
    std::ranges::sort(several);
    for (std::vector<std::size_t>& channels : several) {
        std::erase_if(free, [&](std::size_t channel) { return std::ranges::count(channels, channel) > 0; });
        into.push_back({.name = named_after(problem, channels), .channels = channels, .assumed = true});
    }
}

/// The sensors that a word of an instrument means, each once; what is wrong with it is reported.
void add_sensors(const LocatedString& word, const std::vector<std::string>& names, std::vector<std::string>& literal,
                 InputErrors& errors, Instrument& into) {
    const auto listed_twice = std::ranges::find(literal, word.text) != literal.end();
    literal.push_back(word.text);
    if (listed_twice) {
        errors.add(word.place, fmt::format("{} stands twice in the instrument {}", word.text, into.name), "remove one");
        return;
    }
    bool found = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!matches(word.text, names[i])) {
            continue;
        }
        found = true;
        if (std::ranges::count(into.channels, i) == 0) {
            into.channels.push_back(i);
        }
    }
    if (!found) {
        const std::string remedy = is_pattern(word.text) && !names.empty()
                                       ? fmt::format("the sensors are {}", listed(names))
                                       : suggest(word.text, names, "sensors");
        errors.add(word.place, fmt::format("no sensor is called \"{}\"", word.text), remedy);
    }
}

}  // namespace

std::vector<Instrument> read_instruments(TomlTable& root, const solver::Problem& problem) {
    const std::vector<std::string> names = sensors_of(problem);
    std::vector<Instrument> instruments;
    root.each("instrument", [&](TomlTable& table) {
        Instrument one{.name = table.text("name", Need::required).value_or(""), .channels = {}};
        if (!one.name.empty() && std::ranges::find(instruments, one.name, &Instrument::name) != instruments.end()) {
            table.add_error("name", fmt::format("a second instrument is called \"{}\"", one.name),
                            "rename one, or name all its sensors in one [[instrument]]");
        }
        const std::size_t before = table.errors().count();
        std::vector<std::string> literal;
        for (const LocatedString& word : table.texts("sensors")) {
            add_sensors(word, names, literal, table.errors(), one);
        }
        if (table.errors().count() == before && one.channels.size() < 2) {
            table.add_error("sensors",
                            fmt::format("the instrument {} has {}", one.name,
                                        one.channels.empty() ? "no sensor" : "one sensor alone"),
                            "an instrument is what two sensors at least have in common; name them, or remove it");
        }
        std::ranges::sort(one.channels);
        instruments.push_back(std::move(one));
    });
    return instruments;
}

std::vector<Instrument> measured_instruments(const std::vector<Instrument>& stated,
                                             const std::vector<MeasuredRun>& runs) {
    const solver::Problem& problem = runs.front().problem;
    std::vector<std::size_t> measured;
    for (const MeasuredRun& run : runs) {
        for (const MeasuredSeries& series : run.series) {
            if (!series.frozen && series.channel < problem.n_sensors() &&
                std::ranges::count(measured, series.channel) == 0) {
                measured.push_back(series.channel);
            }
        }
    }
    std::ranges::sort(measured);
    std::vector<Instrument> instruments;
    std::vector<std::size_t> free = measured;
    for (Instrument one : stated) {
        std::erase_if(free, [&](std::size_t channel) { return std::ranges::count(one.channels, channel) > 0; });
        std::erase_if(one.channels, [&](std::size_t channel) { return std::ranges::count(measured, channel) == 0; });
        if (one.channels.size() > 1) {
            instruments.push_back(std::move(one));
        }
    }
    const auto sigma = [&](std::size_t channel) { return problem.channels[channel].standard_deviation.value_or(0.0); };
    assume<Likeness>(
        problem, free,
        [&](std::size_t channel) {
            const solver::Channel& sensor = problem.channels[channel];
            return std::optional(Likeness{.stem = stem_of(sensor.name),
                                          .quantity = sensor.quantity,
                                          .surface = looks_at_surface(problem.mesh, sensor),
                                          .standard_deviation = sigma(channel)});
        },
        instruments);
    assume<double>(
        problem, free,
        [&](std::size_t channel) {
            const bool seen = sigma(channel) > 0.0 && looks_at_surface(problem.mesh, problem.channels[channel]);
            return seen ? std::optional(sigma(channel)) : std::nullopt;
        },
        instruments);
    return instruments;
}

}  // namespace tiretherm::input
