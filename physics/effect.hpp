#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/material.hpp"
#include "physics/signals.hpp"
#include "physics/terms.hpp"
#include "physics/tire.hpp"

namespace tiretherm::physics {

/// What a cause is, for the reader of the catalogue.
enum class Kind : std::uint8_t { source, loss, property };

/// A number of an effect. `standard` is used where a case says nothing; a value outside [low, high] is refused.
struct Parameter {
    std::string_view key;
    std::string_view unit;  ///< UDUNITS; the value inside is in this unit, which is SI with kelvin
    double standard;
    double low;
    double high;
    std::string_view meaning;
};

/// A word of an effect.
struct Choice {
    std::string_view key;
    std::span<const std::string_view> options;  ///< the first is the standard one
    std::string_view meaning;
};

struct ActiveEffect;

/// Where an effect is asked to place itself, once, before the first step.
struct Setting {
    const mesh::Mesh& mesh;
    std::span<const Material> materials;  ///< [n_layers]
    const Tire& tire;
};

/// Everything an effect may look at when it speaks.
struct Moment {
    const mesh::Mesh& mesh;
    std::span<const Material> materials;  ///< [n_layers]
    std::span<const Curve> link_laws;     ///< [n_links] k in W/(m K)
    const Tire& tire;
    std::span<const double> temperature;  ///< [n_nodes] K
    std::span<const double> region_mean;  ///< [n_regions] K
    const ActiveEffect& active;
    std::span<const double> intensities;  ///< [n_intensities] of this effect
};

/// One physical cause, as plain data. An effect speaks in two steps: `drive` turns the inputs of a moment into a few
/// numbers, its intensities, which do not depend on temperature and can therefore be integrated exactly along a logged
/// series; `speak` turns intensities and temperatures into conductances, exchanges and heat.
struct Effect {
    std::string_view id;
    Kind kind;
    bool on;  ///< part of the thesis's model
    std::string_view equation;
    std::string_view source;
    std::string_view meaning;
    std::span<const Parameter> parameters;
    std::span<const Choice> choices;
    std::span<const std::string_view> reads;  ///< names of the signals it needs
    bool needs_tire;
    std::span<const std::string_view> patches;  ///< standard patches, or empty if it acts elsewhere
    int n_intensities;
    void (*place)(const Setting& setting, ActiveEffect& active);  ///< may be null
    void (*drive)(const ActiveEffect& active, const Tire& tire, const Inputs& inputs,
                  std::span<double> intensities);  ///< may be null
    void (*speak)(const Moment& moment, Terms& terms);
    bool gives_derivatives;  ///< otherwise they are taken by difference, for local dependence only
    /// A sentence for the user when the temperatures that its patches saw leave the range its law is known for, or an
    /// empty one. May be null. @param coldest, hottest K
    std::string (*caution)(const ActiveEffect& active, double coldest, double hottest) = nullptr;
};

/// An effect switched on, with its numbers.
struct ActiveEffect {
    const Effect* effect = nullptr;
    std::vector<double> parameters;  ///< in the order of effect->parameters
    std::vector<int> choices;        ///< index of the option chosen, in the order of effect->choices
    std::vector<int> patches;        ///< indices into mesh.patches
    std::vector<double> by_patch;    ///< [patches][parameters], or empty: the same numbers on every patch
    std::vector<int> nodes;          ///< filled by `place`: where it acts
    std::vector<double> weights;     ///< filled by `place`: with which share

    [[nodiscard]] double operator[](std::size_t parameter) const { return parameters[parameter]; }
    /// A parameter on the patch at this position of `patches`.
    [[nodiscard]] double on_patch(std::size_t parameter, std::size_t position) const {
        return by_patch.empty() ? parameters[parameter] : by_patch[position * parameters.size() + parameter];
    }
};

/// An effect with its standard numbers on its standard patches (those of them that the mesh has).
[[nodiscard]] ActiveEffect activate(const Effect& effect, const mesh::Mesh& mesh);

/// Index of a parameter or choice by its key, -1 when absent.
[[nodiscard]] int find_parameter(const Effect& effect, std::string_view key);
[[nodiscard]] int find_choice(const Effect& effect, std::string_view key);

/// The catalogue, in the order of effects.list.
[[nodiscard]] std::span<const Effect* const> catalogue();
[[nodiscard]] const Effect* find_effect(std::string_view id);  ///< null when absent

}  // namespace tiretherm::physics
