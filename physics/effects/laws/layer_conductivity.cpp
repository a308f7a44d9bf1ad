// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: k'(T) = scale (k(T) + slope k(reference) (T - reference)) in the named layers, on two nodes in the
// link between them (thesis (34)).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { scale, slope, reference };

constexpr std::array parameters{
    ParameterSpec{"scale", "1", 1.0, 1e-3, 1e3, "factor on k(T)", false, 1.0},
    ParameterSpec{"slope", "K-1", 0.0, -1.0, 1.0, "added to dk/dT, over k at the reference", false, 0.0},
    ParameterSpec{"reference", "K", 293.15, 200.0, 500.0, "temperature about which the slope turns"},
};
constexpr std::array confounded{
    ConfoundedGroup{{"layer_conductivity", "layer_heat_capacity"}, "a steady state: it sees the conductivity alone"}};
constexpr std::array plausible{
    PlausibleRange{"scale", 0.7, 1.5, "tread compounds 0.21 to 0.56 W/(m K) about the thesis's 0.29 (Clark, NASA 1983)",
                   "no compound conducts that much otherwise: heat leaves by a path that the model lacks"},
    PlausibleRange{"slope", -0.01, 0.03,
                   "laws that the thesis identified with a laser rise by 3 % per K; compounds by far less, recalled",
                   "no compound changes that fast with temperature: another loss grows with it"},
};
constexpr std::array scopes{Scope::layer};

// The line is a share of k itself, so that factors on the same layer by other effects commute with it.
Curve modified(const ActiveEffect& active, int layer, const Curve& k) {
    const double line = active.at(slope, Scope::layer, layer) * k.value(active[reference]);
    return k.plus_line(active[reference], line).scaled(active.at(scale, Scope::layer, layer));
}

/// Two lumps have no inner resistance: what conducts between them is the link, which takes the bulk's numbers.
void modify_properties(const ActiveEffect& active, const mesh::Mesh& mesh, MaterialModel& material_model) {
    for (const int layer : active.layers) {
        for (Curve& k : material_model.materials[static_cast<std::size_t>(layer)].conductivity) {
            k = modified(active, layer, k);
        }
        if (mesh.is_lumped() && layer == 1) {
            material_model.link_laws.front() = modified(active, layer, material_model.link_laws.front());
        }
    }
}

}  // namespace

extern const Effect layer_conductivity;
const Effect layer_conductivity{
    .id = "layer_conductivity",
    .kind = EffectKind::property,
    .equation = "k'(T) = scale (k(T) + slope k(reference) (T - reference))",
    .source = "definition; thesis (34)",
    .valid = "0.5 to 2 times what is printed of a compound; a slope over some 100 K",
    .meaning =
        "A layer that conducts better or worse than stated, or changes otherwise with temperature; on two nodes the "
        "link between them. The ratio of back to front shows it, and with a slope the ratio of two powers.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .scopes = scopes,
    .on_layers = true,
    .model = PropertyModifier{.modify_properties = modify_properties},
};

}  // namespace tiretherm::physics::effects
