#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { emissivity };

constexpr std::array parameters{
    Parameter{"emissivity", "1", 0.95, 0.0, 1.0, "of the surface, where the camera is set to 1", false, 1.0},
};
constexpr std::array scopes{Scope::channel};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};

double read(const ActiveEffect& active, std::size_t position, double value, const Inputs& logged) {
    const double e = active.at(emissivity, Scope::channel, active.channels[position]);
    return std::pow(e * std::pow(value, 4) + (1.0 - e) * std::pow(logged.air_temperature, 4), 0.25);
}

}  // namespace

extern const Effect camera_emissivity;
const Effect camera_emissivity{
    .id = "camera_emissivity",
    .kind = Kind::sensor,
    .equation = "reading^4 = e T^4 + (1 - e) T_air^4, kelvin, T_air as logged",
    .source = "Stefan-Boltzmann law, grey surface, all wavelengths",
    .meaning =
        "A camera that takes rubber for black sees the surroundings in it: it reads too low above their temperature, "
        "too "
        "high below, by 3 K at 80 degC for an emissivity of 0.95.",
    .parameters = parameters,
    .scopes = scopes,
    .reads = reads,
    .on_channels = true,
    .before_lag = true,
    .reads_what = Reads::temperature,
    .read = read,
};

}  // namespace tiretherm::physics::effects
