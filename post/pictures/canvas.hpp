// SPDX-License-Identifier: BSD-3-Clause
// A drawing surface that is saved as PNG, without a display.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "post/pictures/colour.hpp"

namespace tiretherm::post {

/// A place on a canvas, px from the upper left corner.
struct Dot {
    double x = 0.0;
    double y = 0.0;
};

enum class Align { left, centre, right };

struct Writing {
    double size = 24.0;  ///< px
    Colour ink = {};
    Align align = Align::left;
    bool bold = false;
    bool upwards = false;                                                 ///< turned to read from below
    Colour halo = {.red = 0.0, .green = 0.0, .blue = 0.0, .alpha = 0.0};  ///< drawn round the letters
};

/// Lines, areas and letters on pixels, saved as PNG; drawn by cairo, without a display.
class Canvas {
public:
    Canvas(int width, int height, const Colour& background);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void line(std::span<const Dot> dots, const Colour& ink, double width, bool dashed = false);
    void rectangle(const Dot& corner, double width, double height, const Colour& fill);
    void frame(const Dot& corner, double width, double height, const Colour& ink, double line_width);
    /// A filled polygon whose edges are sharp, so that neighbours leave no seam.
    void tile(std::span<const Dot> corners, const Colour& fill);
    void disc(const Dot& centre, double radius, const Colour& fill, const Colour& rim, double rim_width);
    /// @param at the middle of the text's height, and its left end, middle or right end
    void write(const Dot& at, const std::string& text, const Writing& writing);
    [[nodiscard]] double width_of(const std::string& text, const Writing& writing) const;
    /// @param image [width * height], row by row from the top
    void image(const Dot& corner, int width, int height, std::span<const Colour> image);

    /// @errors FileError
    void save(const std::filesystem::path& path) const;

private:
    struct Page;  ///< cairo's handle
    void use(const Colour& ink) const;
    void use(const Writing& writing) const;

    std::unique_ptr<Page> page_;
};

}  // namespace tiretherm::post
