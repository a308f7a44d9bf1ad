// SPDX-License-Identifier: BSD-3-Clause
// A case as the solver sees it: mesh, materials, tire, effects, inputs, settings and channels, in SI units and kelvin.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/effect.hpp"
#include "physics/tire_laws/handling.hpp"
#include "solver/input_model.hpp"
#include "solver/input_signals.hpp"
#include "solver/linear/factor.hpp"
#include "solver/quantity.hpp"

namespace tiretherm::solver {

/// How time is stepped.
enum class Method : std::uint8_t { tr_bdf2, backward_euler };

struct Settings {
    bool steady = false;  ///< solve for the steady state of the inputs at `end` instead of marching
    double start = 0.0;   ///< s
    double end = 0.0;     ///< s
    Method method = Method::tr_bdf2;
    std::optional<double> fixed_step;    ///< s; empty: error-controlled
    std::optional<double> largest_step;  ///< s, where the error controls; empty: none
    double tolerance = 0.01;             ///< K, largest local error of a step
    double output_interval = 0.0;        ///< s between rows of channels; 0: every step
    double field_interval = 0.0;         ///< s between stored fields; 0: only first and last
    LinearSolver linear_solver = LinearSolver::automatic;
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

/// The channels of a camera, one for each node of the surface that it looks at. Its pixels are means over them.
struct CameraChannels {
    std::string camera;
    std::size_t first = 0;  ///< index into Problem::channels
    std::size_t count = 0;

    [[nodiscard]] std::size_t end() const { return first + count; }
    [[nodiscard]] bool contains(int channel) const {
        return channel >= 0 && static_cast<std::size_t>(channel) >= first && static_cast<std::size_t>(channel) < end();
    }
    /// Those of the camera among values of all channels. @param all [n_channels]  @returns [count]
    [[nodiscard]] std::span<const double> of(std::span<const double> all) const { return all.subspan(first, count); }
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
    physics::Handling handling;
    std::vector<physics::ActiveEffect> effects;
    InputSignals input_signals;
    std::shared_ptr<const InputModel> input_model{};  ///< by which some inputs follow `input_numbers`; null: none do
    std::vector<double> input_numbers{};              ///< SI
    std::vector<double> initial;                      ///< [n_nodes] K
    Settings settings;
    std::vector<Channel> channels;        ///< of sensors, then of cameras
    std::vector<CameraChannels> cameras;  ///< whose channels are the last ones
    std::vector<Measured> measured;
    double symmetry = 1.0;  ///< the tire or specimen is this many times the mesh (4 for a quarter)

    /// How many channels belong to sensors: they come before those of cameras.
    [[nodiscard]] std::size_t n_sensors() const { return cameras.empty() ? channels.size() : cameras.front().first; }
    /// The camera that a channel belongs to, null for a sensor's.
    [[nodiscard]] const CameraChannels* camera_of(int channel) const;
};

/// Switches an effect on: its lumped nodes are added to the mesh at the temperature `start`.
/// @returns its index in problem.effects
std::size_t switch_on(Problem& problem, physics::ActiveEffect active, double start);

/// What is wrong with a problem, a sentence each; empty when it can be run.
[[nodiscard]] std::vector<std::string> defects(const Problem& problem);

}  // namespace tiretherm::solver
