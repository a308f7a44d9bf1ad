#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "post/celsius.hpp"
#include "post/comparison.hpp"
#include "post/place.hpp"
#include "post/summary.hpp"
#include "post/table.hpp"

namespace tiretherm::post {

namespace {

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

std::string degrees(double kelvin) { return fmt::format("{:.2f}", celsius(kelvin)); }

/// Five figures at the largest of the values, so that a column shows what adds up to what.
int decimals_for(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    const int before_point = largest >= 1.0 ? static_cast<int>(std::floor(std::log10(largest))) + 1 : 1;
    return std::clamp(5 - before_point, 1, 4);
}

std::string measured_text(const Comparison& c) {
    const std::string value = c.low == c.high ? fmt::format("{:.4g}", celsius(c.low))
                                              : fmt::format("{:.4g} to {:.4g}", celsius(c.low), celsius(c.high));
    return c.at_end ? value : fmt::format("{} at {:.6g} s", value, c.time);
}

std::string temperatures(const RunRecord& run) {
    const std::vector<Comparison> compared = compare(run.problem, run.history);
    Table table({true, false, false, false, false, false, true});
    std::vector<std::string> heading{"degC", "final", "min", "max"};
    if (!compared.empty()) {
        heading.insert(heading.end(), {"measured", "meas - sim", "source"});
    }
    table.add(heading);
    for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
        std::vector<std::string> row{run.problem.channels[c].name, degrees(run.report.channel_final[c]),
                                     degrees(run.report.channel_min[c]), degrees(run.report.channel_max[c])};
        for (const Comparison& comparison : compared) {
            if (comparison.channel != c) {
                continue;
            }
            if (row.empty()) {  // a further value for the same channel
                row.resize(4);
            }
            row.push_back(measured_text(comparison));
            row.push_back(comparison.difference == 0.0 && comparison.low < comparison.high
                              ? "within"
                              : fmt::format("{:+.2f}", comparison.difference));
            row.push_back(comparison.source);
            table.add(std::move(row));
            row.clear();
        }
        if (!row.empty()) {
            table.add(std::move(row));
        }
    }
    return joined(table.lines(2));
}

std::string extremes(const RunRecord& run) {
    Table table({true, false, true, true});
    const auto add = [&](const char* name, const solver::Report::Extreme& extreme) {
        if (extreme.node >= 0) {
            table.add({name, degrees(extreme.temperature) + " degC", fmt::format("at {:.6g} s", extreme.time),
                       describe_place(run.problem.mesh, extreme.node)});
        }
    };
    add("hottest", run.report.hottest);
    add("coldest", run.report.coldest);
    return joined(table.lines(2));
}

std::string budget(const RunRecord& run) {
    const solver::Report& report = run.report;
    std::vector<double> watts;
    std::vector<double> kilojoules;
    std::vector<std::string> names;
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        const physics::Effect& effect = *run.problem.effects[e].effect;
        // A property moves heat inside; only sources and losses have a line in the budget.
        if (effect.kind != physics::Kind::property || report.joules[e] != 0.0) {
            names.emplace_back(effect.id);
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
    Table table({true, false, false});
    table.add({"heat into it", steady ? "W" : "W at the end", steady ? "" : "kJ in all"});
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.add({names[i], fmt::format("{:.{}f}", watts[i], of_watts),
                   steady ? "" : fmt::format("{:.{}f}", kilojoules[i], of_kilojoules)});
    }
    if (!steady) {
        table.add({"stored", "", fmt::format("{:.{}f}", run.problem.symmetry * report.stored / 1e3, of_kilojoules)});
    }
    std::string text = joined(table.lines(2));
    text += fmt::format("  energy closure {:.1e}: {} over the heat turned over\n", report.energy_closure,
                        steady ? "sum" : "stored less sum,");
    const std::vector<physics::ActiveEffect>& effects = run.problem.effects;
    const bool is_tire = std::any_of(effects.begin(), effects.end(),
                                     [](const physics::ActiveEffect& active) { return active.effect->needs_tire; });
    if (is_tire && std::isfinite(report.effective_link)) {
        text += fmt::format("  as a two-node model, its link would be {:.4g} W/K\n", run.problem.symmetry * report.effective_link);
    }
    return text;
}

/// Why the run ended early, if it did.
std::string ending(const RunRecord& run) {
    const solver::Status& status = run.report.status;
    return status.ok() ? "" : wrap("ended early: " + status.message, 2);
}

std::string cost(const RunRecord& run) {
    const solver::Report& report = run.report;
    const mesh::Mesh& mesh = run.problem.mesh;
    const bool round = mesh.grid && mesh.grid->metric == mesh::Metric::axisymmetric;
    std::string layers;
    for (const std::string& name : mesh.layers) {
        layers += (layers.empty() ? "" : ", ") + name;
    }
    Table table({true, true});
    table.add({"mesh", fmt::format("{}{}, {} cells, layers {}", mesh.kind, round ? " about its axis" : "", grouped(mesh.n_cells), layers)});
    if (run.problem.settings.steady) {
        table.add({"steps", fmt::format("steady state; {} factorisations, {} Newton iterations", report.factorisations,
                                        report.newton_iterations)});
    } else {
        table.add({"steps", fmt::format("{}, {} rejected, {} factorisations", grouped(static_cast<double>(report.steps)),
                                        report.rejected, report.factorisations)});
    }
    table.add({"solver", report.linear_solver});
    std::string time = fmt::format("{:.3f} s", run.seconds);
    if (report.simulated > 0.0 && run.seconds > 0.0) {
        time += fmt::format(" for {:.6g} s, {} x real time", report.simulated, grouped(report.simulated / run.seconds));
    }
    constexpr std::array parts{"assembly", "factor", "solve", "output"};
    for (std::size_t i = 0; i < std::min(parts.size(), report.seconds.size()); ++i) {
        time += fmt::format("{}{} {:.3f}", i == 0 ? "; " : ", ", parts[i], report.seconds[i]);
    }
    table.add({"time", time});
    return joined(table.lines(2));
}

std::string items(const std::vector<std::string>& texts) {
    std::string lines;
    for (const std::string& text : texts) {
        lines += wrap(text, 2);
    }
    return lines;
}

}  // namespace

