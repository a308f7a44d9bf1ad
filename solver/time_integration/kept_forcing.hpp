// SPDX-License-Identifier: BSD-3-Clause
// What the inputs do over the steps of a march, for a second march that takes the same steps.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

/// Coefficients at the stages of steps that span logged samples. They do not depend on temperatures, and to find them costs more than
/// to solve a small tire. Kept up to 32 MB; steps beyond are averaged again.
class KeptForcing {
public:
    using Stages = std::vector<std::vector<double>>;  ///< [stages][n_coefficients]

    /// While the first march tries steps: of those that begin at one time the last is kept.
    void keep(double begin, double end, const Stages& stages);
    /// From here on steps are taken, ascending.
    void close() { is_closed_ = true; }
    [[nodiscard]] bool is_closed() const { return is_closed_; }
    /// @returns whether there is one; only then `stages` is filled
    [[nodiscard]] bool take(double begin, double end, Stages& stages);

private:
    struct Step {
        double begin = 0.0;  ///< s
        double end = 0.0;
        std::size_t first = 0;  ///< in values_
    };
    std::vector<Step> steps_;
    std::vector<double> values_;
    std::size_t next_ = 0;
    bool is_closed_ = false;
};

/// A run whose steps are kept.
[[nodiscard]] MarchReport run(const Problem& problem, const Observer& observer, KeptForcing& kept);

}  // namespace tiretherm::solver
