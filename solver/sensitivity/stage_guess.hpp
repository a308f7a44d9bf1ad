// SPDX-License-Identifier: BSD-3-Clause
// First guess of what a stage of a step makes of sensitivities: straight on.
#pragma once

#include <vector>

#include "mesh/index.hpp"
#include "solver/time_integration/tableau.hpp"

namespace tiretherm::solver {

/// First guess of an implicit stage: straight on from the last step, then along the stages found so far.
/// @param S [stages][...] values at the stages, those before this one known
/// @param before values at the last but one stage of the step before  @param last_width of that step, s; 0: there is none
inline void guess_stage(const Tableau& method, int stage, double dt, double last_width,
                        std::vector<std::vector<double>>& S, const std::vector<double>& before) {
    std::vector<double>& out = S[at(stage)];
    const std::vector<double>& now = S.front();
    if (stage == 1) {
        const double c = method.c[at(method.stages) - 2];
        const double rate = last_width > 0.0 ? method.c[1] * dt / ((1.0 - c) * last_width) : 0.0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] = now[i] + rate * (now[i] - before[i]);
        }
        return;
    }
    const double rate = method.c[at(stage)] / method.c[1];
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = now[i] + rate * (S[1][i] - now[i]);
    }
}

}  // namespace tiretherm::solver