std::string summary_text(const RunRecord& run, bool bold) {
    const auto heading = [&](const std::string& text) {
        return bold ? fmt::format("\n\033[1m{}\033[0m\n", text) : "\n" + text + "\n";
    };
    const std::string& title = run.problem.title;
    std::string text = (title.empty() ? run.problem.name : fmt::format("{} ({})", title, run.problem.name)) + "\n";
    text = (bold ? fmt::format("\033[1m{}\033[0m", text) : text) + ending(run);

    if (run.history.rows() > 0) {
        text += heading("Temperatures") + temperatures(run) + extremes(run);
        const double symmetry = run.problem.symmetry;
        text += heading(symmetry == 1.0 ? std::string("Heat budget")
                                        : fmt::format("Heat budget of the whole specimen, {:g} times the mesh", symmetry));
        text += budget(run);
    }
    text += heading("Cost") + cost(run);

    std::vector<std::string> warnings = run.warnings;
    warnings.insert(warnings.end(), run.report.warnings.begin(), run.report.warnings.end());
    if (!warnings.empty()) {
        text += heading("Warnings") + items(warnings);
    }
    if (!run.problem.sources.empty()) {
        text += heading("Cite") + items(run.problem.sources);
    }
    if (!run.files.empty()) {
        text += heading("Files");
        for (const std::filesystem::path& file : run.files) {
            text += "  " + file.string() + "\n";
        }
    }
    return text;
}

}  // namespace tiretherm::post
