#include "hidden_effects/exam_sitting.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "hidden_effects/made_up_bench.hpp"

namespace hidden_effects {

namespace {

namespace diagnosis = tiretherm::diagnosis;

Mark sit_one(const Sheet& sheet, double interval) {
    Mark failed{.kind = sheet.kind,
                .seed = sheet.seed,
                .sigma = hides_nothing(sheet.kind) ? 0.0 : sheet.sigma,
                .answer = "no paper",
                .verdict = {},
                .first = "failed",
                .set = {},
                .false_alarm = hides_nothing(sheet.kind)};
    try {
        const Paper paper = draw_paper(sheet.kind, sheet.sigma, sheet.seed, interval);
        failed.answer = answer_of(paper);
        const tiretherm::cases::Experiment experiment = read_paper(paper);
        return mark_of(paper, diagnosis::diagnose(experiment, diagnosis::observe(experiment), {.plan_next = false}));
    } catch (const std::exception& failure) {
        failed.verdict = failure.what();
        return failed;
    }
}

}  // namespace

void add_sheets(std::vector<Sheet>& sheets, Kind kind, double sigma, std::uint64_t first_seed, int count) {
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
        sheets.push_back({.kind = kind, .sigma = sigma, .seed = first_seed + i});
    }
}

tiretherm::cases::Experiment read_paper(const Paper& paper) {
    // UDUNITS parses with variables of the whole process.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    return read_with(practice_case(), paper.logs);
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
