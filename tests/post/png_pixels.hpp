// SPDX-License-Identifier: BSD-3-Clause
// Pixels of a PNG file, read back with cairo, to count and to place colours.
#pragma once

#include <cairo/cairo.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace tiretherm::sample {

/// A picture as 0xrrggbb, row by row from the top.
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> rgb;

    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return rgb[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    /// How many pixels of a column have this colour.
    [[nodiscard]] int in_column(int x, std::uint32_t colour) const {
        int n = 0;
        for (int y = 0; y < height; ++y) {
            n += at(x, y) == colour ? 1 : 0;
        }
        return n;
    }
    /// How many pixels of a row have this colour.
    [[nodiscard]] int in_row(int y, std::uint32_t colour) const {
        int n = 0;
        for (int x = 0; x < width; ++x) {
            n += at(x, y) == colour ? 1 : 0;
        }
        return n;
    }
    /// Mean height of the pixels of this colour in a column, px from the top; none where it is absent.
    [[nodiscard]] std::optional<double> middle_in_column(int x, std::uint32_t colour) const {
        double sum = 0.0;
        for (int y = 0; y < height; ++y) {
            sum += at(x, y) == colour ? y : 0.0;
        }
        const int n = in_column(x, colour);
        return n > 0 ? std::optional(sum / n) : std::nullopt;
    }
};

inline Pixels pixels(const std::filesystem::path& path) {
    Pixels picture;
    cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
    EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS) << path;
    if (cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS) {
        picture.width = cairo_image_surface_get_width(surface);
        picture.height = cairo_image_surface_get_height(surface);
        const unsigned char* data = cairo_image_surface_get_data(surface);
        const int stride = cairo_image_surface_get_stride(surface);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const unsigned char* bgr = data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x;
                picture.rgb.push_back(static_cast<std::uint32_t>(bgr[2] << 16 | bgr[1] << 8 | bgr[0]));
            }
        }
    }
    cairo_surface_destroy(surface);
    return picture;
}

}  // namespace tiretherm::sample
