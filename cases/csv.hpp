#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/columns.hpp"
#include "cases/document.hpp"

namespace tiretherm::cases {

/// A logger's file: one line of headings `name [unit]`, then numbers, separated by commas, semicolons or tabs. A byte
/// order mark, carriage returns, quotes round a field and blank lines are accepted; decimal commas are not.
/// Keeps no text of its own: the file must outlive it.
class Csv {
public:
    /// Reads the headings; nothing after a mistake.
    [[nodiscard]] static std::optional<Csv> open(const TextFile& file, Mistakes& mistakes);

    struct Head {
        Heading heading;
        Place place;
    };
    [[nodiscard]] const std::vector<Head>& heads() const { return heads_; }
    [[nodiscard]] int find(std::string_view name) const;  ///< index of a heading, -1 when absent

    /// What to read of the file: which column, and what its values must be.
    struct Request {
        int column = 0;
        std::string name;  ///< what messages call it
        Wanted wanted;
        bool ascending = false;
    };
    /// @returns the values of each request, all of one length; none after a mistake
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<Request>& requests, Mistakes& mistakes) const;

    /// A line after the headings, without its end.
    struct Line {
        std::string_view text;
        int number = 0;
    };
    /// Splits a line at the separators; quotes and blanks round a field are taken off.
    void split(std::string_view line, std::vector<std::string_view>& fields) const;
    [[nodiscard]] Place place(const Line& line, std::string_view field) const;
    [[nodiscard]] bool has_commas() const { return separator_ == ','; }

private:
    std::string_view body_;  ///< the lines after the headings
    int first_line_ = 0;
    int file_ = -1;
    char separator_ = ',';
    std::vector<Head> heads_;
};

/// Takes the next line off a text; nothing at its end.
[[nodiscard]] std::optional<std::string_view> next_line(std::string_view& text);

}  // namespace tiretherm::cases
