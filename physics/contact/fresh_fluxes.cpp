// SPDX-License-Identifier: BSD-3-Clause
// Collocation in y = sqrt(t/t_c) with Abel integrals in closed form, and a table of it by octaves of H.

#include "physics/contact/fresh_fluxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/LU>

namespace tiretherm::physics {

namespace {

/// Of the contact, evenly spaced in the square root of time, in which the flux is smooth.
constexpr int n_pieces = 24;
using Vector = Eigen::Matrix<double, n_pieces + 1, 1>;
using Square = Eigen::Matrix<double, n_pieces + 1, n_pieces + 1>;

/// Fluxes or drives at the nodes.
using AtNodes = std::array<Drives, n_pieces + 1>;

double node(int j) { return static_cast<double>(j) / n_pieces; }

/// int of 2 y / sqrt(x^2 - y^2) and of 2 y^2 / sqrt(x^2 - y^2) up to y.
struct Abel {
    double zeroth = 0.0;
    double first = 0.0;
};
Abel abel_up_to(double y, double x) {
    const double root = std::sqrt(std::max(0.0, x * x - y * y));
    return {.zeroth = -2.0 * root, .first = x * x * std::asin(std::min(1.0, y / x)) - y * root};
}

/// What a flux that is straight in y = sqrt(t/t_c) between its nodes amounts to, whatever the contact.
struct Weights {
    /// Row i: int_0^t q(s) / sqrt(pi (t-s)) ds at t = t_c node(i)^2, over sqrt(t_c / pi).
    Square abel = Square::Zero();
    /// int_0^t_c q ds, over t_c: of hat functions in 2 y dy.
    Vector mean = Vector::Zero();
    /// What drives a flux, at t = t_c node(i)^2.
    AtNodes drives;
    /// Column j: the moments of a hat function, int of it times each power of u.
    Eigen::Matrix<double, n_moments, n_pieces + 1> moments;
    Moments of_even;  ///< the moments of an even flux

    Weights() {
        constexpr double width = 1.0 / n_pieces;
        for (int j = 0; j < n_pieces; ++j) {
            mean[j] += width * (node(j) + width / 3.0);
            mean[j + 1] += width * (node(j) + 2.0 * width / 3.0);
            for (int i = j + 1; i <= n_pieces; ++i) {
                const Abel from = abel_up_to(node(j), node(i));
                const Abel to = abel_up_to(node(j + 1), node(i));
                const double zeroth = to.zeroth - from.zeroth;
                const double first = to.first - from.first;
                abel(i, j) += (node(j + 1) * zeroth - first) * n_pieces;
                abel(i, j + 1) += (first - node(j) * zeroth) * n_pieces;
            }
        }
        for (int i = 0; i <= n_pieces; ++i) {
            double power = 1.0;
            Drives& here = drives[static_cast<std::size_t>(i)];
            for (int k = 0; k < n_moments; ++k) {
                here[k] = power;
                moments(k, i) = power * mean[i];
                power *= node(i) * node(i) - 0.5;
            }
            here[n_moments] = abel.row(i).sum();
        }
        of_even = moments.rowwise().sum();
    }
};

const Weights& weights() {
    static const Weights made;
    return made;
}

struct Solved {
    FreshFluxes fluxes;
    AtNodes abel;  ///< A f at the nodes
};

/// Solves f + H A f = drive, which is triangular: nothing comes from later in the contact.
Solved solve(double H, const AtNodes& drive) {
    const Weights& of = weights();
    Solved solved;
    AtNodes flux;
    for (int i = 0; i <= n_pieces; ++i) {
        const auto at = static_cast<std::size_t>(i);
        Drives earlier = Drives::Zero();
        for (int j = 0; j < i; ++j) {
            earlier += of.abel(i, j) * flux[static_cast<std::size_t>(j)];
        }
        flux[at] = (drive[at] - H * earlier) / (1.0 + H * of.abel(i, i));
        solved.fluxes.moments += of.moments.col(i) * flux[at].transpose();
        solved.abel[at] = earlier + of.abel(i, i) * flux[at];
    }
    solved.fluxes.abel_at_exit = solved.abel.back();
    return solved;
}

/// The fluxes in an octave of H as polynomials in x = 2 log2(H) + const from -1 to 1: they have the equation's values at both
/// ends and at places between, and its slopes at both ends, so that the slope is the same on both sides of an end.
class Octaves {
public:
    static constexpr int first = -8;  // 2^-8: from there on
    static constexpr int beyond = 12;

