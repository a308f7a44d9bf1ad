#include "post/run/run_files.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "post/report/file.hpp"
#include "post/pictures/picture.hpp"

namespace tiretherm::post {

namespace {

std::filesystem::path created(std::filesystem::path directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        throw FileError("create the directory", directory, error.message());
    }
    return directory;
}

}  // namespace

RunFiles::RunFiles(std::filesystem::path directory, const solver::Problem& problem, const Provenance& provenance,
                   const FileOptions& choice)
    : directory_(created(std::move(directory))),
      problem_(problem),
      choice_(choice),
      hdf5_(add("results.h5"), problem, provenance),
      csv_(add("channels.csv"), problem) {
    std::error_code ignored;  // pictures and fields of an earlier run must not outlive its results
    std::filesystem::remove(directory_ / "picture.png", ignored);
    std::filesystem::remove(directory_ / "tread.png", ignored);
    std::filesystem::remove(directory_ / "channels.png", ignored);
    std::filesystem::remove(directory_ / "hot_spots.csv", ignored);
    std::filesystem::remove(directory_ / "hot_spots.png", ignored);
    VtkWriter::remove_series(directory_);
    if (choice.vtk) {
        vtk_.emplace(directory_, problem.mesh);
        written_.push_back(vtk_->series());
    }
}

std::filesystem::path RunFiles::add(const char* name) { return written_.emplace_back(directory_ / name); }

void RunFiles::take(const solver::Snapshot& snapshot) {
    history_.take(snapshot);
    csv_.take(snapshot);
    hdf5_.take(snapshot);
    if (snapshot.field) {
        if (vtk_) {
            vtk_->write(snapshot.time, snapshot.temperature);
        }
        last_field_time_ = snapshot.time;
        last_field_.assign(snapshot.temperature.begin(), snapshot.temperature.end());
    }
}

void RunFiles::write_hot_spots(const diagnosis::HotSpots& hot_spots) {
    write_hot_spots_csv(add("hot_spots.csv"), hot_spots, problem_);
    if (choice_.pictures && history_.rows() > 1) {
        draw_hot_spots(add("hot_spots.png"), hot_spots, problem_);
    }
}

void RunFiles::finish() {
    hdf5_.finish();
    if (!choice_.pictures) {
        return;
    }
    if (has_section(problem_.mesh) && !last_field_.empty()) {
        draw_field(add("picture.png"), problem_, last_field_time_, last_field_);
    } else if (!problem_.mesh.columns.empty() && !last_field_.empty()) {
        draw_folded(add("picture.png"), problem_, last_field_time_, last_field_);
        if (problem_.mesh.sectors > 1) {
            draw_tread(add("tread.png"), problem_, last_field_time_, last_field_);
        }
    }
    const bool has_temperature = std::ranges::any_of(problem_.channels, [](const solver::Channel& channel) {
        return channel.quantity == solver::Quantity::temperature;
    });
    if (history_.rows() > 1 && has_temperature) {
        draw_channels(add("channels.png"), problem_, history_);
    }
}

}  // namespace tiretherm::post
