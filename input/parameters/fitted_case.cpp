// SPDX-License-Identifier: BSD-3-Clause
// A fitted case: the original included, and what was fitted laid over it at the paths of its numbers.
#include "input/parameters/fitted_case.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "input/parameters/fitted_effects.hpp"
#include "input/text/characters.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/document.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using Kind = solver::FreeParameter::Kind;
using toml_text::list_value;
using toml_text::quantity_value;
using toml_text::table_value;
using toml_text::temperature_value;
using toml_text::text_value;
using toml_text::texts_value;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A law's value as it was fitted: evaluating the law has left a few units in the last place.
double tidy(double value) {
    const double twelve_digits = std::stod(fmt::format("{:.12g}", value));
    return std::abs(twelve_digits - value) <= 1e-14 * std::abs(value) ? twelve_digits : value;
}

/// Adds the range beyond which a law is held.
TomlValue with_range(TomlValue law_table, const physics::Curve& law) {
    if (const auto range = law.range()) {
        law_table.set("range", list_value({temperature_value((*range)[0]), temperature_value((*range)[1])}));
    }
    return law_table;
}

/// A law in the form that gives it back: through the temperatures at which it was fitted where they make it up, about
/// one of them otherwise; a table as its points.
TomlValue law_value(const physics::Curve& law, const std::vector<double>& knots, const std::string& unit) {
    const auto point = [&](double T) {
        return list_value({temperature_value(T), quantity_value(tidy(law.value(T)), unit)});
    };
    if (law.is_table()) {
        std::vector<TomlValue> rows;
        for (std::size_t i = 0; i < law.table_x().size(); ++i) {
            rows.push_back(list_value({quantity_value(law.table_x()[i], "1"), quantity_value(law.table_y()[i], "1")}));
        }
        return table_value({{"columns", texts_value({"temperature [K]", fmt::format("value [{}]", unit)})},
                            {"rows", list_value(std::move(rows))}});
    }
    if (law.is_constant()) {
        return quantity_value(law.value(0.0), unit);
    }
    const double curvature = law.coefficients()[2];
    if (knots.size() == 3 || (knots.size() == 2 && curvature == 0.0)) {
        std::vector<TomlValue> points;
        std::ranges::transform(knots, std::back_inserter(points), point);
        return with_range(table_value({{"through", list_value(std::move(points))}}), law);
    }
    const double T = knots.front();
    TomlValue about = table_value({{"at", temperature_value(T)},
                                   {"value", quantity_value(tidy(law.value(T)), unit)},
                                   {"slope", quantity_value(law.slope(T), unit + "/K")}});
    if (curvature != 0.0) {
        about.set("curvature", quantity_value(curvature, unit + "/K2"));
    }
    return with_range(std::move(about), law);
}

/// The laws that were fitted: of the link first, then of materials.
void lay_laws_over(TomlValue& over, const FittedCase& fitted, const TomlValue& original) {
    for (const Kind kind : {Kind::link_conductivity, Kind::conductivity, Kind::heat_capacity}) {
        for (const solver::FreeParameter& number : fitted.parameters) {
            if (number.kind != kind) {
                continue;
            }
            const physics::Curve& fitted_law = *solver::law_of(*fitted.fitted, number);
            const TomlValue law = law_value(fitted_law, number.knots, kind == Kind::heat_capacity ? "J/kgK" : "W/mK");
            ParameterPath path = ParameterPath::of(*fitted.fitted, number);
            lay_over(over, path, law);
            if (kind != Kind::conductivity) {
                continue;
            }
            // What the case does not give follows by itself.
            const physics::Material& material = fitted.fitted->materials[at(number.layers.front())];
            for (const auto& [key, axis] : {std::pair{"conductivity_circumference", mesh::Axis::circumference},
                                            std::pair{"conductivity_meridian", mesh::Axis::meridian}}) {
                path.keys.back().text = key;
                if (material.along(axis) == fitted_law && path.find(original) != nullptr) {
                    lay_over(over, path, law);
                }
            }
        }
    }
    if (TomlValue* materials = over.find("material")) {  // whatever the order of the numbers
        std::ranges::sort(materials->items, {},
                          [](const TomlValue& material) { return material.entries.front().value.text; });
    }
}

/// Initial temperatures, all of them: a key that the original has would win over a general one.
TomlValue initial_value(const solver::Problem& problem) {
    const mesh::Mesh& mesh = problem.mesh;
    TomlValue table = table_value();
    for (std::size_t layer = 0; layer < mesh.layers.size(); ++layer) {
        const auto node = std::ranges::find(mesh.layer, static_cast<int>(layer)) - mesh.layer.begin();
        table.set(mesh.layers[layer], temperature_value(problem.initial[static_cast<std::size_t>(node)]));
    }
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        table.set(lumped_node.name, temperature_value(problem.initial[at(lumped_node.node)]));
    }
    return table;
}

