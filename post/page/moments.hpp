// SPDX-License-Identifier: BSD-3-Clause
// Fields at several moments, as a chart with a slider over time takes them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "post/report/value.hpp"

namespace tiretherm::post {

/// A field at a moment, as it will be drawn.
struct Moment {
    double time = 0.0;           ///< s
    std::vector<float> celsius;  ///< [places that are drawn]
    std::optional<std::array<double, 3>>
        mark;  ///< where it is hottest, in the units of the axes, and that temperature, degC
};

/// The moments of a chart. Where there are too many for a page, every second one is left out, but for the last.
class Moments {
public:
    void take(Moment moment);
    /// The moment that the page shows first, perhaps one between those that are taken; without it the last.
    void show_first(Moment moment) { first_ = std::move(moment); }

    [[nodiscard]] bool empty() const { return moments_.empty(); }
    /// Those of the chart, by time. @pre !empty()
    [[nodiscard]] std::vector<Moment> shown() const;
    /// Times, one scale for all, marks, and the values in 65536 steps of the scale. @param shown of this, perhaps with fewer places
    [[nodiscard]] Value data(const std::vector<Moment>& shown) const;

private:
    [[nodiscard]] const Moment& first() const { return first_ ? *first_ : last_; }
    void thin();

    std::vector<Moment> moments_;
    std::optional<Moment> first_;
    Moment last_;
    std::size_t stride_ = 1;  ///< of those that are kept
    std::size_t seen_ = 0;
};

}  // namespace tiretherm::post
