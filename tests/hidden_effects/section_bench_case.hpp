// SPDX-License-Identifier: BSD-3-Clause
// Runs the practice cases on a section with a given log and returns their sensor readings, to be compared with a truth.
#pragma once

#include <string>
#include <vector>

#include "hidden_effects/case_rows.hpp"
#include "hidden_effects/made_up_bench.hpp"
#include "input/measurements/measured_bench.hpp"
#include "section/section_columns_truth.hpp"

namespace hidden_effects {

/// The first samples of a programme.
inline SectionProgramme first_of(SectionProgramme programme, std::size_t n) {
    for (std::vector<double>* signal :
         {&programme.time, &programme.speed, &programme.vertical_load, &programme.slip_angle, &programme.lateral_force,
          &programme.camber, &programme.air_temperature, &programme.road_temperature, &programme.throttle}) {
        signal->resize(n);
    }
    return programme;
}

/// A case of cases/practice as it is, with what a user would add to it, read with a log of its own.
inline tiretherm::solver::Problem practice_problem(const std::string& name, const std::string& added,
                                                   const std::vector<Column>& log) {
    namespace input = tiretherm::input;
    const input::Written written;
    const std::string include = (input::source_folder() / "cases/practice" / (name + ".toml")).string();
    const std::filesystem::path file = written.add("bench.toml", "include = [\"" + include + "\"]\n" + added);
    return read_with(file, {log}).runs.front().problem;
}

/// What the channels of a problem read at every sample of a log that is even, in kelvin.
inline std::vector<std::vector<double>> readings_of(tiretherm::solver::Problem problem, double interval,
                                                    double tolerance) {
    problem.settings.output_interval = interval;
    problem.settings.tolerance = tolerance;
    std::vector<std::vector<double>> channels(problem.channels.size());
    const auto report = tiretherm::solver::run(problem, [&](const tiretherm::solver::Snapshot& now) {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            channels[c].push_back(now.channels[c]);
        }
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return channels;
}

}  // namespace hidden_effects
