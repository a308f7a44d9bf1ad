// SPDX-License-Identifier: BSD-3-Clause
// Reads every column as it is written and looks at it as the data checks do.

#include "input/log_survey/log_survey.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "input/laps/file_laps.hpp"
#include "input/loggers/binary_logs.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/measurements/data_warnings.hpp"
#include "input/measurements/logged_signal.hpp"
#include "input/new_case/log_columns.hpp"
#include "input/runs/runs.hpp"
#include "input/tables/dead_codes.hpp"
#include "input/text/characters.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/table_shelf.hpp"
#include "solver/order_statistics.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::input {

namespace {

/// The samples that have a value, at their times.
struct ValidSamples {
    solver::SharedSamples time;
    std::vector<double> value{};
    std::string left_out{};  ///< what is written of a temperature and is none, a sentence; empty: nothing
};

ValidSamples known_of(const DataFile& file, const LogColumn& log, const solver::SharedSamples& time,
                      InputErrors& errors) {
    DataFile::Samples samples = file.samples(log.column, time, errors);
    ColumnHead head = file.heads()[static_cast<std::size_t>(log.column)];
    head.heading.unit = log.unit.empty() ? head.heading.unit : log.unit;
    const DeadCodes dead(
        samples.value, head,
        {.name = head.heading.name, .spec = quantity_specs::temperature, .purpose = Purpose::measured});
    const auto is_missing = [&](double value) { return !std::isfinite(value) || dead.has(value); };
    const bool shares_times = file.table().columns[static_cast<std::size_t>(log.column)].rate == 0.0;
    if (shares_times && std::ranges::none_of(samples.value, is_missing)) {
        return {.time = samples.value.empty() ? solver::SharedSamples(std::vector<double>()) : time,
                .value = std::move(samples.value)};
    }
    std::ranges::replace_if(samples.value, is_missing, std::nan(""));
    solver::SignalHistory known = known_samples(samples.time, samples.value);
    return {.time = std::move(known.time), .value = std::move(known.value), .left_out = dead.sentence};
}

/// Rate by the median step, and what is missing at it.
/// @param rows that could have a value
void set_rate(ColumnSurvey& column, const ValidSamples& known, double from, double to, std::size_t rows) {
    column.samples = known.time.size();
    const double step = solver::median_step(known.time);
    if (step == 0.0) {
        return;
    }
    column.rate = 1.0 / step;
    const double expected = std::floor((to - from) * column.rate + 1e-3) + 1.0;
    const auto n = static_cast<double>(known.time.size());
    const double lacking = std::min(expected - n, static_cast<double>(rows) - n);  // an uneven clock empties no field
    const double share = lacking / (n + lacking);
    column.missing = share > 0.001 ? share : 0.0;
}

/// The column for the data checks, in SI where its unit is known.
RecordedColumn recorded_of(const ColumnSurvey& column, const LogColumn& log, ValidSamples known) {
    RecordedColumn recorded;
    recorded.name = column.used_as.empty() ? column.name : column.used_as;
    recorded.heading = column.name;
    recorded.unit = log.unit.empty() ? column.unit : log.unit;
    recorded.is_input = log.is_input;
    const MeantUnit meant = meant_unit_by_name(column.name, recorded.unit);
    const std::array<std::string_view, 8> known_units{"K", "m s-1", "N", "Pa", "m s-2", "radian", "rad s-1", "1"};
    recorded.si = "1";
    for (const std::string_view si : known_units) {
        const auto read = conversion(meant_unit(meant.unit, si), si, Scale::absolute);
        if (const auto* found = std::get_if<Conversion>(&read); found != nullptr && !recorded.unit.empty()) {
            recorded.si = si;
            recorded.conversion = *found;
            break;
        }
    }
    std::ranges::for_each(known.value, [&](double& value) { value = recorded.conversion.to_si(value); });
    recorded.time = std::move(known.time);
    recorded.value = std::move(known.value);
    return recorded;
}

/// What was said of the file when it was read, without its name, which stands above.
std::vector<std::string> said_while_reading(const InputErrors& errors, const std::string& path) {
    std::vector<std::string> sentences;
    for (const InputWarning& warning : errors.warnings()) {
        const bool is_of_file = warning.file == path;
        const std::string line = is_of_file && warning.line > 0 ? fmt::format("line {}: ", warning.line) : "";
        sentences.push_back(is_of_file ? line + warning.what : render({warning}, 0).front());
    }
    return unique(sentences);
}

}  // namespace

