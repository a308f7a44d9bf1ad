// SPDX-License-Identifier: BSD-3-Clause
// The tests of cases/durability for any passenger tire.
#include "input/new_case/drum_tests.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

/// By speed symbol. UN R30, annex VII (recalled, not read): 80 % of what the tire may carry at its highest speed; pressures of a
/// radial tire of standard load. What that is of the load index: 91 % of V at 240 km/h and 85 % of W at 270 km/h, full up to
/// 210 and 240 km/h and straight between (read: https://myengineerings.com/tyre-load-capacity/); 85 % of Y at 300 km/h is recalled.
struct OfSymbol {
    std::string_view symbols;
    double load_share;
    double pressure;  // Pa
};
constexpr std::array by_symbol{OfSymbol{"LMN", 0.80, 240e3}, OfSymbol{"PQRS", 0.80, 260e3},
                               OfSymbol{"TUH", 0.80, 280e3}, OfSymbol{"V", 0.73, 300e3},
                               OfSymbol{"W", 0.68, 320e3},   OfSymbol{"Y", 0.68, 320e3}};

constexpr std::array<std::string_view, 5> test_names{"un_r30", "sae_j1561", "fmvss_139_high_speed",
                                                     "fmvss_139_endurance", "fmvss_139_low_pressure"};

/// Steps one after another, each at one speed and load.
struct DrumStep {
    double minutes;
    double kmh;
    double load_share;
};
std::vector<DrumRow> steps(std::span<const DrumStep> all, double from = 0.0) {
    std::vector<DrumRow> rows;
    for (const DrumStep& step : all) {
        rows.push_back({from, step.kmh, step.load_share});
        from += step.minutes;
        rows.push_back({from, step.kmh, step.load_share});
    }
    return rows;
}

/// Steps of 10 km/h from 40 km/h below the symbol's speed on. @param minutes of each step
std::vector<DrumStep> steps_to_the_symbol(double rated, double share, std::span<const double> minutes) {
    std::vector<DrumStep> all;
    for (const double one : minutes) {
        all.push_back({one, rated - 40.0 + 10.0 * static_cast<double>(all.size()), share});
    }
    return all;
}

DrumTest un_r30(const OfSymbol& of, double rated) {
    const bool fastest = of.symbols == "Y";
    const std::array<double, 4> minutes{fastest ? 20.0 : 10.0, 10.0, 10.0, fastest ? 10.0 : 20.0};
    DrumTest test{.title = "UN R30 load and speed",
                  .origin =
                      "UN Regulation No. 30, annex VII, recalled and not read: on a drum of 1.7 m from 40 km/h below "
                      "the symbol's speed to 10 km/h below it, after a ramp of 10 min",
                  .pressure = of.pressure,
                  .pressure_ground = "of the speed symbol, recalled",
                  .room = 25.0,
                  .rows = {{0.0, 0.0, of.load_share}, {10.0, rated - 40.0, of.load_share}}};
    std::ranges::copy(steps(steps_to_the_symbol(rated, of.load_share, minutes), 10.0), std::back_inserter(test.rows));
    return test;
}

DrumTest sae_j1561(const OfSymbol& of, double rated) {
    constexpr std::array minutes{10.0, 10.0, 10.0, 10.0, 10.0};
    return {.title = "SAE J1561 step speed",
            .origin =
                "a test laboratory's public summary of SAE J1561: from 40 km/h below the symbol's speed to it; steps "
                "of 10 min are recalled, the load is assumed to be that of UN R30",
            .pressure = of.pressure,
            .pressure_ground = of.pressure > 280e3 ? "assumed: that of UN R30" : "of the speed symbol",
            .room = 25.0,
            .rows = steps(steps_to_the_symbol(rated, of.load_share, minutes))};
}

DrumTest fmvss_139(std::string_view name) {
    constexpr std::array high{DrumStep{120, 80, 0.85}, DrumStep{120, 0, 0.85}, DrumStep{30, 140, 0.85},
                              DrumStep{30, 150, 0.85}, DrumStep{30, 160, 0.85}};
    constexpr std::array endurance{DrumStep{240, 120, 0.85}, DrumStep{360, 120, 0.90}, DrumStep{1440, 120, 1.0}};
    constexpr std::array low{DrumStep{90, 120, 1.0}};
    DrumTest test{
        .title = "FMVSS 139",
        .origin = "trade press on 49 CFR 571.139: speeds, times and loads; the room and the pressure are recalled",
        .pressure_ground = "recalled",
        .room = 35.0,
        .rows = {}};
    if (name == "fmvss_139_high_speed") {
        test.title += " high speed";
        test.pressure = 220e3;
        test.rows = steps(high);
    } else if (name == "fmvss_139_endurance") {
        test.title += " endurance";
        test.pressure = 180e3;
        test.rows = steps(endurance);
    } else {
        test.title += " low inflation pressure";
        test.pressure = 140e3;
        test.rows = steps(low);
    }
    return test;
}

}  // namespace

std::span<const std::string_view> drum_test_names() { return test_names; }

std::variant<DrumTest, ErrorText> drum_test(std::string_view name, const TireSize& size) {
    const std::optional<double> load = size.service ? size.service->load() : std::nullopt;
    if (!load) {
        return ErrorText{fmt::format("the test {} needs the load index of the tire, and {} has none", name, size.text),
                         "write it behind the size: \"225/50 R17 94H\""};
    }
    if (size.light_truck || size.motorcycle) {
        return ErrorText{fmt::format("the test {} is one of passenger tires, and {} is another", name, size.text),
                         "give a passenger tire's size"};
    }
    DrumTest test;
    if (name.starts_with("fmvss")) {
        test = fmvss_139(name);
    } else {
        const char symbol = size.service->speed_symbol;
        const auto of = std::ranges::find_if(
            by_symbol, [&](const OfSymbol& one) { return one.symbols.find(symbol) != std::string_view::npos; });
        if (of == by_symbol.end()) {
            return ErrorText{fmt::format("the test {} has its speeds from the speed symbol, L to Y, and {} has none",
                                         name, size.text),
                             "write it behind the load index: \"225/50 R17 94H\""};
        }
        const double rated = 3.6 * *size.service->speed();
        test = name == "un_r30" ? un_r30(*of, rated) : sae_j1561(*of, rated);
    }
    test.load = *load;
    return test;
}

}  // namespace tiretherm::input
