// SPDX-License-Identifier: BSD-3-Clause
// Hottest place of a part of the tire, also between cell centres, its history over a run, and the time when it passes a
// critical temperature.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/hot_spot_finder.hpp"
#include "solver/problem.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

/// A temperature that some part of the tire should not pass.
struct Critical {
    std::string name{};          ///< "belt edge"
    std::string part{};          ///< in words: "belt in outside_shoulder and inside_shoulder"; empty: the whole tire
    double temperature = 0.0;    ///< K
    std::vector<int> nodes{};    ///< of the part, ascending
    std::string surface_name{};  ///< of the channel that is compared with it; empty: there is none
    int channel = -1;            ///< index of this channel; -1: the mean temperature below
    mesh::Functional surface{};
};

/// The hot spot at every row of a run.
class HotSpotHistory {
public:
    HotSpotHistory(const mesh::Mesh& mesh, Critical critical);

    void take(const Snapshot& snapshot);
    /// Everything that was taken, as numbers.
    void visit(Archive& archive);

    [[nodiscard]] const Critical& critical() const { return critical_; }
    [[nodiscard]] std::size_t rows() const { return now_.time.size(); }
    [[nodiscard]] const std::vector<double>& time() const { return now_.time; }                ///< [rows] s
    [[nodiscard]] const std::vector<double>& temperature() const { return now_.temperature; }  ///< [rows] K
    [[nodiscard]] const std::vector<double>& surface() const {
        return now_.surface;
    }  ///< [rows] K; NaN where there is none
    [[nodiscard]] const HotSpotFinder::Found& found(std::size_t row) const { return now_.found[row]; }
    /// Row in which the highest temperature is reached, to 5 mK: a plateau goes on creeping. @pre rows() > 0
    [[nodiscard]] std::size_t hottest_row() const { return now_.hottest_row; }
    /// Weights of the hottest place of this row, see HotSpotFinder::functional.
    [[nodiscard]] const mesh::Functional& hottest_place() const { return now_.hottest_place; }

private:
    Critical critical_;
    HotSpotFinder finder_;
    struct State {
        std::vector<double> time;
        std::vector<double> temperature;
        std::vector<double> surface;
        std::vector<HotSpotFinder::Found> found;
        mesh::Functional hottest_place;
        std::size_t hottest_row = 0;
    };
    State now_;
};

/// When a history first passes a level from below, straight between its rows; the first time where it begins above.
/// @returns s; NaN where it never does
[[nodiscard]] double passing_time(std::span<const double> time, std::span<const double> value, double level);

/// A history at a time, straight between its rows and held beyond them.
[[nodiscard]] double value_at(std::span<const double> time, std::span<const double> value, double t);

}  // namespace tiretherm::solver
