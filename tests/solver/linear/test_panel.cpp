// SPDX-License-Identifier: BSD-3-Clause
// Panels: what eight columns give side by side is what each gives alone, to the last digit, whatever vectors the processor has.

#include <gtest/gtest.h>

#include "solver/linear/matrix.hpp"
#include "tests/solver/linear/diffusion_matrix.hpp"

namespace tiretherm::solver {

// B - M X, entry by entry in the order of the row, as plain numbers: no operation is fused, no sum is taken in another order.
TEST(Panel, ResidualHasTheDigitsOfOneColumn) {
    const mesh::Mesh mesh = cube(4);
    const Pattern pattern = pattern_of(mesh);
    const Matrix matrix = diffusion(mesh, pattern, 0.3);
    const auto n = static_cast<std::size_t>(pattern.n);
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<double> B(5 * n);  // fewer columns than a panel has
    std::vector<double> X(5 * n);
    for (std::size_t i = 0; i < B.size(); ++i) {
        B[i] = any(random);
        X[i] = any(random);
    }
    std::vector<PanelRow> b(n);
    std::vector<PanelRow> x(n);
    std::vector<PanelRow> r(n);
    pack(B, b);
    pack(X, x);
    matrix.find_residual(b, x, r);
    for (std::size_t c = 0; c < panel_width; ++c) {
        for (std::size_t i = 0; i < n; ++i) {
            double expected = c < 5 ? B[c * n + i] : 0.0;
            for (int e = pattern.start[i]; c < 5 && e < pattern.start[i + 1]; ++e) {
                const auto at = static_cast<std::size_t>(e);
                const double product = matrix.value[at] * X[c * n + static_cast<std::size_t>(pattern.column[at])];
                expected -= product;
            }
            ASSERT_EQ(r[i][c], expected) << "column " << c << ", node " << i;
        }
    }
    std::vector<double> back(5 * n);
    unpack(x, back);
    EXPECT_EQ(back, X);
}

}  // namespace tiretherm::solver
