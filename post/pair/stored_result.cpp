// SPDX-License-Identifier: BSD-3-Clause
// Takes the data out of report.html and the courses out of channels.csv or compare.csv.

#include "post/pair/stored_result.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "post/export/page_charts.hpp"
#include "post/page/html_page.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

/// The cells of a line that Csv has written.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

double number(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end != '\0' ? std::numeric_limits<double>::quiet_NaN() : value;
}

/// The rows of a table below its headings.
struct StoredTable {
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;
};

StoredTable read_table(const std::filesystem::path& path) {
    std::istringstream lines(read_text(path));
    StoredTable table;
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells = cells_of(line);
        if (table.headings.empty()) {
            table.headings = std::move(cells);
        } else if (cells.size() == table.headings.size()) {
            table.rows.push_back(std::move(cells));
        } else {
            throw PageError(fmt::format("{}: row {} has {} cells and the head has {}", path.string(),
                                        table.rows.size() + 2, cells.size(), table.headings.size()));
        }
    }
    return table;
}

/// "surface_temperature FL [degC]" is a channel for each column.
std::vector<StoredCourse> courses_by_column(const StoredTable& table) {
    std::vector<StoredCourse> courses;
    for (std::size_t c = 1; c < table.headings.size(); ++c) {
        const std::string& heading = table.headings[c];
        const std::size_t bracket = heading.rfind(" [");
        StoredCourse course{.name = heading.substr(0, bracket), .unit = {}};
        if (bracket != std::string::npos) {
            course.unit = heading.substr(bracket + 2, heading.size() - bracket - 3);
        }
        for (const std::vector<std::string>& row : table.rows) {
            course.time.push_back(number(row[0]));
            course.value.push_back(number(row[c]));
        }
        courses.push_back(std::move(course));
    }
    return courses;
}

/// time, run, channel, unit, measured, simulated, difference
std::vector<StoredCourse> courses_by_row(const StoredTable& table) {
    std::vector<StoredCourse> courses;
    for (const std::vector<std::string>& row : table.rows) {
        const std::string name = fmt::format("{} {}", row[2], row[1]);
        auto course = std::ranges::find(courses, name, &StoredCourse::name);
        if (course == courses.end()) {
            course = courses.insert(courses.end(), StoredCourse{.name = name, .unit = row[3]});
        }
        course->time.push_back(number(row[0]));
        course->measured.push_back(number(row[4]));
        course->value.push_back(number(row[5]));
    }
    return courses;
}

}  // namespace

StoredResult read_result(const std::filesystem::path& folder) {
    const std::string text = read_text(folder / page_name);
    const std::size_t begin = text.find(page_data_begin);
    const std::size_t end = begin == std::string::npos ? begin : text.find("</script>", begin);
    if (end == std::string::npos) {
        throw PageError(fmt::format("{} holds no data of a run or a comparison", (folder / page_name).string()));
    }
    const std::size_t first = begin + std::string_view(page_data_begin).size();
    const auto stored = nlohmann::ordered_json::parse(text.begin() + static_cast<std::ptrdiff_t>(first),
                                                      text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    if (!stored.is_object() || !stored.contains("kind") || !stored.contains("data") || !stored.contains("case")) {
        throw PageError(fmt::format("{} is damaged: its data cannot be read", (folder / page_name).string()));
    }
    StoredResult result{.folder = folder,
                        .kind = stored["kind"].get<std::string>(),
                        .case_values = stored["case"],
                        .data = stored["data"]};
    if (result.kind == "compare") {
        result.courses = courses_by_row(read_table(folder / "compare.csv"));
    } else {
        result.courses = courses_by_column(read_table(folder / "channels.csv"));
    }
    return result;
}

}  // namespace tiretherm::post
