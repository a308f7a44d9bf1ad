// SPDX-License-Identifier: BSD-3-Clause
// Reads [[critical]] (temperature limits for parts of the tire) and [[uncertain]] (case values known only with a
// standard deviation).

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/parameters/study_value.hpp"
#include "input/runs/hot_spots.hpp"
#include "input/runs/runs.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

/// The names of a key, each of which the mesh must have. @returns whether a name is meant; all are where none is given
class Chosen {
public:
    Chosen(TomlTable& table, std::string_view key, std::string_view plural, const std::vector<std::string>& known,
           bool has_mesh) {
        if (const TomlValue* list = table.value(key);
            list != nullptr && list->kind == TomlValue::Kind::array && list->items.empty()) {
            table.add_error(key, fmt::format("{} is an empty list", key), "name one, or leave the key out for all");
            sound_ = false;
        }
        for (const LocatedString& word : table.texts(key)) {
            names_.push_back(word.text);
            if (has_mesh && std::ranges::find(known, word.text) == known.end()) {
                table.errors().add(word.place, fmt::format("the mesh has no {} \"{}\"", singular(plural), word.text),
                                   known.empty() ? fmt::format("this mesh has no {}: leave the key out", plural)
                                                 : suggest(word.text, known, plural));
                sound_ = false;
            }
        }
    }
    [[nodiscard]] bool means(const std::string& name) const {
        return names_.empty() || std::ranges::find(names_, name) != names_.end();
    }
    [[nodiscard]] bool sound() const { return sound_; }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

private:
    static std::string singular(std::string_view plural) { return std::string(plural.substr(0, plural.size() - 1)); }

    std::vector<std::string> names_;
    bool sound_ = true;
};

std::string part_description(const Chosen& layers, const Chosen& zones, const Chosen& materials) {
    std::string text = listed(layers.names());
    if (!materials.names().empty()) {
        text += (text.empty() ? "" : " of ") + listed(materials.names());
    }
    if (!zones.names().empty()) {
        text += (text.empty() ? "" : " in ") + listed(zones.names());
    }
    return text;
}

/// The reading that is held beside the hot spot: a sensor of a temperature, or the mean of the outer surface.
void read_surface(TomlTable& table, const solver::Problem& problem, bool has_mesh, solver::Critical& into) {
    const std::optional<std::string> name = table.text("surface");
    if (!has_mesh) {
        return;
    }
    if (!name) {
        const int region = problem.mesh.find_region("surface");
        if (region >= 0) {
            into.surface = problem.mesh.regions[static_cast<std::size_t>(region)].mean;
            into.surface_name = "surface";
        }
        return;
    }
    const auto found = std::ranges::find(problem.channels, *name, &solver::Channel::name);
    if (found == problem.channels.end() || found->quantity != solver::Quantity::temperature) {
        table.add_error("surface", fmt::format("no sensor of a temperature is called \"{}\"", *name),
                        suggest(*name, names_of(problem.channels), "sensors"));
        return;
    }
    into.surface_name = *name;
    into.channel = static_cast<int>(found - problem.channels.begin());
}

/// The hottest that the part is before anything heats it. K
double hottest_surroundings(const solver::Problem& problem, const std::vector<int>& nodes) {
    double hottest = problem.input_signals.at(problem.settings.start, solver::JumpSide::after).air_temperature;
    for (const solver::Series& series : problem.input_signals.series()) {
        if (series.signal->name == "air_temperature" && !series.value.empty()) {
            hottest = std::max(hottest, *std::ranges::max_element(series.value));
        }
    }
    for (const int node : nodes) {
        if (const auto i = static_cast<std::size_t>(node); i < problem.initial.size()) {  // not after an error in it
            hottest = std::max(hottest, problem.initial[i]);
        }
    }
    return hottest;
}

