// SPDX-License-Identifier: BSD-3-Clause
// Opens, labels and writes datasets through the C library of HDF5, and turns its error stack into a FileError.

#include "post/fields/hdf5_file.hpp"

#include <array>
#include <type_traits>
#include <utility>

#include "post/fields/hdf5_creation.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {

static_assert(std::is_same_v<hid_t, std::int64_t>);

namespace {

/// The deepest entry of HDF5's error stack says what the system said.
herr_t keep_deepest(unsigned depth, const H5E_error2_t* entry, void* text) {
    if (depth == 0) {
        *static_cast<std::string*>(text) = entry->desc;
    }
    return 0;
}

std::string last_reason() {
    std::string text = "HDF5 gives no reason";
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, &keep_deepest, &text);
    const std::string mark = "error message = '";
    if (const auto start = text.find(mark); start != std::string::npos) {
        const auto from = start + mark.size();
        return text.substr(from, text.find('\'', from) - from);
    }
    return text;
}

hid_t string_type() {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

/// Texts pass through a buffer of pointers. HDF5's own has 1 MB and is cleared for each call, which took as long as all the rest of
/// a small run.
constexpr std::size_t buffer_of_texts = 4096;

}  // namespace

Hdf5File::Hdf5File(const std::filesystem::path& path) : path_(path) {
    const input::LibraryTurn turn;
    input::silence_hdf5();
    const Scoped access(H5Pcreate(H5P_FILE_ACCESS));
    // A lock would keep others from looking at a run that is under way.
    H5Pset_file_locking(access, false, true);
    file_ = check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), "create");
}

Hdf5File::~Hdf5File() {
    const input::LibraryTurn turn;
    for (const Growing& dataset : growing_) {
        H5Dclose(dataset.dataset);
    }
    if (file_ >= 0) {
        H5Fclose(file_);
    }
}

void Hdf5File::close() {
    const input::LibraryTurn turn;
    for (const Growing& dataset : std::exchange(growing_, {})) {
        check(H5Dclose(dataset.dataset), "write to");
    }
    check(H5Fclose(std::exchange(file_, -1)), "write to");
}

void Hdf5File::fail(const std::string& doing) const { throw FileError(doing, path_, last_reason()); }

Hdf5File::Handle Hdf5File::check(Handle result, const std::string& doing) const {
    if (result < 0) {
        fail(doing);
    }
    return result;
}

void Hdf5File::add_group(const std::string& path) {
    const input::LibraryTurn turn;
    const Scoped list(creation(H5P_GROUP_CREATE));
    const Scoped group(check(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), "write " + path + " to"));
}

void Hdf5File::add_link(const std::string& path, const std::string& target) {
    const input::LibraryTurn turn;
    check(H5Lcreate_hard(file_, target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
          "write " + path + " to");
}

void Hdf5File::attach(Handle object, const std::string& name, const std::string& value) {
    const Scoped type(string_type());
    const Scoped space(H5Screate(H5S_SCALAR));
    const Scoped attribute(check(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), "write to"));
    const char* text = value.c_str();
    check(H5Awrite(attribute, type, &text), "write to");
}

void Hdf5File::attach(Handle dataset, const Label& label) {
    attach(dataset, "units", label.units);
    attach(dataset, "long_name", label.long_name);
    attach(dataset, "source", label.source);
    if (!label.coordinates.empty()) {
        attach(dataset, "coordinates", label.coordinates);
    }
}

void Hdf5File::add_attribute(const std::string& object, const std::string& name, const std::string& value) {
    const input::LibraryTurn turn;
    const Scoped opened(check(H5Oopen(file_, object.c_str(), H5P_DEFAULT), "open " + object + " of"));
    attach(opened, name, value);
}

void Hdf5File::add_attribute(const std::string& object, const std::string& name, double value) {
    const input::LibraryTurn turn;
    const Scoped opened(check(H5Oopen(file_, object.c_str(), H5P_DEFAULT), "open " + object + " of"));
    const Scoped space(H5Screate(H5S_SCALAR));
    const Scoped attribute(
        check(H5Acreate2(opened, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), "write to"));
    check(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), "write to");
}

template <typename Value>
void Hdf5File::write_table(const std::string& path, std::span<const Value> values, std::size_t width, Handle type,
                           const Label& label) {
    const input::LibraryTurn turn;
    const std::array<hsize_t, 2> size{width == 0 ? values.size() : values.size() / width, width};
    const Scoped space(H5Screate_simple(width == 0 ? 1 : 2, size.data(), nullptr));
    const Scoped list(creation(H5P_DATASET_CREATE));
    if (values.size_bytes() >= compressed_from) {
        H5Pset_chunk(list, width == 0 ? 1 : 2, size.data());
        H5Pset_shuffle(list);
        H5Pset_deflate(list, 4);
    }
    const std::string doing = "write " + path + " to";
    const Scoped dataset(check(H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), doing));
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), doing);
    attach(dataset, label);
}

void Hdf5File::write(const std::string& path, std::span<const double> values, std::size_t width, const Label& label) {
    write_table(path, values, width, H5T_NATIVE_DOUBLE, label);
}

void Hdf5File::write(const std::string& path, std::span<const int> values, std::size_t width, const Label& label) {
    write_table(path, values, width, H5T_NATIVE_INT, label);
}

void Hdf5File::write_strings(const std::string& path, std::span<const char* const> values, bool scalar,
                             const Label& label) {
    const input::LibraryTurn turn;
    const Scoped type(string_type());
    const hsize_t size = values.size();
    const Scoped space(scalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr));
    const Scoped list(creation(H5P_DATASET_CREATE));
    const std::string doing = "write " + path + " to";
    const Scoped dataset(check(H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), doing));
    if (size > 0) {
        const Scoped transfer(H5Pcreate(H5P_DATASET_XFER));
        H5Pset_buffer(transfer, buffer_of_texts, nullptr, nullptr);
        check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, transfer, values.data()), doing);
    }
    attach(dataset, label);
}

void Hdf5File::write(const std::string& path, std::span<const std::string> values, const Label& label) {
    std::vector<const char*> texts;
    for (const std::string& value : values) {
        texts.push_back(value.c_str());
    }
    write_strings(path, texts, false, label);
}

void Hdf5File::write(const std::string& path, const std::string& text, const Label& label) {
    const char* one = text.c_str();
    write_strings(path, {&one, 1}, true, label);
}

void Hdf5File::flush() {
    const input::LibraryTurn turn;
    check(H5Fflush(file_, H5F_SCOPE_LOCAL), "write to");
}

}  // namespace tiretherm::post
