#include "input/parameters/fitted_case.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "input/parameters/fitted_effects.hpp"
#include "input/text/document.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/toml_text.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using Kind = solver::FreeParameter::Kind;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A law's value as it was fitted: evaluating the law has left a few units in the last place.
double tidy(double value) {
    const double twelve_digits = std::stod(fmt::format("{:.12g}", value));
    return std::abs(twelve_digits - value) <= 1e-14 * std::abs(value) ? twelve_digits : value;
}

/// A law in the form that gives it back: through the temperatures at which it was fitted where they make it up, about
/// one of them otherwise; a table as its points.
std::string law_text(const physics::Curve& law, const std::vector<double>& knots, std::string_view unit) {
    if (law.is_table()) {
        std::string rows;
        for (std::size_t i = 0; i < law.table_x().size(); ++i) {
            rows += fmt::format("{}[{}, {}]", i > 0 ? ", " : "", law.table_x()[i], law.table_y()[i]);
        }
        return fmt::format("{{ columns = [\"temperature [K]\", \"value [{}]\"], rows = [{}] }}", unit, rows);
    }
    if (law.is_constant()) {
        return toml_text::quantity(law.value(0.0), unit);
    }
    const double curvature = law.coefficients()[2];
    if (knots.size() == 3 || (knots.size() == 2 && curvature == 0.0)) {
        std::string points;
        for (const double T : knots) {
            points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", toml_text::temperature(T),
                                  toml_text::quantity(tidy(law.value(T)), unit));
        }
        return fmt::format("{{ through = [{}] }}", points);
    }
    const double T = knots.front();
    std::string text = fmt::format("{{ at = {}, value = {}, slope = {}", toml_text::temperature(T),
                                   toml_text::quantity(tidy(law.value(T)), unit),
                                   toml_text::quantity(law.slope(T), fmt::format("{}/K", unit)));
    if (curvature != 0.0) {
        text += fmt::format(", curvature = {}", toml_text::quantity(curvature, fmt::format("{}/K2", unit)));
    }
    return text + " }";
}

/// Laws of a material by their keys, in the case's words.
using Laws = std::map<std::string, std::string>;

/// Whether the original case gives a material's key.
bool gives(const TomlValue& original, const std::string& material, std::string_view key) {
    const TomlValue* list = original.find("material");
    for (const TomlValue& entry : list != nullptr ? list->items : std::vector<TomlValue>{}) {
        const TomlValue* name = entry.find("name");
        if (name != nullptr && name->text == material) {
            return entry.find(key) != nullptr;
        }
    }
    return false;
}

std::string materials_text(const FittedCase& fitted, const TomlValue& original) {
    std::map<std::string, Laws> materials;
    for (const solver::FreeParameter& number : fitted.parameters) {
        if (number.kind != Kind::conductivity && number.kind != Kind::heat_capacity) {
            continue;
        }
        const physics::Material& material = fitted.fitted->materials[at(number.layers.front())];
        Laws& laws = materials[material.name];
        if (number.kind == Kind::heat_capacity) {
            laws["heat_capacity"] = law_text(material.heat_capacity, number.knots, "J/kgK");
            continue;
        }
        const physics::Curve& through = material.along(mesh::Axis::through);
        laws["conductivity"] = law_text(through, number.knots, "W/mK");
        // What the case does not give follows by itself.
        for (const auto& [key, axis] : {std::pair{"conductivity_meridian", mesh::Axis::meridian},
                                        std::pair{"conductivity_circumference", mesh::Axis::circumference}}) {
            if (material.along(axis) == through && gives(original, material.name, key)) {
                laws[key] = laws["conductivity"];
            }
        }
    }
    std::string text;
    for (const auto& [name, laws] : materials) {
        text += fmt::format("\n[[material]]\nname = {}\n", toml_text::in_quotes(name));
        for (const auto& [key, law] : laws) {
            text += fmt::format("{} = {}\n", key, law);
        }
    }
    return text;
}

std::string link_text(const FittedCase& fitted) {
    for (const solver::FreeParameter& number : fitted.parameters) {
        if (number.kind == Kind::link_conductivity) {
            return fmt::format("\n[mesh]\nlink_conductivity = {}\n",
                               law_text(fitted.fitted->link_laws.front(), number.knots, "W/mK"));
        }
    }
    return {};
}

