// SPDX-License-Identifier: BSD-3-Clause
// Nodes along meridian and depth, element matrices, surface weights and load vectors of the section.

#include "section/section_shape_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "numerics/quadratic_truth.hpp"

namespace hidden_effects {

namespace {

using quadratic::gauss_place;
using quadratic::gauss_weight;
using quadratic::shapes;
using quadratic::slopes;

using std::numbers::pi;
constexpr double density = 1100.0;
constexpr double heat_capacity = 1800.0;
constexpr std::array<double, 2> conductivity{0.40, 0.30};  ///< tread, carcass
constexpr double sidewall_share = 0.5;
constexpr double sidewall_film = 30.0;  ///< W/m2K

/// 1 at the middle of the outside shoulder and beyond, -1 inside.
double towards_outside(double s) { return std::clamp(-s / shoulder_middle, -1.0, 1.0); }

void scale_to_one(std::vector<double>& load) {
    const double sum = std::accumulate(load.begin(), load.end(), 0.0);
    for (double& value : load) {
        value /= sum > 0.0 ? sum : 1.0;
    }
}

}  // namespace

double SectionShape::radius(double s) const { return strip_ == Strip::section ? section_radius(s) : centre_radius; }

SectionShape::SectionShape(const SectionCauses& causes, int refinement, Strip strip)
    : capacity(0, 0),
      conduction(0, 0),
      strip_(strip),
      s_{strip == Strip::section ? -section_reach() : -tread_edge},
      z_{0.0} {
    const int n = refinement;
    if (strip == Strip::layers) {
        quadratic::append_elements(s_, tread_edge, 1, 1.0);
    } else {
        append_meridian(n);
    }
    quadratic::append_elements(z_, tread_depth, 4 * n, 6.0);
    quadratic::append_elements(z_, section_depth, 2 * n, 1.0);
    capacity = BandMatrix(n_nodes(), reach());
    conduction = BandMatrix(n_nodes(), reach());
    for (std::vector<double>* load :
         {&loss, &loss_skew, &carcass, &crown, &surface, &crown_surface, &inside_shoulder, &liner, &sidewalls}) {
        load->assign(n_nodes(), 0.0);
    }
    find_areas();
    for (std::size_t i = 0; i + 2 < s_.size(); i += 2) {
        for (std::size_t j = 0; j + 2 < z_.size(); j += 2) {
            add_element(causes, i, j);
        }
        add_faces(causes, i);
    }
    capacity.at(gas(), gas()) = 70.0;
    const double total = std::accumulate(loss.begin(), loss.end(), 0.0);
    for (double& value : loss_skew) {
        value /= total;
    }
    for (std::vector<double>* load : {&loss, &carcass, &crown, &surface, &crown_surface, &inside_shoulder, &liner}) {
        scale_to_one(*load);
    }
}

void SectionShape::append_meridian(int n) {
    // Finer towards the edges of the tread, where the surroundings change.
    quadratic::append_elements(s_, -tread_edge, 6 * n, 0.05);
    quadratic::append_elements(s_, -shoulder_middle, 4 * n, 6.0);
    quadratic::append_elements(s_, -crown_edge, 3 * n, 1.0);
    quadratic::append_elements(s_, 0.0, 3 * n, 3.0);
    quadratic::append_elements(s_, crown_edge, 3 * n, 1.0 / 3.0);
    quadratic::append_elements(s_, shoulder_middle, 3 * n, 1.0);
    quadratic::append_elements(s_, tread_edge, 4 * n, 1.0 / 6.0);
    quadratic::append_elements(s_, section_reach(), 6 * n, 20.0);
}

void SectionShape::find_areas() {
    for (std::size_t i = 0; i + 2 < s_.size(); i += 2) {
        for (std::size_t p = 0; p < 3; ++p) {
            const double half = 0.5 * (s_[i + 2] - s_[i]);
            const double ring = 2.0 * pi * radius(s_[i + 1] + half * gauss_place[p]) * half * gauss_weight[p];
            liner_area_ += ring;
            (std::abs(s_[i + 1]) < tread_edge ? tread_area : sidewall_area_) += ring;
        }
    }
}

void SectionShape::add_element(const SectionCauses& causes, std::size_t i, std::size_t j) {
    const double half_s = 0.5 * (s_[i + 2] - s_[i]);
    const double half_z = 0.5 * (z_[j + 2] - z_[j]);
    const std::size_t layer = z_[j + 1] < tread_depth ? 0 : 1;
    const bool below_tread = std::abs(s_[i + 1]) < tread_edge;
    const bool in_crown = std::abs(s_[i + 1]) < crown_edge;
    const double C = density * heat_capacity * causes.capacity.at(layer);
    const double k = conductivity.at(layer) * causes.conductivity.at(layer);
    for (std::size_t p = 0; p < 9; ++p) {
        const double x = gauss_place[p / 3];
        const double y = gauss_place[p % 3];
        const double s = s_[i + 1] + half_s * x;
        const double volume = gauss_weight[p / 3] * gauss_weight[p % 3] * half_s * half_z * 2.0 * pi * radius(s);
        const double lossy = volume * (below_tread ? 1.0 : sidewall_share);
        for (std::size_t a = 0; a < 9; ++a) {
            const std::size_t row = node(i + a / 3, j + a % 3);
            const double shape_a = shapes(x)[a / 3] * shapes(y)[a % 3];
            const double along_a = slopes(x)[a / 3] * shapes(y)[a % 3] / half_s;
            const double through_a = shapes(x)[a / 3] * slopes(y)[a % 3] / half_z;
            loss[row] += lossy * shape_a;
            loss_skew[row] += lossy * shape_a * towards_outside(s);
            carcass[row] += layer == 1 && below_tread ? volume * shape_a : 0.0;
            crown[row] += in_crown ? volume * shape_a : 0.0;
            for (std::size_t b = 0; b < 9; ++b) {
                const std::size_t column = node(i + b / 3, j + b % 3);
                const double along_b = slopes(x)[b / 3] * shapes(y)[b % 3] / half_s;
                const double through_b = shapes(x)[b / 3] * slopes(y)[b % 3] / half_z;
                capacity.at(row, column) += C * volume * shape_a * shapes(x)[b / 3] * shapes(y)[b % 3];
                conduction.at(row, column) += k * volume * (along_a * along_b + through_a * through_b);
            }
        }
    }
}

void SectionShape::add_faces(const SectionCauses& causes, std::size_t i) {
    const double half = 0.5 * (s_[i + 2] - s_[i]);
    const double middle = s_[i + 1];
    const bool is_tread = std::abs(middle) < tread_edge;
    // The cause of both sidewalls together, and the unknown one of the inside sidewall, half of their area; a strip without
    // sidewalls loses to the air from its inner face.
    const double inside = middle > 0.0 ? 2.0 * causes.inside_sidewall : 0.0;
    const double outer_film = is_tread ? 0.0 : sidewall_film + (causes.sidewall + inside) / sidewall_area_;
    const double inner_film = strip_ == Strip::layers ? causes.sidewall / liner_area_ : 0.0;
    for (std::size_t p = 0; p < 3; ++p) {
        const double s = middle + half * gauss_place[p];
        const double area = 2.0 * pi * radius(s) * half * gauss_weight[p];
        const std::array<double, 3> shape = shapes(gauss_place[p]);
        SurfacePoint point{.shape = shape, .area = area};
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t outer = node(i + a, 0);
            const std::size_t inner = node(i + a, z_.size() - 1);
            point.node[a] = outer;
            liner[inner] += area * shape[a];
            surface[outer] += is_tread ? area * shape[a] : 0.0;
            crown_surface[outer] += std::abs(middle) < crown_edge ? area * shape[a] : 0.0;
            inside_shoulder[outer] += is_tread && middle > crown_edge ? area * shape[a] : 0.0;
            sidewalls[outer] += outer_film * area * shape[a];
            sidewalls[inner] += inner_film * area * shape[a];
            for (std::size_t b = 0; b < 3; ++b) {
                conduction.at(inner, node(i + b, z_.size() - 1)) +=
                    (causes.liner / liner_area_ + inner_film) * area * shape[a] * shape[b];
                conduction.at(outer, node(i + b, 0)) += outer_film * area * shape[a] * shape[b];
            }
        }
        if (is_tread) {
            tread.push_back(point);
        }
    }
}

std::vector<double> SectionShape::at(double s, double z) const {
    std::vector<double> weights(n_nodes(), 0.0);
    const auto element = [](const std::vector<double>& nodes, double place) {
        std::size_t i = 0;
        while (i + 4 < nodes.size() && place > nodes[i + 2]) {
            i += 2;
        }
        return i;
    };
    const std::size_t i = element(s_, s);
    const std::size_t j = element(z_, z);
    const std::array<double, 3> along = shapes((s - s_[i + 1]) / (0.5 * (s_[i + 2] - s_[i])));
    const std::array<double, 3> through = shapes((z - z_[j + 1]) / (0.5 * (z_[j + 2] - z_[j])));
    for (std::size_t a = 0; a < 9; ++a) {
        weights[node(i + a / 3, j + a % 3)] += along[a / 3] * through[a % 3];
    }
    return weights;
}

}  // namespace hidden_effects
