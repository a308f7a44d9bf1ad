// SPDX-License-Identifier: BSD-3-Clause
// Additions with their gains in the unit of the sensor that gains most, and upper limits in the order in which they are asked for.

#include "post/diagnosis/tried_sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "post/diagnosis/cause_sections.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/report/number_text.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Additions and effects that stand on the page; all stand behind it.
constexpr std::size_t most_tried = 3;
constexpr std::size_t most_effects = 10;
/// Effects of which a limit is asked for first: timing, sensors, air film, loss, road.
constexpr std::array<std::string_view, 15> asked_first{"sensor_lag",
                                                       "clock_delay",
                                                       "clock_rate",
                                                       "input_delay",
                                                       "sensor_offset",
                                                       "sensor_gain",
                                                       "camera_emissivity",
                                                       "convection_exponent",
                                                       "loss_tangent_slope",
                                                       "load_exponent_of_loss",
                                                       "road_temperature_drift",
                                                       "loss_frequency_shift",
                                                       "wind",
                                                       "slip_input_gain",
                                                       "load_input_gain"};

std::size_t rank_of(const UpperLimit& limit) {
    return static_cast<std::size_t>(std::ranges::find(asked_first, limit.id) - asked_first.begin());
}

bool is_in_answer(const TriedAddition& one, const Diagnosis& result) {
    return std::ranges::all_of(one.causes, [&](const Cause& cause) {
        return std::ranges::any_of(result.causes, [&](const Cause& other) {
            return other.in_set && other.id == cause.id && other.channel == cause.channel && other.place == cause.place;
        });
    });
}

double percent_of_rms(double removed) { return 100.0 * (1.0 - std::sqrt(std::max(0.0, 1.0 - removed))); }

std::string cause_of(const UpperLimit& limit) {
    return name_of(Cause{.id = limit.id, .channel = limit.channel, .place = limit.place});
}

/// "-0.10 to 0.60", "at most 0.60" of what has one side.
std::string interval_of(const UpperLimit& limit) {
    const double half = 0.5 * (limit.high - limit.low);
    const std::string low = to_its_digits(limit.low, half);
    const std::string high = to_its_digits(limit.high, half);
    if (limit.low == limit.absent) {
        return "at most " + high;
    }
    return limit.high == limit.absent ? "at least " + low : fmt::format("{} to {}", low, high);
}

}  // namespace

std::string name_of(const TriedAddition& one) {
    std::string name;
    for (const Cause& cause : one.causes) {
        name += fmt::format("{}{}, {}", name.empty() ? "" : " with ", name_of(cause), size_of(cause));
    }
    return name;
}

std::string change_text(const ChannelChange& change, const input::Experiment& experiment) {
    const solver::Channel& channel = experiment.runs.front().problem.channels[change.channel];
    const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
    const double half = unit.difference(0.5 * (change.high - change.low));
    const auto show = [&](double si) { return to_its_digits(unit.difference(si), half); };
    return fmt::format("{} {} to {} {} rms, gain {} (95 %: {} to {})", channel.name, show(change.before),
                       show(change.after), difference_unit(unit.name), show(change.gain()), show(change.low),
                       show(change.high));
}

std::string text_of(AdditionDoubt doubt, bool within_run) {
    switch (doubt) {
        case AdditionDoubt::none:
            return "";
        case AdditionDoubt::too_small:
            return "it removes next to nothing";
        case AdditionDoubt::may_be_chance:
            return "that may be chance";
        case AdditionDoubt::worsens_channel:
            return "another sensor is predicted worse";
        case AdditionDoubt::worsens_part:
            return within_run ? "a part of the run is predicted worse" : "one of the runs is predicted worse";
        case AdditionDoubt::end_of_range:
            return "it wants the end of what is plausible";
        case AdditionDoubt::not_tested:
            return "it promised too little to be tested";
    }
    return "";
}

DataTable tried_table(const DiagnosisRecord& record) {
    const bool within_run = record.observations.n_recordings() == 1;
    DataTable table;
    for (const TriedAddition& one : record.result.tried) {
        Value::List causes;
        for (const Cause& cause : one.causes) {
            causes.push_back({{"id", cause.id},
                              {"channel", text_or_null(cause.channel)},
                              {"place", text_or_null(cause.place)},
                              {"parameters", parameters_data(cause)}});
        }
        const bool in_answer = is_in_answer(one, record.result);
        const std::string against = in_answer                          ? "in the answer"
                                    : one.doubt == AdditionDoubt::none ? "another one predicts better"
                                                                       : text_of(one.doubt, within_run);
        table.add({data_only("causes", causes),
                   page_only("addition", name_of(one)),
                   {"beside", "beside", count(one.beside)},
                   {"removed, %", "removed", {one.removed, fmt::format("{:.0f}", 100.0 * one.removed)}},
                   {"95 % from", "low", {one.low, shown("{:.0f}", 100.0 * one.low).text}},
                   {"to", "high", {one.high, shown("{:.0f}", 100.0 * one.high).text}},
                   page_only("on data that were left out",
                             one.change ? change_text(*one.change, record.experiment) : "not tested"),
                   {"", "against", against}});
    }
    return table;
}

