#include "input/measurements/experiment.hpp"

#include "input/text/document.hpp"
#include "input/measurements/runs.hpp"

namespace tiretherm::input {

namespace {

/// Multiplies every number of cells in a table and in the lists within it.
void refine(Node& table, int finer) {
    for (Entry& entry : table.entries) {
        if (entry.key.ends_with("cells") && entry.value.kind == Node::Kind::integer) {
            entry.value.number *= finer;
        }
        refine(entry.value, finer);
    }
    for (Node& item : table.items) {
        refine(item, finer);
    }
}

}  // namespace

ExperimentReading read_experiment(const std::filesystem::path& file, const std::vector<std::filesystem::path>& data,
                                  Occasion occasion, int finer) {
    Mistakes mistakes;
    ExperimentReading reading;
    Runs runs;
    if (std::optional<Node> document = read_document(file, mistakes)) {
        for (Entry& entry : document->entries) {
            if (entry.key == "mesh" && finer > 1) {
                refine(entry.value, finer);
            }
        }
        runs = read_runs(*document, case_name(file), data, occasion, mistakes);
        const bool has_runs = occasion == Occasion::planned || !data.empty() || document->find("run") != nullptr;
        if (!has_runs && mistakes.count() == 0 && runs.experiment.runs.front().numbers.empty()) {
            mistakes.add(document->place, "the case has no measured run",
                         "add [[run]] with file = \"....csv\", or give files beside the case: --data run.csv");
        }
    }
    reading.mistakes = mistakes.in_order();
    reading.warnings = unique(mistakes.warnings());
    reading.findings = std::move(runs.findings);
    if (reading.mistakes.empty()) {
        reading.experiment = std::move(runs.experiment);
    }
    return reading;
}

}  // namespace tiretherm::input
