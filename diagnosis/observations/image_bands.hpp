// SPDX-License-Identifier: BSD-3-Clause
// Orthogonal Haar wavelet transformation of images with missing pixels (Mallat, IEEE Trans. Pattern Anal. 11 (1989)
// 674), with noise of equal size within each band (Wornell, Proc. IEEE 81 (1993) 1428).
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tiretherm::diagnosis {

/// An image taken apart by size: differences of neighbouring pixels, of neighbouring blocks of 2 by 2, of 4 by 4 ..., and
/// the mean of the whole. It is an orthogonal transformation, Haar's wavelets on whatever pixels there are (two blocks of
/// n and m living pixels make their mean and, with weights that keep lengths, their difference), so that white noise of
/// the pixels is white noise of the same size in every band. What neighbouring pixels have in common, a drift of the
/// camera or a missing effect, stays in the coarse bands, where it is few numbers and not thousands. Source: Mallat,
/// IEEE Trans. Pattern Anal. 11 (1989) 674; noise that is alike within a band and independent between bands: Wornell,
/// Proc. IEEE 81 (1993) 1428.
class ImageBands {
public:
    /// @param place row and column of each pixel, none twice
    explicit ImageBands(const std::vector<std::pair<int, int>>& place);

    /// @param image [n_pixels] in: pixels, out: differences and the mean, sqrt(n_pixels) times as large
    void apply(std::span<double> image) const;
    [[nodiscard]] int bands() const { return bands_; }
    [[nodiscard]] std::size_t entries() const { return band_.size(); }
    /// Band of an entry after `apply`: 0 the finest, bands() - 1 the mean of the whole.
    [[nodiscard]] int band(std::size_t entry) const { return band_[entry]; }
    /// "differences over 4 px", "mean of the frame".
    [[nodiscard]] std::string name(int band) const;

private:
    /// Two entries become their sum and their difference.
    struct Turn {
        std::size_t sum;
        std::size_t difference;
        double cosine;
        double sine;
    };
    std::vector<Turn> turns_;
    std::vector<int> band_;
    int bands_ = 1;
};

}  // namespace tiretherm::diagnosis
