#include "cases/experiment.hpp"

#include "cases/document.hpp"
#include "cases/runs.hpp"

namespace tiretherm::cases {

ExperimentReading read_experiment(const std::filesystem::path& file, const std::vector<std::filesystem::path>& data,
                                  Occasion occasion) {
    Mistakes mistakes;
    ExperimentReading reading;
    Runs runs;
    if (const std::optional<Node> document = read_document(file, mistakes)) {
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

}  // namespace tiretherm::cases
