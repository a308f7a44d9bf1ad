// SPDX-License-Identifier: BSD-3-Clause
// Compares the sets of causes of the runs: a cause that is in all of them, or which runs show it.

#include "post/diagnosis/run_verdicts.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/stage_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Hypotheses of a run that are listed on the page.
constexpr std::size_t most_hypotheses = 3;

/// "a", "a and b", "a, b and c"
std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    }
    return text;
}

std::string name_of_unknown(const UnknownSource& unknown) {
    const std::string what = unknown.sensor ? "an error in the reading of " : "unknown heat at ";
    return what + unknown.place;
}

/// Names of all causes of a run's set, each once, the best hypothesis first.
std::vector<std::string> names_of(const RunVerdict& run) {
    std::vector<std::string> names;
    const auto add = [&](std::string name) {
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(std::move(name));
        }
    };
    for (const std::vector<Cause>& hypothesis : run.hypotheses) {
        for (const Cause& cause : hypothesis) {
            add(name_of(cause));
        }
    }
    if (run.unknown) {
        add(name_of_unknown(*run.unknown));
    }
    return names;
}

/// Those of the best hypothesis alone.
std::vector<std::string> first_names_of(const RunVerdict& run) {
    if (run.hypotheses.empty()) {
        return names_of(run);
    }
    std::vector<std::string> names;
    std::ranges::transform(run.hypotheses.front(), std::back_inserter(names),
                           [](const Cause& cause) { return name_of(cause); });
    return names;
}

bool shows(const RunVerdict& run, const std::string& name) {
    const std::vector<std::string> names = names_of(run);
    return std::ranges::find(names, name) != names.end();
}

std::vector<const RunVerdict*> judged(const DiagnosisRecord& record) {
    std::vector<const RunVerdict*> runs;
    for (const RunVerdict& run : record.by_run.runs) {
        if (run.is_judged()) {
            runs.push_back(&run);
        }
    }
    return runs;
}

std::string verdict_text(const RunVerdict& run) {
    if (!run.status.ok()) {
        return run.status.outcome == solver::Outcome::stopped ? "stopped" : "failed";
    }
    return std::string(word_of(run.verdict)) + (run.stopped == Part::none ? "" : ", stopped");
}

std::string gain_text(const Gain& gain) {
    return !gain.measured ? "-"
                          : fmt::format("{:.0f} % ({:.0f} to {:.0f} %)", 100.0 * gain.removable_removed,
                                        100.0 * gain.low, 100.0 * gain.high);
}

DataTable table_of(const DiagnosisRecord& record) {
    DataTable table;
    for (const RunVerdict& run : record.by_run.runs) {
        bool first = true;
        const auto add = [&](std::string cause, std::string size) {
            table.add({page_only("run", first ? run.name : ""), page_only("verdict", first ? verdict_text(run) : ""),
                       page_only("cause", std::move(cause)), page_only("size", std::move(size)),
                       page_only("held-out gain", right(first ? gain_text(run.gain) : ""))});
            first = false;
        };
        for (std::size_t h = 0; h < std::min(most_hypotheses, run.hypotheses.size()); ++h) {
            for (std::size_t k = 0; k < run.hypotheses[h].size(); ++k) {
                const Cause& cause = run.hypotheses[h][k];
                const char* before = k > 0 ? "with " : h > 0 ? "or " : "";
                add(before + name_of(cause), cause.numbers.empty() ? "" : size_of(cause.numbers.front()));
            }
        }
        if (run.hypotheses.size() > most_hypotheses) {
            add(fmt::format("or {} more", run.hypotheses.size() - most_hypotheses), "");
        }
        if (run.unknown) {
            const solver::ShownUnit unit = unit_of(*run.unknown, record.experiment);
            const double half = unit.difference(0.5 * (run.unknown->high - run.unknown->low));
            const auto show = [&](double si) { return to_its_digits(unit.difference(si), half); };
            add((run.hypotheses.empty() ? "" : "or ") + name_of_unknown(*run.unknown),
                fmt::format("{} {} ({} to {})", show(run.unknown->watts), unit.name, show(run.unknown->low),
                            show(run.unknown->high)));
        }
        if (first) {
            add("", "");
        }
    }
    return table;
}

/// Which runs show causes that others do not. @param shown_by names of runs
std::string difference_of(const std::string& causes, const std::vector<std::string>& shown_by) {
    return fmt::format("{} {} {}.", listed(shown_by), shown_by.size() == 1 ? "alone shows" : "show", causes);
}

