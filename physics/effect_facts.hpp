// SPDX-License-Identifier: BSD-3-Clause
// What an engineer knows of an effect beside its equation, as data in the effect's own file: where its parameters are
// expected, what a fit beyond means, what it is confounded with, and how its signature is taken.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tiretherm::physics {

/// What a sensor is, as far as a range depends on it.
enum class SensorKind : std::uint8_t {
    any,       ///< not known, or it makes no difference
    infrared,  ///< sees a surface from a distance
    probe,     ///< sits in the rubber
    gas        ///< sits in the gas of the cavity
};

/// Where a parameter is expected to lie: narrower than what a case may say, and wide enough for any car tire; the value at
/// which the effect is absent lies inside. `source` is a measured range, a paper, a data sheet, "definition", or "recalled"
/// where it is engineering knowledge that was not looked up; a range that is wider than its source says so. Ranges of
/// rubber hold for tires: cases of metals begin outside and are not judged.
struct PlausibleRange {
    std::string_view parameter;  ///< "*": any of the effect's that has no range of its own
    double low;                  ///< in the unit of the parameter's ParameterSpec
    double high;
    std::string_view source;
    std::string_view why;  ///< what a value beyond it would mean
    SensorKind sensor = SensorKind::any;
    // What a fit above or below expectation usually means, and what to do; empty where `why` says it.
    std::string_view advice_above{};
    std::string_view advice_below{};
};

/// Causes whose signatures are alike by their physics, whatever the data: naming one of them is a guess unless what
/// separates them was measured. It stands in the file of its first member.
struct ConfoundedGroup {
    std::array<std::string_view, 4> members;  ///< ids of effects; numbers of effects as "effect.key"; empty at the end
    std::string_view separated;               ///< by what an experiment tells them apart
};

/// How the signature of a parameter is taken where its slope at the absent effect is not enough.
struct TrialValues {
    std::string_view parameter;
    std::string_view other{};        ///< another parameter of the effect, which moves along or is held
    double factor = 0.0;             ///< of what moves along
    std::array<double, 11> held{};   ///< values of `other` on trial, ascending, two or more, and zeros
    std::array<double, 4> trials{};  ///< values at which the signature is taken, as many as are not 0
    bool left_out = false;           ///< says nothing that another parameter of the effect does not say
};

}  // namespace tiretherm::physics
