// SPDX-License-Identifier: BSD-3-Clause
// The four classes of effects: what the functions of each one see and do. The facts that all effects share are in
// physics/effect.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/field_transfer/field.hpp"
#include "physics/material.hpp"
#include "physics/signals.hpp"
#include "physics/terms.hpp"
#include "physics/tire.hpp"

namespace tiretherm::physics {

struct ActiveEffect;

/// Materials, laws of the links and the tire, as a case gives them; property modifiers change them before a run.
struct MaterialModel {
    std::vector<Material> materials;  ///< [n_layers]
    std::vector<Curve> link_laws;     ///< [n_links] k in W/(m K)
    Tire tire;
    double laser_spot_scale = 1.0;  ///< true radius of the laser's spot over that of the laser effect
};

/// What an effect knows when it places itself, once, before the first step.
struct PlacementContext {
    const mesh::Mesh& mesh;
    const MaterialModel& material_model;
    std::span<const ActiveEffect> effects;  ///< all that are on

    [[nodiscard]] const ActiveEffect* find(std::string_view id) const;  ///< null when off
    [[nodiscard]] int index_of(std::string_view id) const;              ///< into `effects`; -1 when off
};

/// What property modifiers make of the thesis's laws at a moment, as far as it follows from the inputs.
struct Laws {
    double loss = 1.0;        ///< factor on the strain-energy loss
    double loss_shift = 0.0;  ///< K, added to the equivalent temperature of its loss tangent
    double loss_skew = 0.0;   ///< share of the loss that moves from the inside shoulder to the outside one
    double partition = 1.0;   ///< factor on the share of the friction power that enters the tire
    double forced = 1.0;      ///< factor on the forced part of the air convection
    // Of the contact pressure over its mean, 1 + skew y + crown (1 - 3 y^2)/2 across the tread, y from -1 inside to 1 outside:
    double contact_skew = 0.0;
    double contact_crown = 0.0;
};

/// The inputs of a moment, after the input corrections, and the laws that hold.
struct OperatingPoint {
    const Tire& tire;
    const Inputs& inputs;
    const Laws& laws;
    std::span<const ActiveEffect> effects{};  ///< all that are on
};

/// A factor on a law that follows a region's mean temperature.
struct LossFactor {
    double value = 1.0;
    double dvalue_dT_mean = 0.0;  ///< 1/K
    int region = 0;               ///< index into Mesh::regions
};

/// The state at which an effect adds its terms.
struct EvaluationState {
    const mesh::Mesh& mesh;
    const MaterialModel& material_model;
    std::span<const double> temperature;  ///< [n_nodes] K
    std::span<const double> region_mean;  ///< [n_regions] K
    const ActiveEffect& active;
    std::span<const double> coefficients;        ///< [n_coefficients] of this effect
    std::span<const LossFactor> loss_factors{};  ///< on the strain-energy loss

    /// What a cell or surface node is made of.
    [[nodiscard]] const Material& material_at(int node) const {
        return material_model.materials[static_cast<std::size_t>(mesh.layer[static_cast<std::size_t>(node)])];
    }
};

/// A law that scales the strain-energy loss by a region's mean temperature.
using LossLaw = LossFactor (*)(const EvaluationState& state);

/// A law that the calling program gives to a heat source of a case, in the place of its number.
struct OwnLaw {
    std::function<void(const EvaluationState& state, Terms& terms)> add_terms;

