#include <algorithm>
#include <array>
#include <cmath>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { partition, lambda_x, lambda_y };
enum : std::size_t { longitudinal, lateral };
enum : std::size_t { profile };

constexpr std::array parameters{
    Parameter{"partition", "1", 0.6, 0.0, 1.0, "share of the friction power that enters the tire"},
    Parameter{"lambda_x", "1", 1.0, 0.0, 10.0, "scale of the longitudinal friction power"},
    Parameter{"lambda_y", "1", 1.0, 0.0, 10.0, "scale of the lateral friction power"},
};
constexpr std::array<std::string_view, 2> on_off{"on", "off"};
constexpr std::array choices{
    Choice{"longitudinal", on_off, "whether longitudinal sliding makes heat (a switch of the thesis)"},
    Choice{"lateral", on_off, "whether lateral sliding makes heat (a switch of the thesis)"},
};
constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 1> reads{"speed"};
constexpr std::array<std::string_view, 5> may_read{"vertical_load", "slip_angle", "slip_ratio", "lateral_force",
                                                   "longitudinal_force"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void place(const Setting& setting, ActiveEffect& active) {
    spread_over_patches(setting, active, active.tables[profile]);
}

void drive(const ActiveEffect& active, const Driving& driving, std::span<double> out) {
    const Inputs& in = driving.inputs;
    out[0] = 0.0;
    if (!driving.tire.touches(in.vertical_load)) {
        return;
    }
    // Sliding speeds of the contact: v_sx = V - R_R Omega = -V slip_ratio, v_sy = V tan(alpha).
    const double along = std::abs(in.longitudinal_force * in.speed * in.slip_ratio);
    const double across = std::abs(in.lateral_force * in.speed) * std::tan(std::abs(in.slip_angle));
    // A law may take the share beyond 1, where it says that a term is missing; it never turns heat into cold.
    out[0] = active[partition] * std::max(0.0, driving.laws.partition) *
             ((active.choices[longitudinal] == 0 ? active[lambda_x] * along : 0.0) +
              (active.choices[lateral] == 0 ? active[lambda_y] * across : 0.0));
}

void speak(const Moment& m, Terms& terms) {
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.heat(m.active.nodes[i], m.intensities[0] * m.active.weights[i]);
    }
}

}  // namespace

extern const Effect sliding_friction;
const Effect sliding_friction{
    .id = "sliding_friction",
    .kind = Kind::source,
    .on = true,
    .equation = "q = partition (lambda_x |Fx v_sx| + lambda_y |Fy| |V| tan|alpha|) >= 0, v_sx = V - R_R Omega",
    .source = "thesis (31)",
    .meaning =
        "Heat of sliding in the contact, into the outer surface. Either sign convention of Fy and the slip "
        "angle gives the same heat; signals that are not given count as zero.",
    .parameters = parameters,
    .choices = choices,
    .tables = tables,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .patches = patches,
    .n_intensities = 1,
    .place = place,
    .drive = drive,
    .speak = speak,
};

}  // namespace tiretherm::physics::effects
