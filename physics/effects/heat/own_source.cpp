#include <array>

#include "physics/own_place.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { watts };
enum : std::size_t { course };

constexpr std::array parameters{
    Parameter{"watts", "W", 0.0, -1e9, 1e9, "heat at a signal of 1; below 0 it is taken away", false, 0.0},
};
constexpr std::array tables{
    Table{"course", "s", "1", "the signal against the time since the run's start, held beyond its ends"},
};

void drive(const ActiveEffect& active, const Driving& driving, std::span<double> out) {
    out[0] = active.tables[course] ? active[watts] * active.tables[course]->value(driving.inputs.time) : 0.0;
}

void speak(const Moment& m, Terms& terms) {
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.heat(m.active.nodes[i], m.intensities[0] * m.active.weights[i]);
    }
}

}  // namespace

extern const Effect own_source;
const Effect own_source{
    .id = "own_source",
    .kind = Kind::source,
    .equation = "q = watts s(t), s the signal that it follows",
    .source = "definition: what the user, or a diagnosis, found",
    .meaning =
        "Heat of the user's own, written [[source]] in a case: in named parts of the mesh, following any logged "
        "signal. "
        "Cells share it by heat capacity, surfaces by area. All of it goes into the mesh, also where that is a "
        "quarter.",
    .parameters = parameters,
    .tables = tables,
    .n_intensities = 1,
    .place = place_own,
    .drive = drive,
    .speak = speak,
    .objection = object_to_own,
};

}  // namespace tiretherm::physics::effects
