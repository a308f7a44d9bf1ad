// SPDX-License-Identifier: BSD-3-Clause
// Makes a parameter of each axle, side or corner out of one, with the runs that it belongs to.

#include "input/parameters/parameter_groups.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/drive/corner.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

bool give_each_group_its_own(TomlTable& table, const solver::Problem& problem, const std::vector<RunOfParameter>& runs,
                             std::vector<solver::FreeParameter>& numbers) {
    const std::size_t before = table.errors().count();
    const std::optional<std::string_view> each = table.word("each");
    if (!each) {
        return table.errors().count() == before;
    }
    if (runs.empty() || runs.front().corner.empty()) {
        table.add_error("each", "the case has no [[corner]]", "remove each, or add a [[corner]] for each wheel");
        return false;
    }
    const solver::FreeParameter& first = numbers.front();
    if (first.kind != solver::FreeParameter::Kind::effect ||
        physics::is_user_effect(*problem.effects[first.effect].effect)) {
        table.add_error("each", fmt::format("{} cannot differ from one {} to the other", numbers.front().name, *each),
                        "remove each, which is for values of [effects]; each run has its own start by itself");
        return false;
    }
    const CornerGroup group = *each == "axle"   ? CornerGroup::axle
                              : *each == "side" ? CornerGroup::side
                                                : CornerGroup::corner;
    std::vector<solver::FreeParameter> own;
    for (const solver::FreeParameter& number : numbers) {
        const auto before_it = static_cast<std::ptrdiff_t>(own.size());
        for (std::size_t run = 0; run < runs.size(); ++run) {
            const std::string name = fmt::format("{}, {}", number.name, group_of(runs[run].corner, group));
            auto of_group = std::ranges::find(own.begin() + before_it, own.end(), name, &solver::FreeParameter::name);
            if (of_group == own.end()) {
                own.push_back(number);
                own.back().name = name;
                of_group = own.end() - 1;
            }
            of_group->runs.push_back(run);
        }
    }
    numbers = std::move(own);
    return true;
}

}  // namespace tiretherm::input
