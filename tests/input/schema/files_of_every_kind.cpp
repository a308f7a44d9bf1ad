// SPDX-License-Identifier: BSD-3-Clause
// Made-up cases, a study and a table of measured numbers with every kind of mesh, sensor and parameter once.
#include "input/schema/files_of_every_kind.hpp"

namespace tiretherm::input {

namespace made_up {

constexpr std::string_view two_node = R"(
[tire]
size = "225/50 R17"
[mesh]
kind = "two_node"
surface_mass_share = 0.15
bulk_depth = "10 mm"
material = "rubber"
link_conductivity = { at = "20 degC", value = "0.29 W/mK" }
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = { through = [["20 degC", "1800 J/kgK"], ["90 degC", "1900 J/kgK"]] }
conductivity = { columns = ["temperature [degC]", "k [W/mK]"], rows = [[20, 0.29], [90, 0.95]] }
[[material]]
name = "belt"
[material.cord_rubber]
rubber = "rubber"
cord_diameter = "0.4 mm"
ends = "800 1/m"
thickness = "1 mm"
angle = "22 deg"
cord_conductivity = "50 W/mK"
cord_density = "7850 kg/m3"
cord_heat_capacity = "470 J/kgK"
[[material]]
name = "carcass"
density = "1200 kg/m3"
heat_capacity = "1600 J/kgK"
[material.cord_rubber]
rubber = "rubber"
cord_diameter = "0.4 mm"
ends = "800 1/m"
thickness = "1 mm"
angle = "90 deg"
cord_conductivity = "1 W/mK"
cord_modulus = "10 GPa"
cord_poisson = 0.4
rubber_modulus = "10 MPa"
rubber_poisson = 0.5
[drive]
vertical_load = "4000 N"
speed = "100 km/h"
air_temperature = "23 degC"
road_temperature = "23 degC"
[initial]
temperature = "23 degC"
[time]
end = "3600 s"
[[sensor]]
name = "bulk_temperature"
kind = "region"
region = "bulk"
)";

constexpr std::string_view section = R"(
include = ["two_node.toml"]
[mesh]
kind = "section"
crown_cells = 4
shoulder_cells = 2
sidewall_cells = 2
sectors = 1
[[mesh.layer]]
name = "tread"
thickness = "12 mm"
cells = 4
material = "rubber"
[effects.inner_gas]
[effects.rim_conduction]
[effects.pressure_across_tread]
[effects.resolved_contact]
[effects.road_contact]
on = false
[effects.layer_conductivity]
layers = ["tread"]
[effects.sensor_offset]
channels = ["point"]
[effects.strain_energy_loss]
total = "drum.csv"
field = "loss.h5"
use = "watts"
[limits]
cells = 1e6
rows = 1e6
steps = 1e6
output = "1 GB"
memory = "1 GB"
[drive]
inflation_pressure = "2.2 bar"
slip_angle = "1 deg"
slip_ratio = 0.0
wheel_angle = "0 deg"
[[drive.schedule]]
columns = ["time [s]", "camber [deg]"]
rows = [[0, 0], [10, 1]]
[[drive.file]]
path = "log.csv"
[[sensor]]
name = "point"
kind = "point"
depth = "10 mm"
[[instrument]]
name = "amplifier"
sensors = ["point", "strip"]
[[sensor]]
name = "strip"
kind = "strip"
from = "-10 mm"
to = "10 mm"
[[sensor]]
name = "strips"
kind = "strips"
from = "-10 mm"
to = "10 mm"
count = 2
[[sensor]]
name = "patch"
kind = "patch"
patch = "outside"
[[sensor]]
name = "layer"
kind = "layer"
layer = "tread"
[[sensor]]
name = "zone"
kind = "zone"
zone = "crown"
[[sensor]]
name = "node"
kind = "node"
node = "gas"
[[sensor]]
name = "drag"
kind = "drag_force"
[[sensor]]
name = "moment"
kind = "rolling_moment"
[[sensor]]
name = "loaded"
kind = "loaded_radius"
[[sensor]]
name = "pressure"
kind = "gas_pressure"
[[sensor]]
name = "entry"
kind = "surface_at_entry"
[[sensor]]
name = "exit"
kind = "surface_at_exit"
[[sensor]]
name = "outside_contact"
kind = "contact_pressure_outside"
[[sensor]]
name = "middle_contact"
kind = "contact_pressure_middle"
[[sensor]]
name = "inside_contact"
kind = "contact_pressure_inside"
[[sensor]]
name = "stiffness"
kind = "cornering_stiffness"
[[sensor]]
name = "factor"
kind = "bulk_temperature_factor"
[[sensor]]
name = "lateral"
kind = "lateral_force"
[[sensor]]
name = "reference"
kind = "reference_lateral_force"
[[sensor]]
name = "longitudinal"
kind = "longitudinal_force"
[[measured]]
channel = "point"
range = ["50 degC", "60 degC"]
[[source]]
name = "own"
follows = "speed"
at = "surface"
watts = "37 W"
[[exchange]]
name = "other"
at = "surface"
conductance = "5 W/K"
temperature = "30 degC"
[[parameter]]
effect = "air_convection"
key = "lambda_h"
[[parameter]]
effect = "air_convection"
key = "lambda_h"
patch = "outside"
[[parameter]]
effect = "sensor_offset"
key = "kelvin"
channel = "point"
[[parameter]]
source = "own"
[[parameter]]
exchange = "other"
[[parameter]]
material = "rubber"
law = "conductivity"
at = ["40 degC"]
[[parameter]]
initial = "temperature"
[[critical]]
name = "belt"
temperature = "110 degC"
[[uncertain]]
key = "drive.speed"
standard_deviation = "1 km/h"
)";

