// SPDX-License-Identifier: BSD-3-Clause
// Inputs, signs, units and sensors, from the tables that the laws and the readers use.

#include <algorithm>

#include <fmt/format.h>

#include "app/help/help_text.hpp"
#include "app/help/topics.hpp"
#include "input/model/sensors.hpp"
#include "input/schema/all_tables.hpp"
#include "input/text/characters.hpp"
#include "input/text/unit_text.hpp"
#include "input/text/units.hpp"
#include "physics/conventions.hpp"
#include "physics/signals.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

std::string inputs_topic() {
    std::string text = paragraphs_text(
        "An input is what drives the model. A case gives it in [drive], as a constant, a schedule or a file; a "
        "measured run gives it in a column of that name, or of any name with columns = { V = \"speed\" }. Any unit of "
        "the right kind will do.\n\n");
    post::TextTable table({true, true, true});
    table.add({"input", "for example", "meaning"});
    for (const physics::Signal& signal : physics::signals()) {
        const std::string example =
            signal.unit == "1" ? "0.05" : input::dimension(signal.unit, input::Scale::absolute).example;
        table.add({std::string(signal.name), signal.name == "wet" ? "1" : example, ""});
    }
    const std::vector<std::string> lines = table.lines(2);
    const std::size_t column = lines.front().find("meaning");
    text += lines.front() + "\n";
    for (std::size_t i = 0; i < physics::signals().size(); ++i) {
        text += entry_text(lines[i + 1].substr(2), std::string(physics::signals()[i].meaning), column);
    }
    return text +
           paragraphs_text(
               "\nOne of them, with its range and the effects and sensors that read it: tiretherm inputs INPUT\n\n"
               "Which way each counts as positive: tiretherm help signs\n");
}

std::string signs_topic() {
    std::string text = paragraphs_text(
        "Axes are those of ISO 8855: x forwards, y to the left, z up, for a tire on the right-hand side of the "
        "vehicle. Outside, or outboard, is to its right. A place along the section counts from the centre plane, "
        "negative outboard. docs/inputs.md has a drawing.\n\n"
        "Differences are simulated - measured: + is too hot. In the heat budget + is heat into the tire. A heat flux "
        "is positive out of the rubber.\n\n");
    for (const physics::Signal& signal : physics::signals()) {
        text += entry_text(std::string(signal.name), std::string(physics::sign_convention(signal)), 22);
    }
    return text;
}

std::string units_topic() {
    std::string text = paragraphs_text(
        "A quantity is a text with a number and a unit: \"100 km/h\", \"8 mm\". Any unit of the right kind is "
        "converted; UDUNITS-2 knows them, with prefixes (kN, mm, MPa). A pure number is written 0.6 or \"60 %\". In a "
        "data file the unit stands in the heading: speed [km/h].\n\n"
        "A temperature may be in degC, K or degF. Of a difference of temperatures only the size of the degree counts: "
        "a standard deviation of \"0.5 degC\" is 0.5 K.\n\n"
        "After a power or an energy and a slash, mK, m2K and kgK are products: W/mK is W/(m K). mK alone is a "
        "millikelvin.\n\n");
    post::TextTable usual({true, true, true});
    usual.add({"kind", "for example", "usual units"});
    for (const input::Dimension& dimension : input::dimensions()) {
        if (!dimension.example.empty()) {
            usual.add({dimension.name, dimension.example, dimension.units});
        }
    }
    post::TextTable others({true, true});
    for (const auto& [alias, meaning] : input::unit_aliases()) {
        if (input::is_printable(alias) && alias != "-") {  // Latin-1 is for files
            others.add({alias.empty() ? "- or nothing" : std::string(alias), std::string(meaning)});
        }
    }
    text += usual.text(2) + "\nThese are understood, too:\n" + others.text(2);
    return text;
}

namespace {

/// Keys of a [[sensor]] that say where it is, of one kind.
std::vector<std::string> place_keys(const input::TableKeys& table, std::string_view kind) {
    std::vector<std::string> keys;
    for (const input::Key& key : table.keys) {
        if (!key.of_kinds.empty() && key.is_of(kind)) {
            keys.emplace_back(key.name);
        }
    }
    return keys;
}

}  // namespace

std::string sensors_topic() {
    const std::vector<input::TableKeys>& tables = input::all_tables();
    const auto sensor = std::ranges::find(tables, "sensor", &input::TableKeys::path);
    std::string text = paragraphs_text(
        "A [[sensor]] of a case is one channel of the results. Its name is that of the column in a measured file. "
        "standard_deviation, of one sample, comes from the data sheet.\n\n"
        "  [[sensor]]\n  name = \"shoulder\"\n  kind = \"point\"\n  depth = \"10 mm\"\n"
        "  standard_deviation = \"0.5 K\"\n\n");
    std::string of_places = "Temperatures, by kind:\n";
    std::string others = "\nOther quantities:\n";
    for (const input::SensorKind& kind : input::sensor_kinds()) {
        const std::vector<std::string> keys =
            sensor == tables.end() ? std::vector<std::string>{} : place_keys(*sensor, kind.name);
        const std::string line =
            fmt::format("{}{}{}", kind.meaning, keys.empty() ? "" : "; keys: ", fmt::join(keys, ", "));
        (kind.is_place ? of_places : others) += entry_text(std::string(kind.name), line, kind.is_place ? 12 : 28);
    }
    return text + of_places + others +
           paragraphs_text(
               "\nAll keys: tiretherm keys sensor. What may be wrong with a sensor (lag, offset, gain ...) is an "
               "effect: tiretherm effects.\n");
}

}  // namespace tiretherm::app
