// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm inputs`: what a case can be driven with: unit, range, meaning, sign, and which effects and sensors read it; with
// Markdown it makes docs/inputs.md.

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/text/suggestions.hpp"
#include "input/vehicle/vehicle_log.hpp"
#include "physics/conventions.hpp"
#include "physics/effect.hpp"
#include "post/report/table.hpp"
#include "solver/quantity_inputs.hpp"

namespace tiretherm::app {

namespace {

using Json = nlohmann::ordered_json;

/// Who reads an input, by name.
struct Readers {
    std::vector<std::string> needed_by;  ///< effects that cannot act without it
    std::vector<std::string> used_by;    ///< effects that use it where it is given
    std::vector<std::string> sensors;    ///< kinds of sensors
};

Readers readers_of(std::string_view input) {
    const auto has = [&](std::span<const std::string_view> names) {
        return std::ranges::find(names, input) != names.end();
    };
    Readers readers;
    for (const physics::Effect* effect : physics::catalogue()) {
        if (has(effect->reads)) {
            readers.needed_by.emplace_back(effect->id);
        } else if (has(effect->may_read)) {
            readers.used_by.emplace_back(effect->id);
        }
    }
    for (const solver::QuantityDescription& quantity : solver::quantities()) {
        if (has(quantity.signals) || has(solver::optional_signals(quantity.quantity))) {
            readers.sensors.emplace_back(quantity.kind);
        }
    }
    return readers;
}

std::string unit_text(std::string_view unit) { return unit == "1" ? std::string("-") : std::string(unit); }

std::string range_text(const physics::Signal& signal) {
    return fmt::format("{:g} to {:g} {}", signal.low, signal.high, unit_text(signal.unit));
}

std::string capital(std::string_view text) {
    std::string result(text);
    result[0] = result[0] >= 'a' && result[0] <= 'z' ? static_cast<char>(result[0] - 'a' + 'A') : result[0];
    return result;
}

void print_one(const physics::Signal& signal) {
    const Readers readers = readers_of(signal.name);
    fmt::print("{} ({})\n{}", signal.name, range_text(signal),
               post::wrap(capital(signal.meaning) + ".", 4, prose_width()));
    fmt::print("{}", post::wrap(std::string(physics::sign_convention(signal)), 4, prose_width()));
    const auto line = [](const char* what, const std::vector<std::string>& names) {
        if (!names.empty()) {
            fmt::print("{}", post::wrap(fmt::format("{}: {}", what, fmt::join(names, ", ")), 4, prose_width()));
        }
    };
    line("Needed by the effects", readers.needed_by);
    line("Used where given by the effects", readers.used_by);
    line("Read by sensors of the kinds", readers.sensors);
}

Json as_json(const physics::Signal& signal) {
    const Readers readers = readers_of(signal.name);
    return {{"name", signal.name},
            {"unit", signal.unit},
            {"low", signal.low},
            {"high", signal.high},
            {"meaning", signal.meaning},
            {"sign", physics::sign_convention(signal)},
            {"needed_by", readers.needed_by},
            {"used_by", readers.used_by},
            {"sensors", readers.sensors}};
}

constexpr std::string_view page_head =
    "# Inputs, axes and signs\n\n"
    "What a case can be driven with, in `[drive]` or by the columns of a log. This page is written by `tiretherm "
    "inputs --markdown` from what the code\nknows; do not edit it. Formulas of `[[source]]` and `[[exchange]]` may "
    "follow every input. Units are those inside;\na case and a log may have any of the same kind.\n\n"
    "![The tire from above and from behind, with axes and positive directions](axes.svg)\n\n"
    "The axes are those of ISO 8855: x forwards, y to the left, z up. Drawn is a tire on the right-hand side of the "
    "vehicle: outside, or\noutboard, is to its right. The arc length along the meridian counts from the centre plane, "
    "negative outboard.\n\n"
    "**Left and right.** Heat does not tell the sides of a vehicle apart: camber is that of the vehicle, and slip and "
    "forces count by their\nmagnitude. Only `pressure_across_tread`, where the lateral force loads one shoulder, and "
    "sensors that read the Magic Formula do. For a\ntire on the left turn the signs of `slip_angle` and of the forces "
    "read across: it is then the tire on the right in a mirror.\n";

std::string range_text(const input::VehicleSignal& signal) {
    return signal.unit.empty() ? "any unit" : fmt::format("{:g} to {:g} {}", signal.low, signal.high, signal.unit);
}

constexpr std::string_view of_a_car =
    "Columns of a log in a case with [vehicle], which makes load, slips and forces of each tire out of them and of "
    "speed";

void print_of_a_car(const input::VehicleSignal& signal) {
    fmt::print("{} ({})\n{}", signal.name, range_text(signal),
               post::wrap(capital(signal.meaning) + ". In a case with [vehicle].", 4, prose_width()));
}

Json as_json(const input::VehicleSignal& signal) {
    return {{"name", signal.name},
            {"unit", signal.unit},
            {"low", signal.low},
            {"high", signal.high},
            {"meaning", signal.meaning}};
}

void print_markdown_of_a_car() {
    fmt::print("\n## Signals of a car\n\n{} ([page](vehicle.md)).\n\n| column | range | meaning |\n|---|---|---|\n",
               of_a_car);
    for (const input::VehicleSignal& signal : input::vehicle_signals()) {
        fmt::print("| `{}` | {} | {} |\n", signal.name, range_text(signal), signal.meaning);
    }
}

void print_markdown() {
    fmt::print("{}", page_head);
    const auto names = [](const std::vector<std::string>& all) {
        return all.empty() ? std::string("-") : fmt::format("{}", fmt::join(all, ", "));
    };
    for (const physics::Signal& signal : physics::signals()) {
        const Readers readers = readers_of(signal.name);
        fmt::print("\n## {}\n\n{}, {}. {}\n\n", signal.name, capital(signal.meaning), range_text(signal),
                   physics::sign_convention(signal));
        fmt::print("| needed by the effects | used where given | sensors |\n|---|---|---|\n| {} | {} | {} |\n",
                   names(readers.needed_by), names(readers.used_by), names(readers.sensors));
    }
    print_markdown_of_a_car();
}

struct InputsOptions {
    std::string name;
    bool json = false;
    bool markdown = false;
};

int show(const InputsOptions& options) {
    const physics::Signal* one = options.name.empty() ? nullptr : physics::find_signal(options.name);
    const std::span<const input::VehicleSignal> car = input::vehicle_signals();
    const auto of_car = std::ranges::find(car, options.name, &input::VehicleSignal::name);
    if (!options.name.empty() && one == nullptr && of_car == car.end()) {
        std::vector<std::string> known;
        for (const physics::Signal& signal : physics::signals()) {
            known.emplace_back(signal.name);
        }
        std::ranges::transform(car, std::back_inserter(known),
                               [](const input::VehicleSignal& signal) { return std::string(signal.name); });
        report_error(fmt::format("there is no input \"{}\"", options.name),
                     input::suggest(options.name, known, "inputs"), options.json);
        return Exit::input_error;
    }
    if (options.markdown) {
        print_markdown();
    } else if (of_car != car.end()) {
        if (options.json) {
            fmt::print("{}\n", as_json(*of_car).dump(2));
        } else {
            print_of_a_car(*of_car);
        }
    } else if (options.json && one != nullptr) {
        fmt::print("{}\n", as_json(*one).dump(2));
    } else if (options.json) {
        Json all{{"inputs", Json::array()}};
        for (const physics::Signal& signal : physics::signals()) {
            all["inputs"].push_back(as_json(signal));
        }
        for (const input::VehicleSignal& signal : car) {
            all["of_a_car"].push_back(as_json(signal));
        }
        fmt::print("{}\n", all.dump(2));
    } else if (one != nullptr) {
        print_one(*one);
    } else {
        for (const physics::Signal& signal : physics::signals()) {
            print_one(signal);
        }
        fmt::print("\n{}", post::wrap(std::string(of_a_car) + ":", 0, prose_width()));
        for (const input::VehicleSignal& signal : car) {
            print_of_a_car(signal);
        }
        fmt::print(
            "\nAxes: x forwards, y to the left, z up, of a tire on the right-hand side of the vehicle; drawn in "
            "docs/inputs.md\n");
    }
    return Exit::done;
}

}  // namespace

void add_inputs_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("inputs", "List the inputs of a case: unit, sign, and what reads them");
    const auto options = std::make_shared<InputsOptions>();
    command->add_option("INPUT", options->name, "Name of an input; without it all are listed")->option_text(" ");
    CLI::Option* json = command->add_flag("--json", options->json, "One JSON object");
    command->add_flag("--markdown", options->markdown, "The page docs/inputs.md")->excludes(json);
    command->footer(
        "Example:\n"
        "  tiretherm inputs\n"
        "  tiretherm inputs camber");
    command->callback([options, &exit_code] { exit_code = show(*options); });
}

}  // namespace tiretherm::app
