// SPDX-License-Identifier: BSD-3-Clause
// Collects the columns that the model uses, inputs and sensors, into the recording that the data checks look at.

#include <variant>

#include "input/loggers/logger_units.hpp"
#include "input/measurements/logged_signal.hpp"
#include "input/runs/run_readings.hpp"

namespace tiretherm::input {

namespace {

/// A column by its heading, with no values yet.
RecordedColumn recorded_column(const RunFile& file, const UsedColumn& column, std::string_view si) {
    const ColumnHead& head = file.file.heads()[static_cast<std::size_t>(column.column)];
    const Heading& heading = head.heading;
    RecordedColumn recorded;
    recorded.line = head.place.line;
    recorded.name = column.name;
    recorded.heading = heading.name;
    recorded.unit = heading.unit.value_or("");
    recorded.si = si;
    const auto read = conversion(meant_unit(recorded.unit, si), si, Scale::absolute);
    if (const auto* found = std::get_if<Conversion>(&read)) {
        recorded.conversion = *found;
    }
    return recorded;
}

}  // namespace

Recording recording_of(const RunFile& file, const RunInputs& inputs, const solver::Problem& problem,
                       const MeasuredRun& run) {
    Recording recording;
    recording.time = run.time;
    if (file.columns.time >= 0) {
        recording.time_unit = file.file.heads()[static_cast<std::size_t>(file.columns.time)].heading.unit.value_or("");
    }
    for (const UsedColumn& column : file.columns.used) {
        // A column that is an input and a sensor is looked at once, as the input.
        if (column.input != nullptr) {
            RecordedColumn recorded = recorded_column(file, column, column.input->unit);
            recorded.is_input = true;
            for (const MeasuredInput& input : inputs.inputs) {
                if (input.signal == column.input) {
                    recorded.time = input.time == recording.time ? recording.time : input.time;
                    recorded.value = input.value;
                }
            }
            recording.columns.push_back(std::move(recorded));
            continue;
        }
        for (std::size_t s = 0; s < run.series.size(); ++s) {
            const MeasuredSeries& series = run.series[s];
            const solver::Channel& channel = problem.channels[series.channel];
            if (channel.name != column.name) {
                continue;
            }
            RecordedColumn recorded = recorded_column(file, column, solver::unit_of(channel.quantity));
            recorded.series = s;
            solver::SignalHistory known = known_samples(run.time, series.value);
            recorded.time = known.time.size() == recording.time.size() ? recording.time
                                                                       : solver::SharedSamples(std::move(known.time));
            recorded.value = std::move(known.value);
            recording.columns.push_back(std::move(recorded));
        }
    }
    return recording;
}

}  // namespace tiretherm::input
