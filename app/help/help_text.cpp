// SPDX-License-Identifier: BSD-3-Clause
// Breaks the texts of the help into lines; names and meanings side by side.

#include "app/help/help_text.hpp"

#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

constexpr std::size_t option_column = 26;

class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option(const CLI::Option* option, bool is_positional) const override {
        return entry_text(make_option_name(option, is_positional) + make_option_opts(option), make_option_desc(option),
                          option_column);
    }
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
        std::string name = CLI::Formatter::make_option_name(option, is_positional);
        if (const std::size_t comma = name.find(','); comma != std::string::npos) {
            name.insert(comma + 1, " ");
        }
        return name;
    }
    std::string make_option_opts(const CLI::Option* option) const override {
        const std::string text = CLI::Formatter::make_option_opts(option);
        return text.find_first_not_of(' ') == std::string::npos ? std::string() : text;
    }
    std::string make_subcommand(const CLI::App* command) const override {
        constexpr std::size_t command_column = 14;
        return entry_text(command->get_name(), command->get_description(), command_column);
    }
    std::string make_description(const CLI::App* command) const override {
        return post::wrap(command->get_description() + ".", 0, help_width) + "\n";
    }
    std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override {
        return CLI::detail::find_and_replace(CLI::Formatter::make_help(command, std::move(name), mode), "\n\n\n",
                                             "\n\n");
    }
    std::string make_footer(const CLI::App* command) const override { return paragraphs_text(command->get_footer()); }
};

}  // namespace

std::string entry_text(const std::string& name, const std::string& meaning, std::size_t column) {
    std::string text = "  " + name;
    std::string lines = post::wrap(meaning, column, help_width);
    if (text.size() + 2 > column) {
        return text + "\n" + lines;
    }
    text.resize(column, ' ');
    return lines.empty() ? "  " + name + "\n" : text + lines.substr(column);
}

std::string paragraphs_text(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    std::string paragraph;
    const auto end_paragraph = [&] {
        result += post::wrap(paragraph, 0, help_width);
        paragraph.clear();
    };
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == ' ') {
            end_paragraph();
            result += line + "\n";
        } else {
            paragraph += (paragraph.empty() ? "" : " ") + line;
        }
    }
    end_paragraph();
    return result;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
    auto formatter = std::make_shared<HelpFormatter>();
    formatter->label("Positionals", "Arguments");
    formatter->label("SUBCOMMAND", "COMMAND");
    return formatter;
}

}  // namespace tiretherm::app
