#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

/// Resistance per area [m2 K/W] of half a face in one material at one temperature, and its derivative.
struct Half {
    double resistance;
    double by_T;
};

Half half(const Curve& k, double length, double T) {
    const double value = k.value(T);
    const double resistance = length / value;
    return {resistance, -resistance * k.slope(T) / value};
}

/// Area over length of every face, which is its conductance per conductivity.
void place(const Setting& setting, ActiveEffect& active) {
    active.weights.clear();
    for (const mesh::Face& face : setting.mesh.faces) {
        const double length = face.half_a + face.half_b;
        active.weights.push_back(length > 0.0 ? face.area / length : 0.0);
    }
}

void speak(const Moment& m, Terms& terms) {
    const std::vector<mesh::Face>& faces = m.mesh.faces;
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
        const mesh::Face& face = faces[static_cast<std::size_t>(f)];
        const auto a = static_cast<std::size_t>(face.a);
        const auto b = static_cast<std::size_t>(face.b);
        if (face.joint) {
            continue;
        }
        if (face.link < 0 && m.mesh.layer[a] == m.mesh.layer[b]) {
            const Curve& k = m.stock.materials[static_cast<std::size_t>(m.mesh.layer[a])].along(face.axis);
            const double per_k = m.active.weights[static_cast<std::size_t>(f)];
            const Curve::Mean mean = k.mean(m.temperature[a], m.temperature[b]);
            terms.conduct(f, per_k * mean.value, per_k * mean.by_a, per_k * mean.by_b);
            continue;
        }
        Half on_a{};
        Half on_b{};
        if (face.half_a > 0.0) {
            on_a = half(m.stock.materials[static_cast<std::size_t>(m.mesh.layer[a])].along(face.axis), face.half_a,
                        m.temperature[a]);
        }
        if (face.half_b > 0.0) {
            on_b = half(m.stock.materials[static_cast<std::size_t>(m.mesh.layer[b])].along(face.axis), face.half_b,
                        m.temperature[b]);
        }
        Half between{};
        int region = 0;
        if (face.link >= 0) {
            const mesh::Link& link = m.mesh.links[static_cast<std::size_t>(face.link)];
            region = link.region;
            between = half(m.stock.link_laws[static_cast<std::size_t>(face.link)], link.length,
                           m.region_mean[static_cast<std::size_t>(region)]);
        }
        const double G = face.area / (on_a.resistance + on_b.resistance + between.resistance);
        const double by_resistance = -G * G / face.area;
        terms.conduct(f, G, by_resistance * on_a.by_T, by_resistance * on_b.by_T);
        if (between.by_T != 0.0) {
            terms.conduct_follows(f, region, by_resistance * between.by_T);
        }
    }
}

}  // namespace

extern const Effect conduction;
const Effect conduction{
    .id = "conduction",
    .kind = Kind::property,
    .on = true,
    .equation = "q = -k(T) grad T inside the layers; (T_b - T_s) k(T_b)/dZ S_tot across a link",
    .source = "Fourier; thesis (31)(34)",
    .meaning = "Heat conducted between cells. The laws k(T) and c(T) belong to the materials of the layers.",
    .place = place,
    .speak = speak,
};

}  // namespace tiretherm::physics::effects
