// SPDX-License-Identifier: BSD-3-Clause
// Lists everything that can act on the runs of a table.

#include <algorithm>

#include "diagnosis/quoted/trial_candidates.hpp"
#include "diagnosis/quoted/trials.hpp"

namespace tiretherm::diagnosis::quoted {

std::vector<Addition> Trials::additions(const Numbers& numbers) const {
    std::vector<Addition> all;
    for (const std::size_t run : nominal_runs(model_)) {
        add_effects(all, candidates_[run], validation_.runs[run].problem);
    }
    for (std::size_t other = 0; other < validation_.models.size(); ++other) {
        if (other != model_ && !nominal_runs(other).empty()) {
            all.push_back({.kind = AdditionKind::mesh,
                           .id = validation_.models[other].key,
                           .what = validation_.models[other].name,
                           .high = 1.0,
                           .model = other,
                           .nodes = {0.0, 1.0}});
        }
    }
    for (std::size_t k = 0; k < numbers.inputs.size(); ++k) {
        const UnknownInput& input = numbers.inputs[k];
        if (input.is_number) {
            all.push_back({.kind = AdditionKind::input,
                           .id = input.name,
                           .key = "value",
                           .unit = input.unit,
                           .absent = input.value,
                           .low = input.at.front(),
                           .high = input.at.back(),
                           .source = "the table's own range",
                           .input = static_cast<int>(k),
                           .nodes = input.at,
                           .changes = input.changes});
        }
    }
    std::vector<std::pair<std::string, std::string>> sensors;  // name, first word of the source
    for (const QuotedResult& row : numbers.rows) {
        const input::Readout& readout = validation_.numbers[row.number].models[model_]->of.of;
        const solver::Channel& channel = validation_.runs[readout.run].problem.channels[readout.channel];
        const std::pair<std::string, std::string> sensor{instrument_of(channel.name), source_word(row.number)};
        if (channel.quantity == solver::Quantity::temperature && std::ranges::find(sensors, sensor) == sensors.end()) {
            sensors.push_back(sensor);
        }
    }
    for (const auto& [name, source] : sensors) {
        add_instrument(all, name, source);
    }
    return all;
}

}  // namespace tiretherm::diagnosis::quoted
