// SPDX-License-Identifier: BSD-3-Clause
// The command line of `tiretherm new`: a first case from a tire's size or from a data logger's file.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/given_units.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "app/terminal.hpp"
#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "input/files/nearby_file.hpp"
#include "input/log_survey/log_survey.hpp"
#include "input/new_case/new_case.hpp"
#include "input/text/characters.hpp"
#include "input/text/word_lists.hpp"
#include "post/report/file.hpp"
#include "post/report/table.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view assumed_size = "225/50 R17";

struct NewOptions {
    std::string subject;
    std::string file;
    std::string size;
    std::string mesh;
    std::string pressure;
    bool specimen = false;
    std::string test;
    std::string materials;
    std::vector<std::string> units;
    bool force = false;
    bool json = false;
};

/// Whether the user names a file: one that is there, or a name that ends as a log's does.
bool is_log(const std::string& subject) {
    std::error_code error;
    return input::is_log_file(subject) || fs::exists(subject, error);
}

/// "225_50_R17.toml" of a size, "drive.toml" of drive.csv.
fs::path standard_file(const NewOptions& options, const input::NewCaseRequest& request) {
    std::string name = request.log               ? request.log->stem().string()
                       : options.subject.empty() ? std::string(input::specimen_mesh)
                                                 : std::string(input::trim(options.subject));
    name += options.test.empty() ? "" : "_" + options.test;
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == ' '; }, '_');
    return name + ".toml";
}

/// What the call asks for; nothing after an error, which has been reported.
std::optional<input::NewCaseRequest> read_request(const NewOptions& options) {
    input::NewCaseRequest request;
    const bool log = is_log(options.subject);
    if (log) {
        request.log = options.subject;
    }
    const bool specimen = options.specimen || options.mesh == input::specimen_mesh;
    if (options.subject.empty() && !specimen) {
        report_error("SIZE|LOG is required", "tiretherm new \"225/50 R17\", tiretherm new drive.csv, or --specimen",
                     options.json);
        return std::nullopt;
    }
    if (specimen && (!options.size.empty() || !options.pressure.empty() || (!log && !options.subject.empty()) ||
                     (!options.mesh.empty() && options.mesh != input::specimen_mesh))) {
        report_error("a specimen has no size, no inflation and a mesh of its own",
                     "tiretherm new --specimen, or tiretherm new laser.csv --specimen", options.json);
        return std::nullopt;
    }
    request.size_is_assumed = (log || specimen) && options.size.empty();
    const std::string size = request.size_is_assumed ? std::string(assumed_size) : log ? options.size : options.subject;
    const auto read = input::read_tire_size(size);
    if (const auto* error = std::get_if<input::ErrorText>(&read)) {
        const std::string near = log ? "" : input::nearby_file_remedy(options.subject);
        report_error(log ? error->what : fmt::format("\"{}\" is neither the size of a tire nor a file", size),
                     log             ? error->remedy
                     : !near.empty() ? near
                                     : error->remedy + ", or name a log: drive.csv",
                     options.json);
        return std::nullopt;
    }
    if (!log && !options.size.empty()) {
        report_error("two sizes are given", "leave --size to a log: tiretherm new drive.csv --size \"225/50 R17\"",
                     options.json);
        return std::nullopt;
    }
    request.size = std::get<input::TireSize>(read);
    if (!options.test.empty()) {
        const std::string other = log || specimen ? "--test needs a tire, and none is named"
                                  : !options.mesh.empty() && options.mesh != "section" ? "--test is for a cross-section"
                                                                                       : "";
        const auto test = input::drum_test(options.test, request.size);
        const auto* error = std::get_if<input::ErrorText>(&test);
        if (error != nullptr || !other.empty()) {
            report_error(
                other.empty() ? error->what : other,
                other.empty() ? error->remedy : "write tiretherm new \"225/50 R17 94H\" --test " + options.test,
                options.json);
            return std::nullopt;
        }
        request.test = std::get<input::DrumTest>(test);
    }
    request.literature = options.materials == "literature";
    if (request.literature && (specimen || !(options.mesh.empty() || options.mesh == "section"))) {
        report_error("--materials literature is for a cross-section", "leave it out, or take --mesh section",
                     options.json);
        return std::nullopt;
    }
    if (!options.pressure.empty()) {
        const input::ParsedQuantity pressure =
            input::parse_quantity(options.pressure, {.unit = "Pa", .low = 1e4, .high = 2e6}, "the inflation pressure");
        if (pressure.error) {
            report_error(pressure.error->what, pressure.error->remedy, options.json);
            return std::nullopt;
        }
        request.inflation_pressure = pressure.value;
    }
    const std::optional<std::vector<input::GivenUnit>> units = given_units(options.units, options.json);
    if (!units || (!log && !units->empty())) {
        if (units) {
            report_error("--unit needs a log, and there is none", "name a log: tiretherm new drive.csv", options.json);
        }
        return std::nullopt;
    }
    request.units = *units;
    request.mesh = specimen ? std::string(input::specimen_mesh) : request.literature ? "section" : options.mesh;
    request.target = options.file.empty() ? standard_file(options, request) : fs::path(options.file);
    return request;
}

