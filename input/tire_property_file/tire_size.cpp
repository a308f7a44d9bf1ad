// SPDX-License-Identifier: BSD-3-Clause
// Forms in which sizes are written. Section height = aspect ratio * width, thesis (65), or half of what the outer diameter leaves
// of the rim's.
#include "input/tire_property_file/tire_size.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <regex>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr std::string_view remedy =
    "write width in mm / aspect ratio in %, R, rim in inches: \"225/50 R17\"; or in inches outer diameter x width, "
    "rim: \"31x10.50 R15\", or width, rim: \"11 R22.5\"";
constexpr double inch = 0.0254;  // m

/// What a form of writing has in its three places.
enum class Form : std::uint8_t {
    metric,        ///< width in mm / aspect ratio in %, rim
    metric_outer,  ///< width in mm / outer diameter in mm, rim: of racing tires
    inches_outer,  ///< outer diameter x width, or width / outer diameter, and rim, in inches
    outer_alone,   ///< outer diameter x width in inches, of aircraft
    inches_width,  ///< width and rim in inches
    metric_width,  ///< width in mm, rim
};

struct SizePattern {
    Form form;
    std::string_view text;  ///< two or three numbers; without what stands before and behind
};
// The first that matches counts: 31x10.50 R15 also begins as a size without its rim would, and 200/600 R18 is no aspect ratio
// of 600 %.
constexpr std::array patterns{
    SizePattern{Form::metric_outer, R"((\d{3})\s*/\s*([4-9]\d\d)\s*(?:ZR|R|-)\s*(\d{2}))"},
    SizePattern{Form::metric, R"((\d{2,3})\s*/\s*(\d{2,3})\s*-?\s*(?:[ZVHS]R|R|B|D|-)\s*(\d{2}(?:\.5)?))"},
    SizePattern{Form::inches_outer,
                R"((\d{1,2}(?:\.\d+)?)\s*x\s*(\d{1,2}(?:\.\d+)?)\s*(?:ZR|R|B|D|-)\s*(\d{1,2}(?:\.\d)?))"},
    SizePattern{Form::inches_outer, R"((\d{1,2}\.\d+)\s*/\s*(\d{1,2}\.\d+)\s*(?:R|-)\s*(\d{1,2}))"},
    SizePattern{Form::outer_alone, R"((\d{2}(?:\.\d+)?)\s*x\s*(\d{1,2}(?:\.\d+)?))"},
    SizePattern{Form::inches_width, R"((\d{1,2}(?:\.\d{1,2})?)\s*(?:R|B|D|-)\s*(\d{1,2}(?:\.5)?))"},
    SizePattern{Form::metric_width, R"((\d{3})\s*(?:[ZVHS]R|R|-)\s*(\d{2}))"}};

/// Before: P, LT, ST, T; H, B of aircraft. Behind: C, LT or M/C, then load index (or a pair of it) and speed symbol, then anything.
std::regex whole(const SizePattern& pattern) {
    constexpr std::string_view before = R"(\s*(P|LT|ST|T|H|B)?\s*)";
    constexpr std::string_view behind = R"(\s*(C|LT|M/C)?(?:\s+\(?(?:(\d{2,3})(?:/\d{2,3})?\s*\(?([A-Y])?\b)?.*)?)";
    return std::regex(fmt::format("{}{}{}", before, pattern.text, behind), std::regex::icase);
}

/// How high a section is over its width where the size does not say it: of tires in the tables of ETRTO (recalled).
double usual_ratio(Form form, const std::string& width, double rim) {
    const std::size_t point = width.find('.');
    if (form == Form::metric_width) {
        return 0.80;  // 165 R13, 185 R14
    }
    if (rim != std::floor(rim)) {
        return 0.86;  // 11 R22.5: rims whose seats rise by 15 degrees
    }
    return point != std::string::npos && point + 2 == width.size() ? 0.85 : 1.0;  // 18.4 R38; 7.50 R16
}

