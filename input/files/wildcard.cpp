// SPDX-License-Identifier: BSD-3-Clause
// Compares a name with a pattern, going back to the last star where the rest does not fit.

#include "input/files/wildcard.hpp"

#include <cstddef>

namespace tiretherm::input {

bool matches(std::string_view pattern, std::string_view name) {
    std::size_t p = 0;
    std::size_t n = 0;
    std::size_t star = std::string_view::npos;
    std::size_t after_star = 0;  // up to here the last star has taken the name
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            after_star = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++after_star;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') {
        ++p;
    }
    return p == pattern.size();
}

bool is_pattern(std::string_view word) { return word.find_first_of("*?") != std::string_view::npos; }

}  // namespace tiretherm::input
