// SPDX-License-Identifier: BSD-3-Clause
// A made-up table of quoted numbers: free rolling at several loads, speeds and temperatures, an experiment each, with
// values from the model in which something is hidden.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "diagnosis/quoted/quoted_diagnosis.hpp"
#include "input/runs/reader.hpp"
#include "input/validation/trace.hpp"
#include "input/validation/validation.hpp"
#include "solver/time_integration/run_to_end.hpp"
#include "support/written.hpp"

namespace tiretherm::diagnosis::quoted {

/// One steady test.
struct MadeUpTest {
    double load;   ///< N
    double speed;  ///< km/h
    double air;    ///< degC
};

/// Loads, speeds and temperatures that do not go together.
inline constexpr std::array<MadeUpTest, 10> made_up_tests{{{3000.0, 60.0, 15.0},
                                                           {6500.0, 60.0, 25.0},
                                                           {3000.0, 100.0, 30.0},
                                                           {4500.0, 100.0, 10.0},
                                                           {6500.0, 100.0, 20.0},
                                                           {3500.0, 140.0, 25.0},
                                                           {5000.0, 140.0, 15.0},
                                                           {6500.0, 140.0, 30.0},
                                                           {4000.0, 80.0, 35.0},
                                                           {5500.0, 120.0, 5.0}}};

/// A table of surface and bulk at the end of each test, with noise of the stated 1 K.
class MadeUpTable {
public:
    /// @param hidden changes the problem of each test   @param seed of the noise
    MadeUpTable(const std::function<void(solver::Problem&)>& hidden, unsigned seed) {
        std::mt19937 engine(seed);
        std::normal_distribution<double> noise(0.0, 1.0);
        std::string table = "title = \"Made up\"\n";
        for (std::size_t i = 0; i < made_up_tests.size(); ++i) {
            const MadeUpTest& test = made_up_tests[i];
            const std::filesystem::path file = written_.add(
                fmt::format("test_{}.toml", i),
                fmt::format("title = \"Test {0}\"\ninclude = [\"{1}\"]\n[drive]\nvertical_load = \"{2} N\"\nspeed = "
                            "\"{3} km/h\"\nair_temperature = \"{4} degC\"\nroad_temperature = \"{4} "
                            "degC\"\n[initial]\ntemperature = \"{4} degC\"\n",
                            i, (source_folder() / "cases/two_node/common.toml").string(), test.load, test.speed,
                            test.air));
            input::Reading reading = input::read_case(file);
            EXPECT_TRUE(reading.problem.has_value());
            solver::Problem problem = std::move(*reading.problem);
            hidden(problem);
            input::Trace trace;
            const solver::RunEnd end =
                solver::run_to_end(problem, [&](const solver::Snapshot& snapshot) { trace.take(snapshot); });
            EXPECT_EQ(end.failure, "");
            constexpr std::array channels{"surface_temperature", "bulk_temperature"};
            for (std::size_t c = 0; c < channels.size(); ++c) {
                const double value = trace.read(c, {.from = 3600.0, .to = 3600.0}) - 273.15 + noise(engine);
                table += fmt::format(
                    "[[number]]\nid = \"T{0}\"\nwhat = \"{1}\"\nfiles = {{ two_node = \"test_{0}.toml\" }}\nchannel = "
                    "\"{1}\"\nvalue = \"{2:.3f} degC\"\nuncertainty = \"1 K\"\nsource = \"made up\"\n",
                    i, channels[c], value);
            }
        }
        file_ = written_.add("table.toml", table);
    }

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] QuotedDiagnosis diagnose() const {
        const input::ValidationReading reading = input::read_validation(file_);
        EXPECT_TRUE(reading.table.has_value());
        Trials trials(*reading.table, 0, 2, {});
        return diagnose_quoted(*reading.table, trials, 0);
    }

private:
    static std::filesystem::path source_folder() { return TIRETHERM_SOURCE_DIR; }
    input::Written written_;
    std::filesystem::path file_;
};

}  // namespace tiretherm::diagnosis::quoted