solver::Critical read_one(TomlTable& table, const solver::Problem& problem) {
    const bool has_mesh = problem.mesh.n_nodes > 0;
    const mesh::Mesh& mesh = problem.mesh;
    solver::Critical critical;
    critical.name = table.name("name", Need::required).value_or("");
    const std::optional<double> temperature = table.quantity("temperature", Need::required);
    critical.temperature = temperature.value_or(0.0);
    const Chosen layers(table, "layers", "layers", mesh.layers, has_mesh);
    const Chosen zones(table, "zones", "zones", mesh.zones, has_mesh);
    const Chosen materials(table, "materials", "materials", unique(names_of(problem.materials)), has_mesh);
    critical.part = part_description(layers, zones, materials);
    read_surface(table, problem, has_mesh, critical);
    if (!has_mesh || !layers.sound() || !zones.sound() || !materials.sound() ||
        problem.materials.size() != mesh.layers.size()) {
        return critical;
    }
    for (int node = 0; node < mesh.n_nodes; ++node) {
        const int layer = mesh.layer[static_cast<std::size_t>(node)];
        const int zone = mesh.zone[static_cast<std::size_t>(node)];
        if (layer >= 0 && layers.means(mesh.layers[static_cast<std::size_t>(layer)]) &&
            materials.means(problem.materials[static_cast<std::size_t>(layer)].name) &&
            (zones.names().empty() || (zone >= 0 && zones.means(mesh.zones[static_cast<std::size_t>(zone)])))) {
            critical.nodes.push_back(node);
        }
    }
    if (critical.nodes.empty()) {
        table.add_error("", fmt::format("the mesh has nothing that is {}", critical.part),
                        "name layers, materials and zones that meet");
        return critical;
    }
    const double surroundings = hottest_surroundings(problem, critical.nodes);
    if (temperature && *temperature <= surroundings) {
        table.add_error("temperature",
                        fmt::format("{:.6g} degC is passed before anything heats the tire: its start or its air is at "
                                    "{:.6g} degC",
                                    celsius(*temperature), celsius(surroundings)),
                        "give the temperature that the part can bear");
    }
    return critical;
}

}  // namespace

std::vector<solver::Critical> read_critical(TomlTable& root, const solver::Problem& problem) {
    std::vector<solver::Critical> found;
    root.each("critical", [&](TomlTable& table) {
        solver::Critical critical = read_one(table, problem);
        if (std::ranges::find(found, critical.name, &solver::Critical::name) != found.end() && !critical.name.empty()) {
            table.add_error("name", fmt::format("a second critical temperature is called \"{}\"", critical.name),
                            "rename one");
        }
        found.push_back(std::move(critical));
    });
    return found;
}

namespace {

/// The tables of the file that `alternative` names; nothing after an error.
std::optional<UncertainKey> read_alternative(TomlTable& table, const std::string& file) {
    for (const char* key : {"key", "standard_deviation"}) {
        if (table.has(key)) {
            table.add_error(key, fmt::format("both alternative and {} are given", key),
                            "keep one of them: an alternative is as likely as what the case has");
        }
    }
    const std::filesystem::path path = table.errors().beside(table.place("alternative"), file);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        table.add_error("alternative", fmt::format("there is no file {}", path.generic_string()),
                        "give the path from this file's folder");
        return std::nullopt;
    }
    std::optional<TomlValue> tables = read_document(path, table.errors());
    return tables ? std::optional(UncertainKey{.alternative = path.stem().string(), .tables = std::move(*tables)})
                  : std::nullopt;
}

}  // namespace

std::vector<UncertainKey> read_uncertain(TomlTable& root) {
    std::vector<UncertainKey> found;
    root.each("uncertain", [&](TomlTable& table) {
        if (const std::optional<std::string> file = table.text("alternative")) {
            table.declare_keys({"key", "standard_deviation"});
            if (std::optional<UncertainKey> read = read_alternative(table, *file)) {
                found.push_back(std::move(*read));
            }
            return;
        }
        const std::optional<std::string> key = table.text("key", Need::required);
        const std::optional<Measure> deviation = read_measure(table, "standard_deviation", Need::required);
        InputErrors unheard;  // a path that is none is told as one that leads to nothing
        const std::optional<ParameterPath> path =
            key ? ParameterPath::parse({*key, table.place("key")}, root.content(), unheard) : std::nullopt;
        const TomlValue* value = path ? path->find(root.content()) : nullptr;
        const StudyValue shown_value = value != nullptr ? study_value(*value) : StudyValue{};
        if (key && (value == nullptr || !std::isfinite(shown_value.number))) {
            table.add_error("key",
                            value == nullptr ? fmt::format("the case says nothing at \"{}\"", *key)
                                             : fmt::format("\"{}\" is {}, not a number", *key, shown(*value)),
                            "name a value that the case gives, such as \"drive.air_temperature\"");
            return;
        }
        if (!path || !deviation) {
            return;
        }
        UncertainKey uncertain{.path = *path, .value = *value, .number = shown_value.number, .unit = unit_of(*value)};
        const auto in = in_unit(*deviation, uncertain.unit, true, "standard_deviation", table.errors());
        uncertain.standard_deviation = in.value_or(1.0);
        if (!(uncertain.standard_deviation > 0.0)) {
            table.add_error("standard_deviation", "a standard deviation is positive", "give one above 0");
        }
        if (std::ranges::any_of(found, [&](const UncertainKey& other) { return other.name() == *key; })) {
            table.add_error("key", fmt::format("\"{}\" is uncertain twice", *key), "remove one");
        }
        found.push_back(std::move(uncertain));
    });
    return found;
}

}  // namespace tiretherm::input
