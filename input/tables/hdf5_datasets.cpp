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

#include "input/files/nearby_file.hpp"
#include "input/files/regular_file.hpp"
#include "input/hdf5/hdf5_extent.hpp"
#include "input/hdf5/hdf5_handle.hpp"
#include "input/hdf5/hdf5_trial.hpp"
#include "input/text/characters.hpp"
#include "input/text/word_lists.hpp"

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
    constexpr std::size_t longest = 10000;
    if (H5Tget_size(type) > longest) {
        return std::nullopt;
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
    constexpr hssize_t most_numbers = 1000;
    const hssize_t size = H5Sget_simple_extent_npoints(space);
    if (size < 1 || size > most_numbers) {
        return {};
    }
    std::vector<double> values(static_cast<std::size_t>(size));
    if (H5Aread(opened, H5T_NATIVE_DOUBLE, values.data()) < 0) {
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

/// Whether a dataset has numbers in one dimension, or in any number of them.
bool has_numbers(hid_t dataset, bool one_dimension) {
    const Hdf5Handle type(H5Dget_type(dataset));
    const Hdf5Handle space(H5Dget_space(dataset));
    const H5T_class_t kind = H5Tget_class(type);
    return (kind == H5T_INTEGER || kind == H5T_FLOAT) && (!one_dimension || H5Sget_simple_extent_ndims(space) == 1);
}

ErrorText unreadable(const std::string& name) {
    return {fmt::format("the dataset {} cannot be read: the file is damaged or cut off", name),
            "copy the file or export it again"};
}

/// Reads the datasets of groups, of all together no more than `most_values`.
class ColumnsInHdf5 {
public:
    ColumnsInHdf5(std::uint64_t file_bytes, InputErrors& errors) : file_bytes_(file_bytes), errors_(errors) {}

    std::vector<TableColumn> of_group(hid_t group) {
        std::vector<TableColumn> found;
        for (const std::string& name : members(group, H5O_TYPE_DATASET)) {
            const Hdf5Handle dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT));
            if (dataset < 0) {
                errors_.add({.file = 0}, unreadable(name));
            } else if (has_numbers(dataset, true)) {
                TableColumn& column = found.emplace_back();
                column.head.heading.name = name;
                column.head.heading.unit = attribute(dataset, "units");
                if (column.head.heading.unit == "") {
                    column.head.heading.unit.reset();
                }
                column.head.place = {.file = 0};
                column.number = values(dataset, name);
            }
        }
        return found;
    }

private:
    /// @returns none with a defect
    std::vector<double> values(hid_t dataset, const std::string& name) {
        ErrorText defect = extent_defect(dataset, name, file_bytes_);
        const Hdf5Handle space(H5Dget_space(dataset));
        const hssize_t size = defect.what.empty() ? H5Sget_simple_extent_npoints(space) : 0;
        total_ += static_cast<std::uint64_t>(size);
        if (total_ > most_values) {
            defect = {
                fmt::format("the datasets up to {} have {} values, and at most {} are read", name, total_, most_values),
                "export fewer of them, or a part of the time"};
            total_ -= static_cast<std::uint64_t>(size);
        }
        std::vector<double> read;
        if (defect.what.empty() && size > 0) {
            read.resize(static_cast<std::size_t>(size));
            if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.data()) < 0) {
                defect = unreadable(name);
            }
        }
        if (!defect.what.empty()) {
            errors_.add({.file = 0}, std::move(defect));
            return {};
        }
        return read;
    }

    std::uint64_t file_bytes_;
    InputErrors& errors_;
    std::uint64_t total_ = 0;
};

std::uint64_t size_of(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    return error ? 0 : bytes;
}

}  // namespace

ErrorText hdf5_defect(const std::filesystem::path& path) {
    if (ErrorText reason = not_readable(path, std::numeric_limits<std::uintmax_t>::max()); !reason.what.empty()) {
        return reason;
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        const int reason = errno;
        return {fmt::format("cannot be read: {}", std::system_category().message(reason)), nearby_file_remedy(path)};
    }
    const auto is_hdf5 = [&] {
        const LibraryTurn turn;
        silence_hdf5();
        return H5Fis_hdf5(path.c_str()) > 0;
    };
    if (!is_hdf5()) {
        return {"is not an HDF5 file", "export it as HDF5; a text file ends in .csv"};
    }
    if (!survives_hdf5(path)) {
        return {"is HDF5, but damaged: the HDF5 library fails over it", "copy or export it again"};
    }
    const LibraryTurn turn;
    if (Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) < 0) {
        return {"is HDF5, but cannot be opened: it is cut off, damaged or still being written",
                "copy or export it again"};
    }
    return {};
}

