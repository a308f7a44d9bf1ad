// SPDX-License-Identifier: BSD-3-Clause
// One-dimensional part of the field transfer: linear interpolation between points on a line, and rows of points.
#pragma once

#include <cstddef>
#include <vector>

namespace tiretherm::physics {

/// Places closer than this are the same. m
inline constexpr double same_place = 1e-9;

/// Points of one coordinate, ascending, that are joined by straight lines and held half a spacing beyond their ends; a
/// single one holds everywhere.
class FieldLine {
public:
    explicit FieldLine(std::vector<double> at) : at_(std::move(at)) {}

    [[nodiscard]] std::size_t size() const { return at_.size(); }
    /// Integral over [low, high] of what each point says where the others say nothing. @returns [size] m
    /// @pre the ends are finite, or there is more than one point
    [[nodiscard]] std::vector<double> integrals(double low, double high) const;

private:
    std::vector<double> at_;
};

/// Points with one value of a coordinate, in the order of another.
struct FieldRow {
    double at = 0.0;
    std::vector<std::size_t> points;
};

/// @param by, then [n] coordinates; an empty one is 0 everywhere
[[nodiscard]] std::vector<FieldRow> rows_of(std::size_t n, const std::vector<double>& by,
                                            const std::vector<double>& then);
[[nodiscard]] std::vector<double> values_of(const std::vector<FieldRow>& rows);

/// The different places of a row's points. Points at one place share what it gets.
struct Places {
    std::vector<double> at;        ///< ascending
    std::vector<std::size_t> of;   ///< [points of the row] index into at
    std::vector<double> together;  ///< [at] how many points
};
[[nodiscard]] Places places_of(const FieldRow& row, const std::vector<double>& coordinate);

}  // namespace tiretherm::physics
