// SPDX-License-Identifier: BSD-3-Clause
// Assembles capacity, heat flow and exact Jacobian by Gauss quadrature, with convection and radiation on the faces.

#include "laser/laser_elements_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/quadratic_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

using quadratic::append_elements;
using quadratic::gauss_place;
using quadratic::gauss_weight;
using quadratic::shapes;
using quadratic::slopes;

constexpr double stefan_boltzmann = 5.670374419e-8;

/// What leaves a face for the air, W/m2, and its derivative, W/m2K.
struct Loss {
    double flux = 0.0;
    double by_T = 0.0;
};

Loss loss_of(double T, double air, double h, double emissivity, double natural) {
    const double above = T - air;
    // 1.32 (dT/0.66 m)^0.25: simplified laminar relation of a tire's size.
    const double buoyant = natural * 1.32 * std::pow(std::abs(above) / 0.66, 0.25);
    const double grey = emissivity * stefan_boltzmann;
    return {.flux = (h + buoyant) * above + grey * (std::pow(T + celsius, 4) - std::pow(air + celsius, 4)),
            .by_T = h + 1.25 * buoyant + 4.0 * grey * std::pow(T + celsius, 3)};
}

}  // namespace

LaserElements::LaserElements(const LaserSpecimen& specimen, int refinement) : specimen_(specimen), r_{0.0}, z_{0.0} {
    append_elements(r_, specimen.spot, 6 * refinement, 0.35);
    append_elements(r_, specimen.radius, 9 * refinement, 80.0);
    append_elements(z_, specimen.outer_depth, 8 * refinement, 12.0);
    append_elements(z_, specimen.depth, 3 * refinement, 1.0);
    for (std::size_t layer = 0; layer < 2; ++layer) {
        const Conductivity& k = layer == 0 ? specimen.K1 : specimen.K2;
        law_[layer] = {k[1], (k[2] - k[0]) / 100.0, (k[2] - 2.0 * k[1] + k[0]) / 5000.0};
    }
    for (std::size_t i = 0; i + 2 < r_.size(); i += 2) {
        for (std::size_t j = 0; j + 2 < z_.size(); j += 2) {
            add_element(i, j);
        }
        add_face(i, true);
        add_face(i, false);
    }
}

void LaserElements::add_element(std::size_t i, std::size_t j) {
    Element element;
    const double half_r = 0.5 * (r_[i + 2] - r_[i]);
    const double half_z = 0.5 * (z_[j + 2] - z_[j]);
    element.outer = z_[j + 1] < specimen_.outer_depth;
    for (std::size_t a = 0; a < 9; ++a) {
        element.node[a] = node(i + a / 3, j + a % 3);
    }
    for (std::size_t p = 0; p < n_points; ++p) {
        Point& point = element.point[p];
        const double x = gauss_place[p / 3];
        const double y = gauss_place[p % 3];
        point.weight = gauss_weight[p / 3] * gauss_weight[p % 3] * half_r * half_z * (r_[i + 1] + half_r * x);
        for (std::size_t a = 0; a < 9; ++a) {
            point.shape[a] = shapes(x)[a / 3] * shapes(y)[a % 3];
            point.by_r[a] = slopes(x)[a / 3] * shapes(y)[a % 3] / half_r;
            point.by_z[a] = shapes(x)[a / 3] * slopes(y)[a % 3] / half_z;
        }
    }
    elements_.push_back(element);
}

void LaserElements::add_face(std::size_t i, bool outer_face) {
    const double half = 0.5 * (r_[i + 2] - r_[i]);
    const bool lit = outer_face && r_[i + 1] < specimen_.spot;
    const double area = std::numbers::pi * specimen_.spot * specimen_.spot;
    for (std::size_t p = 0; p < 3; ++p) {
        FacePoint point;
        for (std::size_t a = 0; a < 3; ++a) {
            point.node[a] = node(i + a, outer_face ? 0 : z_.size() - 1);
        }
        point.shape = shapes(gauss_place[p]);
        point.weight = gauss_weight[p] * half * (r_[i + 1] + half * gauss_place[p]);
        point.h = outer_face ? specimen_.h_top : specimen_.h_bottom;
        point.emissivity = outer_face ? specimen_.emissivity : 0.0;
        point.natural = outer_face ? specimen_.natural_convection : 0.0;
        point.light = lit ? specimen_.absorptivity * specimen_.power / area : 0.0;
        faces_.push_back(point);
    }
}

