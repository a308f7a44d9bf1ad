// SPDX-License-Identifier: BSD-3-Clause
// Reads [[corner]] and makes a run of each recording and corner.

#include "input/drive/corner.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

namespace {

using physics::corner_names;

/// What a run says of its corners must be of corners that there are.
void check_corners_of_run(const RunTable& run, const std::vector<Corner>& corners, InputErrors& errors) {
    const TomlValue* own = run.table != nullptr ? run.table->find("corner") : nullptr;
    if (own == nullptr) {
        return;
    }
    for (const Entry& entry : own->entries) {
        if (std::ranges::find(corner_names, entry.key) != corner_names.end() &&
            std::ranges::find(corners, entry.key, &Corner::name) == corners.end()) {
            errors.add(entry.place, fmt::format("the case has no [[corner]] called \"{}\"", entry.key),
                       fmt::format("add [[corner]] with name = \"{}\", or remove this", entry.key));
        }
    }
}

}  // namespace

std::string group_of(std::string_view corner, CornerGroup group) {
    switch (group) {
        case CornerGroup::axle:
            return corner.starts_with('F') ? "front" : "rear";
        case CornerGroup::side:
            return corner.ends_with('L') ? "left" : "right";
        case CornerGroup::corner:
            return std::string(corner);
        case CornerGroup::all:
            break;
    }
    return {};
}

std::vector<Corner> read_corners(TomlTable& root, const std::shared_ptr<ColumnKeys>& of_data) {
    std::vector<Corner> corners;
    root.each("corner", [&](TomlTable& table) {
        table.declare_keys({"drive", "initial", "measured", "effects"});
        Corner corner{.name = {}, .table = &table.content(), .keys = std::make_shared<ColumnKeys>()};
        check_overlaid(table.content(), "corner", table.errors());
        corner.keys->read(table);
        corner.keys->fall_back_on(of_data);
        const std::optional<std::size_t> name = table.choice("name", Need::required);
        if (!name) {
            return;
        }
        corner.name = corner_names[*name];
        if (std::ranges::find(corners, corner.name, &Corner::name) != corners.end()) {
            table.add_error("name", fmt::format("a second [[corner]] is called \"{}\"", corner.name),
                            "give each corner one table");
            return;
        }
        corners.push_back(std::move(corner));
    });
    return corners;
}

void check_overlaid(const TomlValue& over, const std::string& name, InputErrors& errors) {
    for (const std::string_view key : {"drive", "initial", "time", "vehicle", "effects", "measured"}) {
        const TomlValue* value = over.find(key);
        const bool list = key == "measured";
        if (value != nullptr && value->kind != (list ? TomlValue::Kind::array : TomlValue::Kind::table)) {
            errors.add(value->place,
                       fmt::format("{} is {}; a {} is wanted", key, shown(*value), list ? "list of tables" : "table"),
                       fmt::format("write {}{}.{}{}", list ? "[[" : "[", name, key, list ? "]]" : "]"));
        }
    }
}

void read_corners_of_run(TomlTable& run) {
    const std::vector<std::string> names(corner_names.begin(), corner_names.end());
    const std::vector<std::string> keys{"drive", "initial", "time", "measured"};
    const TomlValue* corners = run.value("corner");
    if (corners == nullptr) {
        return;
    }
    if (corners->kind != TomlValue::Kind::table) {
        run.add_error("corner", fmt::format("corner is {}; a table of corners is wanted", shown(*corners)),
                      "corner = { FL = { initial = { temperature = \"40 degC\" } } }");
        return;
    }
    for (const Entry& corner : corners->entries) {
        if (std::ranges::find(names, corner.key) == names.end()) {
            run.errors().add(corner.place, fmt::format("\"{}\" is not a corner", corner.key),
                             suggest(corner.key, names, "corners"));
        }
        if (corner.value.kind != TomlValue::Kind::table) {
            run.errors().add(corner.value.place,
                             fmt::format("{} is {}; a table is wanted", corner.key, shown(corner.value)),
                             fmt::format("write {} = {{ initial = {{ temperature = \"40 degC\" }} }}", corner.key));
        }
        check_overlaid(corner.value, "run.corner." + corner.key, run.errors());
        for (const Entry& entry : corner.value.entries) {
            if (std::ranges::find(keys, entry.key) == keys.end()) {
                run.errors().add(entry.place, fmt::format("\"{}\" is not a key of a corner in a run", entry.key),
                                 suggest(entry.key, keys, "keys"));
            }
        }
    }
}

std::vector<RunTable> at_corners(const std::vector<RunTable>& runs, const std::vector<Corner>& corners,
                                 InputErrors& errors) {
    for (const RunTable& run : runs) {
        check_corners_of_run(run, corners, errors);
    }
    if (corners.empty()) {
        return runs;
    }
    std::vector<RunTable> each;
    for (const RunTable& run : runs) {
        for (const Corner& corner : corners) {
            RunTable& one = each.emplace_back(run);
            one.name = fmt::format("{}_{}", run.name, corner.name);
            one.recording = run.name;
            one.corner = corner.name;
            one.corner_table = corner.table;
            // What the run itself says of columns wins over its corner, and this one over [data].
            one.keys = std::make_shared<ColumnKeys>(run.table != nullptr ? *run.keys : ColumnKeys());
            one.keys->fall_back_on(corner.keys);
        }
    }
    return each;
}

std::vector<CornerColumn> columns_of_one_tire(const RunTable& run, const RunFile& file) {
    std::vector<CornerColumn> found;
    const TomlValue* names = run.corner_table != nullptr ? run.corner_table->find("columns") : nullptr;
    for (const UsedColumn& column : run.corner.empty() ? std::vector<UsedColumn>{} : file.columns.used) {
        const std::string& heading = file.file.heads()[static_cast<std::size_t>(column.column)].heading.name;
        if (column.is_sensor || (names != nullptr && names->find(heading) != nullptr)) {
            found.push_back({.recording = run.recording,
                             .corner = run.corner,
                             .heading = heading,
                             .name = column.name,
                             .place = run.corner_table->place});
        }
    }
    return found;
}

void warn_of_shared_columns(const std::vector<CornerColumn>& columns, InputErrors& errors) {
    for (auto one = columns.begin(); one != columns.end(); ++one) {
        std::vector<std::string> corners;
        const CornerColumn* last = &*one;
        for (const CornerColumn& other : columns) {
            if (other.recording == one->recording && other.heading == one->heading) {
                corners.push_back(other.corner);
                last = &other;
            }
        }
        if (corners.size() > 1 && corners.front() == one->corner) {
            errors.warn(last->place, "the column {} is {} of {}: it belongs to one tire", one->heading, one->name,
                        listed(corners));
        }
    }
}

}  // namespace tiretherm::input
