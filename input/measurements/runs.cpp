#include "input/measurements/runs.hpp"

#include <algorithm>
#include <array>
#include <deque>

#include <fmt/format.h>

#include "input/parameters/hot_spots.hpp"
#include "input/cameras/frames.hpp"
#include "input/effects/own_effects.hpp"
#include "input/parameters/parameters.hpp"
#include "input/model/probes.hpp"
#include "input/measurements/run_readings.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array<std::string_view, 4> tables_of_a_run{"drive", "initial", "time", "measured"};

/// A number of the case counts in each run that has none of its own; it was hardly measured in several.
void warn_of_shared_numbers(const Node& document, const std::vector<RunTable>& tables, const Experiment& experiment,
                            Mistakes& mistakes) {
    const Node* numbers = document.find("measured");
    std::size_t sharing = 0;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const bool own = tables[i].table != nullptr && tables[i].table->find("measured") != nullptr;
        sharing += !own && !experiment.runs[i].numbers.empty() ? 1 : 0;
    }
    if (numbers != nullptr && sharing > 1) {
        mistakes.warn(numbers->place,
                      fmt::format("the numbers of the case count in each of {} runs: give them to the run "
                                  "in which they were measured",
                                  sharing));
    }
}

}  // namespace

std::vector<std::string> unique(const std::vector<std::string>& sentences) {
    std::vector<std::string> once;
    for (const std::string& sentence : sentences) {
        if (std::find(once.begin(), once.end(), sentence) == once.end()) {
            once.push_back(sentence);
        }
    }
    return once;
}

Runs read_runs(const Node& document, const std::string& name, const std::vector<std::filesystem::path>& data,
               Occasion occasion, Mistakes& mistakes) {
    Runs into;
    std::vector<RunTable> tables;
    {
        Section root(document, "the case", mistakes);
        root.forgive();  // its keys are told by the readers below
        tables = read_run_tables(root, name, data);
    }
    const bool measured = !data.empty() || document.find("run") != nullptr;
    const std::vector<std::string> sensors = sensor_names(document);
    const std::vector<std::string> followed = followed_names(document);
    const std::vector<std::string> run_names = measured ? names_of(tables) : std::vector<std::string>{};
    std::deque<Node> documents;  // drafts point into them
    for (const RunTable& table : tables) {
        Node& merged = documents.emplace_back(document);
        if (table.table != nullptr) {
            lay_over(merged, *table.table, tables_of_a_run);
        }
        std::optional<RunFile> file = table.file ? open_run_file(table, sensors, followed, mistakes) : std::nullopt;
        if (!file) {
            table.keys->forgive();
        }
        Draft draft;
        draft.problem.name = name;
        if (measured) {
            draft.run = read_run_inputs(table, file ? &*file : nullptr, mistakes);
        }
        Section root(merged, "the case", mistakes);
        root.know({"include"});
        read_tables(root, draft);
        root.know({"run", "data", "parameter", "identify", "diagnose", "critical", "uncertain"});
        MeasuredRun run;
        run.name = table.name;
        run.file = table.file ? table.file->generic_string() : "";
        if (file) {
            read_series(*file, draft, mistakes, run);
            read_unused(*file, draft.problem.settings, mistakes, run);
            std::ranges::move(find_suspicious(recording_of(*file, draft, run)), std::back_inserter(into.findings));
        }
        read_numbers(draft, merged, table, mistakes, run);
        read_frames(table, draft, mistakes, run, into.findings);
        if (measured && occasion == Occasion::measured) {
            require_readings(run, table, file ? &*file : nullptr, sensors, mistakes);
        }
        if (documents.size() == 1) {
            read_parameters(root, draft, run_names, into.experiment.parameters);
            read_identify(root, into.experiment);
            static_cast<void>(read_critical(root, draft.problem, draft.has_mesh));
            static_cast<void>(read_uncertain(root));
            read_diagnose(root, draft.problem, into.experiment);
            into.problem = draft.problem;
        }
        run.problem = std::move(draft.problem);
        into.experiment.runs.push_back(std::move(run));
    }
    for (const RunTable& table : tables) {
        table.keys->complain(mistakes);
    }
    warn_of_shared_numbers(document, tables, into.experiment, mistakes);
    return into;
}

}  // namespace tiretherm::input
