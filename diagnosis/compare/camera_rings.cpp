// SPDX-License-Identifier: BSD-3-Clause
// Puts rings of pixels in the place of the camera's surface nodes: means of the measured pixels, corrected for the
// difference between mean radiation and mean temperature.

#include "diagnosis/compare/camera_rings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "diagnosis/observations/images.hpp"
#include "physics/camera.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Few, because a diagnosis takes the noise of its channels as independent: what the rings share of the camera's drift is
/// counted once for each of them.
constexpr std::size_t fitted_rings = 3;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Which ring each pixel of a run lies in. The rings are equally wide and end where the farthest pixel is.
std::vector<std::size_t> rings_of(const input::MeasuredFrames& frames, const solver::Problem& problem,
                                  double farthest) {
    std::vector<std::size_t> ring;
    for (const auto& [x, y] : middles_of(frames, problem)) {
        const double share = std::hypot(x, y) / farthest;
        ring.push_back(std::min(fitted_rings - 1, static_cast<std::size_t>(share * fitted_rings)));
    }
    return ring;
}

double farthest_of(const input::MeasuredFrames& frames, const solver::Problem& problem) {
    double farthest = 0.0;
    for (const auto& [x, y] : middles_of(frames, problem)) {
        farthest = std::max(farthest, std::hypot(x, y));
    }
    return farthest;
}

/// A camera of the experiment, and the rings that any run sees of it.
struct Seen {
    std::string name;
    solver::CameraChannels nodes;  ///< its channels as they are
    double farthest = 0.0;
    std::size_t rings = 0;
    std::size_t new_channel = 0;  ///< of its first ring
    [[nodiscard]] std::size_t first_node() const { return nodes.first; }
};

std::vector<Seen> cameras_of(const input::Experiment& experiment) {
    std::vector<Seen> all;
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const input::MeasuredFrames& frames : run.frames) {
            auto known = std::ranges::find(all, frames.camera, &Seen::name);
            if (known == all.end()) {
                all.push_back({.name = frames.camera, .nodes = frames.channels});
                known = all.end() - 1;
            }
            known->farthest = std::max(known->farthest, farthest_of(frames, run.problem));
            known->rings = fitted_rings;
        }
    }
    std::ranges::sort(all, {}, &Seen::first_node);
    return all;
}

/// The mean over the pixels of each ring, as a mean over nodes of the mesh.
std::vector<mesh::Functional> places_of(const input::MeasuredFrames& frames, const solver::Problem& problem,
                                        const std::vector<std::size_t>& ring) {
    const physics::SeenSurface surface(problem.mesh, frames.patch);
    const std::vector<mesh::Functional> pixels =
        physics::over_pixels(surface, frames.detectors, physics::pose_of(problem.effects[frames.pose]), frames.pixels);
    std::vector<mesh::Functional> places(fitted_rings);
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        for (std::size_t k = 0; k < pixels[p].nodes.size(); ++k) {
            const int node = surface.nodes()[static_cast<std::size_t>(pixels[p].nodes[k])];
            places[ring[p]].add(node, pixels[p].weights[k]);
        }
    }
    for (mesh::Functional& place : places) {
        if (place.nodes.empty()) {  // read by nobody
            place.add(surface.nodes().front(), 1.0);
        }
        place.normalise();
    }
    return places;
}

/// What the pixels of a run show at the case's values. @returns [n_frames][n_pixels] K, empty where the run fails
std::vector<double> shown_by(const input::MeasuredFrames& frames, const solver::Problem& problem) {
    const solver::Prediction prediction = solver::predict(problem, {.times = frames.time});
    if (!prediction.status.ok()) {
        return {};  // the diagnosis will say so
    }
    std::vector<double> shown(frames.value.size());
    const ImageView view(frames, problem);
    for (std::size_t f = 0; f < frames.time.size(); ++f) {
        view.read(std::span(prediction.value).subspan(f * prediction.n_channels, prediction.n_channels),
                  std::span(shown).subspan(f * view.pixels(), view.pixels()));
    }
    return shown;
}

/// Means over the pixels of one ring. @returns [n_frames]
std::vector<double> means_of(const std::vector<double>& pixels, const std::vector<std::size_t>& ring, std::size_t k,
                             std::size_t n_frames) {
    const auto count = static_cast<double>(std::ranges::count(ring, k));
    std::vector<double> means(n_frames, 0.0);
    for (std::size_t f = 0; f < n_frames; ++f) {
        for (std::size_t p = 0; p < ring.size(); ++p) {
            means[f] += ring[p] == k ? pixels[f * ring.size() + p] / count : 0.0;
        }
    }
    return means;
}

