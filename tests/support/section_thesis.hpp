// SPDX-License-Identifier: BSD-3-Clause
// The cross-section of cases/section/common.toml, and that with a belt and a carcass of cords, written a second time from its page and the thesis: explicit steps on a
// grid of its own, without code of the program.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/two_node_thesis.hpp"

namespace tiretherm::support {

/// The 225/50 R17 of the thesis as 78 columns of cells along the meridian, outboard to inboard, counted from the inside:
/// liner and carcass (2 mm) and belt (2 mm) in cells of 0.2 mm, tread (8 mm) or sidewall (7 mm) of 0.4 mm. Neighbours share
/// a face where their cells overlap. The inputs and laws of the loss, the film and the contact are those of the two-node
/// model.
///   rho c dT/dt = div(k(T) grad T) + loss by mass,   C_gas dT_gas/dt = 9 W/K (T_liner - T_gas) - 4 W/K (T_gas - T_rim)
class SectionThesis {
public:
    /// Layers alone: the crown without neighbours, sidewalls, gas and rim. `one_rubber` has 0.29 W/mK everywhere.
    /// `section_of_cords` has the belt and the carcass of cases/section/4000N_100kmh_cords.toml.
    enum class Kind { section, section_of_cords, crown_alone, one_rubber };

    SectionThesis(Kind kind, double start) : gas(start), rim(start), kind_(kind) {
        if (!is_section()) {
            add_column(TwoNodeThesis::W, 0.0, true, start);
        } else {
            for (const auto& [from, to, n, tread] :
                 {Zone{-bead(), -0.1125, 15, false}, Zone{-0.1125, -0.0675, 15, true}, Zone{-0.0675, 0.0675, 18, true},
                  Zone{0.0675, 0.1125, 15, true}, Zone{0.1125, bead(), 15, false}}) {
                for (int i = 0; i < n; ++i) {
                    add_column((to - from) / n, from + (i + 0.5) * (to - from) / n, tread, start);
                }
            }
        }
    }

    /// One step of the length that is stable up to 1.1 W/mK.   @param in its scales and inputs   @param camber rad
    void step(const TwoNodeThesis& in, double camber) {
        // In cubic metres of the thesis's rubber.
        const double total_mass = sum([&](const Column& c) { return c.area * weight(c); });
        const double tread_area = sum([](const Column& c) { return c.tread ? c.area : 0.0; });
        const double wall_area = sum([](const Column& c) { return c.tread ? 0.0 : c.area; });
        const double inner_area = sum([](const Column& c) { return c.area; });
        const double lean = 10.0 * camber;
        const double mean_side = sum([&](const Column& c) { return c.area * weight(c) * side(c); }) / total_mass;
        const double loss = in.SEL(bulk()) / total_mass;  // W a m3
        const double slide =
            in.Fz > 0.0 ? std::abs(in.Fx * in.V * in.kappa) + std::abs(in.Fy * in.V * std::tan(in.alpha)) : 0.0;
        const double friction = in.hpc * slide / tread_area;
        const double free = (TwoNodeThesis::S_tot() - in.S_cont()) / tread_area;
        const double road = 500.0 * in.S_cont() / tread_area;
        std::vector<std::vector<double>> watts;
        double to_gas = 0.0;
        double to_rim = 0.0;
        for (Column& c : columns_) {
            std::vector<double>& q = watts.emplace_back(c.T.size(), 0.0);
            for (std::size_t j = 0; j < c.T.size(); ++j) {
                q[j] += loss * (1.0 + lean * (side(c) - mean_side)) * c.area * c.thick[j] * material(c, j).density;
                if (j + 1 < c.T.size()) {
                    const double G = c.area / (0.5 * c.thick[j] / k(c, j) + 0.5 * c.thick[j + 1] / k(c, j + 1));
                    const double flow = G * (c.T[j] - c.T[j + 1]);
                    q[j] -= flow;
                    q[j + 1] += flow;
                }
            }
            const std::size_t top = c.T.size() - 1;
            const double under = k(c, top) / (0.5 * c.thick[top]);
            if (c.tread) {
                const double film = free * in.h(c.surface);
                c.surface = (under * c.T[top] + film * in.T_air + road * in.T_track + friction) / (under + film + road);
            } else {
                const double film = 15.0 / wall_area;
                c.surface = (under * c.T[top] + film * in.T_air) / (under + film);
            }
            q[top] += under * c.area * (c.surface - c.T[top]);
            const double above = k(c, 0) / (0.5 * c.thick[0]);
            const double film = is_section() ? 9.0 / inner_area : 0.0;
            c.liner = (above * c.T[0] + film * gas) / (above + film);
            q[0] += above * c.area * (c.liner - c.T[0]);
            to_gas += film * c.area * (c.liner - gas);
        }
        for (std::size_t i = 0; i + 1 < columns_.size(); ++i) {
            const Column& a = columns_[i];
            const Column& b = columns_[i + 1];
            const double around = 2.0 * TwoNodeThesis::pi * 0.5 * (a.radius + b.radius);
            std::size_t j = 0;
            std::size_t m = 0;
            double reached = 0.0;  // from the inside
            double end_a = a.thick[0];
            double end_b = b.thick[0];
            while (j < a.T.size() && m < b.T.size()) {
                const double end = std::min(end_a, end_b);
                const double G =
                    around * (end - reached) / (0.5 * a.length / along(a, j) + 0.5 * b.length / along(b, m));
                watts[i][j] -= G * (a.T[j] - b.T[m]);
                watts[i + 1][m] += G * (a.T[j] - b.T[m]);
                reached = end;
                const bool both = std::abs(end_a - end_b) < 1e-9;
                if (both || end_a < end_b) {
                    end_a += ++j < a.T.size() ? a.thick[j] : 0.0;
                    m += both ? 1 : 0;
                    end_b += both && m < b.T.size() ? b.thick[m] : 0.0;
                } else {
                    end_b += ++m < b.T.size() ? b.thick[m] : 0.0;
                }
            }
        }
        if (is_section()) {  // 1 W/K through both beads, shared by thickness
            for (const std::size_t i : {std::size_t{0}, columns_.size() - 1}) {
                const Column& c = columns_[i];
                for (std::size_t j = 0; j < c.T.size(); ++j) {
                    const double area = 2.0 * TwoNodeThesis::pi * c.radius * c.thick[j];
                    const double bead = 0.5 * c.thick[j] / c.thickness();
                    const double flow = (c.T[j] - rim) / (1.0 / bead + 0.5 * c.length / (along(c, j) * area));
                    watts[i][j] -= flow;
                    to_rim += flow;
                }
            }
        }
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            for (std::size_t j = 0; j < columns_[i].T.size(); ++j) {
                const Column& c = columns_[i];
                columns_[i].T[j] +=
                    seconds * watts[i][j] / (heat_per_volume * material(c, j).capacity * c.area * c.thick[j]);
            }
        }
        const double gas_to_rim = 4.0 * (gas - rim);
        gas += seconds * (to_gas - gas_to_rim) / 70.0;
        rim += seconds * (to_rim + gas_to_rim - 10.0 * (rim - in.T_air)) / 7200.0;
    }

