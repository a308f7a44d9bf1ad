// SPDX-License-Identifier: BSD-3-Clause
// Cuts the text of a case file into its tables, so that a new case has their lines as they were written, comments and all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

/// A table of a case file as it stands there: the comment above its heading, the heading, its lines.
struct CasePart {
    std::string table;  ///< "mesh.layer"; empty: what stands above the first heading
    std::vector<std::string> lines;

    /// The value of a key as it is written, `"8 mm"` with its quotation marks; empty when absent.
    [[nodiscard]] std::string value(std::string_view key) const;
    /// The same without quotation marks.
    [[nodiscard]] std::string text(std::string_view key) const;
    /// Writes another value in its place and another comment behind it. Nothing where the key is absent.
    void replace(std::string_view key, std::string_view value, std::string_view comment);
    void remove(std::string_view key);
};

/// The tables in the order of the file. A heading stands at the start of its line.
[[nodiscard]] std::vector<CasePart> cut_case(std::string_view text);

}  // namespace tiretherm::input
