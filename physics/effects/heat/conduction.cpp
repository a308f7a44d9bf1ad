// SPDX-License-Identifier: BSD-3-Clause
// Heat conduction between cells, q = -k(T) grad T, with k averaged between the two temperatures inside a material; (T_b
// - T_s) k(T_b)/dZ S_tot across a link (Fourier; thesis (31), (34)).

#include <algorithm>
#include <array>
#include <optional>

#include "mesh/parallel.hpp"
#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

/// Resistance per area [m2 K/W] of half a face in one material at one temperature, and its derivative.
struct Half {
    double resistance;
    double dR_dT;
};

Half half(const Curve& k, double length, double T) {
    const double value = k.value(T);
    const double resistance = length / value;
    return {resistance, -resistance * k.slope(T) / value};
}

/// Faces inside one material come in groups of one layer and direction, three numbers each: the face and its nodes; their
/// weight is area over length. The other faces follow as one group more.
void place(const PlacementContext& context, ActiveEffect& active) {
    const mesh::Mesh& mesh = context.mesh;
    active.nodes.clear();
    active.weights.clear();
    active.groups = {0};
    const auto add = [&](int f) {
        const mesh::Face& face = mesh.faces[static_cast<std::size_t>(f)];
        const double length = face.half_a + face.half_b;
        active.nodes.insert(active.nodes.end(), {f, face.a, face.b});
        active.weights.push_back(length > 0.0 ? face.area / length : 0.0);
    };
    const int n_faces = static_cast<int>(mesh.faces.size());
    const auto layer_of = [&](int f) {
        const mesh::Face& face = mesh.faces[static_cast<std::size_t>(f)];
        const int layer = mesh.layer[static_cast<std::size_t>(face.a)];
        return !face.is_coupling && face.link < 0 && layer == mesh.layer[static_cast<std::size_t>(face.b)] ? layer : -1;
    };
    std::vector<std::vector<int>> alike(3 * mesh.layers.size());
    for (int f = 0; f < n_faces; ++f) {
        if (const int layer = layer_of(f); layer >= 0) {
            const auto axis = static_cast<std::size_t>(mesh.faces[static_cast<std::size_t>(f)].axis);
            alike[3 * static_cast<std::size_t>(layer) + axis].push_back(f);
        }
    }
    for (const std::vector<int>& faces : alike) {
        std::for_each(faces.begin(), faces.end(), add);
        if (!faces.empty()) {
            active.groups.push_back(static_cast<int>(active.weights.size()));
        }
    }
    for (int f = 0; f < n_faces; ++f) {
        if (layer_of(f) < 0 && !mesh.faces[static_cast<std::size_t>(f)].is_coupling) {
            add(f);
        }
    }
}

/// What a field reaches from and to. K
struct Extent {
    double low;
    double high;
};

Extent extent_of(std::span<const double> T) {
    const auto take = [&](const Extent& all, std::size_t i) {
        return Extent{T[i] < all.low ? T[i] : all.low, T[i] > all.high ? T[i] : all.high};
    };
    const auto join = [](const Extent& a, const Extent& b) {
        return Extent{std::min(a.low, b.low), std::max(a.high, b.high)};
    };
    const auto of_range = [&](std::size_t begin, std::size_t end) {
        return fold_side_by_side(begin, end, Extent{T[begin], T[begin]}, take, join);
    };
    return joined_over_ranges(T.size(), of_range, join);
}

/// Faces inside one material whose law is one quadratic over the whole field: the bulk of the work of a section, without
/// a branch. The mean and its slopes are those of Curve::mean.
void add_quadratic_inside(const EvaluationState& m, std::size_t begin, std::size_t end, const Curve& k, Terms& terms) {
    const std::array<double, 3> c = k.coefficients();
    const double half = 0.5 * c[1];
    const double third = c[2] / 3.0;
    const int* const place = m.active.nodes.data();
    const double* const weight = m.active.weights.data();
    const double* const T = m.temperature.data();
    double* const G = terms.face_G.data();
    double* const of_a = terms.face_dq_dTa.data();
    double* const of_b = terms.face_dq_dTb.data();
    const auto add_constant = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = begin + first; i < begin + last; ++i) {
            G[place[3 * i]] += weight[i] * c[0];
        }
        return c[0];
    };
    const auto add_varying = [&](std::size_t first, std::size_t last) {
        double smallest = 0.0;
        for (std::size_t i = begin + first; i < begin + last; ++i) {
            const int f = place[3 * i];
            const double a = T[place[3 * i + 1]];
            const double b = T[place[3 * i + 2]];
            const double value = weight[i] * (c[0] + half * (a + b) + third * (a * a + a * b + b * b));
            const double drop = weight[i] * (b - a);
            G[f] += value;
            of_a[f] += (half + third * (2.0 * a + b)) * drop;
            of_b[f] += (half + third * (a + 2.0 * b)) * drop;
            smallest = value < smallest ? value : smallest;
        }
        return smallest;
    };
    const auto smaller = [](double a, double b) { return std::min(a, b); };
    const double smallest = k.is_constant() ? joined_over_ranges(end - begin, add_constant, smaller)
                                            : joined_over_ranges(end - begin, add_varying, smaller);
    terms.faces_used = true;
    terms.faces_vary = terms.faces_vary || half != 0.0 || third != 0.0;
    terms.nonlinear = terms.nonlinear || terms.faces_vary;
    for (std::size_t i = begin; smallest < 0.0 && i < end; ++i) {
        terms.note_negative_face(place[3 * i]);
    }
}

