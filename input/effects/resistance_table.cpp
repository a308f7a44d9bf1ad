// SPDX-License-Identifier: BSD-3-Clause
// Checks the columns of the rolling-resistance file and makes forces of powers.

#include "input/effects/resistance_table.hpp"

#include <array>

#include <fmt/format.h>

#include "input/tables/data_file.hpp"

namespace tiretherm::input {

namespace {

/// What the loss may be measured over, and as what.
std::array<GridColumn, 7> columns_of_loss() {
    return {grid_column_of("speed"),
            grid_column_of("vertical_load"),
            grid_column_of("inflation_pressure"),
            grid_column_of("air_temperature"),
            grid_column_of_bulk(),
            GridColumn{"force", {.unit = "N", .low = 0.0, .high = 1e5, .above = true}, true},
            GridColumn{"power", {.unit = "W", .low = 0.0, .high = 1e6, .above = true}, true}};
}

void check_columns(const GridRows& rows, InputErrors& errors) {
    if (rows.has("force") == rows.has("power")) {
        errors.add(rows.top,
                   rows.has("force") ? "the table gives force and power" : "the table gives neither force nor power",
                   "keep one column: force [N] or power [W]");
    }
    if (!rows.has("speed") || !rows.has("vertical_load")) {
        errors.add(rows.top, fmt::format("the table has no {}", rows.has("speed") ? "vertical_load" : "speed"),
                   "add the column, with one value where it was not varied");
    }
    if (rows.has("air_temperature") && rows.has("bulk_temperature")) {
        errors.add(rows.top, "the table gives two temperatures", "keep that which was varied");
    }
}

/// Forces, also where powers were measured; nothing after an error.
std::optional<std::vector<double>> forces(const GridRows& rows, InputErrors& errors) {
    std::vector<double> force = rows.values.back();
    for (std::size_t row = 0; row < force.size() && rows.has("power"); ++row) {
        const double speed = rows.of("speed")[row];
        if (!(speed > 0.0)) {
            const FieldLocation spot = rows.row(row);
            return errors.add(spot.place, fmt::format("a power at a standstill{}", spot.aside), "leave the row out");
        }
        force[row] /= speed;
    }
    return force;
}

}  // namespace

std::optional<GridFile> read_resistance_table(const std::filesystem::path& path, const SourceLocation& mentioned,
                                              InputErrors& errors) {
    const std::optional<DataFile> file = DataFile::open(path, mentioned, errors);
    if (!file) {
        return std::nullopt;
    }
    const std::size_t before = errors.count();
    const GridRows rows = read_grid_rows(*file, columns_of_loss(), "a table of the loss has no column", errors);
    check_columns(rows, errors);
    if (errors.count() > before || rows.values.empty()) {
        return std::nullopt;
    }
    const std::optional<std::vector<double>> force = forces(rows, errors);
    return force ? full_grid(rows, *force, errors) : std::nullopt;
}

}  // namespace tiretherm::input
