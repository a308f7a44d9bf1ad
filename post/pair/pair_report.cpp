// SPDX-License-Identifier: BSD-3-Clause
// Looks up in both results what one page shows.

#include "post/pair/pair_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/compare/stretch.hpp"
#include "input/text/word_lists.hpp"
#include "post/page/time_chart.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

namespace {

using Json = nlohmann::ordered_json;

/// NaN where there is none, or null.
double number_at(const Json& of, const char* key) {
    return of.contains(key) && of[key].is_number() ? of[key].get<double>() : std::nan("");
}
std::string text_at(const Json& of, const char* key) {
    return of.contains(key) && of[key].is_string() ? of[key].get<std::string>() : std::string();
}
/// Empty where there is none.
const Json& list_at(const Json& of, const char* key) {
    static const Json none = Json::array();
    return of.contains(key) && of[key].is_array() ? of[key] : none;
}

const StoredCourse* find(const StoredResult& result, const std::string& name) {
    const auto found = std::ranges::find(result.courses, name, &StoredCourse::name);
    return found == result.courses.end() ? nullptr : &*found;
}

/// Channels of both, in the order of A.
struct CoursePair {
    const StoredCourse* a;
    const StoredCourse* b;
};
std::vector<CoursePair> common_courses(const StoredResult& a, const StoredResult& b) {
    std::vector<CoursePair> pairs;
    for (const StoredCourse& course : a.courses) {
        const StoredCourse* other = find(b, course.name);
        if (other != nullptr && other->unit == course.unit && !course.time.empty() && !other->time.empty()) {
            pairs.push_back({&course, other});
        }
    }
    return pairs;
}

diagnosis::StretchValues values_of(const StoredCourse& course) {
    return diagnosis::values_between(course.time, course.value, course.time.front(), course.time.back());
}

DataTable inputs(const StoredResult& a, const StoredResult& b) {
    DataTable table;
    std::vector<std::string> keys;
    for (const StoredResult* result : {&a, &b}) {
        for (const auto& [key, value] : result->case_values.items()) {
            if (std::ranges::find(keys, key) == keys.end()) {
                keys.push_back(key);
            }
        }
    }
    const auto value_of = [](const StoredResult& result, const std::string& key) {
        return result.case_values.contains(key) ? result.case_values[key].get<std::string>() : std::string("-");
    };
    for (const std::string& key : keys) {
        const std::string of_a = value_of(a, key);
        const std::string of_b = value_of(b, key);
        if (of_a != of_b) {
            table.add({{"key", "key", key}, {"A", "a", of_a}, {"B", "b", of_b}});
        }
    }
    return table;
}

/// Three columns of the page: A, B and their difference.
void add_both(DataTable::Row& row, const std::string& heading, const std::string& key, double a, double b,
              const char* format = "{:.4g}", const char* signed_format = "{:+.3g}") {
    row.emplace_back(heading + " A", key + "_a", shown(format, a));
    row.emplace_back("B", key + "_b", shown(format, b));
    row.emplace_back("B - A", key + "_difference", shown(signed_format, b - a));
}

DataTable channels(const std::vector<CoursePair>& pairs) {
    DataTable table;
    for (const CoursePair& pair : pairs) {
        const diagnosis::StretchValues a = values_of(*pair.a);
        const diagnosis::StretchValues b = values_of(*pair.b);
        DataTable::Row row{{"channel", "channel", pair.a->name}, {"unit", "unit", pair.a->unit}};
        add_both(row, "final", "final", a.end, b.end);
        add_both(row, "max", "max", a.highest, b.highest);
        add_both(row, "mean", "mean", a.mean, b.mean);
        table.add(std::move(row));
    }
    return table;
}

/// What two comparisons say of their channels against the measured values.
DataTable biases(const StoredResult& a, const StoredResult& b) {
    DataTable table;
    if (a.kind != "compare") {
        return table;
    }
    for (const Json& of_a : list_at(a.data, "channels")) {
        for (const Json& of_b : list_at(b.data, "channels")) {
            if (text_at(of_a, "name") != text_at(of_b, "name")) {
                continue;
            }
            DataTable::Row row{{"channel", "channel", text_at(of_a, "name")},
                               {"unit", "unit", text_at(of_a, "difference_unit")}};
            add_both(row, "bias", "bias", number_at(of_a, "bias"), number_at(of_b, "bias"), "{:+.3g}");
            add_both(row, "rms", "rmse", number_at(of_a, "rmse"), number_at(of_b, "rmse"), "{:.3g}");
            table.add(std::move(row));
        }
    }
    return table;
}

/// The data of each tire, or of the only run, by what it is called.
std::map<std::string, Json> tires_of(const StoredResult& result) {
    std::map<std::string, Json> tires;
    if (result.data.contains("corners")) {
        for (const Json& corner : result.data["corners"]) {
            tires[text_at(corner, "corner")] = corner;
        }
    } else {
        tires[""] = result.data;
    }
    return tires;
}

DataTable hottest(const StoredResult& a, const StoredResult& b) {
    DataTable table;
    const std::map<std::string, Json> of_b = tires_of(b);
    for (const auto& [name, tire] : tires_of(a)) {
        const auto other = of_b.find(name);
        if (!tire.contains("hottest") || other == of_b.end() || !other->second.contains("hottest")) {
            continue;
        }
        const Json& first = tire["hottest"];
        const Json& second = other->second["hottest"];
        DataTable::Row row;
        if (!name.empty()) {
            row.emplace_back("corner", "corner", name);
        }
        add_both(row, "hottest degC", "hottest", number_at(first, "temperature"), number_at(second, "temperature"),
                 "{:.2f}", "{:+.2f}");
        add_both(row, "at s", "time", number_at(first, "time"), number_at(second, "time"), "{:.6g}", "{:+.6g}");
        row.emplace_back("layer A", "layer_a", text_at(first, "layer"));
        row.emplace_back("layer B", "layer_b", text_at(second, "layer"));
        table.add(std::move(row));
    }
    return table;
}

DataTable hot_spots(const StoredResult& a, const StoredResult& b) {
    DataTable table;
    const auto spots = [](const StoredResult& result) {
        return result.data.contains("hot_spots") ? list_at(result.data["hot_spots"], "spots") : Json::array();
    };
    const auto passing = [](const Json& spot) {
        const bool passes = spot.contains("passed") && spot["passed"].is_object();
        return passes ? number_at(spot["passed"], "time") : std::nan("");
    };
    for (const Json& of_a : spots(a)) {
        for (const Json& of_b : spots(b)) {
            if (text_at(of_a, "name") == text_at(of_b, "name")) {
                DataTable::Row row{{"hot spot", "name", text_at(of_a, "name")}};
                add_both(row, "hottest degC", "hottest", number_at(of_a, "hottest"), number_at(of_b, "hottest"),
                         "{:.2f}", "{:+.2f}");
                add_both(row, "passes at s", "passed", passing(of_a), passing(of_b), "{:.6g}", "{:+.6g}");
                table.add(std::move(row));
            }
        }
    }
    return table;
}

/// Heat by what it is called. W, kJ
using Heat = std::vector<std::pair<std::string, std::pair<double, double>>>;
Heat heat_of(const StoredResult& result) {
    Heat heat;
    for (const Json& effect : list_at(result.data, "budget")) {
        heat.push_back(
            {text_at(effect, "effect"), {number_at(effect, "watts_final"), 1e-3 * number_at(effect, "joules")}});
    }
    if (!heat.empty()) {
        return heat;
    }
    for (const Json& run : list_at(result.data, "heat")) {
        const std::string of = text_at(run, "corner").empty() ? text_at(run, "run") : text_at(run, "corner");
        for (const Json& part : list_at(run, "parts")) {
            heat.push_back({fmt::format("{} {}", text_at(part, "what"), of),
                            {number_at(part, "watts"), 1e-3 * number_at(part, "joules")}});
        }
    }
    return heat;
}

DataTable heat(const StoredResult& a, const StoredResult& b) {
    const Heat of_a = heat_of(a);
    const Heat of_b = heat_of(b);
    DataTable table;
    const char* watts = a.data.contains("budget") ? "W at the end" : "mean W";
    const auto find_in = [](const Heat& all, const std::string& name) {
        const auto found = std::ranges::find(all, name, &Heat::value_type::first);
        return found == all.end() ? std::pair{0.0, 0.0} : found->second;
    };
    std::vector<std::string> names;
    for (const Heat* one : {&of_a, &of_b}) {
        for (const auto& [name, value] : *one) {
            if (std::ranges::find(names, name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    for (const std::string& name : names) {
        const auto first = find_in(of_a, name);
        const auto second = find_in(of_b, name);
        if (first == std::pair{0.0, 0.0} && second == first) {
            continue;
        }
        DataTable::Row row{{"heat into it", "effect", name}};
        add_both(row, watts, "watts", first.first, second.first);
        add_both(row, "kJ in all", "kilojoules", first.second, second.second);
        table.add(std::move(row));
    }
    return table;
}

/// Courses of one unit in a panel, A dashed, and B - A below it.
void add_chart(ReportSection& section, const std::vector<CoursePair>& pairs) {
    TimeChart chart{.difference = "B - A"};
    for (const auto& [a, b] : pairs) {
        TimeSeries series{.channel = a->name, .unit = {a->unit.c_str()}};  // as the files have it
        series.curves = {{a->name + ", A", CurveRole::dashed, a->time, a->value},
                         {b->name + ", B", CurveRole::line, b->time, b->value}};
        TimeCurve difference{.name = a->name, .time = {}, .value = {}};
        for (std::size_t i = 0; i < a->time.size(); ++i) {
            const double t = a->time[i];
            if (t >= b->time.front() && t <= b->time.back()) {
                difference.time.push_back(t);
                difference.value.push_back(diagnosis::values_between(b->time, b->value, t, t).end - a->value[i]);
            }
        }
        if (!difference.time.empty()) {
            series.differences.push_back(std::move(difference));
        }
        chart.series.push_back(std::move(series));
    }
    add_time_chart(section, "A and B against time", "Dashed: A, solid: B.", std::move(chart));
}

std::vector<std::string> only_in(const StoredResult& one, const StoredResult& other) {
    std::vector<std::string> names;
    for (const StoredCourse& course : one.courses) {
        if (find(other, course.name) == nullptr) {
            names.push_back(course.name);
        }
    }
    return names;
}

/// "FL, hottest degC: 112.80 in A, 115.20 in B, B - A +2.40 K.", of each row of a table.
void say_rows(std::vector<std::string>& verdict, const DataTable& table, const std::string& key, const char* what) {
    for (const DataTable::Row& row : table.rows()) {
        const auto a = std::ranges::find(row, key + "_a", &Field::key);
        const std::string of = a == row.begin() ? "" : row.front().cell.text + ", ";
        verdict.push_back(fmt::format("{}{}: {} in A, {} in B, B - A {} {}.", of, what, a->cell.text, a[1].cell.text,
                                      a[2].cell.text, row[1].key == "unit" ? row[1].cell.text : "K"));
    }
}

/// How far the results are apart: of runs their hottest places, of comparisons how near each is to what was measured, then the
/// channels: "surface_temperature: maximum +3.2 K, at the end +1.1 K (B - A)."
std::vector<std::string> verdict_of(const std::vector<CoursePair>& pairs, const DataTable& hottest,
                                    const DataTable& biases) {
    constexpr std::size_t most = 4;
    std::vector<std::string> verdict;
    say_rows(verdict, hottest, "hottest", "hottest place, degC");
    say_rows(verdict, biases, "rmse", "rms of simulated - measured");
    for (const CoursePair& pair : pairs) {
        const diagnosis::StretchValues a = values_of(*pair.a);
        const diagnosis::StretchValues b = values_of(*pair.b);
        if (verdict.size() < most) {
            verdict.push_back(fmt::format("{}: maximum {:+.3g} {}, at the end {:+.3g} {} (B - A).", pair.a->name,
                                          b.highest - a.highest, difference_unit(pair.a->unit), b.end - a.end,
                                          difference_unit(pair.a->unit)));
        }
    }
    return verdict;
}

}  // namespace

std::string nothing_in_common(const StoredResult& a, const StoredResult& b) {
    if (a.kind != b.kind) {
        return fmt::format("{} is a result of {}, {} one of {}", a.folder.string(), a.kind, b.folder.string(), b.kind);
    }
    return common_courses(a, b).empty()
               ? fmt::format("{} and {} have no channel in common", a.folder.string(), b.folder.string())
               : "";
}

Report pair_report(const StoredResult& a, const StoredResult& b) {
    const std::vector<CoursePair> pairs = common_courses(a, b);
    Report report{
        .title = fmt::format("{} against {}", a.folder.generic_string(), b.folder.generic_string()),
        .lead = {"A: " + a.folder.generic_string(), "B: " + b.folder.generic_string(), "Differences are B - A"}};
    report.data = {{"a", a.folder.generic_string()}, {"b", b.folder.generic_string()}, {"kind", a.kind}};
    DataTable of_hottest = hottest(a, b);
    DataTable against_measured = biases(a, b);
    report.verdict = verdict_of(pairs, of_hottest, against_measured);
    const auto add = [&](const std::string& heading, const std::string& key, DataTable table) {
        report.data.set(key, table.data());
        if (!table.empty()) {
            report.add(ReportSection(heading, std::move(table)));
        }
    };
    DataTable changed = inputs(a, b);
    ReportSection of_inputs("Inputs that differ");
    report.data.set("inputs", changed.data());
    if (changed.empty()) {
        of_inputs.say("none: both cases have the same values. Logs and tables that they name may differ.");
    } else {
        of_inputs.add(std::move(changed));
    }
    report.add(std::move(of_inputs));
    DataTable of_channels = channels(pairs);
    report.data.set("channels", of_channels.data());
    ReportSection courses("Channels", std::move(of_channels));
    for (const auto& [name, one, other] : {std::tuple("A", &a, &b), std::tuple("B", &b, &a)}) {
        if (const std::vector<std::string> lonely = only_in(*one, *other); !lonely.empty()) {
            courses.say(fmt::format("only {} has {}", name, input::listed(lonely)));
        }
    }
    add_chart(courses, pairs);
    report.add(std::move(courses));
    add("Against the measured values", "biases", std::move(against_measured));
    add("Hottest place", "hottest", std::move(of_hottest));
    add("Hot spots", "hot_spots", hot_spots(a, b));
    add("Heat", "heat", heat(a, b));
    return report;
}

}  // namespace tiretherm::post