/// Faces inside one material, all with one law.
/// @param extent of the field, found where it is first asked for
void add_terms_inside(const EvaluationState& m, std::size_t begin, std::size_t end, std::optional<Extent>& extent,
                      Terms& terms) {
    const int* const node = m.active.nodes.data();
    const mesh::Face& first = m.mesh.faces[static_cast<std::size_t>(node[3 * begin])];
    const auto layer = static_cast<std::size_t>(m.mesh.layer[static_cast<std::size_t>(first.a)]);
    const Curve& k = m.material_model.materials[layer].along(first.axis);
    if (!k.is_quadratic() && !extent) {
        extent = extent_of(m.temperature);
    }
    if (k.is_quadratic() || k.is_quadratic_between(extent->low, extent->high)) {
        add_quadratic_inside(m, begin, end, k, terms);
        return;
    }
    const double* const T = m.temperature.data();
    for (std::size_t i = begin; i < end; ++i) {
        const double T_a = T[node[3 * i + 1]];
        const double T_b = T[node[3 * i + 2]];
        const double per_k = m.active.weights[i];
        const Curve::Mean mean = k.mean(T_a, T_b);
        terms.conduct(node[3 * i], per_k * mean.value, per_k * mean.slope_a, per_k * mean.slope_b, T_b - T_a);
    }
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const std::vector<int>& groups = m.active.groups;
    std::optional<Extent> extent;
    for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
        add_terms_inside(m, static_cast<std::size_t>(groups[g]), static_cast<std::size_t>(groups[g + 1]), extent,
                         terms);
    }
    for (auto i = static_cast<std::size_t>(groups.back()); i < m.active.weights.size(); ++i) {
        const int f = m.active.nodes[3 * i];
        const mesh::Face& face = m.mesh.faces[static_cast<std::size_t>(f)];
        const auto a = static_cast<std::size_t>(face.a);
        const auto b = static_cast<std::size_t>(face.b);
        Half on_a{};
        Half on_b{};
        if (face.half_a > 0.0) {
            on_a = half(m.material_model.materials[static_cast<std::size_t>(m.mesh.layer[a])].along(face.axis),
                        face.half_a, m.temperature[a]);
        }
        if (face.half_b > 0.0) {
            on_b = half(m.material_model.materials[static_cast<std::size_t>(m.mesh.layer[b])].along(face.axis),
                        face.half_b, m.temperature[b]);
        }
        Half between{};
        int region = 0;
        if (face.link >= 0) {
            const mesh::Link& link = m.mesh.links[static_cast<std::size_t>(face.link)];
            region = link.region;
            between = half(m.material_model.link_laws[static_cast<std::size_t>(face.link)], link.length,
                           m.region_mean[static_cast<std::size_t>(region)]);
        }
        const double G = face.area / (on_a.resistance + on_b.resistance + between.resistance);
        const double dG_dR = -G * G / face.area;
        terms.conduct(f, G, dG_dR * on_a.dR_dT, dG_dR * on_b.dR_dT);
        if (between.dR_dT != 0.0) {
            terms.add_conductance_derivative(f, region, dG_dR * between.dR_dT);
        }
    }
}

/// Of the materials' laws, and of links between lumps.
constexpr std::array plausible{
    PlausibleRange{"conductivity", 0.05, 1.5,
                   "rubber 0.21 (Clark, NASA 1983) to 0.56 W/(m K), butyl liner from 0.13 (recalled); identified by "
                   "the thesis 0.07 to 1.0 at 90 degC",
                   "no rubber compound conducts that way: the law stands in for another path of heat"},
    PlausibleRange{"heat_capacity", 1200.0, 2300.0,
                   "belts from 1200 (recalled), rubber 1500 to 2100 J/(kg K); thesis 1800, Clark (NASA 1983) 2092",
                   "no rubber compound stores that much or that little: the time constant has another cause, such as a "
                   "slow sensor"},
    PlausibleRange{
        "link_conductivity", 0.1, 2.5,
        "saturations of the thesis's drum tests with a link of 10 mm: 1.1 to 1.4 W/(m K); 0.29 at 20 degC stated",
        "a link of two lumps that is far off takes the place of a path of heat that does not pass the surface"},
};

}  // namespace

extern const Effect conduction;
const Effect conduction{
    .id = "conduction",
    .kind = EffectKind::property,
    .on = true,
    .equation = "q = -k(T) grad T inside the layers; (T_b - T_s) k(T_b)/dZ S_tot across a link",
    .source = "Fourier; thesis (31)(34)",
    .valid = "where k(T) and c(T) of the materials are known: give them a range",
    .meaning = "Heat conducted between cells. The laws k(T) and c(T) belong to the materials of the layers.",
    .plausible = plausible,
    .model =
        HeatEffect{
            .place = place,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
