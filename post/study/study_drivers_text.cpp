// SPDX-License-Identifier: BSD-3-Clause
// Formats the regression of a study: strongest quantities, explained variance, and the probability of passing the
// critical temperature.

#include "post/study/study_drivers_text.hpp"

#include <fmt/format.h>

#include "post/report/table.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

std::string regression_text(const StudyRegression& line, std::optional<double> critical) {
    if (!line.exists()) {
        return {};
    }
    Table table({true, false, false, true, false, false, false});
    table.add({"", "mean", "+-", "unit", "K per +-", "95 %", "share %"});
    for (const StudyDriver& driver : line.drivers) {
        table.add({driver.key, fmt::format("{:.4g}", driver.mean), fmt::format("{:.3g}", driver.standard_deviation),
                   driver.unit, fmt::format("{:+.2f}", driver.kelvin), fmt::format("{:.2f}", driver.uncertainty),
                   fmt::format("{:.1f}", 100.0 * driver.share)});
    }
    std::string worth = fmt::format(
        "a linear function of these explains {:.1f} % of the variance (R2); it is {:.1f} +- {:.1f} degC (one standard "
        "deviation), and leaves {:.2f} K over",
        100.0 * line.r_squared, solver::celsius(line.mean), line.standard_deviation, line.residual);
    if (critical) {
        worth += fmt::format("; normal and as wide as both, it would pass {:.6g} degC with {:.1f} %",
                             solver::celsius(*critical), 100.0 * line.chance_above(*critical));
    }
    return table.text(2) + wrap(worth, 2);
}

}  // namespace tiretherm::post