bool is_specimen(const input::NewCase& made) { return made.mesh_name == input::specimen_mesh; }

std::string use_of(const input::LogColumn& column) {
    if (!column.other_use.empty()) {
        return std::string(input::text_of_other_use(column.other_use));
    }
    if (!column.is_used()) {
        const bool guess = !column.suggestion.empty() && column.suggestion != column.heading.name && !column.is_dropped;
        const bool asked = column.reason.ends_with('?');
        return guess ? fmt::format("not used; is it {}?{}{}", column.full_suggestion(), asked ? " " : "",
                                   asked ? column.reason : "")
                     : fmt::format("not used: {}", column.reason);
    }
    const std::string ground = column.unit_ground.empty() ? "" : fmt::format(" ({})", column.unit_remark());
    const std::string unit =
        column.unit.empty() || column.unit_is_given ? "" : fmt::format(", read in {}{}", column.unit, ground);
    const std::string kind = column.is_sensor ? "measured by the sensor " : column.is_input ? "input " : "";
    return kind + column.full_name() + unit;
}

void print_json(const input::NewCase& made, const input::NewCaseRequest& request) {
    Json json{{"case", request.target.generic_string()},
              {"size", is_specimen(made) ? Json() : Json(request.size.text)},
              {"mesh", made.mesh_name},
              {"log", nullptr},
              {"columns", Json::array()},
              {"assumed", Json::array()},
              {"missing", Json::array()},
              {"warnings", made.warnings},
              {"errors", Json::array()},
              {"mistakes", Json::array()}};
    if (made.log) {
        json["log"] = {{"file", made.log->path},       {"from", made.log->time.front()},
                       {"to", made.log->time.back()},  {"samples", made.log->time.size()},
                       {"reads", made.unread.empty()}, {"compares", made.log->use == input::LogUse::run}};
        for (const input::LogColumn& column : made.log->columns) {
            const std::string_view use = !column.other_use.empty() ? column.other_use
                                         : !column.is_used()       ? "not used"
                                         : column.is_sensor        ? "sensor"
                                         : column.is_input         ? "input"
                                                                   : "time";
            json["columns"].push_back({{"column", column.heading.name},
                                       {"unit", column.heading.unit ? Json(*column.heading.unit) : Json()},
                                       {"use", use},
                                       {"name", column.name},
                                       {"corner", column.corner},
                                       {"read_in", column.unit},
                                       {"suggestion", column.suggestion},
                                       {"suggested_unit", column.suggested_unit},
                                       {"reason", column.reason}});
        }
    }
    for (const input::AssumedValue& value : made.assumed) {
        json["assumed"].push_back({{"key", value.key}, {"value", value.value}, {"reason", value.reason}});
    }
    for (const input::MissingPart& part : made.missing) {
        json["missing"].push_back({{"what", part.what}, {"remedy", part.remedy}});
    }
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_case(const input::NewCase& made, const input::NewCaseRequest& request) {
    const std::string file = input::printable(request.target.generic_string());
    is_specimen(made) ? fmt::print("{}: {}\n", file, made.mesh)
                      : fmt::print("{}: a {} on {}\n", file, request.size.text, made.mesh);
    if (!made.unread.empty()) {
        print_text(post::wrap(input::printable(made.unread), 0, prose_width()));
    }
    if (made.log) {
        const std::vector<double>& time = made.log->time;
        fmt::print("\nFrom {}, {} samples from {:g} to {:g} s\n", input::printable(made.log->path),
                   post::grouped(static_cast<double>(time.size())), time.front(), time.back());
        post::TextTable table({true, true});
        std::vector<std::string> foreign;
        for (const input::LogColumn& column : made.log->columns) {
            column.is_foreign ? foreign.push_back(column.heading.name) : table.add({column.title(), use_of(column)});
        }
        print_text(table.text(2));
        if (!foreign.empty()) {
            print_text(post::wrap(fmt::format("Not used, as the model has nothing by such names: {}.",
                                              input::printable(input::listed(foreign))),
                                  2, prose_width()));
        }
    }
    if (!made.assumed.empty()) {
        post::TextTable table({true, true, true});
        for (const input::AssumedValue& value : made.assumed) {
            table.add({value.key, value.value, value.reason});
        }
        fmt::print("\nAssumed; change it in the case\n");
        print_text(table.text(2));
    }
    if (!made.missing.empty()) {
        fmt::print("\nStill missing\n");
        for (const input::MissingPart& part : made.missing) {
            print_text(post::wrap(fmt::format("{}; {}", part.what, part.remedy), 2, prose_width()));
        }
    }
    fmt::print("{}", made.warnings.empty() ? "" : "\n");
    for (const std::string& warning : made.warnings) {
        print_text(post::wrap(fmt::format("warning: {}", input::printable(warning)), 0, prose_width()));
    }
    fmt::print("\nIt runs with: tiretherm run {}\n", file);
    if (made.log && made.log->use == input::LogUse::run) {
        fmt::print("Compared with what was measured: tiretherm compare {}\n", file);
    }
}

int make_case(const NewOptions& options) {
    solver::install_stop_handlers();
    const std::optional<input::NewCaseRequest> request = read_request(options);
    if (!request) {
        return Exit::input_error;
    }
    const std::string file = request->target.generic_string();
    std::error_code error;
    if (fs::is_directory(request->target, error)) {
        report_error(fmt::format("{} is a directory", file), "name a file with --out", options.json);
        return Exit::input_error;
    }
    if (fs::exists(fs::symlink_status(request->target, error)) && !options.force) {
        report_error(fmt::format("{} exists and is left as it is", file),
                     "replace it with --force, or write elsewhere with --out FILE", options.json);
        return Exit::input_error;
    }
    const input::NewCase made = calls::while_reading(request->log ? request->log->string() : file,
                                                     [&] { return input::make_new_case(*request); });
    if (replaces_input(request->target, made.files, options.json)) {
        return Exit::input_error;
    }
    if (!made.errors.empty()) {
        report_errors({.errors = made.errors, .warnings = made.warnings}, "no case was written", options.json);
        return Exit::input_error;
    }
    if (Terminal terminal(options.json, false); calls::was_stopped("no case was written", terminal)) {
        return Exit::interrupted;
    }
    try {
        post::write_with_folder(request->target, made.text);
    } catch (const post::FileError& failure) {
        report_error(failure.what(), "no case was written; choose another file with --out", options.json);
        return Exit::input_error;
    }
    options.json ? print_json(made, *request) : print_case(made, *request);
    return Exit::done;
}

}  // namespace

