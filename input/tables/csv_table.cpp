// SPDX-License-Identifier: BSD-3-Clause
// Reads the headings of a logger's text by its layout, finds its clocks and has the rows parsed.

#include <algorithm>

#include <fmt/format.h>

#include "input/clock/clock_columns.hpp"
#include "input/clock/clock_words.hpp"
#include "input/loggers/csv_layout.hpp"
#include "input/loggers/heading_names.hpp"
#include "input/tables/csv_rows.hpp"
#include "input/tables/long_table.hpp"
#include "input/text/source_text.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t longest_kept = 4'000'000;  // bytes

/// The headings of a text, before its rows are parsed.
class CsvHeadings {
public:
    explicit CsvHeadings(const CsvLayout& layout) : layout_(layout) {}

    std::vector<ColumnHead> read() {
        std::vector<std::string_view> fields;
        split_fields(layout_.lines.names.text, layout_.separator, fields);
        heads_.reserve(fields.size());
        for (const SourceLocation& spot : places(layout_.lines.names, fields)) {
            std::string field(fields[heads_.size()]);
            for (std::size_t at = 0; (at = field.find("\"\"", at)) != std::string::npos; ++at) {
                field.erase(at, 1);  // a quote within quotes
            }
            heads_.push_back(
                {.heading = layout_.round_brackets ? read_round_heading(field) : read_heading_of_logger(field),
                 .place = spot});
        }
        read_units();
        for (ColumnHead& head : heads_) {
            const auto known = std::ranges::find(layout_.known, head.heading.name, &KnownColumn::heading);
            if (known != layout_.known.end()) {
                head.heading.name = known->name.empty() ? head.heading.name : std::string(known->name);
                head.heading.unit = head.heading.unit ? head.heading.unit : std::optional<std::string>(known->unit);
            }
        }
        if (layout_.sources.number > 0) {
            split_fields(layout_.sources.text, layout_.separator, fields);
            distinguish(heads_, fields);
        }
        if (layout_.description.format != LogDescription().format) {
            number_duplicates(heads_);
        }
        return std::move(heads_);
    }

private:
    /// Of all fields of a line in one pass: a line may have a hundred thousand of them.
    static std::vector<SourceLocation> places(const CsvLine& line, const std::vector<std::string_view>& fields) {
        std::vector<SourceLocation> found;
        found.reserve(fields.size());
        int column = 1;
        const char* from = line.text.data();
        for (const std::string_view field : fields) {
            column += count_characters({from, static_cast<std::size_t>(field.data() - from)});
            from = field.data();
            found.push_back(
                {.file = 0, .line = line.number, .column = column, .length = std::max(1, count_characters(field))});
        }
        return found;
    }

    void read_units() {
        for (std::size_t i = 0; i < std::min(layout_.units.size(), heads_.size()); ++i) {
            if (!layout_.units[i].empty()) {
                heads_[i].heading.unit = layout_.units[i];
            }
        }
        if (layout_.lines.units.text.empty()) {
            return;
        }
        std::vector<std::string_view> fields;
        split_fields(layout_.lines.units.text, layout_.separator, fields);
        const std::vector<SourceLocation> spots = places(layout_.lines.units, fields);
        for (std::size_t i = 0; i < std::min(fields.size(), heads_.size()); ++i) {
            ColumnHead& head = heads_[i];
            // An empty unit in a line of units is as good as none: the pure numbers of loggers are mostly unknown units.
            if (!head.heading.unit && !fields[i].empty()) {
                const Heading bracketed = read_heading(fields[i]);
                head.heading.unit = bracketed.name.empty() && bracketed.unit ? *bracketed.unit : std::string(fields[i]);
                head.unit_place = spots[i];
            }
        }
    }

    const CsvLayout& layout_;
    std::vector<ColumnHead> heads_;
};

/// What keeps a line from being one of headings, as an error of the file. @returns whether there is nothing
bool are_headings(const std::vector<ColumnHead>& heads, InputErrors& errors) {
    if (leading_number(heads.front().heading.name)) {
        errors.add(heads.front().place, "the first line holds numbers; it must name the columns",
                   "write a first line such as time [s],speed [km/h]");
        return false;
    }
    for (const ColumnHead& head : heads) {
        constexpr std::size_t longest = 1000;  // bytes; every page and message repeats it
        const std::size_t size = std::max(head.heading.name.size(), head.heading.unit.value_or("").size());
        if (size > longest) {
            errors.add(head.place, fmt::format("the heading of a column has {} characters", size),
                       "name each column in a few words, as in time [s],speed [km/h]");
            return false;
        }
    }
    return true;
}

/// Which columns hold clocks, and which is the file's time.
void find_clocks(std::vector<ColumnHead>& heads, const CsvLayout& layout) {
    const std::string_view names = layout.lines.names.text;
    CsvLine line;
    std::string_view rest = layout.lines.body;
    static_cast<void>(next_row(rest, names, line));
    take_time_units(heads);
    std::vector<std::string_view> first;
    split_fields(line.text, layout.separator, first);
    first.resize(std::min(first.size(), heads.size()));
    for (std::size_t i = 0; i < first.size(); ++i) {
        ColumnHead& head = heads[i];
        // The fields of the column down the file, until one is enough or a line has no such field.
        const auto visit = [&](const FieldVisitor& take) {
            std::vector<std::string_view> fields;
            rest = layout.lines.body;
            while (next_row(rest, names, line)) {
                split_fields(line.text, layout.separator, fields);
                if (i >= fields.size() || !take(fields[i])) {
                    return;
                }
            }
        };
        const bool is_vbox = layout.description.west_is_positive && head.heading.name == "time" && !is_clock(first[i]);
        head.form = is_vbox ? FieldForm::digits : form_of(head, first[i], visit);
        if (head.form != FieldForm::number && !clock_spelling(head.heading.unit.value_or(""))) {
            head.heading.unit = "s";
            head.unit_place = {};
        }
    }
    mark_clock(heads);
    find_dates(heads, first);
}

}  // namespace

std::optional<LogTable> read_csv(const std::shared_ptr<const SourceText>& source, InputErrors& errors) {
    const std::shared_ptr<const std::string> text = source->get();
    std::string_view content = *text;
    if (content.starts_with("\xEF\xBB\xBF")) {
        content.remove_prefix(3);
    }
    CsvLayout layout = find_csv_layout(content);
    if (layout.defect) {
        errors.add({.file = 0, .line = layout.defect_line, .column = 1, .length = 1}, std::move(*layout.defect));
        return std::nullopt;
    }
    std::vector<ColumnHead> heads = CsvHeadings(layout).read();
    if (!are_headings(heads, errors)) {
        return std::nullopt;
    }
    find_clocks(heads, layout);
    LogTable table{.description = std::move(layout.description), .text = source, .defects = errors};
    for (ColumnHead& head : heads) {
        table.columns.push_back({.head = std::move(head)});
    }
    const std::string_view above =
        content.substr(0, static_cast<std::size_t>(layout.lines.body.data() - content.data()));
    const auto first_line = static_cast<int>(std::ranges::count(above, '\n')) + 1;
    const auto rows = std::make_shared<CsvRows>(source, layout.lines.body, first_line, layout.separator,
                                                std::string(layout.lines.names.text));
    rows->parse(table.columns, table.defects);
    table.where = [rows](std::size_t row, int column) { return rows->where(row, column); };
    fold_long_table(table, rows);
    if (text->size() > longest_kept) {
        source->let_go();
    }
    return table;
}

}  // namespace tiretherm::input
