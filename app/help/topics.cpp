// SPDX-License-Identifier: BSD-3-Clause
// The list of topics.

#include "app/help/topics.hpp"

#include <algorithm>
#include <array>

namespace tiretherm::app {

namespace {

constexpr std::array table{
    Topic{"cases", "What a case file consists of", cases_topic},
    Topic{"inputs", "What a case can be driven with: names, units, meaning", inputs_topic},
    Topic{"signs", "Axes, and which way each input counts as positive", signs_topic},
    Topic{"units", "How quantities are written", units_topic},
    Topic{"sensors", "What a sensor of a case can measure", sensors_topic},
    Topic{"data", "What files of measured runs look like", data_topic},
    Topic{"parameters", "What a fit may change, and what it says of it", parameters_topic},
    Topic{"noise", "What is taken for noise of a sensor", noise_topic},
    Topic{"verdicts", "What a diagnosis can answer", verdicts_topic},
};

}  // namespace

std::span<const Topic> topics() { return table; }

const Topic* find_topic(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Topic::name);
    return found == table.end() ? nullptr : found;
}

}  // namespace tiretherm::app
