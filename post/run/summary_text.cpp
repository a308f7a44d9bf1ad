#include <fmt/format.h>

#include "solver/celsius.hpp"
#include "solver/channel_unit.hpp"
#include "post/run/comparison.hpp"
#include "post/report/page.hpp"
#include "mesh/place.hpp"
#include "post/run/summary.hpp"
#include "post/run/summary_parts.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

namespace {

std::string degrees(double kelvin) { return fmt::format("{:.2f}", solver::celsius(kelvin)); }

std::string measured_text(const Comparison& c, const solver::ShownUnit& unit) {
    const std::string value = c.low == c.high ? fmt::format("{:.4g}", unit.value(c.low))
                                              : fmt::format("{:.4g} to {:.4g}", unit.value(c.low), unit.value(c.high));
    return c.at_end ? value : fmt::format("{} at {:.6g} s", value, c.time);
}

std::string readings(const RunRecord& run) {
    const std::vector<Comparison> compared = compare(run.problem, run.history);
    Table table({true, true, false, false, false, false, false, true});
    std::vector<std::string> heading{"channel", "unit", "final", "min", "max"};
    if (!compared.empty()) {
        heading.insert(heading.end(), {"measured", "sim - meas", "source"});
    }
    table.add(heading);
    for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
        const solver::ShownUnit unit = solver::shown_unit(run.problem.channels[c].quantity);
        std::vector<std::string> row{run.problem.channels[c].name, unit.name,
                                     fmt::format("{:.2f}", unit.value(run.report.channel_final[c])),
                                     fmt::format("{:.2f}", unit.value(run.report.channel_min[c])),
                                     fmt::format("{:.2f}", unit.value(run.report.channel_max[c]))};
        for (const Comparison& comparison : compared) {
            if (comparison.channel != c) {
                continue;
            }
            if (row.empty()) {  // a further value for the same channel
                row.resize(5);
            }
            row.push_back(measured_text(comparison, unit));
            row.push_back(comparison.difference == 0.0 && comparison.low < comparison.high
                              ? "within"
                              : fmt::format("{:+.2f}", unit.difference(comparison.difference)));
            row.push_back(comparison.source);
            table.add(std::move(row));
            row.clear();
        }
        if (!row.empty()) {
            table.add(std::move(row));
        }
    }
    return table.text(2);
}

std::string extremes(const RunRecord& run) {
    Table table({true, false, true, true});
    const auto add = [&](const char* name, const solver::Report::Extreme& extreme) {
        if (extreme.node >= 0) {
            table.add({name, degrees(extreme.temperature) + " degC", fmt::format("at {:.6g} s", extreme.time),
                       mesh::describe_place(run.problem.mesh, extreme.node)});
        }
    };
    add("hottest", run.report.hottest);
    add("coldest", run.report.coldest);
    return table.text(2);
}

/// Why the run ended early, if it did.
std::string failure_text(const RunRecord& run) {
    const solver::Status& status = run.report.status;
    return status.ok() ? "" : wrap("ended early: " + status.message, 2);
}

}  // namespace

std::string summary_text(const RunRecord& run, bool bold) {
    const std::string& name = run.problem.name;
    const std::string& title = run.problem.title;
    Page page(bold);
    page.add(page.strong(title.empty() || title == name ? name : fmt::format("{} ({})", title, name)) + "\n");
    page.add(failure_text(run));
    if (run.history.rows() > 0) {
        page.add("Readings", readings(run) + extremes(run));
        if (run.hot_spots != nullptr) {
            page.add("Hot spots", hot_spots_text(*run.hot_spots, run.problem.mesh));
        }
        const double symmetry = run.problem.symmetry;
        page.add(symmetry == 1.0 ? std::string("Heat budget")
                                 : fmt::format("Heat budget of the whole specimen, {:g} times the mesh", symmetry),
                 heat_budget_text(run));
    }
    page.add("Cost", cost_text(run));
    std::vector<std::string> warnings = run.warnings;
    warnings.insert(warnings.end(), run.report.warnings.begin(), run.report.warnings.end());
    page.add("Warnings", paragraphs(warnings));
    page.add("Cite", paragraphs(run.problem.sources));
    std::string files;
    for (const std::filesystem::path& file : run.files) {
        files += "  " + file.string() + "\n";
    }
    page.add("Files", files);
    return page.text();
}

}  // namespace tiretherm::post
