// SPDX-License-Identifier: BSD-3-Clause
// Takes the stack of observations apart by run and channel.
#include "post/page/observed_series.hpp"

#include <map>

namespace tiretherm::post {

std::vector<MeasuredSeries> observed_series(const input::Experiment& experiment,
                                            const diagnosis::Observations& observations,
                                            const std::vector<std::pair<std::string, const Eigen::VectorXd*>>& models) {
    std::map<std::pair<std::size_t, std::size_t>, MeasuredSeries> found;  // by run and channel
    for (std::size_t i = 0; i < observations.rows.size(); ++i) {
        const diagnosis::Observations::Row& row = observations.rows[i];
        if (row.image >= 0) {
            continue;
        }
        MeasuredSeries& series = found[{row.run, row.channel}];
        if (series.time.empty()) {
            const solver::Channel& channel = experiment.runs[row.run].problem.channels[row.channel];
            series.channel = channel.name;
            series.unit = solver::shown_unit(channel.quantity);
            series.run = experiment.runs[row.run].name;
            for (const auto& [name, simulated] : models) {
                series.models.push_back({.name = name, .simulated = {}});
            }
        }
        const auto k = static_cast<Eigen::Index>(i);
        series.time.push_back(observations.times[row.run][row.time]);
        series.measured.push_back(observations.measured[k]);
        for (std::size_t m = 0; m < models.size(); ++m) {
            series.models[m].simulated.push_back((*models[m].second)[k]);
        }
    }
    std::vector<MeasuredSeries> all;
    for (auto& [place, series] : found) {
        all.push_back(std::move(series));
    }
    return all;
}

}  // namespace tiretherm::post
