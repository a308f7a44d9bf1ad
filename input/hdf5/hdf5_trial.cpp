// SPDX-License-Identifier: BSD-3-Clause
// Visits the objects of an HDF5 file; what it reads is dropped.

#include "input/hdf5/hdf5_trial.hpp"

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

#include "input/hdf5/hdf5_handle.hpp"
#include "input/hdf5/own_process.hpp"

namespace tiretherm::input {

namespace {

constexpr std::uint64_t most_bytes = 64U << 20U;  ///< of values: enough for every run, and for some frames of a camera

/// The bytes that values of a type in a space take in memory; 0 for more than are read, or for an error.
std::uint64_t bytes_of(hid_t type, hid_t space, std::uint64_t left) {
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    const std::size_t size = H5Tget_size(type);
    const bool fits = count > 0 && size > 0 && static_cast<std::uint64_t>(count) <= left / size;
    return fits ? static_cast<std::uint64_t>(count) * size : 0;
}

bool is_plain(hid_t type) {
    const H5T_class_t kind = H5Tget_class(type);
    return kind == H5T_INTEGER || kind == H5T_FLOAT || (kind == H5T_STRING && H5Tis_variable_str(type) == 0);
}

herr_t try_attribute(hid_t object, const char* name, const H5A_info_t* /*about*/, void* left) {
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
    const Hdf5Handle type(H5Aget_type(attribute));
    const Hdf5Handle space(H5Aget_space(attribute));
    if (const std::uint64_t bytes = bytes_of(type, space, *static_cast<std::uint64_t*>(left));
        bytes > 0 && is_plain(type)) {
        std::vector<char> values(bytes);
        H5Aread(attribute, type, values.data());
    } else if (bytes == sizeof(char*) && H5Tis_variable_str(type) > 0) {
        char* text = nullptr;
        H5Aread(attribute, type, static_cast<void*>(&text));
        H5free_memory(text);
    }
    return 0;
}

herr_t try_object(hid_t file, const char* name, const H5O_info_t* about, void* data) {
    auto& left = *static_cast<std::uint64_t*>(data);
    const Hdf5Handle object(H5Oopen(file, name, H5P_DEFAULT));
    hsize_t first = 0;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &first, try_attribute, &left);
    if (about->type == H5O_TYPE_DATASET) {
        const Hdf5Handle type(H5Dget_type(object));
        const Hdf5Handle space(H5Dget_space(object));
        if (const std::uint64_t bytes = bytes_of(type, space, left); bytes > 0 && is_plain(type)) {
            left -= bytes;
            std::vector<char> values(bytes);
            H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        }
    }
    return 0;
}

constexpr unsigned most_seconds = 10;  ///< of CPU: 64 MB of values take one

/// A file as it was when it was tried.
using FileState = std::tuple<std::string, std::uintmax_t, std::filesystem::file_time_type>;

FileState state_of(const std::filesystem::path& path) {
    std::error_code error;
    return {std::filesystem::absolute(path, error).string(), std::filesystem::file_size(path, error),
            std::filesystem::last_write_time(path, error)};
}

bool survives_now(const std::filesystem::path& path) {
    const auto visit = [&] {
        const LibraryTurn turn;  // the parent's, where no child can be made
        silence_hdf5();
        const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
        std::uint64_t left = most_bytes;
        H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, try_object, &left, H5O_INFO_BASIC);
        return std::string();
    };
    return in_own_process(visit, most_seconds).has_value();
}

}  // namespace

bool survives_hdf5(const std::filesystem::path& path) {
    static std::mutex talk;
    static std::map<FileState, bool> tried;
    const FileState state = state_of(path);
    const std::lock_guard lock(talk);
    const auto known = tried.find(state);
    return known != tried.end() ? known->second : tried.emplace(state, survives_now(path)).first->second;
}

}  // namespace tiretherm::input
