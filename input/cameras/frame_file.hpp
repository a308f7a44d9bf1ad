// SPDX-License-Identifier: BSD-3-Clause
// Files of infrared camera frames, HDF5 or CSV: the layout is described here; images are read one at a time.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// The frames of a camera as a file holds them; the images themselves are read one at a time.
struct FrameFile {
    int number = -1;  ///< of the file in the errors
    std::string shown;
    int rows = 0;
    int columns = 0;
    std::vector<double> time;                           ///< [n_frames] s, ascending
    std::optional<std::array<double, 2>> pixel_size{};  ///< m, from column to column and from row to row
    /// @param kelvin out, [rows * columns], row by row; NaN: dead  @returns false where the file is damaged
    std::function<bool(std::size_t frame, std::vector<double>& kelvin)> read;
};

/// Opens a file of frames: HDF5 where its name ends in .h5 or .hdf5, otherwise CSV.
///
/// HDF5: `frames` [n, rows, columns], or [n, rows * columns] with attributes `rows` and `columns`, of any number type, with its unit in the attribute `units` and, if it is packed,
/// `scale_factor`, `add_offset` and `_FillValue`; the size of a pixel on the specimen in its attribute `pixel_size`, one
/// number or two (along a row, along a column), with `pixel_size_units`; `time` [n] with `units`.
///
/// CSV: a column `time [s]` and one for each pixel, `r0c0 [degC]`, `r0c1 [degC]` ..., a row for each frame.
/// @param mentioned where the case names it  @returns nothing after an error
[[nodiscard]] std::optional<FrameFile> open_frames(const std::filesystem::path& path, const SourceLocation& mentioned,
                                                   InputErrors& errors);

/// The two kinds. @pre of HDF5: the file could be opened
[[nodiscard]] std::optional<FrameFile> open_hdf5_frames(const std::filesystem::path& path, int number,
                                                        InputErrors& errors);
[[nodiscard]] std::optional<FrameFile> open_csv_frames(const std::filesystem::path& path,
                                                       const SourceLocation& mentioned, InputErrors& errors);

/// Whether the moments of frames do not ascend, which is an error.
[[nodiscard]] bool report_times_not_ascending(const std::vector<double>& time, int number, InputErrors& errors);

}  // namespace tiretherm::input
