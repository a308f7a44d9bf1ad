// SPDX-License-Identifier: BSD-3-Clause
// Statistics of a study's runs: quantiles of the hottest temperature and the probability of passing the critical one,
// with Wilson's interval (J. Am. Stat. Assoc. 22 (1927) 209).
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::diagnosis {

/// How often something happened among independent runs.
struct Chance {
    std::size_t times = 0;
    std::size_t of = 0;
    double share = 0.0;
    double low = 0.0;  ///< Wilson's interval, 95 %
    double high = 1.0;
};

/// Share with the score interval of E. B. Wilson (J. Am. Stat. Assoc. 22, 1927, p. 209): it holds at few runs and at
/// shares of 0 and 1 as well. Nothing is known of 0 runs.
[[nodiscard]] Chance chance(std::size_t times, std::size_t of);

/// Hottest temperatures of the runs at a point of the grid that came to their end, coldest first. degC
[[nodiscard]] std::vector<double> hottest_at(const StudyRecord& study, std::size_t point);

/// The temperature below which a share of the values lies, linear between them. @param sorted not empty
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

/// How often the hottest place at a point of the grid passes the critical temperature. @pre study.critical
[[nodiscard]] Chance passes_critical(const StudyRecord& study, std::size_t point);

/// How often a part at a point of the grid passes its critical temperature. @param part index into StudyRecord::parts
[[nodiscard]] Chance part_passes(const StudyRecord& study, std::size_t point, std::size_t part);
/// The same of all runs.
[[nodiscard]] Chance part_passes(const StudyRecord& study, std::size_t part);

}  // namespace tiretherm::diagnosis
