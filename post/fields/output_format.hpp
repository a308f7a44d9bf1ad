// SPDX-License-Identifier: BSD-3-Clause
// The formats in which a run can be written. A further one is a file beside this and a line in output_formats.list.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "post/report/history.hpp"
#include "post/report/provenance.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// What is written, and where. All of it outlives the output.
struct RunTarget {
    const std::filesystem::path& directory;
    const solver::Problem& problem;
    const Provenance& provenance;
    const History& history;  ///< the channels of every row so far, the one that is taken included
};

/// A run in one format.
class RunOutput {
public:
    virtual ~RunOutput() = default;
    /// A row, with the field where snapshot.field. @errors FileError
    virtual void take(const solver::Snapshot& snapshot) = 0;
    /// The field at the hottest step, a time in s and [n_nodes] K, when the run is over: perhaps one between the rows, or
    /// one that has been stored. @errors FileError
    virtual void take_hottest(double /*time*/, std::span<const double> /*temperature*/) {}
    /// The run is over, however it ended. @errors FileError
    virtual void finish() {}
    /// Files so far.
    [[nodiscard]] virtual std::vector<std::filesystem::path> files() const = 0;
};

struct OutputFormat {
    enum class Use { always, unless_refused, on_request };

    const char* name;  ///< "vtk" makes the option --no-vtk, or --vtk where it is on request
    Use use;
    const char* help;  ///< the line of the option
    /// Creates the files, so that whatever is wrong with them shows before the run. @errors FileError
    std::unique_ptr<RunOutput> (*open)(const RunTarget& target);
    /// Names of the files that a run in this format leaves in a folder, as many of a series as are there: those of an
    /// earlier run would belie this one.
    std::vector<std::string> (*names_in)(const std::filesystem::path& directory);
};

/// All of them, in the order of output_formats.list.
[[nodiscard]] std::span<const OutputFormat* const> output_formats();

}  // namespace tiretherm::post
