#include <array>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { Hc, lambda_Hc };
enum : std::size_t { profile };

constexpr std::array parameters{
    Parameter{"Hc", "W m-2 K-1", 500.0, 0.0, 1e6, "coefficient of a tire that does not roll, over the contact area"},
    Parameter{"lambda_Hc", "1", 1.0, 0.0, 10.0, "scale of the coefficient"},
};
constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 2> reads{"vertical_load", "road_temperature"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void place(const Setting& setting, ActiveEffect& active) {
    spread_over_patches(setting, active, active.tables[profile]);
}

void drive(const ActiveEffect& active, const Driving& driving, std::span<double> out) {
    out[0] = active[lambda_Hc] * active[Hc] * driving.tire.contact_area(driving.inputs.vertical_load);
    out[1] = out[0] * driving.inputs.road_temperature;
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
    .tables = tables,
    .reads = reads,
    .needs_tire = true,
    .patches = patches,
    .n_intensities = 2,
    .field = FieldOf::pressure,
    .place = place,
    .drive = drive,
    .speak = exchange_by_weights,
};

}  // namespace tiretherm::physics::effects
