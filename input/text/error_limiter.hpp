// SPDX-License-Identifier: BSD-3-Clause
// Limits repeated errors of one kind, such as those of a data column: five are reported, the rest is counted.
#pragma once

#include <fmt/format.h>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// Errors of one kind, such as those of a column: five are reported, the others counted.
class ErrorLimiter {
public:
    explicit ErrorLimiter(InputErrors& errors) : errors_(&errors) {}

    void add(const SourceLocation& place, ErrorText error) {
        if (++count_ <= shown) {
            errors_->add(place, std::move(error));
        } else if (count_ == shown + 1) {
            next_ = place;
        }
    }
    /// Whether what is added is only counted from now on.
    [[nodiscard]] bool only_counts() const { return count_ > shown; }
    /// Reports how many more there were. @param subject what they are about, such as a column's name
    void close(const std::string& subject) {
        if (count_ > shown) {
            errors_->add(next_, fmt::format("{}: and {} more like this", subject, count_ - shown));
        }
    }

private:
    static constexpr int shown = 5;
    InputErrors* errors_;
    int count_ = 0;
    SourceLocation next_;
};

}  // namespace tiretherm::input
