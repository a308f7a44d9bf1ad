// SPDX-License-Identifier: BSD-3-Clause
// [material.cord_rubber]: a material of cords in rubber, its properties by mixing rules, and where a mesh cannot show
// them.
#pragma once

#include <optional>
#include <string>

#include "input/materials/ply_summary.hpp"
#include "input/toml/toml_table.hpp"
#include "mesh/mesh.hpp"
#include "physics/material.hpp"
#include "physics/tire_laws/cord_conduction.hpp"
#include "physics/tire_laws/cord_rubber.hpp"

namespace tiretherm::input {

/// What the cords store; a material that gives its density and heat capacity itself does without.
struct CordCapacity {
    double density = 0.0;        ///< kg/m3
    double heat_capacity = 0.0;  ///< J/(kg K)
};

/// Moduli of cord and rubber, from which those of a ply are reported.
struct PlyElasticity {
    physics::Isotropic cord;
    physics::Isotropic rubber;
};

/// A layer of plies as a case describes it.
struct CordRubberPly {
    std::string rubber;    ///< name of its material
    SourceLocation place;  ///< of the table
    physics::ConductingCords cords;
    double angle = 0.0;      ///< rad, of the cords to the circumference; neighbouring plies have opposite signs
    double thickness = 0.0;  ///< m, of one ply
    int plies = 2;
    std::optional<CordCapacity> capacity{};
    std::optional<PlyElasticity> elasticity{};

    /// Whether the plies conduct heat obliquely: a ply too many at +angle.
    [[nodiscard]] bool is_unbalanced() const;
};

/// Reads the subtable `cord_rubber` of a material.
/// @returns nothing when absent or wrong
[[nodiscard]] std::optional<CordRubberPly> read_cord_rubber(TomlTable& material);

/// Fills in what follows from cords and rubber: the conductivities, and where the cords' are given density and heat
/// capacity.
void mix(const CordRubberPly& ply, const physics::Material& rubber, physics::Material& material);

/// A mesh that resolves both directions in the plane cannot show oblique conduction, and a disc has one conductivity in
/// its plane: errors at the ply's place.
void check_cord_rubber(const CordRubberPly& ply, const std::string& name, const mesh::Mesh& mesh, InputErrors& errors);

/// A warning where a layer is not as thick as its plies. @param thickness m, of the layer
void check_thickness(const CordRubberPly& ply, double thickness, const TomlTable& layer);

/// The layer's plies glued together, x around the circumference and y along the meridian. @pre they have moduli
[[nodiscard]] physics::Sheet laminate_of(const CordRubberPly& ply);

[[nodiscard]] PlySummary summary_of(const CordRubberPly& ply, const physics::Material& material);

}  // namespace tiretherm::input
