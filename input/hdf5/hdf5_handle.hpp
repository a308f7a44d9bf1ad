// SPDX-License-Identifier: BSD-3-Clause
// A scoped handle of the HDF5 C library, for the sources that read and write HDF5; no other file includes this one.
#pragma once

#include <hdf5.h>

#include "input/hdf5/own_process.hpp"

namespace tiretherm::input {

/// Closes a handle of HDF5 at the end of a scope; the kind is known to the library. Every function that begins to work with
/// the library takes its turn first.
class Hdf5Handle {
public:
    explicit Hdf5Handle(hid_t handle) : handle_(handle) {}
    ~Hdf5Handle() {
        if (handle_ >= 0) {
            const LibraryTurn turn;
            H5Idec_ref(handle_);
        }
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    operator hid_t() const { return handle_; }

private:
    hid_t handle_;
};

/// What HDF5 has to say goes into errors and exceptions, not to stderr. And it does nothing at the program's end, where it
/// would crash over a file that a full disk kept from being closed; that can be said before its first use alone.
inline void silence_hdf5() {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace tiretherm::input
