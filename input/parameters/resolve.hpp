// SPDX-License-Identifier: BSD-3-Clause
// From a path in the document of a case to the numbers of its problem that a fit may move.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/cameras/camera.hpp"
#include "input/model/materials.hpp"
#include "input/parameters/parameter_path.hpp"

namespace tiretherm::input {

/// The numbers to which a path leads: one, the values of a law at several temperatures, or an initial temperature of each
/// run. Prior and bounds are those of the catalogue.
struct FreeParameters {
    std::vector<solver::FreeParameter> numbers;
    QuantitySpec spec;  ///< what their values must be
};

/// The temperatures at which a law is free. Empty after an error.
struct Knots {
    std::vector<double> kelvin{};
    std::vector<std::string> written{};
    SourceLocation place{};  ///< of the key `at`
};
/// The key `at` of a [[parameter]]: one to three temperatures.
[[nodiscard]] Knots read_knots(TomlTable& table);

/// A case that has been read, with whatever was wrong with it.
struct CaseAsRead {
    const solver::Problem& problem;  ///< without nodes where the mesh could not be read
    const std::vector<Stock>& stock;
    const std::vector<Camera>& cameras;
    const TomlValue& document;
    const std::vector<std::string>& run_names;  ///< of measured runs, in their order
    InputErrors& errors;
};

/// The numbers of the problem to which a path leads. An error has the place of the key that is wrong; nothing is said of
/// an empty key, nor of what is unknown because the case has errors of its own.
/// @param knots of a law; ignored by other paths
[[nodiscard]] std::optional<FreeParameters> resolve(const ParameterPath& path, const CaseAsRead& in,
                                                    const Knots& knots = {});

/// The parts of `resolve`, by the first key of the path.
[[nodiscard]] std::optional<FreeParameters> resolve_effect(const ParameterPath& path, const CaseAsRead& in);
[[nodiscard]] std::optional<FreeParameters> resolve_user_effect(const ParameterPath& path, const CaseAsRead& in);
[[nodiscard]] std::optional<FreeParameters> resolve_camera(const ParameterPath& path, const CaseAsRead& in);
[[nodiscard]] std::optional<FreeParameters> resolve_material(const ParameterPath& path, const CaseAsRead& in,
                                                             const Knots& knots);
[[nodiscard]] std::optional<FreeParameters> resolve_link(const ParameterPath& path, const CaseAsRead& in,
                                                         const Knots& knots);
[[nodiscard]] std::optional<FreeParameters> resolve_vehicle(const ParameterPath& path, const CaseAsRead& in);
[[nodiscard]] std::optional<FreeParameters> resolve_initial(const ParameterPath& path, const CaseAsRead& in);

}  // namespace tiretherm::input
