// SPDX-License-Identifier: BSD-3-Clause
// Places where a [[sensor]] reads the temperature: point, spot, patch, layer, zone, region, strip or lumped node.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/toml/toml_table.hpp"
#include "mesh/mesh.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// Where a sensor reads, with a sentence that says which temperature it is. Nothing after an error.
using Where = std::optional<solver::Channel>;

/// A point: depth, and x, y or radius where the mesh extends along them.
[[nodiscard]] Where read_point(TomlTable& sensor, const mesh::Mesh& mesh);
/// The mean over a disc about the centre of the outer or the inner surface: patch, radius.
[[nodiscard]] Where read_spot(TomlTable& sensor, const mesh::Mesh& mesh);
/// The mean over a patch, a layer (on a section also of one zone), a zone or a region.
[[nodiscard]] Where read_patch(TomlTable& sensor, const mesh::Mesh& mesh);
[[nodiscard]] Where read_layer(TomlTable& sensor, const mesh::Mesh& mesh);
[[nodiscard]] Where read_zone(TomlTable& sensor, const mesh::Mesh& mesh);
[[nodiscard]] Where read_region(TomlTable& sensor, const mesh::Mesh& mesh);
/// The mean over a strip round the outer surface of a section: from, to.
[[nodiscard]] Where read_strip(TomlTable& sensor, const mesh::Mesh& mesh);
inline constexpr int most_strips = 1000;
/// Strips side by side, as an array of infrared sensors sees them: count, from, to, first: the side of the first one, outboard
/// unless it says inboard. They read nothing after an error.
[[nodiscard]] std::vector<solver::Channel> read_strips(TomlTable& sensor, const mesh::Mesh& mesh);
/// A node beside the cells, such as the gas.
[[nodiscard]] Where read_node(TomlTable& sensor, const mesh::Mesh& mesh);

/// The channels that the [[sensor]] tables of a case make, by name, before they are read: what columns may be called.
[[nodiscard]] std::vector<std::string> sensor_names(const TomlValue& document);
/// Whether a channel is that of a sensor or one of its strips: ir_2 of ir.
[[nodiscard]] bool is_channel_of(std::string_view channel, std::string_view sensor);

}  // namespace tiretherm::input
