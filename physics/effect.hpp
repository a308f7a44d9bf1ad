#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
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

/// What a cause is, for the reader of the catalogue.
enum class Kind : std::uint8_t { source, loss, property, input, state, sensor };

/// A parameter of an effect. `standard` is used where a case says nothing; a value outside [low, high] is refused.
struct ParameterSpec {
    std::string_view key;
    std::string_view unit;  ///< UDUNITS; the value inside is in this unit
    double standard;
    double low;
    double high;
    std::string_view meaning;
    bool difference = false;  ///< of two temperatures: converted without the offset of a scale
    /// The value at which an effect changes nothing; NaN where there is none.
    double absent = std::numeric_limits<double>::quiet_NaN();
};

/// A word of an effect.
struct Choice {
    std::string_view key;
    std::span<const std::string_view> options;  ///< the first is the standard one
    std::string_view meaning;
};

/// A table of an effect that replaces one of its weights.
struct Table {
    std::string_view key;
    std::string_view variable_unit;
    std::string_view value_unit;
    std::string_view meaning;
};

/// Where a parameter may differ: `<key>_by_patch = { outside = ... }` in a case.
enum class Scope : std::uint8_t { patch, layer, zone, channel };

/// What kind of channel a sensor model applies to.
enum class Reads : std::uint8_t { anything, temperature, place, pressure };

struct ActiveEffect;
struct MeasuredLoss;

/// Materials, laws of the links and the tire, as a case gives them; property modifiers change them before a run.
struct MaterialModel {
    std::vector<Material> materials;  ///< [n_layers]
    std::vector<Curve> link_laws;     ///< [n_links] k in W/(m K)
    Tire tire;
};

/// What an effect knows when it places itself, once, before the first step.
struct PlacementContext {
    const mesh::Mesh& mesh;
    const MaterialModel& material_model;
    std::span<const ActiveEffect> effects;  ///< all that are on

    [[nodiscard]] const ActiveEffect* find(std::string_view id) const;  ///< null when off
};

/// What property modifiers make of the thesis's laws at a moment, as far as it follows from the inputs.
struct Laws {
    double loss = 1.0;        ///< factor on the strain-energy loss
    double loss_shift = 0.0;  ///< K, added to the equivalent temperature of its loss tangent
    double loss_skew = 0.0;   ///< share of the loss that moves from the inside shoulder to the outside one
    double partition = 1.0;   ///< factor on the share of the friction power that enters the tire
    double forced = 1.0;      ///< factor on the forced part of the air convection
};

/// The inputs of a moment, after the input corrections, and the laws that hold.
struct OperatingPoint {
    const Tire& tire;
    const Inputs& inputs;
    const Laws& laws;
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
};

/// One physical cause, as plain data. Effects come in four classes, applied in this order; within a class their order
/// does not matter, but for sensor models, whose order is that of the catalogue:
///   - input corrections transform the inputs (`transform`) or the initial state (`start`);
///   - property modifiers change properties (`modify_properties`), or laws from the inputs (`modify_laws`) or from
///     temperatures (`scale_loss`);
///   - heat effects work in two steps: `evaluate_coefficients` turns the inputs of a moment into a few coefficients,
///     which do not depend on temperature and can therefore be integrated exactly along a logged series; `add_terms`
///     turns coefficients and temperatures into conductances, exchanges and heat;
///   - sensor models stand between the field and a channel (`read`, `lag`, `delay`, `depth_offset`).
/// A function that an effect does not have is null.
struct Effect {
    std::string_view id;
    Kind kind;
    bool on = false;  ///< part of the thesis's model
    std::string_view equation;
    std::string_view source;
    std::string_view meaning;
    std::span<const ParameterSpec> parameters{};
    std::span<const Choice> choices{};
    std::span<const Table> tables{};
    std::span<const Scope> scopes{};               ///< where its parameters may differ
    std::span<const std::string_view> reads{};     ///< names of the signals it needs
    std::span<const std::string_view> may_read{};  ///< names of signals it uses when they are given
    std::string_view instead_of{};                 ///< an effect that it describes better: one of the two acts
    bool needs_tire = false;
    bool needs_grid = false;                      ///< cannot act on lumps
    std::span<const std::string_view> patches{};  ///< standard patches, or empty if it acts elsewhere
    bool one_patch = false;                       ///< of these the first that the mesh has, not all
    bool on_layers = false;                       ///< acts on the layers that a case names
    bool on_channels = false;                     ///< acts on the channels that a case names
    bool by_deformation = false;                  ///< its heat is work of deformation: what rolling resistance pays for
    bool travels = false;                         ///< its place goes round the tire with the wheel angle
    bool before_lag = false;                      ///< a model of what the sensor sees, not of what it gives
    Reads reads_what = Reads::anything;           ///< of a sensor model; `place`: the temperature at a point
    int n_coefficients = 0;
    FieldOf field = FieldOf::nothing;  ///< what a file of a structural code may give: the key `field` of a case
    int frame_coefficients = 0;        ///< more coefficients, where such a field follows time; 0: it cannot

