// SPDX-License-Identifier: BSD-3-Clause
// Colours of a page, measured: curves stand off from the paper and from each other, also for people who lack the cones for red
// or for green, and the map of differences is as light on one side as on the other.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "post/page/assets.hpp"

namespace tiretherm::post {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

/// The colours of an array of the script, "name = [...]", as linear RGB (IEC 61966-2-1).
std::vector<Triple> colours(const std::string& name) {
    const std::string script(assets::script());
    const std::size_t from = script.find("const " + name + " = [");
    const std::string list = from == std::string::npos ? "" : script.substr(from, script.find(']', from) - from);
    std::vector<Triple> found;
    for (std::size_t at = list.find('#'); at != std::string::npos; at = list.find('#', at + 1)) {
        Triple one{};
        for (std::size_t i = 0; i < 3; ++i) {
            const double c = std::stoi(list.substr(at + 1 + 2 * i, 2), nullptr, 16) / 255.0;
            one[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        }
        found.push_back(one);
    }
    return found;
}

double luminance(const Triple& c) { return 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2]; }

/// WCAG 2.1
double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

Triple seen(const Matrix& eye, const Triple& c) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = std::clamp(eye[i][0] * c[0] + eye[i][1] * c[1] + eye[i][2] * c[2], 0.0, 1.0);
    }
    return out;
}

