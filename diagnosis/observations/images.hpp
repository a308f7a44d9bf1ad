// SPDX-License-Identifier: BSD-3-Clause
// Turns simulated surface temperatures into the pixels of a thermal camera, with derivatives; a pixel adds up radiation
// (T^4).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/observations/image_bands.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// The images of one camera in one run, as rows of Observations: for each entry of the bands its frames, one after another.
struct ImageRows {
    std::size_t run = 0;
    std::size_t frames = 0;         ///< index into MeasuredRun::frames
    std::size_t first = 0;          ///< row of the first entry in the first frame
    std::vector<std::size_t> time;  ///< [n_frames] indices into the times at which the run is asked
    ImageBands bands;

    [[nodiscard]] Eigen::Index rows() const { return static_cast<Eigen::Index>(bands.entries() * time.size()); }
    [[nodiscard]] std::size_t row(std::size_t entry, std::size_t frame) const {
        return first + entry * time.size() + frame;
    }
};
[[nodiscard]] ImageBands bands_of(const input::MeasuredFrames& frames);

/// Turns what the surface's nodes show into what the pixels show. A detector adds up radiation, not temperatures: a pixel
/// shows the fourth root of the mean of T^4, T what each place shows, 1.5 var(T)/T above the mean of T.
class ImageView {
public:
    /// @param problem a run's, with the pose that its numbers have now
    ImageView(const input::MeasuredFrames& frames, const solver::Problem& problem);
    /// Of how the pixels change with a number of the pose.
    /// @param number index into the parameters of physics::camera_pose
    [[nodiscard]] static ImageView slope(const input::MeasuredFrames& frames, const solver::Problem& problem,
                                         std::size_t number);

    /// @param channels of the problem, at one moment, K  @param pixels out, [n_pixels] K
    void read(std::span<const double> channels, std::span<double> pixels) const;
    /// How the pixels follow small changes of what the nodes show. @param changes of the channels, per unit of a number
    /// @param pixels as read  @param out [n_pixels] K per unit
    void follow(std::span<const double> channels, std::span<const double> changes, std::span<const double> pixels,
                std::span<double> out) const;
    /// How they follow the number of `slope`, for a view from there. @param pixels as the view itself reads them
    void turn(std::span<const double> channels, std::span<const double> pixels, std::span<double> out) const;
    [[nodiscard]] std::size_t pixels() const { return pixels_.size(); }

private:
    ImageView() = default;
    solver::CameraChannels channels_;
    std::vector<mesh::Functional> pixels_;  ///< nodes count the surface's
};

/// Middle of each pixel on the specimen. @returns [n_pixels] m
[[nodiscard]] std::vector<std::array<double, 2>> middles_of(const input::MeasuredFrames& frames,
                                                            const solver::Problem& problem);

}  // namespace tiretherm::diagnosis
