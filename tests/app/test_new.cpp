// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm new` as a user calls it: a first case that runs, from a size and from a log.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "input/new_case/new_case.hpp"
#include "tests/app/program.hpp"
#include "tests/input/loggers/ld_writer.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

constexpr std::string_view standard_log =
    "time [s],speed [km/h],vertical_load [N],air_temperature [degC],surface_temperature [degC],bulk_temperature "
    "[degC]\n"
    "0,0,0,20,20.0,20.0\n"
    "60,100,4000,20,22.0,22.0\n"
    "120,100,4000,20,24.0,25.0\n"
    "180,100,4000,20,26.0,28.0\n";

// Two nodes at 4000 N and 100 km/h: 64.0 degC by an integrator apart from this project (cases/two_node/README.md).
TEST(New, SizeGivesACaseThatRuns) {
    const sample::Scratch scratch;
    const Call made = call("new '225/50 R17' --mesh two_node --out mine/first.toml", scratch.path());
    EXPECT_EQ(made.exit_code, 0);
    EXPECT_EQ(made.err, "");
    EXPECT_TRUE(made.out.starts_with("mine/first.toml: a 225/50 R17 on two nodes, surface and bulk\n")) << made.out;
    EXPECT_NE(made.out.find("\n  drive.vertical_load "), std::string::npos) << made.out;
    EXPECT_TRUE(made.out.ends_with("\nIt runs with: tiretherm run mine/first.toml\n")) << made.out;
    std::filesystem::rename(scratch / "mine/first.toml", scratch / "moved.toml");
    const Call run = call("run moved.toml --json --no-vtk --out out", scratch.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(call("check moved.toml", scratch.path()).err, "");
    EXPECT_NE(call("run moved.toml --no-vtk --out out", scratch.path()).out.find("63.97"), std::string::npos);
}

TEST(New, SectionIsTheStandardMeshAndTheSizeTheStandardName) {
    const sample::Scratch scratch;
    EXPECT_EQ(call("new '235/45 ZR17 94W'", scratch.path()).exit_code, 0);
    const Json check = Json::parse(call("check --json 235_45_ZR17_94W.toml", scratch.path()).out);
    EXPECT_EQ(check["errors"], Json::array());
    EXPECT_EQ(check["warnings"], Json::array());
    EXPECT_GT(check["cells"], 1000);
}

// 1 W of the library's case: the specimen of 12 mm under the spot of 1 cm2. The thesis's spot has 85 degC, the library's case 100.8.
TEST(New, SpecimenNeedsNoTire) {
    const sample::Scratch scratch;
    const Call made = call("new --specimen", scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(made.out.starts_with("specimen.toml: a specimen under a laser\n")) << made.out;
    const Json check = Json::parse(call("check --json specimen.toml", scratch.path()).out);
    EXPECT_EQ(check["errors"], Json::array());
    EXPECT_EQ(check["warnings"], Json::array());
    EXPECT_EQ(check["channels"][0], "spot_centre_temperature");
}

// 80 % of 615 kg at 280 kPa, and of a V tire 73 % at 300 kPa: what the page of the case says of its load.
TEST(New, DurabilityTestIsNamedAfterTireAndTest) {
    const sample::Scratch scratch;
    const Call made = call("new '205/55 R16 91V' --test un_r30", scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Call check = call("check 205_55_R16_91V_un_r30.toml", scratch.path());
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_NE(
        check.out.find("6031 N at 250 kPa, up to 240 km/h; 4403 N at 300 kPa are 73 % of what it may carry there"),
        std::string::npos)
        << check.out;
}

// What the log does not give is said before all else.
TEST(New, LogThatIsNotReadIsSaidFirst) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "a.csv", "Time [s],Speed\n0,80\n1,80\n");
    const Call made = call("new a.csv", scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(
        made.out.starts_with("a.toml: a 225/50 R17 on a cross-section\nThe case does not read a.csv: no column "))
        << made.out;
    EXPECT_EQ(Json::parse(call("new a.csv --json --force", scratch.path()).out)["log"]["reads"], false);
}

TEST(New, LogGivesACaseThatIsCompared) {
    const sample::Scratch scratch;
    std::filesystem::create_directory(scratch / "logs");
    post::replace_file(scratch / "logs/drive.csv", standard_log);
    const Call made =
        call("new logs/drive.csv --size '205/55 R16' --mesh two_node --out cases/mine.toml", scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_NE(made.out.find("\nFrom logs/drive.csv, 4 samples from 0 to 180 s\n"), std::string::npos) << made.out;
    EXPECT_NE(made.out.find("\n  speed [km/h]                input speed\n"), std::string::npos) << made.out;
    EXPECT_NE(made.out.find("measured by the sensor bulk_temperature\n"), std::string::npos) << made.out;
    EXPECT_NE(made.out.find("\n  drive.road_temperature  20 degC"), std::string::npos) << made.out;
    std::filesystem::rename(scratch / "cases", scratch / "elsewhere");
    const Call run = call("run elsewhere/mine.toml --no-vtk", scratch.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Call compared = call("compare elsewhere/mine.toml --json", scratch.path());
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_NE(compared.out.find("bulk_temperature"), std::string::npos);
    EXPECT_EQ(call("identify elsewhere/mine.toml --json", scratch.path()).exit_code, 0);
}

// What `tiretherm run` recorded is a log as well; its channels come back as the sensors they were.
TEST(New, ResultsOfARunAreALog) {
    const sample::Scratch scratch;
    ASSERT_EQ(call("run " + two_node + " --no-vtk --out out", scratch.path()).exit_code, 0);
    const Call made = call("new out/results.h5 --mesh two_node --out again.toml --json", scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made.err << made.out;
    const Json json = Json::parse(made.out);
    EXPECT_EQ(json["case"], "again.toml");
    EXPECT_EQ(json["size"], "225/50 R17");
    EXPECT_EQ(json["log"]["compares"], true);
    EXPECT_EQ(json["log"]["to"], 3600.0);
    EXPECT_EQ(json["assumed"][0]["key"], "tire.size");
    EXPECT_EQ(json["errors"], Json::array());
    // The same constants drive it, from the same start: what differs is the 10 s between the samples of the file.
    const Call compared = call("compare again.toml", scratch.path());
    EXPECT_EQ(compared.exit_code, 0) << compared.err;
}

// From the logger's file to a fit by two commands. In the second lap white noise predicts what was left out better than slow
// noise, so that the parameters are assessed twice: each is listed once, the film, the loss, two of friction, the road and four starts.
TEST(New, LogOfACarIsComparedAndFitted) {
    const sample::Scratch scratch;
    std::filesystem::copy_file(TIRETHERM_SOURCE_DIR "/cases/car/session.csv", scratch / "session.csv");
    const Call made = call("new session.csv", scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made.err << made.out;
    EXPECT_NE(made.out.find("\n  Tire Temp RR [C]      measured by the sensor surface_temperature of RR\n"),
              std::string::npos)
        << made.out;
    EXPECT_NE(made.out.find("\n  vehicle.mass "), std::string::npos) << made.out;
    std::string text = post::read_text(scratch / "session.toml");
    const std::size_t laps = text.find("# laps = \"1-7\"");
    ASSERT_NE(laps, std::string::npos) << text;
    text.replace(laps, std::string_view("# laps = \"1-7\"").size(), "laps = \"2\"");
    post::replace_file(scratch / "session.toml", text);
    const Call compared = call("compare session.toml --no-report", scratch.path());
    EXPECT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_NE(compared.out.find("\nCorners\n"), std::string::npos) << compared.out;
    const Call fitted = call("identify session.toml --json --no-report", scratch.path());
    ASSERT_EQ(fitted.exit_code, 0) << fitted.err;
    const Json json = Json::parse(fitted.out);
    EXPECT_EQ(json["parameters"].size(), 9U);
    EXPECT_NE(json["findings"][0].get<std::string>().find("takes the noise as white"), std::string::npos);
    // What cases/car/README.md says of it: the assumed slips are far too large, and the page points at the friction.
    EXPECT_EQ(json["parameters"][2]["name"], "sliding_friction.lambda_y");
    EXPECT_LT(json["parameters"][2]["value"], 0.4);
    EXPECT_NE(fitted.out.find("sliding_friction.lambda_y: the data pull it"), std::string::npos);
}

// cases/car/loggers has the same three laps as four loggers write them. All have the same digits but for the speed of RaceChrono, whose
// last one in m/s is worth 0.4 of that in km/h, 0.002 km/h of some 150: the same tires come of all, to 1 mK. Each knows its laps.
TEST(New, EveryLoggerOfTheCarGivesTheSameTires) {
    const std::filesystem::path loggers = TIRETHERM_SOURCE_DIR "/cases/car/loggers";
    std::vector<Json> results;
    for (const char* name : {"motec.csv", "motec.ld", "racechrono.csv", "vbox.vbo"}) {
        const sample::Scratch scratch;
        std::filesystem::copy_file(loggers / name, scratch / name);
        std::filesystem::copy_file(loggers / "motec.ldx", scratch / "motec.ldx");
        const Call made = call(std::string("new ") + name + " --out case.toml", scratch.path());
        ASSERT_EQ(made.exit_code, 0) << name << made.err << made.out;
        const Call compared = call("compare case.toml --json --no-report", scratch.path());
        ASSERT_EQ(compared.exit_code, 0) << name << compared.err;
        results.push_back(Json::parse(compared.out));
    }
    for (const Json& result : results) {
        const Json& runs = result["channels"][0]["runs"];
        ASSERT_EQ(runs.size(), 4U);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            EXPECT_EQ(runs[corner]["samples"], 852);
            EXPECT_NEAR(runs[corner]["bias"], results[0]["channels"][0]["runs"][corner]["bias"], 1e-3) << runs[corner];
            EXPECT_NEAR(runs[corner]["rmse"], results[0]["channels"][0]["runs"][corner]["rmse"], 1e-3) << runs[corner];
        }
        EXPECT_EQ(result["laps"].size(), 16U);  // out, 1, 2 and in, at each corner
    }
}

TEST(New, CaseThatIsThereIsLeftAloneWithoutForce) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "mine.toml", "mine\n");
    const Call refused = call("new '225/50 R17' --out mine.toml", scratch.path());
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(
        refused.err,
        "tiretherm: mine.toml exists and is left as it is; replace it with --force, or write elsewhere with --out "
        "FILE\n");
    EXPECT_EQ(post::read_text(scratch / "mine.toml"), "mine\n");
    EXPECT_EQ(call("new '225/50 R17' --out mine.toml --force", scratch.path()).exit_code, 0);
    EXPECT_NE(post::read_text(scratch / "mine.toml"), "mine\n");
    EXPECT_EQ(call("new '225/50 R17' --out .", scratch.path()).err,
              "tiretherm: . is a directory; name a file with --out\n");
}

TEST(New, WrongCallsSayWhatToWrite) {
    const sample::Scratch scratch;
    const auto refused = [&](const std::string& arguments) {
        const Call wrong = call("new " + arguments, scratch.path());
        EXPECT_EQ(wrong.exit_code, 1) << arguments;
        EXPECT_EQ(wrong.out, "") << arguments;
        return wrong.err;
    };
    const std::string sizes =
        "write width in mm / aspect ratio in %, R, rim in inches: \"225/50 R17\"; or in inches outer diameter x width, "
        "rim: \"31x10.50 R15\", or width, rim: \"11 R22.5\"";
    EXPECT_EQ(refused("'225-50R17'"), "tiretherm: \"225-50R17\" is neither the size of a tire nor a file; " + sizes +
                                          ", or name a log: drive.csv\n");
    EXPECT_EQ(refused("drive.csv --size 225"), "tiretherm: size is \"225\", not the size of a tire; " + sizes + "\n");
    EXPECT_EQ(refused("'225/50 R17' --size '225/50 R17'"),
              "tiretherm: two sizes are given; leave --size to a log: tiretherm new drive.csv --size \"225/50 R17\"\n");
    EXPECT_NE(refused("drive.csv").find("cannot be read"), std::string::npos);
    EXPECT_NE(refused("'225/50 R17' --pressure 2.4").find("without a unit"), std::string::npos);
    EXPECT_NE(refused("'225/50 R17' --mesh block").find("two_node"), std::string::npos);
    EXPECT_NE(refused("").find("SIZE|LOG is required"), std::string::npos);
    EXPECT_NE(refused("'225/50 R17' --specimen").find("a specimen has no size"), std::string::npos);
    EXPECT_NE(refused("'225/50 R17' --test un_r30").find("needs the load index"), std::string::npos);
    EXPECT_NE(refused("drive.csv --test un_r30").find("--test needs a tire"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

TEST(New, MistakesOfALogAreReportedAtOnceAndNothingIsWritten) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "drive.csv", "time [s],speed [km/h],bulk_temperature [degC]\n0,abc,30\n10,90,warm\n");
    const Call wrong = call("new drive.csv --out mine.toml", scratch.path());
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("drive.csv:2:3: "), std::string::npos) << wrong.err;
    EXPECT_NE(wrong.err.find("drive.csv:3:7: "), std::string::npos) << wrong.err;
    EXPECT_NE(wrong.err.find("2 errors; no case was written\n"), std::string::npos) << wrong.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "mine.toml"));
    const Json json = Json::parse(call("new drive.csv --out mine.toml --json", scratch.path()).out);
    EXPECT_EQ(json["errors"].size(), 2U);
    EXPECT_EQ(json["errors"][0]["line"], 2);
}

// The beacons of a .ld file stand in the file beside it: they are read, and never replaced. A result follows from them.
TEST(New, BeaconsBesideALogAreAnInput) {
    using input::made_up::LdWriter;
    const sample::Scratch scratch;
    input::made_up::LdChannel speed{.name = "Ground Speed", .unit = "km/h"};
    input::made_up::LdChannel tire{.name = "Tyre Temp FL", .unit = "C"};
    for (int i = 0; i < 100; ++i) {
        speed.samples += LdWriter::bytes_of(static_cast<std::uint16_t>(60 + i % 7));
        tire.samples += LdWriter::bytes_of(static_cast<std::uint16_t>(50 + i % 3));
    }
    speed.count = tire.count = 100;
    post::replace_file(scratch / "motec.ld", LdWriter::file({speed, tire}));
    const std::string beacons = "<Marker ClassName=\"BCN\" Time=\"3e7\"/>\n";
    post::replace_file(scratch / "motec.ldx", beacons);
    for (const char* target : {"motec.ldx", "motec.ld"}) {
        const Call refused = call(std::string("new motec.ld --force --out ") + target, scratch.path());
        EXPECT_EQ(refused.exit_code, 1) << refused.out;
        EXPECT_NE(refused.err.find("would be replaced, and it is a file that the call reads"), std::string::npos)
            << refused.err;
    }
    EXPECT_EQ(post::read_text(scratch / "motec.ldx"), beacons);
    const input::NewCase made =
        input::make_new_case({.size = {}, .log = scratch / "motec.ld", .target = scratch / "case.toml"});
    EXPECT_TRUE(std::ranges::any_of(made.files, [](const std::string& file) { return file.ends_with("motec.ldx"); }));
}

}  // namespace
}  // namespace tiretherm::app_test
