// SPDX-License-Identifier: BSD-3-Clause
// The case of a set of dirty data: what its user knows, written as the manual of the program says.

#include "dirty/dirty_case_truth.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace hidden_effects {

namespace {

std::string kelvin(double x) {
    std::ostringstream out;
    out << std::setprecision(3) << x << " K";
    return out.str();
}

const char* place_of(const DirtySet& set, const DirtySensor& sensor) {
    switch (sensor.place) {
        case DirtySensor::Place::bulk:
            return "kind = \"region\"\nregion = \"bulk\"";
        case DirtySensor::Place::probe:
            return "kind = \"point\"\ndepth = \"10 mm\"";
        case DirtySensor::Place::liner:
            return "kind = \"patch\"\npatch = \"inside\"";
        case DirtySensor::Place::gas:
            return "kind = \"node\"\nnode = \"gas\"";
        default:
            break;
    }
    return set.two_node ? "kind = \"region\"\nregion = \"surface\"" : "kind = \"patch\"\npatch = \"outside\"";
}

const char* two_node_mesh = R"([mesh]
kind = "two_node"
surface_mass_share = 0.15
bulk_depth = "10 mm"
material = "rubber"

[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = { at = "20 degC", value = "0.29 W/mK", slope = "0.00943 W/mK/K", range = ["0 degC", "200 degC"] }
)";

/// The same rubber as layers, as warm in the mean: k L/(3 bulk_depth) of two nodes.
const char* cells_of_two_nodes = R"([mesh]
kind = "layers"

[[mesh.layer]]
name = "skin"
thickness = "1.8 mm"
cells = 8
ratio = 3
material = "rubber"

[[mesh.layer]]
name = "body"
thickness = "10.2 mm"
cells = 14
ratio = 3
material = "rubber"

[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = { at = "20 degC", value = "0.116 W/mK", slope = "0.003772 W/mK/K", range = ["0 degC", "200 degC"] }
)";

std::string layers_mesh(int tread, int carcass, double ratio) {
    std::ostringstream out;
    out << "[mesh]\nkind = \"layers\"\n\n[[mesh.layer]]\nname = \"tread\"\nthickness = \"8 mm\"\ncells = " << tread
        << "\nratio = " << ratio << "\nmaterial = \"tread rubber\"\n\n[[mesh.layer]]\nname = \"carcass\"\n"
        << "thickness = \"4 mm\"\ncells = " << carcass << "\nmaterial = \"carcass rubber\"\n";
    for (const char* material :
         {"tread rubber\"\nconductivity = \"0.40 W/mK", "carcass rubber\"\nconductivity = \"0.30 W/mK"}) {
        out << "\n[[material]]\nname = \"" << material
            << "\"\ndensity = \"1100 kg/m3\"\nheat_capacity = \"1800 J/kgK\"\n";
    }
    return out.str();
}

const char* wide_list = R"(
[diagnose]
candidates = [
    "sidewall_convection", "inner_gas", "rim_conduction", "inflation_pressure_rise", "cornering_loss",
    "convection_exponent", "partition_speed", "loss_tangent_slope", "loss_frequency_shift", "load_exponent_of_loss",
    "standing_wave", "road_temperature_drift", "air_temperature_drift", "sensor_lag", "clock_delay", "sensor_offset",
    "sensor_gain", "camera_emissivity", "layer_heat_capacity", "layer_conductivity", "slip_input_gain",
    "load_input_gain", "speed_input_gain", "radiation", "natural_convection", "groove_convection", "resolved_contact",
    "contact_pressure_conductance", "tread_wear", "drum_curvature",
]
)";

}  // namespace

std::string dirty_tire_table() {
    return R"([tire]
size = "225/50 R17"
unloaded_radius = "330.8 mm"
tread_thickness = "12 mm"
contact_length_limit = "160 mm"
contact_length_slope = "0.35 1/kN"
contact_area_at_zero = "0 m2"
contact_area_slope = "2.333e-6 m2/N"
loaded_radius_at_zero = "330.8 mm"
loaded_radius_slope = "-4.2e-6 m/N"
rolling_radius_factor = "348.3 mm"
rolling_radius_exponent = -0.009
)";
}

std::string dirty_case(const DirtySet& set, bool fine) {
    std::ostringstream out;
    out << "title = \"Tire " << set.seed << "\"\ninclude = [\"tire.toml\"]\n\n[tire]\nsidewall_thickness = \""
        << (set.two_node ? 9 : 12) << " mm\"\n\n";
    if (set.two_node) {
        out << (fine ? cells_of_two_nodes : two_node_mesh);
    } else {
        out << (fine ? layers_mesh(16, 7, 2.2)
                     : layers_mesh(set.case_layers[0], set.case_layers[1], set.case_layers[0] > 8 ? 2.2 : 1.0));
    }
    out << "\n[effects.air_convection]\nexponential = \"off\"\n";
    if (set.has_gas_sensor) {
        out << "\n[effects.inner_gas]\nliner = \"9 W/K\"\nrim = \"4 W/K\"\n";
    }
    if (!set.world.inputs.road_is_measured) {
        out << "\n[drive]\nroad_temperature = \"" << std::fixed << std::setprecision(1)
            << set.world.inputs.road_assumed - 273.15 << " degC\"\n";
    }
    out << "\n[initial]\ntemperature = \"air_temperature\"\n";
    for (const DirtySensor& sensor : set.world.sensors) {
        out << "\n[[sensor]]\nname = \"" << sensor.name << "\"\n"
            << place_of(set, sensor) << "\nstandard_deviation = \"" << kelvin(sensor.sigma) << "\"\n";
    }
    out << "\n[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\nexpected = 1.0\nstandard_deviation = "
           "0.1\n";
    out << (set.loss_is_free ? "\n[[parameter]]\neffect = \"strain_energy_loss\"\nkey = \"tan_delta_a\"\nexpected = "
                               "2.14e15\nstandard_deviation = 0.214e15\n"
                             : "\n[[parameter]]\neffect = \"sliding_friction\"\nkey = \"lambda_y\"\nexpected = "
                               "1.0\nstandard_deviation = 0.1\n");
    out << "\n[[parameter]]\ninitial = " << (set.two_node && !fine ? "[\"surface\", \"bulk\"]" : "\"temperature\"")
        << "\nstandard_deviation = \"3 K\"\n\n[identify]\nnoise = \"correlated\"\n";
    if (set.wide_list) {
        out << wide_list;
    }
    return out.str();
}

}  // namespace hidden_effects