/// Initial temperatures as key = value, all of them: a key that the original has would win over a general one.
std::vector<std::string> initial_lines(const solver::Problem& problem) {
    const mesh::Mesh& mesh = problem.mesh;
    std::vector<std::string> lines;
    for (std::size_t layer = 0; layer < mesh.layers.size(); ++layer) {
        const auto node = std::find(mesh.layer.begin(), mesh.layer.end(), static_cast<int>(layer)) - mesh.layer.begin();
        lines.push_back(fmt::format("{} = {}", toml_text::key(mesh.layers[layer]),
                                    toml_text::temperature(problem.initial[static_cast<std::size_t>(node)])));
    }
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        lines.push_back(fmt::format("{} = {}", toml_text::key(lumped_node.name),
                                    toml_text::temperature(problem.initial[at(lumped_node.node)])));
    }
    return lines;
}

/// The runs that start at fitted temperatures, and those whose files were given beside the case.
std::string runs_text(const FittedCase& fitted, const TomlValue& original, const fs::path& folder) {
    const TomlValue* data = original.find("data");  // how columns of files beside the case are read
    std::set<int> moved;
    for (const solver::FreeParameter& number : fitted.parameters) {
        if (number.kind == Kind::initial) {
            moved.insert(number.run);
        }
    }
    std::string text;
    if (moved.contains(-1)) {
        text += "\n[initial]\n";
        for (const std::string& line : initial_lines(*fitted.fitted)) {
            text += line + "\n";
        }
    }
    for (std::size_t i = 0; i < fitted.runs.size(); ++i) {
        const FittedRun& run = fitted.runs[i];
        const bool starts_elsewhere = moved.contains(static_cast<int>(i));
        if (run.file.empty() && !starts_elsewhere) {
            continue;
        }
        text += "\n[[run]]\n";
        // A list in which a name is missing takes the place of the original's runs instead of joining them.
        if (run.file.empty() || run.name != run.file.stem().string()) {
            text += fmt::format("name = {}\n", toml_text::in_quotes(run.name));
        }
        if (!run.file.empty()) {
            text += fmt::format("file = {}\n", toml_text::path(run.file, folder));
            for (const Entry& entry : data != nullptr ? data->entries : std::vector<Entry>{}) {
                text += fmt::format("{} = {}\n", toml_text::key(entry.key), toml_text::value(entry.value));
            }
        }
        if (starts_elsewhere) {
            text += fmt::format("initial = {{ {} }}\n", fmt::join(initial_lines(*run.problem), ", "));
        }
    }
    return text;
}

std::string heading(const FittedCase& fitted) {
    std::vector<std::string> to;
    for (const FittedRun& run : fitted.runs) {
        to.push_back(run.file.empty() ? run.name : run.file.filename().string());
    }
    std::string text = fmt::format("# {}", fitted.before->title);
    text += to.empty() ? ": fitted values\n" : fmt::format(": values fitted to {}\n", listed(to));
    for (const std::string& remark : fitted.remarks) {
        text += "# " + remark + "\n";
    }
    std::replace_if(
        text.begin(), text.end() - 1, [](char c) { return c != '\n' && static_cast<unsigned char>(c) < ' '; }, ' ');
    return text;
}

}  // namespace

std::string fitted_case(const FittedCase& fitted, const fs::path& folder) {
    InputErrors errors;
    const std::optional<TomlValue> original = read_document(fitted.original, errors);
    return heading(fitted) + fmt::format("include = [{}]\n", toml_text::path(fitted.original, folder)) +
           effects_text(*fitted.before, *fitted.fitted, fitted.parameters, fitted.user_effects) + link_text(fitted) +
           materials_text(fitted, original.value_or(TomlValue{})) +
           runs_text(fitted, original.value_or(TomlValue{}), folder);
}

void write_fitted_case(const FittedCase& fitted, const fs::path& file) {
    const std::string text = fitted_case(fitted, file.parent_path().empty() ? fs::path(".") : file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    if (stream) {
        stream << text;
        stream.close();
    }
    if (!stream) {
        throw std::system_error(errno, std::generic_category(), file.string());
    }
}

}  // namespace tiretherm::input
