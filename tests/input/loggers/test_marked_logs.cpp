// SPDX-License-Identifier: BSD-3-Clause
// Logs of TrackAddict, RaceCapture, Torque, Accessport and TunerStudio, made up after what their files look like.

#include <cmath>

#include <gtest/gtest.h>

#include "input/loggers/read_back.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;

}  // namespace

// Units that the headings leave out: seconds, degrees and g = 9.80665 m/s2; a phone's x goes across the car.
TEST(TrackAddict, HasTheUnitsThatItDoesNotWrite) {
    ReadBack file("Log.csv",
                  "# RaceRender Data: TrackAddict 4.8.1 on Android [Mode: 0]\n# Vehicle App ID: 0\n# Device: Phone 7\n"
                  "\"Time\",\"UTC Time\",\"Lap\",\"Predicted Lap "
                  "Time\",\"GPS_Update\",\"Latitude\",\"Longitude\",\"Speed (MPH)\","
                  "\"Heading\",\"Accel X\",\"Accel Y\",\"Brake (calculated)\",\"Vehicle Speed (km/h) *OBD\"\n"
                  "0.000,1725368701.000,0,0,1,51.2,-1.6,100,90,0.5,-0.25,0,160\n"
                  "0.050,1725368701.050,0,0,0,51.2,-1.6,100,90,0.5,-0.25,0,160\n# Lap 0: 00:01:23.456\n"
                  "0.100,1725368701.100,1,0,0,51.2,-1.6,100,90,1,0.5,0,161\n");
    EXPECT_EQ(file.file().description().format, "TrackAddict CSV");
    EXPECT_TRUE(file.file().heads()[0].is_clock);
    EXPECT_EQ(file.column("Time", "s", Purpose::clock), (Values{0.0, 0.05, 0.1}));
    EXPECT_EQ(file.column("Accel X (lateral)", "m s-2"), (Values{4.903325, 4.903325, 9.80665}));
    EXPECT_EQ(file.column("Accel Y (longitudinal)", "m s-2").back(), 4.903325);
    EXPECT_DOUBLE_EQ(file.column("Speed", "m s-1").front(), 44.704);
    EXPECT_DOUBLE_EQ(file.column("Vehicle Speed *OBD", "m s-1").back(), 161.0 / 3.6);
}

// Name, unit, range and rate between bars. Slower channels have empty fields.
TEST(RaceCapture, HasHeadingsBetweenBars) {
    ReadBack file(
        "rc.log",
        "\"Interval\"|\"ms\"|0|0|1,\"Utc\"|\"ms\"|0|0|1,\"AccelX\"|\"G\"|-3.0|3.0|25,\"Yaw\"|\"Deg/Sec\"|-120|120|25,"
        "\"Speed\"|\"MPH\"|0.0|150.0|10,\"TireTmpFL\"|\"C\"|0|200|10,\"LapCount\"|\"\"|0|0|10\n"
        "1000,1725368701000,0.5,180,100,60.5,1\n1040,1725368701040,0.25,90,,,\n1080,1725368701080,,,,61,1\n");
    EXPECT_EQ(file.file().description().format, "RaceCapture log");
    EXPECT_EQ(file.column("time", "s", Purpose::clock), (Values{1.0, 1.04, 1.08}));
    EXPECT_EQ(file.column("AccelX (lateral)", "m s-2").front(), 4.903325);
    EXPECT_NEAR(file.column("Yaw (rate)", "rad s-1").front(), 3.14159265358979, 1e-12);
    const Values speed = file.column("Speed", "m s-1");
    ASSERT_EQ(speed.size(), 3U);
    EXPECT_DOUBLE_EQ(speed[0], 44.704);
    EXPECT_TRUE(std::isnan(speed[1]));
    EXPECT_EQ(file.column("TireTmpFL", "K").back(), 334.15);
}

