#include <cmath>

#include <nlohmann/json.hpp>

#include "post/diagnosis/diagnosis_report.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/report/number_text.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither infinity nor NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json cause_json(const Cause& cause) {
    Json parameters = Json::object();
    for (const CauseNumber& one : cause.numbers) {
        parameters[one.key] = {{"value", number(one.value)},
                               {"unit", slashed_unit(one.unit)},
                               {"low", number(one.low)},
                               {"high", number(one.high)}};
    }
    return {{"id", cause.id},
            {"channel", text_or_null(cause.channel)},
            {"place", text_or_null(cause.place)},
            {"parameters", parameters},
            {"instead_of", cause.instead_of ? number(*cause.instead_of) : Json()},
            {"sigma", number(cause.sigma)},
            {"log_likelihood_gain", number(cause.gain)},
            {"probability", cause.probability > 0.0 ? number(cause.probability) : Json()},
            {"in_set", cause.in_set},
            {"rank", cause.rank},
            {"bound", text_or_null(cause.bound)},
            {"meaning", meaning_of(cause)}};
}

/// `watts` of heat; of a reading that is off there are none, and `size` is in the channel's unit.
Json unknown_json(const UnknownSource& source, const input::Experiment& experiment) {
    const solver::ShownUnit unit = unit_of(source, experiment);
    const auto shown = [&](double si) { return number(unit.difference(si)); };
    Json json{{"place", source.place},
              {"follows", source.follows},
              {"watts", source.sensor ? Json() : shown(source.watts)},
              {"sensor", source.sensor},
              {"size",
               {{"value", shown(source.watts)},
                {"unit", unit.name},
                {"low", shown(source.low)},
                {"high", shown(source.high)}}},
              {"per_unit_of_signal", shown(source.per)},
              {"signal_unit", source.unit == "-" ? "1" : slashed_unit(source.unit)},
              {"sigma", number(source.sigma)},
              {"alike", source.alike}};
    if (!source.run.empty()) {
        json["window"] = {{"run", source.run}, {"from", source.from}, {"to", source.to}};
    }
    return json;
}

Json channel_json(const solver::Channel& channel, const ChannelGain& gain) {
    const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
    const auto shown = [&](double si) { return number(unit.difference(si)); };
    return {{"name", channel.name},
            {"unit", channel.quantity == solver::Quantity::temperature ? "K" : unit.name},
            {"rmse_before", shown(gain.rmse_before)},
            {"rmse_after", shown(gain.rmse_after)},
            {"heldout_before", shown(gain.heldout_before)},
            {"heldout_after", shown(gain.heldout_after)}};
}

Json gain_json(const Gain& gain) {
    const auto measured = [&](double value) { return gain.measured ? number(value) : Json(); };
    return {{"removable_error_removed", measured(gain.removable_removed)},
            {"low", measured(gain.low)},
            {"high", measured(gain.high)},
            {"confirmed", gain.confirmed},
            {"within_run", gain.within_run},
            {"log_e", measured(gain.log_e)}};
}

}  // namespace

std::string diagnosis_json(const DiagnosisRecord& record, const std::vector<std::filesystem::path>& files) {
    const Diagnosis& result = record.result;
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    Json json{{"case", record.case_file.generic_string()}, {"verdict", word_of(result.verdict)}};
    json["causes"] = Json::array();
    for (const Cause& cause : result.causes) {
        json["causes"].push_back(cause_json(cause));
    }
    json["set"] = Json::array();
    for (const std::vector<std::size_t>& hypothesis : result.hypotheses) {
        Json ids = Json::array();
        for (const std::size_t cause : hypothesis) {
            ids.push_back(result.causes[cause].id);
        }
        json["set"].push_back(ids);
    }
    json["unknown"] = result.unknown ? unknown_json(*result.unknown, record.experiment) : Json();
    json["reason"] = reason_of(record);
    json["next_experiment"] = result.next.empty() ? "" : text_of(result.next.front());
    json["channels"] = Json::array();
    for (const ChannelGain& gain : result.channels) {
        json["channels"].push_back(channel_json(channels[gain.channel], gain));
    }
    json["gain"] = gain_json(result.gain);
    json["limits"] = Json::array();
    for (const UpperLimit& limit : result.limits) {
        json["limits"].push_back({{"id", limit.id},
                                  {"channel", text_or_null(limit.channel)},
                                  {"place", text_or_null(limit.place)},
                                  {"key", limit.key},
                                  {"unit", slashed_unit(limit.unit)},
                                  {"low", number(limit.low)},
                                  {"high", number(limit.high)}});
    }
    json["numerical_error_sigma"] = number(result.numerical_error_sigma);
    json["noise"] = Json::array();
    for (std::size_t i = 0; i < result.noise.size(); ++i) {
        const solver::Channel& channel = channels[record.observations.channels[i]];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        json["noise"].push_back({{"channel", channel.name},
                                 {"sigma", unit.difference(result.noise[i].sigma)},
                                 {"rho_1s", number(result.noise[i].rho_1s())},
                                 {"white_share", result.noise[i].white_share}});
    }
    json["remarks"] = result.remarks;
    json["findings"] = record.findings;
    json["warnings"] = record.warnings;
    json["outputs"] = Json::array();
    for (const std::filesystem::path& file : files) {
        json["outputs"].push_back(file.generic_string());
    }
    json["simulations"] = result.simulations;
    json["seconds"] = result.seconds;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tiretherm::post
