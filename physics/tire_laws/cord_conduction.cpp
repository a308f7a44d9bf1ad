// SPDX-License-Identifier: BSD-3-Clause
// Cords and rubber side by side along the cords, Halpin and Tsai's rule across them, and the tensor's rotation.

#include "physics/tire_laws/cord_conduction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "mesh/grid.hpp"

namespace tiretherm::physics {

namespace {

/// Where a law that is no quadratic of temperature is kept: 2 K are fine enough for 1e-5 of a rubber's k(T).
constexpr double lowest = 150.0;
constexpr double highest = 900.0;
constexpr double step = 2.0;

/// offset + factor law
Curve affine(double offset, double factor, const Curve& law) {
    if (!law.is_table()) {
        return law.scaled(factor).plus_quadratic(0.0, offset, 0.0, 0.0);
    }
    std::vector<double> y(law.table_y().begin(), law.table_y().end());
    std::ranges::transform(y, y.begin(), [&](double value) { return offset + factor * value; });
    return Curve::table({law.table_x().begin(), law.table_x().end()}, std::move(y));
}

/// Temperatures at which to keep a function of a law: even steps, and the places where the law is bent.
std::vector<double> temperatures_of(const Curve& law) {
    std::vector<double> T(law.table_x().begin(), law.table_x().end());
    if (const auto range = law.range()) {
        T.insert(T.end(), range->begin(), range->end());
    }
    for (double even = lowest; even <= highest; even += step) {
        T.push_back(even);
    }
    std::ranges::sort(T);
    T.erase(std::unique(T.begin(), T.end()), T.end());
    return T;
}

/// A function of the rubber's conductivity as a law of temperature.
template <typename Function>
Curve of_rubber(const Curve& rubber, const Function& function) {
    if (rubber.is_constant()) {
        return Curve::constant(function(rubber.value(0.0)));
    }
    std::vector<double> T;
    std::vector<double> k;
    for (const double at : temperatures_of(rubber)) {
        if (const double k_rubber = rubber.value(at); k_rubber > 0.0) {
            T.push_back(at);
            k.push_back(function(k_rubber));
        }
    }
    // A law that is positive nowhere is the rubber's own mistake, and is reported there.
    return T.empty() ? rubber : Curve::table(std::move(T), std::move(k));
}

}  // namespace

double conductivity_along(const ConductingCords& cords, double k_rubber) {
    return cords.share * cords.conductivity_along + (1.0 - cords.share) * k_rubber;
}

double conductivity_across(const ConductingCords& cords, double k_rubber) {
    const double sum = cords.conductivity_across + k_rubber;
    const double excess = (cords.conductivity_across - k_rubber) * cords.share;
    return k_rubber * (sum + excess) / (sum - excess);
}

std::array<Curve, 3> ply_conductivity(const ConductingCords& cords, const Curve& rubber, double angle) {
    const double c2 = std::cos(angle) * std::cos(angle);
    const double s2 = std::sin(angle) * std::sin(angle);
    /// k_1 along_share + k_2 (1 - along_share); straight angles leave round-off in cos^2 and sin^2.
    const auto in_plane = [&](double along_share) {
        constexpr double round_off = 1e-12;
        if (along_share > 1.0 - round_off) {
            return affine(cords.share * cords.conductivity_along, 1.0 - cords.share, rubber);
        }
        return of_rubber(rubber, [&](double k_rubber) {
            return along_share * conductivity_along(cords, k_rubber) +
                   (1.0 - along_share) * conductivity_across(cords, k_rubber);
        });
    };
    std::array<Curve, 3> k;
    k[static_cast<std::size_t>(mesh::Axis::meridian)] = in_plane(s2);
    k[static_cast<std::size_t>(mesh::Axis::circumference)] = in_plane(c2);
    k[static_cast<std::size_t>(mesh::Axis::through)] =
        of_rubber(rubber, [&](double k_rubber) { return conductivity_across(cords, k_rubber); });
    return k;
}

double ply_density(double share, double cord, double rubber) { return share * cord + (1.0 - share) * rubber; }

Curve ply_heat_capacity(double share, const StoringPart& cords, const StoringPart& rubber) {
    assert(cords.heat_capacity.is_constant());
    const double rho = ply_density(share, cords.density, rubber.density);
    return affine(share * cords.density * cords.heat_capacity.value(0.0) / rho, (1.0 - share) * rubber.density / rho,
                  rubber.heat_capacity);
}

}  // namespace tiretherm::physics
