// SPDX-License-Identifier: BSD-3-Clause
// Writes reports and errors to stdout and stderr; whether a terminal is there and NO_COLOR decide on bold text.

#include "app/messages.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

#include "input/text/characters.hpp"
#include "post/report/progress.hpp"

namespace tiretherm::app {

namespace {

/// On a terminal, unless NO_COLOR is set.
bool may_be_bold() { return on_terminal(stdout) && std::getenv("NO_COLOR") == nullptr; }

}  // namespace

bool on_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

std::size_t page_width() {
    constexpr std::size_t least = 60;
    return on_terminal(stdout) ? std::max(least, post::terminal_width(stdout)) : post::standard_width;
}

std::size_t prose_width() { return std::min(page_width(), post::widest_prose); }

std::string terminal_text(std::string_view text, bool bold) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\n\033"), text.size());
        shown += input::printable(text.substr(0, end));
        text.remove_prefix(end);
        if (text.empty()) {
            break;
        }
        const bool mark = bold && (text.starts_with("\033[1m") || text.starts_with("\033[0m"));
        shown += mark ? text.substr(0, 4) : text.front() == '\n' ? "\n" : " ";
        text.remove_prefix(mark ? 4 : 1);
    }
    return shown;
}

void print_text(std::string_view text) { fmt::print("{}", terminal_text(text, may_be_bold())); }

void print_report(const post::Report& report, bool json) {
    if (json) {
        fmt::print("{}", post::json_text(report.data));
    } else {
        print_text(post::page_text(
            report, may_be_bold(),
            {.prose = prose_width(), .tables = on_terminal(stdout) ? page_width() : std::string::npos}));
    }
}

void report_error(const std::string& sentence, const std::string& remedy, bool json) {
    const std::string whole = remedy.empty() ? sentence : fmt::format("{}; {}", sentence, remedy);
    if (json) {
        fmt::print("{}", post::json_text(
                             {{"error", whole}, {"errors", post::Value::List{}}, {"mistakes", post::Value::List{}}}));
    } else {
        fmt::print(stderr, "tiretherm: {}\n", input::printable(whole));
    }
}

void report_errors(const input::CaseFindings& reading, const std::string& consequence, bool json) {
    const std::size_t n = reading.errors.size();
    const std::string sentence = fmt::format("{} {}; {}", n, n == 1 ? "error" : "errors", consequence);
    if (!json) {
        fmt::print(stderr, "{}{}\n", terminal_text(input::render(reading)), sentence);
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
    fmt::print("{}",
               post::json_text(
                   {{"error", sentence}, {"errors", errors}, {"mistakes", errors}, {"warnings", reading.warnings}}));
}

}  // namespace tiretherm::app
