// SPDX-License-Identifier: BSD-3-Clause
// Reads answers for C.

#include "interface/answer.hpp"

#include <limits>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interface/guard.hpp"

using tiretherm::interface::item_of;
using tiretherm::post::Value;

namespace tiretherm::interface {

namespace {

const Value::List& list_of(const Value& value) {
    static const Value::List none;
    const auto* list = std::get_if<Value::List>(&value.held());
    return list != nullptr ? *list : none;
}

std::string text_of(const Value& value) {
    const auto* text = std::get_if<std::string>(&value.held());
    return text != nullptr ? *text : std::string();
}

double number_of(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.held())) {
        return static_cast<double>(*whole);
    }
    const auto* number = std::get_if<double>(&value.held());
    return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

/// An end of an interval.
double end_of(const Value& row, const char* end, double where_open) {
    const auto* is_open = std::get_if<bool>(&row[fmt::format("{}_is_open", end)].held());
    return is_open != nullptr && *is_open ? where_open : number_of(row[end]);
}

}  // namespace

std::string in_lines(const std::vector<std::string>& sentences) {
    return fmt::format("{}", fmt::join(sentences, "\n"));
}

void take(const calls::Outcome& outcome, tiretherm_answer& answer) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    answer.notes = in_lines(outcome.notes);
    if (!outcome.page) {
        return;
    }
    const post::Report& page = *outcome.page;
    answer.headline = in_lines(page.verdict);
    answer.page = post::page_text(page, false);
    answer.json = post::json_text(page.data);
    for (const Value& file : list_of(page.data["outputs"])) {
        answer.files.push_back(text_of(file));
    }
    for (const Value& row : list_of(page.data["parameters"])) {
        answer.fitted.push_back({.name = text_of(row["name"]),
                                 .unit = text_of(row["unit"]),
                                 .word = text_of(row["identifiability"]),
                                 .value = number_of(row["value"]),
                                 .low = end_of(row, "low", -infinity),
                                 .high = end_of(row, "high", infinity)});
    }
}

}  // namespace tiretherm::interface

namespace {

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

const tiretherm_answer::Tire* tire_of(const tiretherm_answer* answer, int tire) {
    return answer != nullptr ? item_of(answer->tires, tire) : nullptr;
}

const tiretherm::calls::RecordedRows::Channel* channel_of(const tiretherm_answer* answer, int tire, int channel) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? item_of(found->rows.channels, channel) : nullptr;
}

const tiretherm_answer::Fitted* fitted_of(const tiretherm_answer* answer, int parameter) {
    return answer != nullptr ? item_of(answer->fitted, parameter) : nullptr;
}

const char* text_of(const tiretherm_answer* answer, std::string tiretherm_answer::*text) {
    return answer != nullptr ? (answer->*text).c_str() : nullptr;
}

}  // namespace

extern "C" {

void tiretherm_free_answer(tiretherm_answer* answer) { delete answer; }

const char* tiretherm_headline(const tiretherm_answer* answer) { return text_of(answer, &tiretherm_answer::headline); }
const char* tiretherm_page(const tiretherm_answer* answer) { return text_of(answer, &tiretherm_answer::page); }
const char* tiretherm_json(const tiretherm_answer* answer) { return text_of(answer, &tiretherm_answer::json); }
const char* tiretherm_notes(const tiretherm_answer* answer) { return text_of(answer, &tiretherm_answer::notes); }

int tiretherm_file_count(const tiretherm_answer* answer) {
    return answer != nullptr ? static_cast<int>(answer->files.size()) : 0;
}

const char* tiretherm_file(const tiretherm_answer* answer, int file) {
    const std::string* found = answer != nullptr ? item_of(answer->files, file) : nullptr;
    return found != nullptr ? found->c_str() : nullptr;
}

int tiretherm_tire_count(const tiretherm_answer* answer) {
    return answer != nullptr ? static_cast<int>(answer->tires.size()) : 0;
}

const char* tiretherm_tire_name(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found == nullptr             ? nullptr
           : found->rows.corner.empty() ? found->rows.name.c_str()
                                        : found->rows.corner.c_str();
}

int tiretherm_channel_count(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? static_cast<int>(found->rows.channels.size()) : 0;
}

const char* tiretherm_channel_name(const tiretherm_answer* answer, int tire, int channel) {
    const auto* found = channel_of(answer, tire, channel);
    return found != nullptr ? found->name.c_str() : nullptr;
}

const char* tiretherm_channel_unit(const tiretherm_answer* answer, int tire, int channel) {
    const auto* found = channel_of(answer, tire, channel);
    return found != nullptr ? found->unit.c_str() : nullptr;
}

int tiretherm_find_channel(const tiretherm_answer* answer, int tire, const char* name) {
    for (int i = 0; name != nullptr && i < tiretherm_channel_count(answer, tire); ++i) {
        if (channel_of(answer, tire, i)->name == name) {
            return i;
        }
    }
    return -1;
}

size_t tiretherm_row_count(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? found->rows.time.size() : 0;
}

const double* tiretherm_times(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? found->rows.time.data() : nullptr;
}

const double* tiretherm_values(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? found->rows.values.data() : nullptr;
}

size_t tiretherm_final_temperature_count(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? found->last.size() : 0;
}

const double* tiretherm_final_temperatures(const tiretherm_answer* answer, int tire) {
    const auto* found = tire_of(answer, tire);
    return found != nullptr ? found->last.data() : nullptr;
}

int tiretherm_fitted_count(const tiretherm_answer* answer) {
    return answer != nullptr ? static_cast<int>(answer->fitted.size()) : 0;
}

const char* tiretherm_fitted_name(const tiretherm_answer* answer, int parameter) {
    const auto* found = fitted_of(answer, parameter);
    return found != nullptr ? found->name.c_str() : nullptr;
}

const char* tiretherm_fitted_unit(const tiretherm_answer* answer, int parameter) {
    const auto* found = fitted_of(answer, parameter);
    return found != nullptr ? found->unit.c_str() : nullptr;
}

const char* tiretherm_fitted_word(const tiretherm_answer* answer, int parameter) {
    const auto* found = fitted_of(answer, parameter);
    return found != nullptr ? found->word.c_str() : nullptr;
}

double tiretherm_fitted_value(const tiretherm_answer* answer, int parameter) {
    const auto* found = fitted_of(answer, parameter);
    return found != nullptr ? found->value : not_there;
}

double tiretherm_fitted_low(const tiretherm_answer* answer, int parameter) {
    const auto* found = fitted_of(answer, parameter);
    return found != nullptr ? found->low : not_there;
}

double tiretherm_fitted_high(const tiretherm_answer* answer, int parameter) {
    const auto* found = fitted_of(answer, parameter);
    return found != nullptr ? found->high : not_there;
}

}  // extern "C"
