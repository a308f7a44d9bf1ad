// SPDX-License-Identifier: BSD-3-Clause
// A chart for each kind of law, with the materials that have it.
#include "post/identification/law_charts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "post/identification/fitted_laws.hpp"
#include "post/page/charts.hpp"

namespace tiretherm::post {

namespace {

void add_law(LineChart& chart, const FittedLaw& law, const std::vector<double>& celsius) {
    if (!law.deviation.empty()) {
        std::vector<double> lower;
        std::vector<double> upper;
        for (std::size_t i = 0; i < law.fitted.size(); ++i) {
            lower.push_back(law.fitted[i] - to_95 * law.deviation[i]);
            upper.push_back(law.fitted[i] + to_95 * law.deviation[i]);
        }
        chart.add_band(law.material + ", 95 %", law.material, celsius, lower, upper);
    }
    chart.add_curve(law.material + ", fitted", law.material, CurveRole::line, celsius, law.fitted);
    chart.add_curve(law.material + ", case", law.material, CurveRole::dashed, celsius, law.before);
}

}  // namespace

ReportSection law_charts(const IdentificationRecord& record) {
    ReportSection section("Fitted laws");
    const FittedLaws found = fitted_laws(record);
    for (auto law = found.laws.begin(); law != found.laws.end();) {
        LineChart chart("temperature", "°C", found.celsius.front(), found.celsius.back());
        chart.add_panel(law->name, law->unit);
        std::string title = law->name;
        title.front() = static_cast<char>(title.front() - 'a' + 'A');
        const auto end = std::find_if(law, found.laws.end(), [&](const FittedLaw& one) { return one.key != law->key; });
        for (; law != end; ++law) {
            add_law(chart, *law, found.celsius);
        }
        section.chart(
            std::move(title),
            fmt::format("From {:.1f} to {:.1f} °C, what sensors and cameras have measured. The band is of first order, "
                        "from the intervals of the parameters and their correlation. As numbers: laws.csv.",
                        found.celsius.front(), found.celsius.back()),
            chart.data());
    }
    return section;
}

}  // namespace tiretherm::post