// Two clocks, of which the phone's has decimals; a dash where a sensor has no value; headings again after a pause.
TEST(Torque, TakesTheClockOfThePhone) {
    const std::string head =
        "GPS Time, Device Time, Longitude, Latitude,GPS Speed (Meters/second), Bearing, G(x),Speed (OBD)(km/h),Ambient "
        "air "
        "temp(\u00B0C)\n";
    ReadBack file("trackLog.csv",
                  head + "Tue Sep 03 14:05:01 GMT+02:00 2024,03-Sep-2024 14:05:01.250,-1.6,51.2,12.5,90,0.1,45,-\n" +
                      head +
                      "Tue Sep 03 14:05:02 GMT+02:00 2024,03-Sep-2024 14:05:02.500,-1.6,51.2,12.5,90,0.1,46,21\n");
    ASSERT_TRUE(file.is_open()) << file.messages();
    EXPECT_EQ(file.file().description().format, "Torque CSV");
    const int clock = file.file().find("Device Time");
    ASSERT_GE(clock, 0);
    EXPECT_TRUE(file.file().heads()[static_cast<std::size_t>(clock)].is_clock);
    EXPECT_EQ(file.column("Device Time", "s", Purpose::clock), (Values{0.0, 1.25}));
    EXPECT_EQ(file.column("GPS Time", "s", Purpose::clock), (Values{0.0, 1.0}));
    EXPECT_EQ(file.column("GPS Speed", "m s-1").front(), 12.5);
    EXPECT_EQ(file.column("Speed (OBD)", "m s-1").front(), 12.5);
    const Values air = file.column("Ambient air temp", "K");
    EXPECT_TRUE(std::isnan(air.front()));
    EXPECT_EQ(air.back(), 294.15);
}

// The device is no column, whether its heading is quoted or not, and whether rows end in a comma or not.
TEST(Accessport, LastHeadingIsTheDevice) {
    for (const auto& [device, end] : {std::pair{"AP Info:[AP3-SUB-004 v1.7.4.0][2015 WRX][Reflash: a, b]", ""},
                                      std::pair{"\"AP Info:[AP3-SUB-004 v1.7.4.0][2015 WRX]\"", ","}}) {
        ReadBack file("datalog1.csv", std::string("Time (sec),Vehicle Speed (mph),Boost (psi),") + device +
                                          "\n0,100,14.5" + end + "\n0.04,100,14.5" + end + "\n");
        EXPECT_EQ(file.column("Time", "s", Purpose::clock), (Values{0.0, 0.04})) << file.messages();
        EXPECT_EQ(file.file().heads().size(), 3U);
        EXPECT_DOUBLE_EQ(file.column("Vehicle Speed", "m s-1").front(), 44.704);
        ASSERT_EQ(file.file().description().details.size(), 1U);
        EXPECT_NE(file.file().description().details[0].value.find("AP3-SUB-004"), std::string::npos);
    }
}

// Two lines about the recording, tabs, units in a line of their own, a mark that the driver set.
TEST(TunerStudioMsl, HasUnitsInALineAndMarksBetween) {
    ReadBack file(
        "log.msl",
        "\"speeduino 202310\"\n\"Capture Date: Tue Sep 03 14:05:01 CEST 2024\"\nTime\tSecL\tRPM\tVSS\tCLT\tGear\n"
        "s\tsec\tRPM\tkm/h\t\u00B0C\t\n0.0\t10\t3000\t36\t80\t2\nMARK 001 - Manual - Tue Sep 03 14:05:02\n"
        "0.066\t10\t3000\t72\t81\t2\n");
    EXPECT_EQ(file.file().description().format, "TunerStudio .msl");
    EXPECT_EQ(file.column("Time", "s", Purpose::clock), (Values{0.0, 0.066}));
    EXPECT_EQ(file.column("VSS", "m s-1"), (Values{10.0, 20.0}));
    EXPECT_EQ(file.column("CLT", "K"), (Values{353.15, 354.15}));
}

// What is not read names the program that exports it, by its ending or by its first bytes.
TEST(UnreadLog, NamesTheProgramThatExportsIt) {
    for (const auto& [name, bytes, remedy] :
         {std::tuple{"run.xrk", std::string("<hCNF\0\0", 7), "export it as CSV in AiM RaceStudio 3"},
          std::tuple{"run.bin", std::string("<hCNF\0\0", 7), "export it as CSV in AiM RaceStudio 3"},
          std::tuple{"lap.bmsbin", std::string("\1\0\2\0", 4), "export it as CSV in WinDarab"},
          std::tuple{"VBOX_001.dbn", std::string("\1\0\2\0", 4), "export it as .vbo or CSV in the tools of the device"},
          std::tuple{"log.mlg", std::string("MLVLG\0\0", 7),
                     "export it as .msl or CSV in TunerStudio or MegaLogViewer"},
          std::tuple{"run.ldx", std::string("<?xml version=\"1.0\"?>"), "name the .ld file beside it"}}) {
        ReadBack file(name, bytes);
        EXPECT_FALSE(file.is_open());
        EXPECT_NE(file.messages().find(std::string("which is not read | ") + remedy), std::string::npos)
            << file.messages();
    }
}

}  // namespace tiretherm::input
