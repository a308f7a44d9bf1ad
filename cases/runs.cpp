#include "cases/runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include <fmt/format.h>

#include "cases/channel_value.hpp"
#include "cases/parameters.hpp"
#include "cases/run_inputs.hpp"
#include "cases/wanted.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

constexpr std::array<std::string_view, 4> tables_of_a_run{"drive", "initial", "time", "measured"};

std::vector<std::string> sensor_names(const Node& document) {
    std::vector<std::string> names;
    const Node* sensors = document.find("sensor");
    for (const Node& sensor : sensors != nullptr ? sensors->items : std::vector<Node>{}) {
        const Node* name = sensor.find("name");
        if (name != nullptr && name->kind == Node::Kind::text) {
            names.push_back(name->text);
        }
    }
    return names;
}

int find_channel(const solver::Problem& problem, std::string_view name) {
    const auto found = std::find_if(problem.channels.begin(), problem.channels.end(),
                                    [&](const solver::Channel& channel) { return channel.name == name; });
    return found == problem.channels.end() ? -1 : static_cast<int>(found - problem.channels.begin());
}

/// Samples of the file that lie within the run.
struct Samples {
    std::size_t first = 0;
    std::size_t last = 0;

    [[nodiscard]] std::vector<double> of(const std::vector<double>& all) const {
        return {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last)};
    }
};

Samples samples_within(const RunFile& file, const solver::Settings& settings) {
    const auto begin = file.time.begin() + static_cast<std::ptrdiff_t>(file.first);
    const auto end = file.time.begin() + static_cast<std::ptrdiff_t>(file.last);
    return {.first = static_cast<std::size_t>(std::lower_bound(begin, end, settings.start) - file.time.begin()),
            .last = static_cast<std::size_t>(std::upper_bound(begin, end, settings.end) - file.time.begin())};
}

/// What the sensors' columns of a file say.
void read_series(const RunFile& file, const Draft& draft, Mistakes& mistakes, MeasuredRun& run) {
    std::vector<ColumnRequest> requests;
    std::vector<std::size_t> channels;
    std::vector<std::string> remedies;
    remedies.reserve(file.columns.used.size());
    for (const UsedColumn& column : file.columns.used) {
        const int channel = column.is_sensor ? find_channel(draft.problem, column.name) : -1;
        if (channel < 0) {
            continue;
        }
        const auto index = static_cast<std::size_t>(channel);
        const Wanted wanted = wanted_value(draft.problem.channels[index].quantity);
        remedies.push_back(file.file.missing_unit(file.file.heads()[static_cast<std::size_t>(column.column)], wanted));
        requests.push_back({.column = column.column,
                            .name = column.name,
                            .wanted = wanted,
                            .purpose = Purpose::measured,
                            .missing_unit = remedies.back()});
        channels.push_back(index);
    }
    const std::vector<std::vector<double>> read = file.file.read(requests, mistakes);
    if (file.time.empty()) {
        return;
    }
    const Samples samples = samples_within(file, draft.problem.settings);
    run.time = samples.of(file.time);
    for (std::size_t i = 0; i < read.size(); ++i) {
        MeasuredSeries series{.channel = channels[i], .value = samples.of(read[i])};
        if (std::all_of(series.value.begin(), series.value.end(), [](double v) { return std::isnan(v); })) {
            const Head& head = file.file.heads()[static_cast<std::size_t>(requests[i].column)];
            mistakes.add(head.place, fmt::format("{} has no value in the run", requests[i].name),
                         fmt::format("leave the column out: ignore = [\"{}\"]", head.heading.name));
        } else {
            run.series.push_back(std::move(series));
        }
    }
}

/// Columns that the model does not use, where they are numbers.
void read_unused(const RunFile& file, const solver::Settings& settings, Mistakes& mistakes, MeasuredRun& run) {
    std::vector<ColumnRequest> requests;
    for (const int column : file.columns.unused) {
        requests.push_back({.column = column,
                            .name = file.file.heads()[static_cast<std::size_t>(column)].heading.name,
                            .wanted = {.unit = "1"},
                            .purpose = Purpose::unused});
    }
    std::vector<std::vector<double>> read = file.file.read(requests, mistakes);
    if (file.time.empty()) {
        return;
    }
    const Samples samples = samples_within(file, settings);
    for (std::size_t i = 0; i < read.size(); ++i) {
        std::vector<double> value = samples.of(read[i]);
        if (std::any_of(value.begin(), value.end(), [](double v) { return std::isfinite(v); })) {
            const Heading& heading = file.file.heads()[static_cast<std::size_t>(requests[i].column)].heading;
            run.unused.push_back({.name = heading.name, .unit = heading.unit.value_or(""), .value = std::move(value)});
        }
    }
}

