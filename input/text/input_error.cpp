// SPDX-License-Identifier: BSD-3-Clause
// Formats errors as a compiler does (file, line, caret, remedy) and sorts them by place.

#include "input/text/input_error.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "input/text/characters.hpp"
#include "input/text/source_text.hpp"
#include "input/text/table_shelf.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t widest = 110;  // characters of a source line that are shown
constexpr int farthest = 50'000;     // columns of a line up to which it is shown
// A file of the wrong kind has an error in each of its lines, and nobody reads more of them.
constexpr std::size_t most_shown = 1000;

/// The line and a caret under its place. A long line is cut to a window about the place.
std::string underlined(const InputError& error) {
    std::vector<std::string> characters = split_characters(error.source);
    auto first = static_cast<std::size_t>(std::max(0, error.column - 1));
    if (first > characters.size()) {
        first = characters.size();
    }
    if (characters.size() > widest) {
        const std::size_t from = first > widest / 2 ? std::min(first - widest / 2, characters.size() - widest) : 0;
        const std::size_t to = from + widest;
        std::vector<std::string> window(characters.begin() + static_cast<std::ptrdiff_t>(from),
                                        characters.begin() + static_cast<std::ptrdiff_t>(to));
        if (from > 0) {
            window.insert(window.begin(), "...");
        }
        if (to < characters.size()) {
            window.emplace_back("...");
        }
        first = first - from + (from > 0 ? 1 : 0);
        characters = std::move(window);
    }
    std::string line = "    ";
    std::string caret = "    ";
    for (std::size_t i = 0; i < characters.size(); ++i) {
        line += characters[i];
        if (i < first) {
            caret += characters[i] == "\t" ? "\t" : std::string(characters[i] == "..." ? 3 : 1, ' ');
        }
    }
    const std::size_t room = characters.size() > first ? characters.size() - first : 1;
    const auto length = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, error.length)), 1, room);
    return line + "\n" + caret + "^" + std::string(length - 1, '~') + "\n";
}

/// A sentence without the middle of what is very long, such as a value of ten thousand characters.
std::string shortened(std::string text) {
    constexpr std::size_t longest = 1000;
    constexpr std::size_t kept = 200;  // at each end
    if (text.size() <= longest) {
        return text;
    }
    const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
    std::size_t from = kept;
    std::size_t to = text.size() - kept;
    while (from > 0 && inside(from)) {
        --from;
    }
    while (to < text.size() && inside(to)) {
        ++to;
    }
    return fmt::format("{} ... ({} characters) ... {}", text.substr(0, from), to - from, text.substr(to));
}

std::string spelled(const std::string& file, int line) { return line > 0 ? fmt::format("{}:{}", file, line) : file; }

}  // namespace

std::string render(const InputError& error) {
    const std::string file = printable(error.file);
    const std::string what = printable(error.what);
    std::string text = error.line > 0 ? fmt::format("{}:{}:{}: {}\n", file, error.line, error.column, what)
                                      : fmt::format("{}: {}\n", file, what);
    if (error.line > 0 && !error.source.empty()) {
        text += underlined(error);
    }
    if (!error.remedy.empty()) {
        text += fmt::format("    remedy: {}\n", printable(error.remedy));
    }
    return text;
}

std::vector<InputWarning> merged(const std::vector<InputWarning>& warnings, std::size_t n_corners) {
    struct Merged {
        const InputWarning* first = nullptr;
        std::vector<std::string> corners{};  ///< that say the same
    };
    std::vector<Merged> alike;
    for (const InputWarning& one : warnings) {
        const auto is_same = [&](const Merged& other) {
            return std::tie(one.file, one.line, one.what) ==
                       std::tie(other.first->file, other.first->line, other.first->what) &&
                   one.corner.empty() == other.corners.empty();
        };
        auto same = std::ranges::find_if(alike, is_same);
        if (same == alike.end()) {
            same = alike.insert(alike.end(), {.first = &one});
        }
        if (!one.corner.empty() && std::ranges::find(same->corners, one.corner) == same->corners.end()) {
            same->corners.push_back(one.corner);
        }
    }
    std::vector<InputWarning> all;
    for (const auto& [first, corners] : alike) {
        const bool is_of_some = !corners.empty() && (n_corners < 2 || corners.size() < n_corners);
        all.push_back(*first);
        all.back().what.insert(0, is_of_some ? fmt::format("at {}: ", listed(corners)) : "");
    }
    return all;
}

std::string render(const InputWarning& warning) {
    return (warning.file.empty() ? "" : spelled(warning.file, warning.line) + ": ") + warning.what;
}

std::vector<std::string> render(const std::vector<InputWarning>& warnings, std::size_t n_corners) {
    std::vector<std::string> sentences;
    for (const InputWarning& one : merged(warnings, n_corners)) {
        sentences.push_back(render(one));
    }
    return sentences;
}

InputErrors::InputErrors() : tables_(std::make_shared<TableShelf>()) {}

