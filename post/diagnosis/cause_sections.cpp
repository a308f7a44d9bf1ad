// SPDX-License-Identifier: BSD-3-Clause
// Rows of causes with their numbers, what they mean, and the same as data.
#include "post/diagnosis/cause_sections.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "diagnosis/detect/confounded_effects.hpp"
#include "post/diagnosis/diagnosis_charts.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/remark_text.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Causes that are reported beside those of the set.
constexpr std::size_t most_others = 6;
/// Letters of a cause's name in a row.
constexpr std::size_t widest_name = 36;

/// A source without a name, as a case may have it.
std::string unknown_text(const UnknownSource& unknown, const input::Experiment& experiment) {
    const solver::ShownUnit unit = unit_of(unknown, experiment);
    std::string text;
    if (unknown.run.empty() && unknown.follows != "1") {
        text =
            fmt::format("{:.3g} {} per {}{} of {}. ", unit.difference(unknown.per), unit.name,
                        unknown.unit == "1" || unknown.unit == "-" || unknown.unit.empty() ? "1" : "1 ",
                        unknown.unit == "1" || unknown.unit == "-" ? "" : slashed_unit(unknown.unit), unknown.follows);
    }
    return text + (unknown.sensor
                       ? "A reading that changes faster than heat could make it is the sensor's or the logger's."
                       : "In extended.toml it is a [[source]] of the case's own, to go on with until it has a name.");
}

/// What stands against the size of a cause; empty: nothing.
std::string bound_of(const Cause& cause) {
    if (cause.at_bound) {
        return "at a bound; larger or smaller values were not tested";
    }
    return cause.implausible == nullptr
               ? ""
               : fmt::format("implausible: {:.3g} to {:.3g} is what is known ({}); {}", cause.implausible->low,
                             cause.implausible->high, cause.implausible->source, cause.implausible->why);
}

/// A cause's rows on the page, one for each of its numbers; a long name goes on in the second.
void add_rows(DataTable& table, const Cause& cause) {
    std::vector<std::string> names{name_of(cause)};
    if (names.front().size() > widest_name) {
        names = {cause.id, names.front().substr(cause.id.size())};
    }
    for (std::size_t i = 0; i < std::max({names.size(), cause.numbers.size()}); ++i) {
        const CauseNumber number = i < cause.numbers.size() ? cause.numbers[i] : CauseNumber{};
        const bool any = i < cause.numbers.size();
        const double half = 0.5 * (number.high - number.low);
        const auto show = [&](double value) { return to_its_digits(value, half); };
        const std::string interval =
            half > 0.0 ? fmt::format("{} to {}", show(number.low), show(number.high)) : "on trial";
        table.add({page_only("", right(i == 0 ? fmt::format("{}", cause.rank) : "")),
                   page_only("cause", i < names.size() ? names[i] : ""), page_only("parameter", number.key),
                   page_only("fitted", right(any ? show(number.value) : "")),
                   page_only("unit", any ? unit_or_dash(number.unit) : ""),
                   page_only("95 %", right(any ? interval : "")),
                   page_only("sigma", i == 0 ? shown("{:.1f}", cause.sigma) : right("")),
                   page_only("gain", i == 0 ? shown("{:.1f}", cause.gain) : right("")),
                   page_only("", i == 0 && cause.in_set ? "*" : "")});
    }
}

}  // namespace

std::string unit_or_dash(const std::string& unit) { return unit == "1" ? "-" : slashed_unit(unit); }

ReportSection interpretation(const DiagnosisRecord& record) {
    const Diagnosis& result = record.result;
    ReportSection section("Interpretation");
    if (result.unknown) {
        section.say(unknown_text(*result.unknown, record.experiment));
    }
    for (const Cause& cause : result.causes) {
        if (!cause.in_set) {
            continue;
        }
        ReportSection part(name_of(cause), {meaning_of(cause), bound_of(cause)});
        for (const physics::ConfoundedGroup* group : confounded_groups_of(cause.id)) {
            part.say(fmt::format("Confounded with {}. What separates them: {}.", others_of(*group, cause.id),
                                 group->separated));
        }
        section.add(std::move(part));
    }
    return section;
}

