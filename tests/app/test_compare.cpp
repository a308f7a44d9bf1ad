// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm compare`: page, files and JSON for logs with a known offset; exit status 1 for bad input, 2 for a failed
// run.

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/diagnosis/compare/compared_bench.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// The idle bench with its two logs in a folder: it stays at 23 degC, the bulk is read 7/6 K lower on the whole.
struct Bench {
    input::Written written;
    std::string file;

    Bench() {
        written.add("first.csv", diagnosis::sample::first_log);
        written.add("second.csv", diagnosis::sample::second_log);
        file = written.add("idle.toml", diagnosis::sample::idle_bench).string();
    }
    [[nodiscard]] Call compare(const std::string& arguments = "") const {
        return call("compare " + file + " --out " + (written.folder() / "out").string() + " " + arguments);
    }
};

TEST(Compare, EndsWithAPageAndTwoFiles) {
    const Bench bench;
    const Call run = bench.compare();
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out.find('\033'), std::string::npos);
    EXPECT_TRUE(run.out.starts_with("idle, simulated against measured\n")) << run.out;
    // The answer first, then how it was made.
    EXPECT_LT(run.out.find(" K, at "), run.out.find("\n2 runs, simulated in ")) << run.out;
    for (const char* name : {"compare.csv", "compare_statistics.csv"}) {
        EXPECT_GT(std::filesystem::file_size(bench.written.folder() / "out" / name), 100u);
        EXPECT_NE(run.out.find(name), std::string::npos);
    }
}

TEST(Compare, JsonIsOneObject) {
    const Bench bench;
    const Call run = bench.compare("--json");
    EXPECT_EQ(run.exit_code, 0);
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["case"], "idle");
    ASSERT_EQ(json["channels"].size(), 2u);
    const Json& bulk = json["channels"][0]["name"] == "bulk_temperature" ? json["channels"][0] : json["channels"][1];
    EXPECT_NEAR(bulk["bias"].get<double>(), 7.0 / 6.0, 1e-9);  // 7 K too hot in all, over 6 samples
    EXPECT_EQ(json["numbers"].size(), 1u);
    EXPECT_EQ(json["outputs"].size(), 4u);
}

TEST(Compare, OtherRunsTakeThePlaceOfTheCasesOwn) {
    // The second log alone: the bulk is read 3 K lower, the surface not at all.
    const Bench bench;
    const Call run = bench.compare("--json --data " + (bench.written.folder() / "second.csv").string());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["runs"].size(), 1u);
    ASSERT_EQ(json["channels"].size(), 1u);
    EXPECT_NEAR(json["channels"][0]["bias"].get<double>(), 3.0, 1e-9);
}

/// A run of a bench at a steady speed, with what it reads at all times. @param tables of the case
Call compared(std::string_view tables, double kmh, const std::string& reading, const std::string& arguments = "",
              int rows = 21) {
    const input::Written written;
    std::string log =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC]," + reading + "\n";
    for (int i = 0; i < rows; ++i) {
        log += fmt::format("{},{},4000,20,25,{:.2f}\n", 10 * i, kmh, 25.0 + 8.0 * i / (rows - 1));
    }
    written.add("run.csv", log);
    written.add("case.toml", std::string(tables) + "[[run]]\nfile = \"run.csv\"\n");
    return call("compare case.toml --out out --no-report " + arguments, written.folder());
}

// The loss was compared up to 150 km/h: beyond, the first sentences and the warnings say so, in the JSON as well.
TEST(Compare, ARunBeyondWhatALawWasComparedAtIsTold) {
    const Call fast = compared(input::bench, 230.0, "surface_temperature [degC]", "--json");
    ASSERT_EQ(fast.exit_code, 0) << fast.err;
    EXPECT_EQ(Json::parse(fast.out)["warnings"],
              Json({"strain_energy_loss was compared up to 150 km/h, this test goes to 230: beyond, its law is an "
                    "extrapolation"}));
    const Call page = compared(input::bench, 230.0, "surface_temperature [degC]");
    EXPECT_NE(page.out.find("Laws beyond what is known of them: strain energy loss compared up to 150 km/h"),
              std::string::npos)
        << page.out;
    EXPECT_EQ(Json::parse(compared(input::bench, 140.0, "surface_temperature [degC]", "--json").out)["warnings"],
              Json::array());
}

