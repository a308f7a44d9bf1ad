// SPDX-License-Identifier: BSD-3-Clause
// Joins words by commas and a last "and".

#include "input/text/word_lists.hpp"

namespace tiretherm::input {

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += i == 0 ? "" : (i + 1 == words.size() ? " and " : ", ");
        text += words[i];
    }
    return text;
}

}  // namespace tiretherm::input