ReportSection tried_section(const DiagnosisRecord& record) {
    const Diagnosis& result = record.result;
    const bool within_run = record.observations.n_recordings() == 1;
    ReportSection section("Tried and not taken");
    std::size_t shown_ones = 0;
    for (const TriedAddition& one : result.tried) {
        if (is_in_answer(one, result) || shown_ones == most_tried) {
            continue;
        }
        ++shown_ones;
        const std::string gain = one.change ? change_text(*one.change, record.experiment) + " on left-out data"
                                 : one.removed > 0.0
                                     ? fmt::format("about {:.0f} % of the rms", percent_of_rms(one.removed))
                                     : std::string("no gain");
        const std::string against =
            one.doubt == AdditionDoubt::none ? "another one predicts better" : text_of(one.doubt, within_run);
        section.item(fmt::format("{}{}: {}; {}.", name_of(one), one.beside > 0 ? " (beside what was found)" : "", gain,
                                 against));
    }
    const std::size_t rest = result.tried.size() - shown_ones;
    if (shown_ones == most_tried && rest > 0) {
        section.say("All additions that were fitted stand in diagnosis.json and at the end of report.html.");
    }
    return section;
}

DataTable limits_table(const Diagnosis& result) {
    DataTable table;
    for (const UpperLimit& limit : result.limits) {
        const double half = 0.5 * (limit.high - limit.low);
        table.add({{"cause", "id", {limit.id, cause_of(limit), false}},
                   data_only("channel", text_or_null(limit.channel)),
                   data_only("place", text_or_null(limit.place)),
                   {"parameter", "key", limit.key},
                   {"unit", "unit", {slashed_unit(limit.unit), unit_or_dash(limit.unit), false}},
                   {"95 % from", "low", {limit.low, to_its_digits(limit.low, half)}},
                   {"to", "high", {limit.high, to_its_digits(limit.high, half)}}});
    }
    return table;
}

ReportSection limits_section(const DiagnosisRecord& record) {
    ReportSection section("How large causes can be at most");
    std::vector<const UpperLimit*> all;
    for (const UpperLimit& limit : record.result.limits) {
        all.push_back(&limit);
    }
    std::ranges::stable_sort(all, {}, [](const UpperLimit* one) { return rank_of(*one); });
    std::vector<std::pair<std::string, std::string>> items;  // of an effect's number: what it is, its limits
    for (const UpperLimit* limit : all) {
        const std::string what = fmt::format("{} {}", limit->id, limit->key);
        auto item = std::ranges::find(items, what, &std::pair<std::string, std::string>::first);
        if (item == items.end()) {
            if (items.size() == most_effects) {
                continue;
            }
            item = items.insert(items.end(), {what, ""});
        }
        const std::string& where = limit->channel.empty() ? limit->place : limit->channel;
        const std::string unit = unit_or_dash(limit->unit) == "-" ? "" : " " + slashed_unit(limit->unit);
        item->second += fmt::format("{}{}{}{}", item->second.empty() ? "" : "; ", where.empty() ? "" : where + " ",
                                    interval_of(*limit), unit);
    }
    for (const auto& [what, limits] : items) {
        section.item(what + ": " + limits);
    }
    if (!items.empty()) {
        section.say(
            fmt::format("95 %, each cause alone beside the {}. All {} stand in diagnosis.json and at the end of "
                        "report.html.",
                        record.result.hypotheses.empty() ? "free parameters" : "answer", all.size()));
    }
    return section;
}

std::string richer_mesh_sentence(const DiagnosisRecord& record) {
    for (const RicherMesh& mesh : record.result.richer_meshes) {
        if (!mesh.is_better || !mesh.change) {
            continue;
        }
        std::string text = fmt::format("{} predict better without any cause: {}.",
                                       record.experiment.runs.front().problem.mesh.is_lumped()
                                           ? "Two nodes are too few: " + mesh.name
                                           : "The grid is too coarse: " + mesh.name,
                                       change_text(*mesh.change, record.experiment));
        if (mesh.is_taken) {
            return text;  // whose numbers are those of the answer
        }
        std::string numbers;
        for (const FreeNumber& one : mesh.numbers) {
            const double half = 0.5 * (one.high - one.low);
            const std::string unit = unit_or_dash(one.unit) == "-" ? "" : " " + slashed_unit(one.unit);
            if (!one.name.starts_with("initial")) {
                numbers += fmt::format("{}{} {} ({} to {}){}", numbers.empty() ? "" : ", ", one.name,
                                       to_its_digits(one.value, half), to_its_digits(one.low, half),
                                       to_its_digits(one.high, half), unit);
            }
        }
        return numbers.empty() ? text : fmt::format("{} On them: {}.", text, numbers);
    }
    return "";
}

}  // namespace tiretherm::post
