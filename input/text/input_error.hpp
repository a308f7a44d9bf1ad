// SPDX-License-Identifier: BSD-3-Clause
// Errors and warnings in user input, with file, line, column and remedy, collected so that all are shown at once.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

struct LogTable;
struct TableShelf;

/// An error in what the user wrote, and where. Lines and columns count from 1; a column is a character, not a byte.
struct InputError {
    std::string file;  ///< as the user would type it
    int line = 0;      ///< 0: the file as a whole
    int column = 0;
    int length = 0;  ///< characters to underline
    std::string what;
    std::string remedy;  ///< what to do; empty where `what` says it already
    std::string source;  ///< the line of the file
};

/// The error as a compiler shows it: `file:line:column: what`, the line, a caret under the place, the remedy.
/// @returns lines, each ended by a newline
[[nodiscard]] std::string render(const InputError& error);

/// The text of an error: what is wrong, and what to do.
struct ErrorText {
    std::string what;
    std::string remedy;
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
    /// The same of a file with a table, which it has once. @param text of the file; null: none
    int add_table(const std::string& shown, const LogTable& table, const std::shared_ptr<const std::string>& text);
    /// The number of a file that has been read with its text, -1 when it has not: it need not be read a second time.
    [[nodiscard]] int find_file(std::string_view shown) const;
    [[nodiscard]] std::shared_ptr<const std::string> text(int number) const {
        return files_[static_cast<std::size_t>(number)].text;
    }
    /// The tables that have been read, for these errors, their copies and all that share them.
    [[nodiscard]] TableShelf& tables() const { return *tables_; }
    /// Uses the tables that others have read.
    void share_tables(const InputErrors& others) { tables_ = others.tables_; }
    /// Takes over what is wrong with a file that was read by itself, as the first of `found`. @param number of it here
    void take(const InputErrors& found, int number);
    void add(const SourceLocation& place, std::string what, std::string remedy = {});
    void add(const SourceLocation& place, ErrorText error) {
        add(place, std::move(error.what), std::move(error.remedy));
    }
    /// Something unusual that a run can still be made of.
    void warn(const SourceLocation& place, const std::string& what);

    [[nodiscard]] std::size_t count() const { return found_.size(); }
    [[nodiscard]] const std::string& file(int number) const { return files_[static_cast<std::size_t>(number)].shown; }
    /// All files that were read, in that order, each once.
    [[nodiscard]] std::vector<std::string> files() const;
    /// "case.toml:12", for a sentence about another place.
    [[nodiscard]] std::string spell(const SourceLocation& place) const;
    /// All errors in the order of the files and of their places in them, none twice.
    [[nodiscard]] std::vector<InputError> in_order() const;
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    struct File {
        std::string shown;
        std::shared_ptr<const std::string> text;  ///< copies of the errors share it
        const LogTable* table = nullptr;          ///< kept by `tables`
    };
    struct Found {
        SourceLocation place;
        ErrorText error;
    };
    [[nodiscard]] std::string line_of(const SourceLocation& place) const;

    std::shared_ptr<TableShelf> tables_;
    std::vector<File> files_;
    std::vector<Found> found_;
    std::vector<std::string> warnings_;
};

}  // namespace tiretherm::input
