#pragma once

#include <array>
#include <optional>

#include "input/text/section.hpp"
#include "input/validation/validation.hpp"

namespace tiretherm::input {

/// A reading as it is written, for whatever model. What a table under `minus` or `over` leaves out is taken over from
/// the reading above it.
struct Asked {
    std::optional<Word> case_name;                    ///< without model and ending
    std::array<std::optional<Word>, n_models> files;  ///< instead of case_name
    std::optional<Word> channel;
    Window::Take take = Window::Take::at;
    std::optional<double> from;  ///< s; empty: start of the run
    std::optional<double> to;    ///< s; empty: end of the run
    double share = 0.0;
    Place times;  ///< where the times are written
};

/// The keys case, files, channel, at, take, from, to, time_to.
[[nodiscard]] Asked read_asked(Section& section, const Asked& above);

}  // namespace tiretherm::input
