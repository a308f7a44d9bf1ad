// SPDX-License-Identifier: BSD-3-Clause
// Recognises the line of moments by their units, reads the lines of probes below it and hands them out as columns.

#include "input/tables/probe_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/tables/csv.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr int searched_lines = 30;  ///< for the headings; what stands above them is about the test
constexpr std::size_t fewest_moments = 2;

/// What a heading or a unit says of the axis.
struct Moment {
    std::optional<ProbeTable::Axis> axis{};  ///< nothing for a bare number
    double value = 0.0;                      ///< SI
    std::string unit{};                      ///< of the values, in brackets behind the moment
};

struct AxisUnit {
    ProbeTable::Axis axis = ProbeTable::Axis::time;
    Conversion conversion{};
};

std::optional<AxisUnit> axis_of(std::string_view unit) {
    for (const auto& [axis, si] :
         {std::pair(ProbeTable::Axis::time, "s"), std::pair(ProbeTable::Axis::speed, "m s-1")}) {
        const auto read = conversion(unit, si, Scale::absolute);
        if (const auto* found = std::get_if<Conversion>(&read); found != nullptr && !unit.empty()) {
            return AxisUnit{axis, *found};
        }
    }
    return std::nullopt;
}

std::string_view without_brackets(std::string_view text) {
    text = trim(text);
    return text.size() > 2 && text.front() == '(' && text.back() == ')' ? trim(text.substr(1, text.size() - 2)) : text;
}

/// "Probe [degC]" and "Probe (degC)".
Heading bracketed_heading(std::string_view field) {
    Heading heading = read_heading(field);
    const std::size_t open = field.rfind('(');
    if (!heading.unit && open != std::string_view::npos && trim(field).ends_with(')')) {
        heading = {std::string(trim(field.substr(0, open))), std::string(without_brackets(field.substr(open)))};
    }
    return heading;
}

/// The word before the number of a moment: "t =", "after", "step". @returns lower case, without blanks and marks
std::string word_before(std::string_view text) {
    std::string word;
    for (const char c : text) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else if (std::string_view(" =:@#_").find(c) == std::string_view::npos) {
            return "?";
        }
    }
    return word;
}

std::optional<Moment> moment_of(std::string_view field) {
    constexpr std::array<std::string_view, 8> before_times{"", "t", "v", "at", "after", "time", "speed", "nach"};
    constexpr std::array<std::string_view, 4> before_steps{"step", "stage", "stufe", "s"};
    const Heading heading = read_heading(field);
    const std::string_view name = heading.name;
    const std::size_t digit = name.find_first_of("0123456789");
    const std::optional<Number> number =
        digit == std::string_view::npos ? std::nullopt : leading_number(name.substr(digit));
    if (!number) {
        return std::nullopt;
    }
    const std::string word = word_before(name.substr(0, digit));
    const std::string_view unit = without_brackets(number->rest);
    const std::string in_brackets = heading.unit.value_or("");
    if (std::ranges::find(before_steps, word) != before_steps.end() && (unit.empty() || name.back() == ')')) {
        return Moment{ProbeTable::Axis::step, number->value, in_brackets};
    }
    if (std::ranges::find(before_times, word) == before_times.end()) {
        return std::nullopt;
    }
    if (const std::optional<AxisUnit> own = axis_of(unit.empty() ? std::string_view(in_brackets) : unit)) {
        return Moment{own->axis, own->conversion.to_si(number->value), unit.empty() ? std::string() : in_brackets};
    }
    return unit.empty() ? std::optional(Moment{std::nullopt, number->value, in_brackets}) : std::nullopt;
}

bool is_no_reading(std::string_view field) {
    return field.empty() || field == "-" || field == "--" || field == "\u2013" || field == "\u2014" || field == "n/a" ||
           field == "nan" || field == "NaN";
}

}  // namespace

SourceLocation ProbeTable::place(const Line& line, std::string_view field) const {
    const std::string_view before = line.text.substr(0, static_cast<std::size_t>(field.data() - line.text.data()));
    return {.file = file_,
            .line = line.number,
            .column = count_characters(before) + 1,
            .length = std::max(1, count_characters(field))};
}

