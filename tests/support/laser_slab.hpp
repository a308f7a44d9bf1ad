// SPDX-License-Identifier: BSD-3-Clause
// Exact temperature of a layered square slab under a flux on a disc: double cosine series times the modes of the
// layers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/support/disc_source.hpp"
#include "tests/support/layered_slab.hpp"

namespace tiretherm::support {

/// The linear problem "laser slab" of performance.md, section 1: a square slab 2 X wide of layers, insulated at its
/// sides, with Robin faces and a flux q on a disc of radius a at the middle of its top.
///
/// On the quarter [0, X] x [0, X] the disc's flux is the cosine series
///     sum over m, n of e_m e_n (q pi a^2/(4 X^2)) 2 J1(l a)/(l a) cos(m pi x/X) cos(n pi y/X),
///     l^2 = (m^2 + n^2) pi^2/X^2,  e_0 = 1, else 2,
/// and each mode is a LayeredSlab of wave number l under a flux at its top. At the disc's centre that sum converges
/// slowly, so the insulated half-space of the top layer's material is taken out of each mode, 1/(k l) erf(l sqrt(alpha
/// t)), and added again as a whole: the disc and its mirror images, at all even multiples of X, on a half-space. What
/// is left falls off as l^-3.5, by the film's h/(k l)^2 and by exp(-2 l d) of the top layer's depth d.
class LaserSlab {
public:
    LaserSlab(LayeredSlab depth, double half_width, double radius, double power)
        : depth_(std::move(depth)), X_(half_width), a_(radius), flux_(power / (std::numbers::pi * radius * radius)) {}

    struct Values {
        double top;     ///< K above the surroundings, at the centre of the top
        double bottom;  ///< K, at the centre of the bottom
        double stored;  ///< J in the quarter
    };

    [[nodiscard]] Values at(double t) const {
        const LayeredSlab::Layer& skin = depth_.layers.front();
        const double diffusivity = skin.conductivity / skin.capacity;
        const double reach = std::sqrt(diffusivity * t);
        const DiscSource disc{flux_, a_, skin.conductivity, diffusivity};
        Values sum{disc.at_centre(t), 0.0, 0.0};
        for (int i = 0; i <= 3; ++i) {
            for (int j = 0; j <= 3; ++j) {
                if (i + j > 0) {
                    const double images = (i > 0 ? 2.0 : 1.0) * (j > 0 ? 2.0 : 1.0);
                    sum.top += images * disc.far_away(2.0 * X_ * std::hypot(i, j), t);
                }
            }
        }
        for (int m = 0; m <= most; ++m) {
            for (int n = 0; n <= m; ++n) {
                LayeredSlab mode = depth_;
                mode.wave_number = std::hypot(m, n) * std::numbers::pi / X_;
                const double l = mode.wave_number;
                const double la = l * a_;
                const double shape = la > 0.0 ? 2.0 * std::cyl_bessel_j(1.0, la) / la : 1.0;
                const double copies = (m == n ? 1.0 : 2.0) * (m > 0 ? 2.0 : 1.0) * (n > 0 ? 2.0 : 1.0);
                const double share = copies * flux_ * std::numbers::pi * a_ * a_ / (4.0 * X_ * X_) * shape;
                LayeredSlab::Ends ends = mode.steady_heating();
                // The slowest any mode of this wave number dies is with the smallest diffusivity.
                if (slowest_diffusivity() * l * l * t < 40.0) {
                    const auto modes = mode.modes(t);
                    ends.top -= mode.heating_deficit(modes, 0.0, t);
                    ends.bottom -= mode.heating_deficit(modes, total_depth(), t);
                    if (m == 0) {
                        sum.stored = flux_ * std::numbers::pi * a_ * a_ / 4.0 * mean_store(mode, modes, t);
                    }
                }
                const double half_space = l > 0.0 ? std::erf(l * reach) / (skin.conductivity * l)
                                                  : 2.0 * reach * std::numbers::inv_sqrtpi / skin.conductivity;
                sum.top += share * (ends.top - half_space);
                sum.bottom += share * ends.bottom;
            }
        }
        return sum;
    }

private:
    static constexpr int most = 200;  ///< modes in each direction: l up to 2e4 / m, where l^-1.5 has fallen to 1e-4 K

    [[nodiscard]] double slowest_diffusivity() const {
        double least = 1e9;
        for (const LayeredSlab::Layer& layer : depth_.layers) {
            least = std::min(least, layer.conductivity / layer.capacity);
        }
        return least;
    }
    [[nodiscard]] double total_depth() const {
        double sum = 0.0;
        for (const LayeredSlab::Layer& layer : depth_.layers) {
            sum += layer.thickness;
        }
        return sum;
    }
    /// Heat stored under 1 W spread over the top: of each mode C Z integrated, times its amplitude.
    [[nodiscard]] static double mean_store(const LayeredSlab& slab, const std::vector<LayeredSlab::Mode>& modes,
                                           double t) {
        double sum = 0.0;
        for (const LayeredSlab::Mode& mode : modes) {
            sum += mode.moment / (mode.mu * mode.norm) * -std::expm1(-mode.mu * t);
        }
        // The modes that are dead already: together they lack from the steady store, which a unit flux reaches.
        double all = 0.0;
        for (const LayeredSlab::Mode& mode : modes) {
            all += mode.moment / (mode.mu * mode.norm);
        }
        return sum + steady_store(slab) - all;
    }
    /// Integral of C T of the steady profile under a unit flux, straight in every layer.
    [[nodiscard]] static double steady_store(const LayeredSlab& slab) {
        LayeredSlab plain = slab;
        double T = plain.steady_heating().top;
        const double down = 1.0 - slab.h_top * T;  // what passes through
        double sum = 0.0;
        for (const LayeredSlab::Layer& layer : slab.layers) {
            const double below = T - down * layer.thickness / layer.conductivity;
            sum += layer.capacity * layer.thickness * 0.5 * (T + below);
            T = below;
        }
        return sum;
    }

    LayeredSlab depth_;
    double X_;
    double a_;
    double flux_;
};

}  // namespace tiretherm::support
