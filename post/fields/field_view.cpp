// SPDX-License-Identifier: BSD-3-Clause
// The state file is post/fields/assets/field_view.py, taken in by the assembler, below the values of the run.
#include "post/fields/field_view.hpp"

#include <string_view>

#include <fmt/format.h>

#include "post/report/value.hpp"

asm(".section .rodata\n"
    ".global tiretherm_field_view\n"
    "tiretherm_field_view:\n"
    ".incbin \"" TIRETHERM_FIELD_VIEW
    "\"\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const char tiretherm_field_view[];

namespace tiretherm::post {

namespace {

/// Texts in JSON are texts in Python.
std::string quoted(const std::string& text) { return compact_json(text); }

std::string quoted(const std::vector<std::string>& texts) {
    Value::List list;
    for (const std::string& text : texts) {
        list.emplace_back(text);
    }
    return compact_json(list);
}

std::string_view kind_of(const FieldView& view) {
    const mesh::Mesh& mesh = view.problem.mesh;
    if (mesh.is_ring()) {
        return "ring";
    }
    if (mesh.is_section()) {
        return "section";
    }
    switch (view.shape) {
        case mesh::CellShape::vertex:
            return "nodes";
        case mesh::CellShape::line:
            return "layers";
        case mesh::CellShape::quadrilateral:
            return mesh.grid->metric == mesh::Metric::axisymmetric ? "disc" : "plane";
        case mesh::CellShape::hexahedron:
            return "block";
    }
    return "";
}

}  // namespace

std::string field_view(const FieldView& view) {
    const solver::Problem& problem = view.problem;
    const std::string values = fmt::format(
        "TITLE = {}\nKIND = \"{}\"\nSTEADY = {}\nLOWEST = {:.6g}          # degC, of all times\n"
        "HIGHEST = {:.6g}         # degC\nHOTTEST_TIME = {:.12g}      # s\nEND = {:.12g}               # s, the time "
        "that is shown first\n"
        "LAYERS = {}\nZONES = {}\n",
        quoted(problem.title.empty() ? problem.name : problem.title), kind_of(view),
        problem.settings.steady ? "True" : "False", view.low, view.high, view.hottest_time, view.end,
        quoted(problem.mesh.layers), quoted(problem.mesh.zones));
    std::string text = tiretherm_field_view;
    constexpr std::string_view mark = "# VALUES OF THE RUN\n";
    return text.replace(text.find(mark), mark.size(), values);
}

}  // namespace tiretherm::post
