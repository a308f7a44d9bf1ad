// SPDX-License-Identifier: BSD-3-Clause
// Edit distance with transpositions (optimal string alignment) for "did you mean".

#include "input/text/suggestions.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

std::size_t distance(std::string_view a, std::string_view b) {
    // Rows of the table of edits between the beginnings of both: this one and the two before it.
    std::vector<std::size_t> before_last;
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last = std::exchange(last, row);
        row.front() = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1])) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return row.back();
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 100;  // no word that somebody types is longer, and the edits cost its square
    if (word.size() > longest) {
        return {};
    }
    std::string best;
    // One slip in three letters is a slip; more of them make another word.
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : known) {
        if (candidate.size() > word.size() + least || word.size() > candidate.size() + least) {
            continue;
        }
        if (const std::size_t edits = distance(word, candidate); edits < least) {
            least = edits;
            best = candidate;
        }
    }
    return best;
}

std::string suggest(std::string_view word, const std::vector<std::string>& known, std::string_view kind) {
    if (const std::string near = nearest(word, known); !near.empty()) {
        return fmt::format("did you mean `{}`?", near);
    }
    if (known.size() < 2) {
        return known.empty() || known.front().empty() ? fmt::format("there are no {}", kind)
                                                      : fmt::format("there is only `{}`", known.front());
    }
    return fmt::format("the {} are {}", kind, listed(known));
}

}  // namespace tiretherm::input
