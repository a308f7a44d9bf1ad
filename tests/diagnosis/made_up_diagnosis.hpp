// SPDX-License-Identifier: BSD-3-Clause
// Hand-made diagnoses of every verdict, for tests of their reports.
#pragma once

#include "diagnosis/by_run/run_verdicts.hpp"
#include "diagnosis/detect/candidates.hpp"
#include "post/diagnosis/diagnosis_report.hpp"
#include "tests/diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis::sample {

/// A diagnosis of the practice bench that nobody made: every value is 0.5 K above the base model and on the extended
/// one, in white noise of 0.5 and 0.3 K.
struct MadeUp {
    input::Experiment experiment = practice_bench();
    Observations observations = observe(experiment);
    Diagnosis result;
    RunVerdicts by_run;

    explicit MadeUp(Verdict verdict) {
        result.verdict = verdict;
        result.base = observations.measured.array() - 0.5;
        result.extended = verdict == Verdict::consistent ? result.base : observations.measured;
        result.noise = {{.sigma = 0.5}, {.sigma = 0.3}};
        result.numerical_error_sigma = 0.4;
        result.simulations = 22;
        result.seconds = 3.1;
    }
    [[nodiscard]] post::DiagnosisRecord record() const {
        return {.experiment = experiment,
                .observations = observations,
                .result = result,
                .case_file = practice() / "two_node_bench.toml",
                .data = {},
                .warnings = {},
                .findings = {},
                .by_run = by_run};
    }
};

inline Cause sidewalls() {
    return {.id = "sidewall_convection",
            .numbers = {{.key = "conductance", .unit = "W K-1", .value = 8.1, .low = 7.2, .high = 9.0}},
            .sigma = 17.64,
            .gain = 155.6,
            .in_set = true,
            .rank = 1};
}
inline Cause gas() {
    return {.id = "inner_gas",
            .numbers = {{.key = "liner", .unit = "W K-1", .value = 9.0, .low = 8.0, .high = 10.0},
                        {.key = "rim", .unit = "W K-1", .value = 4.0, .low = 3.6, .high = 4.4}},
            .sigma = 17.1,
            .gain = 153.0,
            .in_set = true,
            .rank = 2};
}
inline Cause lag() {
    return {.id = "sensor_lag",
            .channel = "bulk_temperature",
            .numbers = {{.key = "tau", .unit = "s", .value = 12.0, .low = 9.0, .high = 15.0}},
            .sigma = 7.84,
            .gain = 40.0,
            .rank = 3};
}

/// A verdict of each kind, as full as it can be.
inline MadeUp named() {
    MadeUp one(Verdict::named);
    one.result.causes = {sidewalls(), lag()};
    one.result.hypotheses = {{0}};
    one.result.channels = {
        {.channel = 0, .rmse_before = 1.5, .rmse_after = 0.5, .heldout_before = 1.6, .heldout_after = 0.52},
        {.channel = 1, .rmse_before = 1.9, .rmse_after = 0.31, .heldout_before = 2.0, .heldout_after = 0.33}};
    one.result.gain = {
        .measured = true, .removable_removed = 0.97, .low = 0.93, .high = 0.99, .log_e = 12.0, .confirmed = true};
    return one;
}
inline MadeUp pair() {
    MadeUp one = named();
    one.result.causes[1].in_set = true;
    one.result.hypotheses = {{0, 1}};
    return one;
}
inline MadeUp confounded() {
    MadeUp one(Verdict::confounded);
    one.result.causes = {sidewalls(), gas(), lag()};
    one.result.hypotheses = {{0}, {1}, {1, 2}};
    one.result.next = {{.name = "coast-down from 150 km/h, 5 min", .now = 1.2, .then = 7.0}};
    return one;
}
inline MadeUp unknown() {
    MadeUp one(Verdict::unknown);
    one.result.unknown = UnknownSource{.place = "surface",
                                       .follows = "throttle",
                                       .unit = "1",
                                       .watts = 310.0,
                                       .low = 250.0,
                                       .high = 370.0,
                                       .per = 310.0,
                                       .sigma = 12.0,
                                       .alike = {"bulk, throttle"}};
    return one;
}
inline MadeUp consistent() {
    MadeUp one(Verdict::consistent);
    one.result.limits = {
        {.id = "sidewall_convection", .key = "conductance", .unit = "W K-1", .low = 0.0, .high = 0.8},
        {.id = "sensor_offset", .channel = "bulk_temperature", .key = "kelvin", .unit = "K", .low = -0.2, .high = 0.3},
        {.id = "sensor_lag", .channel = "surface_temperature", .key = "tau", .unit = "s", .low = 0.0, .high = 0.6},
        {.id = "sensor_lag", .channel = "bulk_temperature", .key = "tau", .unit = "s", .low = 0.0, .high = 2.1}};
    return one;
}
/// A search by prediction that took nothing: a lag that may be chance, a film that worsens a sensor, an emissivity at its end.
inline MadeUp nothing_predicts() {
    MadeUp one(Verdict::cannot_tell);
    one.result.extended = one.result.base;
    one.result.n_candidates = 42;
    Cause late = lag();
    late.channel = "surface_temperature";
    late.numbers.front() = {.key = "tau", .unit = "s", .value = 1.4, .low = 0.9, .high = 1.9};
    const auto number = [](const char* key, double value, double low, double high) {
        return CauseNumber{.key = key, .unit = "1", .value = value, .low = low, .high = high};
    };
    one.result.tried = {{.causes = {late},
                         .doubt = AdditionDoubt::may_be_chance,
                         .removed = 0.36,
                         .low = -0.04,
                         .high = 0.51,
                         .change = ChannelChange{.channel = 0, .before = 2.1, .after = 1.7, .low = -0.1, .high = 0.6}},
                        {.causes = {{.id = "convection_exponent", .numbers = {number("exponent", 0.7, 0.6, 0.8)}}},
                         .doubt = AdditionDoubt::worsens_channel,
                         .removed = 0.10,
                         .low = 0.02,
                         .high = 0.15,
                         .change = ChannelChange{.channel = 1, .before = 1.0, .after = 0.9, .low = 0.02, .high = 0.15}},
                        {.causes = {{.id = "camera_emissivity",
                                     .channel = "surface_temperature",
                                     .numbers = {number("emissivity", 0.8, 0.8, 0.8)}}},
                         .doubt = AdditionDoubt::end_of_range,
                         .removed = 0.0975},
                        {.causes = {gas()}, .doubt = AdditionDoubt::not_tested, .removed = 0.01}};
    one.result.model_error = {{.channel = 0, .size = 1.2, .time_scale = 2.0, .noise = 0.5}};
    one.result.next = {{.name = "coast-down from 150 km/h, 5 min", .now = 0.4, .then = 3.1}};
    one.result.told_apart = {"sensor_lag of surface_temperature", "convection_exponent"};
    return one;
}
inline MadeUp cannot_tell() {
    MadeUp one(Verdict::cannot_tell);
    one.result.extended = one.result.base;
    one.result.numerical_error_sigma = 5.3;
    return one;
}

}  // namespace tiretherm::diagnosis::sample