/// Width, section height and rim from the numbers of a form, m. @param numbers as written
void take_numbers(Form form, const std::vector<std::string>& numbers, TireSize& size) {
    const auto number = [&](std::size_t i) { return std::stod(numbers[i]); };
    size.rim_diameter = number(numbers.size() - 1) * inch;
    const double rim = number(numbers.size() - 1);
    switch (form) {
        case Form::metric:
            size.width = number(0) * 1e-3;
            size.section_height = size.width * number(1) * 1e-2;
            size.truck = rim != std::floor(rim);
            size.motorcycle = !size.truck && number(0) <= 240.0 && std::fmod(number(0), 10.0) == 0.0 && rim <= 21.0;
            break;
        case Form::metric_outer:
            size.width = number(0) * 1e-3;
            size.section_height = 0.5 * (number(1) * 1e-3 - size.rim_diameter);
            break;
        case Form::inches_outer:
            size.width = std::min(number(0), number(1)) * inch;
            size.section_height = 0.5 * (std::max(number(0), number(1)) * inch - size.rim_diameter);
            break;
        case Form::outer_alone: {
            constexpr double type_seven = 0.91;  // section height over width: 22x5.5 and 18x4.4 on rims of 12 and 10 in
            const double outer = number(0);
            size.width = number(1) * inch;
            size.rim_diameter = std::round(outer - 2.0 * type_seven * number(1)) * inch;
            size.section_height = 0.5 * (outer * inch - size.rim_diameter);
            size.assumption =
                fmt::format("a rim of {:g} in, as aircraft tires of type VII have", size.rim_diameter / inch);
            break;
        }
        case Form::inches_width:
        case Form::metric_width: {
            const double ratio = usual_ratio(form, numbers[0], rim);
            size.width = number(0) * (form == Form::metric_width ? 1e-3 : inch);
            size.section_height = ratio * size.width;
            size.truck = form == Form::inches_width && (rim != std::floor(rim) || rim >= 20.0);
            size.assumption =
                fmt::format("a section {:g} % as high as wide, which the size does not say", 100.0 * ratio);
            break;
        }
    }
    size.aspect_ratio = 100.0 * size.section_height / size.width;
}

}  // namespace

double TireSize::load_pressure() const {
    constexpr double of_light_truck = 450e3;
    constexpr double of_truck = 800e3;
    constexpr double of_motorcycle_rear = 290e3;
    return truck                                  ? of_truck
           : light_truck                          ? of_light_truck
           : motorcycle && !is_motorcycle_front() ? of_motorcycle_rear
                                                  : physics::standard_load_pressure;
}

std::variant<TireSize, ErrorText> read_tire_size(std::string_view text) {
    static const std::vector<std::regex> expressions = [] {
        std::vector<std::regex> all;
        std::ranges::transform(patterns, std::back_inserter(all), whole);
        return all;
    }();
    // The library matches by recursion over the text: a long one would take the stack.
    constexpr std::size_t longest = 80;
    TireSize size{.text = std::string(text)};
    std::smatch parts;
    const auto found = text.size() > longest ? expressions.end()
                                             : std::ranges::find_if(expressions, [&](const std::regex& expression) {
                                                   return std::regex_match(size.text, parts, expression);
                                               });
    if (found == expressions.end()) {
        return ErrorText{fmt::format("size is \"{}\", not the size of a tire", text), std::string(remedy)};
    }
    const Form form = patterns.at(static_cast<std::size_t>(found - expressions.begin())).form;
    const std::size_t behind = parts.size() - 3;  // letters, load index, speed symbol
    std::vector<std::string> numbers;
    for (std::size_t i = 2; i < behind; ++i) {
        numbers.push_back(parts[i].str());
    }
    take_numbers(form, numbers, size);
    const bool has_motorcycle_mark = parts[behind].length() == 3;
    size.light_truck = size.truck || (parts[behind].matched && !has_motorcycle_mark) || parts[1].length() == 2;
    size.motorcycle = has_motorcycle_mark || (size.motorcycle && !size.light_truck && !parts[1].matched);
    if (parts[behind + 1].matched) {
        const char symbol = parts[behind + 2].matched ? *parts[behind + 2].first : ' ';
        size.service = physics::ServiceDescription{
            .load_index = std::stoi(parts[behind + 1]),
            .speed_symbol = static_cast<char>(std::toupper(static_cast<unsigned char>(symbol)))};
    }
    constexpr double smallest_rim = 0.1;  // m; of karts
    if (size.width < 0.02 || size.aspect_ratio < (form == Form::metric ? 15.0 : 20.0) || size.aspect_ratio > 110.0 ||
        size.rim_diameter < smallest_rim) {
        return ErrorText{fmt::format("size is \"{}\": {:.4g} mm wide, aspect ratio {:.4g} %, rim {:g} in", text,
                                     size.width * 1e3, size.aspect_ratio, size.rim_diameter / inch),
                         std::string(remedy)};
    }
    return size;
}

}  // namespace tiretherm::input