/// CIELAB under D65.
Triple lab(const Triple& c) {
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = f((0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047);
    const double y = f(luminance(c));
    const double z = f((0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// CIEDE2000 (Sharma, Wu, Dalal 2005).
double difference(const Triple& one, const Triple& two) {
    constexpr double degree = std::numbers::pi / 180.0;
    const double mean_c = 0.5 * (std::hypot(one[1], one[2]) + std::hypot(two[1], two[2]));
    const double c7 = std::pow(mean_c, 7.0);
    const double g = 0.5 * (1.0 - std::sqrt(c7 / (c7 + std::pow(25.0, 7.0))));
    const auto hue = [&](const Triple& c) {
        const double h = std::atan2(c[2], (1.0 + g) * c[1]) / degree;
        return h < 0.0 ? h + 360.0 : h;
    };
    const double c1 = std::hypot((1.0 + g) * one[1], one[2]);
    const double c2 = std::hypot((1.0 + g) * two[1], two[2]);
    const double h1 = hue(one);
    const double h2 = hue(two);
    double dh = c1 * c2 == 0.0 ? 0.0 : h2 - h1;
    dh += dh > 180.0 ? -360.0 : dh < -180.0 ? 360.0 : 0.0;
    const double dH = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * dh * degree);
    const double L = 0.5 * (one[0] + two[0]);
    const double C = 0.5 * (c1 + c2);
    double H = h1 + h2;
    if (c1 * c2 != 0.0) {
        H = 0.5 * (std::abs(h1 - h2) <= 180.0 ? H : H < 360.0 ? H + 360.0 : H - 360.0);
    }
    const double T = 1.0 - 0.17 * std::cos((H - 30.0) * degree) + 0.24 * std::cos(2.0 * H * degree) +
                     0.32 * std::cos((3.0 * H + 6.0) * degree) - 0.20 * std::cos((4.0 * H - 63.0) * degree);
    const double l =
        (two[0] - one[0]) / (1.0 + 0.015 * std::pow(L - 50.0, 2) / std::sqrt(20.0 + std::pow(L - 50.0, 2)));
    const double c = (c2 - c1) / (1.0 + 0.045 * C);
    const double h = dH / (1.0 + 0.015 * C * T);
    const double turn = 30.0 * std::exp(-std::pow((H - 275.0) / 25.0, 2));
    const double R =
        -2.0 * std::sqrt(std::pow(C, 7.0) / (std::pow(C, 7.0) + std::pow(25.0, 7.0))) * std::sin(2.0 * turn * degree);
    return std::sqrt(l * l + c * c + h * h + R * c * h);
}

// Machado, Oliveira and Fernandes (2009), severity 1.0, of linear RGB.
constexpr Matrix normal{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
constexpr Matrix protanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

double smallest_difference(const std::vector<Triple>& palette, const Matrix& eye) {
    double smallest = 1e300;
    for (std::size_t i = 0; i < palette.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            smallest = std::min(smallest, difference(lab(seen(eye, palette[i])), lab(seen(eye, palette[j]))));
        }
    }
    return smallest;
}

// Pairs 1, 7 and 17 of the test data of Sharma, Wu and Dalal (2005), table 1: 2.0425, 2.3669 and 27.1492 as printed there.
TEST(Palette, DifferencesOfColoursAreThoseOfTheStandard) {
    EXPECT_NEAR(difference({50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}), 2.0425, 5e-5);
    EXPECT_NEAR(difference({50.0, 0.0, 0.0}, {50.0, -1.0, 2.0}), 2.3669, 5e-5);
    EXPECT_NEAR(difference({50.0, 2.5, 0.0}, {73.0, 25.0, -18.0}), 27.1492, 5e-5);
}

// Ends and quarters of "inferno" as published (R package viridis, inferno(5)); each is met to 2/255. It gets brighter all the way.
TEST(Palette, TemperaturesHaveTheColoursOfInferno) {
    const double published[5][3] = {
        {0, 0, 4}, {0x56, 0x10, 0x6e}, {0xbb, 0x37, 0x54}, {0xf9, 0x8c, 0x0a}, {0xfc, 0xff, 0xa4}};
    const auto byte = [](double linear) {
        return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
    };
    const std::vector<Triple> steps = colours("inferno");
    ASSERT_EQ(steps.size(), 33U);
    for (std::size_t quarter = 0; quarter < 5; ++quarter) {
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(byte(steps[8 * quarter][i]), published[quarter][i], 2.0) << quarter;
        }
    }
    for (std::size_t i = 1; i < steps.size(); ++i) {
        EXPECT_LT(luminance(steps[i - 1]), luminance(steps[i])) << i;
    }
}

// A CIEDE2000 of 1 can just be seen with both colours side by side; thin lines apart from each other need some ten times that.
TEST(Palette, CurvesCanBeToldApartByAllEyes) {
    for (const char* name : {"curvesOnLight", "curvesOnDark"}) {
        const std::vector<Triple> palette = colours(name);
        ASSERT_EQ(palette.size(), 8u) << name;
        EXPECT_GT(smallest_difference(palette, normal), 15.0) << name;
        EXPECT_GT(smallest_difference(palette, protanopia), 15.0) << name;
        EXPECT_GT(smallest_difference(palette, deuteranopia), 15.0) << name;
    }
}

// WCAG 2.1, 1.4.11: graphical objects stand off by 3:1. Paper is #ffffff, luminance 1, or #15181c, 0.0091.
TEST(Palette, CurvesStandOffFromThePaper) {
    for (const Triple& colour : colours("curvesOnLight")) {
        EXPECT_GE(contrast(luminance(colour), 1.0), 3.0);
    }
    for (const Triple& colour : colours("curvesOnDark")) {
        EXPECT_GE(contrast(luminance(colour), 0.0091), 3.0);
    }
}

// Equal steps of lightness from the middle to both ends, to what rounding to 8 bits and the edge of sRGB leave.
TEST(Palette, TheMapOfDifferencesIsEvenOnBothSides) {
    const std::vector<Triple> map = colours("signed");
    ASSERT_EQ(map.size(), 11u);
    const double middle = lab(map[5])[0];
    const double step = (middle - lab(map[0])[0]) / 5.0;
    EXPECT_GT(step, 10.0);
    for (std::size_t i = 1; i <= 5; ++i) {
        EXPECT_NEAR(lab(map[5 - i])[0], middle - step * static_cast<double>(i), 1.5);
        EXPECT_NEAR(lab(map[5 + i])[0], middle - step * static_cast<double>(i), 1.5);
    }
}

}  // namespace
}  // namespace tiretherm::post
