#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cases/complaints.hpp"
#include "cases/csv.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

/// One column being read.
class ColumnReader {
public:
    ColumnReader(const Csv& csv, const Csv::Request& request, Mistakes& mistakes)
        : csv_(&csv), request_(&request), complaints_(mistakes) {
        const Csv::Head& head = csv.heads()[static_cast<std::size_t>(request.column)];
        unit_ = head.heading.unit.value_or("");
        const UnitRead read = read_heading_unit(head.heading, request.wanted);
        conversion_ = read.conversion;
        has_unit_ = !read.fault;
        if (read.fault) {
            mistakes.add(head.place, *read.fault);
        }
    }

    void take(std::string_view field, const Csv::Line& line) {
        const std::optional<Number> number = leading_number(field);
        const bool whole = number && number->rest.empty();
        const double value = whole ? conversion_.to_si(number->value) : std::nan("");
        const bool inside = value >= request_->wanted.low && value <= request_->wanted.high;
        const bool late = !request_->ascending || value > last_;
        if (!whole || (has_unit_ && !(inside && late))) {
            complaints_.add(csv_->place(line, field), fault(field, number));
        }
        last_ = std::isfinite(value) ? value : last_;
        values.push_back(value);
    }

    void close() { complaints_.close(request_->name); }

    std::vector<double> values;

private:
    [[nodiscard]] Fault fault(std::string_view field, const std::optional<Number>& number) const {
        const std::string& name = request_->name;
        if (field.empty() || (number && number->rest.empty() && std::isnan(number->value))) {
            return {
                fmt::format("{} is missing", name),
                request_->ascending ? "remove the line" : "remove the line: between samples an input is interpolated"};
        }
        if (number && number->rest.starts_with(',')) {
            return {fmt::format("{} is {}, with a decimal comma", name, field), "export the file with decimal points"};
        }
        if (!number || !number->rest.empty()) {
            return {fmt::format("{} is \"{}\"; a number is wanted", name, field), ""};
        }
        const std::string shown =
            unit_.empty() || unit_ == "-" ? std::string(field) : fmt::format("{} {}", field, unit_);
        if (const Judged judged = judge(number->value, conversion_, unit_, request_->wanted, name, shown);
            judged.fault) {
            return *judged.fault;
        }
        return conversion_.to_si(number->value) == last_
                   ? Fault{fmt::format("{} stands still at {}", name, shown), "remove one of the lines"}
                   : Fault{fmt::format("{} goes backwards to {}", name, shown),
                           "sort the lines, or split the file where its clock was set"};
    }

    const Csv* csv_;
    const Csv::Request* request_;
    Complaints complaints_;
    std::string unit_;
    Conversion conversion_;
    bool has_unit_ = false;
    double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<std::vector<double>> Csv::read(const std::vector<Request>& requests, Mistakes& mistakes) const {
    const std::size_t before = mistakes.count();
    std::vector<ColumnReader> readings;
    readings.reserve(requests.size());
    for (const Request& request : requests) {
        readings.emplace_back(*this, request, mistakes);
    }
    Complaints ragged(mistakes);
    std::vector<std::string_view> fields;
    std::string_view rest = body_;
    bool empty = true;
    for (Line line{{}, first_line_}; const auto text = next_line(rest); ++line.number) {
        line.text = *text;
        if (trim(line.text).empty()) {
            continue;
        }
        empty = false;
        split(line.text, fields);
        const bool trailing = fields.size() == heads_.size() + 1 && fields.back().empty();
        if (fields.size() != heads_.size() && !trailing) {
            const bool too_many_commas = has_commas() && fields.size() > heads_.size();
            ragged.add(
                place(line, line.text),
                {fmt::format("the line has {} values, the first line names {} columns", fields.size(), heads_.size()),
                 too_many_commas ? "if the numbers have decimal commas, export the file with decimal points"
                                 : "complete or remove the line"});
            continue;
        }
        for (std::size_t i = 0; i < requests.size(); ++i) {
            readings[i].take(fields[static_cast<std::size_t>(requests[i].column)], line);
        }
    }
    if (empty) {
        mistakes.add({.file = file_}, "the file has headings but no numbers");
    }
    ragged.close("the number of values");
    std::vector<std::vector<double>> values;
    for (ColumnReader& reading : readings) {
        reading.close();
        values.push_back(std::move(reading.values));
    }
    return mistakes.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::cases
