// SPDX-License-Identifier: BSD-3-Clause
// Wilson's interval, quantiles by linear interpolation, and counts of runs above the critical temperature.

#include "diagnosis/study/study_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "physics/celsius.hpp"

namespace tiretherm::diagnosis {

Chance chance(std::size_t times, std::size_t of) {
    Chance result{.times = times, .of = of};
    if (of == 0) {
        return result;
    }
    constexpr double z = 1.959963984540054;  // 97.5 % of the standard normal distribution
    const auto n = static_cast<double>(of);
    const double p = static_cast<double>(times) / n;
    const double middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    result.share = p;
    result.low = times == 0 ? 0.0 : middle - half;
    result.high = times == of ? 1.0 : middle + half;
    return result;
}

std::vector<double> hottest_at(const StudyRecord& study, std::size_t point) {
    std::vector<double> found;
    for (std::size_t r = point * study.samples; r < (point + 1) * study.samples; ++r) {
        if (study.outcomes[r].ok()) {
            found.push_back(celsius(study.outcomes[r].hottest));
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

double quantile(const std::vector<double>& sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Chance passes_critical(const StudyRecord& study, std::size_t point) {
    const std::vector<double> sorted = hottest_at(study, point);
    const auto first = std::upper_bound(sorted.begin(), sorted.end(), celsius(*study.critical));
    return chance(static_cast<std::size_t>(sorted.end() - first), sorted.size());
}

Chance part_passes(const StudyRecord& study, std::size_t point, std::size_t part) {
    std::size_t times = 0;
    std::size_t of = 0;
    for (std::size_t r = point * study.samples; r < (point + 1) * study.samples; ++r) {
        if (study.outcomes[r].ok()) {
            const StudyOutcome::Part& reached = study.outcomes[r].parts[part];
            times += reached.hottest > reached.critical ? 1 : 0;
            ++of;
        }
    }
    return chance(times, of);
}

Chance part_passes(const StudyRecord& study, std::size_t part) {
    Chance all;
    for (std::size_t point = 0; point < study.points(); ++point) {
        const Chance here = part_passes(study, point, part);
        all = chance(all.times + here.times, all.of + here.of);
    }
    return all;
}

}  // namespace tiretherm::diagnosis
