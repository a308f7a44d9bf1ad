// SPDX-License-Identifier: BSD-3-Clause
// Draws runs, parameters, hidden effect and noise of a data set from its seed.

#include "exam/exam_data_set_truth.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "exam/exam_confounded_truth.hpp"
#include "exam/exam_hiding_truth.hpp"
#include "exam/exam_signals_truth.hpp"

namespace hidden_effects {

namespace {

constexpr std::size_t n_runs = 3;
constexpr std::array<const char*, 8> words{"nothing",     "single", "pair",         "unknown",
                                           "unknown_odd", "decoy",  "dull_nothing", "dull_single"};

bool is_dull(Kind kind) { return kind == Kind::dull_nothing || kind == Kind::dull_single; }

RigProgramme draw_programme_of(const Rig& rig, Kind kind, std::uint64_t seed, double interval) {
    if (!is_dull(kind)) {
        return rig.draw(seed, interval);
    }
    RigProgramme dull;
    static_cast<Programme&>(dull) = draw_dull_programme(seed, interval);
    return dull;
}

/// No two kinds share a programme, nor do they with the fits of test_recovery_bench. @param run from 1 on, below 10
std::uint64_t seed_of_programme(Kind kind, std::uint64_t seed, std::uint64_t run) {
    return 1000000007ULL * (static_cast<std::uint64_t>(kind) + 1) + 10 * seed + run;
}

/// Adds a run that starts near the temperature of its air.
void add_programme(BenchRuns& runs, RigProgramme programme, Random& random) {
    const double air = programme.air_temperature.front();
    runs.programmes.push_back(std::move(programme));
    runs.of_run.emplace_back();
    for (const FreeNumber& number : runs.rig->of_run) {
        runs.of_run.back().push_back(air + number.expected + number.spread * random.normal());
    }
}

BenchRuns draw_runs(const Rig& rig, Kind kind, std::uint64_t seed, double interval, Random& random) {
    BenchRuns runs{.rig = &rig};
    for (const FreeNumber& number : rig.of_bench) {
        runs.of_bench.push_back(number.expected + number.spread * random.normal());
    }
    for (std::uint64_t run = 1; run <= n_runs; ++run) {
        add_programme(runs, draw_programme_of(rig, kind, seed_of_programme(kind, seed, run), interval), random);
    }
    return runs;
}

/// What the sensors of a data set's bench give, without noise.
Readings true_readings(const ExamDataSet& data_set) {
    const double tolerance = data_set.runs.rig->tolerance;
    if (!is_unknown(data_set.kind)) {
        return readings_of(data_set.runs, data_set.hidden, tolerance);
    }
    BenchRuns driven = data_set.runs;
    driven.programmes = driven_by(data_set.source, data_set.runs.programmes);
    return readings_of(driven, {{.id = data_set.source.id, .parameters = {{"watts", data_set.source.watts}}}},
                       tolerance);
}

/// Logs the next run as its sensors give it. @param trace without noise
void add_log(ExamDataSet& data_set, RigTrace trace, Random& noise) {
    const Rig& rig = *data_set.runs.rig;
    const RigProgramme& programme = data_set.runs.programmes[data_set.logs.size()];
    for (std::size_t c = 0; c < rig.channels.size(); ++c) {
        const std::vector<double> drawn = draw_noise(rig.channels[c].noise, programme.time, noise);
        std::transform(trace[c].begin(), trace[c].end(), drawn.begin(), trace[c].begin(), std::plus<>());
    }
    data_set.logs.push_back(rig.log(programme, trace));
}

}  // namespace

std::string word_of(Kind kind) { return words[static_cast<std::size_t>(kind)]; }

Kind kind_from(const std::string& word) {
    std::string all;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (word == words[i]) {
            return static_cast<Kind>(i);
        }
        all += std::string(i > 0 ? ", " : "") + words[i];
    }
    throw std::invalid_argument("no kind of data set is called '" + word + "'; there are " + all);
}

bool hides_nothing(Kind kind) { return kind == Kind::nothing || kind == Kind::decoy || kind == Kind::dull_nothing; }

bool is_unknown(Kind kind) { return kind == Kind::unknown || kind == Kind::unknown_odd; }

ExamDataSet draw_data_set(Kind kind, double sigma, std::uint64_t seed, double interval, const Rig& rig) {
    if (!rig.every_kind && kind > Kind::unknown) {
        throw std::invalid_argument("the bench " + rig.name +
                                    " has data sets of nothing, single, pair and unknown, none of " + word_of(kind));
    }
    Random random(1000003ULL * seed + static_cast<std::uint64_t>(kind));
    ExamDataSet data_set{.kind = kind,
                         .seed = seed,
                         .sigma = hides_nothing(kind) ? 0.0 : sigma,
                         .runs = draw_runs(rig, kind, seed, interval > 0.0 ? interval : rig.interval, random),
                         .hidden = {},
                         .oracle = {}};
    Random noise(2000003ULL * seed + static_cast<std::uint64_t>(kind) + 500);
    if (!hides_nothing(kind)) {
        data_set.oracle_of_runs = std::make_shared<Oracle>(data_set.runs);
        bool hidden = false;
        for (int draw = 0; draw < 200 && !hidden; ++draw) {
            hidden = is_unknown(kind) ? hide_source(data_set, random) : hide_causes(data_set, random);
        }
        if (!hidden) {
            throw std::runtime_error("nothing can be hidden at " + std::to_string(sigma) + " standard deviations in " +
                                     word_of(kind) + " of seed " + std::to_string(seed));
        }
    }
    if (kind == Kind::pair && rig.finds_twins) {
        data_set.confounded = nearest_confounded(data_set);
    }
    for (RigTrace& trace : true_readings(data_set)) {
        add_log(data_set, std::move(trace), noise);
    }
    if (kind == Kind::decoy) {
        add_decoys(data_set.logs, data_set.runs.programmes, random);
    }
    return data_set;
}

void add_run(ExamDataSet& data_set, const Drive& drive) {
    const std::size_t run = data_set.runs.programmes.size();
    RigProgramme programme;
    static_cast<Programme&>(programme) =
        drive_programme(drive, seed_of_programme(data_set.kind, data_set.seed, run + 1));
    Random random(3000017ULL * data_set.seed + 10 * run + static_cast<std::uint64_t>(data_set.kind));
    add_programme(data_set.runs, std::move(programme), random);
    add_log(data_set, readings_of_run(data_set.runs, run, data_set.hidden, data_set.runs.rig->tolerance), random);
}

std::string answer_of(const ExamDataSet& data_set) {
    if (is_unknown(data_set.kind)) {
        std::string follows;
        for (const std::string& signal : data_set.source.signals) {
            follows += (follows.empty() ? "" : " x ") + signal;
        }
        if (follows.empty()) {
            follows = "a time window";
        }
        return "heat after " + follows + " in the " + data_set.source.place;
    }
    std::string names;
    for (const Cause& cause : data_set.hidden) {
        names += (names.empty() ? "" : " + ") + name_of(cause);
    }
    return names.empty() ? "nothing" : names;
}

}  // namespace hidden_effects
