#include "hidden_effects/exam/exam_sitting.hpp"

#include <atomic>
#include <ctime>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "input/measurements/measured_bench.hpp"

namespace hidden_effects {

namespace {

namespace diagnosis = tiretherm::diagnosis;

double processor_seconds() { return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC); }

Mark sit_one(const Sheet& sheet, double interval) {
    Mark failed{.bench = sheet.rig->name,
                .kind = sheet.kind,
                .seed = sheet.seed,
                .sigma = hides_nothing(sheet.kind) ? 0.0 : sheet.sigma,
                .answer = "no paper",
                .verdict = {},
                .first = "failed",
                .set = {},
                .false_alarm = hides_nothing(sheet.kind)};
    try {
        const double begin = processor_seconds();
        const Paper paper = draw_paper(sheet.kind, sheet.sigma, sheet.seed, interval, *sheet.rig);
        failed.answer = answer_of(paper);
        const double drawn = processor_seconds();
        const diagnosis::Diagnosis found = diagnose_paper(paper, {.plan_next = false});
        const double diagnosed = processor_seconds();
        Mark mark = mark_of(paper, found);
        mark.think_seconds = diagnosed - drawn;
        mark.draw_seconds = drawn - begin + processor_seconds() - diagnosed;
        return mark;
    } catch (const std::exception& failure) {
        failed.verdict = failure.what();
        return failed;
    }
}

}  // namespace

void add_sheets(std::vector<Sheet>& sheets, Kind kind, double sigma, std::uint64_t first_seed, int count,
                const Rig& rig) {
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
        sheets.push_back({.kind = kind, .sigma = sigma, .seed = first_seed + i, .rig = &rig});
    }
}

tiretherm::input::Experiment read_paper(const Paper& paper, int finer) {
    // UDUNITS parses with variables of the whole process.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    namespace cases = tiretherm::input;
    const input::Written scratch;
    std::vector<std::filesystem::path> data;
    for (const std::vector<Column>& log : paper.logs) {
        data.push_back(scratch.add("run" + std::to_string(data.size() + 1) + ".csv", written(log)));
    }
    input::ExperimentReading reading = input::read_experiment(
        input::source_folder() / "cases/practice" / paper.runs.rig->case_file, data, input::ReadMode::measured, finer);
    if (!reading.experiment) {
        throw std::runtime_error(input::error_report(reading));
    }
    return std::move(*reading.experiment);
}

diagnosis::Diagnosis diagnose_paper(const Paper& paper, diagnosis::DiagnosisChoice choice) {
    const tiretherm::input::Experiment experiment = read_paper(paper);
    std::optional<tiretherm::input::Experiment> finer;
    if (experiment.runs.front().problem.mesh.kind != "two_node") {
        finer = read_paper(paper, 2);
        choice.finer = &*finer;
    }
    return diagnosis::diagnose(experiment, diagnosis::observe(experiment), choice);
}

std::vector<Mark> sit(const std::vector<Sheet>& sheets, int threads, double interval,
                      const std::function<void(const Mark&)>& told) {
    std::vector<Mark> marks(sheets.size());
    std::atomic<std::size_t> next{0};
    std::mutex telling;
    const auto work = [&] {
        for (std::size_t i = next++; i < sheets.size(); i = next++) {
            marks[i] = sit_one(sheets[i], interval);
            if (told) {
                const std::scoped_lock lock(telling);
                told(marks[i]);
            }
        }
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) {
        others.emplace_back(work);
    }
    work();
    others.clear();  // waits for them
    return marks;
}

}  // namespace hidden_effects
