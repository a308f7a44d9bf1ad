// SPDX-License-Identifier: BSD-3-Clause
// Words by part and by piece of work.
#include "post/report/stage_text.hpp"

#include <array>

#include <fmt/format.h>

namespace tiretherm::post {

using diagnosis::Part;
using diagnosis::Work;

namespace {

constexpr std::array<std::string_view, 7> parts{// [Part]
                                                "",
                                                "fit and the score tests of the candidates",
                                                "estimate of the grid's error",
                                                "search of causes",
                                                "search of missing heat",
                                                "test of the gain on data that were left out",
                                                "plan of the next experiment"};
static_assert(parts.size() == static_cast<std::size_t>(Part::next_experiment) + 1);

constexpr std::array<std::string_view, 13> works{// [Work]
                                                 "",
                                                 "fitting the case as it is",
                                                 "signatures of {} candidates",
                                                 "signature",
                                                 "responses to unknown heat",
                                                 "estimating the noise",
                                                 "candidate",
                                                 "looking back",
                                                 "prediction",
                                                 "predicting data that are left out",
                                                 "trying another mesh",
                                                 "testing an unknown heat source",
                                                 "planning an experiment that would tell more"};
static_assert(works.size() == static_cast<std::size_t>(Work::next_experiment) + 1);

}  // namespace

std::string_view text_of(Part part) { return parts[static_cast<std::size_t>(part)]; }

std::string text_of(const diagnosis::Activity& stage) {
    const std::string work = fmt::format(fmt::runtime(works[static_cast<std::size_t>(stage.doing)]), stage.count);
    return stage.run.empty() ? work : fmt::format("{} alone: {}", stage.run, work);
}

}  // namespace tiretherm::post