std::optional<LogTable> read_hdf5_columns(const std::filesystem::path& path, InputErrors& errors) {
    const LibraryTurn turn;
    const SourceLocation place{.file = 0};
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const bool ours = attribute(file, "format").value_or("").starts_with("tiretherm results");
    ColumnsInHdf5 columns(size_of(path), errors);
    std::vector<TableColumn> found = ours ? std::vector<TableColumn>{} : columns.of_group(file);
    std::vector<std::string> groups;  // that have any; none when the root has
    for (const std::string& name : found.empty() ? members(file, H5O_TYPE_GROUP) : std::vector<std::string>{}) {
        const Hdf5Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT));
        std::vector<TableColumn> in_group =
            ours && name != "channels" ? std::vector<TableColumn>{} : columns.of_group(group);
        if (!in_group.empty()) {
            groups.push_back(name);
            found = std::move(in_group);
        }
    }
    if (errors.count() > 0) {
        return std::nullopt;
    }
    if (groups.size() > 1) {
        errors.add(place, fmt::format("several groups of the file hold datasets: {}", listed(groups)),
                   "keep the run's datasets in the root or in one group");
        return std::nullopt;
    }
    if (found.empty()) {
        errors.add(place, "the file holds no datasets of numbers in one dimension",
                   "write one for the time and one for each signal, in the root or in one group");
        return std::nullopt;
    }
    // The time says how long the others must be; without one, the first does.
    const auto clock =
        std::ranges::find_if(found, [](const TableColumn& column) { return column.head.heading.name == "time"; });
    const TableColumn& first = clock == found.end() ? found.front() : *clock;
    for (const TableColumn& column : found) {
        if (column.number.size() != first.number.size()) {
            errors.add(place,
                       fmt::format("the dataset {} has {} values, {} has {}", column.head.heading.name,
                                   column.number.size(), first.head.heading.name, first.number.size()),
                       "let all datasets of the run have one length");
        }
    }
    if (errors.count() > 0) {
        return std::nullopt;
    }
    LogTable table{.description = {.format = "HDF5"}, .units = LogTable::Units::in_attributes};
    if (first.number.empty()) {
        table.defects.add(place, "the datasets are empty");
    }
    table.columns = std::move(found);
    table.where = [](std::size_t row, int /*column*/) {
        return FieldLocation{{.file = 0}, fmt::format(" (value {})", row + 1)};
    };
    return table;
}

std::optional<Hdf5Stack> Hdf5Stack::open(const std::filesystem::path& path, const std::string& name,
                                         ErrorText& defect) {
    const LibraryTurn turn;
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const std::vector<std::string> known = members(file, H5O_TYPE_DATASET);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        return std::nullopt;
    }
    Hdf5Stack stack;
    stack.dataset_ = std::make_shared<Hdf5Handle>(H5Dopen2(file, name.c_str(), H5P_DEFAULT));
    const hid_t dataset = *static_cast<const Hdf5Handle*>(stack.dataset_.get());
    if (dataset < 0) {
        defect = unreadable(name);
        return std::nullopt;
    }
    if (!has_numbers(dataset, false)) {
        return std::nullopt;
    }
    defect = extent_defect(dataset, name, size_of(path), 1);
    if (!defect.what.empty()) {
        return std::nullopt;
    }
    const Hdf5Handle space(H5Dget_space(dataset));
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
    const LibraryTurn turn;
    return input::attribute(*static_cast<const Hdf5Handle*>(dataset_.get()), attribute.c_str()).value_or("");
}

std::vector<double> Hdf5Stack::numbers(const std::string& attribute) const {
    const LibraryTurn turn;
    return numeric_attribute(*static_cast<const Hdf5Handle*>(dataset_.get()), attribute.c_str());
}

bool Hdf5Stack::read(std::size_t index, std::vector<double>& values) const {
    const LibraryTurn turn;
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