/// Puts the rings in the place of a problem's nodes; effects on them follow.
void change_channels(solver::Problem& problem, const std::vector<Seen>& cameras, std::size_t first) {
    problem.channels.resize(first);
    problem.cameras.clear();
    for (const Seen& camera : cameras) {
        problem.cameras.push_back({.camera = camera.name, .first = camera.new_channel, .count = camera.rings});
        for (std::size_t k = 0; k < camera.rings; ++k) {
            solver::Channel channel;
            channel.name = fmt::format("{} {}", camera.name, k + 1);
            channel.meaning = fmt::format("{}, mean over the pixels from {:.1f} to {:.1f} mm from the spot's centre",
                                          camera.name, 1e3 * camera.farthest * static_cast<double>(k) / fitted_rings,
                                          1e3 * camera.farthest * static_cast<double>(k + 1) / fitted_rings);
            problem.channels.push_back(std::move(channel));
        }
    }
    for (physics::ActiveEffect& active : problem.effects) {
        std::vector<int> channels;
        std::vector<physics::ActiveEffect::Override> overrides;
        for (const auto& other : active.overrides) {
            if (other.scope != physics::Scope::channel || static_cast<std::size_t>(other.index) < first) {
                overrides.push_back(other);
            }
        }
        std::ranges::copy_if(active.channels, std::back_inserter(channels),
                             [&](int channel) { return static_cast<std::size_t>(channel) < first; });
        for (const Seen& camera : cameras) {
            const auto old = static_cast<int>(camera.first_node());
            const bool acts = std::ranges::find(active.channels, old) != active.channels.end();
            for (std::size_t k = 0; acts && k < camera.rings; ++k) {
                const auto now = static_cast<int>(camera.new_channel + k);
                channels.push_back(now);
                for (const auto& other : active.overrides) {
                    if (other.scope == physics::Scope::channel && other.index == old) {
                        overrides.push_back(other);
                        overrides.back().index = now;
                    }
                }
            }
        }
        active.channels = std::move(channels);
        active.overrides = std::move(overrides);
    }
}

/// Columns at more moments: what was not read there is missing.
std::vector<double> spread(const std::vector<double>& value, const std::vector<double>& from,
                           const std::vector<double>& to) {
    std::vector<double> result(to.size(), missing);
    for (std::size_t i = 0; i < from.size(); ++i) {
        result[static_cast<std::size_t>(std::ranges::lower_bound(to, from[i]) - to.begin())] = value[i];
    }
    return result;
}

void change_times(input::MeasuredRun& run) {
    std::vector<double> times = run.time;
    for (const input::MeasuredFrames& frames : run.frames) {
        times.insert(times.end(), frames.time.begin(), frames.time.end());
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (input::MeasuredSeries& series : run.series) {
        series.value = spread(series.value, run.time, times);
    }
    for (input::UnusedSignal& signal : run.unused) {
        signal.value = spread(signal.value, run.time, times);
    }
    run.time = std::move(times);
}

/// The rings of one camera as series. A pixel shows the mean of the radiation in it, a ring the reading of a mean
/// temperature; what lies between is taken off the data as it is at the case's values, on which it hardly depends.
void add_series(const input::MeasuredFrames& frames, const solver::Problem& before, const Seen& camera,
                input::MeasuredRun& run) {
    const std::vector<std::size_t> ring = rings_of(frames, before, camera.farthest);
    const std::vector<double> shown = shown_by(frames, before);
    const solver::Prediction read = solver::predict(run.problem, {.times = frames.time});
    for (std::size_t k = 0; k < camera.rings; ++k) {
        if (std::ranges::find(ring, k) == ring.end()) {
            continue;
        }
        std::vector<double> value = means_of(frames.value, ring, k, frames.time.size());
        if (!shown.empty() && read.status.ok()) {
            const std::vector<double> of_pixels = means_of(shown, ring, k, frames.time.size());
            for (std::size_t f = 0; f < value.size(); ++f) {
                value[f] -= of_pixels[f] - read.at(f, camera.new_channel + k);
            }
        }
        run.series.push_back({.channel = camera.new_channel + k, .value = spread(value, frames.time, run.time)});
    }
}

}  // namespace

input::Experiment in_rings(input::Experiment experiment, Remarks& remarks) {
    std::vector<Seen> cameras = cameras_of(experiment);
    if (cameras.empty()) {
        return experiment;
    }
    const std::size_t first = cameras.front().first_node();
    std::size_t next = first;
    for (Seen& camera : cameras) {
        camera.new_channel = next;
        next += camera.rings;
        remarks.push_back(remark::images_as_rings(camera.name, static_cast<long>(camera.rings),
                                                  1e3 * camera.farthest / fitted_rings,
                                                  std::sqrt(static_cast<double>(fitted_rings))));
    }
    std::vector<std::size_t> poses;
    for (input::MeasuredRun& run : experiment.runs) {
        const solver::Problem before = run.problem;
        change_times(run);
        change_channels(run.problem, cameras, first);
        for (std::size_t c = first; c < run.problem.channels.size(); ++c) {
            run.problem.channels[c].where = {.nodes = {0}, .weights = {1.0}};  // of a run without frames of this camera
        }
        for (const input::MeasuredFrames& frames : run.frames) {
            poses.push_back(frames.pose);
            const Seen& camera = *std::ranges::find(cameras, frames.camera, &Seen::name);
            const std::vector<mesh::Functional> places =
                places_of(frames, before, rings_of(frames, before, camera.farthest));
            for (std::size_t k = 0; k < camera.rings; ++k) {
                run.problem.channels[camera.new_channel + k].where = places[k];
            }
        }
        for (const input::MeasuredFrames& frames : run.frames) {
            const Seen& camera = *std::ranges::find(cameras, frames.camera, &Seen::name);
            add_series(frames, before, camera, run);
        }
    }
    for (input::MeasuredRun& run : experiment.runs) {
        run.frames.clear();
    }
    std::erase_if(experiment.parameters, [&](const solver::FreeParameter& number) {
        return number.kind == solver::FreeParameter::Kind::effect &&
               std::ranges::find(poses, number.effect) != poses.end();
    });
    return experiment;
}

}  // namespace tiretherm::diagnosis
