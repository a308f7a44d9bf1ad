// SPDX-License-Identifier: BSD-3-Clause
// Splits names into words and finds them in the vocabulary.

#include "input/text/column_names.hpp"

#include <algorithm>
#include <cctype>
#include <variant>

#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string first_of(std::string_view name, std::string_view list) {
    for (std::string& word : words_of(name)) {
        if (has_word(list, word)) {
            return std::move(word);
        }
    }
    return {};
}

}  // namespace

bool has_word(std::string_view words, std::string_view word) {
    for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
        const bool begins = at == 0 || words[at - 1] == ' ';
        const bool ends = at + word.size() == words.size() || words[at + word.size()] == ' ';
        if (begins && ends) {
            return !word.empty();
        }
    }
    return false;
}

std::string bare_name(std::string_view name) {
    std::string bare;
    for (const char c : name) {
        if (is_letter_or_digit(c)) {
            bare += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return bare;
}

std::vector<std::string> words_of(std::string_view name) {
    enum class Class { none, small, capital, digit, other };
    const auto class_of = [](char letter) {
        const auto c = static_cast<unsigned char>(letter);
        // Letters beyond ASCII are some bytes in UTF-8, none of which may begin a word of its own: "Außen" is one word.
        return c >= 128          ? Class::small
               : std::islower(c) ? Class::small
               : std::isupper(c) ? Class::capital
               : std::isdigit(c) ? Class::digit
                                 : Class::other;
    };
    std::vector<std::string> words;
    Class before = Class::none;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const Class now = class_of(name[i]);
        if (now == Class::other) {
            before = now;
            continue;
        }
        // A new word begins at a capital after a small letter, at the last of several capitals before one, at digits.
        const bool last_capital = now == Class::capital && before == Class::capital && i + 1 < name.size() &&
                                  class_of(name[i + 1]) == Class::small;
        const bool goes_on = now == before || (before == Class::capital && now == Class::small);
        if (words.empty() || !goes_on || last_capital) {
            words.emplace_back();
        }
        words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
        before = now;
    }
    return words;
}

std::string word_of_result(std::string_view name) { return first_of(name, column_words::computed); }

std::string word_of_clock(std::string_view name) {
    if (std::string word = first_of(name, column_words::counted); !word.empty()) {
        return word;
    }
    std::vector<std::string> words = words_of(name);
    std::erase_if(words,
                  [](const std::string& word) { return std::isdigit(static_cast<unsigned char>(word.front())); });
    if (std::ranges::find(words, "gps") != words.end()) {
        return first_of(name, column_words::counted_by_gps);
    }
    return words.size() == 1 && has_word(column_words::counted_alone, words.front()) ? words.front() : std::string();
}

bool is_temperature(std::string_view name, std::string_view unit) {
    // UDUNITS takes them for the coulomb and the farad; on the head of a column they are degrees.
    if (unit == "C" || unit == "F") {
        return true;
    }
    if (unit.empty() || unit == "-" || unit == "1") {
        return !first_of(name, column_words::measures_temperature).empty();
    }
    const auto read = conversion(unit, "K", Scale::absolute);
    return std::holds_alternative<Conversion>(read);
}

std::string word_of_tire(std::string_view name) { return first_of(name, column_words::of_tire); }

std::string word_from_outside(std::string_view name) { return first_of(name, column_words::from_outside); }

}  // namespace tiretherm::input
