// SPDX-License-Identifier: BSD-3-Clause
// The files of a run: every chosen format takes every row.
#include "post/run/run_files.hpp"

#include <system_error>
#include <utility>

#include "post/laps/computed_inputs.hpp"
#include "post/laps/heat_by_lap.hpp"
#include "post/report/file.hpp"
#include "post/run/run_sections.hpp"
#include "post/run/tire_laws.hpp"

namespace tiretherm::post {

RunFiles::RunFiles(std::filesystem::path directory, const solver::Problem& problem, const Provenance& provenance,
                   const std::set<std::string>& switched)
    : directory_(create_folder(std::move(directory))),
      problem_(problem),
      with_page_(!switched.contains("report")),
      fields_(problem) {
    if (with_page_) {
        page_ = page_files(directory_);
    }
    for (const std::string& name : names_in(directory_)) {
        std::error_code ignored;
        std::filesystem::remove(directory_ / name, ignored);
    }
    for (const OutputFormat* format : output_formats()) {
        if (format->use == OutputFormat::Use::always ||
            (format->use == OutputFormat::Use::on_request) == switched.contains(format->name)) {
            outputs_.push_back(format->open({directory_, problem, provenance, history_}));
        }
    }
}

std::vector<std::string> RunFiles::names_in(const std::filesystem::path& directory) {
    std::vector<std::string> names = page_names();
    names.insert(names.end(), {"hot_spots.csv", laps_name, heat_name, inputs_name, stiffness_name, "picture.png",
                               "tread.png"});  // version 0.2: *.png
    for (const OutputFormat* format : output_formats()) {
        const std::vector<std::string> more = format->names_in(directory);
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

void RunFiles::take(const solver::Snapshot& snapshot) {
    history_.take(snapshot);
    if (with_page_) {
        fields_.take(snapshot);
    }
    for (const std::unique_ptr<RunOutput>& output : outputs_) {
        output->take(snapshot);
    }
}

void RunFiles::write_page(const Report& report, const PageOrigin& origin) {
    if (with_page_) {
        post::write_page(directory_, report, origin);
    }
}

void RunFiles::write_hot_spots(const diagnosis::HotSpots& hot_spots) {
    write_hot_spots_csv(tables_.emplace_back(directory_ / "hot_spots.csv"), hot_spots, problem_);
}

void RunFiles::write_tables(const RunRecord& run) {
    if (const std::string stiffness = cornering_stiffness_csv(run.problem); !stiffness.empty()) {
        replace_file(tables_.emplace_back(directory_ / stiffness_name), stiffness);
    }
    if (const std::string inputs = computed_inputs_csv({{run.run, &run.problem}}); !inputs.empty()) {
        replace_file(tables_.emplace_back(directory_ / inputs_name), inputs);
    }
    if (run.laps.size() > 1 && !run.problem.settings.steady) {
        replace_file(tables_.emplace_back(directory_ / laps_name), laps_csv(lap_rows(run)));
        replace_file(tables_.emplace_back(directory_ / heat_name), heat_csv({heat_of(run)}));
    }
}

void RunFiles::finish(const solver::MarchReport& report) {
    if (report.hottest.node >= 0) {
        if (with_page_) {
            fields_.take_hottest(report.hottest.time, report.hottest_field);
        }
        for (const std::unique_ptr<RunOutput>& output : outputs_) {
            output->take_hottest(report.hottest.time, report.hottest_field);
        }
    }
    for (const std::unique_ptr<RunOutput>& output : outputs_) {
        output->finish();
    }
}

std::vector<std::filesystem::path> RunFiles::written() const {
    std::vector<std::filesystem::path> files = page_;
    for (const std::unique_ptr<RunOutput>& output : outputs_) {
        const std::vector<std::filesystem::path> more = output->files();
        files.insert(files.end(), more.begin(), more.end());
    }
    files.insert(files.end(), tables_.begin(), tables_.end());
    return files;
}

}  // namespace tiretherm::post
