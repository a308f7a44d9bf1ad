// SPDX-License-Identifier: BSD-3-Clause
// One log in every CSV dialect gives the same inputs; columns, units and schedules; a long log is read in linear time.

#include <algorithm>

#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// A slab whose speed and road temperature come from this log. @param keys more keys of [[drive.file]]
Reading read_log(std::string_view log, std::string_view keys = "") {
    const Written written;
    written.add("logs/run.csv", log);
    std::string text(slab);
    text.erase(text.find("[time]"), std::string_view("[time]\nend = \"60 s\"\n").size());
    return read_case(written.add("case.toml", text + "[[drive.file]]\npath = \"logs/run.csv\"\n" + std::string(keys)));
}

const solver::Series* find(const Reading& reading, std::string_view name) {
    if (!reading.problem) {
        ADD_FAILURE() << error_report(reading);
        return nullptr;
    }
    for (const solver::Series& series : reading.problem->input_signals.series()) {
        if (series.signal->name == name) {
            return &series;
        }
    }
    ADD_FAILURE() << name << " was not read";
    return nullptr;
}

/// The same three samples in every dialect: 0, 36, 54 km/h at 0, 2 and 5 s; 23, 24, 25 degC.
void expect_samples(const Reading& reading) {
    const solver::Series* speed = find(reading, "speed");
    const solver::Series* road = find(reading, "road_temperature");
    ASSERT_TRUE(speed != nullptr && road != nullptr);
    EXPECT_TRUE(speed->logged);
    ASSERT_EQ(speed->time, (std::vector<double>{0.0, 2.0, 5.0}));
    ASSERT_EQ(speed->value.size(), 3U);
    EXPECT_DOUBLE_EQ(speed->value[1], 10.0);
    EXPECT_DOUBLE_EQ(speed->value[2], 15.0);
    EXPECT_DOUBLE_EQ(road->value[2], 298.15);
}

}  // namespace

TEST(Csv, Commas) {
    expect_samples(read_log("time [s],speed [km/h],road_temperature [degC]\n0,0,23\n2,36,24\n5,54.0,2.5e1\n"));
}
// Every page and message repeats a heading: one of 10 MB made pages of 60 MB.
TEST(Csv, HeadingsWithoutEndAreRefused) {
    const std::string endless(1'000'000, 'x');
    for (const std::string& heading : {endless, "load [" + endless + "]"}) {
        const Reading reading = read_log("time [s],speed [km/h]," + heading + "\n0,0,1\n2,36,2\n");
        const std::string said = error_report(reading);
        EXPECT_NE(said.find("logs/run.csv:1:23: the heading of a column has 1000000 characters"), std::string::npos)
            << said.substr(0, 500);
        EXPECT_LT(said.size(), 1000U);
    }
}
TEST(Csv, Semicolons) {
    expect_samples(read_log("time [s];speed [km/h];road_temperature [degC]\n0;0;23\n2;36;24\n5;54;25\n"));
}
TEST(Csv, TabsAndNoNewlineAtTheEnd) {
    expect_samples(read_log("time [s]\tspeed [km/h]\troad_temperature [degC]\n0\t0\t23\n2\t36\t24\n5\t54\t25"));
}
TEST(Csv, ByteOrderMarkAndCarriageReturns) {
    expect_samples(
        read_log("\xEF\xBB\xBFtime [s],speed [km/h],road_temperature [degC]\r\n0,0,23\r\n2,36,24\r\n5,54,25\r\n"));
}
TEST(Csv, QuotesBlanksAndEmptyLines) {
    expect_samples(read_log(
        "\n\"time [s]\" , \"speed [km/h]\" , road_temperature[degC]\n\n 0 , \"0\", 23\n2, 36,24 \n\n5,54,+25\n\n"));
}
TEST(Csv, TrailingSeparators) {
    expect_samples(read_log("time [s],speed [km/h],road_temperature [degC]\n0,0,23,\n2,36,24,\n5,54,25,\n"));
    expect_samples(read_log("time [s],speed [km/h],road_temperature [degC],\n0,0,23,\n2,36,24,\n5,54,25,\n"));
}
TEST(Csv, OtherUnits) {
    expect_samples(
        read_log("time [min],speed [m/s],road_temperature "
                 "[degF]\n0,0,73.4\n0.033333333333333333,10,75.2\n0.083333333333333333,15,77\n"));
    expect_samples(
        read_log("time [ms],speed [kph],road_temperature [\xB0"
                 "C]\n0,0,23\n2000,36,24\n5000,54,25\n"));
}
TEST(Csv, ColumnsMayBeRenamedAndIgnored) {
    expect_samples(
        read_log("t [s],V [km/h],road_temperature [degC],vertical_load [N]\n0,0,23,\n2,36,24,x\n5,54,25,nan\n",
                 "columns = { t = \"time\", V = \"speed\" }\nignore = [\"vertical_load\"]\n"));
}

// Channels and signals unknown to the tire may hold anything: they are not read here.
TEST(Csv, ColumnsThatAreNoInputsAreNotRead) {
    expect_samples(
        read_log("time [s],speed [km/h],throttle,road_temperature [degC],bulk_temperature [degC]\n"
                 "0,0,a,23,\n2,36,,24,nan\n5,54,1,25,x\n"));
}

