// SPDX-License-Identifier: BSD-3-Clause
// The heat budget of a run: what each effect gave or took, and that it adds up to what was stored.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "post/report/number_text.hpp"
#include "post/run/run_sections.hpp"

namespace tiretherm::post {

namespace {

/// How deep the bulk lies below the surface: the length of the link between two nodes, dZ, or else of cells the distance
/// of the two regions' mean depths. m
double bulk_depth(const mesh::Mesh& mesh) {
    if (!mesh.links.empty()) {
        return mesh.links.front().length;
    }
    std::vector<double> depths;
    std::ranges::transform(mesh.centre, std::back_inserter(depths), [](const mesh::Point& place) { return place[2]; });
    const auto mean_depth = [&](std::string_view name) {
        return mesh.regions[static_cast<std::size_t>(mesh.find_region(name))].mean(depths);
    };
    return mean_depth("bulk") - mean_depth("surface");
}

/// Five figures at the largest of the values, so that a column shows what adds up to what.
int decimals_for(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    const int before_point = largest >= 1.0 ? static_cast<int>(std::floor(std::log10(largest))) + 1 : 1;
    return std::clamp(5 - before_point, 1, 4);
}

/// Which heat of sliding, and of a drum, is counted where; empty where nothing slides.
std::string shares_of_sliding(const RunRecord& run) {
    const std::vector<physics::ActiveEffect>& effects = run.problem.effects;
    const auto index_of = [&](std::string_view id) {
        const auto found = std::ranges::find_if(effects, [&](const auto& active) { return active.effect->id == id; });
        return static_cast<std::size_t>(found - effects.begin());
    };
    if (const std::size_t drum = index_of("drum_heating"); drum != effects.size()) {
        const double share =
            effects[drum][static_cast<std::size_t>(physics::find_parameter(*effects[drum].effect, "share"))];
        return fmt::format(
            "drum_heating is what the drum loses to the air; the contact moves heat from tread to drum, and "
            "sliding_friction counts in both{}",
            share < 1.0 ? fmt::format(", for a share of {:g} of what the road takes", share) : "");
    }
    const std::size_t sliding = index_of("sliding_friction");
    if (sliding == effects.size() || run.report.watts[sliding] + run.report.joules[sliding] == 0.0) {
        return {};
    }
    const physics::ActiveEffect& active = effects[sliding];
    const auto number = static_cast<std::size_t>(physics::find_parameter(*active.effect, "partition"));
    const bool charm = active.choices[static_cast<std::size_t>(physics::find_choice(*active.effect, "partition"))] == 1;
    std::string text = charm ? "sliding_friction is the tread's share of the friction power, by the effusivities of "
                               "tread and road; the road's own share is not in this table"
                             : fmt::format(
                                   "sliding_friction is {:g} of the friction power; the other {:g} enters the road and "
                                   "is not in this table",
                                   active[number], 1.0 - active[number]);
    for (const std::string_view road : {"resolved_contact", "travelling_contact", "road_contact"}) {
        if (index_of(road) == effects.size()) {
            continue;
        }
        if (road == "road_contact") {
            text += charm || active[number] >= 1.0 ? "; road_contact removes heat by its film coefficient"
                                                   : "; road_contact additionally removes heat by its film coefficient";
        } else {
            text += fmt::format("; {} is what the road takes out of the tread in the contact, heat of sliding included",
                                road);
        }
    }
    return text;
}

}  // namespace

ReportSection heat_budget_section(const RunRecord& run) {
    const solver::MarchReport& report = run.report;
    std::vector<double> watts;
    std::vector<double> kilojoules;
    std::vector<std::string> names;
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        const physics::Effect& effect = *run.problem.effects[e].effect;
        // Property modifiers and sensor models have no heat of their own, and what conducts only moves it.
        const bool has_terms = effect.heat_effect() != nullptr && effect.kind != physics::EffectKind::property;
        const bool within =
            !run.problem.effects[e].coupling_faces.empty() && report.watts[e] == 0.0;  // from node to node
        if ((has_terms && !within) || report.joules[e] != 0.0) {
            names.emplace_back(run.problem.effects[e].title());
            watts.push_back(run.problem.symmetry * report.watts[e]);
            kilojoules.push_back(run.problem.symmetry * report.joules[e] / 1e3);
        }
    }
    const int of_watts = decimals_for(watts);
    const int of_kilojoules = decimals_for(kilojoules);
    names.emplace_back("sum");
    watts.push_back(std::accumulate(watts.begin(), watts.end(), 0.0));
    kilojoules.push_back(std::accumulate(kilojoules.begin(), kilojoules.end(), 0.0));
    const bool steady = run.problem.settings.steady;  // no time passes, so nothing is summed up or stored
    DataTable table;
    const auto add = [&](const std::string& name, const std::string& of_watt, const std::string& kilojoule) {
        table.add({page_only("heat into it", name), page_only(steady ? "W" : "W at the end", right(of_watt)),
                   page_only(steady ? "" : "kJ in all", right(steady ? "" : kilojoule))});
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        add(names[i], with_decimals(watts[i], of_watts), with_decimals(kilojoules[i], of_kilojoules));
    }
    const double symmetry = run.problem.symmetry;
    if (!steady) {
        add("stored", "", with_decimals(symmetry * report.stored / 1e3, of_kilojoules));
    }
    ReportSection section(symmetry == 1.0
                              ? std::string("Heat budget")
                              : fmt::format("Heat budget of the whole specimen, {:g} times the mesh", symmetry),
                          std::move(table));
    section.say(fmt::format("energy balance error {:.1e} ({}, relative to all heat exchanged)", report.energy_closure,
                            steady ? "sum" : "stored minus sum"));
    if (std::string sliding = shares_of_sliding(run); !sliding.empty()) {
        section.say(std::move(sliding));
    }
    const std::vector<physics::ActiveEffect>& effects = run.problem.effects;
    for (std::size_t e = 0; e < effects.size(); ++e) {
        const double share = run.problem.symmetry * report.law_watts[e];
        if (std::abs(share) >= 0.5 * std::pow(10.0, -of_watts)) {  // neither NaN nor what is shown as nothing
            section.say(fmt::format("{} contributes {:+.{}f} W of this", effects[e].title(), share, of_watts));
        }
    }
    const bool is_tire = std::any_of(effects.begin(), effects.end(),
                                     [](const physics::ActiveEffect& active) { return active.effect->needs_tire; });
    if (is_tire && report.effective_two_node_conductance > 0.0) {  // where heat goes the other way, no link carries it
        const double link = run.problem.symmetry * report.effective_two_node_conductance;
        const double depth = bulk_depth(run.problem.mesh);
        section.say(fmt::format("equivalent two-node link: {:.4g} W/K, or k = {:.3g} W/mK over {:.3g} mm{}", link,
                                link * depth / run.problem.tire.outer_area(), 1e3 * depth,
                                run.problem.mesh.links.empty() ? ", the mean depth of the bulk" : ""));
    }
    return section;
}

}  // namespace tiretherm::post
