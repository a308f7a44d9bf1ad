// SPDX-License-Identifier: BSD-3-Clause
// Google Benchmark reporter that also prints each time as a ratio to the first benchmark of the same run, a figure that
// carries over to other machines.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace tiretherm::benchmarks {

/// Prints, after Google Benchmark's own table, how many times longer each benchmark took than the first one of the
/// same run: the only figure that survives another machine.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Aggregate ? run.aggregate_name == "median" : run.repetitions <= 1) {
                seconds_.emplace_back(run.run_name.str(),
                                      run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit));
            }
        }
    }
    void Finalize() override {
        ConsoleReporter::Finalize();
        for (const auto& [name, seconds] : seconds_) {
            GetOutputStream() << "ratio to " << seconds_.front().first << ": " << seconds / seconds_.front().second
                              << "  " << name << "\n";
        }
    }

private:
    std::vector<std::pair<std::string, double>> seconds_;
};

inline int main_with_ratios(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return 0;
}

}  // namespace tiretherm::benchmarks
