// SPDX-License-Identifier: BSD-3-Clause
// The film of a rotating disk as a choice of the effects that cool parts of a wheel: h = scale max(h_natural, h_disk),
// with h_natural = natural (|T - T_air|/D)^0.25 of a vertical plate (McAdams 1954).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "physics/effect.hpp"

namespace tiretherm::physics::disk_film {

inline constexpr std::string_view key = "film";
inline constexpr std::array<std::string_view, 2> films{"constant", "rotating_disk"};
/// Inputs that the rotating disk needs beside the air's temperature.
inline constexpr std::array<std::string_view, 2> reads{"speed", "vertical_load"};

/// The parameters of an effect that has this choice end with these, in this order.
inline constexpr ParameterSpec scale{
    "disk_scale",
    "1",
    1.0,
    0.0,
    10.0,
    "rotating_disk: factor on the whole film; 0.5 behind a closed wheel house to 2 in the travel wind, assumed"};
inline constexpr ParameterSpec laminar{"laminar", "1",  0.36,
                                       0.0,       10.0, "rotating_disk: Nu_r / Re_r^0.5; 0.33 in theory to 0.38"};
inline constexpr ParameterSpec turbulent{"turbulent", "1", 0.0195,
                                         0.0,         1.0, "rotating_disk: Nu_r / Re_r^0.8; 0.0188 to 0.0197"};
inline constexpr ParameterSpec transition{
    "transition",
    "1",
    2.4e5,
    0.0,
    1e8,
    "rotating_disk: Re_r at which the flow becomes turbulent; 2e5 to 3e5 on a smooth disk, less on a rough one"};
inline constexpr ParameterSpec natural{"natural",
                                       "W m-2 K-1",
                                       1.42,
                                       0.0,
                                       100.0,
                                       "rotating_disk: natural convection at 1 K and 1 m, which the film never falls "
                                       "below; 1.42 for a vertical plate"};
inline constexpr std::size_t n_parameters = 5;

/// The part of a wheel that is cooled: a ring about its axis, of which both faces meet the air.
struct Ring {
    double inner;  ///< m
    double outer;  ///< m, > inner
};
/// From the edge of the rim, R0 - H, to R0.
[[nodiscard]] Ring sidewalls_of(const Tire& tire);
/// From the axis to the edge of the rim.
[[nodiscard]] Ring rim_of(const Tire& tire);
/// Of both faces. @returns m2
[[nodiscard]] double area_of(const Ring& ring);

/// Whether an effect has this choice and takes the rotating disk: then it needs a tire and the inputs `reads`.
[[nodiscard]] bool is_chosen(const ActiveEffect& active);

/// Re = w R^2/nu at the ring's edge over a million, 0 where the film is constant. Measured up to 7e5 on smooth disks (Cobb &
/// Saunders 1956, recalled).
[[nodiscard]] double reynolds_in_millions(const ActiveEffect& active, const Ring& ring, const Tire& tire,
                                          const Inputs& inputs);
inline constexpr double measured_up_to = 0.7;  ///< million

inline constexpr int n_coefficients = 4;

/// Coefficients of the moment: the air's temperature, the laminar and the turbulent part with the air's properties at
/// that temperature, and natural convection at 1 K; 0 for this where natural_convection acts on the same patch.
/// @param out [n_coefficients]
void evaluate(const ActiveEffect& active, const Ring& ring, const OperatingPoint& point, std::span<double> out);

/// A coefficient and its derivative with the temperature of the surface.
struct Film {
    double h;      ///< W/(m2 K)
    double dh_dT;  ///< W/(m2 K2)
};
/// The film at a surface of temperature T, the air's properties taken half-way between surface and air. The radius of
/// the transition stays where it is at the temperature of the air: 3 % too near to the axis at 20 K above it.
/// @param coefficients [n_coefficients], of `evaluate`  @param T K
[[nodiscard]] Film at(const ActiveEffect& active, std::span<const double> coefficients, double T);

}  // namespace tiretherm::physics::disk_film
