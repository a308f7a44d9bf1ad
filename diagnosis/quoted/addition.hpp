// SPDX-License-Identifier: BSD-3-Clause
// What may be added to a model to explain quoted numbers: an effect, another number of an effect that is on, a finer mesh,
// another value of an input that is not printed, or an error of an instrument. Each has one number, or none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tiretherm::diagnosis::quoted {

enum class AdditionKind : std::uint8_t {
    effect,     ///< of the catalogue, off in the cases
    number,     ///< of an effect that is on
    mesh,       ///< another model of the table; nothing is fitted
    input,      ///< of the experiments, not printed
    instrument  ///< offset or gain of all readings of one sensor's name
};

/// One addition with what it changes, at some values of its number.
struct Addition {
    AdditionKind kind = AdditionKind::effect;
    std::string id;       ///< effect, model, input or sensor
    std::string key{};    ///< of the number: "conductance", "offset"; empty where there is none
    std::string unit{};   ///< of the number, UDUNITS
    std::string what{};   ///< more about it: "critical_speed = 125 km/h", or empty
    double absent = 0.0;  ///< the value that changes nothing
    double low = 0.0;     ///< the plausible range
    double high = 0.0;
    std::string source{};         ///< of the range
    int input = -1;               ///< index into Numbers::inputs, of an input
    std::size_t model = 0;        ///< index into Validation::models, of a mesh
    std::vector<double> nodes{};  ///< ascending values that were simulated, `absent` among them; of a mesh 0 and 1
    std::vector<std::vector<double>> changes{};  ///< [nodes][rows], in the unit of each row
    bool is_simulated = true;                    ///< anywhere but where it changes nothing

    /// What chi squared pays for a value: the plausible range is taken as two standard deviations about `absent`.
    [[nodiscard]] double penalty(double value) const;
    [[nodiscard]] bool is_fitted() const { return kind != AdditionKind::mesh; }
    /// Values of the number at which changes are looked up.
    static constexpr std::size_t n_values = 121;
    [[nodiscard]] double value(std::size_t i) const;
    /// Where its interactions with others are simulated: 0.6 of the way to the further end, about where fits of it end.
    [[nodiscard]] double reference() const {
        return absent + 0.6 * ((high - absent >= absent - low ? high : low) - absent);
    }
    /// What it changes at all of these values, between the nodes by cubics.  @returns [n_values][rows]
    [[nodiscard]] std::vector<std::vector<double>> table() const;
    /// "sidewall_convection.conductance", "input hall", "offset of bulk_temperature"
    [[nodiscard]] std::string name() const;
    /// Whether another one is the same cause under another number.
    [[nodiscard]] bool is_same_cause(const Addition& other) const { return kind == other.kind && id == other.id; }
};

/// Values of a number that are simulated: both ends of its range, the absent value, and one between it and each end.
[[nodiscard]] std::vector<double> trial_nodes(double absent, double low, double high);

}  // namespace tiretherm::diagnosis::quoted
