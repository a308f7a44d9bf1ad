#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/effect.hpp"
#include "solver/drive.hpp"

namespace tiretherm::solver {

/// How time is stepped.
enum class Method : std::uint8_t { tr_bdf2, backward_euler };

/// Which factor stands behind the linear systems; `automatic` looks at the fill that CHOLMOD's analysis predicts.
enum class LinearSolver : std::uint8_t { automatic, cholesky, conjugate_gradient };

struct Settings {
    bool steady = false;  ///< solve for the steady state of the drive at `end` instead of marching
    double start = 0.0;   ///< s
    double end = 0.0;     ///< s
    Method method = Method::tr_bdf2;
    std::optional<double> fixed_step;  ///< s; empty: error-controlled
    double tolerance = 0.01;           ///< K, largest local error of a step
    double output_interval = 0.0;      ///< s between rows of channels; 0: every step
    double field_interval = 0.0;       ///< s between stored fields; 0: only first and last
    LinearSolver linear_solver = LinearSolver::automatic;
};

/// A named reading. For now every channel is a temperature, a linear functional of the nodes.
struct Channel {
    std::string name;
    std::string meaning;  ///< says which temperature this is and where ("outer surface, mean over the spot")
    mesh::Functional where;
};

/// A measured value quoted by a source, to stand beside the simulated one.
struct Measured {
    std::string channel;
    double time = 0.0;  ///< s; the end of the run when not given
    double low = 0.0;   ///< K
    double high = 0.0;  ///< K, equal to low for a single number
    std::string source;
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
    std::vector<physics::ActiveEffect> effects;
    Drive drive;
    std::vector<double> initial;  ///< [n_nodes] K
    Settings settings;
    std::vector<Channel> channels;
    std::vector<Measured> measured;
    double symmetry = 1.0;  ///< the tire or specimen is this many times the mesh (4 for a quarter)
};

/// What is wrong with a problem, a sentence each; empty when it can be run.
[[nodiscard]] std::vector<std::string> defects(const Problem& problem);

}  // namespace tiretherm::solver
