// SPDX-License-Identifier: BSD-3-Clause
// Output format "csv": the channels of a run as channels.csv, one row for each output time.
#pragma once

#include <filesystem>
#include <vector>

#include "post/fields/output_format.hpp"
#include "post/report/file.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

/// channels.csv: `time [s],surface_temperature [degC],...`, a row at each output time, written as the run goes.
/// Temperatures carry four decimals: a tenth of a millikelvin, below every error that a run has.
class CsvWriter final : public RunOutput {
public:
    /// @errors FileError
    CsvWriter(const std::filesystem::path& path, const solver::Problem& problem);

    /// @errors FileError
    void take(const solver::Snapshot& snapshot) override;
    [[nodiscard]] std::vector<std::filesystem::path> files() const override { return {path_}; }

private:
    std::filesystem::path path_;
    AppendFile file_;
    std::vector<solver::ShownUnit> units_;
};

}  // namespace tiretherm::post
