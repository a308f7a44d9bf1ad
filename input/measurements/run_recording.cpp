#include <cmath>
#include <variant>

#include "input/measurements/run_readings.hpp"

namespace tiretherm::input {

namespace {

/// A column by its heading, with no values yet.
Watched watch(const RunFile& file, const UsedColumn& column, std::string_view si) {
    const Heading& heading = file.file.heads()[static_cast<std::size_t>(column.column)].heading;
    Watched watched;
    watched.name = column.name;
    watched.heading = heading.name;
    watched.unit = heading.unit.value_or("");
    watched.si = si;
    const auto read = conversion(watched.unit, si, Scale::absolute);
    if (const auto* found = std::get_if<Conversion>(&read)) {
        watched.conversion = *found;
    }
    return watched;
}

}  // namespace

Recording recording_of(const RunFile& file, const Draft& draft, const MeasuredRun& run) {
    Recording recording;
    recording.file = run.file;
    recording.time = run.time;
    if (file.columns.time >= 0) {
        recording.time_unit = file.file.heads()[static_cast<std::size_t>(file.columns.time)].heading.unit.value_or("");
    }
    for (const UsedColumn& column : file.columns.used) {
        if (column.input != nullptr) {
            Watched watched = watch(file, column, column.input->unit);
            watched.is_input = true;
            for (const MeasuredInput& input : draft.run->inputs) {
                if (input.signal == column.input) {
                    watched.time = input.time;
                    watched.value = input.value;
                }
            }
            recording.columns.push_back(std::move(watched));
            continue;
        }
        for (const MeasuredSeries& series : run.series) {
            const solver::Channel& channel = draft.problem.channels[series.channel];
            if (channel.name != column.name) {
                continue;
            }
            Watched watched = watch(file, column, solver::unit_of(channel.quantity));
            for (std::size_t i = 0; i < run.time.size(); ++i) {
                if (!std::isnan(series.value[i])) {
                    watched.time.push_back(run.time[i]);
                    watched.value.push_back(series.value[i]);
                }
            }
            recording.columns.push_back(std::move(watched));
        }
    }
    return recording;
}

}  // namespace tiretherm::input
