// SPDX-License-Identifier: BSD-3-Clause
// Whether the values that an HDF5 dataset announces are in its file, looked at before memory is taken for them.
#pragma once

#include <cstdint>
#include <string>

#include "input/hdf5/hdf5_handle.hpp"
#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// Values that are read at once, at most: 1 GB.
inline constexpr std::uint64_t most_values = std::uint64_t{1} << 27U;

/// Why the values of a dataset are not to be read, or nothing: they are in another file, were never written, are more than
/// the file can hold, or too many. A shape with a fill value of its own may have places that were never written.
/// @param file_bytes size of its file  @param leading first dimensions that are read one index at a time
[[nodiscard]] ErrorText extent_defect(hid_t dataset, const std::string& name, std::uint64_t file_bytes,
                                      std::size_t leading = 0);

}  // namespace tiretherm::input
