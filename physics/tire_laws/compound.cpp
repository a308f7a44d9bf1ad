// SPDX-License-Identifier: BSD-3-Clause
// Reads the parameters of the effect by their names; a table of the loss tangent goes before the Gaussian.

#include "physics/tire_laws/compound.hpp"

#include <algorithm>

namespace tiretherm::physics {

namespace {

LossTangent law_of(const ActiveEffect& active, int layer) {
    const auto number = [&](std::string_view key) {
        return active.at(static_cast<std::size_t>(find_parameter(*active.effect, key)), Scope::layer, layer);
    };
    return {.a = number("tan_delta_a"),
            .b = number("tan_delta_b"),
            .c = number("tan_delta_c"),
            .f0 = number("f0"),
            .C1 = number("C1"),
            .C2 = number("C2"),
            .peak = number("tan_delta_peak")};
}

const std::optional<Curve>& table_of(const ActiveEffect& active) {
    return active.tables[static_cast<std::size_t>(find_table(*active.effect, "tan_delta"))];
}

}  // namespace

double tan_delta_of(const ActiveEffect& active, int layer, double T, double frequency) {
    const LossTangent law = law_of(active, layer);
    const double T_eq = T + law.shift(frequency);
    const std::optional<Curve>& table = table_of(active);
    return table ? table->value(T_eq) : law.value(T_eq);
}

LossPeak loss_peak(const ActiveEffect& active, int layer) {
    const LossTangent law = law_of(active, layer);
    if (const std::optional<Curve>& table = table_of(active)) {
        const auto highest = std::ranges::max_element(table->table_y());
        const auto place = static_cast<std::size_t>(highest - table->table_y().begin());
        return {.temperature = table->table_x()[place], .value = *highest, .frequency = law.f0};
    }
    const double top = std::max(law.b, law.peak);
    return {.temperature = top, .value = law.value(top), .frequency = law.f0};
}

}  // namespace tiretherm::physics
