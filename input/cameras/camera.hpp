// SPDX-License-Identifier: BSD-3-Clause
// Infrared cameras of a case, [[camera]]: surface, pixel size, position on the specimen, blur and emissivity.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

/// Cameras of a case:
///     [[camera]]
///     name = "camera"
///     surface = "top"               # or bottom
///     pixel_size = "0.5 mm"         # on the specimen, or as the file of frames says
///     x = "0.3 mm"                  # of the image's centre on the specimen
///     blur = "0.8 mm"               # full width at half maximum
///     emissivity = 0.95
namespace tiretherm::input {

/// A camera as the case announces it. In a problem it is as many channels as its surface has nodes, behind all sensors:
/// pixels are means of them, so that the number of pixels costs nothing until frames are compared.
struct Camera {
    std::string name;
    SourceLocation place;
    int patch = -1;
    std::optional<std::array<double, 2>> pixel_size{};  ///< m, along a row and along a column of the image
    std::optional<std::array<int, 2>> rows{};           ///< first and last of the part that counts; all of them
    std::optional<std::array<int, 2>> columns{};
    int bin = 1;                                 ///< so many by so many detectors make a pixel
    std::optional<double> standard_deviation{};  ///< K, of one detector
    std::size_t pose = 0;                        ///< index into Problem::effects
    solver::CameraChannels channels{};
};

/// The list [[camera]], behind all sensors.
/// @param given null where what the run's file gives is unknown  @param problem gets the cameras' channels and effects
[[nodiscard]] std::vector<Camera> read_cameras(TomlTable& root, const GivenSignals* given, solver::Problem& problem);

/// What a problem is without its cameras: a run that nothing is measured in does not need their channels.
void take_away_cameras(solver::Problem& problem);

}  // namespace tiretherm::input
