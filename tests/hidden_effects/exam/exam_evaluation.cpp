// SPDX-License-Identifier: BSD-3-Clause
// Writes a data set as case and logs, diagnoses it and marks it; runs several data sets in parallel.

#include "hidden_effects/exam/exam_evaluation.hpp"

#include <ctime>
#include <exception>
#include <mutex>
#include <optional>

#include "input/measurements/measured_bench.hpp"
#include "mesh/parallel.hpp"

namespace hidden_effects {

namespace {

namespace diagnosis = tiretherm::diagnosis;

double processor_seconds() { return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC); }

Mark evaluate_one(const DataSetSpec& spec, double interval) {
    Mark failed{.bench = spec.rig->name,
                .kind = spec.kind,
                .seed = spec.seed,
                .sigma = hides_nothing(spec.kind) ? 0.0 : spec.sigma,
                .answer = "no data set",
                .verdict = {},
                .first = "failed",
                .set = {},
                .false_alarm = hides_nothing(spec.kind)};
    try {
        const double begin = processor_seconds();
        const ExamDataSet data_set = draw_data_set(spec.kind, spec.sigma, spec.seed, interval, *spec.rig);
        failed.answer = answer_of(data_set);
        const double drawn = processor_seconds();
        const diagnosis::Diagnosis found = diagnose_data_set(data_set, {.only_verdict = true});
        const double diagnosed = processor_seconds();
        Mark mark = mark_of(data_set, found);
        mark.diagnose_seconds = diagnosed - drawn;
        mark.draw_seconds = drawn - begin + processor_seconds() - diagnosed;
        return mark;
    } catch (const std::exception& failure) {
        failed.verdict = failure.what();
        return failed;
    }
}

}  // namespace

void add_specs(std::vector<DataSetSpec>& specs, Kind kind, double sigma, std::uint64_t first_seed, int count,
               const Rig& rig) {
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
        specs.push_back({.kind = kind, .sigma = sigma, .seed = first_seed + i, .rig = &rig});
    }
}

tiretherm::input::Experiment read_data_set(const ExamDataSet& data_set, int finer) {
    // UDUNITS parses with variables of the whole process.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    namespace input = tiretherm::input;
    const input::Written scratch;
    std::vector<std::filesystem::path> data;
    for (const std::vector<Column>& log : data_set.logs) {
        data.push_back(scratch.add("run" + std::to_string(data.size() + 1) + ".csv", written(log)));
    }
    input::ExperimentReading reading =
        input::read_experiment(input::source_folder() / "cases/practice" / data_set.runs.rig->case_file, data,
                               input::ReadMode::measured, {.finer = finer});
    if (!reading.experiment) {
        throw std::runtime_error(input::error_report(reading));
    }
    return std::move(*reading.experiment);
}

diagnosis::Diagnosis diagnose_data_set(const ExamDataSet& data_set, diagnosis::DiagnosisOptions choice) {
    const tiretherm::input::Experiment experiment = read_data_set(data_set);
    std::optional<tiretherm::input::Experiment> finer;
    if (!experiment.runs.front().problem.mesh.is_lumped()) {
        finer = read_data_set(data_set, 2);
        choice.finer = &*finer;
    }
    return diagnosis::diagnose(experiment, diagnosis::observe(experiment), choice);
}

std::vector<Mark> evaluate(const std::vector<DataSetSpec>& specs, int threads, double interval,
                           const std::function<void(const Mark&)>& on_marked) {
    std::vector<Mark> marks(specs.size());
    std::mutex reporting;
    const auto mark = [&](std::size_t i) {
        marks[i] = evaluate_one(specs[i], interval);
        if (on_marked) {
            const std::scoped_lock lock(reporting);
            on_marked(marks[i]);
        }
    };
    tiretherm::in_parallel(specs.size(), mark, static_cast<unsigned>(threads));
    return marks;
}

}  // namespace hidden_effects
