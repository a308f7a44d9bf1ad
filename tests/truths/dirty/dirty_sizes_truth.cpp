// SPDX-License-Identifier: BSD-3-Clause
// How large each cause of a set is in the readings: the world with it less the world without it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "dirty/dirty_set_truth.hpp"

namespace hidden_effects {

namespace {

/// Readings of all runs and sensors that work, every second, run by run.
Eigen::VectorXd stacked(const DirtySet& set, const DirtyWorld& world, bool as_logged, std::vector<std::size_t>* ends) {
    const auto courses = dirty_courses(set, world, set.n_runs, as_logged);
    std::vector<double> all;
    for (std::size_t run = 0; run < set.n_runs; ++run) {
        for (std::size_t i = 0; i < world.sensors.size(); ++i) {
            if (set.world.sensors[i].stuck_from < 1e8) {
                continue;
            }
            const std::vector<double> log = dirty_log(world.sensors[i], courses[run][i], 1.0, 0);
            all.insert(all.end(), log.begin(), log.end());
        }
        if (ends != nullptr) {
            ends->push_back(all.size());
        }
    }
    return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

double rms(const Eigen::VectorXd& x) { return x.size() > 0 ? std::sqrt(x.squaredNorm() / double(x.size())) : 0.0; }

/// What the free numbers of the base model can change: film, loss or friction, and the starts.
Eigen::MatrixXd free_directions(const DirtySet& set, const Eigen::VectorXd& truth) {
    const auto n_columns = static_cast<Eigen::Index>(2 + 2 * set.n_runs);
    Eigen::MatrixXd directions(truth.size(), n_columns);
    DirtyWorld world = set.world;
    world.tire.lambda_h *= 1.02;
    directions.col(0) = stacked(set, world, false, nullptr) - truth;
    world = set.world;
    (set.loss_is_free ? world.tire.lambda_sel : world.tire.lambda_y) *= 1.02;
    directions.col(1) = stacked(set, world, false, nullptr) - truth;
    for (std::size_t run = 0; run < set.n_runs; ++run) {
        for (const bool surface : {true, false}) {
            DirtySet shifted = set;
            (surface ? shifted.shifts[run].first : shifted.shifts[run].second) += 1.0;
            directions.col(static_cast<Eigen::Index>(2 + 2 * run + (surface ? 0 : 1))) =
                stacked(shifted, set.world, false, nullptr) - truth;
        }
    }
    return directions;
}

}  // namespace

void measure_dirty_causes(DirtySet& set) {
    std::vector<std::size_t> ends;
    const Eigen::VectorXd truth = stacked(set, set.world, false, &ends);
    if (truth.size() == 0 || set.causes.empty()) {
        return;
    }
    const Eigen::MatrixXd directions = free_directions(set, truth);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(directions);
    for (DirtyCause& cause : set.causes) {
        DirtyWorld without = set.world;
        cause.remove(without);
        // A wrong input changes nothing in the tire, but what a model of it makes of the log.
        const bool of_input = cause.id == "road_temperature" || cause.id == "input_delay" ||
                              cause.id.find("_input_gain") != std::string::npos;
        Eigen::VectorXd difference = of_input
                                         ? stacked(set, set.world, true, nullptr) - stacked(set, without, true, nullptr)
                                         : truth - stacked(set, without, false, nullptr);
        cause.rms_left = rms(difference - directions * factors.solve(difference));
        std::size_t from = 0;
        for (const std::size_t end : ends) {
            const auto n = static_cast<Eigen::Index>(end - from);
            auto part = difference.segment(static_cast<Eigen::Index>(from), n);
            part.array() -= part.mean();
            from = end;
        }
        cause.rms = rms(difference);
    }
}

}  // namespace hidden_effects