BandMatrix LaserElements::capacity() const {
    BandMatrix M(n_nodes(), reach());
    for (const Element& element : elements_) {
        for (const Point& point : element.point) {
            const double C =
                specimen_.density * specimen_.heat_capacity * point.weight *
                (element.outer ? specimen_.outer_heat_capacity_scale : specimen_.inner_heat_capacity_scale);
            for (std::size_t a = 0; a < 9; ++a) {
                for (std::size_t b = 0; b < 9; ++b) {
                    M.at(element.node[a], element.node[b]) += C * point.shape[a] * point.shape[b];
                }
            }
        }
    }
    return M;
}

void LaserElements::heat(std::span<const double> temperature, std::span<double> f, BandMatrix* slope) const {
    std::fill(f.begin(), f.end(), 0.0);
    for (const Element& element : elements_) {
        const std::array<double, 3>& law = law_[element.outer ? 0 : 1];
        std::array<double, 9> T;
        for (std::size_t a = 0; a < 9; ++a) {
            T[a] = temperature[element.node[a]];
        }
        for (const Point& point : element.point) {
            double above = -90.0;
            double T_r = 0.0;
            double T_z = 0.0;
            for (std::size_t a = 0; a < 9; ++a) {
                above += point.shape[a] * T[a];
                T_r += point.by_r[a] * T[a];
                T_z += point.by_z[a] * T[a];
            }
            const double k = point.weight * (law[0] + above * (law[1] + above * law[2]));
            const double k_by_T = point.weight * (law[1] + 2.0 * above * law[2]);
            for (std::size_t a = 0; a < 9; ++a) {
                const double along = point.by_r[a] * T_r + point.by_z[a] * T_z;
                f[element.node[a]] -= k * along;
                for (std::size_t b = 0; slope != nullptr && b < 9; ++b) {
                    slope->at(element.node[a], element.node[b]) -=
                        k * (point.by_r[a] * point.by_r[b] + point.by_z[a] * point.by_z[b]) +
                        k_by_T * point.shape[b] * along;
                }
            }
        }
    }
    for (const FacePoint& point : faces_) {
        double T = 0.0;
        for (std::size_t a = 0; a < 3; ++a) {
            T += point.shape[a] * temperature[point.node[a]];
        }
        const Loss loss = loss_of(T, specimen_.air, point.h, point.emissivity, point.natural);
        for (std::size_t a = 0; a < 3; ++a) {
            f[point.node[a]] += point.weight * point.shape[a] * (point.light - loss.flux);
            for (std::size_t b = 0; slope != nullptr && b < 3; ++b) {
                slope->at(point.node[a], point.node[b]) -= point.weight * loss.by_T * point.shape[a] * point.shape[b];
            }
        }
    }
}

std::vector<double> LaserElements::mean_over(bool outer_face, double from, double to) const {
    std::vector<double> weights(n_nodes(), 0.0);
    for (std::size_t i = 0; i + 2 < r_.size(); i += 2) {
        const double left = std::max(r_[i], from);
        const double right = std::min(r_[i + 2], to);
        for (std::size_t p = 0; p < 3 && left < right; ++p) {
            const double r = 0.5 * (left + right) + 0.5 * (right - left) * gauss_place[p];
            const double weight = gauss_weight[p] * 0.5 * (right - left) * r * 2.0 / (to * to - from * from);
            const std::array<double, 3> shape = shapes((r - r_[i + 1]) / (0.5 * (r_[i + 2] - r_[i])));
            for (std::size_t a = 0; a < 3; ++a) {
                weights[node(i + a, outer_face ? 0 : z_.size() - 1)] += weight * shape[a];
            }
        }
    }
    return weights;
}

}  // namespace hidden_effects
