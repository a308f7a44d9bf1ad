// SPDX-License-Identifier: BSD-3-Clause
// The effects that an exam may hide in simulated data, each with the range of its parameter.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

/// A cause of the catalogue as an exam hides it: the number that says how much of it there is, and how much there can be.
struct Variant {
    std::string id;
    std::string channel{};  ///< of a sensor's effect
    std::string layer{};    ///< of an effect on one of several layers
    std::string key;        ///< of the number, in the catalogue's unit
    double absent = 0.0;    ///< the number where nothing is hidden
    double typical = 1.0;   ///< a step from there that shows: where the search for a size begins
    double low = 0.0;       ///< the least and
    double high = 0.0;      ///< the largest number that a tire, a bench or a sensor may have

    [[nodiscard]] bool both_ways() const { return low < absent && absent < high; }
    /// "sensor_lag of bulk_temperature", "layer_conductivity in tread"
    [[nodiscard]] std::string name() const;
};

/// Every cause that a bench of two nodes can have, each sensor's on each channel: 18 effects, 21 variants.
[[nodiscard]] const std::vector<Variant>& single_variants();
/// Every cause that the bench of layers, of a section or of a laser can have, as its page says: each sensor's on each
/// channel, each layer's on each layer.
[[nodiscard]] const std::vector<Variant>& layers_variants();
[[nodiscard]] const std::vector<Variant>& section_variants();
[[nodiscard]] const std::vector<Variant>& laser_variants();

/// Whether an effect acts on a layer, which a truth gets as the cause's channel.
[[nodiscard]] bool acts_on_layer(std::string_view id);
/// "sensor_lag of bulk_temperature", "layer_conductivity in tread", "layer_conductivity" of two nodes
[[nodiscard]] std::string name_of(const Cause& cause);

/// The cause with its number, and what goes with it: the gas gives to the rim 4/9 of what it takes per kelvin, and the
/// standing wave begins at a speed. @param critical_speed km/h
[[nodiscard]] Cause cause_of(const Variant& variant, double number, double critical_speed);

}  // namespace hidden_effects
