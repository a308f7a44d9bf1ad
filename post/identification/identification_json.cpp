#include <cmath>

#include <nlohmann/json.hpp>

#include "post/identification/identification_report.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither infinity nor NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json fitted_json(const solver::FreeParameter& parameter, const Fitted& one) {
    return {{"name", parameter.name},
            {"unit", parameter.unit},
            {"case", number(one.before)},
            {"value", number(one.value)},
            {"standard_deviation", number(one.standard_deviation)},
            {"low", number(one.low)},
            {"high", number(one.high)},
            {"interval", one.profiled ? "profile" : "wald"},
            {"low_is_open", one.low_is_open},
            {"high_is_open", one.high_is_open},
            {"moved_by_grid_correction", number(one.by_grid)},
            {"prior", std::isfinite(parameter.standard_deviation) ? number(parameter.prior) : Json()},
            {"prior_standard_deviation", number(parameter.standard_deviation)},
            {"identifiability", word_of(one.identifiability)}};
}

}  // namespace

std::string identification_json(const IdentificationRecord& record, const std::vector<std::filesystem::path>& files) {
    const Identification& result = record.result;
    Json json{{"case", record.case_file.generic_string()},
              {"planned", record.planned},
              {"converged", result.converged},
              {"runs", Json::array()},
              {"parameters", Json::array()},
              {"directions", Json::array()}};
    for (const input::MeasuredRun& run : record.experiment.runs) {
        json["runs"].push_back(run.name);
    }
    for (std::size_t j = 0; j < result.fitted.size(); ++j) {
        json["parameters"].push_back(fitted_json(record.experiment.parameters[j], result.fitted[j]));
    }
    for (const Direction& direction : result.directions) {
        json["directions"].push_back({{"strength", number(direction.strength)},
                                      {"share", std::vector<double>(direction.share.begin(), direction.share.end())}});
    }
    for (Eigen::Index a = 0; a < result.correlation.rows(); ++a) {
        const Eigen::VectorXd row = result.correlation.row(a);
        json["correlation"].push_back(std::vector<double>(row.begin(), row.end()));
    }
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    json["channels"] = Json::array();
    for (const ChannelFit& fit : result.channels) {
        const solver::Channel& channel = channels[fit.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        json["channels"].push_back({{"name", fit.name},
                                    {"unit", channel.quantity == solver::Quantity::temperature ? "K" : unit.name},
                                    {"samples", fit.samples},
                                    {"rmse_before", unit.difference(fit.rmse_before)},
                                    {"rmse_after", unit.difference(fit.rmse_after)},
                                    {"sigma", unit.difference(fit.noise.sigma)},
                                    {"rho_1s", number(fit.noise.rho_1s())},
                                    {"white_share", fit.noise.white_share},
                                    {"cautions", fit.cautions}});
    }
    json["numbers"] = Json::array();
    for (const NumberFit& fit : result.numbers) {
        const Observations::Row& row = record.observations.rows[fit.row];
        const solver::ShownUnit unit = solver::shown_unit(channels[row.channel].quantity);
        json["numbers"].push_back(
            {{"channel", channels[row.channel].name},
             {"run", record.experiment.runs[row.run].name},
             {"unit", unit.name},
             {"measured", unit.value(record.observations.measured[static_cast<Eigen::Index>(fit.row)])},
             {"uncertainty", unit.difference(fit.standard_deviation)},
             {"before", unit.value(fit.before)},
             {"after", unit.value(fit.after)}});
    }
    json["misfit"] = number(result.misfit);
    json["freedom"] = number(result.freedom);
    json["non_smooth_parameters"] = result.non_smooth_parameters;
    json["findings"] = record.findings;
    json["warnings"] = record.warnings;
    json["outputs"] = Json::array();
    for (const std::filesystem::path& file : files) {
        json["outputs"].push_back(file.generic_string());
    }
    json["simulations"] = result.simulations;
    json["seconds"] = result.seconds;
    return json.dump(2) + "\n";
}

}  // namespace tiretherm::post