constexpr std::string_view strip = R"([mesh]
kind = "layers"
area = "0.4 m2"
[[mesh.layer]]
name = "tread"
thickness = "12 mm"
cells = 3
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.3 W/mK"
[effects.still_air]
patches = ["outside"]
h = "60 W/m2K"
[initial]
temperature = "80 degC"
[[sensor]]
name = "middle"
kind = "point"
depth = "3 mm"
)";

// A strip of three cells has an error of its grid, which a grid of six shows; two nodes have none.
TEST(Compare, TheErrorOfACoarseGridIsTold) {
    const Call coarse = compared(strip, 0.0, "middle [degC]", "--json");
    ASSERT_EQ(coarse.exit_code, 0) << coarse.err;
    const double error = Json::parse(coarse.out)["channels"][0]["grid_error"].get<double>();
    EXPECT_GT(error, 0.05);
    EXPECT_LT(error, 10.0);
    const Call page = compared(strip, 0.0, "middle [degC]");
    EXPECT_NE(page.out.find("The error of grid and steps in what is simulated is at most "), std::string::npos)
        << page.out;
    const Json lumps = Json::parse(compared(input::bench, 140.0, "surface_temperature [degC]", "--json").out);
    EXPECT_TRUE(lumps["channels"][0]["grid_error"].is_null());
}

// More than 400 cells, or more than four millions of cells times samples: 400 cells at 10 001 samples. Half as many samples are looked at.
TEST(Compare, TheErrorOfAGridIsNotLookedAtWhereThatTakesLong) {
    const auto page_of = [](const char* cells, int rows) {
        return compared(input::replaced(std::string(strip), "cells = 3", std::string("cells = ") + cells), 0.0,
                        "middle [degC]", "", rows)
            .out;
    };
    EXPECT_NE(page_of("401", 21).find(
                  "The error of the grid was not computed: 401 cells over 21 samples would take too long."),
              std::string::npos);
    const std::string many = page_of("400", 10'001);
    EXPECT_NE(many.find("400 cells over 10 001 samples"), std::string::npos) << many;
    EXPECT_EQ(page_of("20", 5'000).find("was not computed"), std::string::npos);
}

TEST(Compare, ErrorsAreReportedAndEndWith1) {
    const Bench bench;
    const std::string log = bench.written.add("wrong.csv", "time [s],speed [km/h]\n0,1\n0,2\n").string();
    const Call wrong = bench.compare("--data " + log);
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("nothing was compared"), std::string::npos) << wrong.err;
    EXPECT_NE(wrong.err.find("wrong.csv"), std::string::npos) << wrong.err;
    const Call json = bench.compare("--json --data " + log);
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_FALSE(Json::parse(json.out)["errors"].empty());
    EXPECT_EQ(call("compare " + two_node).exit_code, 1);  // a case without any measured run
    EXPECT_EQ(call("compare no_such_case.toml").exit_code, 1);
    const Call nowhere = call("compare " + bench.file + " --out /proc/nowhere");
    EXPECT_EQ(nowhere.exit_code, 1);
    EXPECT_NE(nowhere.err.find("--out"), std::string::npos) << nowhere.err;
}

TEST(Compare, ASolverThatFailsEndsWith2) {
    const Bench bench;
    const Call run = call("compare " + bench.written.add("hot.toml", diagnosis::sample::burning_bench).string());
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_NE(run.err.find("run \"first\""), std::string::npos) << run.err;
}

TEST(Compare, HelpHasAnExample) {
    const Call help = call("compare --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("tiretherm compare cases/practice/two_node_bench.toml"), std::string::npos);
}

}  // namespace
}  // namespace tiretherm::app_test
