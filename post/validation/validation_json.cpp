// SPDX-License-Identifier: BSD-3-Clause
// A validation table as one JSON object; an open end of a measured range is null.

#include <cmath>

#include <nlohmann/json.hpp>

#include "post/validation/validation_table.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: an open end is null.
Json closed(double end) { return std::isinf(end) ? Json() : Json(end); }

Json model_json(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    if (!found.applicable) {
        return {};
    }
    Json json{{"value", found.value ? Json(*found.value) : Json()}};
    if (const std::optional<double> off = difference(row, model)) {
        json["difference"] = *off;
        if (row.uncertainty > 0.0) {
            json["in_uncertainties"] = *off / row.uncertainty;
        }
        json["verdict"] = verdict(row, model);
    }
    if (!found.failure.empty()) {
        json["error"] = found.failure;
    }
    return json;
}

Json number_json(const ValidationRecord& record, const ValidationRow& row) {
    Json json{{"id", row.id}, {"what", row.what}, {"unit", row.unit}, {"measured", Json()}};
    if (row.is_measured) {
        json["measured"] = {{"low", closed(row.low)}, {"high", closed(row.high)}, {"source", row.source}};
        if (row.uncertainty > 0.0) {
            json["measured"]["uncertainty"] = row.uncertainty;
            for (const auto& [name, part] : row.parts) {
                json["measured"]["uncertainty_parts"][name] = part;
            }
        }
    }
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        json["models"][record.models[m].key] = model_json(row, m);
    }
    return json;
}

Json figures_json(const ModelFigures& f) {
    return {{"temperatures", f.temperatures}, {"bias", f.bias},     {"rms", f.rms},        {"scatter", f.scatter},
            {"within_2u", f.within},          {"orders", f.orders}, {"holding", f.holding}};
}

}  // namespace

std::string validation_json(const ValidationRecord& record) {
    Json json{{"title", record.title}, {"numbers", Json::array()}};
    for (const ValidationRow& row : record.rows) {
        json["numbers"].push_back(number_json(record, row));
    }
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        json["summary"][record.models[m].key] = {{"common", figures_json(figures(record, m, true))},
                                                 {"all", figures_json(figures(record, m, false))}};
    }
    json["runs"] = record.runs;
    json["seconds"] = record.seconds;
    json["energy_closure"] = record.energy_closure;
    json["warnings"] = record.warnings;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tiretherm::post
