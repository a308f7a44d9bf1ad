// SPDX-License-Identifier: BSD-3-Clause
// Compares the run's start and end with the first and last rows of schedules, logs and the run's file.

#include "input/drive/run_span.hpp"

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr double negligible = 1e-6;  ///< s
constexpr double beyond = 1.0;       ///< s, by which a recording may be longer than the schedule that it was made by

}  // namespace

std::string in_minutes(double seconds) {
    return seconds < 600.0 ? fmt::format("{:.4g} s", seconds) : fmt::format("{:.4g} min", seconds / 60.0);
}

double start_of_run(const RunInputs& run, const DrivenSpan& span, double start, std::optional<double> end) {
    const double first = *run.first;
    if (run.drives() || run.part_of_file || !run.start_readings.empty()) {
        return first;
    }
    const std::optional<double> last = end ? end : span.to;
    return last && first > start && first < *last ? start : first;
}

std::vector<std::string> not_driven(const RunInputs& run, const DrivenSpan& span, const solver::Settings& settings) {
    std::vector<std::string> sentences;
    if (!run.first || settings.steady) {
        return sentences;
    }
    const std::string start = fmt::format("the run starts at {} from [initial]", in_minutes(settings.start));
    if (run.part_of_file && run.lead == 0.0 && settings.start > run.file_first + negligible) {
        sentences.push_back(fmt::format("{}; the first {} of the file are not driven", start,
                                        in_minutes(settings.start - run.file_first)));
    }
    const double from = span.from.value_or(settings.start);
    const double to = span.to.value_or(from);
    if (to <= from) {
        return sentences;
    }
    if (settings.start >= to || settings.end <= from) {
        sentences.push_back(fmt::format(
            "the run goes from {} to {}, the schedule of the case from {} to {}: none of it is driven; let both have "
            "one clock",
            in_minutes(settings.start), in_minutes(settings.end), in_minutes(from), in_minutes(to)));
        return sentences;
    }
    if (settings.start > from + negligible) {
        sentences.push_back(
            fmt::format("{}; the first {} of the schedule are not driven", start, in_minutes(settings.start - from)));
    }
    if (settings.end < to - negligible) {
        sentences.push_back(fmt::format("the run ends at {}; the last {} of the schedule are not driven",
                                        in_minutes(settings.end), in_minutes(to - settings.end)));
    }
    if (settings.start < from - beyond) {
        sentences.push_back(fmt::format("the run starts at {}, the schedule at {}: until then its first values hold",
                                        in_minutes(settings.start), in_minutes(from)));
    }
    if (settings.end > to + beyond) {
        sentences.push_back(fmt::format("the run ends at {}, the schedule at {}: from then on its last values hold",
                                        in_minutes(settings.end), in_minutes(to)));
    }
    return sentences;
}

}  // namespace tiretherm::input