constexpr std::string_view coastdown = R"(
include = ["two_node.toml"]
[effects.strain_energy_loss]
coastdown = { alpha = -0.4, beta = 0.9, a = 0.1, b = 0, c = 0 }
[drive]
inflation_pressure = "2.2 bar"
slip_speed = "1 m/s"
)";

constexpr std::string_view layers = R"(
include = ["two_node.toml"]
[mesh]
kind = "layers"
link_below = "tread"
link_length = "1 mm"
link_conductivity = "0.3 W/mK"
[[mesh.layer]]
name = "tread"
thickness = "8 mm"
cells = 4
material = "rubber"
[[mesh.layer]]
name = "bulk"
thickness = "4 mm"
cells = 4
material = "rubber"
[[parameter]]
link = "conductivity"
at = "70 degC"
[[corner]]
name = "FL"
[[pyrometer]]
run = "warm-up"
sensors = ["bulk_temperature"]
uncertainty = "2 K"
FL = ["42 degC", "43 degC", "41 degC"]
[[run]]
name = "warm-up"
file = "run.csv"
corner = { FL = { initial = { temperature = "40 degC" } } }
[[run]]
name = "numbers"
measured = [{ channel = "bulk_temperature", value = "42 degC", uncertainty = "2 K" }]
)";

constexpr std::string_view strip = R"(
[mesh]
kind = "layers"
area = "1 m2"
[[mesh.layer]]
name = "rubber"
thickness = "12 mm"
cells = 4
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = { at = "20 degC", value = "1800 J/kgK", slope = "1 J/kgK/K" }
conductivity = "0.3 W/mK"
)";

constexpr std::string_view cylinder = R"(
include = ["strip.toml"]
[mesh]
kind = "cylinder"
inner_radius = "0.3 m"
length = "0.2 m"
[[mesh.layer]]
name = "tread"
thickness = "8 mm"
cells = 4
material = "rubber"
[[sensor]]
name = "flux"
kind = "heat_flux"
patch = "outside"
)";

constexpr std::string_view cylinder_of_a_tire = R"(
include = ["layers.toml"]
[mesh]
kind = "cylinder"
[[mesh.layer]]
name = "tread"
thickness = "12 mm"
cells = 4
material = "rubber"
)";

constexpr std::string_view block = R"(
[mesh]
kind = "block"
x = [{ to = "30 mm", cells = 4 }]
y = [{ to = "30 mm", cells = 4 }]
[[mesh.layer]]
name = "tread"
thickness = "8 mm"
cells = 4
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.3 W/mK"
[effects.laser]
radius = "5 mm"
[effects.still_air]
h_by_patch = { top = "10 W/m2K" }
[drive]
laser_power = "1 W"
air_temperature = "23 degC"
[initial]
temperature = "23 degC"
[time]
end = "10 s"
[[sensor]]
name = "point"
kind = "point"
depth = "0 mm"
[[sensor]]
name = "spot"
kind = "spot"
patch = "top"
radius = "5 mm"
[[camera]]
name = "camera"
pixel_size = "0.5 mm"
emissivity = 0.9
rows = [0, 3]
columns = [0, 3]
[[parameter]]
camera = "camera"
key = "x"
standard_deviation = "1 mm"
[[run]]
name = "frames"
frames = { camera = "camera.h5" }
)";

constexpr std::string_view axisymmetric = R"(
include = ["block.toml"]
[mesh]
kind = "axisymmetric"
radius = [{ to = "30 mm", cells = 4 }]
[[mesh.layer]]
name = "tread"
thickness = "8 mm"
cells = 4
material = "rubber"
)";

