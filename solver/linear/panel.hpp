// SPDX-License-Identifier: BSD-3-Clause
// Panels: eight columns side by side, so that a product or a solve fetches each entry of a matrix once for all of them
// and keeps the processor's vectors full.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace tiretherm::solver {

inline constexpr std::size_t panel_width = 8;
/// What eight columns hold at a node, in the compiler's vectors. A panel is [n_nodes] of them.
struct alignas(64) PanelRow {
    using Half [[gnu::vector_size(32)]] = double;
    std::array<Half, 2> half;

    [[nodiscard]] double operator[](std::size_t column) const { return half[column / 4][column % 4]; }
    void set(std::size_t column, double value) { half[column / 4][column % 4] = value; }
    PanelRow& operator+=(const PanelRow& other) {
        half[0] += other.half[0];
        half[1] += other.half[1];
        return *this;
    }
    PanelRow& operator-=(const PanelRow& other) {
        half[0] -= other.half[0];
        half[1] -= other.half[1];
        return *this;
    }
    friend PanelRow operator*(double factor, const PanelRow& row) {
        return {{factor * row.half[0], factor * row.half[1]}};
    }
};
using Panel = std::span<PanelRow>;
using ConstPanel = std::span<const PanelRow>;

/// Takes columns that lie one after the other into a panel; zeros where there are fewer. @param columns [width][n]
inline void pack(std::span<const double> columns, Panel panel) {
    const std::size_t n = panel.size();
    const std::size_t width = columns.size() / n;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < panel_width; ++c) {
            panel[i].set(c, c < width ? columns[c * n + i] : 0.0);
        }
    }
}

/// The way back. @param columns [width][n], at most as many as the panel has
inline void unpack(ConstPanel panel, std::span<double> columns) {
    const std::size_t n = panel.size();
    for (std::size_t first = 0, c = 0; first < columns.size(); first += n, ++c) {
        for (std::size_t i = 0; i < n; ++i) {
            columns[first + i] = panel[i][c];
        }
    }
}

#if defined(__x86_64__)
template <typename Work>
[[gnu::target("avx2"), gnu::flatten]] void with_avx2(const Work& work) {
    work();
}
#endif

/// Calls the work, compiled for vectors of four numbers where this processor has them (AVX2). Without fused operations, so
/// that the result is the same to the last digit on any processor.
template <typename Work>
void in_wide_vectors(const Work& work) {
#if defined(__x86_64__)
    static const bool has_them = __builtin_cpu_supports("avx2") != 0;
    if (has_them) {
        with_avx2(work);
        return;
    }
#endif
    work();
}

}  // namespace tiretherm::solver
