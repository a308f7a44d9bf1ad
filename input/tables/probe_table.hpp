// SPDX-License-Identifier: BSD-3-Clause
// Reader of tables as laboratories write them: a line for each probe, a column for each moment or step of the test.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "input/tables/column_reader.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

/// A table whose lines are probes and whose columns are moments:
///     probe [degC],20 min,30 min,40 min
///     belt_edge,111.6,115.8,115.4
///     crown,66.2,69.3,
/// A moment is a time (`20 min`, `t = 20 min`; a bare number where the first heading has the unit, `probe / time [min]`), the
/// speed of a step of the test (`170 km/h`) or its number (`step 2`). The unit of the values stands in the first heading, in that of
/// a column, behind the name of a probe or in a column `unit`. Other columns, such as a depth, are not read, nor are lines
/// about the test above the headings. An empty field or a dash is no reading.
class ProbeTable {
public:
    enum class Axis : std::uint8_t {
        time,   ///< s
        speed,  ///< m/s, of the steps; a reading was taken at the end of its step
        step    ///< numbers of the steps, the first is 1; likewise
    };

    /// Nothing where a text is laid out in another way.
    [[nodiscard]] static std::optional<ProbeTable> find(const TextFile& file);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const { return heads_; }
    [[nodiscard]] std::vector<ColumnHead>& heads() { return heads_; }
    [[nodiscard]] Axis axis() const { return axis_; }
    [[nodiscard]] const std::vector<double>& moments() const { return moments_; }  ///< on the axis, SI
    /// Where the heading of a moment stands.
    [[nodiscard]] SourceLocation row(std::size_t index) const { return places_[index]; }
    /// Replaces speeds or numbers of steps by times. @param times s, one for each moment
    void take_times(std::vector<double> times);
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests,
                                                        InputErrors& errors) const;

private:
    /// A line of the file, split.
    struct Line {
        std::string_view text;
        int number = 0;
        std::vector<std::string_view> fields{};
    };
    bool read_headings(const Line& line);
    bool read_probe(const Line& line);
    [[nodiscard]] SourceLocation place(const Line& line, std::string_view field) const;

    int file_ = -1;
    char separator_ = ',';
    Axis axis_ = Axis::time;
    std::string unit_;                  ///< of the values, by the first heading or by those of the columns
    std::size_t unit_column_ = 0;       ///< that has the unit of each line; 0: none
    std::vector<std::size_t> columns_;  ///< of the file, one for each moment
    std::vector<double> moments_;
    std::vector<SourceLocation> places_;                     ///< of their headings
    std::vector<ColumnHead> heads_;                          ///< of the moments, then of the probes
    std::vector<std::vector<double>> values_;                ///< [n_probes][n_moments] as written; NaN: no reading
    std::vector<std::vector<SourceLocation>> value_places_;  ///< likewise
};

}  // namespace tiretherm::input
