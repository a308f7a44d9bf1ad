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
#include "input/text/characters.hpp"
#include "input/text/source_text.hpp"

namespace tiretherm::input {

namespace {

constexpr int searched_lines = 30;  ///< for the headings; what stands above them is about the test
constexpr std::size_t fewest_moments = 2;

/// What a heading or a unit says of the axis.
struct Moment {
    std::optional<LogTable::Moments> axis{};  ///< nothing for a bare number
    double value = 0.0;                       ///< SI
    std::string unit{};                       ///< of the values, in brackets behind the moment
};

struct AxisUnit {
    LogTable::Moments axis = LogTable::Moments::times;
    Conversion conversion{};
};

std::optional<AxisUnit> axis_of(std::string_view unit) {
    for (const auto& [axis, si] :
         {std::pair(LogTable::Moments::times, "s"), std::pair(LogTable::Moments::speeds, "m s-1")}) {
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
        return Moment{LogTable::Moments::steps, number->value, in_brackets};
    }
    if (std::ranges::find(before_times, word) == before_times.end()) {
        return std::nullopt;
    }
    if (const std::optional<AxisUnit> own = axis_of(unit.empty() ? std::string_view(in_brackets) : unit)) {
        return Moment{own->axis, own->conversion.to_si(number->value), unit.empty() ? std::string() : in_brackets};
    }
    return unit.empty() ? std::optional(Moment{std::nullopt, number->value, in_brackets}) : std::nullopt;
}

/// A text that is read line by line.
class ProbeReader {
public:
    /// @returns whether it may still be such a table
    bool take(std::string_view text, int number) {
        Line line{{text, number}, {}};
        const bool is_begun = !moments_.empty();
        separator_ = is_begun ? separator_ : separator_of(text);
        split_fields(text, separator_, line.fields);
        if (is_begun) {
            return read_probe(line);
        }
        ProbeReader begun;
        begun.separator_ = separator_;
        if (line.fields.size() > fewest_moments && !leading_number(line.fields.front()) && begun.read_headings(line)) {
            *this = std::move(begun);
            return true;
        }
        return number < searched_lines;
    }

    std::optional<LogTable> table() {
        if (columns_.size() < 2) {
            return std::nullopt;
        }
        LogTable table{.description = {.format = "table of probes"}, .moments = axis_, .columns = std::move(columns_)};
        table.where = [places = std::move(places_), all = table.columns](std::size_t row, int column) {
            const auto at = static_cast<std::size_t>(std::max(0, column));
            return FieldLocation{.place = places[at][row], .text = fmt::format("{:.10g}", all[at].number[row])};
        };
        return table;
    }

private:
    struct Line {
        CsvLine line;
        std::vector<std::string_view> fields;
    };
    bool read_headings(const Line& line);
    bool read_probe(const Line& line);

    char separator_ = ',';
    LogTable::Moments axis_ = LogTable::Moments::times;
    std::string unit_;                  ///< of the values, by the first heading or by those of the columns
    std::size_t unit_column_ = 0;       ///< that has the unit of each line; 0: none
    std::vector<std::size_t> moments_;  ///< fields of a line that are of a moment
    std::vector<TableColumn> columns_;  ///< the moments on the axis, SI; then the probes
    std::vector<std::vector<SourceLocation>> places_;  ///< [columns][moments] of their fields
};

bool ProbeReader::read_headings(const Line& line) {
    std::vector<double> moments;
    std::vector<SourceLocation> places;
    const Heading corner = bracketed_heading(line.fields.front());
    const std::optional<AxisUnit> of_corner = axis_of(corner.unit.value_or(""));
    unit_ = of_corner ? "" : corner.unit.value_or("");
    std::optional<LogTable::Moments> axis;
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
        const LogTable::Moments own = moment->axis ? *moment->axis
                                      : of_corner  ? of_corner->axis
                                                   : LogTable::Moments::steps;
        if (axis && *axis != own) {
            return false;
        }
        axis = own;
        moments_.push_back(i);
        moments.push_back(!moment->axis && of_corner ? of_corner->conversion.to_si(moment->value) : moment->value);
        places.push_back(place_in(line.line, field));
        unit_ = unit_.empty() ? moment->unit : unit_;
    }
    for (std::size_t k = 0; bare && !of_corner && k < moments.size(); ++k) {
        if (moments[k] != static_cast<double>(k + 1)) {  // numbers of which nobody says what they are
            return false;
        }
    }
    if (moments_.size() < fewest_moments) {
        return false;
    }
    axis_ = *axis;
    columns_ = {{.head = {.heading = axis_ == LogTable::Moments::times    ? Heading{"time", "s"}
                                     : axis_ == LogTable::Moments::speeds ? Heading{"speed of the step", "m/s"}
                                                                          : Heading{"step", "1"},
                          .place = places.front()},
                 .number = std::move(moments)}};
    places_ = {std::move(places)};
    return true;
}

bool ProbeReader::read_probe(const Line& line) {
    const auto field = [&](std::size_t i) { return i < line.fields.size() ? line.fields[i] : std::string_view(); };
    Heading heading = bracketed_heading(field(0));
    if (heading.name.empty() || leading_number(field(0))) {
        return false;
    }
    if (!heading.unit) {
        const std::string unit = unit_column_ > 0 ? std::string(without_brackets(field(unit_column_))) : unit_;
        heading.unit = unit.empty() ? std::nullopt : std::optional(unit);
    }
    TableColumn probe{.head = {.heading = std::move(heading), .place = place_in(line.line, field(0))}};
    std::vector<SourceLocation>& places = places_.emplace_back();
    for (const std::size_t column : moments_) {
        std::string room;
        const std::string_view written = field(column);
        const std::optional<Number> number = leading_number(separator_ == ',' ? written : with_point(written, room));
        if (!is_no_reading(written) && !(number && number->rest.empty())) {
            return false;
        }
        probe.number.push_back(is_no_reading(written) ? std::numeric_limits<double>::quiet_NaN() : number->value);
        places.push_back(place_in(line.line, written.data() != nullptr ? written : field(0)));
    }
    columns_.push_back(std::move(probe));
    return true;
}

}  // namespace

std::optional<LogTable> find_probe_table(const std::shared_ptr<const SourceText>& source) {
    const std::shared_ptr<const std::string> text = source->get();
    std::string_view rest = *text;
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    ProbeReader reader;
    for (int number = 1; const auto line = next_line(rest); ++number) {
        if (!is_blank(*line) && !is_comment(*line) && !reader.take(*line, number)) {
            return std::nullopt;
        }
    }
    std::optional<LogTable> table = reader.table();
    if (table) {
        table->text = source;
    }
    return table;
}

}  // namespace tiretherm::input
