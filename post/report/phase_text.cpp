// SPDX-License-Identifier: BSD-3-Clause
// Names and meanings of driving phases; diagnosis/compare/phase.cpp has the thresholds that they state.
#include "post/report/phase_text.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace tiretherm::post {

namespace {

using Words = std::pair<std::string_view, std::string_view>;  // name, meaning

constexpr std::array phase_words{// [Phase]
                                 Words{"standing", "speed below 0.1 m/s"},
                                 Words{"slipping", "slip angle from 0.3 deg or slip ratio from 0.5 % on"},
                                 Words{"slowing", "straight, speed falling faster than 0.01 g"},
                                 Words{"free rolling", "straight, speed steady or rising"},
                                 Words{"cornering", "forces from 15 % of the load on, mostly lateral"},
                                 Words{"braking", "forces from 15 % of the load on, mostly of braking"},
                                 Words{"driving", "forces from 15 % of the load on, mostly of driving"},
                                 Words{"straight", "forces below 15 % of the load"}};
static_assert(phase_words.size() == diagnosis::phases.size());

}  // namespace

std::string_view name_of(diagnosis::Phase phase) { return phase_words[static_cast<std::size_t>(phase)].first; }

std::string_view meaning_of(diagnosis::Phase phase) { return phase_words[static_cast<std::size_t>(phase)].second; }

}  // namespace tiretherm::post