    /// Mean over the outer surface of the tread. K
    [[nodiscard]] double surface() const {
        return sum([](const Column& c) { return c.tread ? c.area * c.surface : 0.0; }) /
               sum([](const Column& c) { return c.tread ? c.area : 0.0; });
    }
    /// Mean over the inner surface. K
    [[nodiscard]] double liner() const {
        return sum([](const Column& c) { return c.area * c.liner; }) / sum([](const Column& c) { return c.area; });
    }
    /// Mean below the tread, or below the outermost layer of 1.8 mm of one rubber. K
    [[nodiscard]] double bulk() const {
        const auto volume = [&](const Column& c, bool times_T) {
            double all = 0.0;
            double depth = c.thickness();
            for (std::size_t j = 0; j < c.T.size() && c.tread; ++j) {
                depth -= c.thick[j];  // of the cell's outer side
                const double below = std::clamp((depth + c.thick[j] - outermost()) / c.thick[j], 0.0, 1.0);
                all += below * c.area * c.thick[j] * (times_T ? c.T[j] : 1.0);
            }
            return all;
        };
        return sum([&](const Column& c) { return volume(c, true); }) /
               sum([&](const Column& c) { return volume(c, false); });
    }
    /// 10 mm deep, between carcass and belt, in the middle of a shoulder, or of the crown that is alone. K
    [[nodiscard]] double outside_probe() const { return probe(columns_.size() == 1 ? 0 : 22); }
    [[nodiscard]] double inside_probe() const { return probe(columns_.size() == 1 ? 0 : 55); }

    static constexpr double seconds = 0.1;
    double gas;  ///< K
    double rim;  ///< K

private:
    struct Zone {
        double from, to;
        int n;
        bool tread;
    };
    struct Column {
        double length = 0.0, middle = 0.0, radius = 0.0, area = 0.0;
        bool tread = true;
        std::vector<double> thick{}, T{};  ///< from the inside out
        double surface = 0.0, liner = 0.0;
        [[nodiscard]] double thickness() const {
            double all = 0.0;
            for (const double t : thick) {
                all += t;
            }
            return all;
        }
    };
    static constexpr double heat_per_volume = TwoNodeThesis::rho * TwoNodeThesis::c_v;
    static constexpr double cell = 0.4e-3;

