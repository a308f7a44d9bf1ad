// SPDX-License-Identifier: BSD-3-Clause
// An HDF5 file written from front to back, readable even after the process was killed; hides the C library from other
// files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tiretherm::post {

/// What every dataset says about itself.
struct Label {
    std::string units;  ///< UDUNITS; "1" for names and counts
    std::string long_name;
    std::string source;
    std::string coordinates;  ///< paths of the datasets along its dimensions, first dimension first; may be empty
};

/// An HDF5 file that is written once, from front to back. Owns every handle; all paths are absolute ("/mesh/volume").
/// All members throw FileError with the path and the reason.
///
/// A process that is killed must leave a readable file. So the file keeps HDF5's oldest format, which no reader refuses
/// because a writer was never closed; nothing that is on disk is ever moved (a compressed chunk is written once, whole,
/// and rows that are rewritten while they fill a chunk are not compressed); and `flush` is called often.
class Hdf5File {
public:
    explicit Hdf5File(const std::filesystem::path& path);
    ~Hdf5File();
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    void add_group(const std::string& path);
    /// Another name of a group or dataset that there is.
    void add_link(const std::string& path, const std::string& target);
    void add_attribute(const std::string& object, const std::string& name, const std::string& value);
    void add_attribute(const std::string& object, const std::string& name, double value);

    /// @param width values a row; 0 for a dataset of one dimension
    void write(const std::string& path, std::span<const double> values, std::size_t width, const Label& label);
    void write(const std::string& path, std::span<const int> values, std::size_t width, const Label& label);
    void write(const std::string& path, std::span<const std::string> values, const Label& label);
    void write(const std::string& path, const std::string& text, const Label& label);

    /// Handle of a dataset that grows by rows.
    enum class Rows : std::size_t {};
    /// @param width values a row; 0 for a dataset of one dimension. Rows of 4 kB and more are compressed, each on its own.
    [[nodiscard]] Rows add_rows(const std::string& path, std::size_t width, const Label& label);
    /// Appends any number of whole rows.
    void append(Rows rows, std::span<const double> values);

    /// Everything appended so far survives the process.
    void flush();
    /// Closes the file, which tells whether all of it could be written. Nothing may be called after.
    void close();

private:
    using Handle = std::int64_t;  ///< hid_t

    struct Growing {
        Handle dataset;
        std::uint64_t width;
        std::uint64_t rows;
        bool flat;
    };

    template <typename Value>
    void write_table(const std::string& path, std::span<const Value> values, std::size_t width, Handle type,
                     const Label& label);
    void write_strings(const std::string& path, std::span<const char* const> values, bool scalar, const Label& label);
    void attach(Handle object, const std::string& name, const std::string& value);
    void attach(Handle dataset, const Label& label);
    [[noreturn]] void fail(const std::string& doing) const;
    /// Passes a result of HDF5 through; negative means failure.
    Handle check(Handle result, const std::string& doing) const;

    std::filesystem::path path_;
    Handle file_ = -1;
    std::vector<Growing> growing_;
};

}  // namespace tiretherm::post
