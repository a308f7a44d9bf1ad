// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm diagnose` of data that are wrong themselves: labels, and more noise than the data sheets say.

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/diagnosis/practice_bench.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;
using diagnosis::sample::Log;

const std::string bench_of_two = TIRETHERM_SOURCE_DIR "/cases/practice/two_node_bench.toml";
constexpr std::size_t surface_column = 8;
constexpr std::size_t bulk_column = 9;

/// The shipped runs, each reading changed.
std::vector<Log> changed_logs(const std::function<double(std::size_t column, double reading)>& change) {
    std::vector<Log> logs = diagnosis::sample::practice_logs();
    for (Log& log : logs) {
        for (const std::size_t column : {surface_column, bulk_column}) {
            for (double& reading : log.columns[column]) {
                reading = change(column, reading);
            }
        }
    }
    return logs;
}

/// Diagnoses the first two runs; a third is kept back as kept_back.csv.
Json diagnosed(const input::Written& written, const std::vector<Log>& logs) {
    const std::string first = written.add("run1.csv", logs[0].text()).string();
    const std::string second = written.add("run2.csv", logs[1].text()).string();
    written.add("kept_back.csv", logs[2].text());
    const Call found = call("diagnose " + bench_of_two + " --data " + first + " --data " + second +
                            " --no-by-run --json --out " + (written.folder() / "out").string());
    EXPECT_EQ(found.exit_code, 0) << found.err;
    return found.exit_code == 0 ? Json::parse(found.out) : Json::object();
}

// The bench has nothing but the wrong unit: once it is read as it is the model agrees, and the unit is the one cause. The extended
// case reads a file that was kept back in the same unit, to the noise of its sensors (0.5 and 0.3 K, 5 % for 601 samples and
// a start that nobody fitted to it).
TEST(DiagnoseData, ASurfaceInFahrenheitIsTheCauseAndIsCorrectedInTheExtendedCase) {
    const input::Written written;
    const Json json = diagnosed(written, changed_logs([](std::size_t column, double reading) {
                                    return column == surface_column ? 1.8 * reading + 32.0 : reading;
                                }));
    EXPECT_EQ(json["verdict"], "named");
    EXPECT_EQ(json["set"], Json::parse(R"([["unit"]])"));
    EXPECT_EQ(json["causes"][0]["columns"], Json::parse(R"(["surface_temperature"])"));
    EXPECT_EQ(json["causes"][0]["unit"], "degF");
    const std::string reason = json["reason"];
    EXPECT_TRUE(reason.starts_with("The numbers of surface_temperature look like degF under a heading of degC"))
        << reason;
    EXPECT_NE(reason.find("in run1.csv and run2.csv (line 1)"), std::string::npos) << reason;
    EXPECT_TRUE(json["findings"].empty()) << json["findings"];  // no second sentence of the same
    const Call compared =
        call("compare " + (written.folder() / "out/extended.toml").string() + " --data " +
             (written.folder() / "kept_back.csv").string() + " --json --out " + (written.folder() / "kept").string());
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    const Json channels = Json::parse(compared.out)["channels"];
    EXPECT_LT(channels[0]["rmse"], 1.0);
    EXPECT_LT(channels[1]["rmse"], 1.0);
}

// White noise of the root of three times the sheet's beside that of the readings makes twice the sheet's.
TEST(DiagnoseData, NoiseOfTwiceTheDataSheetIsNoCause) {
    std::mt19937 engine(20261127);
    std::normal_distribution<double> normal;
    const input::Written written;
    const Json json =
        diagnosed(written, changed_logs([&](std::size_t column, double reading) {
                      return reading + std::sqrt(3.0) * (column == surface_column ? 0.5 : 0.3) * normal(engine);
                  }));
    EXPECT_EQ(json["verdict"], "consistent") << json["reason"];
    const std::string reason = json["reason"];
    EXPECT_NE(reason.find("the noise of surface_temperature is "), std::string::npos) << reason;
    EXPECT_NE(reason.find("the 0.5 K of the data sheet"), std::string::npos) << reason;
    EXPECT_NE(reason.find("nothing in these data asks for a cause"), std::string::npos) << reason;
    EXPECT_TRUE(json["model_error"].empty()) << json["model_error"];
}

}  // namespace
}  // namespace tiretherm::app_test
