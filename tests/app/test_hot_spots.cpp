// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run` on a case with critical temperatures, as a user and a program read it.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"
#include "support/warming_lump.hpp"
#include "tests/app/program.hpp"

namespace tiretherm::app_test {

namespace {

using Json = nlohmann::json;
using support::critical;
using support::three_steps;
using support::warming_plate;

/// Text without its line breaks.
std::string flowing(const std::string& text) {
    std::string flow;
    for (const char c : text) {
        const char blank = c == '\n' ? ' ' : c;
        if (blank != ' ' || flow.empty() || flow.back() != ' ') {
            flow += blank;
        }
    }
    return flow;
}

/// Runs a case that is written into an empty directory.
Call run(const sample::Scratch& scratch, const std::string& text, const std::string& options = "") {
    post::replace_file(scratch / "case.toml", text);
    return call("run case.toml --out out --no-vtk " + options, scratch.path());
}

Json spots(const std::string& text) {
    const sample::Scratch scratch;
    const Call done = run(scratch, text, "--json");
    EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
    return Json::parse(done.out)["hot_spots"];
}

}  // namespace

// The plate passes 55 degC in its third step, whose closed form is support::WarmingLump: a source's formula is right to
// 1e-4 of 48 K, 5 mK, and at 55 degC the plate warms by 13 mK/s.
TEST(HotSpots, PassingIsToldWithItsStepAndSpeed) {
    const Json all = spots(warming_plate + critical("55 degC") + three_steps);
    const Json& spot = all["spots"][0];
    const double expected = support::WarmingLump{}.passing(55.0, 3);
    ASSERT_GT(expected, 1200.0);
    EXPECT_NEAR(spot["passed"]["time"].get<double>(), expected, 1.0);
    EXPECT_EQ(spot["passed"]["step"], 3);
    EXPECT_NEAR(spot["passed"]["into_step"].get<double>(), expected - 1200.0, 1.0);
    EXPECT_NEAR(spot["passed"]["speed"].get<double>(), 24.0 * 3.6, 1e-9);
    EXPECT_TRUE(spot["further_steps"].is_null());
    // Steps at their ends and held for ever: 60, 64 and 68 degC.
    ASSERT_EQ(spot["steps"].size(), 3U);
    for (int i = 0; i < 3; ++i) {
        const Json& step = spot["steps"][static_cast<std::size_t>(i)];
        EXPECT_NEAR(step["hottest_at_end"].get<double>(), support::WarmingLump{}.at_end(i), 0.02) << i;
        EXPECT_NEAR(step["hottest_steady"].get<double>(), 60.0 + 4.0 * i, 0.02) << i;
    }
    EXPECT_NEAR(spot["margin"].get<double>(), 55.0 - support::WarmingLump{}.at_end(2), 0.02);
    // The first step would settle at 60 degC: no step lies below, so that nobody knows the surface's threshold.
    EXPECT_TRUE(spot["surface"]["threshold"].is_null());
    EXPECT_TRUE(spot["surface"]["lag"].is_null());
}

// Steps of an hour come as near to 60 and 64 degC as 1.1 and 0.2 K: at 62 degC the surface reads what the hot spot has (the
// plate has one temperature), and passes it together with it, at 3600 + 1000 ln(5.09/2) = 4534 s by the closed form.
TEST(HotSpots, SurfaceOfAPlateThatHasOneTemperatureDoesNotLag) {
    const Json all = spots(warming_plate + critical("62 degC") + R"([drive]
air_temperature = "20 degC"
[[drive.schedule]]
columns = ["time [min]", "speed [m/s]"]
rows = [[0, 20], [60, 20], [60, 22], [120, 22]]
[time]
end = "120 min"
tolerance = "0.0001 K"
output = "5 s"
)");
    const Json& spot = all["spots"][0];
    EXPECT_NEAR(spot["passed"]["time"].get<double>(), (support::WarmingLump{.step = 3600.0}.passing(62.0, 2)), 3.0);
    EXPECT_EQ(spot["surface"]["reading"], "top");
    EXPECT_NEAR(spot["surface"]["threshold"].get<double>(), 62.0, 0.01);
    EXPECT_NEAR(spot["surface"]["lag"].get<double>(), 0.0, 5.0);
}

TEST(HotSpots, MarginAndFurtherStepsAreToldWhenNothingPasses) {
    const sample::Scratch scratch;
    const Call done = run(scratch, warming_plate + critical("75 degC") + three_steps, "");
    EXPECT_EQ(done.exit_code, 0) << done.err;
    // Continued in steps of 2 m/s every 10 min, the closed form passes 75 degC in the step of 32 m/s, the seventh; a source's
    // formula is right to 16 mK of 164 K there, or 1.8 s.
    const Json spot = spots(warming_plate + critical("75 degC") + three_steps)["spots"][0];
    EXPECT_NEAR(spot["margin"].get<double>(), 75.0 - support::WarmingLump{}.at_end(2), 0.02);
    const Json& further = spot["further_steps"];
    EXPECT_NEAR(further["rise"].get<double>(), 7.2, 1e-9);
    EXPECT_NEAR(further["step_duration"].get<double>(), 600.0, 1e-9);
    EXPECT_EQ(further["passed"]["step"], 7);
    EXPECT_NEAR(further["passed"]["speed"].get<double>(), 115.2, 1e-9);
    EXPECT_NEAR(further["passed"]["time"].get<double>(), (support::WarmingLump{}.passing(75.0, 7)), 1.8);
    for (const std::string& piece :
         {std::string("plate: critical 75.0 degC"), std::string("hot_spots.csv"), std::string("page.txt")}) {
        EXPECT_NE(flowing(done.out).find(piece), std::string::npos) << "lacks: " << piece << "\n" << done.out;
    }
    const std::string csv = post::read_text(scratch / "out/hot_spots.csv");
    EXPECT_TRUE(
        csv.starts_with("time [s],speed [km/h],vertical_load [N],plate [degC],plate margin [K],plate layer,plate "
                        "zone,plate along [mm],plate depth [mm],plate surface [degC]\n"))
        << csv.substr(0, 200);
    EXPECT_NE(csv.find("\n600,72,0,"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(scratch / "out/page.txt"));
    // Files of a case that asks for hot spots do not outlive it.
    const Call again = run(scratch, warming_plate + three_steps);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(again.out.find("Hot spots"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(scratch / "out/hot_spots.csv"));
}

// The hottest place of the tire lies in its whole, so both names of it have one moment, between rows as well. The page begins
// with the critical temperatures and how sure they are.
TEST(HotSpots, ThePageBeginsWithThemAndTheHottestPlaceHasOneMoment) {
    const sample::Scratch scratch;
    const std::string arguments = "run cases/durability/un_r30_load_speed.toml --no-vtk --out ";
    const Call done = call(arguments + (scratch / "out").string() + " --json", TIRETHERM_SOURCE_DIR);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const Json json = Json::parse(done.out);
    const Json& whole = json["hot_spots"]["spots"][1];
    EXPECT_EQ(whole["hottest"], json["hottest"]["temperature"]);
    EXPECT_EQ(whole["hottest_moment"]["time"], json["hottest"]["time"]);
    const std::string page = flowing(post::read_text(scratch / "out/page.txt"));
    const std::size_t spot = page.find(fmt::format(
        "belt edge comes to {:.1f} degC and stays {:.1f} K below its critical 110 degC",
        json["hot_spots"]["spots"][0]["hottest"].get<double>(), json["hot_spots"]["spots"][0]["margin"].get<double>()));
    EXPECT_LT(spot, page.find("Hottest: ")) << page.substr(0, 600);
    EXPECT_NE(page.find("no uncertainty was computed (see [[uncertain]])"), std::string::npos);
}

// 2 * 20 + 20 = 60 degC in the steady state of 20 m/s, which has no time and is not passed at one.
TEST(HotSpots, SteadyStateHasAMarginButNoTime) {
    const sample::Scratch scratch;
    const std::string steady =
        "[drive]\nair_temperature = \"20 degC\"\nspeed = \"20 m/s\"\n[time]\nend = \"1 s\"\nsteady = true\n";
    const Call done = run(scratch, warming_plate + critical("55 degC") + steady, "");
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(flowing(done.out).find(
                  "hottest 60.0 degC in the steady state of 72 km/h, 0 N; at that moment top reads 60.0 degC; "
                  "5.0 K too hot"),
              std::string::npos)
        << done.out;
    const Json all = spots(warming_plate + critical("55 degC") + steady);
    EXPECT_TRUE(all["spots"][0]["passed"].is_null());
    EXPECT_TRUE(all["spots"][0]["further_steps"].is_null());
    EXPECT_NEAR(all["spots"][0]["margin"].get<double>(), -5.0, 0.01);
}

TEST(HotSpots, RefusalToGoOnIsTold) {
    const std::string steady = "[drive]\nair_temperature = \"20 degC\"\nspeed = \"20 m/s\"\n[time]\nend = \"30 min\"\n";
    const Json all = spots(warming_plate + critical("75 degC") + steady);
    EXPECT_EQ(all["spots"][0]["further_steps"]["refusal"], "the test has no steps of speed that could go on");
    EXPECT_TRUE(all["spots"][0]["further_steps"]["passed"].is_null());
}

// The plate is straight in all three numbers. At its end, 1800 s and 62 K/40 ... above the air, it follows
//   the source's watts, 20 +- 2 W per m/s:  0.1 (T - 20 degC),
//   the air, 20 +- 2 K:                     2 K (1 - exp(-1.8)) = 1.669 K, for the start stays where it was.
// Together their root sum of squares; above 62 degC with the normal probability of that.
TEST(HotSpots, FirstOrderIsTheClosedFormOfAStraightCase) {
    const Json all = spots(warming_plate + critical("62 degC") + three_steps + R"([[parameter]]
source = "running"
standard_deviation = "2 W"
[[uncertain]]
key = "drive.air_temperature"
standard_deviation = "2 K"
)");
    const Json& uncertainty = all["spots"][0]["uncertainty"];
    const double end = support::WarmingLump{}.at_end(2);
    const double by_watts = 0.1 * (end - 20.0);
    const double by_air = 2.0 * -std::expm1(-1.8);
    ASSERT_EQ(uncertainty["drivers"].size(), 2U) << all;
    EXPECT_NEAR(uncertainty["drivers"][0]["kelvin"].get<double>(), by_watts, 0.005);
    EXPECT_EQ(uncertainty["drivers"][1]["name"], "drive.air_temperature");
    EXPECT_NEAR(uncertainty["drivers"][1]["kelvin"].get<double>(), by_air, 0.002);
    EXPECT_NEAR(uncertainty["drivers"][1]["nonlinearity"].get<double>(), 0.0, 1e-4);
    const double sd = std::hypot(by_watts, by_air);
    EXPECT_NEAR(uncertainty["standard_deviation"].get<double>(), sd, 0.005);
    EXPECT_NEAR(uncertainty["chance_above_critical"].get<double>(), 0.5 * std::erfc((62.0 - end) / sd / std::sqrt(2.0)),
                0.002);
}

// 1000 kg/m3 less a deviation of 1100 is no density: the number is left out, and said to be.
TEST(HotSpots, UncertainValueThatTheCaseCannotHaveIsLeftOutAndTold) {
    const Json all = spots(warming_plate + critical("62 degC") + three_steps + R"([[uncertain]]
key = "material.metal.density"
standard_deviation = "1100 kg/m3"
[[uncertain]]
key = "drive.air_temperature"
standard_deviation = "2 K"
)");
    EXPECT_EQ(all["spots"][0]["uncertainty"]["drivers"].size(), 1U);
    ASSERT_EQ(all["notes"].size(), 1U);
    EXPECT_TRUE(all["notes"][0].get<std::string>().starts_with("material.metal.density is left out")) << all["notes"];
}

// The same numbers as a study's draws, 300 samples of a coarse section: the tangent's deviation and that of the samples'
// straight line differ by no more than 4/sqrt(600) of it, its probability lies within 3 standard deviations of a count
// of 300, and each number's slope within twice its 95 % interval and 5 % for the bend.
TEST(HotSpots, FirstOrderAgreesWithSamples) {
    const sample::Scratch scratch;
    const std::string base = "include = [\"" TIRETHERM_SOURCE_DIR "/tests/bad_cases/good/section.toml\"]\n";
    post::replace_file(scratch / "case.toml", base + R"([drive]
speed = "120 km/h"
vertical_load = "6000 N"
[effects.load_input_gain]
gain = 1.0
[time]
end = "40 min"
[[critical]]
name = "tire"
temperature = "80 degC"
[[parameter]]
effect = "strain_energy_loss"
key = "tan_delta_a"
standard_deviation = 2.14e14
[[parameter]]
effect = "air_convection"
key = "lambda_h"
standard_deviation = 0.1
[[parameter]]
effect = "load_input_gain"
key = "gain"
standard_deviation = 0.03
[[uncertain]]
key = "drive.air_temperature"
standard_deviation = "3 K"
)");
    const Call one = call("run case.toml --out one --json --no-vtk", scratch.path());
    ASSERT_EQ(one.exit_code, 0) << one.out << one.err;
    const Json spot = Json::parse(one.out)["hot_spots"]["spots"][0];
    // A critical temperature half a deviation above the hot spot, where a probability says most.
    const double sd = spot["uncertainty"]["standard_deviation"];
    const double limit = spot["uncertainty"]["mean"].get<double>() + 0.5 * sd;
    const auto draw = [](const std::string& key, const std::string& mean, const std::string& deviation) {
        return "[[draw]]\nkey = \"" + key + "\"\ndistribution = \"normal\"\nmean = " + mean +
               "\nstandard_deviation = " + deviation + "\n";
    };
    post::replace_file(scratch / "study.toml",
                       fmt::format("case = \"case.toml\"\ncritical = \"{} degC\"\n[sample]\ncount = 300\n", limit) +
                           draw("effects.strain_energy_loss.tan_delta_a", "2.14e15", "2.14e14") +
                           draw("effects.air_convection.lambda_h", "1.0", "0.1") +
                           draw("effects.load_input_gain.gain", "1.0", "0.03") +
                           draw("drive.air_temperature", "\"23 degC\"", "\"3 K\""));
    const Call many = call("study study.toml --out many --json", scratch.path());
    ASSERT_EQ(many.exit_code, 0) << many.out << many.err;
    const Json point = Json::parse(many.out)["points"][0];
    EXPECT_NEAR(point["drivers"]["standard_deviation"].get<double>(), sd, 4.0 / std::sqrt(600.0) * sd);
    EXPECT_GT(point["drivers"]["r_squared"].get<double>(), 0.97);
    const double expected = 0.5 * std::erfc(0.5 / std::sqrt(2.0));
    EXPECT_NEAR(point["passes_critical"]["share"].get<double>(), expected,
                3.0 * std::sqrt(expected * (1.0 - expected) / 300.0));
    for (const Json& number : point["drivers"]["numbers"]) {
        const std::string key = number["key"];
        const Json& drivers = spot["uncertainty"]["drivers"];
        const auto same = std::find_if(drivers.begin(), drivers.end(), [&](const Json& driver) {
            return key.ends_with(driver["name"].get<std::string>());
        });
        ASSERT_NE(same, drivers.end()) << key;
        // Per deviation of the samples there, of the case's here.
        const double slope = number["kelvin"].get<double>() / number["standard_deviation"].get<double>() *
                             (*same)["standard_deviation"].get<double>();
        const double exact = (*same)["kelvin"];
        EXPECT_NEAR(slope, exact, 2.0 * number["uncertainty"].get<double>() + 0.05 * std::abs(exact)) << key;
    }
}

// Air 10 K warmer, and the start as well, make every place of a linear plate 10 K hotter: half of that is the standard deviation of
// two cases that are as likely, and moves their mean.
TEST(HotSpots, AnAlternativeIsAsLikelyAsTheCase) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "warmer.toml",
                       "[drive]\nair_temperature = \"30 degC\"\n[initial]\ntemperature = \"30 degC\"\n");
    const std::string text =
        warming_plate + critical("75 degC") + three_steps + "[[uncertain]]\nalternative = \"warmer.toml\"\n";
    const Call done = run(scratch, text, "--json");
    ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
    const Json spot = Json::parse(done.out)["hot_spots"]["spots"][0];
    const Json& driver = spot["uncertainty"]["drivers"][0];
    EXPECT_EQ(driver["name"], "warmer");
    EXPECT_TRUE(driver["value"].is_null());
    EXPECT_NEAR(driver["kelvin"].get<double>(), 5.0, 0.005);
    EXPECT_NEAR(spot["uncertainty"]["mean"].get<double>(), spot["hottest"].get<double>() + 5.0, 0.005);
    EXPECT_NEAR(spot["uncertainty"]["standard_deviation"].get<double>(), 5.0, 0.005);
    const Call missing =
        run(scratch, warming_plate + critical("75 degC") + three_steps +
                         "[[uncertain]]\nalternative = \"colder.toml\"\nkey = \"drive.air_temperature\"\n");
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.err.find("colder.toml"), std::string::npos) << missing.err;
    EXPECT_NE(missing.err.find("both alternative and key are given"), std::string::npos) << missing.err;
}

