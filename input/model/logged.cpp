#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "input/tables/csv.hpp"
#include "input/model/draft.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using physics::Signal;

/// Which heading of the file stands for which name: `columns = { V = "speed" }`; without it a heading is its own name.
std::map<std::string, Word> read_names(Section& section, const Csv& csv, const std::vector<std::string>& followed) {
    std::map<std::string, Word> names;
    Section renamed = section.section("columns");
    std::vector<std::string> known;
    for (const Head& head : csv.heads()) {
        known.push_back(head.heading.name);
    }
    for (const Entry& entry : renamed.table().entries) {
        const std::optional<std::string> name = renamed.text(entry.key);
        if (csv.find(entry.key) < 0) {
            section.mistakes().add(entry.place, fmt::format("the file has no column \"{}\"", entry.key),
                                   suggest(entry.key, known, "columns"));
        } else if (name && *name != "time" && physics::find_signal(*name) == nullptr &&
                   std::ranges::find(followed, *name) == followed.end()) {
            std::vector<std::string> inputs = names_of(physics::signals());
            inputs.emplace_back("time");
            renamed.mistake(entry.key, fmt::format("\"{}\" is not an input", *name), suggest(*name, inputs, "inputs"));
        } else if (name) {
            names[entry.key] = {*name, entry.value.place};
        }
    }
    return names;
}

/// The columns of the file that are inputs, the time first.
/// @param outranked out, how many inputs a measured run's file gives instead
std::vector<ColumnRequest> requests(Section& section, const Csv& csv, Draft& draft, int& outranked) {
    Mistakes& mistakes = section.mistakes();
    const std::map<std::string, Word> renamed = read_names(section, csv, draft.followed);
    const std::vector<Word> ignored = section.texts("ignore");
    std::vector<ColumnRequest> found{
        {.column = -1, .name = "time", .wanted = wanted::moment, .purpose = Purpose::clock}};
    draft.columns.reserve(draft.columns.size() + csv.heads().size());  // requests look into it
    for (std::size_t i = 0; i < csv.heads().size(); ++i) {
        const Head& head = csv.heads()[i];
        const auto entry = renamed.find(head.heading.name);
        const std::string name = entry == renamed.end() ? head.heading.name : entry->second.text;
        const bool skipped = std::any_of(ignored.begin(), ignored.end(),
                                         [&](const Word& word) { return word.text == head.heading.name; });
        const Signal* signal = physics::find_signal(name);
        const bool followed =
            signal == nullptr && std::ranges::find(draft.followed, name) != draft.followed.end() && name != "time";
        if (skipped || (signal == nullptr && name != "time" && !followed)) {
            continue;
        }
        if (followed) {
            const auto twin = std::ranges::find(draft.columns, name, &OwnColumn::name);
            if (twin != draft.columns.end()) {
                mistakes.add(head.place, fmt::format("a second column is called {}", name), "ignore one of them");
                continue;
            }
            // What its numbers are is told by its own unit.
            draft.columns.push_back({.name = name, .unit = base_unit(head.heading.unit), .course = {}});
            found.push_back({.column = static_cast<int>(i),
                             .name = name,
                             .wanted = {.unit = draft.columns.back().unit},
                             .purpose = Purpose::measured});
            continue;
        }
        if (name == "time") {
            if (found.front().column >= 0) {
                mistakes.add(head.place, "a second column time", "rename or ignore one");
            }
            found.front().column = static_cast<int>(i);
        } else if (draft.outranked("file", name)) {
            ++outranked;
        } else if (claim_signal(name, head.place, draft, mistakes)) {
            found.push_back({.column = static_cast<int>(i), .name = name, .wanted = wanted::of(*signal)});
        }
    }
    for (const Word& word : ignored) {
        if (csv.find(word.text) < 0) {
            mistakes.add(word.place, fmt::format("the file has no column \"{}\"", word.text));
        }
    }
    return found;
}

}  // namespace

void read_logged(Section& section, Draft& draft) {
    Mistakes& mistakes = section.mistakes();
    const std::optional<std::string> path = section.text("path", Need::required);
    section.know({"columns", "ignore"});
    if (!path) {
        return;
    }
    const Place mentioned = section.place("path");
    const fs::path beside = fs::path(mistakes.file(mentioned.file)).parent_path();
    const std::optional<TextFile> file = read_text((beside / *path).lexically_normal(), mentioned, mistakes);
    const std::optional<Csv> csv = file ? Csv::open(*file, mistakes) : std::nullopt;
    if (!csv) {
        return;
    }
    const std::size_t before = mistakes.count();
    int outranked = 0;
    const std::vector<ColumnRequest> wanted_columns = requests(section, *csv, draft, outranked);
    if (wanted_columns.front().column < 0) {
        mistakes.add(csv->heads().front().place, "the file has no column time [s]",
                     "rename one: columns = { t = \"time\" }");
        return;
    }
    if (wanted_columns.size() == 1 && outranked == 0 && mistakes.count() == before) {
        section.mistake("path", "no column of the file is an input",
                        "rename columns to inputs: columns = { V = \"speed\" }");
        return;
    }
    std::vector<std::vector<double>> values = csv->read(wanted_columns, mistakes);
    if (values.empty()) {
        return;
    }
    const std::vector<double> time = std::move(values.front());
    draft.logged_from = std::min(draft.logged_from.value_or(time.front()), time.front());
    draft.logged_to = std::max(draft.logged_to.value_or(time.back()), time.back());
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (wanted_columns[i].purpose == Purpose::measured) {
            const auto column = std::ranges::find(draft.columns, wanted_columns[i].name, &OwnColumn::name);
            for (std::size_t k = 0; k < time.size(); ++k) {
                if (!std::isnan(values[i][k])) {
                    column->course.time.push_back(time[k]);
                    column->course.value.push_back(values[i][k]);
                }
            }
            continue;
        }
        draft.problem.drive.add(solver::Series{.signal = physics::find_signal(wanted_columns[i].name),
                                               .time = time,
                                               .value = std::move(values[i]),
                                               .logged = true});
    }
}

}  // namespace tiretherm::input
