// SPDX-License-Identifier: BSD-3-Clause
// Datasets of Hdf5File that grow by rows: chunked, compressed where a row is large, and appended in place.

#include <array>

#include "post/fields/hdf5_creation.hpp"
#include "post/fields/hdf5_file.hpp"

namespace tiretherm::post {

namespace {

constexpr std::uint64_t chunk_bytes = 16384;  // of rows that are not compressed

}  // namespace

Hdf5File::Rows Hdf5File::add_rows(const std::string& path, std::size_t width, const Label& label) {
    const input::LibraryTurn turn;
    const bool flat = width == 0;
    const std::uint64_t values = flat ? 1 : width;
    const std::uint64_t bytes = values * sizeof(double);
    const bool compressed = bytes >= compressed_from;
    const std::array<hsize_t, 2> size{0, values};
    const std::array<hsize_t, 2> limit{H5S_UNLIMITED, values};
    const std::array<hsize_t, 2> chunk{compressed || bytes > chunk_bytes ? 1 : chunk_bytes / bytes, values};
    const Scoped space(H5Screate_simple(flat ? 1 : 2, size.data(), limit.data()));
    const Scoped list(creation(H5P_DATASET_CREATE));
    H5Pset_chunk(list, flat ? 1 : 2, chunk.data());
    if (compressed) {
        H5Pset_shuffle(list);
        H5Pset_deflate(list, 4);
    }
    const std::string doing = "write " + path + " to";
    const Handle dataset =
        check(H5Dcreate2(file_, path.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, list, H5P_DEFAULT), doing);
    growing_.push_back({.dataset = dataset, .width = values, .rows = 0, .flat = flat});
    attach(dataset, label);
    return static_cast<Rows>(growing_.size() - 1);
}

void Hdf5File::append(Rows rows, std::span<const double> values) {
    const input::LibraryTurn turn;
    if (values.empty()) {
        return;
    }
    Growing& to = growing_[static_cast<std::size_t>(rows)];
    const int rank = to.flat ? 1 : 2;
    const std::array<hsize_t, 2> start{to.rows, 0};
    const std::array<hsize_t, 2> count{values.size() / to.width, to.width};
    const std::array<hsize_t, 2> size{to.rows + count[0], to.width};
    check(H5Dset_extent(to.dataset, size.data()), "extend");
    const Scoped in_memory(H5Screate_simple(rank, count.data(), nullptr));
    const Scoped in_file(H5Dget_space(to.dataset));
    check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), "extend");
    check(H5Dwrite(to.dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, values.data()), "write to");
    to.rows = size[0];
}

}  // namespace tiretherm::post
