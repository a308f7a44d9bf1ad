// SPDX-License-Identifier: BSD-3-Clause
// Keeps the merged document of the case and the texts of its files, and makes problems of it with changed values for the
// uncertainty of hot spots.

#include "input/runs/hot_spots.hpp"

#include <cmath>

#include "input/parameters/study_value.hpp"
#include "input/runs/runs.hpp"

namespace tiretherm::input {

std::optional<HotSpotCase> HotSpotCase::read(const std::filesystem::path& file, const std::string& run) {
    HotSpotCase found;
    found.run_ = run;
    std::optional<TomlValue> document = read_document(file, found.errors_);
    if (!document || document->find("critical") == nullptr) {
        return std::nullopt;
    }
    found.document_ = std::move(*document);
    found.name_ = case_name(file);
    InputErrors errors = found.errors_;
    const Runs runs = read_runs(found.document_, found.name_, {}, ReadMode::measured, errors);
    for (const solver::FreeParameter& number : runs.experiment.parameters) {
        if (std::isfinite(number.standard_deviation)) {
            found.known.push_back(number);
        }
    }
    TomlTable root(found.document_, "the case", errors);
    root.allow_unknown_keys();
    found.critical = read_critical(root, runs.problem_of(run));
    found.uncertain = read_uncertain(root);
    found.errors_ = std::move(errors);  // with the texts of all files, so that no variant opens them again
    return found;
}

std::optional<solver::Problem> HotSpotCase::problem_of(const TomlValue& document) const {
    InputErrors errors = errors_;
    const Runs runs = read_runs(document, name_, {}, ReadMode::measured, errors);
    return errors.count() == 0 ? std::optional(runs.problem_of(run_)) : std::nullopt;
}

std::optional<solver::Problem> HotSpotCase::moved(const UncertainKey& uncertain_key, double deviations) const {
    TomlValue document = document_;
    if (!uncertain_key.alternative.empty()) {
        std::vector<std::string_view> names;
        for (const Entry& entry : uncertain_key.tables.entries) {
            names.push_back(entry.key);
        }
        override_tables(document, uncertain_key.tables, names);
        return problem_of(document);
    }
    InputErrors errors = errors_;
    const double number = uncertain_key.number + deviations * uncertain_key.standard_deviation;
    const StudyValue value = study_value(number, uncertain_key.unit, false, uncertain_key.value.place);
    if (!uncertain_key.path.set(document, value.node, errors)) {
        return std::nullopt;
    }
    return problem_of(document);
}

}  // namespace tiretherm::input
