// SPDX-License-Identifier: BSD-3-Clause
// Selects the frames within the run, masks dead detectors and those that see beside the specimen, and averages the rest
// into binned pixels.

#include "input/cameras/frames.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/cameras/frame_file.hpp"
#include "input/cameras/frame_warnings.hpp"
#include "input/files/enough_memory.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

/// A camera's part of the image: first and last row and column.
struct ImageWindow {
    std::array<int, 2> rows{};
    std::array<int, 2> columns{};
};

std::optional<ImageWindow> window_of(const Camera& camera, const FrameFile& file, InputErrors& errors) {
    const std::array<int, 2> rows = camera.rows.value_or(std::array{0, file.rows - 1});
    const std::array<int, 2> columns = camera.columns.value_or(std::array{0, file.columns - 1});
    bool sound = true;
    for (const auto& [key, last, size] :
         {std::tuple{"rows", rows[1], file.rows}, std::tuple{"columns", columns[1], file.columns}}) {
        if (last >= size) {
            errors.add(camera.place,
                       fmt::format("{} of {} go to {}, and the frames of {} have {}, 0 to {}", key, camera.name, last,
                                   file.shown, size, size - 1),
                       fmt::format("let {} end at {} at most", key, size - 1));
            sound = false;
        }
    }
    return sound ? std::optional(ImageWindow{.rows = rows, .columns = columns}) : std::nullopt;
}

/// Detectors that have a value in every frame of the run. @returns [rows * columns], empty after an error
std::vector<bool> alive_in(const FrameFile& file, const std::vector<std::size_t>& frames, FrameChecks& checks,
                           InputErrors& errors) {
    std::vector<bool> alive(static_cast<std::size_t>(file.rows) * static_cast<std::size_t>(file.columns), true);
    std::vector<double> kelvin;
    for (const std::size_t frame : frames) {
        if (!file.read(frame, kelvin)) {
            errors.add({.file = file.number},
                       fmt::format("frame {} cannot be read: the file is damaged or cut off", frame),
                       "copy or export it again");
            return {};
        }
        checks.take(kelvin);
        for (std::size_t i = 0; i < kelvin.size(); ++i) {
            alive[i] = alive[i] && std::isfinite(kelvin[i]) && kelvin[i] > 0.0;
        }
    }
    return alive;
}

