// SPDX-License-Identifier: BSD-3-Clause
// Makes pictures of the charts of a page in Chromium without a window.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "post/export/page_charts.hpp"
#include "post/report/value.hpp"

namespace tiretherm::post {

/// Where the pictures of a page's charts go, in its folder.
inline constexpr const char* picture_folder = "charts";

struct PictureRequest {
    int width = 1600;  ///< px
    bool dark = false;
    std::string at{};  ///< s, or "end": the moment of fields and of frames; empty: that which the page shows first
    std::chrono::milliseconds limit = std::chrono::minutes(1);
    std::function<bool()> stopped = [] { return false; };
};

/// Chromium, or a browser that is made from it, on the search path.
[[nodiscard]] std::optional<std::filesystem::path> find_browser();

/// Why there are no pictures.
class BrowserError : public std::runtime_error {
public:
    enum class Cause {
        failed,     ///< the browser ended with an error, or without pictures
        timed_out,  ///< it took longer than the limit
        stopped,    ///< the user asked for an end
    };
    BrowserError(Cause why, const std::string& sentence) : std::runtime_error(sentence), cause(why) {}

    Cause cause;
};

/// What came of a chart: one of both is empty.
struct ChartPicture {
    std::string png;      ///< the bytes of a file
    std::string failure;  ///< why its data cannot be drawn
};

/// The charts as they are in the page, each with its title on top, drawn by the scripts of this program: those of the page
/// are not run, and nothing is fetched from a network. A chart that cannot be drawn costs no other its picture.
/// @returns [charts]   @errors BrowserError; FileError where no temporary file can be written
[[nodiscard]] std::vector<ChartPicture> chart_pictures(const std::filesystem::path& browser, const PageCharts& page,
                                                       const PictureRequest& request);

/// Writes the pictures into `picture_folder` of a page's folder, together. @param pictures [charts]
/// @errors FileError; OutputError where another call works there
void write_pictures(const std::filesystem::path& folder, const PageCharts& page,
                    const std::vector<ChartPicture>& pictures);

/// Why charts have no picture: the first of them, and what to do. Empty where all have one.
[[nodiscard]] std::string not_drawn(const PageCharts& page, const std::vector<ChartPicture>& pictures);

/// A folder's page as data: its charts, and their pictures with their sizes. @param pictures [charts], or empty: none was asked for
[[nodiscard]] Value page_data(const std::filesystem::path& folder, const PageCharts& page,
                              const std::vector<ChartPicture>& pictures);

}  // namespace tiretherm::post
