// SPDX-License-Identifier: BSD-3-Clause
// Parts of a study: which runs each has, and how it is written.
#include "diagnosis/study/study_part.hpp"

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {
namespace {

// Ten runs over three parts: 0, 3, 6, 9 and 1, 4, 7 and 2, 5, 8.
TEST(StudyPart, EveryRunBelongsToOnePart) {
    std::size_t all = 0;
    for (std::size_t k = 1; k <= 3; ++k) {
        const StudyPart part{.index = k, .count = 3};
        std::size_t own = 0;
        for (std::size_t run = 0; run < 10; ++run) {
            EXPECT_EQ(part.has(run), run % 3 == k - 1) << run;
            own += part.has(run) ? 1 : 0;
        }
        EXPECT_EQ(part.size(10), own) << k;
        all += own;
    }
    EXPECT_EQ(all, 10U);
    EXPECT_TRUE(StudyPart{}.is_whole());
}

TEST(StudyPart, IsReadAsItIsWritten) {
    const StudyPart part{.index = 3, .count = 16};
    EXPECT_EQ(part.text(), "3/16");
    EXPECT_EQ(part.folder(), "part_3_of_16");
    EXPECT_EQ(StudyPart::parse("3/16"), part);
    EXPECT_EQ(StudyPart::from_folder("part_3_of_16"), part);
}

TEST(StudyPart, WhatIsNoPartIsNone) {
    for (const char* text : {"", "3", "0/4", "5/4", "3/", "/4", "03/16", "3/16 ", "-1/4", "1/100001", "1.0/4"}) {
        EXPECT_FALSE(StudyPart::parse(text)) << text;
    }
    for (const char* name : {"part_3", "part_3_of_", "part_5_of_4", "parts_3_of_16", "part_3_of_16_old"}) {
        EXPECT_FALSE(StudyPart::from_folder(name)) << name;
    }
}

}  // namespace
}  // namespace tiretherm::diagnosis
