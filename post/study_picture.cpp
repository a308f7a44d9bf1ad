#include "post/study_picture.hpp"

#include "post/study_axis.hpp"
#include "post/study_plots.hpp"

namespace tiretherm::post {

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
