// SPDX-License-Identifier: BSD-3-Clause
// Lists of words by which columns of logs are told apart: computed, counted, of the tire, from outside.

#include "input/text/column_names.hpp"

#include <algorithm>
#include <cctype>
#include <span>
#include <variant>

#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

/// Anywhere in the name.
constexpr std::string_view computed[] = {"calc",       "calculated", "computed", "sim",      "simulated",
                                         "simulation", "model",      "modelled", "modeled",  "pred",
                                         "predicted",  "prediction", "est",      "estimate", "estimated",
                                         "fitted",     "virtual",    "derived",  "observer", "kalman"};
constexpr std::string_view counted[] = {
    "timestamp", "clock",    "date",    "utc",    "epoch",    "uptime",    "lap",      "laps",    "odometer", "odo",
    "mileage",   "distance", "counter", "beacon", "latitude", "longitude", "altitude", "easting", "northing"};
/// By themselves, numbers aside.
constexpr std::string_view counted_alone[] = {
    "time", "elapsed", "t",   "dist", "index", "sample", "samples", "count",  "frame", "row", "id",    "nr",
    "no",   "lat",     "lon", "lng",  "x",     "y",      "z",       "sector", "zeit",  "weg", "runde", "datum"};
/// Of a position, beside gps.
constexpr std::string_view counted_by_gps[] = {"lat", "lon", "long", "lng", "alt", "x", "y", "z", "time", "heading"};
constexpr std::string_view temperature[] = {"temp",     "temperature",  "temps", "tmp",       "ir",
                                            "infrared", "thermocouple", "tc",    "pyrometer", "pt100"};
constexpr std::string_view of_tire[] = {"tire",     "tyre",  "tread",    "carcass", "liner",  "innerliner",
                                        "shoulder", "crown", "sidewall", "bead",    "bulk",   "tpms",
                                        "cavity",   "rim",   "rib",      "groove",  "rubber", "reifen"};
constexpr std::string_view from_outside[] = {
    "air",     "ambient", "road",    "track",  "asphalt",      "tarmac",   "ground",  "pavement", "brake",
    "brakes",  "brk",     "disc",    "disk",   "caliper",      "rotor",    "pad",     "gearbox",  "gear",
    "oil",     "water",   "coolant", "engine", "motor",        "inverter", "battery", "exhaust",  "hub",
    "bearing", "drum",    "room",    "hall",   "lab",          "heater",   "lamp",    "blanket",  "wind",
    "tunnel",  "fan",     "chamber", "cabin",  "differential", "luft",     "strasse", "bremse"};

bool is_one_of(std::span<const std::string_view> list, std::string_view word) {
    return std::ranges::find(list, word) != list.end();
}

std::string first_of(std::string_view name, std::span<const std::string_view> list) {
    for (std::string& word : words_of(name)) {
        if (is_one_of(list, word)) {
            return std::move(word);
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
    enum class Class { none, small, capital, digit, other };
    const auto class_of = [](char letter) {
        const auto c = static_cast<unsigned char>(letter);
        return c >= 128          ? Class::small
               : std::islower(c) ? Class::small
               : std::isupper(c) ? Class::capital
               : std::isdigit(c) ? Class::digit
                                 : Class::other;
    };
    std::vector<std::string> words;
    Class before = Class::none;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const Class now = class_of(name[i]);
        if (now == Class::other) {
            before = now;
            continue;
        }
        // A new word begins at a capital after a small letter, at the last of several capitals before one, at digits.
        const bool last_capital = now == Class::capital && before == Class::capital && i + 1 < name.size() &&
                                  class_of(name[i + 1]) == Class::small;
        const bool goes_on = now == before || (before == Class::capital && now == Class::small);
        if (words.empty() || !goes_on || last_capital) {
            words.emplace_back();
        }
        words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
        before = now;
    }
    return words;
}

std::string word_of_result(std::string_view name) { return first_of(name, computed); }

std::string word_of_clock(std::string_view name) {
    if (std::string word = first_of(name, counted); !word.empty()) {
        return word;
    }
    std::vector<std::string> words = words_of(name);
    std::erase_if(words,
                  [](const std::string& word) { return std::isdigit(static_cast<unsigned char>(word.front())); });
    if (std::ranges::find(words, "gps") != words.end()) {
        return first_of(name, counted_by_gps);
    }
    return words.size() == 1 && is_one_of(counted_alone, words.front()) ? words.front() : std::string();
}

bool is_temperature(std::string_view name, std::string_view unit) {
    if (unit == "C" || unit == "F") {
        return true;
    }
    if (unit.empty() || unit == "-" || unit == "1") {
        return !first_of(name, temperature).empty();
    }
    const auto read = conversion(unit, "K", Scale::absolute);
    return std::holds_alternative<Conversion>(read);
}

std::string word_of_tire(std::string_view name) { return first_of(name, of_tire); }

std::string word_from_outside(std::string_view name) { return first_of(name, from_outside); }

}  // namespace tiretherm::input
