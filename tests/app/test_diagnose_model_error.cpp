// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm diagnose` where the model has an error beside any cause: two nodes on the runs of a tire of many layers.

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"
#include "tests/app/program.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string practice_folder = TIRETHERM_SOURCE_DIR "/cases/practice/";

// layers_run1 and 2 were made by an integrator of its own with 23 cells through tread and carcass of other conductivities
// (section_bench.md), the noise 0.5 and 0.3 K. Two nodes, film, loss and starts fitted, miss them by several kelvin; layers
// of the same mass come near, whatever their one conductivity can do for two.
TEST(DiagnoseBesideModelError, ACoarseMeshIsTheCause) {
    const input::Written written;
    const std::string out = (written.folder() / "out").string();
    const Call found =
        call("diagnose " + practice_folder + "two_node_bench.toml --data " + practice_folder +
             "layers_run1.csv --data " + practice_folder + "layers_run2.csv --no-by-run --json --out " + out);
    ASSERT_EQ(found.exit_code, 0) << found.err;
    const Json json = Json::parse(found.out);
    EXPECT_EQ(json["verdict"], "partial") << json["reason"];
    ASSERT_FALSE(json["set"].empty());
    EXPECT_EQ(json["set"][0][0], "mesh") << json["set"];
    EXPECT_EQ(json["causes"][0]["place"], "layers");
    EXPECT_GT(json["gain"]["error_removed_low"], 0.0);
    EXPECT_FALSE(json["model_error"].empty());
    for (const Json& channel : json["channels"]) {
        EXPECT_LT(channel["heldout_after"], channel["heldout_before"]) << channel;
    }
    // The page of the extended case is that of layers, and it is what the diagnosis has seen.
    const Call compared =
        call("compare " + out + "/extended.toml --json --out " + (written.folder() / "again").string());
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    const Json channels = Json::parse(compared.out)["channels"];
    for (std::size_t c = 0; c < channels.size(); ++c) {
        EXPECT_NEAR(channels[c]["rmse"].get<double>(), json["channels"][c]["rmse_after"].get<double>(), 0.01);
    }
}

TEST(DiagnoseBesideModelError, ATimeLimitIsMoreThanNothing) {
    for (const char* limit : {"-1", "0", "''", "nan", "soon", "5s"}) {
        const Call wrong = call("diagnose " + practice_folder + "two_node_bench.toml --time-limit " + limit);
        EXPECT_EQ(wrong.exit_code, 1);
        EXPECT_NE(wrong.err.find("is no number of seconds above 0"), std::string::npos) << wrong.err;
    }
}

}  // namespace
}  // namespace tiretherm::app_test
