// SPDX-License-Identifier: BSD-3-Clause
// A case laid over another: the original included, and what was fitted at the paths of its parameters.
#include "input/parameters/overlay.hpp"

#include <iterator>
#include <set>

#include <fmt/format.h>

#include "input/case_text/case_writer.hpp"
#include "input/parameters/effect_parameters.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/document.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using toml_text::list_value;
using toml_text::table_value;
using toml_text::text_value;
using toml_text::texts_value;

/// The values that differ from corner to corner.
void lay_corners_over(TomlValue& over, const Overlay& overlay) {
    std::vector<TomlValue> corners;
    std::set<std::string> done;
    for (std::size_t r = 0; r < overlay.runs.size(); ++r) {
        const OverlaidRun& run = overlay.runs[r];
        if (run.corner.empty() || !done.insert(run.corner).second) {
            continue;
        }
        TomlValue table = table_value();
        table.in_braces = false;
        table.set("name", text_value(run.corner));
        write_effects_of_run(table, *run.problem, overlay.parameters, r);
        if (table.entries.size() > 1) {
            corners.push_back(std::move(table));
        }
    }
    if (!corners.empty()) {
        over.set("corner", list_value(std::move(corners)));
    }
}

/// What a fitted case says of one run: its name where its file does not give it, its file, and how that is read.
TomlValue run_table_of(const OverlaidRun& run, const Overlay& overlay, const TomlValue& original,
                       const fs::path& folder) {
    const std::string& name = run.corner.empty() ? run.name : run.recording;
    TomlValue table = run_table_of_file(name, run.file, original.find("data"), folder);
    const TomlValue* list = original.find("run");
    const TomlValue* own = list != nullptr && run.file.empty() ? list->find_named(name) : nullptr;
    for (const ColumnChange& change : overlay.columns) {
        if (change.run.empty() ? own != nullptr && says_column(*own, change) : change.run == name) {
            change_column(table, change);
        }
    }
    return table;
}

/// The runs that start at fitted temperatures, and those whose files were given beside the case.
void lay_runs_over(TomlValue& over, const Overlay& overlay, const TomlValue& original, const fs::path& folder) {
    std::set<std::size_t> moved;
    for (const solver::FreeParameter& number : overlay.parameters) {
        if (is_initial(number)) {
            moved.insert(number.runs.begin(), number.runs.end());
        }
    }
    std::vector<TomlValue> runs;
    const OverlaidRun* last = nullptr;  // with a table; the corners of a run follow each other
    for (std::size_t i = 0; i < overlay.runs.size(); ++i) {
        const OverlaidRun& run = overlay.runs[i];
        const bool starts_elsewhere = moved.contains(i);
        if (run.file.empty() && !starts_elsewhere && overlay.columns.empty()) {
            continue;
        }
        const bool is_same_run = last != nullptr && !run.corner.empty() && last->recording == run.recording;
        if (!is_same_run) {
            runs.push_back(run_table_of(run, overlay, original, folder));
        }
        last = &run;
        if (!starts_elsewhere) {
            continue;
        }
        if (run.corner.empty()) {
            runs.back().set("initial", initial_value(*run.problem));
            continue;
        }
        TomlValue& corners = runs.back().at("corner");
        if (corners.kind == TomlValue::Kind::nothing) {
            corners = table_value();
        }
        corners.set(run.corner, table_value({{"initial", initial_value(*run.problem)}}));
    }
    if (!runs.empty()) {
        over.set("run", list_value(std::move(runs)));
    }
}

void write_head(CaseWriter& writer, const Overlay& overlay) {
    std::vector<std::string> to;
    for (const OverlaidRun& run : overlay.runs) {
        to.push_back(run.file.empty() ? run.name : run.file.filename().string());
    }
    const std::string values = to.empty() ? "fitted values" : fmt::format("values fitted to {}", listed(to));
    writer.remark(fmt::format("{}: {}", overlay.before->title, values));
    for (const std::string& remark : overlay.remarks) {
        writer.remark(remark);
    }
}

}  // namespace

std::string overlay_text(const Overlay& overlay, const fs::path& folder) {
    InputErrors errors;
    TomlValue original = read_document(overlay.original, errors).value_or(TomlValue{});
    TomlValue over = table_value();
    over.set("include", list_value({toml_text::path_value(overlay.original, folder)}));
    for (const ColumnChange& change : overlay.columns) {
        if (change.run.empty()) {
            TomlValue& data = original.at("data");
            if (data.kind != TomlValue::Kind::table) {
                data = table_value();
                data.in_braces = false;
            }
            change_column(data, change);
            over.set("data", data);
        }
    }
    if (const TomlValue* mesh = original.find("mesh");
        mesh != nullptr && (overlay.mesh.layers > 0.0 || overlay.mesh.finer > 1)) {
        over.set("unset", toml_text::texts_value({"mesh"}));
        TomlValue changed = *mesh;
        change_mesh(changed, overlay.mesh);
        over.set("mesh", std::move(changed));
    }
    for (const ParameterKind& kind : parameter_kinds()) {
        kind.write(over, overlay, original);
    }
    lay_corners_over(over, overlay);
    lay_runs_over(over, overlay, original, folder);
    CaseWriter writer;
    write_head(writer, overlay);
    writer.document(over);
    return writer.text();
}

}  // namespace tiretherm::input