bool ProbeTable::read_headings(const Line& line) {
    const Heading corner = bracketed_heading(line.fields.front());
    const std::optional<AxisUnit> of_corner = axis_of(corner.unit.value_or(""));
    unit_ = of_corner ? "" : corner.unit.value_or("");
    std::optional<Axis> axis;
    bool bare = false;
    for (std::size_t i = 1; i < line.fields.size(); ++i) {
        const std::string_view field = line.fields[i];
        const std::optional<Moment> moment = moment_of(field);
        if (!moment) {
            const std::string name = word_before(field);
            unit_column_ = name == "unit" || name == "units" || name == "einheit" ? i : unit_column_;
            continue;
        }
        bare = bare || !moment->axis;
        const Axis own = moment->axis ? *moment->axis : of_corner ? of_corner->axis : Axis::step;
        if (axis && *axis != own) {
            return false;
        }
        axis = own;
        columns_.push_back(i);
        moments_.push_back(!moment->axis && of_corner ? of_corner->conversion.to_si(moment->value) : moment->value);
        places_.push_back(place(line, field));
        unit_ = unit_.empty() ? moment->unit : unit_;
    }
    for (std::size_t k = 0; bare && !of_corner && k < moments_.size(); ++k) {
        if (moments_[k] != static_cast<double>(k + 1)) {  // numbers of which nobody says what they are
            return false;
        }
    }
    if (columns_.size() < fewest_moments) {
        return false;
    }
    axis_ = *axis;
    heads_ = {{.heading = axis_ == Axis::time    ? Heading{"time", "s"}
                          : axis_ == Axis::speed ? Heading{"speed of the step", "m/s"}
                                                 : Heading{"step", "1"},
               .place = places_.front()}};
    return true;
}

bool ProbeTable::read_probe(const Line& line) {
    const auto field = [&](std::size_t i) { return i < line.fields.size() ? line.fields[i] : std::string_view(); };
    Heading heading = bracketed_heading(field(0));
    if (heading.name.empty() || leading_number(field(0))) {
        return false;
    }
    if (!heading.unit) {
        const std::string unit = unit_column_ > 0 ? std::string(without_brackets(field(unit_column_))) : unit_;
        heading.unit = unit.empty() ? std::nullopt : std::optional(unit);
    }
    std::vector<double>& values = values_.emplace_back();
    std::vector<SourceLocation>& places = value_places_.emplace_back();
    for (const std::size_t column : columns_) {
        std::string room;
        const std::string_view written = field(column);
        const std::optional<Number> number = leading_number(separator_ == ',' ? written : with_point(written, room));
        if (!is_no_reading(written) && !(number && number->rest.empty())) {
            return false;
        }
        values.push_back(is_no_reading(written) ? std::numeric_limits<double>::quiet_NaN() : number->value);
        places.push_back(place(line, written.data() != nullptr ? written : field(0)));
    }
    heads_.push_back({.heading = std::move(heading), .place = place(line, field(0))});
    return true;
}

std::optional<ProbeTable> ProbeTable::find(const TextFile& file) {
    std::string_view rest = file.text;
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    std::optional<ProbeTable> table;
    Line line;
    for (int number = 1; const auto text = next_line(rest); ++number) {
        if (is_blank(*text) || is_comment(*text)) {
            continue;
        }
        const char separator = table ? table->separator_ : separator_of(*text);
        line = {.text = *text, .number = number};
        split_fields(line.text, separator, line.fields);
        if (!table) {
            ProbeTable begun;
            begun.file_ = file.number;
            begun.separator_ = separator;
            if (line.fields.size() > fewest_moments && !leading_number(line.fields.front()) &&
                begun.read_headings(line)) {
                table = std::move(begun);
            } else if (number >= searched_lines) {
                return std::nullopt;
            }
        } else if (!table->read_probe(line)) {
            return std::nullopt;
        }
    }
    return table && table->heads_.size() > 1 ? table : std::nullopt;
}

void ProbeTable::take_times(std::vector<double> times) {
    moments_ = std::move(times);
    axis_ = Axis::time;
    heads_.front().heading = {"time", "s"};
}

std::vector<std::vector<double>> ProbeTable::read(const std::vector<ColumnRequest>& requests,
                                                  InputErrors& errors) const {
    const std::size_t before = errors.count();
    std::vector<std::vector<double>> values;
    for (const ColumnRequest& request : requests) {
        const auto column = static_cast<std::size_t>(request.column);
        ColumnReader reader(heads_[column], request, errors);
        const std::vector<double>& written = column == 0 ? moments_ : values_[column - 1];
        const std::vector<SourceLocation>& places = column == 0 ? places_ : value_places_[column - 1];
        for (std::size_t k = 0; k < written.size(); ++k) {
            reader.take(written[k], true, [&] {
                return ColumnReader::FieldLocation{.place = places[k], .text = fmt::format("{:.10g}", written[k])};
            });
        }
        reader.close();
        values.push_back(std::move(reader.values));
    }
    return errors.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
