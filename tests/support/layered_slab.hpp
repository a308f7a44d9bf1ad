// SPDX-License-Identifier: BSD-3-Clause
// Exact conduction through a stack of layers with Robin faces: Sturm-Liouville modes found by Pruefer's angle (Carslaw
// and Jaeger, 3.9 to 3.11; Ozisik, composite media).
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace tiretherm::support {

/// Exact conduction through a stack of layers between two faces that exchange heat:
///
///     C dT/dt = d/dz(k dT/dz) - k l^2 T,    k T' = h_top T at z = 0,    -k T' = h_bottom T at z = D,
///
/// T the excess over the surroundings and C = rho c. The wave number l (0: a plain slab) stands for a field that varies
/// as cos(l x) along the layers. Separation, T = Z(z) exp(-mu t), leaves the Sturm-Liouville problem
/// (k Z')' + (mu C - k l^2) Z = 0, whose eigenfunctions are orthogonal with the weight C: Carslaw and Jaeger,
/// Conduction of Heat in Solids (2nd ed. 1959), sections 3.9 to 3.11 for one layer; Ozisik, Heat Conduction, chapter on
/// composite media, for several.
///
/// The eigenvalues are found by the angle of Pruefer: with T = r sin(theta), k T' = r cos(theta) the angle passes every
/// multiple of pi upwards and grows with mu, so that the j-th eigenvalue is the one root of
/// theta(D; mu) = atan2(1, -h_bottom) + j pi: none can be missed, and bisection is safe.
struct LayeredSlab {
    struct Layer {
        double thickness;     ///< m
        double conductivity;  ///< W/(m K)
        double capacity;      ///< J/(m3 K)
    };
    std::vector<Layer> layers;
    double h_top = 0.0;        ///< W/(m2 K)
    double h_bottom = 0.0;     ///< W/(m2 K)
    double wave_number = 0.0;  ///< 1/m

    /// An eigenfunction with Z(0) = 1, by its value and flux k Z' where each layer begins.
    struct Mode {
        double mu = 0.0;  ///< 1/s
        std::vector<double> value;
        std::vector<double> flux;
        double norm = 0.0;      ///< integral of C Z^2
        double moment = 0.0;    ///< integral of C Z
        double integral = 0.0;  ///< integral of Z
    };

    /// mu C / k - l^2: the square of the wave number through a layer, negative where the mode does not oscillate.
    [[nodiscard]] double square(const Layer& layer, double mu) const {
        return mu * layer.capacity / layer.conductivity - wave_number * wave_number;
    }

    /// Value and flux a depth z below the top of a layer.
    struct State {
        double value;
        double flux;
    };
    [[nodiscard]] State carry(const Layer& layer, double mu, State top, double z) const {
        const double s = square(layer, mu);
        const double w = std::sqrt(std::abs(s));
        const double k = layer.conductivity;
        if (w * z < 1e-9) {
            return {top.value + top.flux / k * z, top.flux};
        }
        const double b = top.flux / (k * w);
        if (s > 0.0) {
            return {top.value * std::cos(w * z) + b * std::sin(w * z),
                    k * w * (b * std::cos(w * z) - top.value * std::sin(w * z))};
        }
        return {top.value * std::cosh(w * z) + b * std::sinh(w * z),
                k * w * (b * std::cosh(w * z) + top.value * std::sinh(w * z))};
    }

    /// Pruefer's angle at the bottom.
    [[nodiscard]] double angle(double mu) const {
        constexpr double pi = std::numbers::pi;
        double half_turns = 0.0;
        double rest = std::atan2(1.0, h_top);  // in [0, pi)
        for (const Layer& layer : layers) {
            const double s = square(layer, mu);
            const double w = std::sqrt(std::abs(s));
            const double admittance = layer.conductivity * w;
            if (s > 0.0 && w * layer.thickness > 1e-9) {
                // In the scaled variables (k w T, k T') the solution turns uniformly.
                const double scaled = std::atan2(admittance * std::sin(rest), std::cos(rest)) + w * layer.thickness;
                const double turns = std::floor(scaled / pi);
                half_turns += turns;
                rest = scaled - turns * pi;
                rest = std::atan2(std::sin(rest) / admittance, std::cos(rest));
                continue;
            }
            // Otherwise it crosses zero once at most. Divided by cosh(w d) > 0, against overflow.
            const double t = std::tanh(w * layer.thickness);
            const double over = w * layer.thickness > 1e-9 ? t / admittance : layer.thickness / layer.conductivity;
            const double value = std::sin(rest) + std::cos(rest) * over;
            const double flux = std::cos(rest) + std::sin(rest) * admittance * t;
            half_turns += value < 0.0 ? 1.0 : 0.0;
            rest = value < 0.0 ? std::atan2(-value, -flux) : std::atan2(value, flux);
        }
        return half_turns * pi + rest;
    }

    /// The j-th eigenvalue, j = 0, 1, 2 ... @returns 1/s
    [[nodiscard]] double eigenvalue(int j) const {
        const double wanted = std::atan2(1.0, -h_bottom) + j * std::numbers::pi;
        double low = 0.0;
        double high = 1e-6;
        while (angle(high) < wanted) {
            low = high;
            high *= 2.0;
        }
        for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
            const double middle = 0.5 * (low + high);
            (angle(middle) < wanted ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    [[nodiscard]] Mode mode(int j) const {
        Mode m;
        m.mu = eigenvalue(j);
        State state{1.0, h_top};
        for (const Layer& layer : layers) {
            m.value.push_back(state.value);
            m.flux.push_back(state.flux);
            const double s = square(layer, m.mu);
            const double w = std::sqrt(std::abs(s));
            const double d = layer.thickness;
            const double a = state.value;
            double square_integral = a * a * d;
            double integral = a * d;
            if (w * d > 1e-9) {
                const double b = state.flux / (layer.conductivity * w);
                const double sine = s > 0.0 ? std::sin(w * d) : std::sinh(w * d);
                const double cosine = s > 0.0 ? std::cos(w * d) : std::cosh(w * d);
                const double sign = s > 0.0 ? 1.0 : -1.0;
                // Z = a cos + b sin, or a cosh + b sinh
                square_integral = 0.5 * (a * a + sign * b * b) * d + 0.5 * (a * a - sign * b * b) * sine * cosine / w +
                                  a * b * sine * sine / w;
                integral = a * sine / w + sign * b * (1.0 - cosine) / w;
            }
            m.norm += layer.capacity * square_integral;
            m.moment += layer.capacity * integral;
            m.integral += integral;
            state = carry(layer, m.mu, state, d);
        }
        return m;
    }

    /// All modes that are not yet dead at time t, exp(-mu t) > exp(-40), and at least `least`.
    [[nodiscard]] std::vector<Mode> modes(double t, int least = 1) const {
        std::vector<Mode> result;
        do {
            result.push_back(mode(static_cast<int>(result.size())));
        } while (result.back().mu * t < 40.0 || static_cast<int>(result.size()) < least);
        return result;
    }

    [[nodiscard]] double value(const Mode& m, double z) const {
        std::size_t i = 0;
        double top = 0.0;
        while (i + 1 < layers.size() && z > top + layers[i].thickness) {
            top += layers[i].thickness;
            ++i;
        }
        return carry(layers[i], m.mu, {m.value[i], m.flux[i]}, z - top).value;
    }

    /// Excess at depth z of a slab that starts at an excess of 1 everywhere.
    /// The initial state projects on mode j with the coefficient (integral of C Z) / (integral of C Z^2).
    [[nodiscard]] double cooling(const std::vector<Mode>& all, double z, double t) const {
        double sum = 0.0;
        for (const Mode& m : all) {
            sum += m.moment / m.norm * value(m, z) * std::exp(-m.mu * t);
        }
        return sum;
    }

    /// Heat per area stored in that slab. @returns J/(m2 K)
    [[nodiscard]] double cooling_store(const std::vector<Mode>& all, double t) const {
        double sum = 0.0;
        for (const Mode& m : all) {
            sum += m.moment * m.moment / m.norm * std::exp(-m.mu * t);
        }
        return sum;
    }

    /// What a flux of 1 W/m2 absorbed at the top has left to do at time t, from rest at zero:
    /// dA_j/dt = -mu_j A_j + Z_j(0) / norm_j, so that the deficit of A_j is exp(-mu_j t) / (mu_j norm_j).
    [[nodiscard]] double heating_deficit(const std::vector<Mode>& all, double z, double t) const {
        double sum = 0.0;
        for (const Mode& m : all) {
            sum += value(m, z) / (m.mu * m.norm) * std::exp(-m.mu * t);
        }
        return sum;
    }

    /// Steady excess at the top and at the bottom under 1 W/m2 absorbed at the top, by carrying the admittance
    /// Y = -k T'/T upwards from Y = h_bottom. @returns K m2/W
    struct Ends {
        double top;
        double bottom;
    };
    [[nodiscard]] Ends steady_heating() const {
        double Y = h_bottom;
        double share = 1.0;  // bottom's excess over the excess at the top of the layers passed
        for (std::size_t i = layers.size(); i-- > 0;) {
            const double kl = layers[i].conductivity * wave_number;
            const double ld = wave_number * layers[i].thickness;
            if (ld < 1e-9) {
                const double resistance = layers[i].thickness / layers[i].conductivity;
                share /= 1.0 + Y * resistance;
                Y = Y / (1.0 + Y * resistance);
                continue;
            }
            share /= std::cosh(ld) + Y / kl * std::sinh(ld);
            Y = kl * (Y + kl * std::tanh(ld)) / (kl + Y * std::tanh(ld));
        }
        const double top = 1.0 / (h_top + Y);
        return {top, share * top};
    }
};

}  // namespace tiretherm::support
