// SPDX-License-Identifier: BSD-3-Clause
// What an error of the model does to the intervals of a cause.

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis.hpp"

namespace tiretherm::diagnosis {

// The error leaves 0.5 of the number 2 on either side. Its companion is three times as large, and so is what is left of it:
// 6 +- 1.5. The number that was held on trial, also 2, follows another fitted number, of which 0.1 is left.
TEST(ModelError, WidensEachNumberByThatWhichItFollows) {
    Cause cause{
        .id = "inner_gas",
        .numbers = {{.key = "liner", .unit = {}, .value = 2.0, .low = 1.9, .high = 2.1, .fitted = 1},
                    {.key = "rim", .unit = {}, .value = 6.0, .low = 5.7, .high = 6.3, .fitted = 1, .factor = 3.0},
                    {.key = "held", .unit = {}, .value = 2.0, .low = 1.8, .high = 2.2, .fitted = 2}}};
    cause.widen({7.0, 0.5, 0.1});
    EXPECT_DOUBLE_EQ(cause.numbers[0].low, 1.5);
    EXPECT_DOUBLE_EQ(cause.numbers[0].high, 2.5);
    EXPECT_DOUBLE_EQ(cause.numbers[1].low, 4.5);
    EXPECT_DOUBLE_EQ(cause.numbers[1].high, 7.5);
    EXPECT_DOUBLE_EQ(cause.numbers[2].low, 1.8);
    EXPECT_DOUBLE_EQ(cause.numbers[2].high, 2.2);
}

}  // namespace tiretherm::diagnosis
