// SPDX-License-Identifier: BSD-3-Clause
// What an FMU says of itself: its variables, its description for programs and its page for people.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "solver/real_time/session_model.hpp"

namespace tiretherm::post {

/// The version of the standard.
enum class FmiVersion : std::uint8_t { fmi2, fmi3 };

/// A variable of an FMU. Its number is its place among all, from 1 on.
struct FmuVariable {
    enum class Role : std::uint8_t { input, parameter, output };

    std::string name;
    std::string meaning;
    std::string unit;  ///< UDUNITS
    Role role = Role::input;
    bool difference = false;                                ///< of temperatures
    bool fixed = false;                                     ///< of a parameter: once the first step is taken
    double low = -std::numeric_limits<double>::infinity();  ///< of inputs and parameters, in `unit`
    double high = std::numeric_limits<double>::infinity();
    double start = 0.0;
};

/// The inputs of a session, then its parameters, then its outputs. Each has a name of its own: what is called as another one before
/// it gets its role behind it.
[[nodiscard]] std::vector<FmuVariable> fmu_variables(const solver::SessionModel& model);

/// What a description is made of.
struct FmuContent {
    FmiVersion version = FmiVersion::fmi2;
    std::string identifier;  ///< of its files, a name in C
    std::string token;       ///< by which the shared object knows that the description is its own
    std::string name;        ///< of the case
    std::string title;
    std::string program;  ///< "tiretherm 0.2.0"
    double end = 0.0;     ///< s, of the experiment that the case describes
    std::vector<FmuVariable> variables;
};

/// modelDescription.xml.
[[nodiscard]] std::string model_description(const FmuContent& content);
/// documentation/index.html.
[[nodiscard]] std::string fmu_page(const FmuContent& content);

}  // namespace tiretherm::post
