// SPDX-License-Identifier: BSD-3-Clause
// A result as one HTML file that opens without a network.
#pragma once

#include <filesystem>
#include <string>

#include "post/report/report.hpp"

namespace tiretherm::post {

inline constexpr const char* page_name = "report.html";

/// The page of a result with its charts: title and lead first, then the sections. Style, script and the charting library are
/// in it. Temperatures read °C.
/// @param kind of the result, "run"   @param source the case file, for the foot of the page; may be empty
[[nodiscard]] std::string html_page(const Report& report, const std::string& kind, const std::string& source);

/// The same as a file. @errors FileError
void write_html_page(const std::filesystem::path& path, const Report& report, const std::string& kind,
                     const std::string& source);

}  // namespace tiretherm::post
