// SPDX-License-Identifier: BSD-3-Clause
// The text summary of a study: hottest temperatures over its grid, probabilities with intervals, regression and failed
// runs.

#include <algorithm>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "post/report/page.hpp"
#include "post/report/table.hpp"
#include "post/study/study_drivers_text.hpp"
#include "post/study/study_summary.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t most_columns = 9;
constexpr std::size_t most_rows = 24;

std::string plural(std::size_t n, const char* word) { return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s"); }

/// All that differs between runs: a run's own values.
std::string values_of(const StudyRecord& study, std::size_t run) {
    std::string text;
    for (const StudyColumn& column : study.columns) {
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", column.key, column.texts[run]);
    }
    return text;
}

std::string hottest_text(const StudyRecord& study, std::size_t point) {
    const std::vector<double> hottest = hottest_at(study, point);
    return hottest.empty() ? std::string("failed") : fmt::format("{:.1f}", quantile(hottest, 0.5));
}

/// Rows: the first side of the grid, columns: the second one. Empty where a page would not hold it.
std::string grid_text(const StudyRecord& study) {
    if (study.sides.size() != 2 || study.sides[0] > most_rows || study.sides[1] > most_columns) {
        return {};
    }
    const auto value = [&](std::size_t side, std::size_t point) {
        const StudyColumn& column = study.columns[side];
        const std::size_t run = point * study.samples;
        return column.is_number ? fmt::format("{:.6g}", column.numbers[run]) : column.texts[run];
    };
    Table table(std::vector<bool>(study.sides[1] + 1, false));
    std::vector<std::string> head{""};
    for (std::size_t j = 0; j < study.sides[1]; ++j) {
        head.push_back(value(1, j));
    }
    table.add(head);
    for (std::size_t i = 0; i < study.sides[0]; ++i) {
        std::vector<std::string> row{value(0, i * study.sides[1])};
        for (std::size_t j = 0; j < study.sides[1]; ++j) {
            row.push_back(hottest_text(study, i * study.sides[1] + j));
        }
        table.add(row);
    }
    return fmt::format("  down: {}; across: {}\n", study.columns[0].heading(), study.columns[1].heading()) +
           table.text(2);
}

/// A line for each point: a curve, or what samples give.
std::string points_text(const StudyRecord& study) {
    if (study.points() > most_rows) {
        return {};
    }
    const bool judged = study.is_sampled && study.critical;
    Table table({true, false, false, false, true});
    if (study.is_sampled) {
        table.add({"", "5 %", "median", "95 %",
                   judged ? fmt::format("above {:.6g} degC", solver::celsius(*study.critical)) : ""});
    }
    for (std::size_t point = 0; point < study.points(); ++point) {
        const std::vector<double> hottest = hottest_at(study, point);
        const std::string name = study.sides.empty() ? plural(study.samples, "sample") : point_text(study, point);
        if (!study.is_sampled || hottest.empty()) {
            table.add({name, "", hottest_text(study, point), "", ""});
            continue;
        }
        std::string passing;
        if (judged) {
            const Chance c = passes_critical(study, point);
            passing = fmt::format("{:.1f} %, 95 % interval {:.1f} to {:.1f} % ({} of {})", 100.0 * c.share,
                                  100.0 * c.low, 100.0 * c.high, c.times, c.of);
        }
        table.add({name, fmt::format("{:.1f}", quantile(hottest, 0.05)), fmt::format("{:.1f}", quantile(hottest, 0.5)),
                   fmt::format("{:.1f}", quantile(hottest, 0.95)), passing});
    }
    return table.text(2);
}

/// The straight line at each point of the grid, where a page holds them.
std::string drivers_text(const StudyRecord& study) {
    std::string text;
    for (std::size_t point = 0; point < study.points() && study.points() <= most_rows; ++point) {
        const std::string line =
            study.is_sampled ? regression_text(regression(study, point), study.critical) : std::string();
        text += line.empty() || study.sides.empty() ? line : fmt::format("  {}\n{}", point_text(study, point), line);
    }
    return text;
}

std::string extremes_text(const StudyRecord& study) {
    const auto hotter = [](const StudyOutcome& a, const StudyOutcome& b) {
        return a.ok() != b.ok() ? !a.ok() : a.hottest < b.hottest;
    };
    const auto hottest = std::max_element(study.outcomes.begin(), study.outcomes.end(), hotter);
    if (!hottest->ok()) {
        return {};
    }
    const auto colder = [](const StudyOutcome& a, const StudyOutcome& b) {
        return a.ok() != b.ok() ? a.ok() : a.hottest < b.hottest;
    };
    const auto coldest = std::min_element(study.outcomes.begin(), study.outcomes.end(), colder);
    std::string text;
    for (const auto& [name, found] : {std::pair("hottest", hottest), std::pair("coldest", coldest)}) {
        const auto run = static_cast<std::size_t>(found - study.outcomes.begin());
        const std::string zone = found->hottest_zone.empty() ? "" : ", " + found->hottest_zone;
        text += wrap(
            fmt::format("{} run: {:.1f} degC in {}{} at {:.6g} s; run {}: {}", name, solver::celsius(found->hottest),
                        found->hottest_layer, zone, found->hottest_time, run + 1, values_of(study, run)),
            2);
    }
    if (study.critical && !study.is_sampled) {
        const auto passing = static_cast<std::size_t>(
            std::count_if(study.outcomes.begin(), study.outcomes.end(),
                          [&](const StudyOutcome& run) { return run.ok() && run.hottest > *study.critical; }));
        text += fmt::format("  {} of {} runs pass {:.6g} degC\n", passing,
                            study.outcomes.size() - study.failed().size(), solver::celsius(*study.critical));
    }
    return text;
}

std::string failures_text(const StudyRecord& study) {
    std::vector<std::string> sentences;
    for (const std::size_t run : study.failed()) {
        sentences.push_back(
            fmt::format("run {} ({}): {}", run + 1, values_of(study, run), study.outcomes[run].failure));
    }
    constexpr std::size_t most = 10;
    if (sentences.size() > most) {
        const std::size_t more = sentences.size() - most;
        sentences.resize(most);
        sentences.push_back(fmt::format("and {} more; all are in the tables", more));
    }
    return paragraphs(sentences);
}

}  // namespace

