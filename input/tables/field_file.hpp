// SPDX-License-Identifier: BSD-3-Clause
// Fields of a structural (finite element) code: pressure, friction power or loss density at points, in frames over time
// or wheel angle.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "input/tables/data_file.hpp"
#include "physics/field_transfer/field.hpp"
#include "physics/field_transfer/field_transfer.hpp"

namespace tiretherm::input {

/// The points of one time or wheel angle, and what they say.
struct FieldFrame {
    double at = 0.0;  ///< s or rad; 0 where the file knows neither
    std::size_t first_row = 0;
    physics::FieldPoints points;
    std::vector<double> density;  ///< [points] Pa, W/m2 or W/m3; of a shape also what is proportional to it
};

/// A field as a structural code writes it, in columns of one length: a row for each point of each frame, the rows of a
/// frame together. cases/contact_fields/README.md is the page for those who write such files.
struct FieldFile {
    enum class Against : std::uint8_t { nothing, time, wheel_angle };

    std::shared_ptr<const DataFile> file;
    Against against = Against::nothing;
    std::vector<FieldFrame> frames;

    /// How much each frame counts in the mean over a revolution. @pre against the wheel angle  @returns [frames], sum 1
    [[nodiscard]] std::vector<double> shares_of_revolution() const;
};

/// @param mentioned where the case names it  @param watts whether the values are to be powers, not only a shape
/// @param along_meridian whether places along the meridian count on the mesh  @returns nothing after an error
[[nodiscard]] std::optional<FieldFile> read_field_file(const std::filesystem::path& path,
                                                       const SourceLocation& mentioned, physics::FieldOf of, bool watts,
                                                       bool along_meridian, InputErrors& errors);

}  // namespace tiretherm::input
