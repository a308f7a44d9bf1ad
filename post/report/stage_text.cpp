// SPDX-License-Identifier: BSD-3-Clause
// Words by part and by piece of work.
#include "post/report/stage_text.hpp"

#include <fmt/format.h>

namespace tiretherm::post {

using diagnosis::Part;
using diagnosis::Work;

std::string_view text_of(Part part) {
    switch (part) {
        case Part::none:
            return "";
        case Part::score_tests:
            return "fit and the score tests of the candidates";
        case Part::grid_error:
            return "estimate of the grid's error";
        case Part::causes:
            return "search of causes";
        case Part::missing_heat:
            return "search of missing heat";
        case Part::gain:
            return "test of the gain on data that were left out";
        case Part::next_experiment:
            return "plan of the next experiment";
    }
    return "";
}

namespace {

std::string words_of(const diagnosis::Stage& stage) {
    switch (stage.doing) {
        case Work::none:
            return "";
        case Work::fitting_case:
            return "fitting the case as it is";
        case Work::signatures:
            return fmt::format("signatures of {} candidates", stage.count);
        case Work::signature:
            return "signature";
        case Work::unknown_heat:
            return "responses to unknown heat";
        case Work::noise:
            return "estimating the noise";
        case Work::candidate:
            return "candidate";
        case Work::looking_back:
            return "looking back";
        case Work::prediction:
            return "prediction";
        case Work::left_out_data:
            return "predicting data that are left out";
        case Work::other_mesh:
            return "trying another mesh";
        case Work::unknown_source:
            return "testing an unknown heat source";
        case Work::next_experiment:
            return "planning an experiment that would tell more";
    }
    return "";
}

}  // namespace

std::string text_of(const diagnosis::Stage& stage) {
    return stage.run.empty() ? words_of(stage) : fmt::format("{} alone: {}", stage.run, words_of(stage));
}

}  // namespace tiretherm::post
