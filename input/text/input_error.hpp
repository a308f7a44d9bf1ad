// SPDX-License-Identifier: BSD-3-Clause
// Errors and warnings in user input, with file, line, column and remedy, collected so that all are shown at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace tiretherm::input {

struct LogTable;
class SourceText;
struct TableShelf;

/// By what the program tells errors apart. A sentence is for the user; whoever must know which error it is asks for this.
enum class ErrorCode : std::uint8_t {
    other,          ///< nobody needs to know
    missing_input,  ///< an active effect needs an input that [drive] lacks; there is no run that may give it
};

/// An error in what the user wrote, and where. Lines and columns count from 1; a column is a character, not a byte.
struct InputError {
    std::string file;  ///< as the user would type it
    int line = 0;      ///< 0: the file as a whole
    int column = 0;
    int length = 0;  ///< characters to underline
    std::string what;
    std::string remedy;  ///< what to do; empty where `what` says it already
    std::string source;  ///< the line of the file
    ErrorCode code = ErrorCode::other;
    std::string about{};  ///< the input that is wrong, where it is one: "speed"
};

/// Something unusual that a run can still be made of.
struct InputWarning {
    std::string file{};    ///< as the user would type it; empty: of the case as a whole
    int line = 0;          ///< 0: the file as a whole
    std::string corner{};  ///< of the car, FL, FR, RL or RR, that it is about; empty: no single one
    std::string what;
    std::string form{};  ///< of which kind it is: `what` before its values were put in; empty: it has none
};

/// The error as a compiler shows it: `file:line:column: what`, the line, a caret under the place, the remedy.
/// @returns lines, each ended by a newline
[[nodiscard]] std::string render(const InputError& error);

/// Warnings that are alike but for their corners once, each with the corners in its sentence where they are not all of the case.
/// @param n_corners of the case; 0 and 1: all that is said of a corner is of this one
[[nodiscard]] std::vector<InputWarning> merged(const std::vector<InputWarning>& warnings, std::size_t n_corners);
/// A warning as a sentence: "FILE:LINE: what".
[[nodiscard]] std::string render(const InputWarning& warning);
/// Warnings as sentences, those that are alike once: "FILE:LINE: at FL and FR: what". Of all corners of the case they are not named.
/// @param n_corners of the case; 0 and 1: all that is said of a corner is of this one
[[nodiscard]] std::vector<std::string> render(const std::vector<InputWarning>& warnings, std::size_t n_corners);

/// An error without its place: what is wrong, and what to do.
struct ErrorText {
    std::string what;
    std::string remedy;
    ErrorCode code = ErrorCode::other;
    std::string about{};  ///< as in InputError
};

/// A piece of a file. `file` counts the files in the order they were read.
struct SourceLocation {
    int file = -1;
    int line = 0;
    int column = 0;
    int length = 0;
};

/// Collects everything that is wrong with a case and its files, so that the user sees it all at once.
class InputErrors {
public:
    InputErrors();
    /// @param shown path as the user would type it  @returns the file's number
    int add_file(std::string shown, std::string text);
    int add_file(std::string shown, std::shared_ptr<const SourceText> text);
    /// The same of a file with a table, which it has once. @param text of the file; null: none
    int add_table(const std::string& shown, const LogTable& table, const std::shared_ptr<const SourceText>& text);
    /// The number of a file that has been read with its text, -1 when it has not: it need not be read a second time.
    [[nodiscard]] int find_file(std::string_view shown) const;
    [[nodiscard]] const std::shared_ptr<const SourceText>& text(int number) const {
        return files_[static_cast<std::size_t>(number)].text;
    }
    /// The tables that have been read, for these errors, their copies and all that share them.
    [[nodiscard]] TableShelf& tables() const { return *tables_; }
    /// Uses the tables that others have read.
    void share_tables(const InputErrors& others) { tables_ = others.tables_; }
    /// Takes over what is wrong with a file that was read by itself, as the first of `found`. @param number of it here
    void take(const InputErrors& found, int number);
    /// @returns nothing, what a reader has of a wrong value: `return errors.add(...)`
    std::nullopt_t add(const SourceLocation& place, ErrorText error);
    std::nullopt_t add(const SourceLocation& place, std::string what, std::string remedy = {}) {
        return add(place, ErrorText{std::move(what), std::move(remedy)});
    }
    /// Something unusual that a run can still be made of.
    void warn(const SourceLocation& place, std::string what) { add_warning(place, {}, {}, std::move(what)); }
    /// The same of a sentence with values, as fmt::format takes them.
    template <typename... Args>
    void warn(const SourceLocation& place, fmt::format_string<Args...> form, Args&&... values) {
        warn_of_corner(place, {}, form, std::forward<Args>(values)...);
    }
    /// The same of one corner of a car. @param corner empty: no single one
    template <typename... Args>
    void warn_of_corner(const SourceLocation& place, std::string_view corner, fmt::format_string<Args...> form,
                        Args&&... values) {
        const fmt::string_view text = form;
        add_warning(place, corner, {text.data(), text.size()}, fmt::format(form, std::forward<Args>(values)...));
    }

    [[nodiscard]] std::size_t count() const { return found_.size(); }
    [[nodiscard]] const std::string& file(int number) const { return files_[static_cast<std::size_t>(number)].shown; }
    /// The path that a file names, from the folder of that file on.
    [[nodiscard]] std::filesystem::path beside(const SourceLocation& place, const std::filesystem::path& name) const {
        return (std::filesystem::path(file(place.file)).parent_path() / name).lexically_normal();
    }
    /// All files that were read, in that order, each once.
    [[nodiscard]] std::vector<std::string> files() const;
    /// "case.toml:12", for a sentence about another place.
    [[nodiscard]] std::string spell(const SourceLocation& place) const;
    /// All errors in the order of the files and of their places in them, none twice.
    [[nodiscard]] std::vector<InputError> in_order() const;
    [[nodiscard]] const std::vector<InputWarning>& warnings() const { return warnings_; }

private:
    struct File {
        std::string shown;
        std::shared_ptr<const SourceText> text;  ///< copies of the errors share it
        const LogTable* table = nullptr;         ///< kept by `tables`
    };
    struct Found {
        SourceLocation place;
        ErrorText error;
    };
    [[nodiscard]] std::string line_of(const SourceLocation& place) const;

    std::shared_ptr<TableShelf> tables_;
    std::vector<File> files_;
    std::vector<Found> found_;
    void add_warning(const SourceLocation& place, std::string_view corner, std::string_view form, std::string what);

    std::vector<InputWarning> warnings_;
};

}  // namespace tiretherm::input
