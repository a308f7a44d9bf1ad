// SPDX-License-Identifier: BSD-3-Clause
// One speed, one load, and a probe in the bulk alone: what it sees are combinations of film, loss and link. Heat that
// leaves the bulk passes the link and the film one after the other, so that the probe sees little but their sum, and of
// where the surface started nothing is left after a minute. What the data do not see is to be named, and nothing that is
// said with an interval may be false.
#include <algorithm>

#include <gtest/gtest.h>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/identification.hpp"
#include "diagnosis/practice_bench.hpp"
#include "hidden_effects/made_up_bench.hpp"
#include "input/measurements/measured_bench.hpp"
#include "support/coverage.hpp"

namespace hidden_effects {

namespace {

namespace input = tiretherm::input;
namespace diagnosis = tiretherm::diagnosis;
namespace sample = tiretherm::diagnosis::sample;
using diagnosis::Identifiability;

/// The practice case with the link's conductivity free too, without runs of its own.
std::string free_case(bool with_priors) {
    std::string text = sample::practice_text();
    text = text.substr(0, text.find("[[run]]"));
    if (!with_priors) {
        text = input::replaced(text, "standard_deviation = 0.1\n", "");
        text = input::replaced(text, "standard_deviation = 0.214e15\n", "");
    }
    return text + "[[parameter]]\nlink = \"conductivity\"\nat = [\"60 degC\"]\n";
}

struct Recovered {
    input::Experiment experiment;
    diagnosis::Identification fit;
};

Recovered recover(const MadeUpBench& made, bool with_priors) {
    const input::Written written;
    std::vector<Column> log = made.logs.front();
    std::erase_if(log, [](const Column& column) { return column.heading.starts_with("surface_temperature"); });
    Recovered found{.experiment = read_with(written.add("free.toml", free_case(with_priors)), {log}), .fit = {}};
    found.fit = diagnosis::identify(found.experiment, diagnosis::observe(found.experiment));
    EXPECT_TRUE(found.fit.status.ok()) << found.fit.status.message;
    return found;
}

}  // namespace

TEST(UnseenRecovery, WhatADullRunDoesNotSeeIsNamedAndNoIntervalIsFalse) {
    tiretherm::support::Coverage reported;
    bool one_without_interval = false;
    for (std::uint64_t seed = 6001; seed <= 6004; ++seed) {
        const MadeUpBench made = make_up_bench(seed, 4.0, draw_dull_programme);
        const Recovered found = recover(made, false);
        // The least seen combination: the data say less of it than its prior or, without one, than its own size.
        EXPECT_LT(found.fit.directions.back().strength, 1.0) << "seed " << seed;
        for (std::size_t j = 0; j < found.fit.fitted.size(); ++j) {
            const diagnosis::Fitted& one = found.fit.fitted[j];
            const tiretherm::solver::FreeParameter& parameter = found.experiment.parameters[j];
            if (parameter.name.starts_with("initial surface")) {
                EXPECT_EQ(one.identifiability, Identifiability::prior_only) << "seed " << seed;
            }
            if (one.identifiability == Identifiability::not_determined) {
                EXPECT_TRUE(std::isnan(one.low) && std::isnan(one.high)) << parameter.name;
                one_without_interval = true;
            } else {
                const double truth = made.truth_of(parameter);
                reported.add(truth, one.value, one.low, one.high);
                EXPECT_LT(std::abs(one.value - truth), 3.3 * one.standard_deviation) << seed << ' ' << parameter.name;
            }
        }
    }
    EXPECT_TRUE(one_without_interval);
    EXPECT_LE(reported.missed(), tiretherm::support::most_misses(reported.count()))
        << reported.missed() << " of " << reported.count();
}

// Of the film's scale such a run says less than the prior of 10 % does.
TEST(UnseenRecovery, WithPriorsIntervalsAreThoseOfThePriors) {
    for (std::uint64_t seed = 6001; seed <= 6004; ++seed) {
        const MadeUpBench made = make_up_bench(seed, 4.0, draw_dull_programme);
        const Recovered found = recover(made, true);
        const std::size_t film = sample::index_of(found.experiment, sample::film);
        const diagnosis::Fitted& one = found.fit.fitted[film];
        EXPECT_TRUE(one.identifiability == Identifiability::prior_only ||
                    one.identifiability == Identifiability::with_prior)
            << word_of(one.identifiability);
        EXPECT_LE(one.standard_deviation, 0.1);
        EXPECT_LT(one.low, made.lambda_h);
        EXPECT_GT(one.high, made.lambda_h);
        for (const diagnosis::Fitted& other : found.fit.fitted) {
            EXPECT_TRUE(other.identifiability == Identifiability::not_determined || std::isfinite(other.low));
        }
    }
}

}  // namespace hidden_effects
