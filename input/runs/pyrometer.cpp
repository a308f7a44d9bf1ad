// SPDX-License-Identifier: BSD-3-Clause
// Reads [[pyrometer]] and writes what it says of one run and corner as [[measured]].

#include "input/runs/pyrometer.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/files/run_name.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

namespace {

/// When the readings were taken. @returns s, or nothing: at the run's end, after an error, or of another run
std::optional<double> time_of_stop(TomlTable& table, const RunFile* file, bool is_of_run) {
    const std::optional<double> time = table.quantity("time");
    const std::optional<int> lap = table.count("lap");
    const double after = table.quantity("after").value_or(0.0);
    if (time && lap) {
        table.add_error("lap", "both time and lap say when the stop was", "keep one of them");
        return std::nullopt;
    }
    if (table.has("after") && !table.has("lap")) {
        table.add_error("after", "after counts from the end of a lap, and no lap is given",
                        "add lap = 8, or write time");
        return std::nullopt;
    }
    if (!lap || !is_of_run) {
        return time;
    }
    const std::vector<Lap> laps = file != nullptr ? file->laps.laps : std::vector<Lap>{};
    const auto found = std::ranges::find(laps, *lap, &Lap::number);
    if (found == laps.end()) {
        table.add_error("lap", fmt::format("there is no lap {}", *lap),
                        laps.empty() ? "no laps are known of the run: write time = \"742 s\""
                                     : fmt::format("the laps are {}", list_laps(laps)));
        return std::nullopt;
    }
    if (file->time.empty()) {
        return std::nullopt;  // which has been reported
    }
    // The mark at the end of the last lap lies between its last sample and the next.
    const double first = file->time[file->first];
    const double last = file->time[file->last - 1];
    const double next = file->last < file->time.size() ? file->time[file->last] : last;
    const double end = found->end > last && found->end <= next ? last : found->end;
    if (end < first || end + after > last) {
        table.add_error(
            end + after > last && end <= last ? "after" : "lap",
            fmt::format("{:.6g} s after the end of lap {} it is {:.6g} s, and the run goes from {:.6g} s to {:.6g} s",
                        after, *lap, end + after, first, last),
            "choose a moment within the run: the tire cools while the car stands, and the log has to go on as long");
        return std::nullopt;
    }
    return end + after;
}

/// Values for as many sensors, K. Empty after an error. @param key of the corner, or "readings"
std::vector<double> readings_of(TomlTable& table, std::string_view key, std::size_t n_sensors) {
    const std::size_t before = table.errors().count();
    std::vector<double> kelvin;
    for (const LocatedString& text : table.texts(key)) {
        const ParsedQuantity parsed = parse_quantity(text.text, quantity_specs::temperature, key);
        if (parsed.error) {
            table.errors().add(text.place, *parsed.error);
        }
        kelvin.push_back(parsed.value);
    }
    if (table.errors().count() > before) {
        return {};
    }
    if (n_sensors == 1 && kelvin.size() > 1) {
        double sum = 0.0;
        for (const double one : kelvin) {
            sum += one;
        }
        return {sum / static_cast<double>(kelvin.size())};
    }
    if (kelvin.size() != n_sensors) {
        table.add_error(
            key,
            fmt::format("{} has {} {} for {} {}", key, kelvin.size(), kelvin.size() == 1 ? "value" : "values",
                        n_sensors, n_sensors == 1 ? "sensor" : "sensors"),
            "give one for each sensor, in their order; several of a single sensor are averaged");
        return {};
    }
    return kelvin;
}

/// Whether --data has the only run of the case, by name, or the case has none.
bool is_run_of_case(const TomlValue& document, const std::string& name) {
    const TomlValue* runs = document.find("run");
    if (runs == nullptr) {
        return true;
    }
    if (runs->items.size() != 1) {
        return false;
    }
    const auto text = [&](std::string_view key) -> std::string {
        const TomlValue* value = runs->items.front().find(key);
        return value != nullptr ? value->text : "";
    };
    return name == (text("name").empty() ? run_name(text("file"), text("laps")) : text("name"));
}

/// Whether a stop belongs to the run. An unknown name is an error.
bool is_of_run(TomlTable& table, const RunTable& run, const std::vector<RunTable>& runs, const TomlValue& document) {
    std::vector<std::string> names;
    for (const RunTable& one : runs) {
        const std::string& name = one.corner.empty() ? one.name : one.recording;
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    }
    const std::optional<std::string> name = table.text("run");
    const bool by_data = run.table == nullptr && run.file;  // --data takes the place of the runs
    const bool is_known = name ? std::ranges::find(names, *name) != names.end()
                               : names.size() == 1 && is_run_of_case(document, names.front());
    if (by_data && !is_known) {
        table.errors().warn(table.place(),
                            "the run of this [[pyrometer]] is not among those of --data: it is left out");
        return false;
    }
    if (!name && names.size() > 1) {
        table.add_error("run", "the run after which the readings were taken is missing",
                        fmt::format("add run = \"{}\"; the runs are {}", names.front(), listed(names)));
        return false;
    }
    if (name && std::ranges::find(names, *name) == names.end()) {
        table.add_error("run", fmt::format("there is no run \"{}\"", *name), suggest(*name, names, "runs"));
        return false;
    }
    return !name || *name == (run.corner.empty() ? run.name : run.recording);
}

/// Whether the readings are those of tires that the case has. @returns false after an error
bool check_readings(TomlTable& table, const RunTable& run, const std::vector<RunTable>& runs,
                    const std::vector<LocatedString>& sensors) {
    const std::size_t before = table.errors().count();
    if (table.has("sensors") && sensors.empty()) {
        table.add_error("sensors", "sensors names none", "write sensors = [\"bulk_temperature\"]");
    }
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (sensors[i].text == sensors[k].text) {
                table.errors().add(sensors[i].place, fmt::format("{} stands twice", sensors[i].text),
                                   "name each sensor once; several readings of a single sensor are averaged");
            }
        }
    }
    bool any = table.has("readings");
    if (any && !run.corner.empty()) {
        table.add_error("readings", "readings are those of a single tire, and the case has corners",
                        "write FL = [...], FR = [...] and so on");
    }
    for (const std::string_view corner : physics::corner_names) {
        any = any || table.has(corner);
        if (table.has(corner) && std::ranges::find(runs, corner, &RunTable::corner) == runs.end()) {
            table.add_error(corner, fmt::format("the case has no [[corner]] called \"{}\"", corner),
                            run.corner.empty()
                                ? "write readings = [...], or add [[corner]]"
                                : fmt::format("add [[corner]] with name = \"{}\", or remove this", corner));
        }
    }
    if (!any) {
        table.errors().add(table.place(), "[[pyrometer]] has no reading",
                           run.corner.empty() ? "add readings = [\"80 degC\"]" : "add FL = [\"80 degC\"]");
    }
    return table.errors().count() == before;
}

