// SPDX-License-Identifier: BSD-3-Clause
// Colours of pictures: matplotlib's perceptually uniform map "inferno" for temperatures, and line colours by Okabe and
// Ito (2008).
#pragma once

#include <span>

namespace tiretherm::post {

/// Red, green, blue in [0, 1]; alpha 1 covers.
struct Colour {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double alpha = 1.0;
};

/// 0xrrggbb
[[nodiscard]] constexpr Colour colour(unsigned rgb, double alpha = 1.0) {
    return {.red = static_cast<double>(rgb >> 16U & 0xFFU) / 255.0,
            .green = static_cast<double>(rgb >> 8U & 0xFFU) / 255.0,
            .blue = static_cast<double>(rgb & 0xFFU) / 255.0,
            .alpha = alpha};
}

[[nodiscard]] constexpr Colour mix(const Colour& a, const Colour& b, double share_of_b) {
    const double share_of_a = 1.0 - share_of_b;
    return {.red = share_of_a * a.red + share_of_b * b.red,
            .green = share_of_a * a.green + share_of_b * b.green,
            .blue = share_of_a * a.blue + share_of_b * b.blue,
            .alpha = share_of_a * a.alpha + share_of_b * b.alpha};
}

/// How bright a colour looks, 0 to 1 (Rec. 709).
[[nodiscard]] constexpr double luminance(const Colour& c) {
    return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
}

/// "Inferno" of matplotlib (N. J. Smith, S. van der Walt, 2015; CC0): equal differences of temperature look equally
/// large, in grey and to colour-blind eyes too.   @param share 0 coldest, 1 hottest; clamped
[[nodiscard]] Colour heat_colour(double share);

/// Colours that stay apart to colour-blind eyes (Okabe and Ito 2008), for lines.
[[nodiscard]] std::span<const Colour> line_colours();

}  // namespace tiretherm::post
