// SPDX-License-Identifier: BSD-3-Clause
// Sizes of user effects, found in made-up runs whose truth is known.
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

// The puzzle's runs were made with lambda_h = 0.96, lambda_SEL = 1.06 and 0.8 W/K between bulk and air; nothing follows
// the throttle. Each interval of 95 % holds its truth in these runs.
TEST(IdentificationOwn, FindsTheExchangeThatThePuzzleHides) {
    const input::Experiment experiment = sample::read_bench(sample::practice() / "two_node_own_effects.toml");
    const Identification result = sample::fit(experiment);
    for (const auto& [name, truth] :
         {std::pair{"throttle_heat.watts", 0.0}, std::pair{"wall.conductance", 0.8},
          std::pair{"air_convection.lambda_h", 0.96}, std::pair{"strain_energy_loss.tan_delta_a", 1.06 * 2.14e15}}) {
        const Fitted& number = result.fitted[sample::index_of(experiment, name)];
        EXPECT_EQ(number.identifiability, Identifiability::determined) << name;
        EXPECT_LT(number.low, truth) << name;
        EXPECT_GT(number.high, truth) << name;
    }
    const Fitted& wall = result.fitted[sample::index_of(experiment, "wall.conductance")];
    EXPECT_GT(wall.low, 0.5);  // far from nothing: half the interval is 0.09 W/K
}

}  // namespace tiretherm::diagnosis
