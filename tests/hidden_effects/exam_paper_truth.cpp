#include "exam_paper_truth.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "exam_hiding_truth.hpp"
#include "exam_signals_truth.hpp"

namespace hidden_effects {

namespace {

constexpr std::size_t n_runs = 3;
constexpr std::array<const char*, 8> words{"nothing",     "single", "pair",         "unknown",
                                           "unknown_odd", "decoy",  "dull_nothing", "dull_single"};

bool is_dull(Kind kind) { return kind == Kind::dull_nothing || kind == Kind::dull_single; }

BenchRuns draw_runs(Kind kind, std::uint64_t seed, double interval, Random& random) {
    BenchRuns runs{.lambda_h = 1.0 + 0.07 * random.normal(),
                   .lambda_sel = 1.0 + 0.07 * random.normal(),
                   .surface_start = {},
                   .bulk_start = {},
                   .programmes = {}};
    for (std::uint64_t run = 1; run <= n_runs; ++run) {
        // No two kinds share a programme, nor do they with the fits of test_recovery_bench.
        const std::uint64_t of_run = 1000000007ULL * (static_cast<std::uint64_t>(kind) + 1) + 10 * seed + run;
        runs.programmes.push_back(is_dull(kind) ? draw_dull_programme(of_run, interval)
                                                : draw_programme(of_run, interval));
        const double air = runs.programmes.back().air_temperature.front();
        runs.surface_start.push_back(air + 2.0 * random.normal());
        runs.bulk_start.push_back(air + 2.0 * random.normal());
    }
    return runs;
}

/// What the sensors of a paper's bench give, without noise.
Readings true_readings(const Paper& paper) {
    if (!is_unknown(paper.kind)) {
        return readings_of(paper.runs, paper.hidden);
    }
    BenchRuns driven = paper.runs;
    driven.programmes = driven_by(paper.source, paper.runs.programmes);
    return readings_of(driven,
                       {{.id = "unknown_" + paper.source.place, .parameters = {{"watts", paper.source.watts}}}});
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
    throw std::invalid_argument("no kind of paper is called '" + word + "'; there are " + all);
}

bool hides_nothing(Kind kind) { return kind == Kind::nothing || kind == Kind::decoy || kind == Kind::dull_nothing; }

bool is_unknown(Kind kind) { return kind == Kind::unknown || kind == Kind::unknown_odd; }

Paper draw_paper(Kind kind, double sigma, std::uint64_t seed, double interval) {
    Random random(1000003ULL * seed + static_cast<std::uint64_t>(kind));
    Paper paper{.kind = kind,
                .seed = seed,
                .sigma = hides_nothing(kind) ? 0.0 : sigma,
                .runs = draw_runs(kind, seed, interval, random),
                .hidden = {},
                .oracle = {}};
    Random noise(2000003ULL * seed + static_cast<std::uint64_t>(kind) + 500);
    bool hidden = hides_nothing(kind);
    if (is_unknown(kind)) {
        for (int draw = 0; draw < 200 && !hidden; ++draw) {
            hidden = hide_source(paper, random);
        }
    } else if (!hidden) {
        const Oracle oracle(paper.runs);
        for (int draw = 0; draw < 200 && !hidden; ++draw) {
            hidden = hide_causes(paper, oracle, random);
        }
    }
    if (!hidden) {
        throw std::runtime_error("nothing can be hidden at " + std::to_string(sigma) + " standard deviations in " +
                                 word_of(kind) + " of seed " + std::to_string(seed));
    }
    Readings readings = true_readings(paper);
    const auto add = [&](std::vector<double>& values, const Noise& of, const std::vector<double>& times) {
        const std::vector<double> drawn = draw_noise(of, times, noise);
        std::transform(values.begin(), values.end(), drawn.begin(), values.begin(), std::plus<>());
    };
    for (std::size_t run = 0; run < n_runs; ++run) {
        const Programme& programme = paper.runs.programmes[run];
        add(readings[run].surface, camera_noise, programme.time);
        add(readings[run].bulk, probe_noise, programme.time);
        paper.logs.push_back(bench_columns(programme, readings[run]));
    }
    if (kind == Kind::decoy) {
        add_decoys(paper.logs, paper.runs.programmes, random);
    }
    return paper;
}

std::string answer_of(const Paper& paper) {
    if (is_unknown(paper.kind)) {
        std::string follows;
        for (const std::string& signal : paper.source.signals) {
            follows += (follows.empty() ? "" : " x ") + signal;
        }
        if (follows.empty()) {
            follows = "a time window";
        }
        return "heat after " + follows + " in the " + paper.source.place;
    }
    std::string names;
    for (const Cause& cause : paper.hidden) {
        names += (names.empty() ? "" : " + ") + cause.id + (cause.channel.empty() ? "" : " of " + cause.channel);
    }
    return names.empty() ? "nothing" : names;
}

}  // namespace hidden_effects
