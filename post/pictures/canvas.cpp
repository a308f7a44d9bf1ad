// SPDX-License-Identifier: BSD-3-Clause
// Lines, areas, text and images by cairo, PNG files by libpng; the only source that includes either.

#include "post/pictures/canvas.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <cairo/cairo.h>
#include <png.h>

#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

std::uint32_t pixel(const Colour& c) {
    const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(255.0 * value)); };
    return byte(c.alpha) << 24U | byte(c.red * c.alpha) << 16U | byte(c.green * c.alpha) << 8U | byte(c.blue * c.alpha);
}

}  // namespace

struct Canvas::Page {
    cairo_t* context;
    ~Page() { cairo_destroy(context); }
};

Canvas::~Canvas() = default;

Canvas::Canvas(int width, int height, const Colour& background) {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    page_.reset(new Page{cairo_create(surface)});
    cairo_surface_destroy(surface);  // the context keeps it
    use(background);
    cairo_paint(page_->context);
    cairo_set_line_join(page_->context, CAIRO_LINE_JOIN_ROUND);
}

void Canvas::use(const Colour& ink) const {
    cairo_set_source_rgba(page_->context, ink.red, ink.green, ink.blue, ink.alpha);
}

void Canvas::use(const Writing& writing) const {
    cairo_select_font_face(page_->context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           writing.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(page_->context, writing.size);
}

void Canvas::line(std::span<const Dot> dots, const Colour& ink, double width, bool dashed) {
    for (const Dot& dot : dots) {
        cairo_line_to(page_->context, dot.x, dot.y);
    }
    const double dash[] = {4.0 * width, 3.0 * width};
    cairo_set_dash(page_->context, dash, dashed ? 2 : 0, 0.0);
    use(ink);
    cairo_set_line_width(page_->context, width);
    cairo_stroke(page_->context);
    cairo_set_dash(page_->context, nullptr, 0, 0.0);
}

void Canvas::rectangle(const Dot& corner, double width, double height, const Colour& fill) {
    cairo_rectangle(page_->context, corner.x, corner.y, width, height);
    use(fill);
    cairo_fill(page_->context);
}

void Canvas::frame(const Dot& corner, double width, double height, const Colour& ink, double line_width) {
    cairo_rectangle(page_->context, corner.x, corner.y, width, height);
    use(ink);
    cairo_set_line_width(page_->context, line_width);
    cairo_stroke(page_->context);
}

void Canvas::tile(std::span<const Dot> corners, const Colour& fill) {
    for (const Dot& dot : corners) {
        cairo_line_to(page_->context, dot.x, dot.y);
    }
    cairo_close_path(page_->context);
    use(fill);
    cairo_set_antialias(page_->context, CAIRO_ANTIALIAS_NONE);
    cairo_fill(page_->context);
    cairo_set_antialias(page_->context, CAIRO_ANTIALIAS_DEFAULT);
}

void Canvas::disc(const Dot& centre, double radius, const Colour& fill, const Colour& rim, double rim_width) {
    cairo_new_sub_path(page_->context);
    cairo_arc(page_->context, centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
    use(fill);
    cairo_fill_preserve(page_->context);
    use(rim);
    cairo_set_line_width(page_->context, rim_width);
    cairo_stroke(page_->context);
}

double Canvas::width_of(const std::string& text, const Writing& writing) const {
    use(writing);
    cairo_text_extents_t extents{};
    cairo_text_extents(page_->context, text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::write(const Dot& at, const std::string& text, const Writing& writing) {
    const double width = width_of(text, writing);
    const double back = writing.align == Align::left ? 0.0 : writing.align == Align::centre ? 0.5 * width : width;
    cairo_save(page_->context);
    cairo_translate(page_->context, at.x, at.y);
    if (writing.upwards) {
        cairo_rotate(page_->context, -0.5 * std::numbers::pi);
    }
    // Figures of DejaVu Sans are 0.73 of its size high.
    cairo_move_to(page_->context, -back, 0.365 * writing.size);
    cairo_text_path(page_->context, text.c_str());
    if (writing.halo.alpha > 0.0) {
        use(writing.halo);
        cairo_set_line_width(page_->context, 0.35 * writing.size);
        cairo_stroke_preserve(page_->context);
    }
    use(writing.ink);
    cairo_fill(page_->context);
    cairo_restore(page_->context);
}

void Canvas::image(const Dot& corner, int width, int height, std::span<const Colour> image) {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    cairo_surface_flush(surface);
    unsigned char* bytes = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    auto from = image.begin();
    for (int y = 0; y < height; ++y) {
        auto* row = reinterpret_cast<std::uint32_t*>(bytes + y * stride);
        for (int x = 0; x < width; ++x) {
            row[x] = pixel(*from++);
        }
    }
    cairo_surface_mark_dirty(surface);
    cairo_set_source_surface(page_->context, surface, corner.x, corner.y);
    cairo_paint(page_->context);
    cairo_surface_destroy(surface);
}

void Canvas::save(const std::filesystem::path& path) const {
    cairo_surface_t* const surface = cairo_get_target(page_->context);
    cairo_surface_flush(surface);
    const int width = cairo_image_surface_get_width(surface);
    const int height = cairo_image_surface_get_height(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    const unsigned char* const pixels = cairo_image_surface_get_data(surface);
    std::vector<unsigned char> colours;
    colours.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(pixels + y * stride);
        for (int x = 0; x < width; ++x) {
            for (const unsigned shift : {16U, 8U, 0U}) {
                colours.push_back(static_cast<unsigned char>(row[x] >> shift & 0xFFU));
            }
        }
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    image.flags = PNG_IMAGE_FLAG_FAST;  // drawings have flat areas: filters and a thorough search gain little
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, colours.data(), 0, nullptr) == 0) {
        throw FileError("write", path, image.message);
    }
    bytes.resize(size);
    replace_file(path, bytes);
}

}  // namespace tiretherm::post
