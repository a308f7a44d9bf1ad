// SPDX-License-Identifier: BSD-3-Clause
// Evaluates laws at the fitted parameters and beside them.
#include "post/identification/fitted_laws.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/report/csv.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr int points = 61;

enum class MaterialLaw { through, along, capacity };

const physics::Curve& curve_of(const physics::Material& material, MaterialLaw law) {
    switch (law) {
        case MaterialLaw::through:
            return material.along(mesh::Axis::through);
        case MaterialLaw::along:
            return material.conductivity.front();
        case MaterialLaw::capacity:
            break;
    }
    return material.heat_capacity;
}

/// Lowest and highest temperature that sensors, single readings and cameras have measured. K; nothing measured: low > high
std::pair<double, double> measured_range(const IdentificationRecord& record) {
    double low = 1e300;
    double high = -1e300;
    const auto take = [&](double kelvin) {
        low = std::isfinite(kelvin) ? std::min(low, kelvin) : low;
        high = std::isfinite(kelvin) ? std::max(high, kelvin) : high;
    };
    const auto& channels = record.experiment.runs.front().problem.channels;
    for (std::size_t i = 0; i < record.observations.rows.size(); ++i) {
        const Observations::Row& row = record.observations.rows[i];
        // Rows of images are bands of their sizes, no temperatures.
        if (row.image < 0 && channels[row.channel].quantity == solver::Quantity::temperature) {
            take(record.observations.measured[static_cast<Eigen::Index>(i)]);
        }
    }
    for (const input::MeasuredRun& run : record.experiment.runs) {
        for (const input::MeasuredFrames& frames : run.frames) {
            std::ranges::for_each(frames.value, take);
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

/// Standard deviation of a law at each temperature, from what a small step of each parameter does to it.
/// @returns empty where a parameter that moves it has no interval
std::vector<double> deviations(const IdentificationRecord& record, const Simulator& simulator, std::size_t material,
                               MaterialLaw law, const std::vector<double>& kelvin) {
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

FittedLaws fitted_laws(const IdentificationRecord& record) {
    FittedLaws found;
    const auto [low, high] = measured_range(record);
    const Identification& result = record.result;
    if (!(high > low) || result.correlation.rows() != static_cast<Eigen::Index>(result.fitted.size())) {
        return found;
    }
    std::vector<double> kelvin;
    for (int i = 0; i < points; ++i) {
        kelvin.push_back(low + (high - low) * i / (points - 1));
        found.celsius.push_back(celsius(kelvin.back()));
    }
    const Simulator simulator(record.experiment, record.observations);
    const solver::Problem before = simulator.problem(0, simulator.start());
    const solver::Problem after = simulator.problem(0, result.values);
    struct Kind {
        MaterialLaw law;
        const char* key;
        const char* name;
        const char* unit;
    };
    for (const Kind& kind :
         {Kind{MaterialLaw::through, "conductivity", "conductivity through the thickness", "W/(m K)"},
          Kind{MaterialLaw::along, "conductivity_along", "conductivity along the surface", "W/(m K)"},
          Kind{MaterialLaw::capacity, "heat_capacity", "heat capacity", "J/(kg K)"}}) {
        for (std::size_t m = 0; m < after.materials.size(); ++m) {
            const physics::Material& fitted = after.materials[m];
            const physics::Curve& curve = curve_of(fitted, kind.law);
            const bool is_isotropic = fitted.along(mesh::Axis::through) == fitted.conductivity.front();
            const bool is_known = std::ranges::any_of(
                found.laws, [&](const FittedLaw& law) { return law.key == kind.key && law.material == fitted.name; });
            if (curve == curve_of(before.materials[m], kind.law) || (kind.law == MaterialLaw::along && is_isotropic) ||
                is_known) {
                continue;
            }
            found.laws.push_back({.material = fitted.name,
                                  .key = kind.key,
                                  .name = kind.name,
                                  .unit = kind.unit,
                                  .before = values_of(curve_of(before.materials[m], kind.law), kelvin),
                                  .fitted = values_of(curve, kelvin),
                                  .deviation = deviations(record, simulator, m, kind.law, kelvin)});
        }
    }
    return found;
}

std::string laws_csv(const FittedLaws& laws) {
    std::vector<std::string> headings{"temperature [degC]"};
    for (const FittedLaw& law : laws.laws) {
        for (const char* column : {"", " case", " low", " high"}) {
            headings.push_back(fmt::format("{} {}{} [{}]", law.material, law.key, column, law.unit));
        }
    }
    Csv csv(headings);
    for (std::size_t i = 0; i < laws.celsius.size(); ++i) {
        csv.add(Digits{laws.celsius[i], 6});
        for (const FittedLaw& law : laws.laws) {
            const double half = law.deviation.empty() ? std::nan("") : to_95 * law.deviation[i];
            for (const double value : {law.fitted[i], law.before[i], law.fitted[i] - half, law.fitted[i] + half}) {
                csv.add(Digits{value, 6});
            }
        }
        csv.end_row();
    }
    return csv.text();
}

std::string parameters_csv(const IdentificationRecord& record) {
    const Identification& result = record.result;
    const std::vector<solver::FreeParameter>& parameters = record.experiment.parameters;
    std::vector<std::string> headings{"parameter", "unit", "fitted", "standard_deviation",       "low",
                                      "high",      "case", "prior",  "prior_standard_deviation", "identifiability"};
    const bool has_correlation = result.correlation.rows() == static_cast<Eigen::Index>(parameters.size());
    for (const solver::FreeParameter& parameter : parameters) {
        if (has_correlation) {
            headings.push_back(fmt::format("correlation with {}", parameter.name));
        }
    }
    Csv csv(headings);
    for (std::size_t j = 0; j < parameters.size(); ++j) {
        const Fitted& one = result.fitted[j];
        csv.add(parameters[j].name);
        csv.add(slashed_unit(parameters[j].unit));
        const bool has_prior = std::isfinite(parameters[j].standard_deviation);
        for (const double value : {one.value, one.standard_deviation, one.low, one.high, one.before,
                                   has_prior ? parameters[j].prior : std::nan(""), parameters[j].standard_deviation}) {
            csv.add(Digits{value, 8});
        }
        csv.add(word_of(one.identifiability));
        for (Eigen::Index k = 0; has_correlation && k < result.correlation.rows(); ++k) {
            csv.add(Digits{result.correlation(static_cast<Eigen::Index>(j), k), 6});
        }
        csv.end_row();
    }
    return csv.text();
}

}  // namespace tiretherm::post
