// SPDX-License-Identifier: BSD-3-Clause
// Reads one column of a CSV or HDF5 file into SI values, checked for its purpose: clock, input, measured, point and
// others.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "input/clock/clock.hpp"
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
    int date_column = -1;   ///< of a clock: the column that has its dates; -1: none
};

/// Where a field of a column stands.
struct FieldLocation {
    SourceLocation place;
    std::string aside{};  ///< ends the sentence of a file that has no lines
    std::string text{};   ///< as written, with a decimal point; empty in a file of numbers
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
    std::string
        unit_remedy{};  ///< what to do about a unit that is missing or wrong; empty: to write it into the heading
};

/// One column being read: turns its fields into SI values and reports those that are wrong.
class ColumnReader {
public:
    /// @param request must outlive the reader
    ColumnReader(const ColumnHead& head, const ColumnRequest& request, InputErrors& errors);

    /// Takes the next number as it is written, NaN where nothing stands.
    /// @param is_number false where something else stands
    /// @param where gives its FieldLocation; called only for the first few that are wrong
    template <typename Where>
    void take(double written, bool is_number, const Where& where) {
        if (!accept(written, is_number)) {
            limiter_.only_counts() ? limiter_.add({}, {}) : report(where(), written, is_number);
        }
        remember();
    }
    /// Reports how many more errors there were.
    void close() { limiter_.close(request_->name); }

    std::vector<double> values;  ///< SI

private:
    /// Whether a clock that shows this next was set to another time.
    [[nodiscard]] bool leaps(double value) const;
    /// Appends the value. @returns false for a wrong one
    bool accept(double written, bool is_number);
    void report(const FieldLocation& field, double written, bool is_number);
    [[nodiscard]] ErrorText error_text(std::string_view field, double written, bool is_number) const;
    /// A unit in which a value that is out of range would be in it, the other sign of a load among them; empty: none.
    [[nodiscard]] std::string other_unit(double written) const;
    void remember();

    const ColumnRequest* request_;
    std::string heading_;
    FieldForm form_;
    ErrorLimiter limiter_;
    std::string unit_;
    Conversion conversion_;
    bool has_unit_ = false;
    double last_ = -std::numeric_limits<double>::infinity();
    double before_last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace tiretherm::input
