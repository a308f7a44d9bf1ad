// SPDX-License-Identifier: BSD-3-Clause
// Groups of effects whose signatures are alike: every member leads to its group, and names effects that there are.
#include "diagnosis/detect/confounded_effects.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "physics/effect.hpp"

namespace tiretherm::diagnosis {
namespace {

TEST(ConfoundedEffects, EveryMemberIsAnEffectAndFindsItsGroup) {
    std::size_t groups = 0;
    for (const physics::Effect* effect : physics::catalogue()) {
        for (const physics::ConfoundedGroup& group : effect->confounded) {
            ++groups;
            EXPECT_FALSE(group.separated.empty()) << effect->id;
            for (const std::string_view member : group.members) {
                if (!member.empty()) {
                    EXPECT_NE(physics::find_effect(member.substr(0, member.find('.'))), nullptr) << member;
                    const auto found = confounded_groups_of(member);
                    EXPECT_NE(std::ranges::find(found, &group), found.end()) << member;
                }
            }
        }
    }
    EXPECT_GT(groups, 0U);
    EXPECT_TRUE(confounded_groups_of("no_such_effect").empty());
}

TEST(ConfoundedEffects, OthersAreAllButTheOneThatIsAskedFor) {
    const physics::ConfoundedGroup group{.members = {"one", "two", "three"}, .separated = "a camera"};
    EXPECT_EQ(others_of(group, "two"), "one, three");
    EXPECT_EQ(others_of(group, "none"), "one, two, three");
}

}  // namespace
}  // namespace tiretherm::diagnosis