ReportSection causes_section(const Diagnosis& result) {
    ReportSection section("Candidate causes");
    // A search by prediction weighs no likelihoods: its causes are those of the verdict.
    if (std::ranges::none_of(result.causes, [](const Cause& cause) { return cause.gain > 0.0; })) {
        return section;
    }
    DataTable table;
    std::size_t others = 0;
    for (const Cause& cause : result.causes) {
        if (cause.in_set || ++others <= most_others) {
            add_rows(table, cause);
        }
    }
    if (table.empty()) {
        return section;
    }
    section.add(std::move(table));
    add_cause_charts(section, result);
    section.say(
        fmt::format("{}sigma: standard deviations from no effect or from the case's value; gain: in log likelihood "
                    "over the model without it, the free parameters fitted anew each time.",
                    std::ranges::any_of(result.causes, &Cause::in_set) ? "*: in the set; " : ""));
    if (others > most_others) {
        section.say(fmt::format("{} more are less likely; all of them stand in diagnosis.json.", others - most_others));
    }
    return section;
}

Value causes_data(const Diagnosis& result) {
    Value::List list;
    for (const DataFault& fault : result.data_faults) {
        Value::List columns;
        for (const LabelledColumn& column : fault.what.columns) {
            columns.push_back(column.name);
        }
        list.push_back({{"id", id_of(fault)},
                        {"channel", Value()},
                        {"columns", columns},
                        {"unit", text_or_null(fault.what.unit)},
                        {"runs", fault.scope.recordings},
                        {"rms_before", fault.before},
                        {"rms_after", fault.after},
                        {"in_set", true},
                        {"meaning", text_of(fault.remark)}});
    }
    for (const Cause& cause : result.causes) {
        list.push_back({{"id", cause.id},
                        {"channel", text_or_null(cause.channel)},
                        {"place", text_or_null(cause.place)},
                        {"run", text_or_null(cause.run)},
                        {"parameters", parameters_data(cause)},
                        {"instead_of", cause.instead_of},
                        {"sigma", cause.sigma},
                        {"log_likelihood_gain", cause.gain},
                        {"probability", where(cause.probability > 0.0, cause.probability)},
                        {"in_set", cause.in_set},
                        {"rank", cause.rank},
                        {"bound", text_or_null(cause.at_bound ? bound_of(cause) : "")},
                        {"implausible", text_or_null(cause.implausible != nullptr ? bound_of(cause) : "")},
                        {"meaning", meaning_of(cause)}});
    }
    return list;
}

Value set_data(const Diagnosis& result) {
    Value::List of_data;
    for (const DataFault& fault : result.data_faults) {
        of_data.push_back(id_of(fault));
    }
    if (!of_data.empty() && result.hypotheses.empty()) {
        return Value::List{of_data};
    }
    Value::List set;
    for (const std::vector<std::size_t>& hypothesis : result.hypotheses) {
        Value::List ids = of_data;
        for (const std::size_t cause : hypothesis) {
            ids.push_back(result.causes[cause].id);
        }
        set.push_back(ids);
    }
    return set;
}

Value unknown_data(const UnknownSource& source, const input::Experiment& experiment) {
    const solver::ShownUnit unit = unit_of(source, experiment);
    const auto show = [&](double si) { return unit.difference(si); };
    Value data{
        {"place", source.place},
        {"follows", source.follows},
        {"watts", where(!source.sensor, show(source.watts))},
        {"sensor", source.sensor},
        {"size",
         {{"value", show(source.watts)}, {"unit", unit.name}, {"low", show(source.low)}, {"high", show(source.high)}}},
        {"per_unit_of_signal", show(source.per)},
        {"signal_unit", source.unit == "-" ? "1" : slashed_unit(source.unit)},
        {"sigma", source.sigma},
        {"alike", source.alike}};
    if (!source.run.empty()) {
        data.set("window", {{"run", source.run}, {"from", source.from}, {"to", source.to}});
    }
    return data;
}

}  // namespace tiretherm::post
