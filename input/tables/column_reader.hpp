// SPDX-License-Identifier: BSD-3-Clause
// Reads one column of a CSV or HDF5 file into SI values, checked for its purpose: clock, input, measured, point and
// others.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "input/loggers/clock.hpp"
#include "input/tables/columns.hpp"
#include "input/text/error_limiter.hpp"

namespace tiretherm::input {

/// The head of a column of a file, and where it stands.
struct ColumnHead {
    Heading heading;
    SourceLocation place;
    SourceLocation unit_place{};  ///< of the unit, where it stands on its own; file -1: within `place`
    FieldForm form = FieldForm::number;
    bool is_clock = false;  ///< the time of the file, where no column is called `time`
};

/// What a column of a file is read for.
enum class Purpose : std::uint8_t {
    clock,     ///< ascending; two lines at one time are a jump
    frame,     ///< not descending: alike for all points of a frame
    point,     ///< every point counts, with a value of its own
    input,     ///< every sample counts
    measured,  ///< an empty field or nan is a missing value, NaN
    unused     ///< raw; cells that are no numbers become NaN
};

/// Which column of a file to read, and what its values must be.
struct ColumnRequest {
    int column = 0;
    std::string name;  ///< what messages call it
    QuantitySpec spec;
    Purpose purpose = Purpose::input;
    std::string_view
        unit_remedy{};  ///< what to do about a unit that is missing or wrong; empty: to write it into the heading
};

/// One column being read: turns its fields into SI values and reports those that are wrong.
class ColumnReader {
public:
    /// @param request must outlive the reader
    ColumnReader(const ColumnHead& head, const ColumnRequest& request, InputErrors& errors);

    /// Where a field stands.
    struct FieldLocation {
        SourceLocation place;
        std::string aside{};  ///< ends the sentence of a file that has no lines
    };
    /// Takes the next field. @param where gives its FieldLocation; called only for a field that is wrong
    template <typename Where>
    void take(std::string_view field, const Where& where) {
        const std::optional<Number> number = form_ == FieldForm::number ? leading_number(field) : clock_.read(field);
        if (!accept(field, number)) {
            ErrorText wrong = error_text(field, number);
            const FieldLocation spot = where();
            wrong.what += spot.aside;
            limiter_.add(spot.place, std::move(wrong));
        }
        remember();
    }
    /// Takes the next value of a file of numbers.
    template <typename Where>
    void take(double written, const Where& where) {
        if (!accept({}, Number{written, {}})) {
            ErrorText wrong = error_text(fmt_number(written), Number{written, {}});
            const FieldLocation spot = where();
            wrong.what += spot.aside;
            limiter_.add(spot.place, std::move(wrong));
        }
        remember();
    }
    /// Reports how many more errors there were.
    void close() { limiter_.close(request_->name); }

    std::vector<double> values;  ///< SI

private:
    /// Appends the value. @returns false for a wrong one
    bool accept(std::string_view field, const std::optional<Number>& number);
    [[nodiscard]] ErrorText error_text(std::string_view field, const std::optional<Number>& number) const;
    void remember();
    static std::string fmt_number(double written);

    const ColumnRequest* request_;
    FieldForm form_;
    ClockReader clock_;
    ErrorLimiter limiter_;
    std::string unit_;
    Conversion conversion_;
    bool has_unit_ = false;
    double last_ = -std::numeric_limits<double>::infinity();
    double before_last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace tiretherm::input
