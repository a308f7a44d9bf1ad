// SPDX-License-Identifier: BSD-3-Clause
// A case is written by the descriptions of its keys.
#include <stdexcept>

#include "input/case_text/case_parts.hpp"
#include "input/case_text/case_writer.hpp"
#include "input/new_case/drum_tests.hpp"
#include "input/new_case/made.hpp"
#include "input/schema/all_tables.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {
namespace {

/// Every entry of a table whose keys are described has its description. @returns how many there are
int expect_described_entries(const std::string& text) {
    int n = 0;
    for (const CasePart& part : cut_case(text)) {
        const TableKeys* keys = keys_of_table(part.table);
        for (const std::string& line : part.lines) {
            const std::size_t end = line.find(" = ");
            const bool is_entry = end != std::string::npos && line.front() != '#' && line.front() != ' ';
            if (is_entry && keys != nullptr && !keys->has_names) {
                EXPECT_NE(keys->find(line.substr(0, end)), nullptr) << part.table << ": " << line;
                ++n;
            }
        }
    }
    return n;
}

// A size on each mesh, each test on a drum, a log that drives, one that is compared, one of a car and one of a laser. A case has
// at least a title, its sources, two keys of [time] and two of a sensor.
TEST(CaseWriter, EveryEntryOfANewCaseIsADescribedKey) {
    const Written written;
    std::vector<NewCase> all;
    for (const char* mesh : {"section", "layers", "two_node"}) {
        all.push_back(make(written, "225/50 R17", mesh));
    }
    for (const std::string_view test : drum_test_names()) {
        NewCaseRequest request{.size = std::get<TireSize>(read_tire_size("225/50 R17 94V")),
                               .target = written.folder() / "case.toml"};
        request.test = std::get<DrumTest>(drum_test(test, request.size));
        all.push_back(make_new_case(request));
    }
    written.add("drive.csv", "time [s],speed [km/h]\n0,80\n10,90\n");
    written.add("run.csv", "time [s],speed [km/h],T surf [degC],bulk_temperature [degC]\n0,80,30,30\n10,90,31,30\n");
    written.add(
        "car.csv",
        "Time [s],GPS Speed [km/h],LatAcc [g],Tire Temp FL [C],Tire Temp RR [C]\n0,80,0.1,30,31\n1,81,0.3,30,31\n"
        "2,82,-0.2,30.5,31\n");
    written.add("laser.csv", "time [s],P laser [W],spot_temperature [degC]\n0,1,30\n10,1,31\n");
    for (const char* log : {"drive.csv", "run.csv", "car.csv", "laser.csv"}) {
        all.push_back(make(written, "225/50 R17", "", log));
    }
    for (const NewCase& made : all) {
        EXPECT_TRUE(made.errors.empty()) << errors_of(made, written);
        EXPECT_GE(expect_described_entries(made.text), 6) << made.text;
    }
}

// So that a key that is renamed cannot stay behind in what writes cases: tables, keys, words and parameters of effects.
TEST(CaseWriter, RefusesWhatNoDescriptionHas) {
    CaseWriter writer;
    EXPECT_THROW(writer.table("tyre"), std::logic_error);
    EXPECT_THROW(writer.table("run.colums"), std::logic_error);
    writer.table("time");
    EXPECT_THROW(writer.entry("ende", "10 s"), std::logic_error);
    EXPECT_THROW(writer.suggestion("ende", "10 s"), std::logic_error);
    EXPECT_THROW(writer.entry("method", "euler"), std::logic_error);
    writer.table("effects.air_convection");
    EXPECT_THROW(writer.entry("lambda", "1"), std::logic_error);
    EXPECT_THROW(writer.document(toml_text::table_value({{"drive", toml_text::table_value()}, {"speeed", {}}})),
                 std::logic_error);
}

// Text, choice and a quantity with a unit stand in quotation marks; a pure number, a list and a flag do not. The meaning is the
// first sentence of the description, and is told once.
TEST(CaseWriter, FormAndMeaningAreThoseOfTheDescription) {
    CaseWriter writer;
    for (int i = 0; i < 2; ++i) {
        writer.table("vehicle");
        writer.entry("mass", "1350 kg");
        writer.entry("front_brake_share", "0.65");
        writer.suggestion("air_density", "1.1 kg/m3", "thin air");
    }
    EXPECT_EQ(writer.text(),
              "[vehicle]\n"
              "mass = \"1350 kg\"                    # of the car as it was driven, with driver and fuel\n"
              "front_brake_share = 0.65            # share of the front axle in the braking force\n"
              "# air_density = \"1.1 kg/m3\"         # thin air\n"
              "\n"
              "[vehicle]\n"
              "mass = \"1350 kg\"\n"
              "front_brake_share = 0.65\n"
              "# air_density = \"1.1 kg/m3\"         # thin air\n");
}

}  // namespace
}  // namespace tiretherm::input
