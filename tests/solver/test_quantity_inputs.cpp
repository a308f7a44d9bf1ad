// SPDX-License-Identifier: BSD-3-Clause
// The inputs that a quantity is said to read are those that change it.

#include "solver/quantity_inputs.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/system.hpp"

namespace tiretherm::solver {

// Each input in turn is moved by a tenth, in a Magic Formula without a coefficient of nothing, of this tire and of another: a
// quantity that changes says that it reads it, and one that says that it reads what a case may leave out changes.
TEST(QuantityInputs, AreThoseThatChangeTheQuantity) {
    Problem problem = two_node_tire();
    physics::MagicFormula law;
    law.pCy1 = 1.3, law.pDy1 = 1.0, law.pDy3 = 2.0, law.pKy1 = 20.0, law.pKy2 = 2.0, law.pKy3 = 0.5, law.pVy3 = 0.3;
    law.pCx1 = 1.6, law.pDx1 = 1.1, law.pDx3 = 2.0, law.pKx1 = 22.0;
    law.lambda.muV = 0.1;
    law.version = physics::MagicFormulaVersion::mf61, law.nominal_pressure = 2.2e5;
    law.pPx1 = -0.2, law.pPx3 = 0.1, law.pPy1 = 0.3, law.pPy3 = 0.1;
    problem.handling.magic_formula = law;
    problem.handling.grip = physics::Grip{.hysteresis = 1.0};
    Problem tuned = problem;
    tuned.handling.replaces_stiffness = true;
    System system(problem);
    const physics::Inputs base{.speed = 25.0,
                               .vertical_load = 4000.0,
                               .slip_angle = 0.03,
                               .slip_ratio = 0.02,
                               .lateral_force = 2000.0,
                               .longitudinal_force = 500.0,
                               .camber = 0.05,
                               .inflation_pressure = 2.3e5,
                               .air_temperature = 296.15,
                               .road_temperature = 296.15,
                               .wet = 0.5,
                               .laser_power = 1.0,
                               .wheel_angle = 10.0};
    std::vector<double> coefficients(system.n_coefficients());
    int changes = 0;
    for (const QuantityDescription& quantity : quantities()) {
        if (quantity.evaluate == nullptr || !quantity.needs_effect.empty()) {
            continue;
        }
        const auto value = [&](const Problem& of, const physics::Inputs& inputs) {
            return quantity.evaluate({.problem = of,
                                      .system = system,
                                      .quantity = quantity.quantity,
                                      .followed = 330.0,
                                      .inputs = inputs,
                                      .logged = inputs,
                                      .gas_start = 296.15,
                                      .coefficients = coefficients,
                                      .surface = 320.0});
        };
        for (const physics::Signal& signal : physics::signals()) {
            physics::Inputs moved = base;
            moved.*signal.member += base.*signal.member == 0.0 ? 0.1 : 0.1 * base.*signal.member;
            const auto says = [&](std::span<const std::string_view> names) {
                return std::ranges::find(names, signal.name) != names.end();
            };
            const auto changes_it = [&](const Problem& of) {
                return std::abs(value(of, moved) / value(of, base) - 1.0) > 1e-12;
            };
            const bool changed = changes_it(problem) || changes_it(tuned);
            changes += changed ? 1 : 0;
            EXPECT_TRUE(!changed || says(quantity.signals) || says(optional_signals(quantity.quantity)))
                << quantity.kind << " reads " << signal.name;
            EXPECT_TRUE(changed || !says(optional_signals(quantity.quantity)))
                << quantity.kind << " does not read " << signal.name;
        }
    }
    EXPECT_GT(changes, 15);
}

}  // namespace tiretherm::solver
