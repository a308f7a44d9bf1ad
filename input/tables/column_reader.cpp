// SPDX-License-Identifier: BSD-3-Clause
// Converts fields to SI and checks order, range and missing values; words the errors.

#include "input/tables/column_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/loggers/logger_units.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

constexpr double seconds_of_a_day = 86400.0;
/// No logger waits longer in one file: its clock was set, as from 0 to the seconds since 1970.
constexpr double longest_pause = 100.0 * seconds_of_a_day;

}  // namespace

ColumnReader::ColumnReader(const ColumnHead& head, const ColumnRequest& request, InputErrors& errors)
    : request_(&request),
      heading_(head.heading.name),
      form_(head.form),
      limiter_(errors),
      unit_(head.form == FieldForm::number ? head.heading.unit.value_or("") : "") {
    if (request.purpose == Purpose::unused) {
        return;
    }
    UnitRead read = read_heading_unit(head.heading, request.spec);
    conversion_ = read.conversion;
    has_unit_ = !read.error;
    if (read.error) {
        if (!request.unit_remedy.empty()) {
            read.error->remedy = request.unit_remedy;
        }
        errors.add(head.unit_place.file >= 0 ? head.unit_place : head.place, *read.error);
    }
}

bool ColumnReader::accept(double written, bool is_number) {
    const double value = is_number ? conversion_.to_si(written) : std::nan("");
    values.push_back(value);
    switch (request_->purpose) {
        case Purpose::unused:
            return true;
        case Purpose::measured:
            if (is_number && std::isnan(written)) {
                return true;
            }
            break;
        case Purpose::clock:
        case Purpose::frame:
        case Purpose::point:
        case Purpose::input:
            break;
    }
    if (request_->purpose == Purpose::measured && value < request_->spec.low &&
        value >= request_->spec.low - request_->spec.zero_error) {
        values.back() = request_->spec.low;
        return is_number;
    }
    const bool inside = value >= request_->spec.low && value <= request_->spec.high && std::isfinite(value);
    const bool orders = request_->purpose == Purpose::clock || request_->purpose == Purpose::frame;
    const bool third = request_->purpose == Purpose::clock && value == before_last_;
    const bool late = !orders || (value >= last_ && !third);
    return is_number && !std::isnan(written) && (!has_unit_ || (inside && late && !leaps(value)));
}

bool ColumnReader::leaps(double value) const {
    return request_->purpose == Purpose::clock && std::isfinite(last_) && value - last_ > longest_pause;
}

void ColumnReader::report(const FieldLocation& field, double written, bool is_number) {
    const std::string in_text = field.text.empty() ? fmt::format("{}", written) : field.text;
    ErrorText wrong = error_text(in_text, written, is_number);
    wrong.what += field.aside;
    limiter_.add(field.place, std::move(wrong));
}

void ColumnReader::remember() {
    if (std::isfinite(values.back())) {
        before_last_ = last_;
        last_ = values.back();
    }
}

std::string ColumnReader::other_unit(double written) const {
    const QuantitySpec& spec = request_->spec;
    const auto is_inside = [&](double value) {
        return value >= std::max(spec.low, spec.usual_low) && value <= std::min(spec.high, spec.usual_high);
    };
    if (spec.unit != "K") {
        if (spec.low != 0.0 || !is_inside(conversion_.to_si(-written))) {
            return "";
        }
        const std::string_view unit = unit_;
        return unit.starts_with(turned_sign) ? std::string(unit.substr(turned_sign.size()))
                                             : fmt::format("{}{}", turned_sign, meant_unit(unit, spec.unit));
    }
    constexpr std::array<std::string_view, 3> temperatures{"K", "degC", "degF"};
    const auto fits = std::ranges::find_if(temperatures, [&](std::string_view unit) {
        const auto read = conversion(unit, "K", Scale::absolute);
        const auto* found = std::get_if<Conversion>(&read);
        return found != nullptr && is_inside(found->to_si(written));
    });
    return fits == temperatures.end() ? "" : std::string(*fits);
}

ErrorText ColumnReader::error_text(std::string_view field, double written, bool is_number) const {
    const std::string& name = request_->name;
    const bool clock = request_->purpose == Purpose::clock;
    const bool may_miss = request_->purpose == Purpose::measured;
    if (is_number && std::isnan(written)) {
        if (request_->purpose == Purpose::point || request_->purpose == Purpose::frame) {
            return {fmt::format("{} is missing", name), "give every point of every frame a value, 0 where nothing is"};
        }
        return {fmt::format("{} is missing", name),
                clock ? "remove the line" : "remove the line: between samples an input is interpolated"};
    }
    const bool is_clock = form_ == FieldForm::clock || form_ == FieldForm::digits;
    const std::optional<Number> number = is_number || is_clock ? std::nullopt : leading_number(field);
    if (number && number->rest.starts_with(',')) {
        return {fmt::format("{} is {}, with a comma in the number", name, field),
                "export the file with decimal points, or with semicolons between the columns and decimal commas, and "
                "without "
                "marks between thousands"};
    }
    const std::string empty_it = may_miss ? "leave the field empty where nothing was measured" : "";
    if (clock && !is_number) {
        return {fmt::format("{} is \"{}\", which is no time", name, field),
                "write seconds, or clocks such as 11:49:03.250 or 2026-10-24 11:49:03.250 (in VBOX files 114903.25)"};
    }
    if (!is_number) {
        return {fmt::format("{} is \"{}\"; a number is wanted", name, field), empty_it};
    }
    std::string_view in_column = unit_;
    in_column.remove_prefix(in_column.starts_with(turned_sign) ? turned_sign.size() : 0);
    const std::string shown =
        unit_.empty() || unit_ == "-" ? std::string(field) : fmt::format("{} {}", field, in_column);
    if (ParsedQuantity parsed = check_quantity(written, conversion_, unit_, request_->spec, name, shown);
        parsed.error) {
        if (may_miss && (parsed.error->remedy.empty() || !std::isfinite(written))) {
            const std::string other = other_unit(written);
            const std::string all = other.starts_with('-') ? "has the other sign" : "is in " + other;
            parsed.error->remedy =
                other.empty() ? empty_it
                              : fmt::format("{}; if the whole column {}, say so in the case: units = {{ {} = \"{}\" }}",
                                            empty_it, all, toml_text::key(heading_), other);
        }
        return *parsed.error;
    }
    if (const double value = conversion_.to_si(written); leaps(value)) {
        return {fmt::format("{} jumps by {:.0f} days to {}", name, (value - last_) / seconds_of_a_day, shown),
                "remove the lines before the clock was set, or split the file there"};
    }
    return conversion_.to_si(written) == last_ && clock
               ? ErrorText{fmt::format("a third line has the same {}, {}", name, shown),
                           "a jump has two lines, before and after"}
               : ErrorText{fmt::format("{} goes backwards to {}", name, shown),
                           request_->purpose == Purpose::frame
                               ? "write the frames in ascending order, each with all its points"
                               : "sort the lines, or split the file where its clock was set"};
}

}  // namespace tiretherm::input