std::string study_text(const StudyRecord& study, const StudyCall& call, bool bold) {
    Page page(bold);
    const std::size_t n = study.outcomes.size();
    page.add(page.strong(study.title) + "\n");
    page.add(fmt::format("  {} of {}{}\n", plural(n, "run"), study.case_name,
                         study.is_sampled ? fmt::format(", {} at each of {}", plural(study.samples, "sample"),
                                                        plural(study.points(), "point"))
                                          : ""));
    const std::string grid = grid_text(study);
    page.add(study.is_sampled ? "Hottest temperature [degC], median of the samples" : "Hottest temperature [degC]",
             grid);
    if (grid.empty() || study.is_sampled) {
        page.add(study.is_sampled ? "Hottest temperature [degC] of the samples" : "Hottest temperature [degC]",
                 points_text(study));
    }
    page.add("What drives it", drivers_text(study));
    page.add("Extremes", extremes_text(study));
    page.add("Warnings", paragraphs(study.warnings));
    page.add("Runs that failed", failures_text(study));
    const std::size_t made = n - call.kept;
    std::string cost = fmt::format("  {} kept, {} made now in {:.1f} s", call.kept, made, call.seconds);
    if (made > 0) {
        cost +=
            fmt::format(" ({:.3f} s a run, {} at a time)", call.run_seconds / static_cast<double>(made), call.threads);
    }
    cost += "\n";
    if (call.outdated > 0) {
        cost += fmt::format("  {} of another build of tiretherm are not used\n", plural(call.outdated, "run"));
    }
    page.add("Cost", cost);
    std::string files;
    for (const std::filesystem::path& file : call.files) {
        files += fmt::format("  {}\n", file.string());
    }
    page.add("Files", files);
    return page.text();
}

}  // namespace tiretherm::post
