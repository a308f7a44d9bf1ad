// SPDX-License-Identifier: BSD-3-Clause
// Whether the HDF5 library survives a file: tried in a process of its own.
#pragma once

#include <filesystem>

namespace tiretherm::input {

/// Opens every object and attribute of a file, and reads datasets of up to 64 MB in all, in a process of its own: the
/// library (1.10) reads beside its buffers where a file is damaged. An error that it reports is none here.
/// Each file once: a file that is as old and as long as it was has been tried. @returns false where the library was ended by a signal or did not come to an end
[[nodiscard]] bool survives_hdf5(const std::filesystem::path& path);

}  // namespace tiretherm::input
