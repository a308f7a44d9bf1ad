// SPDX-License-Identifier: BSD-3-Clause
// Prints the messages of a call.

#include "app/terminal.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/text/characters.hpp"

namespace tiretherm::app {

void Terminal::refuse(const std::vector<std::string>& sentences, const std::string& remedy) {
    if (json_) {
        report_error(fmt::format("{}", fmt::join(sentences, "; ")), remedy, true);
        return;
    }
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        report_error(sentences[i], i + 1 == sentences.size() ? remedy : "", false);
    }
}

void Terminal::refuse(const input::CaseFindings& findings, const std::string& consequence) {
    report_errors(findings, consequence, json_);
}

void Terminal::take(const post::Report& page) {
    if (json_ || !is_quiet()) {
        print_report(page, json_);
    }
}

void Terminal::take(const std::string& text) { fmt::print("{}", text); }

void Terminal::complain(const std::string& sentence, const std::string& remedy) {
    if (!json_) {
        std::fflush(stdout);
        report_error(sentence, remedy, false);
    }
}

void Terminal::note(const std::string& sentence) {
    std::fflush(stdout);
    fmt::print(stderr, "tiretherm: {}\n", input::printable(sentence));
}

}  // namespace tiretherm::app
