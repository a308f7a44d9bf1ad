// SPDX-License-Identifier: BSD-3-Clause
// Tables and data of the laws, and what was measured beside them.

#include "post/run/tire_laws.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/page/charts.hpp"
#include "post/report/csv.hpp"
#include "post/run/shown_laws.hpp"

namespace tiretherm::post {

namespace {

bool has_tire(const solver::Problem& problem) {
    return std::ranges::any_of(problem.effects, [](const auto& active) { return active.effect->needs_tire; });
}

constexpr ShownLaw stiffness_law{"cornering stiffness", "cornering_stiffness", "kN/rad", 1e-3, 2, nullptr, nullptr, ""};

/// What was measured beside the laws, a row each.
DataTable measured_table(const solver::Problem& problem) {
    DataTable table;
    const auto add = [&](const ShownLaw& as, double load, std::optional<double> T, double measured, double computed) {
        const auto number = [&](double value) {
            return Cell(Value(as.factor * value), fmt::format("{:.{}f}", as.factor * value, as.decimals));
        };
        table.add({Field("law", "law", Cell(Value(as.key), as.name, false)),
                   Field("load N", "vertical_load", shown("{:.4g}", load)),
                   Field("bulk degC", "bulk_temperature", T ? shown("{:.4g}", celsius(*T)) : Cell(Value(), "", true)),
                   Field("measured", "measured", number(measured)), Field("computed", "computed", number(computed)),
                   Field("", "unit", Cell(as.unit)),
                   Field("differs by %", "difference_percent", shown("{:+.2f}", 100.0 * (computed / measured - 1.0)))});
    };
    for (const ShownLaw& law : shown_laws) {
        const std::optional<physics::Curve>& points = problem.handling.measured.*law.measured;
        for (std::size_t i = 0; points && i < points->table_x().size(); ++i) {
            const double load = points->table_x()[i];
            add(law, load, {}, points->table_y()[i], (problem.tire.*law.law)(load));
        }
    }
    for (const auto& [load, T, stiffness] : problem.handling.measured.cornering_stiffness) {
        add(stiffness_law, load, T, stiffness, shown_stiffness(problem, load, T));
    }
    return table;
}

/// Rows of loads, columns of temperatures.
DataTable stiffness_table(const solver::Problem& problem) {
    const StiffnessMap map = stiffness_map(problem);
    DataTable table;
    for (const double load : map.loads) {
        DataTable::Row row{page_only("load N", shown("{:.4g}", load))};
        for (const double T : map.temperatures) {
            row.push_back(page_only(fmt::format("{:.4g} degC", celsius(T)),
                                    shown("{:.4g}", 1e-3 * shown_stiffness(problem, load, T))));
        }
        table.add(std::move(row));
    }
    return table;
}

}  // namespace

std::vector<CompoundPeak> compound_peaks(const solver::Problem& problem) {
    std::vector<CompoundPeak> found;
    for (const physics::ActiveEffect& active : problem.effects) {
        for (std::size_t layer = 0;
             active.effect->id == "strain_energy_loss" && !active.total && layer < problem.mesh.layers.size();
             ++layer) {
            const physics::LossPeak peak = physics::loss_peak(active, static_cast<int>(layer));
            auto same = std::ranges::find(found, peak, &CompoundPeak::peak);
            if (same == found.end()) {
                same = found.insert(same, {.peak = peak, .layers = {}});
            }
            same->layers.push_back(problem.mesh.layers[layer]);
        }
    }
    return found;
}

bool shows_stiffness(const solver::Problem& problem) {
    using enum solver::Quantity;
    return has_tire(problem) &&
           (problem.handling.is_given || std::ranges::any_of(problem.channels, [](const solver::Channel& channel) {
                return channel.quantity == solver::Quantity::cornering_stiffness || channel.quantity == lateral_force ||
                       channel.quantity == bulk_temperature_factor;
            }));
}

ReportSection tire_laws_section(const solver::Problem& problem) {
    ReportSection section("Tire laws");
    if (!has_tire(problem)) {
        return section;
    }
    if (DataTable measured = measured_table(problem); !measured.empty()) {
        section.say("What was measured of the tire beside its laws:");
        section.add(std::move(measured));
    }
    if (shows_stiffness(problem)) {
        section.say("Cornering stiffness in kN/rad, by load and temperature of the bulk:");
        section.add(stiffness_table(problem));
        add_stiffness_chart(section, problem);
    }
    add_law_charts(section, problem);
    return section;
}

Value tire_laws_data(const solver::Problem& problem) {
    if (!has_tire(problem)) {
        return {};
    }
    Value::List peaks;
    for (const CompoundPeak& compound : compound_peaks(problem)) {
        peaks.push_back({{"layers", compound.layers},
                         {"temperature", celsius(compound.peak.temperature)},
                         {"value", compound.peak.value},
                         {"frequency", compound.peak.frequency}});
    }
    Value::List laws;
    for (const double load : shown_loads(problem)) {
        Value row{{"vertical_load", load}};
        for (const ShownLaw& law : shown_laws) {
            row.set(law.key, rounded(law.factor * (problem.tire.*law.law)(load), 9));
        }
        laws.push_back(std::move(row));
    }
    Value units{{"vertical_load", "N"}, {"temperature", "degC"}, {"frequency", "Hz"}, {"cornering_stiffness", "N/rad"}};
    for (const ShownLaw& law : shown_laws) {
        units.set(law.key, law.unit);
    }
    Value data{{"loss_tangent_peaks", std::move(peaks)}, {"laws", std::move(laws)}};
    if (const DataTable measured = measured_table(problem); !measured.empty()) {
        data.set("measured", measured.data());
    }
    if (shows_stiffness(problem)) {
        Value::List rows;
        const StiffnessMap map = stiffness_map(problem);
        for (const double load : map.loads) {
            for (const double T : map.temperatures) {
                rows.push_back({{"vertical_load", load},
                                {"bulk_temperature", celsius(T)},
                                {"cornering_stiffness", rounded(shown_stiffness(problem, load, T), 9)}});
            }
        }
        data.set("cornering_stiffness", std::move(rows));
    }
    data.set("units", std::move(units));
    return data;
}

std::string cornering_stiffness_csv(const solver::Problem& problem) {
    if (!shows_stiffness(problem)) {
        return {};
    }
    Csv csv({"vertical_load [N]", "bulk_temperature [degC]", "cornering_stiffness [N/rad]"});
    const StiffnessMap map = stiffness_map(problem);
    for (const double load : map.loads) {
        for (const double T : map.temperatures) {
            csv.row(Digits{load, 9}, Digits{celsius(T), 9}, Digits{shown_stiffness(problem, load, T), 9});
        }
    }
    return csv.text();
}

}  // namespace tiretherm::post