constexpr std::string_view study = R"(
case = "two_node.toml"
[sample]
count = 20
[[vary]]
key = "drive.speed"
values = ["80 km/h", "100 km/h"]
[[vary]]
key = "drive.vertical_load"
from = "3 kN"
to = "4 kN"
count = 2
[[draw]]
key = "effects.air_convection.lambda_h"
distribution = "normal"
mean = 1.0
standard_deviation = 0.1
[[draw]]
key = "effects.road_contact.Hc"
distribution = "uniform"
from = "400 W/m2K"
to = "600 W/m2K"
)";

constexpr std::string_view table = R"(
[[input]]
name = "air"
meaning = "of the hall"
standing = "assumed"
keys = ["drive.air_temperature"]
cases = ["two_node"]
adds_keys = true
value = "23 degC"
range = ["20 degC", "26 degC"]
[[input]]
name = "warm-up"
meaning = "its length"
standing = "assumed"
between = [["0 s", "10 s"]]
value = "10 s"
range = ["5 s", "20 s"]
[[input]]
name = "pace"
meaning = "of the road"
standing = "inferred"
signal = "speed"
value = "100 km/h"
range = ["80 km/h", "120 km/h"]
[[input]]
name = "share"
meaning = "of saturation"
standing = "assumed"
reads = "time_to"
value = 0.95
range = [0.9, 0.98]
[[number]]
id = "M1"
what = "bulk"
files = { two_node = "two_node.toml" }
channel = "bulk_temperature"
value = "50 degC"
uncertainty = "3 K"
source = "here"
minus = { at = "0 s" }
inputs = ["air"]
inferred_from_it = ["pace"]
[[number]]
id = "M2"
what = "bulk"
files = { two_node = "two_node.toml" }
channel = "bulk_temperature"
time_to = 0.95
from = "0 s"
below = "600 s"
source = "here"
[[number]]
id = "M3"
what = "bulk"
files = { two_node = "two_node.toml" }
channel = "bulk_temperature"
take = "max"
above = 1.0
source = "here"
over = { at = "0 s", minus = { at = "1 s" } }
)";

/// Two cars: tires by a property file and by stiffnesses; the other alternatives are those of both.
constexpr std::string_view car = R"(
[vehicle]
corner = "FL"
mass = "1350 kg"
wheelbase = "2.7 m"
front_track = "1.55 m"
rear_track = "1.5 m"
centre_of_gravity_height = "0.5 m"
centre_of_gravity_behind_front_axle = "1.3 m"
yaw_inertia = "1900 kg m2"
front_roll_stiffness_share = 0.55
front_roll_centre_height = "0.05 m"
rear_roll_centre_height = "0.1 m"
drag_area = "0.7 m2"
downforce_area = "0.2 m2"
front_downforce_share = 0.4
air_density = "1.2 kg/m3"
driven_axle = "all"
front_drive_share = 0.4
front_brake_share = 0.65
front_toe_in = "0.1 deg"
rear_toe_in = "0.1 deg"
front_cornering_stiffness = "80 kN/rad"
rear_cornering_stiffness = "90 kN/rad"
front_slip_stiffness = "90 kN"
rear_slip_stiffness = "90 kN"
friction = 1.1
steering_ratio = 15
smoothing = "0.2 s"
lateral_acceleration_sign = "automatic"
yaw_rate_sign = "left"
steering_sign = "left"
)";

constexpr std::string_view car_of_property_file = R"(
[vehicle]
corner = "RR"
mass = "1350 kg"
wheelbase = "2.7 m"
front_track = "1.55 m"
centre_of_gravity_height = "0.5 m"
front_weight_share = 0.5
front_roll_stiffness_share = 0.55
driven_axle = "front"
front_brake_share = 0.65
property_file = "made_up.tir"
rear_property_file = "made_up.tir"
friction_scale = 0.9
stiffness_scale = 0.9
)";

}  // namespace made_up

const std::vector<MadeUpFile>& files_of_every_kind() {
    static const std::vector<MadeUpFile> files{{"two_node.toml", made_up::two_node},
                                               {"section.toml", made_up::section},
                                               {"layers.toml", made_up::layers},
                                               {"strip.toml", made_up::strip},
                                               {"cylinder.toml", made_up::cylinder},
                                               {"cylinder_of_a_tire.toml", made_up::cylinder_of_a_tire},
                                               {"coastdown.toml", made_up::coastdown},
                                               {"block.toml", made_up::block},
                                               {"axisymmetric.toml", made_up::axisymmetric},
                                               {"study.toml", made_up::study},
                                               {"table.toml", made_up::table},
                                               {"car.toml", made_up::car},
                                               {"car_of_property_file.toml", made_up::car_of_property_file}};
    return files;
}

}  // namespace tiretherm::input
