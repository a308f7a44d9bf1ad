#include "exam_paper_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "exam_signals_truth.hpp"

namespace hidden_effects {

namespace {

constexpr std::size_t n_runs = 3;
constexpr double least_apart = 0.9;  ///< a correlation beyond which two things are one to the exam
constexpr std::array<const char*, 8> words{"nothing",     "single", "pair",         "unknown",
                                           "unknown_odd", "decoy",  "dull_nothing", "dull_single"};

bool is_dull(Kind kind) { return kind == Kind::dull_nothing || kind == Kind::dull_single; }

/// Share of all samples that are faster than a speed. @param speed km/h
double faster_than(const BenchRuns& runs, double speed) {
    double faster = 0.0;
    double all = 0.0;
    for (const Programme& programme : runs.programmes) {
        for (const double V : programme.speed) {
            faster += 3.6 * V > speed ? 1.0 : 0.0;
            all += 1.0;
        }
    }
    return faster / all;
}

/// Where a standing wave begins, km/h, so that a twentieth of the samples is 10 km/h beyond; 0 where there is none.
double draw_critical_speed(const BenchRuns& runs, Random& random) {
    for (int i = 0; i < 20; ++i) {
        const double speed = std::round(random.uniform(100.0, 170.0));
        if (faster_than(runs, speed + 10.0) >= 0.05) {
            return speed;
        }
    }
    return 0.0;
}

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

/// A cause with the number at which it shows as wanted, and what it leaves behind.
struct Sized {
    Cause cause;
    Eigen::VectorXd left;
};

/// Draws a cause. @returns nothing, with the reason in `rejected`, where that size is not physical
std::optional<Sized> draw_cause(const Oracle& oracle, double sigma, Random& random,
                                std::vector<std::string>& rejected) {
    const std::vector<Variant>& variants = single_variants();
    const Variant& variant =
        variants[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(variants.size())))];
    const double sign = random.uniform() < 0.5 || !variant.both_ways() ? 1.0 : -1.0;
    const double critical_speed = draw_critical_speed(oracle.runs(), random);
    if (variant.id == "standing_wave" && critical_speed == 0.0) {
        rejected.push_back(variant.name() + ": too slow for a wave");
        return std::nullopt;
    }
    const std::optional<double> number = number_for(oracle, variant, sign, sigma, critical_speed);
    if (!number) {
        rejected.push_back(variant.name() + ": not physical at that size");
        return std::nullopt;
    }
    Cause cause = cause_of(variant, *number, critical_speed);
    Eigen::VectorXd left = oracle.left_by({cause});
    return Sized{.cause = std::move(cause), .left = std::move(left)};
}

/// Every single cause beside what is hidden, at the size at which it shows as well, or as large as it can be.
std::vector<Likeness> likenesses(const Oracle& oracle, const Eigen::VectorXd& hidden, double critical_speed) {
    std::vector<Likeness> alike;
    for (const Variant& variant : single_variants()) {
        const auto left_by = [&](double step) {
            return oracle.left_by({cause_of(variant, variant.absent + step, critical_speed)});
        };
        Eigen::VectorXd left = left_by(variant.typical);
        if (left.norm() < 1e-3) {
            continue;
        }
        const double room = (variant.typical > 0.0 ? variant.high : variant.low) - variant.absent;
        const double step = variant.typical * hidden.norm() / left.norm();
        left = left_by(std::abs(step) < std::abs(room) ? step : room);
        alike.push_back({.variant = &variant, .correlation = correlation(hidden, left)});
    }
    std::ranges::sort(alike, {}, [](const Likeness& one) {
        return -(one.variant->both_ways() ? std::abs(one.correlation) : one.correlation);
    });
    return alike;
}

double critical_speed_of(const std::vector<Cause>& hidden) {
    for (const Cause& cause : hidden) {
        if (cause.id == "standing_wave") {
            return cause.parameters.at("critical_speed");
        }
    }
    return 140.0;
}

/// Hides causes of the catalogue. @returns false where this draw is given up
bool hide_causes(Paper& paper, const Oracle& oracle, Random& random) {
    std::vector<Sized> drawn;
    for (std::size_t i = 0; i < (paper.kind == Kind::pair ? 2U : 1U); ++i) {
        std::optional<Sized> one = draw_cause(oracle, paper.sigma, random, paper.rejected);
        if (!one) {
            return false;
        }
        drawn.push_back(std::move(*one));
    }
    Eigen::VectorXd left = drawn.front().left;
    if (drawn.size() == 2) {
        if (std::abs(correlation(left, drawn.back().left)) >= least_apart) {
            paper.rejected.push_back(drawn[0].cause.id + " and " + drawn[1].cause.id + ": look alike");
            return false;
        }
        left = oracle.left_by({drawn[0].cause, drawn[1].cause});
    }
    for (const Sized& one : drawn) {
        paper.hidden.push_back(one.cause);
        paper.oracle.push_back(one.left.norm());
    }
    paper.alike = likenesses(oracle, left, critical_speed_of(paper.hidden));
    return true;
}

/// Hides heat that no effect explains. @returns false where this draw is given up
bool hide_source(Paper& paper, Random& random) {
    const HiddenSource source = draw_source(paper.kind, n_runs, random);
    const Variant watts{.id = "unknown_" + source.place, .key = "watts", .typical = 30.0, .high = 2000.0};
    BenchRuns driven = paper.runs;
    driven.programmes = driven_by(source, paper.runs.programmes);
    const Oracle oracle(driven);
    const std::optional<double> number = number_for(oracle, watts, 1.0, paper.sigma, 0.0);
    if (!number) {
        paper.rejected.emplace_back("a source: not physical at that size");
        return false;
    }
    const Cause cause = cause_of(watts, *number, 0.0);
    const Eigen::VectorXd left = oracle.left_by({cause});
    std::vector<Likeness> alike = likenesses(oracle, left, 140.0);
    if (std::abs(alike.front().correlation) >= least_apart) {
        paper.rejected.push_back("a source: looks like " + alike.front().variant->name());
        return false;
    }
    paper.source = source;
    paper.source.watts = *number;
    paper.oracle = {left.norm()};
    paper.alike = std::move(alike);
    return true;
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
