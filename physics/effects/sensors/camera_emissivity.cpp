// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: camera set to emissivity 1 over a grey surface, reading^4 = e T^4 + (1 - e) T_air^4 (Stefan-Boltzmann
// law); a stated temperature may replace T_air.

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { emissivity, reflected_temperature };
enum : std::size_t { reflects };
enum : int { the_air, what_is_stated };

constexpr std::array parameters{
    ParameterSpec{"emissivity", "1", 0.95, 0.0, 1.0, "of the surface, where the camera is set to 1", false, 1.0},
    ParameterSpec{"reflected_temperature", "K", 293.15, 0.0, 3000.0,
                  "of the surroundings that the surface mirrors, with reflects = \"stated\""},
};
constexpr std::array confounded{
    ConfoundedGroup{{"camera_emissivity", "sidewall_convection"},
                    "a contact probe on the surface, or a soak at the temperature of the air"}};
constexpr std::array plausible{
    PlausibleRange{"emissivity", 0.85, 1.0,
                   "rubber 0.90 to 0.95 (radiation of tires, recalled), less where it is polished",
                   "rubber is blacker than that: the camera is off by another cause"},
};
constexpr std::array<std::string_view, 2> mirrored{"air", "stated"};
constexpr std::array choices{
    Choice{"reflects", mirrored, "whose temperature is mirrored: the air's, or reflected_temperature"}};
constexpr std::array scopes{Scope::channel};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};

double read(const ActiveEffect& active, std::size_t position, double value, const Inputs& logged) {
    const int channel = active.channels[position];
    const double e = active.at(emissivity, Scope::channel, channel);
    const double around = active.choices[reflects] == what_is_stated
                              ? active.at(reflected_temperature, Scope::channel, channel)
                              : logged.air_temperature;
    return std::pow(e * std::pow(value, 4) + (1.0 - e) * std::pow(around, 4), 0.25);
}

}  // namespace

extern const Effect camera_emissivity;
const Effect camera_emissivity{
    .id = "camera_emissivity",
    .kind = EffectKind::sensor,
    .equation = "reading^4 = e T^4 + (1 - e) T_air^4, kelvin, T_air as logged, or the temperature that is stated",
    .source = "Stefan-Boltzmann law, grey surface, all wavelengths",
    .valid = "emissivity 0.9 to 0.98 for rubber (recalled); cameras of 8 to 14 um that are read as black",
    .meaning =
        "A camera that takes rubber for black sees the surroundings in it: it reads too low above their temperature, "
        "too "
        "high below, by 3 K at 80 degC for an emissivity of 0.95.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .choices = choices,
    .scopes = scopes,
    .reads = reads,
    .model =
        SensorModel{
            .applies_to = ChannelsOf::temperature,
            .sees_surfaces_only = true,
            .before_lag = true,
            .read = read,
        },
};

}  // namespace tiretherm::physics::effects
