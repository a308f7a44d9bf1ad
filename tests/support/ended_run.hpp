// SPDX-License-Identifier: BSD-3-Clause
// A run with all that it showed, and what every run owes: finite numbers, a closed ledger, and a sentence where it fails.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "solver/system.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm::support {

inline constexpr double coldest_kelvin = 233.15;  ///< -40 degC
inline constexpr double hottest_kelvin = 573.15;  ///< 300 degC

/// How a run went: its field at the end, and all that it showed.
struct EndedRun {
    solver::MarchReport report;
    std::vector<double> field;
    double coldest = std::numeric_limits<double>::infinity();
    double hottest = -std::numeric_limits<double>::infinity();
    bool finite = true;

    [[nodiscard]] bool ok() const { return report.status.ok(); }
};

inline EndedRun run_to_its_end(const solver::Problem& problem) {
    EndedRun result;
    EXPECT_EQ(solver::defects(problem), std::vector<std::string>{});
    result.report = solver::run(problem, [&](const solver::Snapshot& now) {
        result.field.assign(now.temperature.begin(), now.temperature.end());
        for (const double T : now.temperature) {
            result.finite = result.finite && std::isfinite(T);
            result.coldest = std::min(result.coldest, T);
            result.hottest = std::max(result.hottest, T);
        }
        for (const double watts : now.watts) {
            result.finite = result.finite && std::isfinite(watts);
        }
        return true;
    });
    return result;
}

/// Largest difference of two fields, not a number where they have not as many nodes. K
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = a.size() == b.size() ? 0.0 : std::nan("");
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return worst;
}

/// Largest value of a law where a run may be. Its quadratics are to be convex.
inline double largest_value(const physics::Curve& law) {
    return law.is_table() ? std::ranges::max(law.table_y())
                          : std::max(law.value(coldest_kelvin), law.value(hottest_kelvin));
}

/// The ledger closes: heat stored less heat attributed is nothing beside the heat turned over, but for the last digit of
/// every temperature: times its largest heat capacity in each stage, and times its films as long as the run.
inline void expect_closed(const solver::Problem& problem, const EndedRun& run) {
    solver::System system(problem);
    const solver::MarchReport& report = run.report;
    const bool steady = problem.settings.steady;
    const auto sum = [](const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); };
    const double open = std::abs(steady ? sum(report.watts) : report.stored - sum(report.joules));
    const double turnover = report.energy_closure > 0.0 ? open / report.energy_closure : 0.0;
    std::vector<double> coefficients(system.n_coefficients());
    system.evaluate_coefficients(problem.input_signals.at(problem.settings.end, solver::JumpSide::before),
                                 coefficients);
    system.evaluate(run.field, coefficients);
    const double stages = 2.0 * static_cast<double>(report.steps);
    double last_digits = 0.0;
    for (std::size_t i = 0; i < run.field.size(); ++i) {
        const int layer = problem.mesh.layer[i];
        const double capacity =
            layer < 0 ? system.capacity(i, run.field[i])
                      : problem.mesh.volume[i] * problem.materials[static_cast<std::size_t>(layer)].density *
                            largest_value(problem.materials[static_cast<std::size_t>(layer)].heat_capacity);
        const double film = system.terms().node_G[i];
        last_digits += 1.1e-16 * run.field[i] * (steady ? film : stages * capacity + report.simulated * film);
    }
    EXPECT_LE(open, energy_closure * turnover + 10.0 * last_digits)
        << turnover << " turned over, closes to " << report.energy_closure;
}

/// The run ended well, or with a sentence that names time, place and effect; either way with numbers.
/// @returns whether it ended well
inline bool expect_sound(const solver::Problem& problem, const EndedRun& run) {
    EXPECT_TRUE(run.finite);
    const std::string& message = run.report.status.message;
    if (!run.ok()) {
        EXPECT_NE(message.find(" at t = "), std::string::npos) << message;
        EXPECT_NE(message.find(", in "), std::string::npos) << message;
        EXPECT_NE(message.find("largest heat source there: "), std::string::npos) << message;
        return false;
    }
    expect_closed(problem, run);
    return true;
}

}  // namespace tiretherm::support
