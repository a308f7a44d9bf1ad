#pragma once

#include <filesystem>
#include <vector>

#include "cases/columns.hpp"
#include "cases/mistake.hpp"

namespace tiretherm::cases {

/// A dataset of numbers in one dimension, with its attribute `units`.
struct Dataset {
    Heading heading;
    std::vector<double> values;
};

/// The datasets of a file's root; where it has none, those of its last group that has any.
struct Datasets {
    std::vector<Dataset> found;
    std::vector<std::string> groups;  ///< that have any; empty when the root has
};

/// Why a file cannot be opened as HDF5; empty for one that can.
[[nodiscard]] Fault hdf5_defect(const std::filesystem::path& path);

/// @pre hdf5_defect says nothing. Of a file that tiretherm wrote only the channels are looked at.
[[nodiscard]] Datasets read_datasets(const std::filesystem::path& path);

}  // namespace tiretherm::cases
