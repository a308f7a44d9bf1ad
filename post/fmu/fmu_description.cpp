// SPDX-License-Identifier: BSD-3-Clause
// The description in the order and with the attributes of the schemas of FMI 2.0 and FMI 3.0.

#include "post/fmu/fmu_description.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "post/fmu/unit_definition.hpp"

namespace tiretherm::post {

namespace {

using Role = FmuVariable::Role;

/// A text as it may stand in XML, also between quotation marks.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return result;
}

std::string attribute(std::string_view key, std::string_view value) {
    return value.empty() ? std::string() : fmt::format(" {}=\"{}\"", key, escaped(value));
}

std::string bound(std::string_view key, double value) {
    return std::isfinite(value) ? fmt::format(" {}=\"{}\"", key, value) : std::string();
}

std::string_view causality(Role role) {
    switch (role) {
        case Role::input:
            return "input";
        case Role::parameter:
            return "parameter";
        case Role::output:
            return "output";
    }
    return "";
}

/// What both versions write of a variable's place in the model.
std::string head_of(const FmuVariable& variable, std::size_t number) {
    const bool is_parameter = variable.role == Role::parameter;
    return attribute("name", variable.name) + fmt::format(" valueReference=\"{}\"", number) +
           attribute("description", variable.meaning) + attribute("causality", causality(variable.role)) +
           attribute("variability", !is_parameter    ? "continuous"
                                    : variable.fixed ? "fixed"
                                                     : "tunable") +
           attribute("initial", is_parameter                    ? "exact"
                                : variable.role == Role::output ? "calculated"
                                                                : "");
}

/// And of its value.
std::string value_of(const FmuVariable& variable) {
    const bool is_output = variable.role == Role::output;
    return attribute("unit", fmi_unit(variable.unit)) +
           attribute("displayUnit", variable.difference ? "" : fmi_display_unit(variable.unit)) +
           attribute("relativeQuantity", variable.difference ? "true" : "") + bound("min", variable.low) +
           bound("max", variable.high) + (is_output ? "" : fmt::format(" start=\"{}\"", variable.start));
}

std::string units_of(const FmuContent& content) {
    std::set<std::string> units;
    for (const FmuVariable& variable : content.variables) {
        units.insert(variable.unit);
    }
    if (content.version == FmiVersion::fmi3) {
        units.insert("s");  // of the time, which only this version lists
    }
    std::string text = "  <UnitDefinitions>\n";
    for (const std::string& unit : units) {
        text += fmt::format("    {}\n", fmi_unit_definition(unit));
    }
    return text + "  </UnitDefinitions>\n";
}

/// Categories of its log, in both versions.
constexpr std::string_view categories =
    "  <LogCategories>\n"
    "    <Category name=\"logEvents\" description=\"what the environment has set off\"/>\n"
    "    <Category name=\"logStatusDiscard\" description=\"calls that changed nothing: a value out of range, a step "
    "without solution\"/>\n"
    "    <Category name=\"logStatusError\" description=\"calls that failed\"/>\n"
    "    <Category name=\"logAll\" description=\"all of them\"/>\n"
    "  </LogCategories>\n";

/// Length of a step that a thermal model of a tire takes well, and that a short experiment has a hundred of. s
double step_of(const FmuContent& content) { return std::min(0.1, 0.01 * content.end); }

std::string variables_of_fmi2(const FmuContent& content) {
    std::string text = "  <ModelVariables>\n";
    for (std::size_t i = 0; i < content.variables.size(); ++i) {
        text += fmt::format("    <ScalarVariable{}><Real{}/></ScalarVariable>\n", head_of(content.variables[i], i + 1),
                            value_of(content.variables[i]));
    }
    return text + "  </ModelVariables>\n";
}

std::string variables_of_fmi3(const FmuContent& content) {
    std::string text =
        "  <ModelVariables>\n"
        "    <Float64 name=\"time\" valueReference=\"0\" causality=\"independent\" variability=\"continuous\" "
        "unit=\"s\"/>\n";
    for (std::size_t i = 0; i < content.variables.size(); ++i) {
        text +=
            fmt::format("    <Float64{}{}/>\n", head_of(content.variables[i], i + 1), value_of(content.variables[i]));
    }
    return text + "  </ModelVariables>\n";
}

/// All outputs, which at a communication point follow from the state alone, and in initialization mode from all that is set.
std::string structure_of(const FmuContent& content) {
    const bool is_2 = content.version == FmiVersion::fmi2;
    std::string outputs;
    std::string unknowns;
    for (std::size_t i = 0; i < content.variables.size(); ++i) {
        if (content.variables[i].role == Role::output) {
            // Without the time in its list, the index of FMI 2 is the number as well.
            outputs += is_2 ? fmt::format("      <Unknown index=\"{}\" dependencies=\"\"/>\n", i + 1)
                            : fmt::format("    <Output valueReference=\"{}\" dependencies=\"\"/>\n", i + 1);
            unknowns += is_2 ? fmt::format("      <Unknown index=\"{}\"/>\n", i + 1)
                             : fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", i + 1);
        }
    }
    if (is_2 && !outputs.empty()) {
        outputs = fmt::format("    <Outputs>\n{}    </Outputs>\n", outputs);
        unknowns = fmt::format("    <InitialUnknowns>\n{}    </InitialUnknowns>\n", unknowns);
    }
    return fmt::format("  <ModelStructure>\n{}{}  </ModelStructure>\n", outputs, unknowns);
}

FmuVariable input_variable(const solver::SessionModel& model, const physics::Signal& signal) {
    return {.name = std::string(signal.name),
            .meaning = std::string(signal.meaning),
            .unit = std::string(signal.unit),
            .role = Role::input,
            .low = signal.low,
            .high = signal.high,
            .start = model.start.*signal.member};
}

FmuVariable parameter_variable(const solver::SessionModel& model, const solver::FreeParameter& parameter) {
    const bool is_initial = parameter.kind == solver::FreeParameter::Kind::initial;
    bool difference = is_initial;
    std::string meaning = is_initial ? "shift of the initial temperatures" : "";
    if (parameter.kind == solver::FreeParameter::Kind::effect) {
        const physics::Effect& effect = *model.problem.effects[parameter.effect].effect;
        meaning = effect.parameters[parameter.parameter].meaning;
        difference = effect.parameters[parameter.parameter].difference;
    }
    return {.name = parameter.name,
            .meaning = std::move(meaning),
            .unit = parameter.unit,
            .role = Role::parameter,
            .difference = difference,
            .fixed = is_initial,
            .low = parameter.low,
            .high = parameter.high,
            .start = solver::value_of(model.problem, parameter)};
}

}  // namespace