std::string left_out_text(const DiagnosisRecord& record) {
    switch (record.by_run.left_out) {
        case LeftOutRuns::none:
            break;
        case LeftOutRuns::stopped_before:
            return "No run was diagnosed alone: it was stopped.";
        case LeftOutRuns::takes_long:
            return "No run was diagnosed alone, because all together took long; --by-run does it.";
        case LeftOutRuns::stopped_after:
            return fmt::format("Stopped after {} of {} runs.", record.by_run.runs.size(),
                               record.experiment.runs.size());
    }
    return "";
}

}  // namespace

std::string agreement_of(const DiagnosisRecord& record) {
    const std::vector<const RunVerdict*> runs = judged(record);
    if (runs.size() < 2) {
        return "";
    }
    const auto in_all = [&](const std::string& name) {
        return std::ranges::all_of(runs, [&](const RunVerdict* run) { return shows(*run, name); });
    };
    std::vector<std::string> silent;
    std::vector<std::string> common;
    std::vector<std::string> apart;  // of the best hypotheses
    for (const RunVerdict* run : runs) {
        const std::vector<std::string> names = names_of(*run);
        if (names.empty()) {
            silent.push_back(run->name);
        }
        for (const std::string& name : names) {
            if (in_all(name) && std::ranges::find(common, name) == common.end()) {
                common.push_back(name);
            }
        }
        for (const std::string& name : first_names_of(*run)) {
            if (!in_all(name) && std::ranges::find(apart, name) == apart.end()) {
                apart.push_back(name);
            }
        }
    }
    if (silent.size() == runs.size()) {
        return "All runs agree: none of them alone shows anything significant.";
    }
    std::string text;
    if (!common.empty()) {
        text = fmt::format("All runs agree on {}.", fmt::join(common, " or "));
        // What stands first in one run and is one of several explanations there is no difference between runs.
        const bool same = std::ranges::all_of(runs, [&](const RunVerdict* run) {
            return run->hypotheses.size() + (run->unknown ? 1U : 0U) > 1 ||
                   std::ranges::all_of(first_names_of(*run), in_all);
        });
        if (same) {
            return text;
        }
    }
    // What the same runs show stands in one sentence.
    std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> differences;  // names of runs, of causes
    for (const std::string& name : apart) {
        std::vector<std::string> shown_by;
        for (const RunVerdict* run : runs) {
            if (shows(*run, name)) {
                shown_by.push_back(run->name);
            }
        }
        const auto known = std::ranges::find_if(differences, [&](const auto& one) { return one.first == shown_by; });
        if (known == differences.end()) {
            differences.push_back({std::move(shown_by), {name}});
        } else {
            known->second.push_back(name);
        }
    }
    for (const auto& [shown_by, causes] : differences) {
        text += (text.empty() ? "" : " ") + difference_of(listed(causes), shown_by);
    }
    if (!silent.empty()) {
        text += fmt::format(" {} alone {} nothing significant, which may be for want of data.", listed(silent),
                            silent.size() == 1 ? "shows" : "show");
    }
    return text;
}

ReportSection run_verdicts_section(const DiagnosisRecord& record) {
    ReportSection section("Each run alone");
    if (DataTable table = table_of(record); !table.empty()) {
        section.add(std::move(table));
        section.say(agreement_of(record));
        section.say("held-out gain: share of the removable error that is removed on blocks of the run left out (95 %)");
    }
    section.say(left_out_text(record));
    return section;
}

Value run_verdicts_data(const DiagnosisRecord& record) {
    Value::List list;
    for (const RunVerdict& run : record.by_run.runs) {
        Value::List causes;
        for (std::size_t h = 0; h < run.hypotheses.size(); ++h) {
            for (const Cause& cause : run.hypotheses[h]) {
                causes.push_back({{"id", cause.id},
                                  {"channel", text_or_null(cause.channel)},
                                  {"place", text_or_null(cause.place)},
                                  {"parameters", parameters_data(cause)},
                                  {"sigma", cause.sigma},
                                  {"hypothesis", h + 1}});
            }
        }
        if (run.unknown) {
            causes.push_back({{"id", Value()},
                              {"place", run.unknown->place},
                              {"follows", run.unknown->follows},
                              {"sigma", run.unknown->sigma},
                              {"hypothesis", run.hypotheses.size() + 1}});
        }
        list.push_back(
            {{"name", run.name},
             {"verdict", run.status.ok() ? Value(word_of(run.verdict)) : Value()},
             {"causes", causes},
             {"gain", where(run.gain.measured, run.gain.removable_removed)},
             {"gain_low", where(run.gain.measured, run.gain.low)},
             {"gain_high", where(run.gain.measured, run.gain.high)},
             {"confirmed", run.gain.confirmed},
             {"stopped", text_or_null(run.status.ok() ? std::string(text_of(run.stopped)) : run.status.message)}});
    }
    return list;
}

}  // namespace tiretherm::post