/// Bins of living detectors that see nothing but the specimen; one with less than half of its detectors is left out.
void find_pixels(const Camera& camera, const ImageWindow& window, const std::vector<bool>& alive,
                 const solver::Problem& problem, MeasuredFrames& into) {
    const physics::SeenSurface surface(problem.mesh, camera.patch);
    const physics::CameraPose pose = physics::pose_of(problem.effects[camera.pose]);
    const int n = camera.bin;
    into.rows = (window.rows[1] - window.rows[0]) / n + 1;
    into.columns = (window.columns[1] - window.columns[0]) / n + 1;
    for (int row = 0; row < into.rows; ++row) {
        for (int column = 0; column < into.columns; ++column) {
            physics::BinnedPixel pixel{.row = row, .column = column, .detectors = {}};
            for (int r = window.rows[0] + row * n; r < window.rows[0] + (row + 1) * n && r <= window.rows[1]; ++r) {
                for (int c = window.columns[0] + column * n;
                     c < window.columns[0] + (column + 1) * n && c <= window.columns[1]; ++c) {
                    const int detector = r * into.detectors.columns + c;
                    if (!alive[static_cast<std::size_t>(detector)]) {
                        ++into.dead;
                    } else if (!physics::sees_specimen(surface, into.detectors, pose, r, c)) {
                        ++into.beside;
                    } else {
                        pixel.detectors.push_back(detector);
                    }
                }
            }
            // Half of the detectors still average the noise and lie about the middle of the bin.
            if (2 * pixel.detectors.size() >= static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {
                into.pixels.push_back(std::move(pixel));
            }
        }
    }
}

void read_values(const FrameFile& file, const std::vector<std::size_t>& frames, MeasuredFrames& into) {
    std::vector<double> kelvin;
    into.value.reserve(frames.size() * into.pixels.size());
    for (const std::size_t frame : frames) {
        into.time.push_back(file.time[frame]);
        (void)file.read(frame, kelvin);  // it could be read before
        for (const physics::BinnedPixel& pixel : into.pixels) {
            double sum = 0.0;
            for (const int detector : pixel.detectors) {
                sum += kelvin[static_cast<std::size_t>(detector)];
            }
            into.value.push_back(sum / static_cast<double>(pixel.detectors.size()));
        }
    }
}

const Camera* find_camera(const FramesOfRun& named, const std::vector<Camera>& cameras, InputErrors& errors) {
    if (named.camera.text.empty() && cameras.size() == 1) {
        return &cameras.front();
    }
    const auto found = std::ranges::find(cameras, named.camera.text, &Camera::name);
    if (found != cameras.end()) {
        return &*found;
    }
    if (std::ranges::any_of(cameras, [](const Camera& camera) { return camera.name.empty(); })) {
        return nullptr;  // its name is wrong, which has been said; it may be the one
    }
    errors.add(named.camera.place,
               cameras.empty()             ? "the case has no camera that gives frames"
               : named.camera.text.empty() ? "frames does not say of which camera"
                                           : fmt::format("there is no camera \"{}\"", named.camera.text),
               cameras.empty()             ? "add [[camera]] with a name"
               : named.camera.text.empty() ? fmt::format("write frames = {{ {} = \"....h5\" }}", cameras.front().name)
                                           : suggest(named.camera.text, names_of(cameras), "cameras"));
    return nullptr;
}

void read_one(const Camera& camera, const FramesOfRun& named, const RunInputs* inputs, const solver::Problem& problem,
              InputErrors& errors, MeasuredRun& run, std::vector<InputWarning>& warnings) {
    const std::optional<FrameFile> file = open_frames(named.path, named.place, errors);
    if (!file) {
        return;
    }
    const std::optional<std::array<double, 2>> size = camera.pixel_size ? camera.pixel_size : file->pixel_size;
    if (!size) {
        errors.add(named.place, fmt::format("the size of a pixel of {} on the specimen is not given", camera.name),
                   "add pixel_size = \"0.5 mm\" to the [[camera]], or the attribute pixel_size to the file's frames");
    }
    const std::optional<ImageWindow> window = window_of(camera, *file, errors);
    std::vector<std::size_t> frames;
    const solver::Settings& settings = problem.settings;
    const double from = settings.start + (inputs != nullptr ? inputs->lead : 0.0);
    const auto is_left_out = [&](double t) {
        return inputs != nullptr &&
               std::ranges::any_of(inputs->left_out, [t](const LapWindow& lap) { return t >= lap.from && t < lap.to; });
    };
    for (std::size_t i = 0; i < file->time.size(); ++i) {
        if (file->time[i] >= from && file->time[i] <= settings.end && !is_left_out(file->time[i])) {
            frames.push_back(i);
        }
    }
    if (frames.empty() && settings.end > settings.start) {
        errors.add(named.place,
                   fmt::format("no frame lies within the run: frames from {:.6g} to {:.6g} s, the run from {:.6g} to "
                               "{:.6g} s",
                               file->time.front(), file->time.back(), settings.start, settings.end),
                   "give the frames the run's clock, or the run its time = { start = ..., end = ... }");
    }
    if (!size || !window || frames.empty() || camera.patch < 0) {
        return;
    }
    FrameChecks checks;
    const std::vector<bool> alive = alive_in(*file, frames, checks, errors);
    if (alive.empty()) {
        return;
    }
    MeasuredFrames measured{
        .camera = camera.name,
        .file = file->shown,
        .patch = camera.patch,
        .pose = camera.pose,
        .channels = camera.channels,
        .detectors = {.rows = file->rows, .columns = file->columns, .pitch_x = (*size)[0], .pitch_y = (*size)[1]},
        .bin = camera.bin};
    if (camera.standard_deviation) {
        measured.standard_deviation = *camera.standard_deviation / camera.bin;
    }
    find_pixels(camera, *window, alive, problem, measured);
    if (measured.pixels.empty()) {
        errors.add({.file = file->number},
                   fmt::format("no pixel of {} is of use: of {} detectors {} are dead and {} look beside the specimen",
                               camera.name, measured.dead + measured.beside, measured.dead, measured.beside),
                   measured.dead > measured.beside ? "export the frames again, as temperatures"
                                                   : "check pixel_size, x, y and rotation of the [[camera]]");
        return;
    }
    read_values(*file, frames, measured);
    for (std::string& sentence : checks.warnings(measured, file->time.size() - frames.size())) {
        warnings.push_back({.file = measured.file, .what = std::move(sentence)});
    }
    run.frames.push_back(std::move(measured));
}

}  // namespace

void read_frames(const RunTable& table, const RunInputs* inputs, const std::vector<Camera>& cameras,
                 const solver::Problem& problem, InputErrors& errors, MeasuredRun& run,
                 std::vector<InputWarning>& warnings) {
    for (const FramesOfRun& named : table.frames) {
        if (const Camera* camera = find_camera(named, cameras, errors)) {
            static_cast<void>(with_memory(named.path.generic_string(), named.place, errors, [&] {
                read_one(*camera, named, inputs, problem, errors, run, warnings);
                return true;
            }));
        }
    }
}

}  // namespace tiretherm::input