TomlValue at_place(TomlValue value, const SourceLocation& place) {
    value.place = place;
    for (Entry& entry : value.entries) {
        entry.place = place;
        entry.value.place = place;
    }
    return value;
}

}  // namespace

void add_pyrometer_readings(TomlValue& document, const RunTable& run, const RunFile* file,
                            const std::vector<RunTable>& runs, InputErrors& errors) {
    if (document.find("pyrometer") == nullptr) {
        return;
    }
    std::vector<TomlValue> measured;
    // The tables are read from a copy: what they give is added to the document itself.
    const TomlValue as_read = document;
    TomlTable root(as_read, "the case", errors);
    root.allow_unknown_keys();
    root.each("pyrometer", [&](TomlTable& table) {
        table.declare_keys({"FL", "FR", "RL", "RR", "readings"});
        const bool is_of = is_of_run(table, run, runs, as_read);
        const std::vector<LocatedString> sensors = table.texts("sensors");
        const std::optional<double> time = time_of_stop(table, file, is_of);
        const auto uncertainty = table.quantity(
            "uncertainty", {.unit = "K", .scale = Scale::difference, .low = 0.0, .above = true}, Need::required);
        const std::string source = table.text("source").value_or("pyrometer");
        const std::string_view key = run.corner.empty() ? std::string_view("readings") : std::string_view(run.corner);
        if (!check_readings(table, run, runs, sensors) || !is_of || !table.has(key)) {
            return;
        }
        const std::vector<double> values = readings_of(table, key, sensors.size());
        for (std::size_t i = 0; i < values.size() && uncertainty; ++i) {
            TomlValue one = toml_text::table_value({{"channel", toml_text::text_value(sensors[i].text)},
                                                    {"value", toml_text::quantity_value(values[i], "K")},
                                                    {"uncertainty", toml_text::quantity_value(*uncertainty, "K")},
                                                    {"source", toml_text::text_value(source)}});
            if (time) {
                one.set("time", toml_text::quantity_value(*time, "s"));
            }
            one = at_place(std::move(one), table.place(key));
            one.entries.front().value.place = sensors[i].place;
            measured.push_back(std::move(one));
        }
    });
    TomlValue& list = document.at("measured", document.place);
    if (list.kind == TomlValue::Kind::nothing) {
        list.kind = TomlValue::Kind::array;
        list.place = document.place;
    }
    std::ranges::move(measured, std::back_inserter(list.items));
}

}  // namespace tiretherm::input
