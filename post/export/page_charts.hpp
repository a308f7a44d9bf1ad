// SPDX-License-Identifier: BSD-3-Clause
// The charts of a report.html, read back from it.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::post {

/// A chart of a page.
struct PageChart {
    std::string title;
    std::string element;    ///< the whole figure as it stands in the page
    std::string picture{};  ///< the name of its picture
};

/// What a page holds.
struct PageCharts {
    std::string version;  ///< of the program that wrote it
    std::vector<PageChart> charts;
};

/// A page that is none of this program's, or that was cut off or damaged; what() says what is wrong with it.
class PageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The charts of a page, each with the name of its picture. @errors FileError; PageError
[[nodiscard]] PageCharts read_page(const std::filesystem::path& page);

/// Names of the pictures of charts: "Heat at the end" is heat-at-the-end.png; equal ones are numbered from 2 on.
[[nodiscard]] std::vector<std::string> picture_names(const std::vector<PageChart>& charts);

/// Leaves those charts alone, in the order of the page, that are named: by the title, or by the picture with or without its ending.
/// @param names empty: all   @returns the first name that no chart has; empty where each has one
[[nodiscard]] std::string choose_charts(PageCharts& page, const std::vector<std::string>& names);

}  // namespace tiretherm::post
