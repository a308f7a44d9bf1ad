// SPDX-License-Identifier: BSD-3-Clause
// How large a case is before it is run: cells, rows, steps, files and memory, and the limits of [limits].
#pragma once

#include <optional>
#include <string>

#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// What a case may come to. A larger one is refused, since it is a slip more often than a wish; [limits] raises each.
struct SizeLimits {
    double cells = 5e6;
    double rows = 1e7;     ///< of channels
    double steps = 1e9;    ///< of a fixed length
    double output = 20e9;  ///< bytes of all files
    double memory = 8e9;   ///< bytes
};

/// What a run will come to: estimates, good to a factor of two or so.
struct CaseSize {
    double cells = 0.0;
    double rows = 0.0;              ///< of channels; 0: one for each step, whose number is not known before
    double fields = 0.0;            ///< stored fields
    std::optional<double> steps{};  ///< where their length is fixed
    double output = 0.0;            ///< bytes of all files, the page not counted
    double memory = 0.0;            ///< bytes at the peak of a run
};

[[nodiscard]] CaseSize size_of(const solver::Problem& problem);
/// "1.5 GB".
[[nodiscard]] std::string spell_bytes(double bytes);

/// The table [limits].
[[nodiscard]] SizeLimits read_limits(TomlTable& root);

/// Whether a mesh of so many cells may be built; reports it where not. Nothing of its size is allocated before.
[[nodiscard]] bool is_affordable(const TomlTable& mesh, double cells, const SizeLimits& limits);

/// The key of [time] whose value asks for more than may be, what is wrong and what to do.
struct SizeExcess {
    std::string key;
    std::string what;
    std::string remedy;
};
/// The first limit that a run passes, or a time that double precision does not resolve; nothing where it is sound.
[[nodiscard]] std::optional<SizeExcess> excess_of(const solver::Problem& problem, const SizeLimits& limits);

}  // namespace tiretherm::input
