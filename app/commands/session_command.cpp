// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm session`: the tires of a case in real time behind a port, for simulators, with a page for a browser.

#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/live/live_server.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "calls/doing.hpp"
#include "input/runs/reader.hpp"

namespace tiretherm::app {

namespace {

struct SessionOptions {
    std::string case_file;
    std::string run;
    std::string listen;
    bool four = false;
    double time_limit = std::numeric_limits<double>::infinity();
};

/// Of "localhost:7000" or "[::1]:7000".
std::optional<live::Place> place_of(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) {
        return {};
    }
    std::string host = text.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) {
        host = host.substr(1, host.size() - 2);
    }
    const std::string port = text.substr(colon + 1);
    const bool is_port = !port.empty() && port.size() <= 5 &&
                         port.find_first_not_of("0123456789") == std::string::npos && std::stoi(port) <= 65535;
    return is_port && !host.empty() ? std::optional(live::Place{host, port}) : std::nullopt;
}

void tell_ready(const SessionOptions& options, const std::string& address, bool is_loopback) {
    if (!is_loopback) {
        std::fflush(stdout);
        fmt::print(stderr,
                   "warning: whoever reaches this machine can see the session and drive it; nothing is encrypted\n");
    }
    fmt::print("{} is live at {}\nPage: http://{}/\nCtrl-C ends it.\n", options.case_file, address, address);
    std::fflush(stdout);
}

/// Whether the runs of a case can be a session; reports it where they cannot.
bool can_be_live(const input::Reading& reading, const SessionOptions& options) {
    if (!reading.problem) {
        report_errors(reading, "nothing was begun", false);
        return false;
    }
    for (const input::RunOfCase& run : reading.chosen) {
        if (const auto defects = solver::defects(run.problem); !defects.empty()) {
            report_error(fmt::format("{}: {}", options.case_file, fmt::join(defects, "; ")), "", false);
            return false;
        }
        if (run.problem.n_sensors() == 0) {
            report_error("the case has no sensor: a session would have nothing to tell", "add a [[sensor]]", false);
            return false;
        }
    }
    if (options.four && reading.chosen.size() > 1) {
        report_error("--four is for a case of one tire", "this one has a tire at each corner already", false);
        return false;
    }
    return true;
}

int session(const SessionOptions& options) {
    const std::optional<live::Place> place = place_of(options.listen);
    if (!place) {
        report_error(fmt::format("--listen: \"{}\" is no host with a port", options.listen),
                     "write --listen localhost:7000", false);
        return Exit::input_error;
    }
    const input::Reading reading =
        calls::while_reading(options.case_file, [&] { return input::read_case_run(options.case_file, options.run); });
    if (!can_be_live(reading, options)) {
        return Exit::input_error;
    }
    calls::now_doing("listening at " + options.listen);
    try {
        live::LiveTires tires(reading.chosen, options.four);
        live::serve(tires, *place, options.time_limit,
                    [&](const std::string& address, bool is_loopback) { tell_ready(options, address, is_loopback); });
    } catch (const std::system_error& failure) {
        report_error(fmt::format("--listen {}: {}", options.listen, failure.code().message()),
                     "name a host of this machine and a free port above 1023; port 0 takes a free one", false);
        return Exit::input_error;
    }
    return Exit::done;
}

}  // namespace

void add_session_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("session", "Tires in real time for a simulator, with a live page");
    const auto options = std::make_shared<SessionOptions>();
    command->add_option("CASE", options->case_file, "Case file (TOML)")->required()->option_text(" ");
    command
        ->add_option("--run", options->run,
                     "Which of the case's [[run]] tables, of a car's tires RUN_FL. Default: the first")
        ->option_text("NAME");
    command
        ->add_option(
            "--listen", options->listen,
            "Where programs and browsers find it. Port 0: a free one. Anything but localhost is open to others")
        ->option_text("HOST:PORT")
        ->required();
    command->add_flag("--four", options->four, "The one tire of the case stands at all four corners: FL, FR, RL, RR");
    add_seconds_option(*command, "--time-limit", options->time_limit, "Ends after so long. Default: never");
    command->footer(
        "A program connects by TCP and sends a JSON object a line; each is answered by one:\n\n"
        "  {\"hello\": 1}                names and units of inputs and outputs\n"
        "  {\"time\": 0.01, \"inputs\": {\"speed\": 30, \"camber\": \"-2 deg\"},\n"
        "   \"tires\": {\"FL\": {\"vertical_load\": 4000}}}\n"
        "                              steps to that time; temperatures follow\n"
        "  {\"observe\": true}           looks on: a line for each step\n\n"
        "Numbers are SI and kelvin; a text has its unit. The first to send a time drives, all others look on. A "
        "browser shows the tires at http://HOST:PORT/. No message opens a file. Page: docs/live.md\n\n"
        "Exit code: 0 after Ctrl-C or --time-limit, 1 an error in the call or the case, or the port is taken.\n\n"
        "Example:\n"
        "  tiretherm session cases/car/session.toml --listen localhost:0 --time-limit 1");
    command->callback([options, &exit_code] { exit_code = session(*options); });
}

}  // namespace tiretherm::app
