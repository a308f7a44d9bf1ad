// SPDX-License-Identifier: BSD-3-Clause
// Comma-separated tables, as spreadsheets read them.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::post {

/// A number with so many significant digits, "{:.6g}"; an empty cell where it is not finite.
struct Digits {
    double value;
    int digits;
};
/// A number with so many decimals, "{:.4f}"; an empty cell where it is not finite.
struct Decimals {
    double value;
    int decimals;
};

/// A table that grows cell by cell. A text stands in quotes where a comma or a quote in it would end its cell.
class Csv {
public:
    explicit Csv(const std::vector<std::string>& headings);

    /// A whole row.
    void row(const auto&... cells) {
        (add(cells), ...);
        end_row();
    }
    void add(std::string_view text);
    void add(Digits number);
    void add(Decimals number);
    void add(std::integral auto whole) { add(std::string_view(std::to_string(whole))); }
    void end_row();

    [[nodiscard]] const std::string& text() const { return text_; }
    /// The rows so far, to be written; what follows begins anew.
    [[nodiscard]] std::string take();

private:
    void separate();

    std::string text_;
    bool in_row_ = false;
};

}  // namespace tiretherm::post
