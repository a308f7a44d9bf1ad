// SPDX-License-Identifier: BSD-3-Clause
// Names by critical temperature and by values.
#include "post/study/study_names.hpp"

#include <set>

#include <fmt/format.h>

#include "physics/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose studies are named here

std::string part_text(const StudyRecord& study, std::size_t part) {
    std::set<double> limits;
    for (const StudyOutcome& outcome : study.outcomes) {
        if (outcome.ok()) {
            limits.insert(outcome.parts[part].critical);
        }
    }
    return limits.size() == 1 ? fmt::format("{} above {:.6g} degC", study.parts[part], celsius(*limits.begin()))
                              : fmt::format("{} above its critical temperature", study.parts[part]);
}

std::string point_text(const StudyRecord& study, std::size_t point) {
    std::string text;
    for (std::size_t side = 0; side < study.sides.size(); ++side) {
        const StudyColumn& column = study.columns[side];
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", column.key, column.texts[point * study.samples]);
    }
    return text;
}

}  // namespace tiretherm::post
