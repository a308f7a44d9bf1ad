// SPDX-License-Identifier: BSD-3-Clause
// Guesses what a column of a log may be. A guess is written as a comment only, for the user to judge.
#include "input/new_case/column_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "input/loggers/logger_units.hpp"
#include "input/text/column_names.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Words by which loggers call a quantity. A heading is the more likely the quantity, the more of them it has.
struct Vocabulary {
    std::string_view ending;  ///< of the names that it is about
    std::array<std::string_view, 9> words;
};
constexpr std::array vocabularies{
    Vocabulary{"time", {"time", "t", "timestamp", "zeit", "elapsed"}},
    Vocabulary{"speed", {"speed", "velocity", "vel", "v", "vx", "gps", "ground", "geschwindigkeit"}},
    Vocabulary{"vertical_load", {"load", "fz", "vertical", "normal", "radlast", "wheelload"}},
    Vocabulary{"slip_angle", {"slip", "angle", "alpha", "sa"}},
    Vocabulary{"slip_ratio", {"slip", "ratio", "kappa", "sr", "sx"}},
    Vocabulary{"lateral_force", {"lateral", "fy", "side", "force", "cornering"}},
    Vocabulary{"longitudinal_force", {"longitudinal", "fx", "brake", "drive", "force"}},
    Vocabulary{"camber", {"camber", "gamma", "ia", "inclination", "sturz"}},
    Vocabulary{"inflation_pressure", {"pressure", "inflation", "p", "press", "tpms", "druck"}},
    Vocabulary{"air_temperature", {"air", "ambient", "amb", "tamb", "tair", "luft", "weather"}},
    Vocabulary{"road_temperature", {"road", "track", "asphalt", "drum", "troad", "ttrack", "strasse", "ground"}},
    Vocabulary{"wet", {"wet", "rain"}},
    Vocabulary{"surface_temperature", {"surface", "surf", "tread", "ir", "infrared", "tsurf", "camera", "pyrometer"}},
    Vocabulary{"inner_liner_temperature", {"liner", "innerliner", "inner", "inside", "carcass", "back", "bottom"}},
    Vocabulary{"spot_mean_temperature",
               {"spot", "front", "top", "outer", "outside", "surface", "camera", "ir", "mean"}},
    Vocabulary{"spot_centre_temperature", {"spot", "centre", "center", "peak", "max", "hottest"}},
    Vocabulary{"bulk_temperature", {"bulk", "core", "tbulk", "probe", "needle", "tire", "tyre"}},
    Vocabulary{"gas_temperature", {"gas", "cavity", "tgas", "tpms", "innenluft"}},
    Vocabulary{"drag_force", {"drag", "rolling", "resistance", "rr", "fr"}},
    Vocabulary{"rolling_moment", {"rolling", "moment", "my", "torque"}},
    Vocabulary{"loaded_radius", {"radius", "loaded", "rl"}},
};
constexpr std::array zone_words{
    std::pair<std::string_view, std::string_view>{"outside_shoulder_", "outside outboard outer"},
    std::pair<std::string_view, std::string_view>{"inside_shoulder_", "inboard inside"},
    std::pair<std::string_view, std::string_view>{"crown_", "crown centre center middle mid"}};

bool contains_word(std::string_view list, std::string_view word) {
    const std::size_t at = (" " + std::string(list) + " ").find(" " + std::string(word) + " ");
    return at != std::string::npos;
}

/// How many words of a heading speak for a meaning; a side counts half, so that it decides between equals.
double score(const std::vector<std::string>& words, std::string_view name) {
    double points = 0.0;
    for (const auto& [zone, list] : zone_words) {
        if (name.starts_with(zone)) {
            const bool named = std::ranges::any_of(
                words, [&words_of_zone = list](const auto& word) { return contains_word(words_of_zone, word); });
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
    const auto hits = std::ranges::count_if(words, [&](const std::string& word) {
        return !word.empty() && std::ranges::find(found->words, word) != found->words.end();
    });
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

std::string bare_name(std::string_view name) {
    std::string bare;
    for (const char c : name) {
        if (is_letter(c) || is_digit(c)) {
            bare += lower(c);
        }
    }
    return bare;
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
    if (!near.empty()) {
        return &*std::ranges::find(meanings, near, &ColumnMeaning::name);
    }
    return best;
}

}  // namespace tiretherm::input
