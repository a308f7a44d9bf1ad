// SPDX-License-Identifier: BSD-3-Clause
// Input of the hot-spot analysis: the lists [[critical]] and [[uncertain]], and variants of the case that it needs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/parameters/parameter_path.hpp"
#include "solver/hot_spot/hot_spot.hpp"
#include "solver/sensitivity/free_parameter.hpp"

/// What a case says of its hot spots: the lists [[critical]] and [[uncertain]].
namespace tiretherm::input {

/// A value of the case that is known with a standard deviation only, "drive.air_temperature"; or other tables that may hold
/// as well as those of the case: both are as likely.
struct UncertainKey {
    ParameterPath path{};
    TomlValue value{};                ///< as the case has it
    double number = 0.0;              ///< in `unit`
    std::string unit{};               ///< as the case writes it; empty for a pure number
    double standard_deviation = 0.0;  ///< in `unit`, > 0
    std::string alternative{};        ///< name of the file of the other tables; empty: a value
    TomlValue tables{};               ///< of that file

    [[nodiscard]] std::string name() const { return alternative.empty() ? path.text() : alternative; }
};

/// The list [[critical]]. Needs a case that has been read; of a mesh with errors only the numbers are checked.
[[nodiscard]] std::vector<solver::Critical> read_critical(TomlTable& root, const solver::Problem& problem);
/// The list [[uncertain]].
[[nodiscard]] std::vector<UncertainKey> read_uncertain(TomlTable& root);

/// A sound case that asks for its hot spots, and the cases beside it that the answer takes.
class HotSpotCase {
public:
    /// @param run of the case, by its name; empty: the first  @pre read_case found no error in the file
    /// @returns nothing where the case has no [[critical]]
    [[nodiscard]] static std::optional<HotSpotCase> read(const std::filesystem::path& file,
                                                         const std::string& run = {});

    std::vector<solver::Critical> critical{};
    std::vector<solver::FreeParameter> known{};  ///< the [[parameter]] tables of which a standard deviation is known
    std::vector<UncertainKey> uncertain{};

    /// The case with one value some standard deviations off, or with the other tables; nothing where that is no sound case.
    [[nodiscard]] std::optional<solver::Problem> moved(const UncertainKey& uncertain_key, double deviations) const;
    /// The case with another document, such as one that goes on longer; nothing where that is no sound case.
    [[nodiscard]] std::optional<solver::Problem> problem_of(const TomlValue& document) const;
    [[nodiscard]] const TomlValue& document() const { return document_; }

private:
    TomlValue document_;
    InputErrors errors_;  ///< knows the files
    std::string name_;
    std::string run_;
};

}  // namespace tiretherm::input
