// SPDX-License-Identifier: BSD-3-Clause
// Neighbouring pixels of a large image are drawn as one, so that a page stays small.
#include "post/comparison/camera_chart.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/page/charts.hpp"
#include "post/page/moments.hpp"

namespace tiretherm::post {

using diagnosis::ComparedImages;

namespace {

constexpr double most_squares = 8'000.0;  ///< in a panel
constexpr double half_millimetres = 0.5e3;

/// Squares of so many by so many pixels.
struct Squares {
    int side = 1;
    int columns = 0;
    std::vector<std::size_t> of_pixel;  ///< [pixels] into index
    std::vector<int> index;             ///< of the squares that hold a pixel: row * columns + column
};

Squares squares_of(const ComparedImages& images) {
    Squares squares;
    const double pixels = static_cast<double>(images.rows) * images.columns;
    squares.side = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / most_squares))));
    squares.columns = (images.columns + squares.side - 1) / squares.side;
    std::map<int, std::size_t> known;
    for (const auto& [row, column] : images.place) {
        const int at = row / squares.side * squares.columns + column / squares.side;
        const auto [found, fresh] = known.try_emplace(at, squares.index.size());
        if (fresh) {
            squares.index.push_back(at);
        }
        squares.of_pixel.push_back(found->second);
    }
    return squares;
}

/// Means over the squares of one frame. @param kelvin [frames][pixels]
void add_means(std::vector<float>& celsius, const Squares& squares, const std::vector<double>& kelvin,
               std::size_t frame) {
    std::vector<double> sum(squares.index.size(), 0.0);
    std::vector<double> count(squares.index.size(), 0.0);
    const std::size_t pixels = squares.of_pixel.size();
    for (std::size_t p = 0; p < pixels; ++p) {
        sum[squares.of_pixel[p]] += tiretherm::celsius(kelvin[frame * pixels + p]);
        count[squares.of_pixel[p]] += 1.0;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        celsius.push_back(static_cast<float>(sum[i] / count[i]));
    }
}

/// The largest difference between the halves of a moment's values, measured and simulated.
double largest_difference(const std::vector<Moment>& shown) {
    float most = 0.0F;
    for (const Moment& moment : shown) {
        const std::size_t half = moment.celsius.size() / 2;
        for (std::size_t i = 0; i < half; ++i) {
            most = std::max(most, std::abs(moment.celsius[half + i] - moment.celsius[i]));
        }
    }
    return static_cast<double>(most);
}

}  // namespace

Value camera_chart(const ComparedImages& images) {
    const Squares squares = squares_of(images);
    const auto moment_of = [&](std::size_t frame) {
        Moment moment{.time = images.time[frame], .celsius = {}, .mark = {}};
        add_means(moment.celsius, squares, images.measured, frame);
        add_means(moment.celsius, squares, images.simulated, frame);
        return moment;
    };
    Moments moments;
    for (std::size_t frame = 0; frame < images.time.size(); ++frame) {
        moments.take(moment_of(frame));
    }
    moments.show_first(moment_of(images.worst));
    const std::vector<Moment> shown = moments.shown();
    Value data{{"kind", "images"}};
    data.set(moments.data(shown));
    data.set({{"first", "worst frame"},
              {"reach", rounded(largest_difference(shown))},
              {"columns", squares.columns},
              {"half_width", rounded(half_millimetres * images.columns * images.pitch_x)},
              {"half_height", rounded(half_millimetres * images.rows * images.pitch_y)},
              {"square", Value::List{rounded(2.0 * half_millimetres * squares.side * images.pitch_x),
                                     rounded(2.0 * half_millimetres * squares.side * images.pitch_y)}},
              {"pixels", squares.index}});
    return data;
}

std::string camera_caption(const ComparedImages& images) {
    const int side = squares_of(images).side;
    return "Measured and simulated have one scale for all frames, and the differences have one about zero. Grey pixels "
           "are left out." +
           (side > 1 ? fmt::format(" A square is the mean of {0} by {0} pixels.", side) : std::string());
}

}  // namespace tiretherm::post
