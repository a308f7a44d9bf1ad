// SPDX-License-Identifier: BSD-3-Clause
// A case as a fit or a diagnosis has left it, written as a case that includes the original.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "input/parameters/column_change.hpp"
#include "input/parameters/mesh_change.hpp"
#include "solver/sensitivity/free_parameter.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

/// A measured run that a case was fitted to.
struct OverlaidRun {
    std::string name;
    const solver::Problem* problem = nullptr;  ///< with the fitted values
    std::filesystem::path file{};              ///< of its measured values, where it was given beside the case
    std::string recording{};                   ///< of a corner: the name of the run without it
    std::string corner{};                      ///< FL, FR, RL or RR; empty: the case has no [[corner]]
};

/// A case and what a fit has made of it.
struct Overlay {
    std::filesystem::path original;           ///< the case's file
    const solver::Problem* before = nullptr;  ///< the case as it is
    const solver::Problem* fitted = nullptr;  ///< with the fitted values, and with effects that were switched on
    std::span<const solver::FreeParameter> parameters;  ///< that were fitted
    std::vector<OverlaidRun> runs;       ///< in the order of FreeParameter::runs; may be empty for the case's own
    std::vector<std::string> remarks{};  ///< lines to stand at the top
    /// Effects of the user's own that `fitted` has and `before` lacks: what they follow stands nowhere else.
    std::vector<solver::UserEffect> user_effects{};
    MeshChange mesh{};                    ///< of the original's mesh
    std::vector<ColumnChange> columns{};  ///< that were read otherwise than the original says
};

/// The case with its fitted values as a TOML text: it includes the original and lays over it what has changed, each
/// number with all its digits, so that reading it gives the fitted problem again.
/// @param folder where the text will stand: paths in it are relative to there
[[nodiscard]] std::string overlay_text(const Overlay& overlay, const std::filesystem::path& folder);

}  // namespace tiretherm::input
