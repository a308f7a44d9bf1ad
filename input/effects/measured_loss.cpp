// SPDX-License-Identifier: BSD-3-Clause
// Reads `total` (a table of a drum test) and `coastdown` (the SAE J2452 coefficients), and checks that the drive gives
// the inputs that they need.

#include "input/effects/measured_loss.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/effects/resistance_table.hpp"
#include "input/text/quantity_specs.hpp"
#include "physics/tire_laws/measured_loss.hpp"

namespace tiretherm::input {

namespace {

using physics::MeasuredLoss;

/// What is measured over must be among the inputs.
void need(TomlTable& table, std::string_view key, const std::string& signal, const solver::InputSignals& inputs,
          const GivenSignals& given) {
    const physics::Signal& input = *physics::find_signal(signal);
    if (!inputs.gives(input) && !given.contains(signal)) {
        table.add_error(key, fmt::format("[drive] lacks {}, over which the loss was measured", signal),
                        fmt::format("add {} = {} to [drive]", signal, spell_example(quantity_specs::of(input))));
    }
}

/// Beyond the table its end is held: a warning says where the drive goes there.
void warn_beyond(const TomlTable& table, const physics::Signal& signal, const std::vector<double>& at,
                 const solver::InputSignals& input_signals) {
    double low = input_signals.constants().*signal.member;
    double high = low;
    for (const solver::Series& series : input_signals.series()) {
        if (series.signal == &signal) {
            low = *std::ranges::min_element(series.value);
            high = *std::ranges::max_element(series.value);
        }
    }
    const bool below = signal.name != "speed" && signal.name != "vertical_load" && low < at.front();
    if (below || high > at.back()) {
        table.errors().warn(table.place("total"),
                            "{} goes from {:.6g} to {:.6g} {}, the table from {:.6g} to {:.6g}: beyond "
                            "its ends the table is held",
                            signal.name, low, high, signal.unit, at.front(), at.back());
    }
}

std::optional<MeasuredLoss> read_table(TomlTable& table, const std::string& name, const solver::InputSignals& inputs,
                                       const GivenSignals& given, std::vector<std::string>& over) {
    const SourceLocation mentioned = table.place("total");
    std::optional<GridFile> file =
        read_resistance_table(table.errors().beside(mentioned, name), mentioned, table.errors());
    if (!file) {
        return std::nullopt;
    }
    MeasuredLoss loss;
    for (std::size_t a = 0; a < file->names.size(); ++a) {
        const std::vector<double>& at = file->table.axes[a].at;
        if (file->table.axes[a].input == nullptr) {
            loss.bulk_temperatures = at;
            if (at.size() > physics::most_temperatures) {
                table.add_error("total", fmt::format("the table has {} temperatures; {} are the most", at.size(),
                                                     physics::most_temperatures));
            }
            continue;
        }
        over.push_back(file->names[a]);
        need(table, "total", file->names[a], inputs, given);
        warn_beyond(table, *physics::find_signal(file->names[a]), at, inputs);
    }
    loss.table = std::move(file->table);
    return loss;
}

/// A unit of the fit in SI.
double unit_of_fit(TomlTable& fit, std::string_view key, const QuantitySpec& spec, std::string_view standard) {
    const std::string unit = fit.text(key).value_or(std::string(standard));
    const UnitRead read = read_unit(unit, spec, fmt::format("{} is [{}]", key, unit));
    if (read.error) {
        fit.add_error(key, read.error->what, fmt::format("write {} = \"{}\"", key, standard));
    }
    return read.conversion.factor;
}

MeasuredLoss read_coastdown(TomlTable& table, const solver::InputSignals& inputs, const GivenSignals& given,
                            std::vector<std::string>& over) {
    TomlTable fit = table.subtable("coastdown");
    physics::CoastdownFit found;
    fit.read_into(found.law);
    found.pressure_unit = unit_of_fit(fit, "pressure_unit", {.unit = "Pa"}, "kPa");
    found.load_unit = unit_of_fit(fit, "load_unit", {.unit = "N"}, "N");
    found.speed_unit = unit_of_fit(fit, "speed_unit", {.unit = "m s-1"}, "km/h");
    found.force_unit = unit_of_fit(fit, "force_unit", {.unit = "N"}, "N");
    over.emplace_back("inflation_pressure");
    need(table, "coastdown", over.back(), inputs, given);
    return {.coastdown = found, .table = {}};
}

}  // namespace

std::vector<std::string> read_measured_loss(TomlTable& table, const solver::InputSignals& inputs,
                                            const GivenSignals& given, physics::ActiveEffect& active) {
    std::vector<std::string> over;
    const std::size_t before = table.errors().count();
    const std::optional<std::string> total = table.text("total");
    const bool fitted = table.has("coastdown");
    if (!total && !fitted) {
        return over;
    }
    const std::string_view key = total ? "total" : "coastdown";
    if (total && fitted) {
        table.add_error("coastdown", "the loss is measured twice: total and coastdown", "remove one of them");
    }
    if (active.choices.front() == 1) {
        table.add_error(key, "a measured total knows the bulk's temperature at most, and temperature is \"local\"",
                        "remove temperature = \"local\"");
    }
    if (active.field && !active.field->watts.empty()) {
        table.add_error(key, "the field gives the watts already", "write use = \"shape\", or remove one of them");
    }
    std::optional<MeasuredLoss> loss =
        total ? read_table(table, *total, inputs, given, over) : read_coastdown(table, inputs, given, over);
    if (loss && table.errors().count() == before) {
        if (loss->bulk_temperatures.size() > 1 &&
            active.effect->n_coefficients() < active.effect->heat_effect()->frame_coefficients) {
            active.effect = &physics::in_frames(*active.effect);
        }
        active.total = std::make_shared<const MeasuredLoss>(std::move(*loss));
    }
    return over;
}

}  // namespace tiretherm::input