int InputErrors::add_file(std::string shown, std::string text) {
    return add_file(std::move(shown), std::make_shared<const SourceText>(std::move(text)));
}

int InputErrors::add_file(std::string shown, std::shared_ptr<const SourceText> text) {
    files_.push_back({.shown = std::move(shown), .text = std::move(text)});
    return static_cast<int>(files_.size()) - 1;
}

int InputErrors::add_table(const std::string& shown, const LogTable& table,
                           const std::shared_ptr<const SourceText>& text) {
    auto known = std::ranges::find(files_, &table, &File::table);
    if (known == files_.end() && text) {
        known = std::ranges::find(files_, text, &File::text);
    }
    if (known == files_.end()) {
        add_file(shown, "");
        known = files_.end() - 1;
        known->text = text ? text : known->text;
    }
    known->table = &table;
    return static_cast<int>(known - files_.begin());
}

void InputErrors::take(const InputErrors& found, int number) {
    for (std::size_t i = 1; i < found.files_.size(); ++i) {  // that were read beside it
        add_file(found.files_[i].shown, "");
    }
    for (Found one : found.found_) {
        one.place.file = number;
        found_.push_back(std::move(one));
    }
    for (InputWarning one : found.warnings_) {  // in which the file may go by another path
        one.file = one.file == found.files_.front().shown ? file(number) : one.file;
        warnings_.push_back(std::move(one));
    }
}

int InputErrors::find_file(std::string_view shown) const {
    const auto found =
        std::ranges::find_if(files_, [&](const File& file) { return file.shown == shown && !file.text->is_empty(); });
    return found == files_.end() ? -1 : static_cast<int>(found - files_.begin());
}

std::vector<std::string> InputErrors::files() const {
    std::vector<std::string> all;
    for (const File& file : files_) {
        if (std::ranges::find(all, file.shown) == all.end()) {
            all.push_back(file.shown);
        }
    }
    return all;
}

std::nullopt_t InputErrors::add(const SourceLocation& place, ErrorText error) {
    SourceLocation where = place;
    if (where.file < 0) {  // of what nobody wrote, as a run that is the case itself: of the file that all began with
        where = {.file = files_.empty() ? add_file("input", "") : 0};
    }
    error.what = shortened(std::move(error.what));
    error.remedy = shortened(std::move(error.remedy));
    found_.push_back({where, std::move(error)});
    return std::nullopt;
}

void InputErrors::add_warning(const SourceLocation& place, std::string_view corner, std::string_view form,
                              std::string what) {
    warnings_.push_back({.file = place.file >= 0 ? file(place.file) : std::string(),
                         .line = place.line,
                         .corner = std::string(corner),
                         .what = shortened(std::move(what)),
                         .form = std::string(form)});
}

std::string InputErrors::spell(const SourceLocation& place) const { return spelled(file(place.file), place.line); }

std::string InputErrors::line_of(const SourceLocation& place) const {
    const std::shared_ptr<const std::string> whole = files_[static_cast<std::size_t>(place.file)].text->get();
    const std::string& text = *whole;
    std::size_t start = 0;
    for (int line = 1; line < place.line; ++line) {
        start = text.find('\n', start);
        if (start == std::string::npos) {
            return {};
        }
        ++start;
    }
    // Of a line without end, as of a file that is no table, only what is about the place.
    const std::size_t length = std::min(text.find('\n', start), text.size()) - start;
    std::string line = text.substr(start, std::min(length, std::size_t{4} * farthest));
    if (!line.empty() && line.back() == '\r') {
        line.pop_back();
    }
    return line.starts_with("\xEF\xBB\xBF") ? line.substr(3) : line;
}

std::vector<InputError> InputErrors::in_order() const {
    std::vector<const Found*> order;
    for (const Found& found : found_) {
        order.push_back(&found);
    }
    // Stable: two errors at one place stay in the order in which they were found.
    std::stable_sort(order.begin(), order.end(), [](const Found* a, const Found* b) {
        return std::tie(a->place.file, a->place.line, a->place.column) <
               std::tie(b->place.file, b->place.line, b->place.column);
    });
    std::vector<InputError> result;
    std::set<std::tuple<std::string_view, int, std::string_view>> seen;  // into files_ and found_
    for (const Found* found : order) {
        const SourceLocation& place = found->place;
        if (!seen.emplace(file(place.file), place.line, found->error.what).second) {
            continue;
        }
        if (result.size() == most_shown) {
            result.push_back({.file = file(place.file),
                              .what = fmt::format("and more errors, of which {} are shown", most_shown),
                              .remedy = "correct those first",
                              .source = {}});
            break;
        }
        InputError error{.file = file(place.file),
                         .line = place.line,
                         .column = place.column,
                         .length = place.length,
                         .what = found->error.what,
                         .remedy = found->error.remedy,
                         .source = {},
                         .code = found->error.code,
                         .about = found->error.about};
        error.source = place.line > 0 && place.column < farthest ? line_of(place) : std::string();
        result.push_back(std::move(error));
    }
    return result;
}

}  // namespace tiretherm::input
