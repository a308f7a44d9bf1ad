// SPDX-License-Identifier: BSD-3-Clause
// Figures of one compared channel: bias and scatter over all runs, by run and by driving phase, model uncertainty, and
// association with each signal.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnosis/compare/comparison.hpp"

namespace tiretherm::diagnosis {

namespace {

Pieces differences_of(const ComparedChannel& channel) {
    Pieces pieces;
    for (const ComparedSeries& series : channel.series) {
        pieces.push_back(series.difference());
    }
    return pieces;
}

/// Stretches of the series in one phase, each a piece of its own.
std::vector<PhaseFigures> phases_of(const std::vector<const ComparedSeries*>& all) {
    struct Stretches {
        Pieces pieces{};
        double time = 0.0;
    };
    std::array<Stretches, phases.size()> found;
    for (const ComparedSeries* one : all) {
        const ComparedSeries& series = *one;
        const std::vector<double> difference = series.difference();
        const auto interval = [&](std::size_t to) {  // from the sample before; a gap counts as nothing
            const bool is_known = to > 0 && to < series.time.size() && !is_gap(series.time, to);
            return is_known ? series.time[to] - series.time[to - 1] : 0.0;
        };
        double before = 0.0;
        for (std::size_t i = 0; i < series.time.size(); ++i) {
            Stretches& own =
                found[static_cast<std::size_t>(std::ranges::find(phases, series.phase[i]) - phases.begin())];
            if (i == 0 || series.phase[i - 1] != series.phase[i]) {
                own.pieces.emplace_back();
            }
            own.pieces.back().push_back(difference[i]);
            // A sample stands for half the interval on either side.
            const double after = interval(i + 1);
            own.time += 0.5 * (before + after);
            before = after;
        }
    }
    double whole = 0.0;
    for (const Stretches& one : found) {
        whole += one.time;
    }
    std::vector<PhaseFigures> result;
    for (std::size_t p = 0; p < phases.size(); ++p) {
        if (!found[p].pieces.empty()) {
            result.push_back({.phase = phases[p],
                              .share = whole > 0.0 ? found[p].time / whole : 1.0,
                              .figures = figures(found[p].pieces)});
        }
    }
    return result;
}

/// Figures of each lap of which a series has samples.
std::vector<LapFigures> laps_of(const ComparedChannel& channel, const std::vector<std::vector<input::Lap>>& laps) {
    std::vector<LapFigures> result;
    for (const ComparedSeries& series : channel.series) {
        const std::vector<double> difference = series.difference();
        for (const input::Lap& lap : series.run < laps.size() ? laps[series.run] : std::vector<input::Lap>{}) {
            const auto first = std::ranges::lower_bound(series.time, lap.start) - series.time.begin();
            const auto last = std::ranges::lower_bound(series.time, lap.end) - series.time.begin();
            const auto own = [&](const std::vector<double>& all) {
                return std::vector<double>(all.begin() + first, all.begin() + last);
            };
            if (first < last) {
                result.push_back({.run = series.run,
                                  .lap = lap,
                                  .figures = figures({own(difference)}),
                                  .measured = values_of(own(series.measured)),
                                  .simulated = values_of(own(series.simulated))});
            }
        }
    }
    return result;
}

/// Figures of each corner, in the order of their first runs.
std::vector<CornerFigures> corners_of(const ComparedChannel& channel) {
    std::vector<CornerFigures> corners;
    for (const ComparedSeries& first : channel.series) {
        if (first.corner.empty() || std::ranges::find(corners, first.corner, &CornerFigures::corner) != corners.end()) {
            continue;
        }
        std::vector<const ComparedSeries*> own;
        Pieces differences;
        for (const ComparedSeries& series : channel.series) {
            if (series.corner == first.corner) {
                own.push_back(&series);
                differences.push_back(series.difference());
            }
        }
        corners.push_back({.corner = first.corner, .figures = figures(differences), .phases = phases_of(own)});
    }
    return corners;
}

/// Differences of a channel, and what is found of them once for all regressors.
struct Differences {
    Pieces all;
    double together = correlated_samples(all);  ///< as `bins` takes it
    Autocovariance covariance{all};
};

/// @param values of the regressor, beside all differences
RegressorFigures against(Pieces values, Differences& differences) {
    const auto is_missing = [](double value) { return std::isnan(value); };
    if (std::ranges::none_of(values, [&](const auto& piece) { return std::ranges::any_of(piece, is_missing); })) {
        return {.name = {},
                .unit = {},
                .association = association(values, differences.all, differences.covariance),
                .bins = bins(values, differences.all, differences.together)};
    }
    Pieces known(values.size());
    for (std::size_t s = 0; s < values.size(); ++s) {
        for (std::size_t i = 0; i < values[s].size(); ++i) {
            if (!is_missing(values[s][i])) {
                known[s].push_back(differences.all[s][i]);
            }
        }
        std::erase_if(values[s], is_missing);
    }
    return {.name = {},
            .unit = {},
            .association = association(values, known),
            .bins = bins(values, known, correlated_samples(known))};
}

}  // namespace

void evaluate(ComparedChannel& channel, const std::vector<std::pair<std::string, std::string>>& regressors,
              const std::vector<std::vector<input::Lap>>& laps) {
    const Pieces differences = differences_of(channel);
    channel.figures = figures(differences);
    Pieces times;
    std::vector<double> measured;
    std::vector<double> simulated;
    for (std::size_t s = 0; s < channel.series.size(); ++s) {
        const ComparedSeries& series = channel.series[s];
        channel.runs.push_back({.run = series.run,
                                .figures = figures({differences[s]}),
                                .corner = series.corner,
                                .measured = values_of(series.measured),
                                .simulated = values_of(series.simulated)});
        times.push_back(series.time);
        for (std::size_t i = 0; i < series.time.size(); ++i) {
            if (!std::isnan(series.surroundings[i])) {
                measured.push_back(series.measured[i] - series.surroundings[i]);
                simulated.push_back(series.simulated[i] - series.surroundings[i]);
            }
        }
    }
    channel.noise = sample_to_sample_noise(times, differences);
    if (!channel.sensor_is_stated) {
        channel.sensor = std::isnan(channel.noise) ? 0.0 : channel.noise;
    }
    channel.model = model_uncertainty(channel.figures, measured, simulated, channel.sensor);
    std::vector<const ComparedSeries*> all;
    for (const ComparedSeries& series : channel.series) {
        all.push_back(&series);
    }
    channel.phases = phases_of(all);
    channel.laps = laps_of(channel, laps);
    channel.corners = corners_of(channel);
    channel.common = common_biases(channel.corners);
    Differences of_all{.all = differences};
    for (std::size_t r = 0; r < regressors.size(); ++r) {
        Pieces values;
        std::ranges::transform(channel.series, std::back_inserter(values),
                               [&](ComparedSeries& series) { return std::move(series.regressor[r]); });
        RegressorFigures found = against(std::move(values), of_all);
        if (found.bins.size() > 1 && found.association.correlation != 0.0) {  // the signal varies
            std::tie(found.name, found.unit) = regressors[r];
            channel.regressors.push_back(std::move(found));
        }
    }
    std::stable_sort(channel.regressors.begin(), channel.regressors.end(),
                     [](const RegressorFigures& a, const RegressorFigures& b) {
                         return std::abs(a.association.sigmas) > std::abs(b.association.sigmas);
                     });
    channel.significant = 0.05 / static_cast<double>(std::max<std::size_t>(1, channel.regressors.size()));
}

}  // namespace tiretherm::diagnosis
