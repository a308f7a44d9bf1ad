// SPDX-License-Identifier: BSD-3-Clause
// Computes the figures of a camera's images from measured and simulated pixels: bias, noise, and differences by ring,
// by time and by size of structure.

#include "diagnosis/compare/camera_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/observations/images.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr int shown_rings = 8;
constexpr std::size_t most_stages = 6;

/// Sums of differences.
struct Sum {
    double n = 0.0;
    double sum = 0.0;
    double squares = 0.0;

    void add(double difference) {
        n += 1.0;
        sum += difference;
        squares += difference * difference;
    }
    [[nodiscard]] double mean() const { return sum / n; }
    [[nodiscard]] double rms() const { return std::sqrt(squares / n); }
};

std::vector<PartFigures> rings_of(const ComparedImages& images) {
    std::vector<double> distance;
    std::ranges::transform(images.where, std::back_inserter(distance),
                           [](const auto& at) { return std::hypot(at[0], at[1]); });
    const double farthest = *std::ranges::max_element(distance);
    std::vector<Sum> sums(shown_rings);
    std::vector<std::size_t> pixels(shown_rings, 0);
    for (std::size_t p = 0; p < images.pixels(); ++p) {
        const double share = farthest > 0.0 ? distance[p] / farthest : 0.0;
        const auto ring = static_cast<std::size_t>(std::min(shown_rings - 1, static_cast<int>(share * shown_rings)));
        ++pixels[ring];
        for (std::size_t f = 0; f < images.time.size(); ++f) {
            sums[ring].add(images.difference(f, p));
        }
    }
    std::vector<PartFigures> rings;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        if (pixels[k] > 0) {
            rings.push_back({.from = static_cast<double>(k) * farthest / shown_rings,
                             .to = static_cast<double>(k + 1) * farthest / shown_rings,
                             .pixels = pixels[k],
                             .bias = sums[k].mean(),
                             .rmse = sums[k].rms()});
        }
    }
    return rings;
}

std::vector<PartFigures> stages_of(const ComparedImages& images) {
    const std::size_t n = images.time.size();
    std::vector<PartFigures> stages;
    std::size_t first = 0;
    for (std::size_t k = 1; k <= most_stages; ++k) {
        const std::size_t end = n * k / most_stages;
        if (end <= first) {
            continue;
        }
        Sum sum;
        for (std::size_t f = first; f < end; ++f) {
            for (std::size_t p = 0; p < images.pixels(); ++p) {
                sum.add(images.difference(f, p));
            }
        }
        stages.push_back({.from = images.time[first],
                          .to = images.time[end - 1],
                          .pixels = images.pixels(),
                          .bias = sum.mean(),
                          .rmse = sum.rms()});
        first = end;
    }
    return stages;
}

}  // namespace

ComparedImages compare_images(const input::MeasuredRun& run, std::size_t index, const input::MeasuredFrames& frames,
                              const std::vector<double>& times, const solver::Prediction& prediction) {
    ComparedImages images;
    images.camera = frames.camera;
    images.file = frames.file;
    images.run = index;
    images.time = frames.time;
    images.rows = frames.rows;
    images.columns = frames.columns;
    images.pitch_x = frames.detectors.pitch_x * frames.bin;
    images.pitch_y = frames.detectors.pitch_y * frames.bin;
    images.where = middles_of(frames, run.problem);
    images.measured = frames.value;
    images.dead = frames.dead;
    images.beside = frames.beside;
    images.bin = frames.bin;
    images.sensor_is_stated = frames.standard_deviation.has_value();
    images.sensor = frames.standard_deviation.value_or(0.0);
    for (const physics::BinnedPixel& pixel : frames.pixels) {
        images.place.push_back({pixel.row, pixel.column});
    }
    images.simulated.resize(frames.value.size());
    const ImageView view(frames, run.problem);
    for (std::size_t f = 0; f < frames.time.size(); ++f) {
        const auto at = static_cast<std::size_t>(std::ranges::lower_bound(times, frames.time[f]) - times.begin());
        view.read(std::span(prediction.value).subspan(at * prediction.n_channels, prediction.n_channels),
                  std::span(images.simulated).subspan(f * images.pixels(), images.pixels()));
    }
    evaluate(images);
    return images;
}

void evaluate(ComparedImages& images) {
    const std::size_t n_frames = images.time.size();
    const std::size_t n_pixels = images.pixels();
    Sum all;
    std::vector<double> means;
    double largest = 0.0;
    for (std::size_t f = 0; f < n_frames; ++f) {
        Sum frame;
        for (std::size_t p = 0; p < n_pixels; ++p) {
            frame.add(images.difference(f, p));
            all.add(images.difference(f, p));
        }
        means.push_back(frame.mean());
        if (frame.rms() > largest) {
            largest = frame.rms();
            images.worst = f;
        }
    }
    // Pixels share missing effects of the model: how sure the bias is follows from how the mean of the frames goes
    // along time.
    images.figures = figures({means});
    images.figures.samples = n_frames * n_pixels;
    images.figures.bias = all.mean();
    images.figures.rmse = all.rms();
    images.figures.scatter = std::sqrt(std::max(0.0, all.squares / all.n - all.mean() * all.mean()));

    Pieces times(n_pixels, images.time);
    Pieces differences(n_pixels, std::vector<double>(n_frames));
    for (std::size_t f = 0; f < n_frames; ++f) {
        for (std::size_t p = 0; p < n_pixels; ++p) {
            differences[p][f] = images.difference(f, p);
        }
    }
    images.noise = sample_to_sample_noise(times, differences);
    if (!images.sensor_is_stated) {
        images.sensor = std::isnan(images.noise) ? 0.0 : images.noise;
    }
    images.removable =
        std::sqrt(std::max(0.0, images.figures.rmse * images.figures.rmse - images.sensor * images.sensor));
    images.rings = rings_of(images);
    images.stages = stages_of(images);

    std::vector<std::pair<int, int>> place;
    std::ranges::transform(images.place, std::back_inserter(place), [](const auto& at) {
        return std::pair{at[0], at[1]};
    });
    const ImageBands bands(place);
    std::vector<Sum> sums(static_cast<std::size_t>(bands.bands()));
    std::vector<double> frame(n_pixels);
    for (std::size_t f = 0; f < n_frames; ++f) {
        for (std::size_t p = 0; p < n_pixels; ++p) {
            frame[p] = images.difference(f, p);
        }
        bands.apply(frame);
        for (std::size_t p = 0; p < n_pixels; ++p) {
            sums[static_cast<std::size_t>(bands.band(p))].add(frame[p]);
        }
    }
    images.scales.clear();
    for (int band = 0; band < bands.bands(); ++band) {
        if (sums[static_cast<std::size_t>(band)].n > 0.0) {
            images.scales.emplace_back(bands.name(band), sums[static_cast<std::size_t>(band)].rms());
        }
    }
}

}  // namespace tiretherm::diagnosis
