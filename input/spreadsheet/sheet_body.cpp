// SPDX-License-Identifier: BSD-3-Clause
// Writes each parameter of the sheets under its key in the case, fills in defaults, and lists what was mapped and what
// was assumed.

#include "input/spreadsheet/sheet_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/text/units.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

using Entry = SheetBody::Entry;

/// What a case needs and the thesis's sheets have no place for.
constexpr std::array<std::array<std::string_view, 4>, 7> fixed{
    {{"drive", "vertical_load", "\"4000 N\"", "the sheets hold no load: that of the thesis's first warm-up"},
     {"drive", "speed", "\"100 km/h\"", "the sheets hold no speed: that of the thesis's first warm-up"},
     {"time", "end", "\"3600 s\"", "the sheets hold no duration: until the bulk has settled"},
     {"time", "output", "\"10 s\"", "the sheets hold no interval"},
     {"sensor.surface_temperature", "region", "\"surface\"", "the sheets hold no sensors"},
     {"sensor.bulk_temperature", "region", "\"bulk\"", "the sheets hold no sensors"},
     {"drive", "", "", "the sheets hold no slip, forces or camber: free rolling, so that sliding makes no heat"}}};

constexpr std::string_view thesis =
    "Essentiality of Temperature Management while Modeling and Analyzing Tires Contact Forces, PhD thesis, University "
    "of "
    "Naples Federico II, 2014: equations (31)-(71)";

std::string quoted_units(const SheetMeasured& m, std::string_view x, std::string_view y) {
    return fmt::format("{{ columns = [\"{} [{}]\", \"{} [{}]\"], rows = [", x, m.variable_unit, y, m.value_unit);
}

/// A measured table as a case writes it, a line for each row.
Entry table_entry(const SheetMeasured& measured) {
    const SheetTable& table = *measured.table;
    const bool temperature = table.variable == "Temperature";
    Entry entry{.table = std::string(table.table),
                .key = std::string(table.key),
                .lines = {quoted_units(measured, temperature ? "temperature" : "load", table.key)},
                .places = {measured.places.front()},
                .remark = fmt::format("{}: {}", table.sheet, table.value),
                .called = std::string(table.value)};
    for (std::size_t i = 0; i < measured.value.size(); ++i) {
        entry.lines.push_back(fmt::format("    [{}, {}],", measured.variable[i], measured.value[i]));
        entry.places.push_back(measured.places[i]);
    }
    entry.lines.emplace_back("] }");
    entry.places.push_back(measured.places.back());
    return entry;
}

/// The width dT of the transition, of its rate a = -2 ln(0.003)/dT (71), in the inverse of the rate's unit.
std::string transition_width(const SheetValue& value) {
    const auto kelvin = conversion(value.unit, "K-1", Scale::absolute);
    return toml_text::quantity(-2.0 * std::log(0.003) / std::get<Conversion>(kelvin).to_si(value.number), "K");
}

std::string written(const SheetValue& value) {
    switch (value.parameter->use) {
        case SheetUse::text:
            return toml_text::in_quotes(value.text);
        case SheetUse::on:
            return value.number > 0.0 ? "true" : "false";
        case SheetUse::word:
            return value.number > 0.0 ? "\"on\"" : "\"off\"";
        case SheetUse::rate:  // a = -2 ln(0.003)/dT, (71) with the errata's natural logarithm
            return transition_width(value);
        default:
            return toml_text::quantity(value.number, value.unit);
    }
}

/// Whether another parameter of the sheets takes this one's key.
const SheetValue* rival(const SheetContent& content, const SheetParameter& parameter) {
    for (const SheetValue& value : content.values) {
        if (value.parameter != &parameter && value.sound && !parameter.key.empty() &&
            value.parameter->path() == parameter.path() && value.parameter->sheet == "LateralStiffness") {
            return &value;
        }
    }
    return nullptr;
}

/// Writes one parameter and lists where it went.
class Filling {
public:
    Filling(const SheetContent& content, SheetBody& body, SheetCase& result)
        : content_(content), body_(body), result_(result) {}

    void take(const SheetParameter& parameter) {
        const SheetValue* value = content_.find(parameter);
        if (parameter.use == SheetUse::coefficient || parameter.use == SheetUse::scale ||
            parameter.use == SheetUse::computed) {
            return;
        }
        if (value == nullptr || !value->sound) {
            assume(parameter);
        } else if (parameter.use == SheetUse::none) {
            result_.unmapped.push_back({std::string(parameter.sheet), std::string(parameter.name), shown(*value),
                                        std::string(parameter.meaning)});
        } else if (const SheetValue* other = rival(content_, parameter)) {
            result_.unmapped.push_back(
                {std::string(parameter.sheet), std::string(parameter.name), shown(*value),
                 fmt::format("{} of {} takes its place", other->parameter->name, other->parameter->sheet)});
        } else if (parameter.use == SheetUse::sensor) {
            sensor(*value);
        } else {
            body_.add({.table = std::string(parameter.table),
                       .key = std::string(parameter.key),
                       .lines = {written(*value)},
                       .places = {value->place},
                       .remark = fmt::format("{}: {}", parameter.sheet, parameter.name),
                       .called = std::string(parameter.name)});
            map(*value, parameter.path());
        }
    }

