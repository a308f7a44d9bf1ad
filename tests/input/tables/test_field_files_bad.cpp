// SPDX-License-Identifier: BSD-3-Clause
// Files of a structural code that are wrong: what is refused, with which words, where, and what to do.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "input/effects/field_bench.hpp"
#include "post/fields/hdf5_file.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using namespace field_bench;

}  // namespace

TEST(BadFieldFile, ThatIsEmptyMissingOrCut) {
    expect_said(said(friction, ""), {"field.csv"});
    expect_said(said("[effects.sliding_friction]\nfield = \"feld.csv\"\n", "y [mm]\n"),
                {"the file feld.csv cannot be read: No such file or directory", "did you mean `field.csv`?"});
    expect_said(said(friction, "y [mm],friction_power [W/m2]\n"), {"the file has headings but no numbers"});
    // A row too short, and a frame that lost its last points.
    expect_said(said(friction, "y [mm],friction_power [W/m2]\n-50,1\n0\n"),
                {"field.csv:3:1: the line has 1 values, the first line names 2 columns"});
    expect_said(said(friction, "time [s],y [mm],friction_power [W/m2]\n0,-50,1\n0,50,1\n1,-50,1\n"),
                {"field.csv:4:1: this frame has 1 points, the first has 2", "the file may be cut off"});
}

// Several things at once, each with its place and its remedy.
TEST(BadFieldFile, ReportsAllItsErrorsAtOnce) {
    expect_said(
        said(friction, "y [s],presure [kPa],pressure [kPa],sliding_velocity\n-50,1,-3,1\n0,1,nan,x\n"),
        {"field.csv:1:1: the column y is in [s]", "write \"y [mm]\"",
         "field.csv:1:7: a field has no column \"presure\"", "did you mean `pressure`?",
         "field.csv:2:7: pressure is -3 kPa", "field.csv:3:5: pressure is missing",
         "give every point of every frame a value, 0 where nothing is", "the column sliding_velocity has no unit",
         "write \"sliding_velocity [m/s]\"", "field.csv:3:9: sliding_velocity is \"x\"; a number is wanted"});
}

// A separator behind the last column is no column; an empty heading between others is one that nobody knows.
TEST(BadFieldFile, ASeparatorAtTheEndOfTheLineIsNoColumn) {
    const std::string negative = said(friction, "y [mm],friction_power [W/m2],\n-50,-1,\n50,1,\n");
    expect_said(negative, {"field.csv:2:5: friction_power is -1 W/m2; it must be between 0"});
    EXPECT_EQ(negative.find("heading"), std::string::npos) << negative;
    EXPECT_EQ(negative.find("column"), std::string::npos) << negative;
    expect_said(said(friction, "y [mm],,friction_power [W/m2]\n-50,1,1\n50,1,1\n"),
                {"field.csv:1:8: heading 2 is empty", "name the column, or remove it"});
}

TEST(BadFieldFile, LacksWhatTheEffectNeeds) {
    expect_said(said(friction, "y [mm],pressure [kPa]\n0,1\n"),
                {"field.csv: the field has no column sliding_velocity", "write \"sliding_velocity [m/s]\""});
    expect_said(said(friction_watts, "y [mm],pressure [kPa],sliding_velocity [m/s]\n0,1,1\n"),
                {"the field gives no power of friction", "with use = \"shape\" pressure and sliding_velocity do"});
    expect_said(said(loss, "y [mm],pressure [kPa]\n0,1\n"), {"the field has no column loss_density"});
    expect_said(said(friction, "friction_power [W/m2]\n1\n"), {"a column y or cell is required"});
    expect_said(said(friction, "x [mm],y [mm],friction_power [W/m2]\n0,0,1\n0,5,1\n"),
                {"some y has one x only", "add area [mm2]"});
    expect_said(said(loss, "x [mm],y [mm],loss_density [W/m3]\n0,0,1\n0,5,1\n"),
                {"loss_density turns with the tire: x is no place of it"});
}

TEST(BadFieldFile, GoesBackwardsOrNotAllTheWayRound) {
    expect_said(said(friction, "time [s],y [mm],friction_power [W/m2]\n0,0,1\n2,0,1\n1,0,1\n"),
                {"field.csv:4:1: time goes backwards to 1 s", "write the frames in ascending order"});
    expect_said(said(friction, "wheel_angle [deg],y [mm],friction_power [W/m2]\n0,0,1\n90,0,1\n180,0,1\n"),
                {"field.csv:1:1: wheel_angle goes from 0 to 180 deg, which is not a whole revolution"});
    expect_said(said(friction, "wheel_angle [deg],y [mm],friction_power [W/m2]\n0,0,1\n400,0,1\n"),
                {"which is not a whole revolution"});
    expect_said(said(friction, "time [s],wheel_angle [deg],y [mm],friction_power [W/m2]\n0,0,0,1\n"),
                {"against time or against the wheel angle, not both"});
}

