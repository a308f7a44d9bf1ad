// SPDX-License-Identifier: BSD-3-Clause
// Made-up runs of the two-node bench with known parameters, for tests of coverage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "numerics/table_truth.hpp"
#include "two_node/programme_truth.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

/// Makes a programme from a seed, with a sample every so many seconds: draw_programme or draw_dull_programme.
using Maker = std::function<Programme(std::uint64_t seed, double interval)>;

/// Three logged runs of a bench whose numbers are known, as cases/practice/README.md says: scales normal about 1 with
/// 0.07, each lump's temperature at the start normal about the first air temperature with 2 K, noise of 0.5 K (camera)
/// and 0.3 K (probe).
struct MadeUpBench {
    double lambda_h = 1.0;
    double lambda_sel = 1.0;
    std::vector<double> surface_start;  ///< [n_runs] K off the first air temperature that was logged
    std::vector<double> bulk_start;
    std::vector<std::vector<Column>> logs;  ///< [n_runs]

    /// What a parameter of cases/practice truly is, in its unit.
    [[nodiscard]] double truth_of(const tiretherm::solver::FreeParameter& parameter) const;
};
/// @param causes what else goes on in the truth, and is missing in the case
[[nodiscard]] MadeUpBench make_up_bench(std::uint64_t seed, double interval, const Maker& maker = draw_programme,
                                        const std::vector<Cause>& causes = {});

/// The experiment that the program reads from a case and these logs, written to files as a user would.
[[nodiscard]] tiretherm::input::Experiment read_with(const std::filesystem::path& file,
                                                     const std::vector<std::vector<Column>>& logs);
/// cases/practice/two_node_bench.toml
[[nodiscard]] std::filesystem::path practice_case();

}  // namespace hidden_effects
