// SPDX-License-Identifier: BSD-3-Clause
// Compares the shape of a dataset with what is stored of it.

#include "input/hdf5/hdf5_extent.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr const char* again = "copy the file or export it again";

/// A product that stays at the largest number where it would pass it.
std::uint64_t product(const std::vector<hsize_t>& factors, std::size_t from = 0) {
    std::uint64_t all = 1;
    for (std::size_t i = from; i < factors.size(); ++i) {
        const bool fits = factors[i] == 0 || all <= std::numeric_limits<std::uint64_t>::max() / factors[i];
        all = fits ? all * factors[i] : std::numeric_limits<std::uint64_t>::max();
    }
    return all;
}

std::string spell(const std::vector<hsize_t>& shape) { return fmt::format("{}", fmt::join(shape, " x ")); }

bool has_fill_value(hid_t properties) {
    H5D_fill_value_t status = H5D_FILL_VALUE_UNDEFINED;
    return H5Pfill_value_defined(properties, &status) >= 0 && status == H5D_FILL_VALUE_USER_DEFINED;
}

/// The shape of the blocks in which a dataset is stored; empty where it is not, and for a damaged one.
std::vector<hsize_t> block_of(hid_t properties, std::size_t rank) {
    std::vector<hsize_t> block(rank);
    const bool known = H5Pget_layout(properties) == H5D_CHUNKED &&
                       H5Pget_chunk(properties, static_cast<int>(rank), block.data()) == static_cast<int>(rank);
    return known && product(block) > 0 ? block : std::vector<hsize_t>{};
}

/// Whether the stored blocks are fewer than the shape needs, or of another size than their values make it.
/// @param value size of one in bytes  @param may_lack blocks that were never written stand for a fill value
bool blocks_differ(hid_t dataset, hid_t space, hid_t properties, const std::vector<hsize_t>& block,
                   const std::vector<hsize_t>& shape, std::uint64_t value, bool may_lack) {
    std::vector<hsize_t> needed(shape.size());
    for (std::size_t i = 0; i < shape.size(); ++i) {
        needed[i] = (shape[i] - 1) / block[i] + 1;
    }
    hsize_t stored = 0;
    if (H5Dget_num_chunks(dataset, space, &stored) < 0) {
        return true;
    }
    const bool packed = H5Pget_nfilters(properties) != 0;  // then their size says nothing
    const bool of_size = packed || H5Dget_storage_size(dataset) == product({stored, product(block), value});
    return !of_size || (stored < product(needed) && !may_lack);
}

}  // namespace

ErrorText extent_defect(hid_t dataset, const std::string& name, std::uint64_t file_bytes, std::size_t leading) {
    const Hdf5Handle space(H5Dget_space(dataset));
    const Hdf5Handle properties(H5Dget_create_plist(dataset));
    const Hdf5Handle type(H5Dget_type(dataset));
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0) {
        return {fmt::format("the dataset {} has no shape: the file is damaged", name), again};
    }
    std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
    if (rank > 0) {
        H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    }
    const H5D_layout_t layout = H5Pget_layout(properties);
    if (layout == H5D_VIRTUAL || (layout == H5D_CONTIGUOUS && H5Pget_external_count(properties) > 0)) {
        return {fmt::format("the dataset {} keeps its values in other files ({})", name,
                            layout == H5D_VIRTUAL ? "a virtual dataset" : "external storage"),
                "export it with its values inside the file"};
    }
    const std::uint64_t values = product(shape);
    if (values == 0) {
        return {};
    }
    const std::vector<hsize_t> block = block_of(properties, shape.size());
    if (std::max(product(shape, leading), product(block)) > most_values) {
        return {
            fmt::format("the dataset {} has a shape of {} values{}, and at most {} are read at once: it is too large, "
                        "or the file is damaged",
                        name, spell(shape), block.empty() ? "" : fmt::format(" in blocks of {}", spell(block)),
                        most_values),
            "export a part of it, or copy the file again"};
    }
    const bool may_lack = has_fill_value(properties);
    const std::uint64_t stored = H5Dget_storage_size(dataset);
    if (stored == 0 && !may_lack) {
        return {fmt::format("the dataset {} has a shape of {} values, and none was ever written", name, spell(shape)),
                again};
    }
    const std::uint64_t value = H5Tget_size(type);
    const bool differs = layout == H5D_CHUNKED
                             ? block.empty() || blocks_differ(dataset, space, properties, block, shape, value, may_lack)
                             : stored != 0 && product({values, value}) > stored;
    // The library takes the size of a value from the type and that of a block from elsewhere, and reads beyond it.
    if (stored > file_bytes || differs || value > sizeof(long double)) {
        return {fmt::format("the dataset {} has a shape of {} values, and the file does not hold them all: it is "
                            "damaged, cut off or not yet written to its end",
                            name, spell(shape)),
                again};
    }
    return {};
}

}  // namespace tiretherm::input
