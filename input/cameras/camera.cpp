// SPDX-License-Identifier: BSD-3-Clause
// Reads [[camera]]: adds the nodes of the seen surface as channels, the image position and blur as an effect, and the
// emissivity as a sensor model.

#include "input/cameras/camera.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"
#include "physics/camera.hpp"

namespace tiretherm::input {

namespace {

constexpr QuantitySpec pixel{
    .unit = "m", .low = 0.0, .high = 0.1, .above = true, .usual_low = 1e-6, .usual_high = 0.01};
constexpr int most_columns = 100000;

/// One size, or one along a row and one along a column.
std::optional<std::array<double, 2>> read_size(TomlTable& camera) {
    const std::vector<LocatedString> words = camera.texts("pixel_size");
    std::vector<double> sizes;
    for (const LocatedString& word : words) {
        const std::optional<double> size = read_quantity(word, pixel, "pixel_size", camera.errors());
        if (!size) {
            return std::nullopt;
        }
        sizes.push_back(*size);
    }
    if (sizes.size() > 2) {
        return camera.add_error("pixel_size", fmt::format("pixel_size has {} values", sizes.size()),
                                "give one, or two: along a row and along a column of the image");
    }
    return sizes.empty() ? std::nullopt : std::optional(std::array{sizes.front(), sizes.back()});
}

/// First and last of the rows or columns that count, from 0 on, both counted.
std::optional<std::array<int, 2>> read_stretch(TomlTable& camera, std::string_view key) {
    const TomlValue* list = camera.value(key);
    if (list == nullptr) {
        return std::nullopt;
    }
    const auto sound = [](const TomlValue& node) {
        return node.kind == TomlValue::Kind::integer && node.number >= 0.0 && node.number < most_columns;
    };
    if (list->kind != TomlValue::Kind::array || list->items.size() != 2 || !sound(list->items[0]) ||
        !sound(list->items[1]) || list->items[0].number > list->items[1].number) {
        return camera.add_error(key, fmt::format("{} is no stretch of the image", key),
                                fmt::format("write {} = [8, 55], the first and the last that count, from 0 on", key));
    }
    return std::array{static_cast<int>(list->items[0].number), static_cast<int>(list->items[1].number)};
}

int read_patch(TomlTable& camera, const mesh::Mesh& mesh) {
    std::vector<std::string_view> names;
    std::vector<int> patches;
    for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
        if (physics::can_be_seen(mesh, static_cast<int>(i))) {
            names.emplace_back(mesh.patches[i].name);
            patches.push_back(static_cast<int>(i));
        }
    }
    if (names.empty()) {
        camera.errors().add(camera.place(), fmt::format("a camera cannot look at a mesh of kind {}", mesh.kind),
                            "use one of kind axisymmetric or block, or strips of a section");
        camera.declare_keys({"surface"});
        return -1;
    }
    const std::optional<std::size_t> found = camera.choice("surface", names);
    const bool wrong = camera.has("surface") && !found;
    return wrong ? -1 : patches[found.value_or(0)];
}

/// The nodes of the surface as channels.
void add_channels(Camera& camera, solver::Problem& problem) {
    const physics::SeenSurface surface(problem.mesh, camera.patch);
    camera.channels = {.camera = camera.name, .first = problem.channels.size(), .count = surface.nodes().size()};
    problem.cameras.push_back(camera.channels);
    for (std::size_t i = 0; i < surface.nodes().size(); ++i) {
        solver::Channel channel;
        channel.name = fmt::format("{} {}", camera.name, i);
        channel.meaning = fmt::format("what {} sees at a node of the surface", camera.name);
        channel.where = {.nodes = {surface.nodes()[i]}, .weights = {1.0}};
        problem.channels.push_back(std::move(channel));
    }
}

physics::ActiveEffect behind(const Camera& camera, const physics::Effect& effect, const mesh::Mesh& mesh) {
    physics::ActiveEffect active = physics::activate(effect, mesh);
    active.name = camera.name;
    for (std::size_t channel = camera.channels.first; channel < camera.channels.end(); ++channel) {
        active.channels.push_back(static_cast<int>(channel));
    }
    return active;
}

/// The grey surface, where the case says that it is one.
void add_emissivity(TomlTable& table, const Camera& camera, const GivenSignals* given, solver::Problem& problem) {
    const auto emissivity = table.quantity("emissivity");
    const auto mirrored = table.quantity("reflected_temperature");
    if (mirrored && !table.has("emissivity")) {
        table.add_error("reflected_temperature", "a black surface, of emissivity 1, mirrors nothing",
                        "add emissivity = 0.95");
    }
    if (emissivity && !mirrored && given != nullptr && !given->contains("air_temperature")) {
        table.add_error("emissivity", "the surface mirrors the air, whose temperature [drive] lacks",
                        "add reflected_temperature = \"23 degC\", or air_temperature to [drive]");
    }
    if (!emissivity || camera.patch < 0) {
        return;
    }
    physics::ActiveEffect grey = behind(camera, *physics::find_effect("camera_emissivity"), problem.mesh);
    grey.parameters[0] = *emissivity;
    if (mirrored) {
        grey.choices[0] = 1;
        grey.parameters[1] = *mirrored;
    }
    problem.effects.push_back(std::move(grey));
}

bool is_taken(const std::string& name, const solver::Problem& problem, const std::vector<Camera>& cameras) {
    const auto same = [&](const auto& other) { return other.name == name; };
    return std::ranges::any_of(problem.channels, same) || std::ranges::any_of(cameras, same);
}

}  // namespace

