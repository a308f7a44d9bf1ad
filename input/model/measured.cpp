// SPDX-License-Identifier: BSD-3-Clause
// Reads [[measured]]: a number or a range for a channel; the width of a range counts as a uniform distribution in the
// standard uncertainty.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/model/sensors.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

/// Standard uncertainty: what the source says, and the width of a range as that of a flat distribution.
std::optional<double> combined(std::optional<double> stated, double width) {
    const double flat = width / std::sqrt(12.0);
    return stated || width > 0.0 ? std::optional(std::hypot(stated.value_or(0.0), flat)) : std::nullopt;
}

void read_value(TomlTable& table, solver::Quantity reads, solver::Measured& measured) {
    const QuantitySpec spec = value_spec(reads);
    const Need need = table.has("range") ? Need::optional : Need::required;
    const std::optional<double> value = table.quantity("value", spec, need);
    measured.low = measured.high = value.value_or(0.0);
    if (table.has("range")) {
        if (table.has("value")) {
            table.add_error("value", "both value and range are given", "keep one of them");
        }
        const auto range = table.range("range", spec).value_or(std::array{0.0, 0.0});
        measured.low = range[0];
        measured.high = range[1];
    } else {
        table.declare_keys({"range"});
    }
    measured.uncertainty = combined(table.quantity("uncertainty", deviation_spec(reads)), measured.high - measured.low);
}

}  // namespace

QuantitySpec value_spec(solver::Quantity quantity) {
    return quantity == solver::Quantity::temperature ? quantity_specs::temperature
                                                     : QuantitySpec{.unit = unit_of(quantity)};
}

QuantitySpec deviation_spec(solver::Quantity quantity) {
    QuantitySpec spec{.unit = unit_of(quantity), .scale = Scale::difference, .low = 0.0, .above = true};
    if (quantity == solver::Quantity::temperature) {
        spec.high = quantity_specs::tolerance.high;
    }
    return spec;
}

std::vector<solver::Measured> read_measured(TomlTable& root, const solver::Problem& problem, double from) {
    const double end = problem.settings.end;
    const std::vector<std::string> channels = names_of(problem.channels);
    std::vector<solver::Measured> all;
    root.each("measured", [&](TomlTable& table) {
        solver::Measured measured;
        measured.channel = table.text("channel", Need::required).value_or("");
        const bool is_named = table.has("channel");
        const auto channel = is_named ? find_name({measured.channel, table.place("channel")}, channels,
                                                  "there is no sensor", "sensors", table.errors())
                                      : std::nullopt;
        const solver::Quantity reads = channel ? problem.channels[*channel].quantity : solver::Quantity::temperature;
        if (is_named && !channel) {
            table.declare_keys({"value", "range", "uncertainty"});  // in the unit of nobody knows what
        }
        measured.source = table.text("source").value_or("");
        measured.time = table.quantity("time").value_or(end);
        if (table.has("time") && (measured.time < from || measured.time > end)) {
            table.add_error("time", fmt::format("the run goes from {:.6g} s to {:.6g} s", from, end),
                            "choose a time within the run");
        }
        if (channel || !is_named) {
            read_value(table, reads, measured);
        }
        all.push_back(std::move(measured));
    });
    return all;
}

}  // namespace tiretherm::input
