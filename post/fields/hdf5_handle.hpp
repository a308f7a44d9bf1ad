// SPDX-License-Identifier: BSD-3-Clause
// Scoped handles and creation properties of HDF5, shared by the sources of Hdf5File only.
#pragma once

#include <cstdint>

#include <hdf5.h>

/// What the two sources of Hdf5File share; no other file includes this one.
namespace tiretherm::post {

/// Closes a handle of HDF5 at the end of a scope; the kind is known to the library.
class Scoped {
public:
    explicit Scoped(hid_t handle) : handle_(handle) {}
    ~Scoped() {
        if (handle_ >= 0) {
            H5Idec_ref(handle_);
        }
    }
    Scoped(const Scoped&) = delete;
    Scoped& operator=(const Scoped&) = delete;
    operator hid_t() const { return handle_; }

private:
    hid_t handle_;
};

/// Without times of creation, so that equal runs describe themselves equally.
inline hid_t creation(hid_t list_class) {
    const hid_t list = H5Pcreate(list_class);
    H5Pset_obj_track_times(list, false);
    return list;
}

constexpr std::uint64_t compressed_from = 4096;  ///< bytes, of a table or of a row that is written once

}  // namespace tiretherm::post
