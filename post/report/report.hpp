// SPDX-License-Identifier: BSD-3-Clause
// A result as one value: its page (title, sections, tables, sentences) and its data. Text and JSON are made from it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "post/report/table.hpp"
#include "post/report/value.hpp"

namespace tiretherm::post {

/// One value of a table: as it is read, and as data.
struct Cell {
    Cell(std::string words) : text(words), value(std::move(words)) {}
    Cell(std::string_view words) : Cell(std::string(words)) {}
    Cell(const char* words) : Cell(std::string(words)) {}
    /// A number as it is printed, or a word that reads otherwise than it is as data; numbers stand to the right.
    Cell(Value number, std::string printed, bool right = true)
        : text(std::move(printed)), value(std::move(number)), to_right(right) {}

    std::string text;
    Value value;
    bool to_right = false;
};

/// A number in a format of fmt, "{:.3g}"; "-" where it is not finite.
[[nodiscard]] Cell shown(std::string_view format, double value);
/// A count in groups of three digits.
[[nodiscard]] Cell count(std::size_t n);
/// Figures that are no number by themselves, "3 to 5".
[[nodiscard]] Cell right(std::string text);

/// A cell with the heading of its column on the page and its key in the data.
struct Field {
    Field(std::string column, std::string member, Cell what)
        : heading(std::move(column)), key(std::move(member)), cell(std::move(what)) {}

    std::string heading;
    std::string key;  ///< empty: on the page only
    Cell cell;
    bool on_page = true;
};
[[nodiscard]] Field page_only(std::string heading, Cell cell);
[[nodiscard]] Field data_only(std::string key, Value value);

/// The fields with keys. @returns an object
[[nodiscard]] Value object_of(const std::vector<Field>& row);

/// Rows of fields, an object of the data each. The first row gives the columns of the page; later ones may be shorter.
class DataTable {
public:
    using Row = std::vector<Field>;

    DataTable() = default;
    /// @param columns a row that gives the columns of a table which is shown even without rows
    explicit DataTable(Row columns) : columns_(std::move(columns)) {}

    void add(Row row) { rows_.push_back(std::move(row)); }
    /// A row of the page that is no data.
    void add_to_page(Row row);

    [[nodiscard]] bool empty() const { return columns_.empty() && rows_.empty(); }
    [[nodiscard]] const Row& columns() const { return columns_; }
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    /// An object for each row that has keys.
    [[nodiscard]] Value data() const;

private:
    Row columns_;
    std::vector<Row> rows_;
};

/// The columns of a table on the page. Rows may differ in length: a column is as the first row says that has it.
struct PageColumns {
    std::vector<std::string> headings;
    std::vector<bool> to_right;
};
[[nodiscard]] PageColumns page_columns(const DataTable& table);

/// A piece of a section, in the order of the page.
struct PageItem {
    enum class Kind {
        paragraph,
        item,  ///< of a list
        line,  ///< as it is, whatever its length
        gap,
        table,
        part,   ///< with a heading of its own: `text`
        chart,  ///< of the page as HTML alone: `text` is its title
    };
    Kind kind = Kind::paragraph;
    std::string text;
    DataTable table;
    std::vector<PageItem> blocks;  ///< of a part
    std::string caption{};         ///< of a chart: how it is read
    Value chart{};                 ///< what report.js draws
};

/// A heading and what stands below it. Without a heading it is set apart by an empty line, or follows the title at once.
class ReportSection {
public:
    explicit ReportSection(std::string heading) : heading_(std::move(heading)) {}
    /// Sentences, a paragraph each.
    ReportSection(std::string heading, const std::vector<std::string>& paragraphs);
    ReportSection(std::string heading, DataTable table) : heading_(std::move(heading)) { add(std::move(table)); }

    /// Nothing, where there is nothing to say.
    void say(std::string paragraph);
    void item(std::string text) { add(PageItem::Kind::item, std::move(text)); }
    void line(std::string text) { add(PageItem::Kind::line, std::move(text)); }
    /// An empty line, where something stands above it.
    void gap();
    void add(DataTable table);
    void add(ReportSection part);
    /// A chart of the page as HTML. @param data post/page/charts.hpp makes it
    void chart(std::string title, std::string caption, Value data);
    /// Whether there is anything on the page as text.
    [[nodiscard]] bool has_text() const;

    [[nodiscard]] const std::string& heading() const { return heading_; }
    [[nodiscard]] const std::vector<PageItem>& blocks() const { return blocks_; }

private:
    void add(PageItem::Kind kind, std::string text) { blocks_.push_back({kind, std::move(text), {}, {}}); }

    std::string heading_;
    std::vector<PageItem> blocks_;
};

/// A result: one page and its data.
struct Report {
    std::string title;
    std::vector<std::string> lead = {};        ///< lines below the title
    std::vector<ReportSection> sections = {};  ///< those with nothing in them are left out
    Value data = {};
    std::vector<std::string> verdict = {};     ///< below the title: the answer with its doubt, a sentence each
    std::vector<ReportSection> appendix = {};  ///< of the page as HTML, at its end

    void add(ReportSection section) { sections.push_back(std::move(section)); }
    /// Sentences, on the page and under a key of the data.
    void add(std::string heading, std::string key, const std::vector<std::string>& sentences);
    /// The section of warnings. @param of_laws those of laws beyond their ranges
    void add_warnings(std::vector<std::string> warnings, const std::vector<std::string>& of_laws);
    /// The answer at the head of the page as HTML; of the page as text it is the first section.
    void add_verdict(std::vector<std::string> sentences);
    /// Files that were written: the last section, and "outputs" of the data.
    void add(const std::vector<std::filesystem::path>& files);
};

inline constexpr const char* verdict_heading = "Verdict";

/// "1 run", "3 runs"
[[nodiscard]] std::string plural(std::size_t n, std::string_view thing);

/// The section of this heading. @pre there is one
[[nodiscard]] const ReportSection& section(const Report& report, std::string_view heading);

/// Columns that a page may take. In a file or a pipe a row of a table stays one line, whatever its length.
struct PageWidth {
    std::size_t prose = standard_width;
    std::size_t tables = std::string::npos;
};

/// The page as text. Lines that cannot be broken, such as the name of a file, may be longer than the page is wide.
/// @param bold headings in bold, for a terminal   @returns lines, each ended by a newline
[[nodiscard]] std::string page_text(const Report& report, bool bold, const PageWidth& width = {});

/// The columns of the page as a table of Markdown.  @returns lines, each ended by a newline
[[nodiscard]] std::string markdown_text(const DataTable& table);

}  // namespace tiretherm::post
