// SPDX-License-Identifier: BSD-3-Clause
// The calls of the HDF5 C library for reading: handles, text and number attributes, datasets and slices of them.

#include "input/tables/hdf5_datasets.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "input/tables/hdf5_handle.hpp"
#include "input/text/regular_file.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

/// A text attribute, of fixed or of variable length; nothing where there is none.
std::optional<std::string> attribute(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) {
        return std::nullopt;
    }
    const Hdf5Handle opened(H5Aopen(object, name, H5P_DEFAULT));
    const Hdf5Handle type(H5Aget_type(opened));
    const Hdf5Handle space(H5Aget_space(opened));
    if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) {
        return std::nullopt;
    }
    if (H5Tis_variable_str(type) > 0) {
        char* text = nullptr;
        if (H5Aread(opened, type, static_cast<void*>(&text)) < 0 || text == nullptr) {
            return std::nullopt;
        }
        std::string result(text);
        H5free_memory(text);
        return result;
    }
    std::string text(H5Tget_size(type), '\0');
    if (H5Aread(opened, type, text.data()) < 0) {
        return std::nullopt;
    }
    text.resize(std::min(text.find('\0'), text.size()));
    return std::string(trim(text));
}

/// A numeric attribute; empty where there is none.
std::vector<double> numeric_attribute(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) {
        return {};
    }
    const Hdf5Handle opened(H5Aopen(object, name, H5P_DEFAULT));
    const Hdf5Handle type(H5Aget_type(opened));
    const Hdf5Handle space(H5Aget_space(opened));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
        return {};
    }
    std::vector<double> values(static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space))));
    if (values.empty() || H5Aread(opened, H5T_NATIVE_DOUBLE, values.data()) < 0) {
        return {};
    }
    return values;
}

std::vector<std::string> members(hid_t group, H5O_type_t kind) {
    struct Found {
        H5O_type_t kind;
        std::vector<std::string> names;
    } found{kind, {}};
    const auto take = [](hid_t in, const char* name, const H5L_info_t*, void* into) -> herr_t {
        auto* all = static_cast<Found*>(into);
        const Hdf5Handle object(H5Oopen(in, name, H5P_DEFAULT));
        H5O_info_t about{};
        if (object >= 0 && H5Oget_info2(object, &about, H5O_INFO_BASIC) >= 0 && about.type == all->kind) {
            all->names.emplace_back(name);
        }
        return 0;
    };
    H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &found);
    return found.names;
}

/// The numbers of a dataset of one dimension; nothing for any other.
std::optional<std::vector<double>> numbers(hid_t dataset) {
    const Hdf5Handle type(H5Dget_type(dataset));
    const Hdf5Handle space(H5Dget_space(dataset));
    const H5T_class_t kind = H5Tget_class(type);
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Sget_simple_extent_ndims(space) != 1) {
        return std::nullopt;
    }
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    if (!values.empty() && H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
        return std::nullopt;
    }
    return values;
}

std::vector<Dataset> datasets(hid_t group) {
    std::vector<Dataset> found;
    for (const std::string& name : members(group, H5O_TYPE_DATASET)) {
        const Hdf5Handle dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT));
        if (auto values = dataset >= 0 ? numbers(dataset) : std::nullopt) {
            std::optional<std::string> unit = attribute(dataset, "units");
            found.push_back({.heading = {name, unit.value_or("").empty() ? std::nullopt : std::move(unit)},
                             .values = std::move(*values)});
        }
    }
    return found;
}

}  // namespace

ErrorText hdf5_defect(const std::filesystem::path& path) {
    silence_hdf5();
    if (ErrorText reason = not_readable(path, std::numeric_limits<std::uintmax_t>::max()); !reason.what.empty()) {
        return reason;
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        return {fmt::format("cannot be read: {}", std::system_category().message(errno)), ""};
    }
    if (H5Fis_hdf5(path.c_str()) <= 0) {
        return {"is not an HDF5 file", "export it as HDF5; a text file ends in .csv"};
    }
    if (Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) < 0) {
        return {"is HDF5, but cannot be opened: it is cut off, damaged or still being written",
                "copy or export it again"};
    }
    return {};
}

Datasets read_datasets(const std::filesystem::path& path) {
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const bool ours = attribute(file, "format").value_or("").starts_with("tiretherm results");
    Datasets all{.found = ours ? std::vector<Dataset>{} : datasets(file), .groups = {}};
    for (const std::string& name : all.found.empty() ? members(file, H5O_TYPE_GROUP) : std::vector<std::string>{}) {
        const Hdf5Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT));
        std::vector<Dataset> in_group = ours && name != "channels" ? std::vector<Dataset>{} : datasets(group);
        if (!in_group.empty()) {
            all.groups.push_back(name);
            all.found = std::move(in_group);
        }
    }
    return all;
}

std::optional<Hdf5Stack> Hdf5Stack::open(const std::filesystem::path& path, const std::string& name) {
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const std::vector<std::string> known = members(file, H5O_TYPE_DATASET);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        return std::nullopt;
    }
    Hdf5Stack stack;
    stack.dataset_ = std::make_shared<Hdf5Handle>(H5Dopen2(file, name.c_str(), H5P_DEFAULT));
    const hid_t dataset = *static_cast<const Hdf5Handle*>(stack.dataset_.get());
    const Hdf5Handle type(H5Dget_type(dataset));
    const Hdf5Handle space(H5Dget_space(dataset));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
        return std::nullopt;
    }
    std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
    if (!shape.empty()) {
        H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    }
    stack.shape_.assign(shape.begin(), shape.end());
    const auto first = [&](const char* attribute) {
        const std::vector<double> values = numeric_attribute(dataset, attribute);
        return values.empty() ? std::nullopt : std::optional(values.front());
    };
    stack.factor_ = first("scale_factor").value_or(1.0);
    stack.offset_ = first("add_offset").value_or(0.0);
    stack.fill_ = first("_FillValue");
    return stack;
}

std::string Hdf5Stack::text(const std::string& attribute) const {
    return input::attribute(*static_cast<const Hdf5Handle*>(dataset_.get()), attribute.c_str()).value_or("");
}

std::vector<double> Hdf5Stack::numbers(const std::string& attribute) const {
    return numeric_attribute(*static_cast<const Hdf5Handle*>(dataset_.get()), attribute.c_str());
}

bool Hdf5Stack::read(std::size_t index, std::vector<double>& values) const {
    const hid_t dataset = *static_cast<const Hdf5Handle*>(dataset_.get());
    const Hdf5Handle space(H5Dget_space(dataset));
    std::vector<hsize_t> start(shape_.size(), 0);
    std::vector<hsize_t> count(shape_.begin(), shape_.end());
    start.front() = index;
    count.front() = 1;
    std::size_t size = 1;
    for (const hsize_t extent : count) {
        size *= extent;
    }
    values.resize(size);
    const auto length = static_cast<hsize_t>(size);
    const Hdf5Handle memory(H5Screate_simple(1, &length, nullptr));
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) < 0) {
        return false;
    }
    for (double& value : values) {
        value = fill_ && value == *fill_ ? std::numeric_limits<double>::quiet_NaN() : factor_ * value + offset_;
    }
    return true;
}

}  // namespace tiretherm::input
