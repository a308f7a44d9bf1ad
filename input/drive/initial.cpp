// SPDX-License-Identifier: BSD-3-Clause
// Reads [initial]: start temperatures of the layers and of lumped nodes such as gas and rim, as values, as
// "air_temperature" or as what a sensor of the run reads.

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "input/drive/drive.hpp"
#include "input/model/probes.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

/// Reads the keys of [initial].
struct StartReader {
    const solver::Problem& problem;
    const GivenSignals& given;
    const RunInputs* run;               ///< null: none is measured
    std::vector<std::string> channels;  ///< that [[sensor]] makes

    [[nodiscard]] bool is_sensor(std::string_view name) const {
        return std::ranges::any_of(channels, [&](const std::string& channel) { return is_channel_of(channel, name); });
    }
    [[nodiscard]] std::optional<double> read(TomlTable& initial, std::string_view key,
                                             Need need = Need::optional) const;
    /// An input, such as the air's temperature, when the run starts; nothing where it is not given.
    [[nodiscard]] std::optional<double> first(std::string_view signal) const;
    /// The input that a lumped node starts at: that of the effect which brings the node.
    [[nodiscard]] std::string_view around(int lumped_node) const;

private:
    /// The sensors' mean at the start of the run, in its first second. @param sensor its name, or that of an array
    [[nodiscard]] std::optional<double> first_reading(std::string_view sensor) const;
};

std::optional<double> StartReader::first(std::string_view signal) const {
    const auto found = given.find(signal);
    return found != given.end()
               ? std::optional(problem.input_signals.at(problem.settings.start, solver::JumpSide::after).*
                               physics::find_signal(signal)->member)
               : std::nullopt;
}

std::string_view StartReader::around(int lumped_node) const {
    const auto brings = std::ranges::find_if(problem.effects, [&](const physics::ActiveEffect& active) {
        return std::ranges::count(active.lumped_nodes, lumped_node) > 0;
    });
    return brings->effect->heat_effect()->starts_at;
}

std::optional<double> StartReader::first_reading(std::string_view sensor) const {
    // Long enough for the noise of several samples to go, short against what the tire changes by. s
    constexpr double span = 1.0;
    const double start = problem.settings.start + (run != nullptr ? run->lead : 0.0);
    double sum = 0.0;
    int count = 0;
    for (const StartReading& one : run != nullptr ? run->start_readings : std::vector<StartReading>{}) {
        const std::vector<double>& time = one.reading.time;
        if (!is_channel_of(one.sensor, sensor)) {
            continue;
        }
        const auto first = static_cast<std::size_t>(std::ranges::lower_bound(time, start) - time.begin());
        for (std::size_t i = first; i < time.size() && (i == first || time[i] <= start + span); ++i) {
            sum += one.reading.value[i];
            ++count;
        }
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// A temperature, or that of the air by the name of the input, or that of a sensor by its name.
std::optional<double> StartReader::read(TomlTable& initial, std::string_view key, Need need) const {
    const TomlValue* node = initial.value(key, Need::optional);
    const bool is_text = node != nullptr && node->kind == TomlValue::Kind::text;
    if (is_text && is_sensor(node->text)) {
        const std::optional<double> read = first_reading(node->text);
        const bool is_reported = run != nullptr && (run->unreadable || (run->has_file && !run->first));
        if (!read && !is_reported) {
            initial.add_error(key,
                              fmt::format("{} is set to what {} reads, and {} has no such reading", key, node->text,
                                          run != nullptr ? "the run " + run->name : "a case without a run"),
                              "write a temperature, or give this run a start of its own: initial = { temperature = "
                              "\"40 degC\" }");
        }
        return read;
    }
    if (is_text && node->text != "air_temperature" && !node->text.empty() && !leading_number(node->text)) {
        std::vector<std::string> names = channels;
        names.emplace_back("air_temperature");
        const std::string near = nearest(node->text, names);
        return initial.add_error(
            key, fmt::format("{} is \"{}\", which is neither a temperature nor a sensor", key, node->text),
            near.empty() ? fmt::format("write a temperature, such as \"25 degC\", or one of: {}", listed(names))
                         : fmt::format("did you mean `{}`?", near));
    }
    if (!is_text || node->text != "air_temperature") {
        return initial.quantity(key, quantity_specs::temperature, need);
    }
    const std::optional<double> air = first("air_temperature");
    if (!air) {
        initial.add_error(key, fmt::format("{} is set to \"air_temperature\", but no air temperature is given", key),
                          "add air_temperature to [drive], or write a temperature");
    }
    return air;
}

}  // namespace

std::vector<double> read_initial(TomlTable& root, const solver::Problem& problem, const GivenSignals& given,
                                 const RunInputs* run) {
    TomlTable initial = root.subtable("initial", Need::required);
    const StartReader start{.problem = problem, .given = given, .run = run, .channels = sensor_names(root.content())};
    const std::size_t before = initial.errors().count();
    std::vector<double> temperatures;
    if (problem.mesh.n_nodes == 0) {
        for (const Entry& layer : initial.content().entries) {
            static_cast<void>(start.read(initial, layer.key));
        }
        return temperatures;
    }
    const mesh::Mesh& mesh = problem.mesh;
    const bool by_layer = std::any_of(mesh.layers.begin(), mesh.layers.end(),
                                      [&](const std::string& layer) { return initial.has(layer); });
    const std::optional<double> everywhere =
        start.read(initial, "temperature", by_layer ? Need::optional : Need::required);
    std::vector<double> of_layer;
    for (const std::string& layer : mesh.layers) {
        const bool needed = by_layer && !initial.has("temperature");
        const auto own = start.read(initial, layer, needed ? Need::required : Need::optional);
        of_layer.push_back(own.value_or(everywhere.value_or(0.0)));
    }
    // Gas and rim start with the air around them, a drum with the road, or as the rest where these are not given.
    const double rest = everywhere.value_or(of_layer.front());
    std::map<int, double> of_node;
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        of_node[lumped_node.node] =
            start.read(initial, lumped_node.name).value_or(start.first(start.around(lumped_node.node)).value_or(rest));
    }
    if (initial.errors().count() > before) {
        return temperatures;
    }
    for (int node = 0; node < mesh.n_nodes; ++node) {
        const int layer = mesh.layer[static_cast<std::size_t>(node)];
        temperatures.push_back(layer < 0 ? of_node.at(node) : of_layer[static_cast<std::size_t>(layer)]);
    }
    return temperatures;
}

}  // namespace tiretherm::input
