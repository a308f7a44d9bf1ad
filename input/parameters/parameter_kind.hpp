// SPDX-License-Identifier: BSD-3-Clause
// A kind of free parameter: which paths of a case lead to it, which numbers stand there, and how a fitted one is written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/cameras/camera.hpp"
#include "input/model/materials.hpp"
#include "input/parameters/overlay.hpp"
#include "input/parameters/parameter_path.hpp"
#include "input/text/quantity.hpp"
#include "solver/sensitivity/free_parameter.hpp"

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

/// A kind of parameter that a fit may move. Its file has all that is known of it.
struct ParameterKind {
    std::vector<std::string_view>
        subjects;  ///< keys of a [[parameter]] one of which says that such a parameter is free
    bool (*takes)(const ParameterPath& path);
    bool (*has)(const solver::FreeParameter& parameter);
    /// The paths that a [[parameter]] names with one of the subjects. None after an error.
    std::vector<ParameterPath> (*paths_of_table)(TomlTable& table, std::string_view subject, const TomlValue& document);
    /// The parameters to which a path leads. An error has the place of the key that is wrong; nothing is said of an empty
    /// key, nor of what is unknown because the case has errors of its own.
    /// @param knots of a law; ignored by others
    std::optional<FreeParameters> (*find)(const ParameterPath& path, const CaseAsRead& in, const Knots& knots);
    /// Where a parameter stands in its case. An initial temperature belongs to [initial] of the case or of a run.
    ParameterPath (*path_of)(const solver::Problem& problem, const solver::FreeParameter& parameter);
    /// Writes what was fitted, and the same for all runs, over the original.
    void (*write)(TomlValue& over, const Overlay& overlay, const TomlValue& original);
};
/// All kinds, in the order in which a fitted case has them.
[[nodiscard]] std::span<const ParameterKind> parameter_kinds();
[[nodiscard]] ParameterKind effect_kind();
[[nodiscard]] ParameterKind law_kind();
[[nodiscard]] ParameterKind vehicle_kind();
[[nodiscard]] ParameterKind initial_kind();

/// Of the kind that takes the path; an error where none does.
[[nodiscard]] std::optional<FreeParameters> find_parameters(const ParameterPath& path, const CaseAsRead& in,
                                                            const Knots& knots = {});
/// Where a parameter stands in its case.
[[nodiscard]] ParameterPath path_of(const solver::Problem& problem, const solver::FreeParameter& parameter);

[[nodiscard]] bool is_initial(const solver::FreeParameter& parameter);
/// Initial temperatures as a table of a case, all of them: a key that the original has would win over a general one.
[[nodiscard]] TomlValue initial_value(const solver::Problem& problem);

/// The text of a key of a [[parameter]], empty after an error, and its place.
[[nodiscard]] LocatedString located(TomlTable& table, std::string_view key, Need need = Need::optional);

}  // namespace tiretherm::input