/// Numbers of the run with their uncertainty. One of the run's own without uncertainty is a mistake; one of the case
/// may stand there only to be shown.
void read_numbers(const Draft& draft, const Node& document, const RunTable& table, Mistakes& mistakes,
                  MeasuredRun& run) {
    const Node* list = document.find("measured");
    const bool own = table.table != nullptr && table.table->find("measured") != nullptr;
    const std::vector<solver::Measured>& numbers = draft.problem.measured;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const solver::Measured& number = numbers[i];
        const int channel = find_channel(draft.problem, number.channel);
        if (channel < 0) {
            continue;
        }
        const auto index = static_cast<std::size_t>(channel);
        const std::optional<double> sd =
            number.uncertainty ? number.uncertainty : draft.problem.channels[index].standard_deviation;
        if (sd) {
            run.numbers.push_back({.channel = index,
                                   .time = number.time,
                                   .value = 0.5 * (number.low + number.high),
                                   .standard_deviation = *sd,
                                   .source = number.source});
        } else if (own) {
            const Place place = list != nullptr && i < list->items.size() ? list->items[i].place : table.place;
            mistakes.add(place, fmt::format("the number of {} has no uncertainty", number.channel),
                         fmt::format("add uncertainty = {}, its standard uncertainty",
                                     spell_example(wanted_deviation(draft.problem.channels[index].quantity))));
        }
    }
}

/// A run against which nothing can be held is of no use.
void require_readings(const MeasuredRun& run, const RunTable& table, const RunFile* file,
                      const std::vector<std::string>& sensors, Mistakes& mistakes) {
    const bool has_column = file != nullptr && std::any_of(file->columns.used.begin(), file->columns.used.end(),
                                                           [](const UsedColumn& column) { return column.is_sensor; });
    if (has_column || !run.numbers.empty() || (table.file && file == nullptr)) {
        return;
    }
    const std::string known =
        sensors.empty() ? "the case has no [[sensor]]; add one" : fmt::format("the sensors are {}", listed(sensors));
    if (file == nullptr) {
        mistakes.add(table.place, fmt::format("the run {} measures nothing", table.name),
                     fmt::format("give it a file, or measured = [{{ channel = \"{}\", value = \"...\", uncertainty = "
                                 "\"...\" }}]",
                                 sensors.empty() ? "..." : sensors.front()));
        return;
    }
    const Place place = table.place.file >= 0 ? table.place : Place{.file = file->file.number()};
    mistakes.add(
        place, fmt::format("no column of the file is a sensor of the case: the run {} measures nothing", table.name),
        fmt::format("map one: columns = {{ T = \"{}\" }}; {}", sensors.empty() ? "..." : sensors.front(), known));
}

}  // namespace

std::vector<std::string> unique(const std::vector<std::string>& sentences) {
    std::vector<std::string> once;
    for (const std::string& sentence : sentences) {
        if (std::find(once.begin(), once.end(), sentence) == once.end()) {
            once.push_back(sentence);
        }
    }
    return once;
}

Runs read_runs(const Node& document, const std::string& name, const std::vector<std::filesystem::path>& data,
               Mistakes& mistakes) {
    Runs into;
    std::vector<RunTable> tables;
    {
        Section root(document, "the case", mistakes);
        root.forgive();  // its keys are told by the readers below
        tables = read_run_tables(root, name, data);
    }
    const bool measured = !data.empty() || document.find("run") != nullptr;
    const std::vector<std::string> sensors = sensor_names(document);
    const std::vector<std::string> run_names = measured ? names_of(tables) : std::vector<std::string>{};
    std::deque<Node> documents;  // drafts point into them
    for (const RunTable& table : tables) {
        Node& merged = documents.emplace_back(document);
        if (table.table != nullptr) {
            lay_over(merged, *table.table, tables_of_a_run);
        }
        std::optional<RunFile> file = table.file ? open_run_file(table, sensors, mistakes) : std::nullopt;
        if (table.file && !file) {
            table.keys->forgive();
        }
        Draft draft;
        draft.problem.name = name;
        if (measured) {
            draft.run = read_run_inputs(table, file ? &*file : nullptr, mistakes);
        }
        Section root(merged, "the case", mistakes);
        root.know({"include"});
        read_tables(root, draft);
        root.know({"run", "data", "parameter", "identify"});
        MeasuredRun run;
        run.name = table.name;
        run.file = table.file ? table.file->generic_string() : "";
        if (file) {
            read_series(*file, draft, mistakes, run);
            read_unused(*file, draft.problem.settings, mistakes, run);
        }
        read_numbers(draft, merged, table, mistakes, run);
        if (measured) {
            require_readings(run, table, file ? &*file : nullptr, sensors, mistakes);
        }
        if (documents.size() == 1) {
            read_parameters(root, draft, run_names, into.experiment.parameters);
            read_identify(root, into.experiment);
            into.problem = draft.problem;
        }
        run.problem = std::move(draft.problem);
        into.experiment.runs.push_back(std::move(run));
    }
    for (const RunTable& table : tables) {
        table.keys->complain(mistakes);
    }
    return into;
}

}  // namespace tiretherm::cases
