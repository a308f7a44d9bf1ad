// SPDX-License-Identifier: BSD-3-Clause
// The pages of `tiretherm help TOPIC`: what the program itself knows of inputs, units, sensors and words, one screen or two.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tiretherm::app {

struct Topic {
    std::string_view name;
    std::string_view summary;
    std::string (*text)();  ///< lines of at most 80 columns
};

/// In the order of `tiretherm help`.
[[nodiscard]] std::span<const Topic> topics();
/// @returns null for a name that is none
[[nodiscard]] const Topic* find_topic(std::string_view name);

// Made of tables of the program.
[[nodiscard]] std::string inputs_topic();
[[nodiscard]] std::string signs_topic();
[[nodiscard]] std::string units_topic();
[[nodiscard]] std::string sensors_topic();
[[nodiscard]] std::string cases_topic();
[[nodiscard]] std::string data_topic();
[[nodiscard]] std::string parameters_topic();
[[nodiscard]] std::string noise_topic();
[[nodiscard]] std::string verdicts_topic();

}  // namespace tiretherm::app
