// SPDX-License-Identifier: BSD-3-Clause
// Looks for the markers alone; what else the XML holds is of the display.

#include "input/loggers/motec_ldx.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "input/text/quantity.hpp"
#include "input/text/regular_file.hpp"

namespace tiretherm::input {

namespace {

constexpr std::uintmax_t largest = 10'000'000;  ///< bytes; a file of a few beacons has some kilobytes
constexpr double microsecond = 1e-6;

}  // namespace

std::filesystem::path ldx_file(const std::filesystem::path& ld_file) {
    return std::filesystem::path(ld_file).replace_extension(".ldx");
}

std::vector<double> read_ldx_markers(const std::filesystem::path& ld_file) {
    const std::filesystem::path file = ldx_file(ld_file);
    if (!not_readable(file, largest).what.empty()) {
        return {};
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    std::vector<double> markers;
    std::size_t end = 0;
    for (std::size_t at = text.find("<Marker "); at != std::string::npos; at = text.find("<Marker ", end)) {
        end = std::min(text.find_first_of("<>", at + 1), text.size());  // of a damaged element at the next one
        const std::string_view element = std::string_view(text).substr(at, end - at);
        const std::size_t time = element.find(" Time=\"");
        if (element.find("ClassName=\"BCN\"") == std::string_view::npos || time == std::string_view::npos) {
            continue;
        }
        const std::optional<Number> number = leading_number(element.substr(time + 7));
        if (number && std::isfinite(number->value)) {
            markers.push_back(microsecond * number->value);
        }
    }
    std::ranges::sort(markers);
    return markers;
}

}  // namespace tiretherm::input
