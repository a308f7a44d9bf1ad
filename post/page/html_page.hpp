// SPDX-License-Identifier: BSD-3-Clause
// A result as one HTML file that opens without a network.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "post/report/report.hpp"

namespace tiretherm::post {

inline constexpr const char* page_name = "report.html";

/// What a page was made from, for its foot.
struct PageOrigin {
    std::string kind;                  ///< of the result, "run"
    std::string source{};              ///< the case file; may be empty
    std::vector<std::string> files{};  ///< all that were read: the case, what it includes, logs, tables
};

/// The page of a result with its charts: title, verdict and lead first, then the sections, the appendix, and the files and
/// versions that it rests on. Style, script and the charting library are in it. Temperatures read °C.
[[nodiscard]] std::string html_page(const Report& report, const PageOrigin& origin);

/// The same as a file. @errors FileError
void write_html_page(const std::filesystem::path& path, const Report& report, const PageOrigin& origin);

}  // namespace tiretherm::post
