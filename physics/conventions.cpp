// SPDX-License-Identifier: BSD-3-Clause
// Table of the sign conventions; tests/physics/test_conventions.cpp derives each from the laws themselves.

#include "physics/conventions.hpp"

#include <algorithm>
#include <array>

namespace tiretherm::physics {

namespace {

struct Convention {
    double Inputs::*member;
    std::string_view text;
};

constexpr std::array table{
    Convention{
        &Inputs::speed,
        "Positive: the tire rolls forwards (x), the road runs backwards under it. Heat takes the magnitude; in the "
        "Magic Formula rolling backwards turns the slip angle."},
    Convention{&Inputs::vertical_load, "Positive: the tire is pressed onto the road. 0: it does not touch the road."},
    Convention{
        &Inputs::slip_angle,
        "Between the heading (x) and the velocity of the wheel. Heat takes the magnitude. In the Magic Formula the "
        "lateral force has the sign of pKy1 times the slip angle (and speed): with forces positive to the left (y), "
        "a wheel that moves to its right has a positive slip angle where pKy1 is positive, and a negative one where "
        "pKy1 is negative."},
    Convention{
        &Inputs::slip_ratio,
        "Positive: the tire is driven, it turns faster than it rolls freely. Negative: it brakes; -1 is a locked "
        "wheel, which does not roll. Heat of sliding takes the magnitude; the longitudinal force of the Magic Formula "
        "and of "
        "the brush has its sign."},
    Convention{
        &Inputs::slip_speed,
        "Positive: the tread runs faster backwards than the road under it, as in a wheel that spins. Heat of sliding "
        "takes the magnitude; the Magic Formula's slip ratio is this speed over |V|, at standstill a large one."},
    Convention{&Inputs::lateral_force,
               "Drawn positive to the left (y): towards the middle of the vehicle, as at the outer tires of a bend. "
               "Heat takes "
               "the magnitude: either sign gives the same total. Across the tread the sign counts: positive loads the "
               "outside shoulder (pressure_across_tread)."},
    Convention{
        &Inputs::longitudinal_force,
        "Positive: forwards (x), driving. Negative: braking. Heat takes the magnitude: either sign gives the same."},
    Convention{
        &Inputs::camber,
        "Of the vehicle, alike on both sides of it: negative with the top leaning inboard, which heats the inside "
        "(inboard) shoulder; positive with the top leaning outboard, which heats the outside one (camber_asymmetry, "
        "pressure_across_tread). "
        "The Magic Formula takes it as it is: on the right-hand side of the vehicle that is the inclination of ISO "
        "8855, positive with the top leaning to the right."},
    Convention{&Inputs::inflation_pressure, "Above the atmosphere: 0 is a flat tire."},
    Convention{&Inputs::air_temperature,
               "Absolute. Heat flows into the tire where the air is warmer than its surface."},
    Convention{&Inputs::road_temperature,
               "Absolute. Heat flows into the tire where the road is warmer than its surface."},
    Convention{&Inputs::wet, "0: dry, 1: wet; between them a share of the film of water."},
    Convention{&Inputs::laser_power, "Positive: into the surface, before the share that is absorbed."},
    Convention{&Inputs::brake_temperature,
               "Absolute. Heat flows into the tire where the brake is hotter than the rim."},
    Convention{&Inputs::wheel_angle, "Grows while the tire rolls forwards, by the speed over the rolling radius."},
};

}  // namespace

std::string_view sign_convention(const Signal& signal) {
    const auto* const found = std::ranges::find(table, signal.member, &Convention::member);
    return found == table.end() ? std::string_view() : found->text;
}

}  // namespace tiretherm::physics
