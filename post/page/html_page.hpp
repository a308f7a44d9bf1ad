// SPDX-License-Identifier: BSD-3-Clause
// The page of a result as files: one HTML file that opens without a network, and text.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "post/report/report.hpp"

namespace tiretherm::post {

inline constexpr const char* page_name = "report.html";
inline constexpr const char* text_page_name = "page.txt";

/// What a page was made from, for its foot.
struct PageOrigin {
    std::string kind;                  ///< of the result, "run"
    std::string source{};              ///< the case file; may be empty
    std::vector<std::string> files{};  ///< all that were read: the case, what it includes, logs, tables
    /// Values of the case by their keys; with them the page holds the data of the result, for `report A B`. Empty: neither
    std::vector<std::pair<std::string, std::string>> case_values{};
};

/// Where a page holds the data of its result: an object of kind, case and data, up to the end of the element.
inline constexpr const char* page_data_begin = "<script type=\"application/json\" id=\"result-data\">";

/// The page of a result with its charts: title, verdict and lead first, then the sections, the appendix, and the files and
/// versions that it rests on. Style, script and the charting library are in it. Temperatures read °C.
[[nodiscard]] std::string html_page(const Report& report, const PageOrigin& origin);

/// Names of the files of a page, of which --no-report leaves out all: report.html, and page.txt as the terminal shows it.
[[nodiscard]] std::vector<std::string> page_names();
/// The same in a folder.
[[nodiscard]] std::vector<std::filesystem::path> page_files(const std::filesystem::path& folder);

/// Writes these files. @errors FileError
void write_page(const std::filesystem::path& folder, const Report& report, const PageOrigin& origin);

}  // namespace tiretherm::post
