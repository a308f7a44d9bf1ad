// SPDX-License-Identifier: BSD-3-Clause
// Position of a contact that goes round the tire at a moment, as angles in the rubber's frame, and the share of each
// sector that is in contact.
#pragma once

#include "mesh/mesh.hpp"
#include "physics/effect.hpp"
#include "physics/tire.hpp"
#include "physics/tire_laws/contact.hpp"

namespace tiretherm::physics {

/// The choice of an effect whose heat may be spread around the circumference or follow the contact.
inline constexpr std::string_view around_key = "around";
enum : int { evenly, in_contact };

/// Most sectors of a ring that a contact can go round.
inline constexpr int most_sectors = 256;

/// Where the contact is on the tire at a moment. Angles are those of the rubber, in which the contact's middle is at the
/// wheel angle - pi: what is at angle 0 starts a run at the top of the wheel and meets the road half a turn later.
class TravellingContact {
public:
    /// Nothing touches at rest and off the road.
    TravellingContact(const Tire& tire, const Inputs& inputs);

    [[nodiscard]] bool touches() const { return length_ > 0.0; }
    /// Angle that the contact spans, rad; no more than 2.
    [[nodiscard]] double length() const { return length_; }
    /// At which tread and road pass the contact, the faster of the two; rad/s, > 0 where anything touches.
    [[nodiscard]] double angular_speed() const { return angular_speed_; }

    /// What of a sector is in the contact, as angles since entry: 0 <= from <= to <= length(); nothing where from = to,
    /// but for a column.
    struct Part {
        bool inside = false;
        double from = 0.0;
        double to = 0.0;
    };
    /// @param sector of so many around the circumference. One alone is a column of rubber, the place at angle 0, which
    /// passes the contact as a whole: from = to.
    [[nodiscard]] Part part(int sector, int sectors) const;

private:
    double length_ = 0.0;
    double angular_speed_ = 0.0;
    double since_entry_ = 0.0;  ///< angle by which the place at angle 0 is past the entry, rad
    double direction_ = 1.0;    ///< -1 backwards
};

/// Shares the power of an area that travels with the contact out over the sectors: what a sector gets, times the number
/// of sectors, over what it would get if the power were spread around the circumference. Its mean over a revolution is 1.
[[nodiscard]] double concentration(const TravellingContact& contact, int sector, int sectors);

/// What of that stays in the tread when the road has taken its share back by an effect `travelling_contact`: the mean over
/// the part of the sector in contact. @param effusivity of the tread, W s^0.5/(m2 K)  @pre the sector touches
[[nodiscard]] double kept_heat(const ActiveEffect& travelling_contact, double effusivity, SlidingHeat enters,
                               const TravellingContact& contact, int sector, int sectors);

/// Whether an effect's place goes round the tire: always, or because a case chose it so.
[[nodiscard]] bool travels(const ActiveEffect& active);

/// Which sector each of an effect's nodes belongs to, 0 on a mesh that is not a ring.
[[nodiscard]] std::vector<int> sectors_of(const mesh::Mesh& mesh, const std::vector<int>& nodes);

}  // namespace tiretherm::physics
