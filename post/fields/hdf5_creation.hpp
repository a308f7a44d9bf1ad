// SPDX-License-Identifier: BSD-3-Clause
// Creation properties of HDF5, shared by the sources of Hdf5File; no other file includes this one.
#pragma once

#include <cstdint>

#include "input/hdf5/hdf5_handle.hpp"

namespace tiretherm::post {

using Scoped = input::Hdf5Handle;

/// Without times of creation, so that equal runs describe themselves equally.
[[nodiscard]] inline hid_t creation(hid_t list_class) {
    const hid_t list = H5Pcreate(list_class);
    H5Pset_obj_track_times(list, false);
    return list;
}

constexpr std::uint64_t compressed_from = 4096;  ///< bytes, of a table or of a row that is written once

}  // namespace tiretherm::post
