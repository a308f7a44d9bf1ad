// SPDX-License-Identifier: BSD-3-Clause
// Output format "hdf5": results.h5 with case, mesh, channels, heat budget and temperature fields in SI units.
#pragma once

#include <filesystem>
#include <vector>

#include "post/fields/hdf5_file.hpp"
#include "post/fields/output_format.hpp"
#include "post/report/provenance.hpp"

namespace tiretherm::post {

/// results.h5: everything a run knows, in SI and kelvin, each dataset with units, long_name and source.
///
///   /case      name, title, source (what to cite), tiretherm_version, file, text
///   /mesh      centre, volume, layer [n_nodes]; layer_name; point, corners [n_cells, corners of a cell]
///   /channels  time; one dataset a channel                                        [rows] K
///   /inputs    one dataset an input that is given                                  [rows] SI
///   /heat_budget  effect; watts, joules [rows, n_effects]; stored [rows]: of the whole specimen
///   /field     time; temperature [n_times, n_nodes]: the cells first, then the nodes on the surfaces
///
/// Rows reach the disk at least twice a second, a field at once: a run that is killed leaves them readable.
class Hdf5Writer final : public RunOutput {
public:
    /// @param problem must outlive the writer   @errors FileError
    Hdf5Writer(const std::filesystem::path& path, const solver::Problem& problem, const Provenance& provenance);

    /// @errors FileError
    void take(const solver::Snapshot& snapshot) override;
    /// Writes what is still held back. @errors FileError
    void finish() override;
    [[nodiscard]] std::vector<std::filesystem::path> files() const override { return {path_}; }

private:
    /// Rows held back in memory until the next flush.
    struct Column {
        Hdf5File::Rows rows;
        std::vector<double> waiting;
    };

    void write_case(const Provenance& provenance);
    void write_mesh();
    void add_columns();
    Column column(const std::string& path, std::size_t width, const Label& label);
    void flush();

    const solver::Problem& problem_;
    std::string source_;
    std::filesystem::path path_;
    Hdf5File file_;
    std::vector<Column> channels_;                ///< time, then the channels
    std::vector<const physics::Signal*> inputs_;  ///< whose columns follow those of the channels
    std::vector<Column> heat_budget_;             ///< watts, joules, stored
    std::vector<Column> field_;                   ///< time, temperature
};

}  // namespace tiretherm::post
