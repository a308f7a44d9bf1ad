// SPDX-License-Identifier: BSD-3-Clause
// Takes the energies of each stretch out of their courses and puts the runs beside each other.

#include "post/laps/heat_by_lap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "post/laps/lap_rows.hpp"
#include "post/page/charts.hpp"
#include "post/report/csv.hpp"

namespace tiretherm::post {

using diagnosis::EnergyCourse;
using diagnosis::RunHeat;

namespace {

/// A lap as far as it lies in the run, or the whole run.
struct Stretch {
    std::string name;
    double from = 0.0;
    double to = 0.0;

    [[nodiscard]] double joules(const EnergyCourse& course, std::size_t i) const { return course.between(i, from, to); }
    /// NaN without duration.
    [[nodiscard]] double watts(const EnergyCourse& course, std::size_t i) const {
        return to > from ? joules(course, i) / (to - from) : std::numeric_limits<double>::quiet_NaN();
    }
    [[nodiscard]] double friction(const RunHeat& run) const {
        return run.friction.names.empty() ? std::numeric_limits<double>::quiet_NaN()
                                          : watts(run.friction, 0) + watts(run.friction, 1);
    }
};

Stretch whole(const RunHeat& run) { return {.name = "all", .from = run.start, .to = run.end}; }

std::vector<Stretch> laps_of(const RunHeat& run) {
    std::vector<Stretch> laps;
    for (const input::Lap& lap : run.laps) {
        laps.push_back(
            {.name = lap_name(lap), .from = std::max(run.start, lap.start), .to = std::min(run.end, lap.end)});
    }
    return laps;
}

std::vector<std::string> names_of(const std::vector<RunHeat>& runs) {
    std::vector<std::string> names;
    std::ranges::transform(runs, std::back_inserter(names), &RunHeat::run);
    return short_names(names);
}

/// Effects that bring or take heat in any run, in the order of the case.
std::vector<std::string> effects_of(const std::vector<RunHeat>& runs) {
    std::vector<std::string> effects;
    for (const RunHeat& run : runs) {
        for (std::size_t e = 0; e < run.heat.names.size(); ++e) {
            if (whole(run).joules(run.heat, e) != 0.0 &&
                std::ranges::find(effects, run.heat.names[e]) == effects.end()) {
                effects.push_back(run.heat.names[e]);
            }
        }
    }
    return effects;
}

double mean_watts(const RunHeat& run, const std::string& effect) {
    const auto found = std::ranges::find(run.heat.names, effect);
    return found == run.heat.names.end()
               ? std::numeric_limits<double>::quiet_NaN()
               : whole(run).watts(run.heat, static_cast<std::size_t>(found - run.heat.names.begin()));
}

void for_each_part(const RunHeat& run, const Stretch& stretch, const auto& tell) {
    for (std::size_t i = 0; i < run.friction.names.size(); ++i) {
        tell("friction power " + run.friction.names[i], stretch.joules(run.friction, i),
             stretch.watts(run.friction, i));
    }
    for (std::size_t e = 0; e < run.heat.names.size(); ++e) {
        tell(run.heat.names[e], stretch.joules(run.heat, e), stretch.watts(run.heat, e));
    }
}

DataTable by_run(const std::vector<RunHeat>& runs, const std::vector<std::string>& effects) {
    const std::vector<std::string> names = names_of(runs);
    DataTable table;
    const auto add = [&](const std::string& what, const auto& watts) {
        DataTable::Row row{page_only("mean W", what)};
        for (std::size_t r = 0; r < runs.size(); ++r) {
            row.push_back(page_only(names[r], shown("{:.1f}", watts(runs[r]))));
        }
        table.add_to_page(std::move(row));
    };
    if (std::ranges::any_of(runs, [](const RunHeat& run) { return !run.friction.names.empty(); })) {
        add("friction power", [](const RunHeat& run) { return whole(run).friction(run); });
        for (std::size_t i = 0; i < 2; ++i) {
            add(i == 0 ? "  along (drive and brakes)" : "  across (cornering)", [&](const RunHeat& run) {
                return run.friction.names.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                  : whole(run).watts(run.friction, i);
            });
        }
    }
    for (const std::string& effect : effects) {
        add(effect, [&](const RunHeat& run) { return mean_watts(run, effect); });
    }
    return table;
}

DataTable friction_by_lap(const std::vector<RunHeat>& runs) {
    std::vector<std::vector<input::Lap>> laps;
    std::ranges::transform(runs, std::back_inserter(laps), &RunHeat::laps);
    const std::vector<std::string> names = names_of(runs);
    DataTable table;
    const bool slides = std::ranges::any_of(runs, [](const RunHeat& run) { return !run.friction.names.empty(); });
    for (const std::string& lap : slides ? names_of_laps(laps) : std::vector<std::string>{}) {
        DataTable::Row row{page_only("friction power, mean W in lap", right(lap))};
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const std::vector<Stretch> own = laps_of(runs[r]);
            const auto found = std::ranges::find(own, lap, &Stretch::name);
            row.push_back(
                page_only(names[r], found == own.end() ? right("-") : shown("{:.1f}", found->friction(runs[r]))));
        }
        table.add_to_page(std::move(row));
    }
    return table;
}

Value data_of(const RunHeat& run, const Stretch& stretch) {
    Value::List parts;
    for_each_part(run, stretch, [&](const std::string& what, double joules, double watts) {
        parts.push_back({{"what", what}, {"joules", joules}, {"watts", watts}});
    });
    return {{"lap", stretch.name},
            {"seconds", stretch.to - stretch.from},
            {"friction_watts", stretch.friction(run)},
            {"parts", std::move(parts)}};
}

}  // namespace

