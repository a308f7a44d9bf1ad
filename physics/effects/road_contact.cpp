#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { Hc, lambda_Hc };

constexpr std::array parameters{
    Parameter{"Hc", "W m-2 K-1", 500.0, 0.0, 1e6, "coefficient of a tire that does not roll, over the contact area"},
    Parameter{"lambda_Hc", "1", 1.0, 0.0, 10.0, "scale of the coefficient"},
};
constexpr std::array<std::string_view, 2> reads{"vertical_load", "road_temperature"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void drive(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, std::span<double> out) {
    out[0] = active[lambda_Hc] * active[Hc] * tire.contact_area(inputs.vertical_load);
    out[1] = out[0] * inputs.road_temperature;
}

void speak(const Moment& m, Terms& terms) {
    const double G = m.intensities[0];
    if (G <= 0.0) {
        return;
    }
    const double T_road = m.intensities[1] / G;
    for (const int patch : m.active.patches) {
        const mesh::Patch& outside = m.mesh.patches[static_cast<std::size_t>(patch)];
        const double per_area = G / outside.area();
        for (const mesh::PatchFace& face : outside.faces) {
            terms.exchange(face.node, per_area * face.area, T_road);
        }
    }
}

}  // namespace

extern const Effect road_contact;
const Effect road_contact{
    .id = "road_contact",
    .kind = Kind::loss,
    .on = true,
    .equation = "q = lambda_Hc Hc S_cont(Fz) (T_road - T_surf)",
    .source = "thesis (31)(35)",
    .meaning =
        "Heat to the road through a contact that is smeared over the circumference: Hc is a lumped share of "
        "area, not the coefficient inside a rolling contact.",
    .parameters = parameters,
    .choices = {},
    .reads = reads,
    .needs_tire = true,
    .patches = patches,
    .n_intensities = 2,
    .place = nullptr,
    .drive = drive,
    .speak = speak,
    .gives_derivatives = true,
};

}  // namespace tiretherm::physics::effects
