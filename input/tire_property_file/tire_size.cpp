// SPDX-License-Identifier: BSD-3-Clause
// Reads a tire's size, section height = aspect ratio * width, thesis (65).
#include "input/tire_property_file/tire_size.hpp"

#include <cctype>
#include <regex>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr std::string_view remedy = "write width in mm / aspect ratio in %, R, rim in inches: \"225/50 R17\"";
constexpr double inch = 0.0254;  // m

}  // namespace

std::variant<TireSize, ErrorText> read_tire_size(std::string_view text) {
    static const std::regex pattern(
        R"(\s*(P|LT|T)?\s*(\d{2,3})\s*/\s*(\d{2,3})\s*-?\s*(?:ZR|R|B|D|-)\s*(\d{2}(?:\.5)?)\s*(C)?(?:\s+(?:(\d{2,3})(?:/\d{2,3})?\s*([A-Y])?\b)?.*)?)",
        std::regex::icase);
    TireSize size{.text = std::string(text)};
    std::smatch parts;
    if (!std::regex_match(size.text, parts, pattern)) {
        return ErrorText{fmt::format("size is \"{}\", not the size of a tire", text), std::string(remedy)};
    }
    const double width_mm = std::stod(parts[2]);
    const double rim_inches = std::stod(parts[4]);
    size.aspect_ratio = std::stod(parts[3]);
    size.width = width_mm * 1e-3;
    size.section_height = size.width * size.aspect_ratio * 1e-2;
    size.rim_diameter = rim_inches * inch;
    size.light_truck = parts[5].matched || parts[1].length() == 2;
    if (parts[6].matched) {
        const char symbol = parts[7].matched ? *parts[7].first : ' ';
        size.service = physics::ServiceDescription{
            .load_index = std::stoi(parts[6]),
            .speed_symbol = static_cast<char>(std::toupper(static_cast<unsigned char>(symbol)))};
    }
    if (width_mm < 20.0 || size.aspect_ratio < 15.0 || size.aspect_ratio > 110.0 || size.rim_diameter < 0.2) {
        return ErrorText{fmt::format("size is \"{}\": {} mm wide, aspect ratio {} %, rim {} in", text, width_mm,
                                     size.aspect_ratio, parts[4].str()),
                         std::string(remedy)};
    }
    return size;
}

}  // namespace tiretherm::input
