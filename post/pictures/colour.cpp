// SPDX-License-Identifier: BSD-3-Clause
// Control points of the colour map and the line colours.

#include "post/pictures/colour.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tiretherm::post {

namespace {

// Joined by straight lines, these are within 1.5/255 of matplotlib's 256.
constexpr std::array inferno{
    0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2e0a5a, 0x3c0965, 0x4a0c6b, 0x57106d, 0x63146e, 0x70196e,
    0x7d1e6d, 0x89226a, 0x962766, 0xa32b61, 0xaf315c, 0xbb3755, 0xc63e4d, 0xd14644, 0xdb4f3b, 0xe35932, 0xeb6528,
    0xf1711e, 0xf67f14, 0xf98d0a, 0xfb9c06, 0xfcab0f, 0xfbba1f, 0xf9ca32, 0xf5d949, 0xf2e865, 0xf3f586, 0xfcffa4,
};

constexpr std::array lines{colour(0x0072b2), colour(0xd55e00), colour(0x009e73),
                           colour(0xcc79a7), colour(0xe69f00), colour(0x56b4e9)};

}  // namespace

Colour heat_colour(double share) {
    const double position = std::clamp(share, 0.0, 1.0) * static_cast<double>(inferno.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(position), inferno.size() - 2);
    return mix(colour(static_cast<unsigned>(inferno[below])), colour(static_cast<unsigned>(inferno[below + 1])),
               position - static_cast<double>(below));
}

std::span<const Colour> line_colours() { return lines; }

}  // namespace tiretherm::post