std::optional<LogSurvey> survey_log(const std::filesystem::path& path, const std::vector<GivenUnit>& units,
                                    InputErrors& errors) {
    std::optional<Log> log = read_log(path, mesh_template("section", 12.0), units, errors);
    InputErrors again = errors;  // shares the file
    std::optional<DataFile> file = log ? DataFile::open(path, {}, again) : std::nullopt;
    if (!file) {
        return std::nullopt;
    }
    for (LogColumn& column : log->columns) {
        column.value = std::vector<double>();  // it is looked at as it is written
    }
    LogSurvey survey{.path = log->path, .description = file->description()};
    const LogColumn* clock = log->find("time");
    Recording recording;
    recording.time = std::move(log->time);
    solver::SharedSamples time = recording.time;
    const bool has_own_clocks = file->table().has_own_clocks();
    if (has_own_clocks) {  // the log has the rows of its used channels alone
        auto all = file->read({{.column = 0, .name = "time", .spec = {.unit = "s"}, .purpose = Purpose::clock}}, again);
        time = all.empty() ? time : solver::SharedSamples(std::move(all.front()));
    }
    survey.doubts = said_while_reading(errors, survey.path);
    survey.from = time.front();
    survey.to = time.back();
    survey.rows = time.size();
    survey.laps = find_laps(*file, time, std::nullopt, true, again);
    recording.time_unit = clock->heading.unit.value_or("");
    if (!clock->unit_ground.empty()) {
        survey.doubts.push_back(
            fmt::format("the column {} has no unit: {} is {}", clock->heading.name, clock->unit, clock->unit_remark()));
    }
    for (const LogColumn& column : log->columns) {
        if (column.heading.name.empty()) {
            continue;
        }
        ColumnSurvey found{.name = column.heading.name,
                           .unit = column.heading.unit.value_or(""),
                           .use = std::string(!column.other_use.empty() ? column.other_use
                                              : !column.is_used()       ? ""
                                              : column.is_input         ? "input"
                                              : column.is_sensor        ? "sensor"
                                                                        : "time"),
                           .used_as = column.full_name(),
                           .suggestion = column.full_suggestion(),
                           .reason = column.reason,
                           .is_dropped = column.is_dropped};
        solver::leave_reading_if_stopped();
        ValidSamples known = known_of(*file, column, time, again);
        if (!column.is_used() && !known.left_out.empty()) {  // of one that is used the reading has said it
            survey.doubts.push_back(known.left_out);
        }
        set_rate(found, known, survey.from, survey.to, has_own_clocks ? known.time.size() : survey.rows);
        if (!known.value.empty()) {
            const auto [low, high] = std::ranges::minmax(known.value);
            found.low = low;
            found.high = high;
        }
        if (!column.is_used() && found.unit.size() == 1) {
            if (const MeantUnit meant = meant_unit_by_name(found.name, found.unit); meant.error) {
                survey.doubts.push_back(fmt::format("{} In a case, {}", meant.error->what, meant.error->remedy));
            }
        }
        // What counts and where the car was are no signals; the time is looked at by itself.
        const bool is_signal =
            found.use != "time" && !counts_laps(found.name) && found.unit != "1" && known.value.size() > 1;
        if (is_signal && (column.is_used() || !found.unit.empty())) {
            // Pedals and switches rest at 0, and a machine holds what it was told: of what is not used only temperatures are judged.
            RecordedColumn recorded = recorded_of(found, column, std::move(known));
            if (column.is_used() || recorded.is_temperature()) {
                recording.columns.push_back(std::move(recorded));
            }
        }
        survey.columns.push_back(std::move(found));
    }
    file.reset();
    again.tables().tables.clear();  // nobody reads the file any more
    std::ranges::move(find_suspicious(recording), std::back_inserter(survey.doubts));
    return survey;
}

bool is_log_file(const std::filesystem::path& path) {
    return is_ending_of_log(in_small_letters(path.extension().string()));
}

}  // namespace tiretherm::input
