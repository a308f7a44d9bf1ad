// SPDX-License-Identifier: BSD-3-Clause
// A section in a bend, to which tests give field files of a structural code.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/written.hpp"

/// A sound section in a bend, to which tests of fields give files.
namespace tiretherm::input::field_bench {

using Values = std::vector<double>;

/// A sound section that corners at 100 km/h, over what a test adds.
inline std::string cornering(const std::string& more) {
    return "include = [\"" + (source_folder() / "tests/bad_cases/good/section.toml").string() + "\"]\n[drive]\n" +
           "slip_angle = \"2 deg\"\nlateral_force = \"2000 N\"\ninflation_pressure = \"230 kPa\"\n" + more;
}

inline const std::string friction = "[effects.sliding_friction]\nfield = \"field.csv\"\n";
inline const std::string friction_watts = friction + "use = \"watts\"\n";
inline const std::string loss = "[effects.strain_energy_loss]\nfield = \"field.csv\"\n";

inline Reading read(const std::string& tables, const std::string& field) {
    const Written written;
    written.add("field.csv", field);
    return read_case(written.add("case.toml", cornering(tables)));
}

/// What the user reads, with the folder's name taken out.
inline std::string said(const std::string& tables, const std::string& field) {
    const Written written;
    written.add("field.csv", field);
    const Reading reading = read_case(written.add("case.toml", cornering(tables)));
    EXPECT_FALSE(reading.problem.has_value());
    std::string text;
    for (const InputError& error : reading.errors) {
        text += render(error);
    }
    const std::string prefix = written.folder().string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) {
        text.erase(at, prefix.size());
    }
    return text;
}

inline void expect_said(const std::string& text, const std::vector<std::string>& pieces) {
    for (const std::string& piece : pieces) {
        EXPECT_NE(text.find(piece), std::string::npos) << "lacks: " << piece << "\nin:\n" << text;
    }
}

}  // namespace tiretherm::input::field_bench