TEST(Csv, TheRunLastsAsLongAsTheLogUnlessTheCaseSaysMore) {
    const std::string log = "time [s],speed [km/h]\n10,0\n20,36\n";
    const Reading plain = read_log(log);
    ASSERT_TRUE(plain.problem.has_value()) << error_report(plain);
    EXPECT_DOUBLE_EQ(plain.problem->settings.start, 10.0);
    EXPECT_DOUBLE_EQ(plain.problem->settings.end, 20.0);
    const Reading bounded = read_log(log, "[time]\nstart = \"12 s\"\nend = \"18 s\"\n");
    ASSERT_TRUE(bounded.problem.has_value()) << error_report(bounded);
    EXPECT_DOUBLE_EQ(bounded.problem->settings.start, 12.0);
    EXPECT_DOUBLE_EQ(bounded.problem->settings.end, 18.0);
}

// 200 000 lines of 10 columns, 10 MB: an hour at 50 Hz. Seconds would mean that something is quadratic.
TEST(Csv, ALongLogIsReadInLinearTime) {
    std::string log = "time [s],speed [km/h],a,b,c,d,e,f,g,h\n";
    for (int i = 0; i < 200'000; ++i) {
        log += std::to_string(i) + ",100,1.5,2.5,3.5,4.5,5.5,6.5,7.5,8.5\n";
    }
    const Reading reading = read_log(log);
    const solver::Series* speed = find(reading, "speed");
    ASSERT_NE(speed, nullptr);
    EXPECT_EQ(speed->time.size(), 200'000U);
}

// A log of 80 min, and an end of 60 min that stands in an included file: a quarter of the log is never driven.
TEST(Csv, ALogThatIsCutIsReported) {
    const std::string log = "time [s],speed [km/h]\n0,0\n4800,80\n";
    const Written written;
    written.add("logs/run.csv", log);
    std::string text(slab);
    text.erase(text.find("[time]"), std::string_view("[time]\nend = \"60 s\"\n").size());
    written.add("common.toml", text + "[time]\nend = \"3600 s\"\n");
    const std::string own = "include = [\"common.toml\"]\n[[drive.file]]\npath = \"logs/run.csv\"\n";
    const auto warning = [&](const std::string& file, const std::string& more) {
        const Reading reading = read_case(written.add(file, own + more));
        const auto found = std::ranges::find_if(
            reading.warnings, [](const std::string& line) { return line.find("[time]") != std::string::npos; });
        return found == reading.warnings.end() ? "" : *found;
    };
    const std::string cut = warning("case.toml", "");
    EXPECT_NE(cut.find("common.toml"), std::string::npos) << cut;
    EXPECT_NE(cut.find("[time] end cuts 20 min of 80 min off the end of the log"), std::string::npos) << cut;
    EXPECT_EQ(warning("whole.toml", "[time]\nend = \"4800 s\"\n"), "");
    const std::string late = warning("late.toml", "[time]\nstart = \"2400 s\"\nend = \"4800 s\"\n");
    EXPECT_NE(late.find("[time] start cuts 40 min of 80 min off the beginning of the log"), std::string::npos) << late;
}

// Held, the speed of a sample counts until the next; the jumps are break times.
TEST(Csv, AColumnCanHold) {
    const Reading reading = read_log("time [s],speed [km/h]\n0,0\n2,36\n5,54\n", "hold = [\"speed\"]\n");
    const solver::Series* speed = find(reading, "speed");
    ASSERT_NE(speed, nullptr);
    EXPECT_EQ(speed->time, (std::vector<double>{0, 2, 2, 5, 5}));
    EXPECT_NEAR(speed->at(4.9, solver::JumpSide::before), 10.0, 1e-12);
    EXPECT_EQ(reading.problem->input_signals.stops(), (std::vector<double>{2, 5}));
    EXPECT_FALSE(read_log("time [s],speed [km/h]\n0,0\n2,36\n", "hold = [\"sped\"]\n").problem.has_value());
}

TEST(Schedule, JumpsAtARepeatedTime) {
    const Written written;
    const Reading reading = read_case(written.add("case.toml", std::string(slab) + R"(
[[drive.schedule]]
columns = ["time [min]", "speed [km/h]", "wet"]
rows = [[0, 0, 0], [1, 36, 0], [1, 72, 1], [2, 72.0, 1]]
)"));
    const solver::Series* speed = find(reading, "speed");
    ASSERT_NE(speed, nullptr);
    EXPECT_FALSE(speed->logged);
    EXPECT_EQ(speed->time, (std::vector<double>{0.0, 60.0, 60.0, 120.0}));
    EXPECT_NEAR(speed->at(60.0, solver::JumpSide::before), 10.0, 1e-14);
    EXPECT_NEAR(speed->at(60.0, solver::JumpSide::after), 20.0, 1e-14);
    EXPECT_NEAR(speed->at(30.0, solver::JumpSide::after), 5.0, 1e-14);
    EXPECT_EQ(reading.problem->input_signals.stops(), (std::vector<double>{0.0, 60.0, 120.0}));
}

}  // namespace tiretherm::input
