#pragma once

#include <filesystem>
#include <vector>

#include "solver/channel_unit.hpp"
#include "post/report/file.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// channels.csv: `time [s],surface_temperature [degC],...`, a row at each output time, written as the run goes.
/// Temperatures carry four decimals: a tenth of a millikelvin, below every error that a run has.
class CsvWriter {
public:
    /// @errors FileError
    CsvWriter(const std::filesystem::path& path, const solver::Problem& problem);

    /// @errors FileError
    void take(const solver::Snapshot& snapshot);

private:
    AppendFile file_;
    std::vector<solver::ShownUnit> units_;
};

}  // namespace tiretherm::post