std::vector<FmuVariable> fmu_variables(const solver::SessionModel& model) {
    std::vector<FmuVariable> variables;
    for (const physics::Signal* signal : model.inputs()) {
        variables.push_back(input_variable(model, *signal));
    }
    for (const solver::FreeParameter& parameter : model.parameters) {
        variables.push_back(parameter_variable(model, parameter));
    }
    for (const solver::Channel& channel : model.problem.channels) {
        variables.push_back({.name = channel.name,
                             .meaning = channel.meaning,
                             .unit = std::string(solver::unit_of(channel.quantity)),
                             .role = Role::output});
    }
    std::set<std::string> taken{"time"};
    for (FmuVariable& variable : variables) {
        while (!taken.insert(variable.name).second) {
            variable.name += fmt::format("_{}", causality(variable.role));
        }
    }
    return variables;
}

std::string model_description(const FmuContent& content) {
    const bool is_2 = content.version == FmiVersion::fmi2;
    const std::string_view state = is_2 ? "state" : "State";
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription";
    text += attribute("fmiVersion", is_2 ? "2.0" : "3.0") + attribute("modelName", content.name) +
            attribute(is_2 ? "guid" : "instantiationToken", content.token) + attribute("description", content.title) +
            attribute("license", "documentation/licenses") + attribute("generationTool", content.program) + ">\n";
    text += fmt::format(
        "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"true\" "
        "canGetAndSetFMU{}=\"true\" canSerializeFMU{}=\"true\" providesDirectionalDerivative{}=\"true\"{}/>\n",
        content.identifier, state, state, is_2 ? "" : "s", is_2 ? " canNotUseMemoryManagementFunctions=\"true\"" : "");
    text += units_of(content);
    text += categories;
    text += fmt::format("  <DefaultExperiment startTime=\"0\" stopTime=\"{}\" stepSize=\"{}\"/>\n", content.end,
                        step_of(content));
    text += is_2 ? variables_of_fmi2(content) : variables_of_fmi3(content);
    return text + structure_of(content) + "</fmiModelDescription>\n";
}

std::string fmu_page(const FmuContent& content) {
    std::string rows;
    for (const FmuVariable& variable : content.variables) {
        const bool is_output = variable.role == Role::output;
        rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            escaped(variable.name), causality(variable.role), fmi_unit(variable.unit),
                            is_output ? "" : fmt::format("{:.6g}", variable.start), escaped(variable.meaning));
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}</title></head>\n<body>\n"
        "<h1>{0}</h1>\n<p>{1}</p>\n"
        "<p>Temperatures of a tire, by {2}, for co-simulation. A step of the environment is one step of the case's "
        "method. What an input is set to holds at the end of the next step; from the step before, it goes there in a "
        "straight line. Temperatures begin as the case says.</p>\n"
        "<p>resources/case.toml is the case, with all that it includes; it is there to be read, the FMU does not "
        "need it.</p>\n"
        "<table>\n<tr><th>variable</th><th>causality</th><th>unit</th><th>start</th><th>meaning</th></tr>\n"
        "{3}</table>\n</body>\n</html>\n",
        escaped(content.name), escaped(content.title), content.program, rows);
}

}  // namespace tiretherm::post
