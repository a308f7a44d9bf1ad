// SPDX-License-Identifier: BSD-3-Clause
// What a new case takes from the library's cases of the thesis's tire: mesh, materials, effects, drive and sensors.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/case_text/case_parts.hpp"
#include "input/text/quantity.hpp"

namespace tiretherm::input {

/// A sensor that a case may have.
struct TemplateSensor {
    std::string name;
    QuantitySpec spec;    ///< of what it reads
    bool shipped = true;  ///< of the library's case; others are written only where a log has them
    std::vector<std::string> lines{};
};

/// The mesh of a case that is about a specimen and no tire.
inline constexpr std::string_view specimen_mesh = "specimen";

/// A kind of mesh with all that the library's cases on it share.
struct MeshTemplate {
    std::string name;                   ///< "section", as the option --mesh takes it
    std::string what;                   ///< "a cross-section"
    std::vector<std::string> origin{};  ///< comment lines: sources and assumptions
    std::string sources{};              ///< value of the key
    std::vector<CasePart> mesh{};       ///< [mesh], [[mesh.layer]] and [[material]]; of a specimen the effects too
    std::vector<CasePart> effects{};    ///< that are named, each once: of the last file that names it
    std::vector<CasePart> settings{};   ///< [drive], [initial] and [time]
    std::vector<TemplateSensor> sensors{};

    /// The value of a key of [drive], [initial] or [time] without quotation marks; empty when absent.
    [[nodiscard]] std::string setting(std::string_view table, std::string_view key) const;
    [[nodiscard]] const TemplateSensor* find_sensor(std::string_view name) const;  ///< null when absent
};

/// Names of the meshes, the standard one first.
[[nodiscard]] std::span<const std::string_view> mesh_template_names();

/// @param name one of them  @param tread_thickness_mm mm, through the crown: how deep probes lie
[[nodiscard]] MeshTemplate mesh_template(std::string_view name, double tread_thickness_mm);

}  // namespace tiretherm::input
