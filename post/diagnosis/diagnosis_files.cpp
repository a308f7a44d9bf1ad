// SPDX-License-Identifier: BSD-3-Clause
// The files of a diagnosis: the extended case, residuals and missing heat as tables, diagnosis.json.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/parameters/overlay.hpp"
#include "input/runs/reader.hpp"
#include "post/comparison/corner_sections.hpp"
#include "post/diagnosis/diagnosis_report.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/page/html_page.hpp"
#include "post/report/csv.hpp"
#include "post/report/file.hpp"
#include "post/report/table.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Simulated less measured, in standard deviations of independent noise.
Eigen::VectorXd whitened(const DiagnosisRecord& record, const Eigen::VectorXd& simulated) {
    Eigen::MatrixXd rest = simulated - record.observations.measured;
    whiten(record.observations.blocks, {.channels = record.result.noise, .weight = {}}, rest);
    return rest.col(0);
}

std::string samples_csv(const DiagnosisRecord& record) {
    Csv csv({"time [s]", "run", "channel", "unit", "measured", "base", "extended", "whitened_base [1]",
             "whitened_extended [1]"});
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    const Eigen::VectorXd base = whitened(record, record.result.base);
    const Eigen::VectorXd extended = whitened(record, record.result.extended);
    for (std::size_t i = 0; i < record.observations.rows.size(); ++i) {
        const Observations::Row& row = record.observations.rows[i];
        const auto k = static_cast<Eigen::Index>(i);
        const solver::ShownUnit unit = solver::shown_unit(channels[row.channel].quantity);
        csv.row(Digits{record.observations.times[row.run][row.time], 10}, record.experiment.runs[row.run].name,
                channels[row.channel].name, unit.name, Digits{unit.value(record.observations.measured[k]), 8},
                Digits{unit.value(record.result.base[k]), 8}, Digits{unit.value(record.result.extended[k]), 8},
                Digits{base[k], 5}, Digits{extended[k], 5});
    }
    return csv.text();
}

std::string missing_heat_csv(const DiagnosisRecord& record) {
    Csv csv({"run", "place", "from [s]", "to [s]", "watts [W]", "low [W]", "high [W]", "sigma [1]"});
    for (const MissingHeat& missing : record.result.missing_heat) {
        csv.row(record.experiment.runs[missing.run].name, missing.place, Digits{missing.from, 10},
                Digits{missing.to, 10}, Digits{missing.watts, 6}, Digits{missing.low(), 6}, Digits{missing.high(), 6},
                Digits{missing.sigma(), 5});
    }
    return csv.text();
}

/// A sentence as comment lines.
std::vector<std::string> lines_of(const std::string& sentence) {
    std::vector<std::string> lines;
    const std::string text = wrap(sentence, 0);
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = text.find('\n', from);
        lines.push_back(text.substr(from, to - from));
        from = to + 1;
    }
    return lines;
}

std::string extended_toml(const DiagnosisRecord& record, const std::filesystem::path& directory) {
    const input::Experiment& model = *record.result.extended_model;
    const Simulator simulator(model, record.observations);
    std::vector<solver::Problem> problems;
    std::vector<input::OverlaidRun> runs;
    problems.reserve(model.runs.size());
    for (std::size_t r = 0; r < model.runs.size(); ++r) {
        problems.push_back(simulator.problem(r, record.result.extended_values));
        // The diagnosis sharpens the steps for itself; the case goes on with its own.
        problems.back().settings = record.experiment.runs[r].problem.settings;
        runs.push_back(
            {.name = model.runs[r].name,
             .problem = &problems.back(),
             .file = record.data.empty() ? std::filesystem::path() : std::filesystem::path(model.runs[r].file),
             .recording = model.runs[r].recording,
             .corner = model.runs[r].corner});
    }
    std::vector<std::string> remarks{"tiretherm diagnose"};
    for (std::string& line : lines_of(reason_of(record))) {
        remarks.push_back(std::move(line));
    }
    std::vector<input::ColumnChange> columns;
    for (const DataFault& fault : record.result.data_faults) {
        std::ranges::copy(fault.changes, std::back_inserter(columns));
    }
    return input::overlay_text({.original = record.case_file,
                                .before = &record.experiment.runs.front().problem,
                                .fitted = &problems.front(),
                                .parameters = model.parameters,
                                .runs = std::move(runs),
                                .remarks = std::move(remarks),
                                .user_effects = record.result.extended_user_effects,
                                .mesh = record.result.extended_mesh,
                                .columns = std::move(columns)},
                               directory);
}

}  // namespace

std::vector<std::string> diagnosis_names() {
    std::vector<std::string> names = page_names();
    names.insert(names.end(), {"diagnosis.json", "extended.toml", "residuals.csv", "missing_heat.csv", laps_name});
    return names;
}

std::vector<std::filesystem::path> write_diagnosis(DiagnosisRecord& record, const std::filesystem::path& directory,
                                                   const std::filesystem::path& home) {
    create_folder(directory);
    const std::filesystem::path& there = home.empty() ? directory : home;
    std::vector<std::filesystem::path> files{directory / "diagnosis.json"};
    const std::filesystem::path extended = directory / "extended.toml";
    if (record.result.extended_model) {
        files.push_back(extended);
        const std::string text = extended_toml(record, there);
        replace_file(extended, text);
        if (const input::Reading reading = input::read_case(there / "extended.toml", text); !reading.problem) {
            record.warnings.push_back("the extended case cannot be run as it is: " + reading.errors.front().what);
        }
    } else {
        std::error_code error;
        std::filesystem::remove(extended, error);  // of an earlier diagnosis: it would pass for this one's
    }
    files.push_back(directory / "residuals.csv");
    replace_file(files.back(), samples_csv(record));
    if (!record.result.missing_heat.empty()) {
        files.push_back(directory / "missing_heat.csv");
        replace_file(files.back(), missing_heat_csv(record));
    }
    const Diagnosis& result = record.result;
    if (const std::vector<LapRow> rows =
            observed_lap_rows(record.experiment, record.observations,
                              result.extended.size() == result.base.size() ? result.extended : result.base);
        have_laps_or_corners(rows)) {
        files.push_back(directory / laps_name);
        replace_file(files.back(), laps_csv(rows));
    }
    if (record.with_page) {
        std::ranges::copy(page_files(directory), std::back_inserter(files));
    }
    std::vector<std::filesystem::path> named;
    std::ranges::transform(files, std::back_inserter(named),
                           [&](const std::filesystem::path& file) { return there / file.filename(); });
    const Report page = diagnosis_report(record, named);
    replace_file(files.front(), json_text(page.data));
    if (record.with_page) {
        write_page(directory, page, {.kind = "diagnose", .source = record.case_file.string(), .files = record.inputs});
    }
    return files;
}

}  // namespace tiretherm::post
