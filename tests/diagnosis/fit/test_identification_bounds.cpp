// SPDX-License-Identifier: BSD-3-Clause
// Fits that do not end in the middle of a valley: at a bound, past values at which the model fails.
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

// The film's true scale is 1.05, its bound 1.02: five standard deviations short of the truth, which the loss makes up for in part.
TEST(IdentificationBounds, AFitThatWantsToGoFurtherEndsAtTheBound) {
    input::Experiment experiment = sample::practice_bench();
    experiment.runs.resize(1);
    experiment.parameters.resize(3);  // film, loss and the surface's start
    const std::size_t film = sample::index_of(experiment, sample::film);
    experiment.parameters[film].high = 1.02;
    const Identification result = sample::fit(experiment);
    EXPECT_EQ(result.fitted[film].identifiability, Identifiability::at_bound);
    EXPECT_NEAR(result.fitted[film].value, 1.02, 1e-6);
    EXPECT_LE(result.fitted[film].high, 1.02);
    const std::size_t loss = sample::index_of(experiment, sample::loss);
    EXPECT_EQ(result.fitted[loss].identifiability, Identifiability::doubtful);
    EXPECT_NEAR(result.fitted[loss].value, 0.93 * 2.14e15, 0.02 * 2.14e15);
}

// The link's law is free at 60 and 62 degC and starts a quarter too low. A value at 62 degC alone that is right would
// turn the straight line through both negative in a cold tire: the way leads along the edge of what can be simulated.
// In truth k(T) = 0.29 + 0.00943 (T - 20 degC) W/mK: 0.6672 at 60, 0.6861 at 62 degC.
TEST(IdentificationBounds, TheSearchFindsTheTruthBesideValuesAtWhichTheModelFails) {
    const input::Written written;
    const std::string extra = "\n[[parameter]]\nlink = \"conductivity\"\nat = [\"60 degC\", \"62 degC\"]\n";
    input::Experiment experiment = sample::read_bench(written.add("link.toml", sample::practice_text() + extra));
    const std::size_t at_60 = sample::index_of(experiment, "link.conductivity at 60 degC");
    const std::size_t at_62 = at_60 + 1;
    const auto start = [&](std::size_t j, double value) {
        for (input::MeasuredRun& run : experiment.runs) {
            const solver::FreeParameter& number = experiment.parameters[j];
            solver::move(run.problem, number, solver::value_of(run.problem, number), value);
        }
    };
    start(at_60, 0.50);
    start(at_62, 0.51);
    const Observations observations = observe(experiment);
    Simulator simulator(experiment, observations);
    Eigen::VectorXd values = simulator.start();
    values[static_cast<Eigen::Index>(at_62)] = 0.70;  // -4.7 W/mK at 10 degC
    EXPECT_FALSE(simulator.at(values).status.ok());
    testing::internal::CaptureStderr();
    const Identification result = sample::fit(experiment);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    for (const auto& [j, truth] : {std::pair{at_60, 0.6672}, std::pair{at_62, 0.68606}}) {
        EXPECT_EQ(result.fitted[j].identifiability, Identifiability::determined);
        EXPECT_LT(result.fitted[j].low, truth);
        EXPECT_GT(result.fitted[j].high, truth);
    }
}

}  // namespace tiretherm::diagnosis
