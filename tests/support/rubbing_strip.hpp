// SPDX-License-Identifier: BSD-3-Clause
// A strip of tread that slides on fresh road once a turn, turn by turn: cells of tread and of road on either side of an
// interface, stepped by SDIRK2. Uses nothing of the program.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace tiretherm::support {

/// Everything on a square metre of the contact; lengths in m, times in s, temperatures in K above the road.
struct RubbingStrip {
    double tread_k = 0.29;           ///< W/(m K)
    double tread_capacity = 1.98e6;  ///< J/(m3 K)
    double road_k = 1.2;
    double road_capacity = 2.07e6;
    double interface_h = 2.5e4;  ///< W/(m2 K)
    double heat = 0.0;           ///< W/m2 into the tread's side of the interface, in the contact
    double road_heat = 0.0;      ///< the same into the road's side
    double thickness = 0.01;     ///< of the tread, whose far side is insulated
    double start = 37.0;         ///< of the tread
    double duration = 0.0;       ///< of a contact
    double period = 0.0;         ///< of a turn, in whose middle the contact is

    struct Turn {
        double entry = 0.0;  ///< the tread's surface when it meets the road, and when it leaves it
        double exit = 0.0;
        double end = 0.0;      ///< the same when the turn ends, half a turn after the contact
        double mean = 0.0;     ///< over the turn
        double to_road = 0.0;  ///< J/m2 since the start
    };
    /// @param steps of a contact, and of each half of the rest  @returns the last of the turns
    [[nodiscard]] Turn last_of(int turns, int steps) const;
};

namespace rubbing {

/// Cells in a row from the deepest of the tread, over the surfaces of tread and road (no capacity) to the deepest of the
/// road.
struct Row {
    std::vector<double> capacity;  ///< J/(m2 K)
    std::vector<double> G;         ///< W/(m2 K), from each to the next
    std::size_t surface = 0;       ///< the tread's; the road's is the next

    /// One stage: solves capacity (T - known)/s = heat balance of T by Thomas's algorithm. @param T out
    void solve(double s, const std::vector<double>& known, double heat, double road_heat, bool touching,
               std::vector<double>& T) const {
        const std::size_t n = touching ? capacity.size() : surface + 1;
        std::vector<double> up(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double below = i > 0 ? G[i - 1] : 0.0;
            const double above = i + 1 < n ? G[i] : 0.0;
            double diagonal = capacity[i] / s + below + above;
            double right = capacity[i] / s * known[i];
            right += touching && i == surface ? heat : touching && i == surface + 1 ? road_heat : 0.0;
            if (i > 0) {
                diagonal -= below * up[i - 1];
                right += below * T[i - 1];
            }
            up[i] = above / diagonal;
            T[i] = right / diagonal;
        }
        for (std::size_t i = n - 1; i-- > 0;) {
            T[i] += up[i] * T[i + 1];
        }
    }
};

/// Widths that grow by a fifteenth from 0.3 um at the surface.
inline std::vector<double> widths(double depth) {
    std::vector<double> found;
    double at = 0.0;
    for (double width = 0.3e-6; at < depth; width *= 1.0667) {
        found.push_back(std::min(width, depth - at));
        at += found.back();
    }
    return found;
}

}  // namespace rubbing

inline RubbingStrip::Turn RubbingStrip::last_of(int turns, int steps) const {
    rubbing::Row row;
    const std::vector<double> tread = rubbing::widths(thickness);
    const std::vector<double> road = rubbing::widths(20.0 * std::sqrt(road_k / road_capacity * duration));
    for (std::size_t i = tread.size(); i-- > 0;) {
        row.capacity.push_back(tread_capacity * tread[i]);
        row.G.push_back(tread_k / (i > 0 ? 0.5 * (tread[i] + tread[i - 1]) : 0.5 * tread[0]));
    }
    row.surface = row.capacity.size();
    row.capacity.push_back(0.0);
    row.G.push_back(interface_h);
    row.capacity.push_back(0.0);
    row.G.push_back(road_k / (0.5 * road[0]));
    for (std::size_t i = 0; i < road.size(); ++i) {
        row.capacity.push_back(road_capacity * road[i]);
        row.G.push_back(i + 1 < road.size() ? road_k / (0.5 * (road[i] + road[i + 1])) : 0.0);
    }
    std::vector<double> T(row.capacity.size(), 0.0);
    std::fill_n(T.begin(), row.surface + 1, start);
    std::vector<double> middle = T;
    std::vector<double> known = T;
    Turn turn;
    // Alexander's SDIRK2, stiffly accurate: its second stage is the end of the step.
    const double gamma = 1.0 - std::sqrt(0.5);
    const auto step = [&](double dt, bool touching) {
        const double before = T[row.surface];
        row.solve(gamma * dt, T, heat, road_heat, touching, middle);
        for (std::size_t i = 0; i < T.size(); ++i) {
            known[i] = T[i] + (1.0 - gamma) / gamma * (middle[i] - T[i]);
        }
        const double drop = middle[row.surface] - middle[row.surface + 1];
        row.solve(gamma * dt, known, heat, road_heat, touching, T);
        if (touching) {
            turn.to_road +=
                dt * row.G[row.surface] * ((1.0 - gamma) * drop + gamma * (T[row.surface] - T[row.surface + 1]));
        }
        turn.mean += 0.5 * dt * (before + T[row.surface]) / period;
    };
    // Steps that grow with the square root of time, as what begins with a jump does.
    const auto phase = [&](double length, bool touching) {
        for (int i = 1; i <= steps; ++i) {
            step(length * (2.0 * i - 1.0) / (static_cast<double>(steps) * steps), touching);
        }
    };
    for (int i = 0; i < turns; ++i) {
        turn.mean = 0.0;
        phase(0.5 * (period - duration), false);
        turn.entry = T[row.surface];
        std::fill(T.begin() + static_cast<std::ptrdiff_t>(row.surface) + 1, T.end(), 0.0);  // fresh road
        phase(duration, true);
        turn.exit = T[row.surface];
        phase(0.5 * (period - duration), false);
        turn.end = T[row.surface];
    }
    return turn;
}

}  // namespace tiretherm::support
