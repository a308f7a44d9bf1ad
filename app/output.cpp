// SPDX-License-Identifier: BSD-3-Clause
// Opens and commits the folder of a call's files, with the sentences for what keeps it from that.

#include "app/output.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/build_identity.hpp"
#include "app/commands.hpp"
#include "app/messages.hpp"
#include "post/report/file.hpp"
#include "post/report/record_file.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

constexpr const char* elsewhere = "choose another directory with --out";
constexpr const char* unchanged = "the files of an earlier call are as they were; choose another directory with --out";

}  // namespace

void add_out_option(CLI::App& command, std::string& target, const std::string& what, const char* type,
                    const char* names) {
    const CLI::Validator named(
        [](const std::string& text) {
            return text.empty() ? std::string("it is empty; give a name or leave the option out") : std::string();
        },
        "");
    command.add_option(names, target, what)->option_text(type)->check(named);
}

std::unique_ptr<post::OutputFolder> open_output(const std::filesystem::path& folder, std::vector<std::string> inputs,
                                                const std::vector<std::string>& names, const std::string& consequence,
                                                bool json) {
    try {
        auto opened = std::make_unique<post::OutputFolder>(folder, std::move(inputs));
        opened->refuse_inputs(names);
        return opened;
    } catch (const std::runtime_error& error) {
        report_error(error.what(), fmt::format("{}; {}", consequence, elsewhere), json);
        return nullptr;
    }
}

bool write_output(post::OutputFolder& folder, const std::vector<std::string>& stale, bool json,
                  const std::function<void()>& write) {
    try {
        write();
        folder.commit(stale);
        return true;
    } catch (const std::exception& error) {
        const bool of_files = dynamic_cast<const post::FileError*>(&error) != nullptr ||
                              dynamic_cast<const post::OutputError*>(&error) != nullptr ||
                              dynamic_cast<const std::filesystem::filesystem_error*>(&error) != nullptr;
        // What was computed is worth more than the room that it takes: with a disk that is less full the call goes on.
        const bool kept = folder.has_journal();
        if (kept) {
            folder.keep_journals();
        }
        if (!of_files) {
            throw;
        }
        report_error(
            folder.in_place(error.what()),
            kept ? fmt::format("{}, or make room: the same call goes on from what is kept", unchanged) : unchanged,
            json);
    }
    return false;
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

solver::Digest::Value call_identity(const std::vector<std::string>& files, const std::vector<std::string>& arguments) {
    solver::Digest digest;
    digest.add(std::string_view(build_identity()));
    for (const std::string& argument : arguments) {
        digest.add(std::string_view(argument));
    }
    post::add_files(digest, files);
    return digest.value();
}

void add_quiet_option(CLI::App& command, bool& quiet) {
    command.add_flag("--quiet", quiet, "No summary and no progress");
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

void tell_of_continuation(const std::string& kept) {
    fmt::print(stderr, "tiretherm: an interrupted call is continued: {}\n", kept);
}

void tell_of_damage(const std::string& consequence) {
    fmt::print(stderr, "tiretherm: what an interrupted call has kept was cut off or damaged; {}\n", consequence);
}

bool was_stopped(const std::string& consequence, bool json) {
    if (!solver::stop_requested()) {
        return false;
    }
    report_error(stop_sentence(), consequence, json);
    return true;
}

std::string stop_sentence() { return solver::is_time_up() ? "the time limit has passed" : "stopped"; }

int stop_exit() { return solver::is_time_up() ? Exit::numerical_failure : Exit::interrupted; }

}  // namespace tiretherm::app
