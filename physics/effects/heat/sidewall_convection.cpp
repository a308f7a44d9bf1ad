// SPDX-License-Identifier: BSD-3-Clause
// Heat from the sidewalls to the air: q = (conductance + h A) (T_air - T) (Newton's law of cooling), or with the film of
// a rotating disk (Cobb & Saunders 1956). The thesis's tire has no sidewalls (erratum E16).

#include <algorithm>
#include <array>

#include "physics/spread.hpp"
#include "physics/tire_laws/disk_film.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { conductance, h };

constexpr std::array parameters{
    ParameterSpec{"conductance", "W K-1", 15.0, 0.0, 1e4,
                  "of both sidewalls together; 0.3 to 0.4 m2 at 30 to 60 W/m2K make 10 to 25 W/K", false, 0.0},
    ParameterSpec{"h", "W m-2 K-1", 0.0, 0.0, 1e4, "coefficient on the patch's area, in addition", false, 0.0},
    disk_film::scale,
    disk_film::laminar,
    disk_film::turbulent,
    disk_film::transition,
    disk_film::natural,
};
constexpr std::array trials{TrialValues{.parameter = "h", .left_out = true}};
constexpr std::array confounded{
    ConfoundedGroup{{"sidewall_convection", "inner_gas", "radiation"},
                    "a channel in the gas or on the liner; a long cool-down: gas gives back for minutes what it "
                    "took, radiation falls with the fourth power, sidewalls do neither"}};
constexpr std::array plausible{
    PlausibleRange{"conductance", 0.0, 40.0,
                   "rotating disk: 1.5 W/K at rest, 22 W/K at 100 km/h, 38 W/K at 200 km/h for a 225/50 R17",
                   "sidewalls shed no more than that: another loss is missing"},
    PlausibleRange{"h", 0.0, 100.0, "rotating disk 30 to 60 W/(m2 K) at 100 km/h",
                   "sidewalls shed no more than that: another loss is missing"},
    PlausibleRange{"disk_scale", 0.5, 2.0, "half behind a closed wheel house to twice in the travel wind; assumed",
                   "no sidewall is that far from a rotating disk: another loss is missing"},
};
constexpr std::array choices{Choice{disk_film::key, disk_film::films,
                                    "conductance and h at every speed, or the film of a rotating disk",
                                    disk_film::reads}};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"sidewalls", "inside"};

void place(const PlacementContext& context, ActiveEffect& active) { spread_over_patches(context, active); }

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    std::ranges::fill(out, 0.0);
    out[0] = point.inputs.air_temperature;
    if (disk_film::is_chosen(active)) {
        disk_film::evaluate(active, disk_film::sidewalls_of(point.tire), point, out);
    }
}

/// Of the patches, but of both faces of the tire where a mesh has no sidewalls and the inside stands for them. m2
double area_of_sidewalls(const EvaluationState& m) {
    double area = 0.0;
    for (const int index : m.active.patches) {
        const mesh::Patch& patch = m.mesh.patches[static_cast<std::size_t>(index)];
        if (patch.name == "inside") {
            return disk_film::area_of(disk_film::sidewalls_of(m.material_model.tire));
        }
        area += patch.area();
    }
    return area;
}

void add_disk_terms(const EvaluationState& m, Terms& terms) {
    const double area = area_of_sidewalls(m);
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        const int node = m.active.nodes[i];
        const double share = area * m.active.weights[i];
        const disk_film::Film film =
            disk_film::at(m.active, m.coefficients, m.temperature[static_cast<std::size_t>(node)]);
        terms.exchange(node, share * film.h, m.coefficients[0], share * film.dh_dT);
    }
}

void add_terms(const EvaluationState& m, Terms& terms) {
    if (disk_film::is_chosen(m.active)) {
        add_disk_terms(m, terms);
        return;
    }
    double area = 0.0;
    for (const int patch : m.active.patches) {
        area += m.mesh.patches[static_cast<std::size_t>(patch)].area();
    }
    const double G = m.active[conductance] + m.active[h] * area;
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.exchange(m.active.nodes[i], G * m.active.weights[i], m.coefficients[0]);
    }
}

double reynolds_in_millions(const ActiveEffect& active, const Tire& tire, const Inputs& inputs) {
    return disk_film::reynolds_in_millions(active, disk_film::sidewalls_of(tire), tire, inputs);
}

constexpr std::array compared{ComparedRange{"", 0.0, disk_film::measured_up_to, "measured",
                                            "million (Reynolds number of the disk)", reynolds_in_millions}};

}  // namespace

extern const Effect sidewall_convection;
const Effect sidewall_convection{
    .id = "sidewall_convection",
    .kind = EffectKind::loss,
    .equation =
        "q = (conductance + h A) (T_air - T); of a rotating disk: q = disk_scale h_disk A (T_air - T), h_disk = "
        "max(natural (|T - T_air|/(2 R0))^0.25, mean of k laminar (w/nu)^0.5 inside of w r^2/nu = transition and of "
        "(k/r) turbulent (w r^2/nu)^0.8 outside of it, over R0 - H < r < R0)",
    .source =
        "Newton's law of cooling; rotating disk in air: Cobb & Saunders, Proc. R. Soc. A 236, 1956, 343 (means 0.36 "
        "Re^0.5 and 0.015 Re^0.8, of which the latter is the local 0.0195 Re_r^0.8; transition at 2.4e5; recalled); "
        "vertical plate: McAdams, Heat Transmission, 3rd ed. 1954, ch. 7",
    .valid =
        "with constants at the speed at which they were taken, 100 km/h for the standard value (assumed); the disk: "
        "smooth, in air at rest, Re up to 7e5 (recalled); its k and nu are those of air at the mean of T and T_air, "
        "power laws "
        "within 1 % of tables from 250 to 400 K",
    .meaning =
        "Heat that leaves through the sidewalls, which the thesis's tire does not have (erratum E16). Spread by area "
        "over the sidewalls; on a mesh without them it is taken from the inside, on two nodes from the bulk. With "
        "film = \"rotating_disk\" the coefficient follows the speed and conductance and h do not count; it needs a "
        "tire, its speed and its load, and where a mesh has no sidewalls A is 2 pi (R0^2 - (R0 - H)^2), 0.39 m2 of a "
        "225/50 R17. At 60 degC in air of 23 degC that tire has 1.5 W/K at rest, 9 W/K at 50 km/h, 22 W/K (56 W/m2K) "
        "at 100 km/h and 38 W/K at 200 km/h; the constant 15 W/K is its film at 71 km/h. Measured on smooth disks up "
        "to about Re = 7e5 (recalled), which is 116 km/h; beyond, the law is an extrapolation. It knows no travel "
        "wind, wheel house or lettering: disk_scale stands for them. A plate of the tire's diameter in the travel wind "
        "alone would have 63 W/m2K at 100 km/h; wind and rotation do not simply add (aus der Wiesche, Int. J. Thermal "
        "Sciences 46, 2007, 745, abstract). On two nodes the rubber between bulk and outer face is not in it: with "
        "4.5 mm of 0.29 W/mK in series 12 of 22 W/K remain. Where natural_convection acts on the same patch, the floor "
        "at rest is its own.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .trials = trials,
    .choices = choices,
    .reads = reads,
    .may_read = disk_film::reads,
    .patches = patches,
    .one_patch = true,
    .model =
        HeatEffect{
            .n_coefficients = disk_film::n_coefficients,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
