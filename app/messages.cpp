// SPDX-License-Identifier: BSD-3-Clause
// Writes reports and errors to stdout and stderr; whether a terminal is there and NO_COLOR decide on bold text.

#include "app/messages.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace tiretherm::app {

namespace {

/// On a terminal, unless NO_COLOR is set.
bool may_be_bold() { return on_terminal(stdout) && std::getenv("NO_COLOR") == nullptr; }

}  // namespace

bool on_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

void print_report(const post::Report& report, bool json) {
    fmt::print("{}", json ? post::json_text(report.data) : post::page_text(report, may_be_bold()));
}

void report_error(const std::string& sentence, const std::string& remedy, bool json) {
    const std::string whole = remedy.empty() ? sentence : fmt::format("{}; {}", sentence, remedy);
    if (json) {
        fmt::print("{}", post::json_text({{"error", whole}, {"mistakes", post::Value::List{}}}));
    } else {
        fmt::print(stderr, "tiretherm: {}\n", whole);
    }
}

void report_errors(const input::Reading& reading, const std::string& consequence, bool json) {
    const std::size_t n = reading.errors.size();
    const std::string sentence = fmt::format("{} {}; {}", n, n == 1 ? "error" : "errors", consequence);
    if (!json) {
        fmt::print(stderr, "{}{}\n", input::render(reading), sentence);
        return;
    }
    post::Value::List errors;
    for (const input::InputError& error : reading.errors) {
        errors.push_back({{"file", error.file},
                          {"line", error.line},
                          {"column", error.column},
                          {"length", error.length},
                          {"message", error.what},
                          {"remedy", error.remedy}});
    }
    fmt::print("{}", post::json_text({{"error", sentence}, {"mistakes", errors}, {"warnings", reading.warnings}}));
}

}  // namespace tiretherm::app