bool have_laps_or_corners(const std::vector<RunHeat>& runs) {
    return std::ranges::any_of(runs, [](const RunHeat& run) {
        return (!run.corner.empty() || run.laps.size() > 1) && run.end > run.start &&
               (!run.heat.time.empty() || !run.friction.names.empty());
    });
}

ReportSection heat_by_lap_section(const std::vector<RunHeat>& runs, const std::string& heading) {
    ReportSection section(heading);
    if (!have_laps_or_corners(runs)) {
        return section;
    }
    const std::vector<std::string> effects = effects_of(runs);
    section.add(by_run(runs, effects));
    section.say(
        "friction power: all that sliding makes in the contact, by the inputs, before road and tire share it. Below it "
        "what each effect brings into the tire; below zero it takes out.");
    if (DataTable laps = friction_by_lap(runs); !laps.empty()) {
        section.add(std::move(laps));
    }
    std::vector<BarGroup> groups;
    for (const std::string& effect : effects) {
        BarGroup& group = groups.emplace_back(BarGroup{.name = effect, .values = {}});
        std::ranges::transform(runs, std::back_inserter(group.values),
                               [&](const RunHeat& run) { return mean_watts(run, effect); });
    }
    if (!groups.empty() && runs.size() > 1) {
        section.chart("Mean heat of each path, tire by tire", "Above zero a path brings heat in.",
                      grouped_bar_chart("heat", "W", names_of(runs), groups));
    }
    return section;
}

Value heat_by_lap_data(const std::vector<RunHeat>& runs) {
    Value::List list;
    for (const RunHeat& run : have_laps_or_corners(runs) ? runs : std::vector<RunHeat>{}) {
        Value::List laps;
        for (const Stretch& lap : laps_of(run)) {
            laps.push_back(data_of(run, lap));
        }
        Value one{{"run", run.run}, {"corner", text_or_null(run.corner)}};
        one.set(data_of(run, whole(run)));
        one.set("laps", std::move(laps));
        list.push_back(std::move(one));
    }
    return list;
}

std::string heat_csv(const std::vector<RunHeat>& runs) {
    Csv csv({"run", "corner", "lap", "seconds", "what", "joules", "mean watts"});
    for (const RunHeat& run : runs) {
        std::vector<Stretch> stretches = laps_of(run);
        stretches.push_back(whole(run));
        for (const Stretch& stretch : stretches) {
            for_each_part(run, stretch, [&](const std::string& what, double joules, double watts) {
                csv.row(run.run, run.corner, stretch.name, Digits{stretch.to - stretch.from, 9}, what,
                        Digits{joules, 7}, Digits{watts, 6});
            });
        }
    }
    return csv.text();
}

}  // namespace tiretherm::post