    // The outer profile of three tangent arcs: a crown of 1 m radius to 67.5 mm, a shoulder that turns on to 45 degrees at
    // 112.5 mm, a sidewall that turns on to 120 degrees at the rim's radius, R0 - H.
    static double dropped(double from, double to, double length, double along) {
        const double bend = (to - from) / length;
        return (std::cos(from) - std::cos(from + bend * along)) / bend;
    }
    static constexpr double turn_1 = 0.0675;
    static constexpr double turn_2 = TwoNodeThesis::pi / 4.0;
    static constexpr double turn_3 = 2.0 * TwoNodeThesis::pi / 3.0;
    static double wall_drop() {
        return TwoNodeThesis::H - dropped(0.0, turn_1, 0.0675, 0.0675) - dropped(turn_1, turn_2, 0.045, 0.045);
    }
    static double wall_length() { return wall_drop() * (turn_3 - turn_2) / (std::cos(turn_2) - std::cos(turn_3)); }
    static double bead() { return 0.1125 + wall_length(); }
    static double radius_at(double s) {
        const double x = std::abs(s);
        double R = TwoNodeThesis::R0 - dropped(0.0, turn_1, 0.0675, std::min(x, 0.0675));
        R -= x > 0.0675 ? dropped(turn_1, turn_2, 0.045, std::min(x, 0.1125) - 0.0675) : 0.0;
        return R - (x > 0.1125 ? dropped(turn_2, turn_3, wall_length(), x - 0.1125) : 0.0);
    }

    void add_column(double length, double middle, bool tread, double start) {
        Column c{.length = length, .middle = middle, .tread = tread};
        c.radius = radius_at(middle);
        c.area = 2.0 * TwoNodeThesis::pi * c.radius * length;
        c.thick.assign(tread ? 20 : 10, 0.5 * cell);
        c.thick.insert(c.thick.end(), tread ? 20 : 17, cell);
        if (!tread) {
            c.thick.push_back(0.5 * cell);  // 9 mm
        }
        c.T.assign(c.thick.size(), start);
        c.surface = c.liner = start;
        columns_.push_back(c);
    }
    [[nodiscard]] double probe(std::size_t column) const {
        const Column& c = columns_[column];
        return (k(c, 9) * c.T[9] + k(c, 10) * c.T[10]) / (k(c, 9) + k(c, 10));
    }
    [[nodiscard]] double outermost() const { return is_section() ? 0.008 : 0.0018; }
    /// 1 at the middle of the outside shoulder and beyond, -1 inside.
    static double side(const Column& c) { return std::clamp(-c.middle / 0.09, -1.0, 1.0); }
    /// Density and heat capacity per volume over those of the thesis's rubber; conductivities, W/mK.
    struct Material {
        double density = 1.0;
        double capacity = 1.0;
        double through = 0.0;
        double along = 0.0;  ///< the meridian
    };
    /// Skim rubber of 0.25 W/mK. Steel cords of 50 W/mK at 22 degrees, V = 800 pi 0.424^2/4 / 1000 = 0.1129566:
    /// k1 = 5.869590, k2 = 0.25 (50.25 + 49.75 V)/(50.25 - 49.75 V) = 0.312957, k1 sin^2 + k2 cos^2 = 1.092720;
    /// V 7850 + (1 - V) 1100 = 1862.457 kg/m3, V 7850 470 + (1 - V) 1100 1800 = 2173099 J/m3K.
    static Material belt() { return {1862.457 / 1100.0, 2173099.0 / 1980000.0, 0.312957, 1.092720}; }
    /// Polyester along the meridian, 1 and 0.2 W/mK, V = 1000 pi 0.66^2/4 / 1200 = 0.2850995: k1 = 0.463825,
    /// k2 = 0.25 (0.45 - 0.05 V)/(0.45 + 0.05 V) = 0.234647; V 1380 + (1 - V) 1100 = 1179.828 kg/m3,
    /// V 1380 1200 + (1 - V) 1100 1800 = 1887628 J/m3K.
    static Material carcass() { return {1179.828 / 1100.0, 1887628.0 / 1980000.0, 0.234647, 0.463825}; }

    /// K1 of the rubber and K2 of what is below, straight lines through 20 and 90 degC; of cords, those above.
    [[nodiscard]] Material material(const Column& c, std::size_t j) const {
        if (kind_ == Kind::one_rubber) {
            return {.through = 0.29, .along = 0.29};
        }
        const bool below = j < (c.tread ? 20U : 10U);
        if (kind_ == Kind::section_of_cords && below && j >= 4U) {  // 0.8 mm of liner lie inside
            return j < 10U ? carcass() : belt();
        }
        const double share = (c.T[j] - 293.15) / 70.0;
        const double k = below ? 0.060 + 0.015 * share : 0.29 + 0.66 * share;
        return {.through = k, .along = k};
    }
    [[nodiscard]] double k(const Column& c, std::size_t j) const { return material(c, j).through; }
    [[nodiscard]] double along(const Column& c, std::size_t j) const { return material(c, j).along; }
    /// Thickness of the thesis's rubber that weighs as much as a column. m
    [[nodiscard]] double weight(const Column& c) const {
        double all = 0.0;
        for (std::size_t j = 0; j < c.thick.size(); ++j) {
            all += c.thick[j] * material(c, j).density;
        }
        return all;
    }
    [[nodiscard]] bool is_section() const { return kind_ == Kind::section || kind_ == Kind::section_of_cords; }
    template <class Of>
    [[nodiscard]] double sum(const Of& of) const {
        double all = 0.0;
        for (const Column& c : columns_) {
            all += of(c);
        }
        return all;
    }

    Kind kind_;
    std::vector<Column> columns_;
};

}  // namespace tiretherm::support