    /// To the digest of a problem: of what it computes nothing is known, so that no other law is taken for it.
    void add_to(auto& digest) const { digest.add(reinterpret_cast<std::uintptr_t>(this)); }
};

/// What kind of channel a sensor model applies to.
enum class ChannelsOf : std::uint8_t { anything, temperature, temperature_at_point, pressure };

/// Corrects the inputs of a moment, or the state at the start of a run, before anything else sees them.
struct InputCorrection {
    void (*transform)(const ActiveEffect& active, Inputs& inputs) = nullptr;
    /// By how much the log of a signal is late: what happens at t stands in it at t + delay. @returns s; 0: not at all
    double (*delay)(const ActiveEffect& active, const Signal& signal) = nullptr;
    /// @param temperature [n_nodes] K
    void (*start)(const ActiveEffect& active, const mesh::Mesh& mesh, std::span<double> temperature) = nullptr;
};

/// Changes properties once before a run, or laws: from the inputs of a moment, or from temperatures.
struct PropertyModifier {
    void (*place)(const PlacementContext& context, ActiveEffect& active) = nullptr;
    void (*modify_properties)(const ActiveEffect& active, const mesh::Mesh& mesh,
                              MaterialModel& material_model) = nullptr;
    void (*modify_laws)(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, Laws& laws) = nullptr;
    LossLaw scale_loss = nullptr;
};

/// Adds heat in two steps: `evaluate_coefficients` turns the inputs of a moment into a few coefficients, which do not
/// depend on temperature and can therefore be integrated exactly along a logged series; `add_terms` turns coefficients
/// and temperatures into conductances, exchanges and heat.
struct HeatEffect {
    bool by_deformation = false;  ///< its heat is work of deformation: what rolling resistance pays for
    bool travels = false;         ///< its place goes round the tire with the wheel angle
    bool is_memory = false;  ///< its lumped nodes are states of a law, no part of the tire: no budget counts their heat
    int n_coefficients = 0;
    FieldOf field = FieldOf::nothing;  ///< what a file of a structural code may give: the key `field` of a case
    int frame_coefficients = 0;        ///< more coefficients, where such a field follows time; 0: it cannot
    bool gives_derivatives = true;     ///< otherwise they are taken by difference, for local dependence only

    /// Adds lumped nodes and coupling faces to the mesh, once, when the effect is switched on.
    void (*extend)(mesh::Mesh& mesh, ActiveEffect& active) = nullptr;
    /// Heat capacity of its lumped nodes. @returns J/K, in the order of ActiveEffect::lumped_nodes
    double (*capacity)(const ActiveEffect& active, std::size_t index) = nullptr;
    std::string_view starts_at = "air_temperature";  ///< the input whose first value its lumped nodes start at
    void (*place)(const PlacementContext& context, ActiveEffect& active) = nullptr;
    /// The law of the loss that follows the temperature of a lumped node of its own, if it carries one.
    LossLaw scale_loss = nullptr;
    /// @param coefficients out, [n_coefficients]; null where there are none
    void (*evaluate_coefficients)(const ActiveEffect& active, const OperatingPoint& point,
                                  std::span<double> coefficients) = nullptr;
    void (*add_terms)(const EvaluationState& state, Terms& terms) = nullptr;  ///< never null
    /// The range that its law is known for, in a sentence without what was reached, when the temperatures that its patches saw,
    /// or all layers where it has none, left it; otherwise empty. @param coldest, hottest K
    std::string (*range_warning)(const ActiveEffect& active, double coldest, double hottest) = nullptr;
};

/// Stands between the field and the channels that a case names. The functions take the channel's position in
/// ActiveEffect::channels.
struct SensorModel {
    ChannelsOf applies_to = ChannelsOf::anything;
    bool sees_surfaces_only = false;  ///< a camera: no candidate for what reads the inside
    bool before_lag = false;          ///< a model of what the sensor sees, not of what it gives

    /// The sensor's output from the value before.
    double (*read)(const ActiveEffect& active, std::size_t position, double value, const Inputs& logged) = nullptr;
    double (*lag)(const ActiveEffect& active, std::size_t position) = nullptr;         ///< time constant, s
    double (*delay)(const ActiveEffect& active, std::size_t position) = nullptr;       ///< s
    double (*clock_rate)(const ActiveEffect& active, std::size_t position) = nullptr;  ///< further delay, s for each s
    double (*depth_offset)(const ActiveEffect& active, std::size_t position) = nullptr;  ///< m below the stated depth
};

}  // namespace tiretherm::physics
