// SPDX-License-Identifier: BSD-3-Clause
// Looks for few numbers beyond a range, each of which stands several times or is one that programs write on purpose.

#include "input/tables/dead_codes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tiretherm::input {

namespace {

constexpr std::size_t most_codes = 2;
constexpr double far = 30.0;  ///< K, from all that is measured
constexpr std::array usual{127.0, 255.0, 999.0, 9999.0, 32767.0, 65535.0};

bool is_usual(double number) { return std::ranges::find(usual, std::abs(number)) != usual.end() || number == -32768.0; }

}  // namespace

DeadCodes::DeadCodes(const std::vector<double>& written, const ColumnHead& head, const ColumnRequest& request) {
    const UnitRead read = read_heading_unit(head.heading, request.spec);
    const QuantitySpec& spec = request.spec;
    if (spec.unit != "K" || spec.scale != Scale::absolute || request.purpose != Purpose::measured || read.error) {
        return;
    }
    std::vector<std::size_t> count;
    std::size_t known = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double number : written) {
        const double value = read.conversion.to_si(number);
        if (!std::isfinite(number)) {
            continue;
        }
        ++known;
        if (value >= spec.low && value <= spec.high) {
            least = std::min(least, value);
            most = std::max(most, value);
            continue;
        }
        const auto at = std::ranges::find(codes, number) - codes.begin();
        if (at == std::ssize(codes)) {
            codes.push_back(number);
            count.push_back(0);
        }
        ++count[static_cast<std::size_t>(at)];
        if (codes.size() > most_codes) {
            codes.clear();
            return;
        }
    }
    std::size_t dead = 0;
    std::vector<std::string> shown;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double value = read.conversion.to_si(codes[i]);
        const bool is_far = value < least - far || value > most + far;
        if (!is_far || (count[i] < 2 && !is_usual(codes[i]))) {
            codes.clear();
            return;
        }
        dead += count[i];
        shown.push_back(fmt::format("{:g} {}", codes[i], head.heading.unit.value_or("")));
    }
    if (dead == 0 || 2 * dead >= known) {
        codes.clear();
        return;
    }
    sentence = fmt::format("{} is {} in {} of {} samples, which no sensor of it reads: left out", request.name,
                           fmt::join(shown, " or "), dead, known);
}

}  // namespace tiretherm::input
