// SPDX-License-Identifier: BSD-3-Clause
// Reads the case file with its runs; a caller that needs another grid lets it change [mesh].

#include "input/runs/read_experiment.hpp"

#include "input/runs/runs.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

std::vector<std::string> not_driven(const Experiment& experiment) {
    std::vector<std::string> sentences;
    for (const MeasuredRun& run : experiment.runs) {
        for (const std::string& sentence : run.not_driven) {
            sentences.push_back((run.recording.empty() ? run.name : run.recording) + ": " + sentence);
        }
    }
    return unique(sentences);
}

void CaseFindings::take(const InputErrors& said) {
    errors = said.in_order();
    warnings = render(said.warnings(), corners.size());
    files = said.files();
}

ExperimentReading read_experiment(const std::filesystem::path& file, const std::vector<std::filesystem::path>& data,
                                  ReadMode mode, const MeshChange& change, const std::vector<ColumnChange>& columns) {
    InputErrors errors;
    ExperimentReading reading;
    Runs runs;
    if (std::optional<TomlValue> document = read_document(file, errors)) {
        // Before anything is read, so that all that refers to the mesh is read for the changed one.
        if (TomlValue* mesh = document->find("mesh")) {
            change_mesh(*mesh, change);
        }
        std::vector<std::filesystem::path> files = data;
        change_columns(*document, columns, files);
        runs = read_runs(*document, case_name(file), files, mode, errors);
        const bool has_runs = mode == ReadMode::planned || !data.empty() || document->find("run") != nullptr;
        if (!has_runs && errors.count() == 0 && runs.experiment.runs.front().numbers.empty()) {
            errors.add(document->place, "the case has no measured run",
                       "add [[run]] with file = \"....csv\", or give files beside the case: --data run.csv");
        }
    }
    static_cast<CaseFindings&>(reading) = runs;
    reading.take(errors);
    if (reading.errors.empty()) {
        reading.experiment = std::move(runs.experiment);
    }
    return reading;
}

}  // namespace tiretherm::input
