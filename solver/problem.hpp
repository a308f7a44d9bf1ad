#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/effect.hpp"
#include "physics/tire_laws/cornering_stiffness.hpp"
#include "physics/tire_laws/magic_formula.hpp"
#include "solver/input_signals.hpp"
#include "solver/linear/factor.hpp"

namespace tiretherm::solver {

/// How time is stepped.
enum class Method : std::uint8_t { tr_bdf2, backward_euler };

struct Settings {
    bool steady = false;  ///< solve for the steady state of the inputs at `end` instead of marching
    double start = 0.0;   ///< s
    double end = 0.0;     ///< s
    Method method = Method::tr_bdf2;
    std::optional<double> fixed_step;  ///< s; empty: error-controlled
    double tolerance = 0.01;           ///< K, largest local error of a step
    double output_interval = 0.0;      ///< s between rows of channels; 0: every step
    double field_interval = 0.0;       ///< s between stored fields; 0: only first and last
    LinearSolver linear_solver = LinearSolver::automatic;
};

/// What a channel reads. Temperatures are functionals of the nodes; the others follow from the tire's laws, the inputs
/// and, where it says so, the temperature of `where`.
enum class Quantity : std::uint8_t {
    temperature,              ///< K
    drag_force,               ///< N, rolling resistance of all that is lost by deformation (51)
    rolling_moment,           ///< N m (50)
    loaded_radius,            ///< m (37)
    cornering_stiffness,      ///< N/rad, at the temperature of `where` (52)
    gas_pressure,             ///< Pa above the atmosphere, heated at constant volume to the temperature of `where`
    bulk_temperature_factor,  ///< lambda_Tb of the Magic Formula at the temperature of `where` (60)
    lateral_force,            ///< N, Magic Formula with the cornering stiffness at the temperature of `where` (59)
    reference_lateral_force,  ///< N, Magic Formula that knows no temperature (10)
    longitudinal_force,       ///< N, Magic Formula in pure longitudinal slip (8)
    surface_at_entry,         ///< K, where the tread meets the road, in each revolution of which `where` is the mean
    surface_at_exit           ///< K, where it leaves the road
};
[[nodiscard]] std::string_view unit_of(Quantity quantity);  ///< SI, as UDUNITS reads it

/// The laws by which temperature reaches vehicle dynamics.
struct Handling {
    physics::EquivalentModulus modulus;                  ///< of the cornering stiffness
    double lambda_CP = 1.0;                              ///< scale of the cornering stiffness
    std::optional<physics::MagicFormula> magic_formula;  ///< of a property file
};

/// A named output: what a sensor reads.
struct Channel {
    std::string name;
    std::string meaning;  ///< says which temperature this is and where ("outer surface, mean over the spot")
    mesh::Functional where;
    Quantity quantity = Quantity::temperature;
    std::optional<mesh::Point> point{};          ///< m, of a sensor at a point
    std::optional<double> standard_deviation{};  ///< of the sensor, as its data sheet says, in the quantity's unit
};

/// A measured value quoted by a source, to stand beside the simulated one.
struct Measured {
    std::string channel;
    double time = 0.0;  ///< s; the end of the run when not given
    double low = 0.0;   ///< in the unit of the channel's quantity
    double high = 0.0;  ///< equal to low for a single number
    std::string source;
    std::optional<double> uncertainty{};  ///< standard; of a range with its width as a flat distribution
};

/// A case as the solver sees it: a value, everything in SI and kelvin, names resolved to indices.
struct Problem {
    std::string name;
    std::string title;
    std::vector<std::string> sources;  ///< what to cite
    mesh::Mesh mesh;
    std::vector<physics::Material> materials;  ///< [n_layers]
    std::vector<physics::Curve> link_laws;     ///< [n_links] W/(m K) against K
    physics::Tire tire;
    Handling handling;
    std::vector<physics::ActiveEffect> effects;
    InputSignals input_signals;
    std::vector<double> initial;  ///< [n_nodes] K
    Settings settings;
    std::vector<Channel> channels;
    std::vector<Measured> measured;
    double symmetry = 1.0;  ///< the tire or specimen is this many times the mesh (4 for a quarter)
};

/// Switches an effect on: its lumped nodes are added to the mesh at the temperature `start`.
/// @returns its index in problem.effects
std::size_t switch_on(Problem& problem, physics::ActiveEffect active, double start);

/// What is wrong with a problem, a sentence each; empty when it can be run.
[[nodiscard]] std::vector<std::string> defects(const Problem& problem);

}  // namespace tiretherm::solver
