// SPDX-License-Identifier: BSD-3-Clause
// Common interface of the benches to which an exam is set: case, unknown parameters, sensors with noise, and truth.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exam/exam_causes_truth.hpp"
#include "numerics/random_truth.hpp"
#include "numerics/table_truth.hpp"
#include "section/section_programme_truth.hpp"

namespace hidden_effects {

/// What drives a run of any bench; a signal that a bench has not is empty. The laser's lamp stands in the throttle's place.
struct RigProgramme : SectionProgramme {
    std::vector<double> laser_power{};  ///< W
};

/// What the sensors give without noise, [channel][sample], in kelvin or, on the laser's bench, in degC.
using RigTrace = std::vector<std::vector<double>>;

/// A number that the user of a bench does not know.
struct FreeNumber {
    std::string name;
    double expected = 0.0;  ///< of a run: above the first air temperature
    double prior = 0.0;     ///< standard deviation that the case gives it
    double spread = 0.0;    ///< standard deviation about `expected` with which an exam draws it
};

struct RigChannel {
    std::string name;
    Noise noise;
};

/// Heat that no effect of the catalogue explains, as a bench's truth offers it.
struct RigSource {
    std::string id;                    ///< of the truth: `watts` times what stands in the throttle's place
    std::string place;                 ///< as the program names it
    std::vector<std::string> or_at{};  ///< parts of a place that the program has no name for
    std::string signal = "throttle";   ///< of the log, or "time"
};

/// A bench of cases/practice to which an exam is set: its case, what its user does not know, and its truth.
struct Rig {
    std::string name;
    std::string case_file;               ///< in cases/practice
    std::vector<FreeNumber> of_bench{};  ///< the same in every run
    std::vector<FreeNumber> of_run{};    ///< temperatures at the start
    std::vector<RigChannel> channels{};
    const std::vector<Variant>* variants = nullptr;
    std::vector<RigSource> sources{};
    RigProgramme (*draw)(std::uint64_t seed, double interval) = nullptr;
    /// @param numbers those of the bench, then those of the run  @param tolerance K, local error of a step
    RigTrace (*drive)(std::span<const double> numbers, const std::vector<Cause>& causes, const RigProgramme& programme,
                      double tolerance) = nullptr;
    std::vector<Column> (*log)(const RigProgramme& programme, const RigTrace& trace) = nullptr;
    double interval = 2.0;       ///< s between samples, unless a data set asks for another
    double tolerance = 1e-6;     ///< K, of the readings that are logged
    double oracle_error = 1e-6;  ///< K, of the readings that the oracle compares
    double size_error = 0.005;   ///< relative, of the size at which a cause shows
    /// A truth's run takes a tenth of a second or more: what a cause is like is found at one size, and only when asked.
    bool costly = false;
    bool finds_twins = false;  ///< a truth's run takes a tenth of a second or less: every other pair is tried on a pair
    bool every_kind = false;   ///< also unknown_odd, decoy and the dull kinds
};

[[nodiscard]] const Rig& two_node_rig();
[[nodiscard]] const Rig& layers_rig();
[[nodiscard]] const Rig& section_rig();
[[nodiscard]] const Rig& laser_rig();

/// The scales that no user of a tire's bench knows; exams draw them within their prior.
[[nodiscard]] std::vector<FreeNumber> tire_scales();
/// @param deviations of the noise, of which 70 % follows itself
[[nodiscard]] std::vector<RigChannel> rig_channels(std::span<const std::string_view> names,
                                                   std::span<const double> deviations);

[[nodiscard]] bool is_rig(const std::string& name);
/// @errors std::invalid_argument lists the benches
[[nodiscard]] const Rig& rig_of(const std::string& name);

}  // namespace hidden_effects
