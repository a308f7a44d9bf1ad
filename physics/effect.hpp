// SPDX-License-Identifier: BSD-3-Clause
// An effect of the catalogue as plain data, an effect that is switched on, and the catalogue itself. The equations stand
// in the effects' own files.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/effect_classes.hpp"
#include "physics/effect_facts.hpp"
#include "physics/field_transfer/field.hpp"

namespace tiretherm::physics {

/// What a cause is, for the reader of the catalogue.
enum class EffectKind : std::uint8_t { source, loss, property, input, state, sensor };

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
    double (Tire::*absent_of_tire)() const = nullptr;  ///< where that value follows from the tire

    [[nodiscard]] double absent_of(const Tire& tire) const {
        return absent_of_tire != nullptr ? (tire.*absent_of_tire)() : absent;
    }
};

/// A word of an effect.
struct Choice {
    std::string_view key;
    std::span<const std::string_view> options;  ///< the first is the standard one
    std::string_view meaning;
    std::span<const std::string_view> reads{};  ///< signals that all but the first need, and with them a tire
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

struct MeasuredLoss;

/// Values within which a law was compared with measurements, or is said to hold. The source stands beside each.
struct ComparedRange {
    std::string_view signal;  ///< an input; empty: what `value` makes of all
    double low = 0.0;         ///< SI, or in `unit`
    double high = 0.0;
    std::string_view how = "compared";  ///< what was done there: "compared", "fitted", "measured", "stated"
    std::string_view unit{};            ///< of `value`: "times its reference pressure"
    /// 0 where the range says nothing.
    double (*value)(const ActiveEffect& active, const Tire& tire, const Inputs& inputs) = nullptr;
};

/// One physical cause, as plain data: facts that all effects have, and the class it belongs to with the functions of that
/// class. The classes act in the order in which the variant lists them; within a class the order of the effects does not
/// matter, but for sensor models, whose order is that of the catalogue.
struct Effect {
    std::string_view id;
    EffectKind kind;
    bool on = false;  ///< part of the thesis's model
    std::string_view equation;
    std::string_view source;
    std::string_view valid{};  ///< where its law and its standard numbers hold, and what is assumed of them
    std::string_view meaning;
    std::span<const ComparedRange> compared{};  ///< where its law was compared with measurements, or is said to hold
    std::span<const ParameterSpec> parameters{};
    std::span<const PlausibleRange> plausible{};  ///< of its parameters
    std::span<const ConfoundedGroup> confounded{};
    std::span<const TrialValues> trials{};  ///< of its parameters
    std::span<const Choice> choices{};
    std::span<const Table> tables{};
    std::span<const Scope> scopes{};               ///< where its parameters may differ
    std::span<const std::string_view> reads{};     ///< names of the signals it needs
    std::span<const std::string_view> may_read{};  ///< names of signals it uses when they are given
    std::string_view instead_of{};                 ///< an effect that it describes better: one of the two acts
    /// A diagnosis tries it where this effect is on or a case lists it as a candidate; empty: wherever it can act.
    std::string_view tried_beside{};
    bool needs_tire = false;
    bool needs_grid = false;                      ///< cannot act on lumps
    std::span<const std::string_view> patches{};  ///< standard patches, or empty if it acts elsewhere
    bool one_patch = false;                       ///< of these the first that the mesh has, not all
    bool on_layers = false;                       ///< acts on the layers that a case names
    /// A sentence for the user when the numbers of a case cannot hold on this mesh, or an empty one.
    std::string (*invalid_on_mesh)(const ActiveEffect& active, const mesh::Mesh& mesh) = nullptr;
    std::variant<InputCorrection, PropertyModifier, HeatEffect, SensorModel> model;

    /// The effect as a member of one class, null when it belongs to another.
    [[nodiscard]] const InputCorrection* input_correction() const { return std::get_if<InputCorrection>(&model); }
    [[nodiscard]] const PropertyModifier* property_modifier() const { return std::get_if<PropertyModifier>(&model); }
    [[nodiscard]] const HeatEffect* heat_effect() const { return std::get_if<HeatEffect>(&model); }
    [[nodiscard]] const SensorModel* sensor_model() const { return std::get_if<SensorModel>(&model); }

    /// How many coefficients follow from the inputs: none but for heat effects.
    [[nodiscard]] int n_coefficients() const { return heat_effect() != nullptr ? heat_effect()->n_coefficients : 0; }
    /// What a file of a structural code may give it: nothing but to heat effects.
    [[nodiscard]] FieldOf field() const { return heat_effect() != nullptr ? heat_effect()->field : FieldOf::nothing; }
    /// Finds where it acts, once, before the first step; nothing to find for most effects.
    void place(const PlacementContext& context, ActiveEffect& active) const;
    /// Its law of the loss, as a property modifier or as a heat effect; null when it has none.
    [[nodiscard]] LossLaw loss_law() const;
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
    std::shared_ptr<const OwnLaw> law{};          ///< of a user's heat source, in the place of its number
    std::vector<int> lumped_nodes;                ///< filled by `extend`: lumped nodes of its own
    std::vector<int> coupling_faces;              ///< filled by `extend`: faces that lead to lumped nodes; of a contact
                                                  ///< by `place`: from each of its nodes to a drum that it heats
    std::vector<int> nodes;                       ///< filled by `place`: where it acts
    std::vector<double> weights;                  ///< filled by `place`: with which share
    std::vector<int> groups;  ///< filled by `place`: where runs of alike places begin in `weights`, and their end
    int road = -1;  ///< filled by `place`: index of the effect through which the road takes heat back; -1: none
    std::vector<double>
        effusivities;  ///< filled by `place`: of the tread, at which what happens in the contact is worked out
    double effusivity_of_road = 0.0;  ///< filled by `place`
    double share_of_drum = 0.0;       ///< filled by `place`, of a contact: of what the road takes, by `coupling_faces`
    std::vector<double> skew;         ///< filled by `place`: how far to the outside shoulder, -1 inside to 1 outside
    std::vector<double> crown;  ///< filled by `place`, of a contact: how far a place gains from pressure in the middle

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

/// The same effect with the coefficients that a field in frames needs. @pre it is a heat effect with frame_coefficients > 0
[[nodiscard]] const Effect& in_frames(const Effect& effect);

/// The catalogue, in the order of effects.list.
[[nodiscard]] std::span<const Effect* const> catalogue();
[[nodiscard]] const Effect* find_effect(std::string_view id);  ///< null when absent

}  // namespace tiretherm::physics