void add_new_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("new", "Write a commented case from a tire's size or a measured log");
    const auto options = std::make_shared<NewOptions>();
    const auto names = input::mesh_template_names();
    command
        ->add_option("SIZE|LOG", options->subject,
                     "Size of a tire, \"225/50 R17 94H\" or \"31x10.50R15\"; or a data logger's file")
        ->option_text(" ");
    add_out_option(*command, options->file, "The case. Default: the size or the log's name, here", "CASE");
    command->add_option("--size", options->size, "The tire of a log. Default: 225/50 R17, that of the thesis")
        ->option_text("SIZE");
    const auto tests = input::drum_test_names();
    command
        ->add_option("--test", options->test,
                     fmt::format("A durability test on a drum, by load index and speed symbol of the size: {}",
                                 fmt::join(tests, ", ")))
        ->option_text("NAME")
        ->check(CLI::IsMember(std::vector<std::string>(tests.begin(), tests.end())));
    command->add_flag("--specimen", options->specimen,
                      "A specimen under a laser, at rest. Default where the log has the power of a laser");
    command
        ->add_option("--mesh", options->mesh,
                     "section, layers, two_node or specimen. Default: section; two_node for a car's log with one "
                     "reading across each tread")
        ->option_text("KIND")
        ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
    command
        ->add_option("--materials", options->materials,
                     "thesis: K1 and K2, equivalent conductivities that were identified on one 225/50 R17; "
                     "literature: those of rubber and cords, 0.25 and 0.30 W/mK. Default: thesis")
        ->option_text("SET")
        ->check(CLI::IsMember({"thesis", "literature"}));
    command
        ->add_option("--pressure", options->pressure,
                     "Inflation, \"2.4 bar\": scales stiffness and contact. Default: 220 kPa, light trucks 450 kPa, "
                     "trucks 800 kPa, motorcycles 250 kPa in front and 290 kPa behind")
        ->option_text("PRESSURE");
    command
        ->add_option(
            "--unit", options->units,
            "A unit that the log lacks, or has wrong, once for each: \"GPS Speed=km/h\"; \"*temp*=degC\" of several")
        ->option_text("COLUMN=UNIT ...");
    command->add_flag("--force", options->force, "Replace a case that is there already");
    command->add_flag("--json", options->json, "One JSON object: columns, assumptions, what is missing");
    command->footer(
        "Every line of the case says what it means and where its value comes from. Of a log, columns with standard "
        "names\n"
        "and units (time [s], speed [km/h], vertical_load [N], air_temperature [degC], road_temperature [degC],\n"
        "surface_temperature [degC], bulk_temperature [degC] ...; cases/README.md has all) become inputs and measured\n"
        "sensors; of others the case has suggestions, to be confirmed by taking a # away. Inputs that the log lacks "
        "get\n"
        "constants. Paths in the case are relative: move case and log together.\n\n"
        "Of a car's log (AiM, MoTeC, RaceChrono, VBOX: GPS Speed, LatAcc, Tire Temp FL ...) the case has a tire at "
        "each\n"
        "corner with readings and [vehicle], which gives them load, forces and slips; the car's values are assumed.\n"
        "docs/loggers.md lists the names.\n\n"
        "Exit code: 0 the case was written, 1 an error in the call or the log, 130 interrupted.\n\n"
        "Examples:\n"
        "  tiretherm new \"225/50 R17\" --out out/mine.toml\n"
        "  tiretherm run out/mine.toml\n"
        "  tiretherm new cases/practice/run1.csv --size \"235/45 R17\" \\\n"
        "      --out out/drive.toml\n"
        "  tiretherm compare out/drive.toml");
    command->callback([options, &exit_code] { exit_code = make_case(*options); });
}

}  // namespace tiretherm::app
