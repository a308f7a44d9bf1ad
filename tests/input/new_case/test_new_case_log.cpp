// SPDX-License-Identifier: BSD-3-Clause
// A case from a log: standard columns are used, odd ones are suggested, wrong ones are reported with their line.
#include "input/new_case/made.hpp"
#include "input/runs/read_experiment.hpp"
#include "post/fields/hdf5_file.hpp"

namespace tiretherm::input {
namespace {

constexpr double zero_of_log = 273.15;

/// A minute in standard names; the tire starts warm.
constexpr std::string_view standard_log =
    "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],throttle [%],"
    "surface_temperature [degC],bulk_temperature [degC],gas_temperature [degC]\n"
    "0,36,4000,21,30,10,,45.5,40\n"
    "20,54,4100,22,30,20,35.5,45.8,40\n"
    "40,72,4200,23,31,35,36.0,46.1,41\n"
    "60,72,4200,24,31,40,36.3,46.6,41\n";

/// What nobody prepared: lines of the logger above the names, units of its own, capitals, a column of words.
constexpr std::string_view odd_log =
    "Logger,RaceBox 7\n"
    "Session,Friday\n"
    "\n"
    "Time,Ground Speed,Fz_FL,Tyre Temp Surf,Amb,Lap,Tyre Press FL\n"
    "s,kmh,kN,C,degF,,bar\n"
    "0,0,4.0,25.0,77,out,2.1\n"
    "10,90,4.1,30.0,77,out,2.1\n"
    "20,90,4.2,33.0,77,1,2.2\n"
    "30,90,4.2,35.0,77,1,2.2\n";

/// The text with the # taken away from the lines that offer it, one of each key.
std::string confirmed(const std::string& text) {
    std::string result;
    for (const std::string& line : lines_of(text)) {
        const bool heading = line.starts_with("# [[run]]") || line.starts_with("# [run.");
        const bool offered = line.find("Then take the # away") != std::string::npos ||
                             line.find("or what its unit is") != std::string::npos || line.starts_with("# file = ") ||
                             (line.starts_with("# Time = ") || line.starts_with("# Speed = "));
        result += (heading || offered ? line.substr(2) : line) + "\n";
    }
    return result;
}

TEST(NewCaseLog, StandardColumnsDriveAndAreCompared) {
    const Written written;
    written.add("drive.csv", standard_log);
    const NewCase made = make(written, "235/45 R17", "section", "drive.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_TRUE(made.missing.empty());
    EXPECT_EQ(made.log->use, LogUse::run);
    EXPECT_TRUE(column_of(made, "speed").is_input);
    EXPECT_TRUE(column_of(made, "bulk_temperature").is_sensor);
    EXPECT_FALSE(column_of(made, "throttle").is_used());
    EXPECT_EQ(made.assumed.size(), 2U);  // laws of the tire, conductivities

    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    const MeasuredRun& run = reading.experiment->runs.at(0);
    EXPECT_EQ(run.time, (std::vector<double>{0, 20, 40, 60}));
    ASSERT_EQ(run.series.size(), 3U);
    EXPECT_NEAR(run.problem.input_signals.at(10.0, solver::JumpSide::after).speed, 12.5, 1e-12);
    EXPECT_EQ(reading.experiment->parameters.size(), 3U);
}

// First values: surface 35.5 (after a gap), bulk 45.5, gas 40 degC; the tread has their mean, 40.5.
TEST(NewCaseLog, TireStartsWhereItsSensorsDo) {
    const Written written;
    written.add("drive.csv", standard_log);
    for (const auto& [mesh, outer] :
         {std::pair("section", 40.5), std::pair("layers", 35.5), std::pair("two_node", 35.5)}) {
        const NewCase made = make(written, "225/50 R17", mesh, "drive.csv");
        const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
        ASSERT_TRUE(reading.experiment.has_value()) << errors_of(made, written);
        const solver::Problem& problem = reading.experiment->runs.at(0).problem;
        const mesh::Mesh& cells = problem.mesh;
        for (int node = 0; node < cells.n_nodes; ++node) {
            const auto i = static_cast<std::size_t>(node);
            if (cells.layer[i] >= 0) {
                EXPECT_NEAR(problem.initial[i], zero_of_log + (cells.layer[i] == 0 ? outer : 45.5), 1e-9)
                    << mesh << node;
            }
        }
        for (const mesh::LumpedNode& lumped : cells.lumped_nodes) {
            const double expected = lumped.name == "gas" ? 40.0 : 21.0;  // the rim stands in the air
            EXPECT_NEAR(problem.initial[static_cast<std::size_t>(lumped.node)], zero_of_log + expected, 1e-9)
                << lumped.name;
        }
    }
}

// Names without regard to capitals and blanks, time in seconds unless it says otherwise. KPH and C of a temperature are read as
// they are: the case need not say what they mean.
TEST(NewCaseLog, SpellingOfNamesAndUnitsIsForgiven) {
    const Written written;
    written.add(
        "drive.csv",
        "Time,Speed [KPH],Vertical Load [N],Bulk-Temperature [C]\n0,50,4000,30\n10,50,4000,31\n20,50,4000,32\n");
    const NewCase made = make(written, "225/50 R17", "two_node", "drive.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(column_of(made, "Time").unit, "s");
    EXPECT_EQ(column_of(made, "Speed").unit, "");
    EXPECT_EQ(column_of(made, "Vertical Load").unit, "");
    EXPECT_EQ(column_of(made, "Bulk-Temperature").unit, "");
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    const MeasuredRun& run = reading.experiment->runs.at(0);
    EXPECT_NEAR(run.series.at(0).value.at(0), zero_of_log + 30.0, 1e-9);
    EXPECT_NEAR(run.problem.input_signals.at(5.0, solver::JumpSide::after).speed, 50.0 / 3.6, 1e-12);
}

// The log says neither load, air nor road: constants, each with its reason; the road as the air where that is known.
TEST(NewCaseLog, InputsThatTheLogLacksAreConstants) {
    const Written written;
    written.add("drive.csv", "time [s],air_temperature [degC],bulk_temperature [degC]\n0,10,30\n10,12,31\n20,14,32\n");
    const NewCase made = make(written, "225/50 R17", "two_node", "drive.csv");
    std::vector<std::string> assumed;
    for (const AssumedValue& value : made.assumed) {
        assumed.push_back(value.key + " " + value.value);
        EXPECT_NE(value.reason.find("the log does not give it"), std::string::npos) << value.key;
    }
    EXPECT_EQ(assumed, (std::vector<std::string>{"drive.vertical_load 4000 N", "drive.speed 100 km/h",
                                                 "drive.road_temperature 12 degC"}));
    const Reading reading = read_case(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(reading.problem->input_signals.at(5.0, solver::JumpSide::after).road_temperature, zero_of_log + 12.0,
                1e-9);
}

TEST(NewCaseLog, OddLogRunsAtOnceAndIsComparedOnceItsColumnsAreConfirmed) {
    const Written written;
    written.add("odd.csv", odd_log);
    const NewCase made = make(written, "225/50 R17", "section", "odd.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.log->use, LogUse::nothing);
    EXPECT_EQ(column_of(made, "Time").name, "time");
    EXPECT_EQ(column_of(made, "Ground Speed").suggestion, "speed");
    EXPECT_EQ(column_of(made, "Ground Speed").suggested_unit, "");
    EXPECT_EQ(column_of(made, "Fz_FL").suggestion, "vertical_load");
    EXPECT_EQ(column_of(made, "Tyre Temp Surf").suggestion, "surface_temperature");
    EXPECT_EQ(column_of(made, "Tyre Temp Surf").suggested_unit, "");
    EXPECT_EQ(column_of(made, "Amb").suggestion, "air_temperature");
    EXPECT_EQ(column_of(made, "Tyre Press FL").suggestion, "inflation_pressure");
    EXPECT_EQ(column_of(made, "Lap").suggestion, "");
    ASSERT_EQ(made.missing.size(), 1U);
    EXPECT_NE(made.missing[0].remedy.find("[run.columns]"), std::string::npos);

    const Reading at_once = read_case(written.add("case.toml", made.text));
    ASSERT_TRUE(at_once.problem) << render(at_once);
    EXPECT_EQ(at_once.problem->settings.end, 30.0);

    const ExperimentReading reading = read_experiment(written.add("case.toml", confirmed(made.text)));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front()) << confirmed(made.text);
    const MeasuredRun& run = reading.experiment->runs.at(0);
    ASSERT_EQ(run.series.size(), 1U);
    EXPECT_NEAR(run.series[0].value[1], zero_of_log + 30.0, 1e-9);
    const physics::Inputs inputs = run.problem.input_signals.at(30.0, solver::JumpSide::before);
    EXPECT_NEAR(inputs.speed, 25.0, 1e-12);
    EXPECT_NEAR(inputs.vertical_load, 4200.0, 1e-9);
    EXPECT_NEAR(inputs.air_temperature, zero_of_log + 25.0, 1e-9);
}

// Inputs alone drive the tire; a column that is missing for too long or without a unit is left to a constant.
TEST(NewCaseLog, InputsAloneDriveTheTire) {
    const Written written;
    written.add("drive.csv",
                "time [s],Speed [km/h],vertical_load,air_temperature [degC],road_temperature [degC]\n"
                "0,36,4000,20,\n10,72,4000,20,25\n20,72,4000,20,25\n");
    const NewCase made = make(written, "225/50 R17", "two_node", "drive.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.log->use, LogUse::drive);
    EXPECT_EQ(column_of(made, "vertical_load").reason, "the column vertical_load has no unit");
    EXPECT_EQ(column_of(made, "road_temperature").reason, "road_temperature is missing in 1 of 3 samples");
    const Reading reading = read_case(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.problem) << render(reading);
    const physics::Inputs inputs = reading.problem->input_signals.at(5.0, solver::JumpSide::after);
    EXPECT_NEAR(inputs.speed, 15.0, 1e-12);
    EXPECT_NEAR(inputs.vertical_load, 4000.0, 1e-9);
    EXPECT_NEAR(inputs.road_temperature, zero_of_log + 20.0, 1e-9);
    EXPECT_EQ(reading.problem->settings.end, 20.0);
    std::vector<std::string> missing;
    for (const MissingPart& part : made.missing) {
        missing.push_back(part.what);
    }
    EXPECT_EQ(missing, (std::vector<std::string>{
                           "vertical_load is not used: the column vertical_load has no unit",
                           "road_temperature [degC] is not used: road_temperature is missing in 1 of 3 samples",
                           "nothing to compare with: no column is known to be a sensor's"}));
}

TEST(NewCaseLog, SensorsOfOneSideAndForcesHaveTheirPlace) {
    const Written written;
    written.add("drive.csv",
                "time [s],speed [km/h],crown_surface_temperature [degC],inside_shoulder_inner_liner_temperature [degC],"
                "drag_force [N],loaded_radius [mm]\n0,80,30,31,40,315\n10,80,31,32,41,315\n");
    const NewCase section = make(written, "225/50 R17", "section", "drive.csv");
    ASSERT_TRUE(section.errors.empty()) << errors_of(section, written);
    const ExperimentReading reading = read_experiment(written.add("case.toml", section.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    EXPECT_EQ(reading.experiment->runs.at(0).series.size(), 4U);
    const NewCase two_node = make(written, "225/50 R17", "two_node", "drive.csv");
    EXPECT_EQ(column_of(two_node, "crown_surface_temperature").reason,
              "the mesh two_node cannot represent it, --mesh section can");
    EXPECT_TRUE(column_of(two_node, "drag_force").is_sensor);
}

TEST(NewCaseLog, Hdf5LogIsReadAsCsv) {
    const Written written;
    {
        post::Hdf5File file(written.folder() / "run.h5");
        const auto add = [&](const std::string& name, const std::vector<double>& values, const std::string& unit) {
            file.write(name, values, 0, {.units = unit, .long_name = "", .source = "", .coordinates = ""});
        };
        add("/time", {0, 10, 20}, "s");
        add("/speed", {10, 10, 20}, "m/s");
        add("/bulk_temperature", {300, 301, 302}, "K");
    }
    const NewCase made = make(written, "225/50 R17", "two_node", "run.h5");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    EXPECT_EQ(reading.experiment->runs.at(0).series.at(0).value, (std::vector<double>{300, 301, 302}));
}

TEST(NewCaseLog, MistakesOfTheLogAreAllReportedWithTheirLines) {
    const Written written;
    written.add("wrong.csv",
                "time [s],speed [km/h],bulk_temperature "
                "[degC]\n0,abc,30\n10,90,warm\n5,90,31\n20,900000,31\n30,90\n40,90,32\n");
    const NewCase made = make(written, "225/50 R17", "section", "wrong.csv");
    EXPECT_EQ(made.text, "");
    std::vector<int> lines;
    for (const InputError& error : made.errors) {
        EXPECT_TRUE(error.file.ends_with("wrong.csv")) << error.file;
        lines.push_back(error.line);
    }
    EXPECT_EQ(lines, (std::vector<int>{2, 3, 4, 5, 6})) << errors_of(made, written);
}

TEST(NewCaseLog, LogWithoutTimeTwiceTheSameNameOrASingleSampleIsRefused) {
    const Written written;
    written.add("timeless.csv", "speed [km/h],bulk_temperature [degC]\n90,30\n90,31\n");
    EXPECT_EQ(errors_of(make(written, "225/50 R17", "section", "timeless.csv"), written),
              "timeless.csv:1:1: no column of the file is the time\n"
              "    speed [km/h],bulk_temperature [degC]\n"
              "    ^~~~~~~~~~~~\n"
              "    remedy: call one time [s], as in time [s],speed [km/h]\n");
    written.add("twice.csv", "time [s],speed [km/h],speed [m/s]\n0,90,25\n10,90,25\n");
    EXPECT_EQ(errors_of(make(written, "225/50 R17", "section", "twice.csv"), written),
              "twice.csv:1:23: two columns are called speed\n"
              "    time [s],speed [km/h],speed [m/s]\n"
              "                          ^~~~~~~~~~~\n"
              "    remedy: rename one in the file\n");
    written.add("short.csv", "time [s],speed [km/h]\n0,90\n");
    EXPECT_EQ(errors_of(make(written, "225/50 R17", "section", "short.csv"), written),
              "short.csv: the file has a single sample: a run goes from one time to another\n");
    EXPECT_NE(errors_of(make(written, "225/50 R17", "section", "absent.csv"), written).find("cannot be read"),
              std::string::npos);
}

// Headings may hold anything; a case must stay TOML.
TEST(NewCaseLog, HeadingsOfAnyBytesDoNoHarm) {
    const Written written;
    written.add("bytes.csv", std::string("time [s];T \"inner\\outer\" [degC];T\xE4t [\xB0"
                                         "C];\xE2\x82\xAC [-];Bulk Temperature [\xB0"
                                         "C]\n0;30;30;1;30\n10;31;31;1;31\n"));
    const NewCase made = make(written, "225/50 R17", "two_node", "bytes.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_TRUE(column_of(made, "Bulk Temperature").is_sensor);
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    EXPECT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
}

}  // namespace
}  // namespace tiretherm::input