std::vector<Camera> read_cameras(TomlTable& root, const GivenSignals* given, solver::Problem& problem) {
    std::vector<Camera> all;
    root.each("camera", [&](TomlTable& table) {
        Camera camera;
        camera.name = table.name("name", Need::required).value_or("");
        camera.place = table.place();
        if (!camera.name.empty() && is_taken(camera.name, problem, all)) {
            table.add_error("name", fmt::format("a second sensor is called \"{}\"", camera.name), "rename one");
        }
        table.declare_keys({"surface"});
        camera.patch = problem.mesh.n_nodes > 0 ? read_patch(table, problem.mesh) : -1;
        camera.pixel_size = read_size(table);
        camera.rows = read_stretch(table, "rows");
        camera.columns = read_stretch(table, "columns");
        camera.bin = table.count("bin").value_or(1);
        camera.standard_deviation = table.quantity("standard_deviation", quantity_specs::tolerance);
        physics::CameraPose pose;
        table.read_into(pose);
        if (camera.patch >= 0) {
            add_channels(camera, problem);
            physics::ActiveEffect active = behind(camera, physics::camera_pose(), problem.mesh);
            active.parameters = {pose.x, pose.y, pose.rotation, pose.blur};
            camera.pose = problem.effects.size();
            problem.effects.push_back(std::move(active));
        }
        add_emissivity(table, camera, given, problem);
        all.push_back(std::move(camera));
    });
    return all;
}

void take_away_cameras(solver::Problem& problem) {
    const std::size_t first = problem.n_sensors();
    if (problem.cameras.empty()) {
        return;
    }
    problem.channels.resize(first);
    problem.cameras.clear();
    const auto is_gone = [&](int channel) { return static_cast<std::size_t>(channel) >= first; };
    for (physics::ActiveEffect& active : problem.effects) {
        std::erase_if(active.overrides, [&](const physics::ActiveEffect::Override& other) {
            return other.scope == physics::Scope::channel && is_gone(other.index);
        });
    }
    // An effect behind cameras alone goes with them; one that stands behind sensors as well stays with these.
    std::erase_if(problem.effects, [&](physics::ActiveEffect& active) {
        const bool had_some = !active.channels.empty();
        std::erase_if(active.channels, is_gone);
        return had_some && active.channels.empty();
    });
}

}  // namespace tiretherm::input
