#include <cmath>

#include <nlohmann/json.hpp>

#include "post/comparison/comparison_report.hpp"
#include "post/comparison/comparison_sentences.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither infinity nor NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json figures_json(const ComparedChannel& channel, const Figures& f) {
    const auto si = [&](double difference) { return number(channel.unit.difference(difference)); };
    return {{"samples", f.samples}, {"bias", si(f.bias)},       {"bias_deviation", si(f.bias_deviation)},
            {"rmse", si(f.rmse)},   {"scatter", si(f.scatter)}, {"independent_samples", number(f.independent)}};
}

Json regressor_json(const ComparedChannel& channel, const RegressorFigures& regressor) {
    const Association& a = regressor.association;
    Json json{{"name", regressor.name},       {"unit", regressor.unit},
              {"correlation", a.correlation}, {"independent_samples", a.independent},
              {"sigmas", a.sigmas},           {"chance", a.chance},
              {"bins", Json::array()}};
    for (const Bin& bin : regressor.bins) {
        json["bins"].push_back({{"low", bin.low},
                                {"high", bin.high},
                                {"samples", bin.samples},
                                {"bias", channel.unit.difference(bin.mean)},
                                {"bias_deviation", channel.unit.difference(bin.deviation)}});
    }
    return json;
}

Json channel_json(const Comparison& comparison, const ComparedChannel& channel) {
    Json json{{"name", channel.name}, {"unit", channel.unit.name}, {"difference_unit", difference_unit(channel)}};
    json.update(figures_json(channel, channel.figures));
    const ModelUncertainty& model = channel.model;
    json["noise"] = number(channel.unit.difference(channel.noise));
    json["sensor"] = channel.unit.difference(channel.sensor);
    json["sensor_is_stated"] = channel.sensor_is_stated;
    json["removable_rmse"] = channel.unit.difference(model.removable);
    json["model"] = {{"scatter", channel.unit.difference(model.scatter)},
                     {"below_sensor", model.below_sensor},
                     {"factor", model.compared > 0 ? Json(model.factor) : Json()},
                     {"relative", model.compared > 0 ? Json(model.relative) : Json()},
                     {"samples", model.compared}};
    for (const RunFigures& run : channel.runs) {
        Json of_run{{"run", comparison.runs[run.run]}};
        of_run.update(figures_json(channel, run.figures));
        json["runs"].push_back(of_run);
    }
    for (const PhaseFigures& phase : channel.phases) {
        Json of_phase{{"phase", name_of(phase.phase)}, {"share", phase.share}};
        of_phase.update(figures_json(channel, phase.figures));
        json["phases"].push_back(of_phase);
    }
    json["regressors"] = Json::array();
    for (const RegressorFigures& regressor : channel.regressors) {
        json["regressors"].push_back(regressor_json(channel, regressor));
    }
    json["significant_chance"] = channel.significant;
    json["interpretation"] = sentences(channel);
    return json;
}

Json camera_json(const Comparison& comparison, const ComparedImages& images) {
    const Figures& f = images.figures;
    Json json{{"name", images.camera},
              {"run", comparison.runs[images.run]},
              {"file", images.file},
              {"frames", images.time.size()},
              {"pixels", images.pixels()},
              {"dead", images.dead},
              {"beside", images.beside},
              {"bias", number(f.bias)},
              {"bias_deviation", number(f.bias_deviation)},
              {"rmse", number(f.rmse)},
              {"scatter", number(f.scatter)},
              {"noise", number(images.noise)},
              {"sensor", number(images.sensor)},
              {"sensor_is_stated", images.sensor_is_stated},
              {"removable_rmse", number(images.removable)},
              {"worst_frame_at", images.time[images.worst]}};
    const auto parts = [](const std::vector<PartFigures>& figures) {
        Json list = Json::array();
        for (const PartFigures& part : figures) {
            list.push_back({{"from", part.from},
                            {"to", part.to},
                            {"pixels", part.pixels},
                            {"bias", part.bias},
                            {"rmse", part.rmse}});
        }
        return list;
    };
    json["by_distance"] = parts(images.rings);
    json["by_time"] = parts(images.stages);
    for (const auto& [name, rms] : images.scales) {
        json["by_size"].push_back({{"size", name}, {"rmse", rms}});
    }
    return json;
}

Json number_json(const Comparison& comparison, const ComparedNumber& n) {
    return {{"channel", n.channel},
            {"run", comparison.runs[n.run]},
            {"time", n.time},
            {"unit", n.unit.name},
            {"measured", n.unit.value(n.measured)},
            {"uncertainty", n.unit.difference(n.uncertainty)},
            {"simulated", n.unit.value(n.simulated)},
            {"difference", n.unit.difference(n.simulated - n.measured)},
            {"in_uncertainties", n.in_uncertainties()},
            {"source", n.source}};
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const std::vector<std::filesystem::path>& files) {
    Json json{{"case", comparison.name},       {"difference", "simulated - measured"},
              {"seconds", comparison.seconds}, {"runs", Json::array()},
              {"channels", Json::array()},     {"numbers", Json::array()}};
    for (std::size_t r = 0; r < comparison.runs.size(); ++r) {
        json["runs"].push_back({{"name", comparison.runs[r]}, {"file", comparison.files[r]}});
    }
    for (const ComparedChannel& channel : comparison.channels) {
        json["channels"].push_back(channel_json(comparison, channel));
    }
    for (const ComparedNumber& n : comparison.numbers) {
        json["numbers"].push_back(number_json(comparison, n));
    }
    json["cameras"] = Json::array();
    for (const ComparedImages& images : comparison.images) {
        json["cameras"].push_back(camera_json(comparison, images));
    }
    json["findings"] = comparison.findings;
    json["warnings"] = comparison.warnings;
    json["outputs"] = Json::array();
    for (const std::filesystem::path& file : files) {
        json["outputs"].push_back(file.string());
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tiretherm::post
