// SPDX-License-Identifier: BSD-3-Clause
// Tells a study from a case by its keys, and prints what it varies.

#include "app/commands/check_study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/studies/study.hpp"
#include "input/text/characters.hpp"
#include "input/toml/document.hpp"
#include "post/report/report.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

void print_study(const input::Study& study, const std::vector<std::string>& warnings, bool json) {
    using Json = nlohmann::ordered_json;
    if (json) {
        Json shown{{"study", study.title},     {"case", study.case_name}, {"runs", study.runs.size()},
                   {"inputs", Json::array()},  {"warnings", warnings},    {"errors", Json::array()},
                   {"mistakes", Json::array()}};
        for (const input::StudyInput& input : study.inputs) {
            shown["inputs"].push_back(
                {{"key", input.key.text}, {"drawn", input.is_drawn}, {"values", input.values.size()}});
        }
        fmt::print("{}\n", shown.dump(2, ' ', false, Json::error_handler_t::replace));
        return;
    }
    post::TextTable table({true, true});
    table.add({"case", study.case_name});
    table.add({"runs", post::plural(study.runs.size(), "run")});
    for (const input::StudyInput& input : study.inputs) {
        table.add({input.is_drawn ? "draw" : "vary",
                   fmt::format("{}: {}", input.key.text, post::plural(input.values.size(), "value"))});
    }
    fmt::print("{}: no errors in the study\n", input::printable(study.title));
    for (const std::string& line : table.lines(2)) {
        fmt::print("{}\n", input::printable(line));
    }
    for (const std::string& warning : warnings) {
        fmt::print("warning: {}\n", input::printable(warning));
    }
}

}  // namespace

std::optional<int> check_study(const std::filesystem::path& file, bool json) {
    input::InputErrors errors;
    const std::optional<input::TomlValue> document = input::read_document(file, errors);
    if (!document || document->find("mesh") != nullptr) {
        return std::nullopt;
    }
    if (document->find("number") != nullptr) {
        report_error(fmt::format("{} is a table of measured numbers, and no case", file.generic_string()),
                     fmt::format("tiretherm validate {} reads it", file.generic_string()), json);
        return Exit::input_error;
    }
    if (document->find("case") == nullptr) {
        return std::nullopt;
    }
    const input::StudyReading reading = input::read_study(file);
    if (!reading.study) {
        report_errors({.errors = reading.errors, .warnings = reading.warnings}, "the study cannot be run", json);
        return Exit::input_error;
    }
    print_study(*reading.study, reading.warnings, json);
    return Exit::done;
}

}  // namespace tiretherm::app
