// SPDX-License-Identifier: BSD-3-Clause
// Chooses map, curve or histogram by how many sides of the study's grid have more than one value.

#include "post/charts/study_picture.hpp"

#include "post/charts/study_axis.hpp"
#include "post/charts/study_plots.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

bool has_study_picture(const StudyRecord& study) {
    const bool any = study.failed().size() < study.outcomes.size();
    return any && (!wide_sides(study).empty() || study.samples > 1);
}

void draw_study(const std::filesystem::path& path, const StudyRecord& study) {
    switch (wide_sides(study).size()) {
        case 0:
            return draw_study_histogram(path, study);
        case 1:
            return draw_study_curve(path, study);
        default:
            return draw_study_map(path, study);
    }
}

}  // namespace tiretherm::post
