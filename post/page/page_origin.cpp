// SPDX-License-Identifier: BSD-3-Clause
// The build gives the program's version, its commit and the versions of the libraries that it was built with.
#include "post/page/page_origin.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "solver/compared_ranges.hpp"

namespace tiretherm::post {

ReportSection origin_section(const PageOrigin& origin) {
    ReportSection section("Files and versions");
    DataTable table;
    const auto add = [&](const std::string& name, const std::string& text) {
        if (!text.empty()) {
            table.add({page_only("", name), page_only("", text)});
        }
    };
    add("command", "tiretherm " + origin.kind);
    add("case file", origin.source);
    bool first = true;
    for (const std::string& file : origin.files) {
        if (file != origin.source) {
            add(first ? "reads" : "", file);
            first = false;
        }
    }
    const std::string commit = TIRETHERM_COMMIT;
    add("program", fmt::format("tiretherm {}{}", TIRETHERM_VERSION, commit.empty() ? "" : ", commit " + commit));
    add("libraries", TIRETHERM_LIBRARIES);
    section.add(std::move(table));
    return section;
}

ReportSection citations_section(const solver::Problem& problem) {
    ReportSection section("Cite");
    section.item(
        fmt::format("the tiretherm authors: tiretherm: finite-volume temperature field of a rolling tire, version {}. "
                    "CITATION.cff in its sources has the entry",
                    TIRETHERM_VERSION));
    std::vector<std::pair<std::string, std::vector<std::string>>> sources;  // with the effects that come from it
    for (const std::string& source : problem.sources) {
        sources.push_back({source, {"this case"}});
    }
    for (const physics::ActiveEffect& active : problem.effects) {
        const std::string source(active.effect->source);
        if (source.empty()) {
            continue;
        }
        auto known = std::ranges::find(sources, source, &std::pair<std::string, std::vector<std::string>>::first);
        if (known == sources.end()) {
            known = sources.insert(sources.end(), {source, {}});
        }
        const std::string name(active.title());
        if (std::ranges::find(known->second, name) == known->second.end()) {
            known->second.push_back(name);
        }
    }
    for (const auto& [source, effects] : sources) {
        section.item(fmt::format("{} ({})", source, fmt::join(effects, ", ")));
    }
    ReportSection ranges("Where its laws hold");
    const std::vector<solver::BeyondCompared> beyond = solver::beyond_compared(problem);
    for (const physics::ActiveEffect& active : problem.effects) {
        if (!active.effect->valid.empty()) {
            std::string text = fmt::format("{}: {}", active.title(), active.effect->valid);
            for (const solver::BeyondCompared& law : beyond) {
                text += law.effect == active.effect->id ? "; " + law.text() : "";
            }
            ranges.item(std::move(text));
        }
    }
    section.add(std::move(ranges));
    return section;
}

}  // namespace tiretherm::post
