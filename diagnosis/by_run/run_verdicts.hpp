// SPDX-License-Identifier: BSD-3-Clause
// Each run of a diagnosis diagnosed alone: what only some of the runs show is a fault of those runs, not of the model.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"

namespace tiretherm::diagnosis {

/// What a run says alone.
struct RunVerdict {
    std::string name;
    solver::Status status{};  ///< of a run that failed; then nothing below holds
    Verdict verdict = Verdict::cannot_tell;
    std::vector<std::vector<Cause>> hypotheses{};  ///< the set, the best first
    std::optional<UnknownSource> unknown{};
    Gain gain{};                ///< on blocks of the run
    Part stopped = Part::none;  ///< what was being done when time ran out; none: it came to its end

    /// Whether it can be compared with other runs.
    [[nodiscard]] bool is_judged() const {
        return status.ok() && stopped == Part::none && verdict != Verdict::cannot_tell;
    }
};

/// Why runs were left out of a diagnosis of each alone.
enum class LeftOutRuns : std::uint8_t {
    none,            ///< all are there
    stopped_before,  ///< an end was asked for before the first
    takes_long,      ///< all together took long, and nobody asked for it
    stopped_after    ///< those that are there were through when an end was asked for
};

/// The verdicts of all runs, in their order.
struct RunVerdicts {
    std::vector<RunVerdict> runs;  ///< empty where they were left out
    LeftOutRuns left_out = LeftOutRuns::none;

    /// Whether an end was asked for before all runs were through.
    [[nodiscard]] bool are_cut_short() const;
};

/// One run of an experiment: the numbers of other runs are gone, and instruments of which it reads fewer than two sensors.
[[nodiscard]] input::Experiment single_run(const input::Experiment& experiment, std::size_t run);

/// Diagnoses each run with the same options, several at a time, but plans no next experiment. An end that is asked for ends
/// the runs at hand and leaves out the rest. Progress is that of the first run that is not through, and comes from any thread,
/// one at a time. @param choice of the diagnosis of all runs; its meshes are those of all runs
[[nodiscard]] RunVerdicts diagnose_by_run(const input::Experiment& experiment, const DiagnosisOptions& choice);

/// Where the diagnosis of all runs took longer, that of each run is left out unless it is asked for.
inline constexpr double longest_before_by_run = 60.0;  // s

}  // namespace tiretherm::diagnosis