TEST(HotSpots, HelpSpeaksOfThem) {
    const Call help = call("run --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("[[critical]]"), std::string::npos);
    EXPECT_NE(help.out.find("hot_spots.csv"), std::string::npos);
}

TEST(HotSpots, ErrorsOfCriticalTemperaturesAreAnObjectToo) {
    const sample::Scratch scratch;
    const Call done = run(scratch, warming_plate + critical("15 degC") + three_steps, "--json");
    EXPECT_EQ(done.exit_code, 1);
    const Json report = Json::parse(done.out);
    ASSERT_EQ(report["errors"].size(), 1U) << done.out;
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

// The run fails in its second step: of the others nothing is known.
TEST(HotSpots, ARunThatFailsHasThePageOfWhatItCameTo) {
    const sample::Scratch scratch;
    post::replace_file(
        scratch / "fire.toml",
        "include = [\"" TIRETHERM_SOURCE_DIR
        "/cases/durability/fmvss_139_high_speed.toml\"]\n"
        "[[source]]\nname = \"fire\"\nfollows = \"(time > 8000) * 1e15\"\nat = \"surface\"\nwatts = \"1 W\"\n");
    const Call run = call("run fire.toml --no-vtk --out o", scratch.path());
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_NE(run.out.find("The run ended early: nothing is said of steady states"), std::string::npos) << run.out;
    EXPECT_TRUE(std::filesystem::exists(scratch / "o/report.html"));
}

}  // namespace tiretherm::app_test
