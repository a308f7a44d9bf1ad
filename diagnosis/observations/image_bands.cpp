// SPDX-License-Identifier: BSD-3-Clause
// Builds the Haar transformation for an image with missing pixels, level by level, and applies it in place.

#include "diagnosis/observations/image_bands.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

namespace tiretherm::diagnosis {

namespace {

/// A block of pixels: where its sum stands, and how many they are.
struct Group {
    std::size_t entry = 0;
    double pixels = 1.0;
};
using Groups = std::map<std::pair<int, int>, Group>;

}  // namespace

ImageBands::ImageBands(const std::vector<std::pair<int, int>>& place) : band_(place.size(), 0) {
    Groups groups;
    for (std::size_t i = 0; i < place.size(); ++i) {
        groups[place[i]] = {.entry = i};
    }
    const auto join = [&](bool along_row) {
        Groups joined;
        for (const auto& [at, group] : groups) {
            const std::pair<int, int> above =
                along_row ? std::pair{at.first, at.second / 2} : std::pair{at.first / 2, at.second};
            const auto [partner, alone] = joined.try_emplace(above, group);
            if (!alone) {
                Group& other = partner->second;
                const double all = other.pixels + group.pixels;
                turns_.push_back({.sum = other.entry,
                                  .difference = group.entry,
                                  .cosine = std::sqrt(other.pixels / all),
                                  .sine = std::sqrt(group.pixels / all)});
                band_[group.entry] = bands_ - 1;
                other.pixels = all;
            }
        }
        groups = std::move(joined);
    };
    while (groups.size() > 1) {
        join(true);
        join(false);
        ++bands_;
    }
    if (!groups.empty()) {
        band_[groups.begin()->second.entry] = bands_ - 1;
    }
}

void ImageBands::apply(std::span<double> image) const {
    for (const Turn& turn : turns_) {
        const double a = image[turn.sum];
        const double b = image[turn.difference];
        image[turn.sum] = turn.cosine * a + turn.sine * b;
        image[turn.difference] = turn.cosine * b - turn.sine * a;
    }
}

std::string ImageBands::name(int band) const {
    return band + 1 == bands_ ? "mean of the frame" : fmt::format("differences over {} px", 1 << band);
}

}  // namespace tiretherm::diagnosis
