// SPDX-License-Identifier: BSD-3-Clause
// The runs of a study as a CSV table, one row for each run.

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/report/csv.hpp"
#include "post/study/study_tables.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

std::vector<std::string> headings(const StudyRecord& study) {
    std::vector<std::string> names{"run"};
    for (const StudyColumn& column : study.columns) {
        names.push_back(column.heading());
    }
    names.insert(names.end(), {"outcome", "hottest [degC]", "hottest_time [s]", "hottest_layer", "hottest_zone"});
    for (const solver::Channel& channel : study.channels) {
        for (const char* what : {"final", "min", "max"}) {
            names.push_back(fmt::format("{}_{} [{}]", channel.name, what, solver::shown_unit(channel.quantity).name));
        }
    }
    for (const std::string& part : study.parts) {
        names.push_back(fmt::format("{}_hottest [degC]", part));
        names.push_back(fmt::format("{}_critical [degC]", part));
    }
    names.insert(names.end(), {"energy_closure [-]", "steps [-]"});
    return names;
}

void add_outcome(Csv& csv, const StudyRecord& study, const StudyOutcome& run) {
    csv.add("ok");
    csv.add(Decimals{celsius(run.hottest), 4});
    csv.add(Digits{run.hottest_time, 6});
    csv.add(run.hottest_layer);
    csv.add(run.hottest_zone);
    for (std::size_t c = 0; c < study.channels.size(); ++c) {
        const solver::ShownUnit unit = solver::shown_unit(study.channels[c].quantity);
        for (const double value : {run.channel_final[c], run.channel_min[c], run.channel_max[c]}) {
            csv.add(Decimals{unit.value(value), 4});
        }
    }
    for (const StudyOutcome::Part& part : run.parts) {
        csv.add(Decimals{celsius(part.hottest), 4});
        csv.add(Decimals{celsius(part.critical), 4});
    }
    csv.add(fmt::format("{:.2e}", run.energy_closure));
    csv.add(run.steps);
}

}  // namespace

std::string study_csv(const StudyRecord& study) {
    Csv csv(headings(study));
    for (std::size_t r = 0; r < study.outcomes.size(); ++r) {
        const StudyOutcome& run = study.outcomes[r];
        csv.add(r + 1);
        for (const StudyColumn& column : study.columns) {
            if (column.is_number) {
                csv.add(Digits{column.numbers[r], 10});
            } else {
                csv.add(column.texts[r]);
            }
        }
        if (run.ok()) {
            add_outcome(csv, study, run);
        } else {
            csv.add(run.failure);
            for (std::size_t empty = 0; empty < 6 + 3 * study.channels.size() + 2 * study.parts.size(); ++empty) {
                csv.add("");
            }
        }
        csv.end_row();
    }
    return csv.text();
}

}  // namespace tiretherm::post
