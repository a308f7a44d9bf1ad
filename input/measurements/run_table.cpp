#include "input/measurements/run_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

void read_window(Section& section, RunTable& run) {
    run.from = section.quantity("from", wanted::moment);
    run.to = section.quantity("to", wanted::moment);
    if (run.from && run.to && !(*run.from < *run.to)) {
        section.mistake("to", fmt::format("from is {:.6g} s and to is {:.6g} s", *run.from, *run.to),
                        "let to be later than from");
        run.from = run.to = std::nullopt;
    }
}

/// frames = "camera.h5", or frames = { outside = "outside.h5", inside = "inside.h5" }.
void read_frame_files(Section& section, RunTable& run) {
    const Node* frames = section.table().find("frames");
    section.know({"frames"});
    const auto add = [&](const Word& camera, const std::optional<std::string>& path, const Place& place) {
        if (path) {
            const fs::path beside = fs::path(section.mistakes().file(place.file)).parent_path();
            run.frames.push_back({.camera = camera, .path = (beside / *path).lexically_normal(), .place = place});
        }
    };
    if (frames != nullptr && frames->kind == Node::Kind::table) {
        Section table = section.section("frames");
        for (const Entry& entry : frames->entries) {
            add({entry.key, entry.place}, table.text(entry.key), entry.value.place);
        }
    } else if (frames != nullptr) {
        add({"", frames->place}, section.text("frames"), frames->place);
    }
}

RunTable read_run(Section& section) {
    RunTable run{.table = &section.table(), .place = section.place(), .name = {}};
    const std::optional<std::string> file = section.text("file");
    section.know({"name", "drive", "initial", "time", "measured", "columns", "units", "ignore", "from", "to"});
    if (file) {
        run.place = section.place("file");
        const fs::path beside = fs::path(section.mistakes().file(run.place.file)).parent_path();
        run.file = (beside / *file).lexically_normal();
    } else {
        for (const std::string_view key : {"columns", "units", "ignore", "from", "to"}) {
            if (section.has(key)) {
                section.mistake(key, fmt::format("{} speaks of a file, and the run has none", key),
                                "add file = \"....csv\"");
            }
        }
    }
    run.name = section.name("name", run.file ? Need::optional : Need::required)
                   .value_or(run.file ? run.file->stem().string() : std::string());
    run.keys->read(section);
    read_window(section, run);
    read_frame_files(section, run);
    return run;
}

void complain_of_twins(const std::vector<RunTable>& runs, Mistakes& mistakes) {
    for (auto run = runs.begin(); run != runs.end(); ++run) {
        const auto twin = std::find_if(runs.begin(), run, [&](const RunTable& r) { return r.name == run->name; });
        if (twin != run && !run->name.empty()) {
            const Node* name = run->table->find("name");
            mistakes.add(name != nullptr ? name->place : run->place,
                         fmt::format("a second run is called \"{}\"", run->name),
                         "give each run a name of its own: name = \"...\"");
        }
    }
}

/// A run for each file. Files of one name in several folders are told apart by the folder.
std::vector<RunTable> runs_of(const std::vector<fs::path>& data, const RunTable& like, Mistakes& mistakes) {
    std::vector<RunTable> runs;
    for (const fs::path& file : data) {
        RunTable run = like;
        run.file = file.lexically_normal();
        const auto same_stem = [&](const fs::path& other) { return other.stem() == file.stem(); };
        const bool alone = std::count_if(data.begin(), data.end(), same_stem) == 1;
        const std::string folder = run.file->parent_path().filename().string();
        run.name = alone || folder.empty() ? file.stem().string() : folder + "_" + file.stem().string();
        if (std::any_of(runs.begin(), runs.end(), [&](const RunTable& r) { return r.name == run.name; })) {
            const Place place{.file = mistakes.add_file(run.file->generic_string(), "")};
            mistakes.add(place, fmt::format("a second file of a run \"{}\"", run.name),
                         "give each file once, under a name of its own");
            continue;
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

}  // namespace

void ColumnKeys::read_words(Section table, std::vector<Key>& into) {
    for (const Entry& entry : table.table().entries) {
        if (const std::optional<std::string> word = table.text(entry.key)) {
            into.push_back({.column = {entry.key, entry.place}, .value = {*word, entry.value.place}});
        }
    }
}

void ColumnKeys::read(Section& section) {
    read_words(section.section("columns"), names_);
    read_words(section.section("units"), units_);
    for (Word& word : section.texts("ignore")) {
        ignored_.push_back({.column = std::move(word), .value = {}});
    }
}

Word ColumnKeys::name_of(const std::string& heading, const Place& place) {
    headings_.insert(heading);
    for (Key& key : names_) {
        if (key.column.text == heading) {
            key.found = true;
            return key.value;
        }
    }
    return {heading, place};
}

const Word* ColumnKeys::unit_of(const std::string& heading) {
    for (Key& key : units_) {
        if (key.column.text == heading) {
            key.found = true;
            return &key.value;
        }
    }
    return nullptr;
}

bool ColumnKeys::ignores(const std::string& heading) {
    bool ignored = false;
    for (Key& key : ignored_) {
        if (key.column.text == heading) {
            key.found = ignored = true;
        }
    }
    return ignored;
}

void ColumnKeys::complain(Mistakes& mistakes) const {
    if (forgiving_) {
        return;
    }
    const std::vector<std::string> known(headings_.begin(), headings_.end());
    for (const std::vector<Key>* keys : {&names_, &units_, &ignored_}) {
        for (const Key& key : *keys) {
            if (!key.found) {
                mistakes.add(key.column.place, fmt::format("the file has no column \"{}\"", key.column.text),
                             suggest(key.column.text, known, "columns"));
            }
        }
    }
}

std::vector<RunTable> read_run_tables(Section& root, const std::string& case_name, const std::vector<fs::path>& data) {
    RunTable of_data{.table = nullptr, .place = {}, .name = {}};
    {
        Section section = root.section("data");
        of_data.keys->read(section);
        read_window(section, of_data);
    }
    if (!data.empty()) {
        root.know({"run"});
        return runs_of(data, of_data, root.mistakes());
    }
    std::vector<RunTable> runs;
    root.each("run", [&](Section& section) { runs.push_back(read_run(section)); });
    complain_of_twins(runs, root.mistakes());
    if (!root.has("run")) {
        RunTable itself{.table = nullptr, .place = {}, .name = fs::path(case_name).filename().string()};
        runs.push_back(std::move(itself));
    }
    return runs;
}

}  // namespace tiretherm::input
