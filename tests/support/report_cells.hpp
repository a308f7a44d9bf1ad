// SPDX-License-Identifier: BSD-3-Clause
// What a section of a report says in the rows of its first table.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "post/report/report.hpp"

namespace tiretherm::post {

inline const DataTable& table_of(const ReportSection& section) {
    const auto found = std::ranges::find(section.blocks(), PageItem::Kind::table, &PageItem::kind);
    if (found == section.blocks().end()) {
        throw std::out_of_range("no table in " + section.heading());
    }
    return found->table;
}

inline std::size_t row_count(const ReportSection& section) { return table_of(section).rows().size(); }

/// A row as the page shows it.
inline std::vector<std::string> row_texts(const ReportSection& section, std::size_t row) {
    std::vector<std::string> texts;
    for (const Field& field : table_of(section).rows().at(row)) {
        if (field.on_page) {
            texts.push_back(field.cell.text);
        }
    }
    return texts;
}

inline std::string cell_text(const ReportSection& section, std::size_t row, std::string_view heading) {
    for (const Field& field : table_of(section).rows().at(row)) {
        if (field.on_page && field.heading == heading) {
            return field.cell.text;
        }
    }
    throw std::out_of_range("no column " + std::string(heading) + " in " + section.heading());
}

}  // namespace tiretherm::post
