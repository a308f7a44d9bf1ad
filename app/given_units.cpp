// SPDX-License-Identifier: BSD-3-Clause
// Splits COLUMN=UNIT.

#include "app/given_units.hpp"

#include <string_view>

#include <fmt/format.h>

#include "app/messages.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::app {

std::optional<std::vector<input::GivenUnit>> given_units(const std::vector<std::string>& words, bool json) {
    std::vector<input::GivenUnit> units;
    for (const std::string& word : words) {
        const std::size_t sign = word.rfind('=');
        if (sign == std::string::npos || sign == 0 || sign + 1 == word.size()) {
            report_error(fmt::format("--unit {} is not a column and its unit", word),
                         "write --unit \"GPS Speed=km/h\", or --unit \"*temp*=degC\" of several columns", json);
            return std::nullopt;
        }
        units.push_back({std::string(input::trim(std::string_view(word).substr(0, sign))),
                         std::string(input::trim(std::string_view(word).substr(sign + 1)))});
    }
    return units;
}

}  // namespace tiretherm::app
