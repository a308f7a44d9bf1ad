// SPDX-License-Identifier: BSD-3-Clause
// Reads the keys of [[run]], or makes one run of each --data file.

#include "input/drive/run_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/drive/corner.hpp"
#include "input/files/run_name.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

constexpr int most_repeats = 20;

/// start_line = [[51.2077, -1.6089], [51.2078, -1.6086]], in degrees.
void read_start_line(TomlTable& table, RunTable& run) {
    const TomlValue* value = table.content().find("start_line");
    table.declare_keys({"start_line"});
    if (value == nullptr) {
        return;
    }
    std::vector<double> degrees;
    for (const TomlValue& point : value->items) {
        const bool is_point = point.items.size() == 2 && point.items[0].is_number() && point.items[1].is_number();
        if (is_point && std::abs(point.items[0].number) <= 90.0 && std::abs(point.items[1].number) <= 180.0) {
            degrees.push_back(point.items[0].number);
            degrees.push_back(point.items[1].number);
        }
    }
    if (value->items.size() != 2 || degrees.size() != 4 || (degrees[0] == degrees[2] && degrees[1] == degrees[3])) {
        table.add_error("start_line", fmt::format("start_line is {}; two points are wanted", shown(*value)),
                        "write the ends of the line as latitude and longitude in degrees: "
                        "start_line = [[51.2077, -1.6089], [51.2078, -1.6086]]");
        return;
    }
    run.start_line_place = table.place("start_line");
    run.start_line = StartLine{
        .latitude_a = degrees[0], .longitude_a = degrees[1], .latitude_b = degrees[2], .longitude_b = degrees[3]};
}

void read_window(TomlTable& table, RunTable& run) {
    run.from = table.quantity("from");
    run.to = table.quantity("to");
    if (run.from && run.to && !(*run.from < *run.to)) {
        table.add_error("to", fmt::format("from is {:.6g} s and to is {:.6g} s", *run.from, *run.to),
                        "let to be later than from");
        run.from = run.to = std::nullopt;
    }
    if (const std::optional<std::string> laps = table.text("laps")) {
        run.laps = LocatedString{*laps, table.place("laps")};
        for (const std::string_view key : {"from", "to"}) {
            if (table.has(key)) {
                table.add_error(key, fmt::format("{} and laps both say which part of the file the run is", key),
                                "keep one of them");
            }
        }
    }
    run.repeat_first_lap = table.count("repeat_first_lap").value_or(0);
    if (run.repeat_first_lap > 0 && !run.laps) {
        table.add_error("repeat_first_lap", "repeat_first_lap says to drive the first lap before, but not which it is",
                        "say which laps the run is: laps = \"1-8\"");
    }
    read_start_line(table, run);
}

/// frames = "camera.h5", or frames = { outside = "outside.h5", inside = "inside.h5" }.
void read_frame_files(TomlTable& table, RunTable& run) {
    const TomlValue* frames = table.content().find("frames");
    table.declare_keys({"frames"});
    const auto add = [&](const LocatedString& camera, const std::optional<std::string>& path,
                         const SourceLocation& place) {
        if (path) {
            run.frames.push_back({.camera = camera, .path = table.errors().beside(place, *path), .place = place});
        }
    };
    if (frames != nullptr && frames->kind == TomlValue::Kind::table) {
        TomlTable by_camera = table.subtable("frames");
        for (const Entry& entry : frames->entries) {
            add({entry.key, entry.place}, by_camera.text(entry.key), entry.value.place);
        }
    } else if (frames != nullptr) {
        add({"", frames->place}, table.text("frames"), frames->place);
    }
}

std::string_view laps_of(const RunTable& run) { return run.laps ? std::string_view(run.laps->text) : ""; }