    void measured() {
        for (const SheetMeasured& m : content_.measured) {
            if (!m.table->key.empty() && table_instead(content_, m.table->law) == &m) {
                body_.add(table_entry(m));
                result_.mapped.push_back({.sheet = std::string(m.table->sheet),
                                          .parameter = fmt::format("{} against {}", m.table->value, m.table->variable),
                                          .key = fmt::format("{}.{}", m.table->table, m.table->key),
                                          .value = fmt::format("{} rows", m.value.size()),
                                          .is_number = false,
                                          .number = 0.0,
                                          .unit = m.value_unit});
            }
        }
    }

    void fill_up() {
        for (const auto& [table, key, value, reason] : fixed) {
            if (!key.empty()) {
                body_.add({.table = std::string(table),
                           .key = std::string(key),
                           .lines = {std::string(value)},
                           .places = {{}},
                           .remark = "assumed",
                           .called = std::string(key)});
            }
            result_.missing.push_back({fmt::format("{}{}{}", table, key.empty() ? "" : ".", key), std::string(value),
                                       std::string(reason), "", ""});
        }
    }

private:
    [[nodiscard]] static std::string shown(const SheetValue& value) {
        const bool has_unit = !value.unit.empty() && value.unit != "1" && value.unit != "-";
        return has_unit ? fmt::format("{} {}", value.number, value.unit) : value.text;
    }

    void map(const SheetValue& value, std::string key) {
        const SheetUse use = value.parameter->use;
        const bool number = use == SheetUse::number || use == SheetUse::rate;
        result_.mapped.push_back({.sheet = std::string(value.parameter->sheet),
                                  .parameter = std::string(value.parameter->name),
                                  .key = std::move(key),
                                  .value = number                  ? fmt::format("{}", value.number)
                                           : use == SheetUse::text ? value.text
                                                                   : (value.number > 0.0 ? "ON" : "OFF"),
                                  .is_number = number,
                                  .number = value.number,
                                  .unit = number ? value.unit : ""});
    }

    void sensor(const SheetValue& value) {
        if (value.number > 0.0) {
            body_.add({.table = "sensor.cornering_stiffness",
                       .key = "kind",
                       .lines = {"\"cornering_stiffness\""},
                       .places = {value.place},
                       .remark = fmt::format("{}: {}", value.parameter->sheet, value.parameter->name),
                       .called = std::string(value.parameter->name)});
        }
        map(value, "sensor.cornering_stiffness");
    }

    void assume(const SheetParameter& parameter) {
        const bool table = !parameter.law.empty() && table_instead(content_, parameter.law) != nullptr;
        if (parameter.ground.empty() || table || rival(content_, parameter) != nullptr) {
            return;
        }
        if (parameter.use == SheetUse::sensor) {
            body_.add({.table = "sensor.cornering_stiffness",
                       .key = "kind",
                       .lines = {"\"cornering_stiffness\""},
                       .places = {{}},
                       .remark = "assumed",
                       .called = std::string(parameter.name)});
        } else if (!parameter.standard.empty()) {
            body_.add({.table = std::string(parameter.table),
                       .key = std::string(parameter.key),
                       .lines = {std::string(parameter.standard)},
                       .places = {{}},
                       .remark = "assumed",
                       .called = std::string(parameter.name)});
        }
        result_.missing.push_back({parameter.path(), std::string(parameter.standard), std::string(parameter.ground),
                                   std::string(parameter.sheet), std::string(parameter.name)});
    }

    const SheetContent& content_;
    SheetBody& body_;
    SheetCase& result_;
};

}  // namespace

bool gives_law(const SheetContent& content, std::string_view law) {
    return std::ranges::any_of(content.values, [&](const SheetValue& value) {
        return value.parameter->law == law && value.parameter->use != SheetUse::scale;
    });
}

const SheetMeasured* table_instead(const SheetContent& content, std::string_view law) {
    const auto found = std::ranges::find_if(content.measured, [&](const SheetMeasured& m) {
        return !law.empty() && m.table->law == law && !gives_law(content, law);
    });
    return found == content.measured.end() ? nullptr : &*found;
}

SheetBody make_sheet_body(const SheetContent& content, SheetCase& result, InputErrors& errors) {
    SheetBody body;
    Filling filling(content, body, result);
    for (const SheetParameter& parameter : sheet_parameters()) {
        filling.take(parameter);
    }
    body.add({.table = "",
              .key = "sources",
              .lines = {fmt::format("[{}]", toml_text::in_quotes(thesis))},
              .places = {{}},
              .remark = "",
              .called = "sources"});
    add_sheet_law(content, "heat_capacity", body, result, errors);
    add_sheet_law(content, "conductivity", body, result, errors);
    filling.measured();
    filling.fill_up();
    return body;
}

}  // namespace tiretherm::input
