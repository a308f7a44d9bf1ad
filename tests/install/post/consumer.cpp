// SPDX-License-Identifier: BSD-3-Clause
// Reads an installed case, runs it and writes its files: what a program around the libraries does. No header of toml++, VTK or
// HDF5 is needed for it.
#include <cstdio>
#include <filesystem>

#include "input/runs/reader.hpp"
#include "post/run/run_files.hpp"
#include "solver/time_integration/march.hpp"

using namespace tiretherm;

/// consumer CASE FOLDER
int main(int, char** argv) {
    const input::Reading reading = input::read_case(argv[1]);
    if (!reading.problem) {
        std::puts("the case was not read");
        return 1;
    }
    const post::Provenance provenance{.version = "0", .case_file = argv[1], .case_text = ""};
    post::RunFiles files(argv[2], *reading.problem, provenance, {});
    const solver::MarchReport report = solver::run(*reading.problem, [&](const solver::Snapshot& snapshot) {
        files.take(snapshot);
        return true;
    });
    files.finish(report);
    if (!report.status.ok()) {
        std::puts(report.status.message.c_str());
        return 1;
    }
    for (const char* name : {"results.h5", "channels.csv", "field.pvd"}) {
        if (!std::filesystem::exists(std::filesystem::path(argv[2]) / name)) {
            std::printf("%s was not written\n", name);
            return 1;
        }
    }
    return 0;
}
