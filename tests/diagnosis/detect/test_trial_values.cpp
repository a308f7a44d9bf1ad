// SPDX-License-Identifier: BSD-3-Clause
// The trial values of the diagnosis stand for parameters that the catalogue has, and within the catalogue's bounds.

#include "diagnosis/detect/trial_values.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {
namespace {

TEST(TrialValues, AreOfParametersThatThereAreAndWithinTheirBounds) {
    for (const TrialValues& one : trial_values()) {
        SCOPED_TRACE(std::string(one.effect) + "." + std::string(one.parameter));
        const physics::Effect* effect = physics::find_effect(one.effect);
        ASSERT_NE(effect, nullptr);
        const int index = physics::find_parameter(*effect, one.parameter);
        ASSERT_GE(index, 0);
        const physics::ParameterSpec& parameter = effect->parameters[static_cast<std::size_t>(index)];
        EXPECT_FALSE(std::isnan(parameter.absent)) << "is no candidate";
        EXPECT_EQ(trial_values_of(*effect, parameter), &one) << "stands there twice";
        for (const double value : one.trials) {
            EXPECT_TRUE(value == 0.0 || (value >= parameter.low && value <= parameter.high)) << value;
        }
        if (one.other.empty()) {
            EXPECT_EQ(one.factor, 0.0);
            EXPECT_EQ(one.held[0], 0.0);
            continue;
        }
        const int other_index = physics::find_parameter(*effect, one.other);
        ASSERT_GE(other_index, 0) << one.other;
        const physics::ParameterSpec& other = effect->parameters[static_cast<std::size_t>(other_index)];
        const auto end = std::ranges::find(one.held, 0.0);
        EXPECT_TRUE(std::is_sorted(one.held.begin(), end));
        EXPECT_NE(end - one.held.begin(), 1) << "a single value has no neighbour";
        for (auto value = one.held.begin(); value != end; ++value) {
            EXPECT_GE(*value, other.low);
            EXPECT_LE(*value, other.high);
        }
    }
}

}  // namespace
}  // namespace tiretherm::diagnosis
