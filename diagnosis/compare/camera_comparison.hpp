// SPDX-License-Identifier: BSD-3-Clause
// Compares the frames of a thermal camera with simulated images, pixel by pixel; a camera counts as one channel.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "diagnosis/compare/comparison_statistics.hpp"
#include "input/measurements/experiment.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::diagnosis {

/// Differences over some pixels or some frames.
struct PartFigures {
    double from = 0.0;  ///< m from the origin of the specimen, or s
    double to = 0.0;
    std::size_t pixels = 0;
    double bias = 0.0;
    double rmse = 0.0;
};

/// The frames of a camera in one run beside those that are simulated; a camera is one channel, however many pixels it has.
/// Every difference is simulated - measured.
struct ComparedImages {
    std::string camera;
    std::string file;
    std::size_t run = 0;
    std::vector<double> time;  ///< [n_frames] s
    int rows = 0;              ///< of the image, all pixels
    int columns = 0;
    double pitch_x = 0.0;  ///< m, of a pixel
    double pitch_y = 0.0;
    std::vector<std::array<int, 2>> place;     ///< [n_pixels] row, column of those that are compared
    std::vector<std::array<double, 2>> where;  ///< [n_pixels] m, on the specimen
    std::vector<double> measured;              ///< [n_frames][n_pixels] K
    std::vector<double> simulated;
    int dead = 0;
    int beside = 0;
    int bin = 1;

    /// Over all pixels and frames; the bias's deviation is that of the frames' means, whose errors go on for a while.
    Figures figures;
    double noise = 0.0;  ///< K, of a pixel: what changes from one frame to the next
    double sensor = 0.0;
    bool sensor_is_stated = false;
    double removable = 0.0;                              ///< K, rms once the sensor's is removed
    std::vector<PartFigures> rings;                      ///< by distance from the origin
    std::vector<PartFigures> stages;                     ///< by time
    std::vector<std::pair<std::string, double>> scales;  ///< rms of the differences in each band (ImageBands)
    std::size_t worst = 0;                               ///< the frame with the largest rms

    [[nodiscard]] std::size_t pixels() const { return place.size(); }
    [[nodiscard]] double difference(std::size_t frame, std::size_t pixel) const {
        return simulated[frame * pixels() + pixel] - measured[frame * pixels() + pixel];
    }
};
/// @param times of the prediction
[[nodiscard]] ComparedImages compare_images(const input::MeasuredRun& run, std::size_t index,
                                            const input::MeasuredFrames& frames, const std::vector<double>& times,
                                            const solver::Prediction& prediction);
/// The figures, from what is measured and simulated.
void evaluate(ComparedImages& images);

}  // namespace tiretherm::diagnosis
