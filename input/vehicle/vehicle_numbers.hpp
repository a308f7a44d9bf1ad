// SPDX-License-Identifier: BSD-3-Clause
// The numbers of [vehicle], and the car that they describe. A fit may move them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "physics/vehicle/brake.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

enum class VehicleNumber : std::uint8_t {
#define VEHICLE_NUMBER(key, absent) key,
#include "input/vehicle/vehicle_numbers.list"
};

/// How the case writes a number.
struct VehicleNumberSpec {
    std::string_view key;
    double absent;  ///< SI, where the case does not give it; NaN: see vehicle_of
};
inline constexpr std::size_t n_vehicle_numbers = static_cast<std::size_t>(VehicleNumber::brake_cooling) + 1;
/// [n_vehicle_numbers], in the order of the enumeration.
[[nodiscard]] std::span<const VehicleNumberSpec> vehicle_numbers();
[[nodiscard]] const VehicleNumberSpec& spec_of(VehicleNumber number);

/// Values of all numbers, SI.
class VehicleNumbers {
public:
    VehicleNumbers();  ///< those that are absent
    explicit VehicleNumbers(std::span<const double> all);

    [[nodiscard]] double operator[](VehicleNumber number) const { return all_[static_cast<std::size_t>(number)]; }
    double& operator[](VehicleNumber number) { return all_[static_cast<std::size_t>(number)]; }
    [[nodiscard]] double or_else(VehicleNumber number, double other) const {
        return std::isnan((*this)[number]) ? other : (*this)[number];
    }
    [[nodiscard]] std::span<const double> all() const { return all_; }
    template <typename Take>
    void visit_members(const Take& take) const {
        take(all_);
    }

private:
    std::array<double, n_vehicle_numbers> all_{};
};

enum class DrivenAxle : std::uint8_t { front, rear, all };

/// What describes a car besides its numbers.
struct VehicleKind {
    DrivenAxle driven = DrivenAxle::rear;
    /// Of property files, front and rear; without them the stiffnesses count.
    std::array<std::optional<physics::MagicFormula>, 2> laws{};
};

/// The car of these numbers. Where they are not given, the rear track is the front one, the yaw inertia m a b (Gillespie 1992,
/// ch. 6), the friction without end. A centre of gravity that is not between the axles is taken to the nearer of them.
[[nodiscard]] physics::Vehicle vehicle_of(const VehicleNumbers& numbers, const VehicleKind& kind);
[[nodiscard]] physics::Brake brake_of(const VehicleNumbers& numbers);

}  // namespace tiretherm::input