RunTable read_run(TomlTable& table) {
    RunTable run{.table = &table.content(), .place = table.place(), .name = {}};
    const std::optional<std::string> file = table.text("file");
    table.declare_keys({"name", "drive", "initial", "time", "measured", "vehicle", "columns", "units", "unit_names",
                        "ignore", "hold", "keep_suspicious", "from", "to", "laps", "repeat_first_lap", "start_line"});
    check_overlaid(table.content(), "run", table.errors());
    read_corners_of_run(table);
    if (file) {
        run.place = table.place("file");
        run.file = table.errors().beside(run.place, *file);
    } else if (!table.has("file")) {
        for (const std::string_view key : {"columns", "units", "unit_names", "ignore", "hold", "keep_suspicious",
                                           "from", "to", "laps", "repeat_first_lap", "start_line"}) {
            if (table.has(key)) {
                table.add_error(key, fmt::format("{} needs a file, and the run has none", key),
                                "add file = \"....csv\"");
            }
        }
    }
    run.keys->read(table);
    read_window(table, run);
    const std::string of_file = run.file ? run_name(*run.file, laps_of(run)) : std::string();
    run.name = table.name("name", table.has("file") ? Need::optional : Need::required).value_or(of_file);
    read_frame_files(table, run);
    return run;
}

void report_duplicates(const std::vector<RunTable>& runs, InputErrors& errors) {
    for (auto run = runs.begin(); run != runs.end(); ++run) {
        const auto duplicate = std::find_if(runs.begin(), run, [&](const RunTable& r) { return r.name == run->name; });
        if (duplicate != run && !run->name.empty()) {
            const TomlValue* name = run->table->find("name");
            errors.add(name != nullptr ? name->place : run->place,
                       fmt::format("a second run is called \"{}\"", run->name),
                       "give each run a name of its own: name = \"...\"");
        }
    }
}

/// A run for each file. Files of one name in several folders are distinguished by the folder.
std::vector<RunTable> runs_of(const std::vector<fs::path>& data, const RunTable& like, InputErrors& errors) {
    std::vector<RunTable> runs;
    for (const fs::path& file : data) {
        RunTable run = like;
        run.file = file.lexically_normal();
        run.name = name_beside(data, file, laps_of(run));
        if (std::any_of(runs.begin(), runs.end(), [&](const RunTable& r) { return r.name == run.name; })) {
            const SourceLocation place{.file = errors.add_file(run.file->generic_string(), "")};
            errors.add(place, fmt::format("a second file of a run \"{}\"", run.name),
                       "give each file once, under a name of its own");
            continue;
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

}  // namespace

std::string name_beside(const std::vector<fs::path>& data, const fs::path& file, std::string_view laps) {
    const auto same_stem = [&](const fs::path& other) { return other.stem() == file.stem(); };
    const bool alone = std::count_if(data.begin(), data.end(), same_stem) == 1;
    const std::string folder = file.lexically_normal().parent_path().filename().string();
    return (alone || folder.empty() ? "" : folder + "_") + run_name(file, laps);
}

std::string name_of_run_table(const TomlValue& table) {
    if (const TomlValue* name = table.find("name")) {
        return name->text;
    }
    const TomlValue* file = table.find("file");
    const TomlValue* laps = table.find("laps");
    return file == nullptr ? "" : run_name(file->text, laps != nullptr ? laps->text : "");
}

std::vector<RunTable> read_run_tables(TomlTable& root, const std::string& case_name,
                                      const std::vector<fs::path>& data) {
    RunTable of_data{.table = nullptr, .place = {}, .name = {}};
    {
        TomlTable table = root.subtable("data");
        of_data.keys->read(table);
        read_window(table, of_data);
    }
    const std::vector<Corner> corners = read_corners(root, of_data.keys);
    if (!data.empty()) {
        root.declare_keys({"run"});
        return at_corners(runs_of(data, of_data, root.errors()), corners, root.errors());
    }
    std::vector<RunTable> runs;
    root.each("run", [&](TomlTable& table) {
        runs.push_back(read_run(table));
        runs.back().keys->fall_back_on(of_data.keys);
    });
    report_duplicates(runs, root.errors());
    if (const TomlValue* tables = root.content().find("run");
        tables != nullptr && tables->kind == TomlValue::Kind::array && tables->items.empty()) {
        root.add_error("run", "run is an empty list", "remove it, or add [[run]] with file = \"....csv\"");
    }
    if (runs.empty()) {  // none is said, or nothing that is one: whoever reads on finds the case itself
        const SourceLocation place = root.has("run") ? root.place("run") : SourceLocation{};
        runs.push_back({.table = nullptr, .place = place, .name = fs::path(case_name).filename().string()});
    }
    return at_corners(runs, corners, root.errors());
}

}  // namespace tiretherm::input