// Seven points beside the tread of 225 mm: five are shown, the others counted.
TEST(BadFieldFile, LiesBesideTheTire) {
    const std::string text =
        said(friction, "y [mm],friction_power [W/m2]\n0,1\n120,1\n121,1\n122,1\n123,1\n124,1\n125,1\n126,1\n");
    expect_said(text, {"field.csv:3:1: y is 120 mm, beyond the tread, which reaches from -112.5 to 112.5 mm",
                       "leave the point out, or correct the origin or the sign of its coordinates",
                       "field.csv: and 2 more like this"});
    expect_said(said(loss, "y [mm],depth [mm],loss_density [W/m3]\n0,2,1\n0,200,1\n"),
                {"field.csv:3:1: depth is 200 mm at y = 0 mm"});
    expect_said(said(loss, "cell,loss_density [W/m3]\n0,1\n1e6,1\n0.5,1\n"), {"cell is 0.5; a whole number is wanted"});
    expect_said(said(loss, "cell,loss_density [W/m3]\n0,1\n1e6,1\n"), {"cell 1000000 is none of the mesh's"});
}

TEST(BadFieldFile, HasRivalsOrNoShape) {
    const std::string even = "y [mm],friction_power [W/m2]\n0,1\n";
    expect_said(said(friction + "profile = { columns = [\"s [mm]\", \"w [-]\"], rows = [[-10, 1], [10, 1]] }\n", even),
                {"sliding_friction has a profile and a field"});
    expect_said(said(friction, "y [mm],friction_power [W/m2]\n0,0\n"), {"is zero everywhere: it gives no shape"});
    expect_said(said(friction, "time [s],y [mm],friction_power [W/m2]\n0,0,1\n1,0,0\n"),
                {"field.csv:3:1: field.csv is zero everywhere in this frame"});
    expect_said(said("[effects.sliding_friction]\nuse = \"watts\"\n", ""), {"use needs a field, and there is none"});
    expect_said(said(friction + "use = \"wats\"\n", even), {"did you mean `watts`?"});
    expect_said(
        said("[effects.road_contact]\nfield = \"field.csv\"\n", "time [s],y [mm],pressure [kPa]\n0,0,1\n1,0,1\n"),
        {"road_contact cannot follow a field against time"});
    expect_said(said("[effects.road_contact]\nuse = \"shape\"\n", even),
                {"\"use\" is not a key of [effects.road_contact]"});
    expect_said(said(loss + "belt_edge_gain = 0.5\n", "y [mm],loss_density [W/m3]\n0,1\n"),
                {"the field replaces the weights of layers, zones and belt edges"});
}

// HDF5: a dataset is missing, another is too short, one has no unit, and a file is cut in half.
TEST(BadFieldFile, OfHdf5NamesTheDataset) {
    const Written written;
    const std::string tables = "[effects.sliding_friction]\nfield = \"field.h5\"\n";
    const fs::path file = written.folder() / "field.h5";
    const auto complain = [&](const std::function<void(post::Hdf5File&)>& write) {
        fs::remove(file);
        {
            post::Hdf5File hdf5(file);
            write(hdf5);
        }
        return render(read_case(written.add("case.toml", cornering(tables))));
    };
    const auto add = [](post::Hdf5File& hdf5, const std::string& path, const Values& values, const std::string& units) {
        hdf5.write(path, values, 0, {.units = units, .long_name = "", .source = "", .coordinates = ""});
    };
    expect_said(complain([&](post::Hdf5File& h) {
                    add(h, "/y", {-0.05, 0.05}, "m");
                    add(h, "/sliding_velocity", {1, 2}, "m/s");
                }),
                {"field.h5: the field has no dataset pressure", "give the dataset an attribute units = \"kPa\""});
    expect_said(complain([&](post::Hdf5File& h) {
                    add(h, "/y", {-0.05, 0.05}, "m");
                    add(h, "/friction_power", {1, 2, 3}, "W/m2");
                }),
                {"values"});
    expect_said(complain([&](post::Hdf5File& h) {
                    add(h, "/y", {-0.05, 0.05}, "m");
                    add(h, "/friction_power", {1, std::nan("")}, "W/m2");
                }),
                {"friction_power is missing (value 2)"});
    expect_said(complain([&](post::Hdf5File& h) {
                    add(h, "/y", {-0.05, 0.5}, "m");
                    add(h, "/friction_power", {1, 1}, "W/m2");
                }),
                {"y is 500 mm, beyond the tread", "(value 2)"});
    fs::resize_file(file, fs::file_size(file) / 2);
    expect_said(render(read_case(written.add("case.toml", cornering(tables)))),
                {"is HDF5, but cannot be opened: it is cut off, damaged or still being written"});
}

}  // namespace tiretherm::input
