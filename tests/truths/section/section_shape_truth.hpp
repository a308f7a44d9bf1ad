// SPDX-License-Identifier: BSD-3-Clause
// Biquadratic finite elements of the tire section, or of its crown alone as flat layers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "numerics/band_truth.hpp"
#include "section/section_causes_truth.hpp"
#include "section/section_meridian_truth.hpp"

namespace hidden_effects {

/// What of the tire is looked at: the section, or its crown band alone, a flat strip that is the same along s.
enum class Strip : std::uint8_t { section, layers };

inline constexpr double tread_depth = 0.008;    ///< m
inline constexpr double section_depth = 0.012;  ///< m

/// The section in biquadratic finite elements over arc length and depth, every one a ring of the profile's radius:
/// matrices and load vectors of what is linear. Nodes are numbered down the depth first; one more is the gas.
class SectionShape {
public:
    /// A point of quadrature on the tread's outer surface.
    struct SurfacePoint {
        std::array<std::size_t, 3> node{};
        std::array<double, 3> shape{};
        double area = 0.0;  ///< m2
    };

    SectionShape(const SectionCauses& causes, int refinement, Strip strip);

    [[nodiscard]] std::size_t n_nodes() const { return s_.size() * z_.size() + 1; }
    [[nodiscard]] std::size_t gas() const { return n_nodes() - 1; }
    [[nodiscard]] std::size_t reach() const { return 2 * z_.size() + 2; }
    /// Weights with which the nodes make the temperature at a place.
    [[nodiscard]] std::vector<double> at(double s, double z) const;

    BandMatrix capacity;              ///< J/K
    BandMatrix conduction;            ///< W/K, with the exchange of both sidewalls and of the liner
    std::vector<SurfacePoint> tread;  ///< outer surface
    double tread_area = 0.0;          ///< m2
    // Load vectors, the sum of each 1.
    std::vector<double> loss;             ///< by mass, half as much of it in the sidewalls
    std::vector<double> loss_skew;        ///< the same times the share towards the outside; its sum is 0
    std::vector<double> carcass;          ///< volume of the carcass below the tread
    std::vector<double> crown;            ///< volume of the crown
    std::vector<double> surface;          ///< outer surface of the tread
    std::vector<double> crown_surface;    ///< outer surface of the crown
    std::vector<double> inside_shoulder;  ///< outer surface of the inside shoulder
    std::vector<double> liner;            ///< inner surface
    std::vector<double> sidewalls;        ///< W/K, exchange of the outer surfaces of the sidewalls with the air

private:
    void add_element(const SectionCauses& causes, std::size_t i, std::size_t j);
    void add_faces(const SectionCauses& causes, std::size_t i);
    void append_meridian(int n);
    void find_areas();
    [[nodiscard]] double radius(double s) const;
    [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return i * z_.size() + j; }

    Strip strip_;
    std::vector<double> s_;  ///< m, of the nodes, three to an element
    std::vector<double> z_;
    double liner_area_ = 0.0;
    double sidewall_area_ = 0.0;  ///< of both
};

}  // namespace hidden_effects
