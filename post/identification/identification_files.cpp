// SPDX-License-Identifier: BSD-3-Clause
// The files of a fit: the case with the fitted values; samples, parameters and laws as tables; a plan as JSON.
#include <fmt/format.h>

#include "input/parameters/overlay.hpp"
#include "post/comparison/corner_sections.hpp"
#include "post/identification/fitted_laws.hpp"
#include "post/identification/identification_report.hpp"
#include "post/page/html_page.hpp"
#include "post/report/csv.hpp"
#include "post/report/file.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

std::string samples_csv(const IdentificationRecord& record) {
    Csv csv({"time [s]", "run", "channel", "unit", "measured", "case", "fitted"});
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    for (std::size_t i = 0; i < record.observations.rows.size(); ++i) {
        const Observations::Row& row = record.observations.rows[i];
        if (row.image >= 0) {
            continue;  // camera frames have pictures and a table of their own
        }
        const auto k = static_cast<Eigen::Index>(i);
        const solver::ShownUnit unit = solver::shown_unit(channels[row.channel].quantity);
        csv.row(Digits{record.observations.times[row.run][row.time], 10}, record.experiment.runs[row.run].name,
                channels[row.channel].name, unit.name, Digits{unit.value(record.observations.measured[k]), 8},
                Digits{unit.value(record.result.before[k]), 8}, Digits{unit.value(record.result.after[k]), 8});
    }
    return csv.text();
}

std::string toml(const IdentificationRecord& record, const std::filesystem::path& directory) {
    const input::Experiment& experiment = record.experiment;
    const Simulator simulator(experiment, record.observations);
    std::vector<solver::Problem> fitted;
    std::vector<input::OverlaidRun> runs;
    fitted.reserve(experiment.runs.size());
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        fitted.push_back(simulator.problem(r, record.result.values));
        runs.push_back(
            {.name = experiment.runs[r].name,
             .problem = &fitted.back(),
             .file = record.data.empty() ? std::filesystem::path() : std::filesystem::path(experiment.runs[r].file),
             .recording = experiment.runs[r].recording,
             .corner = experiment.runs[r].corner});
    }
    std::string runs_named;
    for (const input::MeasuredRun& run : experiment.runs) {
        runs_named += (runs_named.empty() ? "" : ", ") + run.name;
    }
    return input::overlay_text({.original = record.case_file,
                                .before = &experiment.runs.front().problem,
                                .fitted = &fitted.front(),
                                .parameters = experiment.parameters,
                                .runs = std::move(runs),
                                .remarks = {fmt::format("tiretherm identify: {}, fitted to {}",
                                                        experiment.runs.front().problem.title, runs_named)}},
                               directory);
}

}  // namespace

std::vector<std::string> identification_names() {
    std::vector<std::string> names = page_names();
    names.insert(names.end(), {"identified.toml", "identify.csv", "parameters.csv", "laws.csv", laps_name});
    return names;
}

std::vector<std::string> plan_names() {
    std::vector<std::string> names = page_names();
    names.push_back("plan.json");
    return names;
}

std::vector<std::filesystem::path> write_identification(const IdentificationRecord& record,
                                                        const std::filesystem::path& directory,
                                                        const std::filesystem::path& home) {
    create_folder(directory);
    const std::filesystem::path& there = home.empty() ? directory : home;
    if (record.planned) {
        const std::filesystem::path file = directory / "plan.json";
        replace_file(file, json_text(identification_report(record, {there / "plan.json"}).data));
        return {file};
    }
    std::vector<std::filesystem::path> files;
    const auto write = [&](const char* name, const std::string& content) {
        files.push_back(directory / name);
        replace_file(files.back(), content);
    };
    write("identified.toml", toml(record, there));
    write("identify.csv", samples_csv(record));
    write("parameters.csv", parameters_csv(record));
    if (const FittedLaws laws = fitted_laws(record); !laws.laws.empty()) {
        write("laws.csv", laws_csv(laws));
    }
    if (const std::vector<LapRow> rows = observed_lap_rows(record.experiment, record.observations, record.result.after);
        have_laps_or_corners(rows)) {
        write(laps_name, laps_csv(rows));
    }
    return files;
}

}  // namespace tiretherm::post