    Octaves() {
        // Chebyshev's extrema of six, the fewest with errors of 1e-9.
        constexpr int n_values = n_terms - 2;
        Eigen::Matrix<double, n_terms, n_terms> conditions;
        std::array<double, n_values> place{};
        for (int i = 0; i < n_values; ++i) {
            const double x = -std::cos(i * std::numbers::pi / (n_values - 1));
            place[static_cast<std::size_t>(i)] = x;
            for (int k = 0; k < n_terms; ++k) {
                conditions(i, k) = std::pow(x, k);
            }
        }
        for (int k = 0; k < n_terms; ++k) {  // slopes at -1 and 1
            conditions(n_values, k) = k % 2 == 0 ? -k : k;
            conditions(n_values + 1, k) = k;
        }
        const Eigen::Matrix<double, n_terms, n_terms> from_values = conditions.inverse();
        for (int octave = first; octave < beyond; ++octave) {
            std::array<FreshFluxes, n_terms>& terms = octaves_[static_cast<std::size_t>(octave - first)];
            const auto add = [&](int condition, double factor, const FreshFluxes& value) {
                for (int k = 0; k < n_terms; ++k) {
                    FreshFluxes& term = terms[static_cast<std::size_t>(k)];
                    term.moments += factor * from_values(k, condition) * value.moments;
                    term.abel_at_exit += factor * from_values(k, condition) * value.abel_at_exit;
                }
            };
            for (int i = 0; i < n_values; ++i) {
                add(i, 1.0,
                    FreshFluxes::by_collocation(std::exp2(octave + 0.5 * (1.0 + place[static_cast<std::size_t>(i)]))));
            }
            constexpr double dlnH_dx = 0.5 * std::numbers::ln2;
            add(n_values, dlnH_dx, FreshFluxes::slope_by_collocation(std::exp2(octave)));
            add(n_values + 1, dlnH_dx, FreshFluxes::slope_by_collocation(std::exp2(octave + 1)));
        }
    }

    /// @param exponent log2(H), at least `first` and less than `beyond`
    [[nodiscard]] FreshFluxes at(double exponent) const {
        const double octave = std::floor(exponent);
        const double x = 2.0 * (exponent - octave) - 1.0;
        const auto& terms = octaves_[static_cast<std::size_t>(octave - first)];
        FreshFluxes sum = terms.back();
        for (std::size_t k = n_terms - 1; k-- > 0;) {
            sum.moments = sum.moments * x + terms[k].moments;
            sum.abel_at_exit = sum.abel_at_exit * x + terms[k].abel_at_exit;
        }
        return sum;
    }

private:
    static constexpr int n_terms = 8;
    std::array<std::array<FreshFluxes, n_terms>, beyond - first> octaves_;
};

}  // namespace

FreshFluxes FreshFluxes::by_collocation(double H) { return solve(H, weights().drives).fluxes; }

FreshFluxes FreshFluxes::slope_by_collocation(double H) {
    AtNodes drive = solve(H, weights().drives).abel;  // H f' + H A (H f') = -H A f
    for (Drives& at_node : drive) {
        at_node *= -H;
    }
    return solve(H, drive).fluxes;
}

FreshFluxes FreshFluxes::at(double H) {
    static const Octaves octaves;
    const double exponent = std::log2(H);
    return exponent >= Octaves::first && exponent < Octaves::beyond ? octaves.at(exponent) : by_collocation(H);
}

const Drives& drives_at_entry() { return weights().drives.front(); }
const Drives& drives_at_exit() { return weights().drives.back(); }
const Moments& moments_of_even_flux() { return weights().of_even; }

}  // namespace tiretherm::physics