    /// Adds lumped nodes and coupling faces to the mesh, once, when the effect is switched on.
    void (*extend)(mesh::Mesh& mesh, ActiveEffect& active) = nullptr;
    /// Heat capacity of its lumped nodes. @returns J/K, in the order of ActiveEffect::lumped_nodes
    double (*capacity)(const ActiveEffect& active, std::size_t index) = nullptr;
    void (*start)(const ActiveEffect& active, const mesh::Mesh& mesh, std::span<double> temperature) = nullptr;
    void (*modify_properties)(const ActiveEffect& active, const mesh::Mesh& mesh,
                              MaterialModel& material_model) = nullptr;
    void (*place)(const PlacementContext& context, ActiveEffect& active) = nullptr;
    void (*transform)(const ActiveEffect& active, Inputs& inputs) = nullptr;
    void (*modify_laws)(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, Laws& laws) = nullptr;
    LossFactor (*scale_loss)(const EvaluationState& state) = nullptr;
    void (*evaluate_coefficients)(const ActiveEffect& active, const OperatingPoint& point,
                                  std::span<double> coefficients) = nullptr;
    void (*add_terms)(const EvaluationState& state, Terms& terms) = nullptr;
    bool gives_derivatives = true;  ///< otherwise they are taken by difference, for local dependence only
    /// The sensor's output from the value before. @param position of the channel in ActiveEffect::channels
    double (*read)(const ActiveEffect& active, std::size_t position, double value, const Inputs& logged) = nullptr;
    double (*lag)(const ActiveEffect& active, std::size_t position) = nullptr;           ///< time constant, s
    double (*delay)(const ActiveEffect& active, std::size_t position) = nullptr;         ///< s
    double (*depth_offset)(const ActiveEffect& active, std::size_t position) = nullptr;  ///< m below the stated depth
    /// A sentence for the user when the numbers of a case cannot hold on this mesh, or an empty one.
    std::string (*invalid_on_mesh)(const ActiveEffect& active, const mesh::Mesh& mesh) = nullptr;
    /// A sentence for the user when the temperatures that its patches saw leave the range its law is known for, or an
    /// empty one. @param coldest, hottest K
    std::string (*range_warning)(const ActiveEffect& active, double coldest, double hottest) = nullptr;
};

/// An effect switched on, with its numbers.
struct ActiveEffect {
    /// Another value of a parameter on one patch, layer, zone or channel.
    struct Override {
        Scope scope = Scope::patch;
        int index = 0;  ///< into the mesh's patches, layers or zones, or the problem's channels
        std::size_t parameter = 0;
        double value = 0.0;
    };

    const Effect* effect = nullptr;
    std::string name{};                        ///< of a user effect; otherwise empty
    std::vector<double> parameters;            ///< in the order of effect->parameters
    std::vector<int> choices;                  ///< index of the option chosen, in the order of effect->choices
    std::vector<std::optional<Curve>> tables;  ///< in the order of effect->tables
    std::vector<int> patches;                  ///< indices into mesh.patches
    std::vector<int> layers;                   ///< indices into mesh.layers, of an effect on layers
    std::vector<int> channels;                 ///< indices into the problem's channels, of a sensor model
    std::vector<Override> overrides;
    std::shared_ptr<const Field> field{};         ///< replaces the weights of `place`
    std::shared_ptr<const MeasuredLoss> total{};  ///< replaces the total of the effect's law
    std::vector<int> lumped_nodes;                ///< filled by `extend`: lumped nodes of its own
    std::vector<int> coupling_faces;              ///< filled by `extend`: faces that lead to lumped nodes
    std::vector<int> nodes;                       ///< filled by `place`: where it acts
    std::vector<double> weights;                  ///< filled by `place`: with which share
    std::vector<int> groups;   ///< filled by `place`: where runs of alike places begin in `weights`, and their end
    std::vector<double> skew;  ///< filled by `place`: how far to the outside shoulder, -1 inside to 1 outside

    /// What it is called: its own name, or its effect's.
    [[nodiscard]] std::string_view title() const { return name.empty() ? effect->id : std::string_view(name); }
    [[nodiscard]] double operator[](std::size_t parameter) const { return parameters[parameter]; }
    /// A parameter at a place, as overridden there.
    [[nodiscard]] double at(std::size_t parameter, Scope scope, int index) const;
    /// A parameter on the patch at this position of `patches`.
    [[nodiscard]] double on_patch(std::size_t parameter, std::size_t position) const {
        return at(parameter, Scope::patch, patches[position]);
    }
};

/// An effect with its standard numbers on its standard patches (those of them that the mesh has) or layers (all below
/// the first, or the only one).
[[nodiscard]] ActiveEffect activate(const Effect& effect, const mesh::Mesh& mesh);

/// Index of a parameter, choice or table by its key, -1 when absent.
[[nodiscard]] int find_parameter(const Effect& effect, std::string_view key);
[[nodiscard]] int find_choice(const Effect& effect, std::string_view key);
[[nodiscard]] int find_table(const Effect& effect, std::string_view key);

/// The same effect with the coefficients that a field in frames needs. @pre effect.frame_coefficients > 0
[[nodiscard]] const Effect& in_frames(const Effect& effect);

/// The catalogue, in the order of effects.list.
[[nodiscard]] std::span<const Effect* const> catalogue();
[[nodiscard]] const Effect* find_effect(std::string_view id);  ///< null when absent

}  // namespace tiretherm::physics
