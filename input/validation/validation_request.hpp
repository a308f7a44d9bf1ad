// SPDX-License-Identifier: BSD-3-Clause
// One readout as it is written in a validation table, before run and channel are known.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "input/toml/toml_table.hpp"
#include "input/validation/validation.hpp"

namespace tiretherm::input {

/// A request for a readout as it is written, for any model. What a table under `minus` or `over` leaves out is
/// taken over from the request above it.
struct ReadoutRequest {
    std::optional<LocatedString> case_name;      ///< without model and ending
    std::map<std::string, LocatedString> files;  ///< by the models' keys, instead of case_name
    std::optional<LocatedString> channel;
    Window::Take take = Window::Take::at;
    std::optional<double> from;  ///< s; empty: start of the run
    std::optional<double> to;    ///< s; empty: end of the run
    double share = 0.0;
    SourceLocation times;  ///< where the times are written
};

/// The keys case, files, channel, at, take, from, to, time_to.
[[nodiscard]] ReadoutRequest read_request(TomlTable& table, const ReadoutRequest& above,
                                          const std::vector<ValidationModel>& models);

}  // namespace tiretherm::input
