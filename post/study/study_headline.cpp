// SPDX-License-Identifier: BSD-3-Clause
// The first sentences of a study's page: probability and quantiles of samples, hottest and coldest point of a grid.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "physics/celsius.hpp"
#include "post/study/study_names.hpp"
#include "post/study/study_sections.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Sides of a grid whose values still make a sentence.
constexpr std::size_t most_sides = 3;

/// "42", "0.4", "99.7": no share that is neither none nor all reads as one of these.
std::string percent(double share) {
    const double value = 100.0 * share;
    const bool is_near_an_end = (value > 0.0 && value < 9.5) || (value > 99.0 && value < 100.0);
    return is_near_an_end ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

/// Where a point of the grid is: its values, or where these are many its run.
std::string place_of(const StudyRecord& study, std::size_t point) {
    return study.sides.size() > most_sides ? fmt::format("run {}", point * study.samples + 1)
                                           : point_text(study, point);
}

/// "42 % of 1000 samples pass 120 degC (39 to 45 %); median 118.4, nine tenths 104.9 to 130.9 degC"
std::string of_samples(const StudyRecord& study, std::size_t point) {
    const std::vector<double> hottest = hottest_at(study, point);
    if (hottest.empty()) {
        return "no sample came to its end";
    }
    const std::string spread = fmt::format("median {:.1f}, nine tenths {:.1f} to {:.1f} degC", quantile(hottest, 0.5),
                                           quantile(hottest, 0.05), quantile(hottest, 0.95));
    if (!study.critical) {
        return fmt::format("hottest temperature of {}: {}", plural(hottest.size(), "sample"), spread);
    }
    const Chance passes = passes_critical(study, point);
    return fmt::format("{} % of {} pass {:.6g} degC ({} to {} %); {}", percent(passes.share),
                       plural(passes.of, "sample"), celsius(*study.critical), percent(passes.low), percent(passes.high),
                       spread);
}

std::string of_grid(const StudyRecord& study, std::size_t coldest, std::size_t hottest) {
    const auto at = [&](std::size_t point) {
        return fmt::format("{:.1f} degC at {}", hottest_at(study, point).front(), place_of(study, point));
    };
    std::string text;
    if (study.critical) {
        const auto passing = std::ranges::count_if(
            study.outcomes, [&](const StudyOutcome& run) { return run.ok() && run.hottest > *study.critical; });
        text = fmt::format("{} of {} pass {:.6g} degC. ", passing,
                           plural(study.outcomes.size() - study.failed().size(), "run"), celsius(*study.critical));
    }
    return fmt::format("{}Hottest: {}; coldest: {}.", text, at(hottest), at(coldest));
}

}  // namespace

std::vector<std::string> study_headline(const StudyRecord& study) {
    std::vector<std::pair<double, std::size_t>> medians;  // degC, of the points that have one
    for (std::size_t point = 0; point < study.points(); ++point) {
        if (const std::vector<double> hottest = hottest_at(study, point); !hottest.empty()) {
            medians.emplace_back(quantile(hottest, 0.5), point);
        }
    }
    if (medians.empty()) {
        return {"No run came to its end."};
    }
    const std::size_t coldest = std::ranges::min_element(medians)->second;
    const std::size_t hottest = std::ranges::max_element(medians)->second;
    std::vector<std::string> sentences;
    if (!study.is_sampled) {
        sentences.push_back(of_grid(study, coldest, hottest));
    } else if (study.points() == 1) {
        sentences.push_back(of_samples(study, coldest) + ".");
        sentences.back().front() = sentences.back().front() == 'h' ? 'H' : sentences.back().front();
    } else {
        for (const std::size_t point : {hottest, coldest}) {
            sentences.push_back(fmt::format("{}: {}.", place_of(study, point), of_samples(study, point)));
        }
    }
    // Without a temperature of the study's own those of its parts are what it was asked for.
    std::size_t place = study.critical ? sentences.size() : 0;
    for (std::size_t part = 0; part < study.parts.size(); ++part, ++place) {
        const Chance passes = part_passes(study, part);
        sentences.insert(
            sentences.begin() + static_cast<std::ptrdiff_t>(place),
            study.is_sampled && study.points() == 1
                ? fmt::format("{} in {} % of {} ({} to {} %).", part_text(study, part), percent(passes.share),
                              plural(passes.of, "sample"), percent(passes.low), percent(passes.high))
                : fmt::format("{} in {} of {}.", part_text(study, part), passes.times, plural(passes.of, "run")));
    }
    if (const std::size_t failed = study.failed().size(); failed > 0) {
        sentences.push_back(fmt::format("{} of {} failed and {} not counted.", failed,
                                        plural(study.outcomes.size(), "run"), failed == 1 ? "is" : "are"));
    }
    return sentences;
}

}  // namespace tiretherm::post
