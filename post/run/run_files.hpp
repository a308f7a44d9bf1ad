#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "post/fields/csv_writer.hpp"
#include "post/fields/hdf5_writer.hpp"
#include "post/report/history.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/fields/vtk_writer.hpp"

namespace tiretherm::post {

/// Which files a run writes besides results.h5 and channels.csv.
struct FileOptions {
    bool vtk = true;
    bool pictures = true;
};

/// The files of a run in one directory. They replace those of an earlier run there; other files are left alone.
class RunFiles {
public:
    /// Creates the directory and opens the files, so that whatever is wrong with them shows before the run.
    /// @param problem must outlive this   @errors FileError
    RunFiles(std::filesystem::path directory, const solver::Problem& problem, const Provenance& provenance,
             const FileOptions& choice);

    /// @errors FileError
    void take(const solver::Snapshot& snapshot);
    /// Completes the files and draws the pictures. @errors FileError
    void finish();

    /// The courses of the hot spots as hot_spots.csv and hot_spots.png. @errors FileError
    void write_hot_spots(const diagnosis::HotSpots& hot_spots);

    [[nodiscard]] const History& history() const { return history_; }
    /// All files written so far, by their use: results, channels, fields, pictures.
    [[nodiscard]] const std::vector<std::filesystem::path>& written() const { return written_; }

private:
    std::filesystem::path add(const char* name);

    std::filesystem::path directory_;
    const solver::Problem& problem_;
    FileOptions choice_;
    std::vector<std::filesystem::path> written_;
    Hdf5Writer hdf5_;
    CsvWriter csv_;
    std::optional<VtkWriter> vtk_;
    History history_;
    double last_field_time_ = 0.0;
    std::vector<double> last_field_;  ///< [n_nodes] K
};

}  // namespace tiretherm::post
