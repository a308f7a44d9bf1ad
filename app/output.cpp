// SPDX-License-Identifier: BSD-3-Clause
// Options of several commands, and the file that a case is written to.

#include "app/output.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/messages.hpp"

namespace tiretherm::app {

void add_out_option(CLI::App& command, std::string& target, const std::string& what, const char* type,
                    const char* names) {
    const CLI::Validator named(
        [](const std::string& text) {
            return text.empty() ? std::string("it is empty; give a name or leave the option out") : std::string();
        },
        "");
    command.add_option(names, target, what)->option_text(type)->check(named);
}

bool replaces_input(const std::filesystem::path& target, const std::vector<std::string>& inputs, bool json) {
    for (const std::string& input : inputs) {
        std::error_code error;
        if (std::filesystem::equivalent(target, input, error) && !error) {
            report_error(fmt::format("{} would be replaced, and it is a file that the call reads ({})",
                                     target.generic_string(), input),
                         "no case was written; write elsewhere with --out", json);
            return true;
        }
    }
    return false;
}

void add_quiet_option(CLI::App& command, bool& quiet) {
    command.add_flag("--quiet", quiet, "No summary and no progress");
}

void add_json_option(CLI::App& command, bool& json, const std::string& instead_of) {
    command.add_flag("--json", json, "One JSON object instead of the " + instead_of);
}

void add_seconds_option(CLI::App& command, const std::string& name, double& seconds, const std::string& what,
                        Seconds range) {
    const CLI::Validator is_duration(
        [range](const std::string& text) {
            double number = -1.0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
            const bool above = range == Seconds::above_zero;
            return is_number && (number > 0.0 || (number == 0.0 && !above))
                       ? std::string()
                       : fmt::format("\"{}\" is no number of seconds {}", text, above ? "above 0" : "from 0 on");
        },
        "");
    command.add_option(name, seconds, what)->option_text("SECONDS")->check(is_duration);
}

void add_fresh_option(CLI::App& command, bool& fresh) {
    command.add_flag("--fresh", fresh, "Begin anew where an interrupted call of the same would be continued");
}

}  // namespace tiretherm::app
