// SPDX-License-Identifier: BSD-3-Clause
// Evaluates laws at the fitted numbers and beside them.
#include "post/identification/law_charts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/page/charts.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr int points = 61;
constexpr double to_95 = 1.959964;  ///< standard deviations

enum class Law { through, along, capacity };

const physics::Curve& curve_of(const physics::Material& material, Law law) {
    switch (law) {
        case Law::through:
            return material.along(mesh::Axis::through);
        case Law::along:
            return material.conductivity.front();
        case Law::capacity:
            break;
    }
    return material.heat_capacity;
}

/// Lowest and highest temperature that was measured. K; nothing measured: low > high
std::pair<double, double> measured_range(const IdentificationRecord& record) {
    double low = 1e300;
    double high = -1e300;
    const auto& channels = record.experiment.runs.front().problem.channels;
    for (std::size_t i = 0; i < record.observations.rows.size(); ++i) {
        const Observations::Row& row = record.observations.rows[i];
        if (row.image < 0 && channels[row.channel].quantity == solver::Quantity::temperature) {
            low = std::min(low, record.observations.measured[static_cast<Eigen::Index>(i)]);
            high = std::max(high, record.observations.measured[static_cast<Eigen::Index>(i)]);
        }
    }
    return {low, high};
}

std::vector<double> values_of(const physics::Curve& curve, const std::vector<double>& kelvin) {
    std::vector<double> values;
    for (const double T : kelvin) {
        values.push_back(curve.value(T));
    }
    return values;
}

/// Standard deviation of a law at each temperature, from what a small step of each number does to it.
/// @returns empty where a number that moves it has no interval
std::vector<double> deviations(const IdentificationRecord& record, const Simulator& simulator, std::size_t material,
                               Law law, const std::vector<double>& kelvin) {
    const Identification& result = record.result;
    const auto n = static_cast<Eigen::Index>(result.fitted.size());
    const std::vector<double> centre =
        values_of(curve_of(simulator.problem(0, result.values).materials[material], law), kelvin);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(kelvin.size()), n);
    for (Eigen::Index p = 0; p < n; ++p) {
        const double sigma = result.fitted[static_cast<std::size_t>(p)].standard_deviation;
        const double size = std::max(std::abs(result.values[p]), 1e-9);
        const double step = std::isfinite(sigma) && sigma > 0.0 ? 0.01 * sigma : 1e-4 * size;
        Eigen::VectorXd beside = result.values;
        beside[p] += step;
        const std::vector<double> moved =
            values_of(curve_of(simulator.problem(0, beside).materials[material], law), kelvin);
        for (std::size_t i = 0; i < kelvin.size(); ++i) {
            slope(static_cast<Eigen::Index>(i), p) = (moved[i] - centre[i]) / step;
        }
        if (!(std::isfinite(sigma) && sigma > 0.0)) {
            if (slope.col(p).cwiseAbs().maxCoeff() > 0.0) {
                return {};
            }
            continue;
        }
        slope.col(p) *= sigma;
    }
    std::vector<double> found;
    for (Eigen::Index i = 0; i < slope.rows(); ++i) {
        const Eigen::VectorXd row = slope.row(i).transpose();
        found.push_back(std::sqrt(std::max(0.0, row.dot(result.correlation * row))));
    }
    return found;
}

}  // namespace

Section law_charts(const IdentificationRecord& record) {
    Section section("Fitted laws");
    const auto [low, high] = measured_range(record);
    const Identification& result = record.result;
    const auto n = static_cast<Eigen::Index>(result.fitted.size());
    if (!(high > low) || result.correlation.rows() != n) {
        return section;
    }
    std::vector<double> kelvin;
    std::vector<double> celsius;
    for (int i = 0; i < points; ++i) {
        kelvin.push_back(low + (high - low) * i / (points - 1));
        celsius.push_back(solver::celsius(kelvin.back()));
    }
    const Simulator simulator(record.experiment, record.observations);
    const solver::Problem before = simulator.problem(0, simulator.start());
    const solver::Problem after = simulator.problem(0, result.values);
    struct Kind {
        Law law;
        const char* name;
        const char* unit;
    };
    std::vector<std::string> done;
    for (const Kind& kind : {Kind{Law::through, "conductivity through the thickness", "W/(m K)"},
                             Kind{Law::along, "conductivity along the surface", "W/(m K)"},
                             Kind{Law::capacity, "heat capacity", "J/(kg K)"}}) {
        LineChart chart("temperature", "°C", celsius.front(), celsius.back());
        bool any = false;
        for (std::size_t m = 0; m < after.materials.size(); ++m) {
            const physics::Material& fitted = after.materials[m];
            const bool isotropic = fitted.along(mesh::Axis::through) == fitted.conductivity.front();
            const std::string id = fmt::format("{} {}", static_cast<int>(kind.law), fitted.name);
            if (curve_of(fitted, kind.law) == curve_of(before.materials[m], kind.law) ||
                (kind.law == Law::along && isotropic) || std::ranges::find(done, id) != done.end()) {
                continue;
            }
            done.push_back(id);
            if (!any) {
                chart.add_panel(kind.name, kind.unit);
                any = true;
            }
            const std::vector<double> values = values_of(curve_of(fitted, kind.law), kelvin);
            const std::vector<double> sigma = deviations(record, simulator, m, kind.law, kelvin);
            if (!sigma.empty()) {
                std::vector<double> lower;
                std::vector<double> upper;
                for (std::size_t i = 0; i < values.size(); ++i) {
                    lower.push_back(values[i] - to_95 * sigma[i]);
                    upper.push_back(values[i] + to_95 * sigma[i]);
                }
                chart.add_band(fitted.name + ", 95 %", fitted.name, celsius, lower, upper);
            }
            chart.add_curve(fitted.name + ", fitted", fitted.name, CurveRole::line, celsius, values);
            chart.add_curve(fitted.name + ", case", fitted.name, CurveRole::dashed, celsius,
                            values_of(curve_of(before.materials[m], kind.law), kelvin));
        }
        if (any) {
            std::string title = kind.name;
            title.front() = static_cast<char>(title.front() - 'a' + 'A');
            section.chart(std::move(title),
                          "Over the temperatures that were measured. The band is of first order, from the intervals of "
                          "the parameters and their correlation.",
                          chart.data());
        }
    }
    return section;
}

}  // namespace tiretherm::post