/// The numbers of the car that were fitted.
void lay_vehicle_over(TomlValue& over, const FittedCase& fitted) {
    for (const solver::FreeParameter& number : fitted.parameters) {
        if (number.kind == Kind::input) {
            lay_over(over, ParameterPath::of(*fitted.fitted, number),
                     quantity_value(fitted.fitted->input_numbers[number.parameter], number.unit));
        }
    }
}

/// A value of the case as a value in braces or brackets, whether or not it had a heading of its own.
TomlValue in_one_line(TomlValue value) {
    value.in_braces = true;
    for (TomlValue& item : value.items) {
        item.in_braces = true;
    }
    return value;
}

/// The values that differ from corner to corner.
void lay_corners_over(TomlValue& over, const FittedCase& fitted) {
    std::vector<TomlValue> corners;
    std::set<std::string> done;
    for (std::size_t r = 0; r < fitted.runs.size(); ++r) {
        const FittedRun& run = fitted.runs[r];
        if (run.corner.empty() || !done.insert(run.corner).second) {
            continue;
        }
        TomlValue table = table_value();
        table.in_braces = false;
        table.set("name", text_value(run.corner));
        lay_corner_over(table, *run.problem, fitted.parameters, r);
        if (table.entries.size() > 1) {
            corners.push_back(std::move(table));
        }
    }
    if (!corners.empty()) {
        over.set("corner", list_value(std::move(corners)));
    }
}

/// What a fitted case says of one run: its name where its file does not give it, its file, and how that is read.
TomlValue run_table_of(const FittedRun& run, const TomlValue* data, const fs::path& folder) {
    TomlValue table = table_value();
    table.in_braces = false;
    const std::string& name = run.corner.empty() ? run.name : run.recording;
    // A list in which a name is missing takes the place of the original's runs instead of joining them.
    if (run.file.empty() || name != run.file.stem().string()) {
        table.set("name", text_value(name));
    }
    if (!run.file.empty()) {
        table.set("file", toml_text::path_value(run.file, folder));
        for (const Entry& entry : data != nullptr ? data->entries : std::vector<Entry>{}) {
            table.set(entry.key, in_one_line(entry.value));
        }
    }
    return table;
}

/// The runs that start at fitted temperatures, and those whose files were given beside the case.
void lay_runs_over(TomlValue& over, const FittedCase& fitted, const TomlValue& original, const fs::path& folder) {
    const TomlValue* data = original.find("data");  // how columns of files beside the case are read
    std::set<std::size_t> moved;
    bool moved_everywhere = false;
    for (const solver::FreeParameter& number : fitted.parameters) {
        if (number.kind == Kind::initial) {
            moved.insert(number.runs.begin(), number.runs.end());
            moved_everywhere = moved_everywhere || number.runs.empty();
        }
    }
    if (moved_everywhere) {
        TomlValue initial = initial_value(*fitted.fitted);
        initial.in_braces = false;
        over.set("initial", std::move(initial));
    }
    std::vector<TomlValue> runs;
    const FittedRun* last = nullptr;  // with a table; the corners of a run follow each other
    for (std::size_t i = 0; i < fitted.runs.size(); ++i) {
        const FittedRun& run = fitted.runs[i];
        const bool starts_elsewhere = moved.contains(i);
        if (run.file.empty() && !starts_elsewhere) {
            continue;
        }
        const bool is_same_run = last != nullptr && !run.corner.empty() && last->recording == run.recording;
        if (!is_same_run) {
            runs.push_back(run_table_of(run, data, folder));
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

std::string heading(const FittedCase& fitted) {
    std::vector<std::string> to;
    for (const FittedRun& run : fitted.runs) {
        to.push_back(run.file.empty() ? run.name : run.file.filename().string());
    }
    // A title, a file or a remark of several lines must not end the comment.
    const std::string values = to.empty() ? "fitted values" : fmt::format("values fitted to {}", listed(to));
    std::string text = fmt::format("# {}: {}\n", printable(fitted.before->title), printable(values));
    for (const std::string& remark : fitted.remarks) {
        text += fmt::format("# {}\n", printable(remark));
    }
    return text;
}

}  // namespace

std::string fitted_case(const FittedCase& fitted, const fs::path& folder) {
    InputErrors errors;
    const TomlValue original = read_document(fitted.original, errors).value_or(TomlValue{});
    TomlValue over = table_value();
    over.set("include", list_value({toml_text::path_value(fitted.original, folder)}));
    if (const TomlValue* mesh = original.find("mesh");
        mesh != nullptr && (fitted.mesh.layers > 0.0 || fitted.mesh.finer > 1)) {
        over.set("unset", toml_text::texts_value({"mesh"}));
        TomlValue changed = *mesh;
        change_mesh(changed, fitted.mesh);
        over.set("mesh", std::move(changed));
    }
    lay_effects_over(over, *fitted.before, *fitted.fitted, fitted.parameters, fitted.user_effects);
    lay_laws_over(over, fitted, original);
    lay_vehicle_over(over, fitted);
    lay_corners_over(over, fitted);
    lay_runs_over(over, fitted, original, folder);
    return heading(fitted) + toml_text::document(over);
}

}  // namespace tiretherm::input
