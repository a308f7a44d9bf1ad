// SPDX-License-Identifier: BSD-3-Clause
// The cross-section of cases/section/common.toml, and that with a belt and a carcass of cords, written a second time from its page and the thesis: explicit steps on a
// grid of its own, without code of the program.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/rolling_contact_series.hpp"
#include "support/two_node_thesis.hpp"

namespace tiretherm::support {

/// A tire as 78 columns of cells along the meridian, outboard to inboard, counted from the inside: liner and carcass (2 mm)
/// and belt (2 mm) in cells of 0.2 mm, tread (8 mm of the thesis's tire) or sidewall (7 mm) of 0.4 mm, or all twice as
/// thick. Neighbours share a face where their cells overlap. The inputs and laws of the loss, the film and the contact are
/// those of the two-node model.
///   rho c dT/dt = div(k(T) grad T) + loss by mass,   C_gas dT_gas/dt = G (T_liner - T_gas) - G_rim (T_gas - T_rim)
class SectionThesis {
public:
    enum class Kind {
        section,
        section_of_cords,  ///< belt and carcass of cases/section/4000N_100kmh_cords.toml
        crown_alone,       ///< layers: without neighbours, sidewalls, gas and rim
        one_rubber,        ///< the crown alone of 0.29 W/mK everywhere
        disks,             ///< sidewalls and rim cooled by the film of a rotating disk
        rolling_contact,   ///< the road's heat as a rolling tread gives it
        all_heat_paths,    ///< cases/section/all_heat_paths.toml
    };

    SectionThesis(Kind kind, double start, const ThesisTire& tire = {}, int coarse = 1)
        : seconds(0.1 * coarse * coarse), gas(start), rim(start), kind_(kind), tire_(tire), coarse_(coarse) {
        const double W = tire.W;
        if (!is_section()) {
            add_column(W, 0.0, true, start);
            return;
        }
        for (const auto& [from, to, n, tread] :
             {Zone{-bead(), -0.5 * W, 15, false}, Zone{-0.5 * W, -0.3 * W, 15, true}, Zone{-0.3 * W, 0.3 * W, 18, true},
              Zone{0.3 * W, 0.5 * W, 15, true}, Zone{0.5 * W, bead(), 15, false}}) {
            for (int i = 0; i < n; ++i) {
                add_column((to - from) / n, from + (i + 0.5) * (to - from) / n, tread, start);
            }
        }
    }

    /// One step of the length that is stable up to 1.1 W/mK.   @param in its scales and inputs   @param camber rad
    void step(const TwoNodeThesis& in, double camber) {
        if (has_disks() || kind_ == Kind::rolling_contact) {
            follow(in);
        }
        Watts watts = made(in, camber);
        const double to_gas = through_the_surfaces(in, watts);
        along_the_meridian(watts);
        const double to_rim = through_the_beads(watts);
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            Column& c = columns_[i];
            for (std::size_t j = 0; j < c.T.size(); ++j) {
                c.T[j] += seconds * watts[i][j] / (heat_per_volume * material(c, j).capacity * c.area * c.thick[j]);
            }
        }
        const double gas_to_rim = rim_film(in) * (gas - rim);
        const double rim_to_air = has_disks() ? 0.5 * disk_film(of_rim_, rim_radius(), rim, in.T_air) : 10.0;
        gas += seconds * (to_gas - gas_to_rim) / 70.0;
        rim += seconds * (to_rim + gas_to_rim - rim_to_air * (rim - in.T_air)) / 7200.0;
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
    /// 10 mm deep in the middle of a shoulder, or of the crown that is alone. K
    [[nodiscard]] double outside_probe() const { return probe(columns_.size() == 1 ? 0 : 22); }
    [[nodiscard]] double inside_probe() const { return probe(columns_.size() == 1 ? 0 : 55); }

    double seconds;  ///< of a step
    double gas;      ///< K
    double rim;      ///< K

private:
    using Watts = std::vector<std::vector<double>>;
    struct Zone {
        double from, to;
        int n;
        bool tread;
    };
    /// Films at even steps of what they depend on.
    struct Table {
        double from = 0.0, apart = 0.0;
        std::array<double, 12> film{};
        template <class Of>
        void fill(const Of& of) {
            for (std::size_t i = 0; i < film.size(); ++i) {
                film[i] = of(from + apart * static_cast<double>(i));
            }
        }
        [[nodiscard]] double at(double x) const {
            const double place = (x - from) / apart;
            const auto i = static_cast<std::size_t>(place);
            return film.at(i) + (place - static_cast<double>(i)) * (film.at(i + 1) - film.at(i));
        }
    };
    struct Column {
        double length = 0.0, middle = 0.0, radius = 0.0, area = 0.0;
        bool tread = true;
        std::size_t n_below = 0;           ///< cells below tread or sidewall
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
    static constexpr double pi = TwoNodeThesis::pi;
    static constexpr double heat_per_volume = TwoNodeThesis::rho * TwoNodeThesis::c_v;
    static constexpr double below_tread = 4e-3;  // belt, carcass and liner
    static constexpr double below_wall = 2e-3;   // carcass and liner

    /// Heat of the loss.
    [[nodiscard]] Watts made(const TwoNodeThesis& in, double camber) const {
        // In cubic metres of the thesis's rubber.
        const double total_mass = sum([&](const Column& c) { return c.area * weight(c); });
        const double mean_side = sum([&](const Column& c) { return c.area * weight(c) * side(c); }) / total_mass;
        const double lean = 10.0 * camber;
        double loss = in.SEL(bulk()) / total_mass;  // W a m3
        if (kind_ == Kind::all_heat_paths) {
            // The law's drum of 1.707 m is not there, and the gas was filled at 20 degC.
            loss *= std::pow(gas / 293.15, -0.45) / std::sqrt(1.0 + tire_.R0 / (0.5 * 1.707));
        }
        Watts watts;
        for (const Column& c : columns_) {
            std::vector<double>& q = watts.emplace_back();
            for (std::size_t j = 0; j < c.T.size(); ++j) {
                q.push_back(loss * (1.0 + lean * (side(c) - mean_side)) * c.area * c.thick[j] * material(c, j).density);
            }
        }
        return watts;
    }

    /// Conduction through the columns, to air, road and gas.   @returns W to the gas
    double through_the_surfaces(const TwoNodeThesis& in, Watts& watts) {
        const double tread_area = sum([](const Column& c) { return c.tread ? c.area : 0.0; });
        const double wall_area = sum([](const Column& c) { return c.tread ? 0.0 : c.area; });
        const double inner_area = sum([](const Column& c) { return c.area; });
        const double slide =
            in.Fz > 0.0 ? std::abs(in.Fx * in.V * in.kappa) + std::abs(in.Fy * in.V * std::tan(in.alpha)) : 0.0;
        const double friction = in.hpc * slide / tread_area;
        const double free = (in.S_tot() - in.S_cont()) / tread_area;
        double to_gas = 0.0;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            Column& c = columns_[i];
            std::vector<double>& q = watts[i];
            for (std::size_t j = 0; j + 1 < c.T.size(); ++j) {
                const double G = c.area / (0.5 * c.thick[j] / k(c, j) + 0.5 * c.thick[j + 1] / k(c, j + 1));
                const double flow = G * (c.T[j] - c.T[j + 1]);
                q[j] -= flow;
                q[j + 1] += flow;
            }
            const std::size_t top = c.T.size() - 1;
            const double under = k(c, top) / (0.5 * c.thick[top]);
            double film = radiating(c.surface, in.T_air);
            if (c.tread) {
                const double road = road_film(c) * in.S_cont() / tread_area;
                film += free * tread_film(in, c.surface);
                c.surface = (under * c.T[top] + film * in.T_air + road * in.T_track + friction) / (under + film + road);
            } else {
                film += has_disks() ? disk_film(of_walls_, tire_.R0, c.surface, in.T_air) : 15.0 / wall_area;
                c.surface = (under * c.T[top] + film * in.T_air) / (under + film);
            }
            q[top] += under * c.area * (c.surface - c.T[top]);
            const double above = k(c, 0) / (0.5 * c.thick[0]);
            const double inner = liner_film(in, c.liner, inner_area);
            c.liner = (above * c.T[0] + inner * gas) / (above + inner);
            q[0] += above * c.area * (c.liner - c.T[0]);
            to_gas += inner * c.area * (c.liner - gas);
        }
        return to_gas;
    }

    void along_the_meridian(Watts& watts) const {
        for (std::size_t i = 0; i + 1 < columns_.size(); ++i) {
            const Column& a = columns_[i];
            const Column& b = columns_[i + 1];
            const double around = 2.0 * pi * 0.5 * (a.radius + b.radius);
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
    }

    /// 1 W/K through both beads, shared by thickness.   @returns W to the rim
    double through_the_beads(Watts& watts) const {
        double to_rim = 0.0;
        if (!is_section()) {
            return to_rim;
        }
        for (const std::size_t i : {std::size_t{0}, columns_.size() - 1}) {
            const Column& c = columns_[i];
            for (std::size_t j = 0; j < c.T.size(); ++j) {
                const double area = 2.0 * pi * c.radius * c.thick[j];
                const double bead = 0.5 * c.thick[j] / c.thickness();
                const double flow = (c.T[j] - rim) / (1.0 / bead + 0.5 * c.length / (along(c, j) * area));
                watts[i][j] -= flow;
                to_rim += flow;
            }
        }
        return to_rim;
    }

    // Films, W/(m2 K).
    [[nodiscard]] double tread_film(const TwoNodeThesis& in, double T) const {
        if (kind_ != Kind::all_heat_paths) {
            return in.h(T);
        }
        // Straight fins 8 mm deep between blocks of 20 mm of 0.29 W/mK, a quarter of the area.
        const double mL = std::sqrt(2.0 * in.forced() / (0.29 * 0.020)) * 0.008;
        return std::max(30.0, in.forced()) + 0.25 * std::tanh(mL) / mL * in.forced();
    }
    [[nodiscard]] double radiating(double T, double T_air) const {
        return kind_ == Kind::all_heat_paths ? 0.95 * 5.670374e-8 * (T * T + T_air * T_air) * (T + T_air) : 0.0;
    }
    /// 500 W/(m2 K) of the thesis, or that of a rolling tread on asphalt by its effusivity.
    [[nodiscard]] double road_film(const Column& c) const {
        if (kind_ != Kind::rolling_contact && kind_ != Kind::all_heat_paths) {
            return 500.0;
        }
        return of_road_.at(std::sqrt((0.29 + 0.66 * (c.surface - 293.15) / 70.0) * heat_per_volume));
    }
    /// Of a disk that turns, never below that of a plate.   @param forced by the mean of T and that of the air
    [[nodiscard]] static double disk_film(const Table& forced, double outer, double T, double T_air) {
        return std::max(1.42 * std::pow(std::abs(T - T_air) / (2.0 * outer), 0.25), forced.at(0.5 * (T + T_air)));
    }
    /// Cobb & Saunders over a ring; air by Sutherland's formulas.   @param turning rad/s
    [[nodiscard]] static double forced_disk_film(double turning, double inner, double outer, double T) {
        const double w_over_nu = turning * 101325.0 / (viscosity(T) * 287.05 * T);
        constexpr int rings = 500;
        double heat = 0.0;
        for (int i = 0; i < rings; ++i) {
            const double r = inner + (i + 0.5) * (outer - inner) / rings;
            const double Re = w_over_nu * r * r;
            const double local = conducts(T) / r * (Re < 2.4e5 ? 0.36 * std::sqrt(Re) : 0.0195 * std::pow(Re, 0.8));
            heat += local * 2.0 * r * (outer - inner) / rings;
        }
        return heat / (outer * outer - inner * inner);
    }
    /// The tables at another speed or load.
    void follow(const TwoNodeThesis& in) {
        if (in.V == V_of_tables_ && in.Fz == Fz_of_tables_) {
            return;
        }
        V_of_tables_ = in.V;
        Fz_of_tables_ = in.Fz;
        const bool rolls = in.V > 0.0 && in.Fz > 0.0;
        const double turning = rolls ? in.V / tire_.R_R(in.Fz) : 0.0;
        const RollingContactSeries series{.contact = tire_.length(in.Fz) / in.V,
                                          .revolution = 2.0 * pi / turning,
                                          .road = std::sqrt(1.2 * 2300.0 * 900.0)};
        of_road_.fill([&](double tread) { return rolls && kind_ != Kind::disks ? series.film(tread) : 0.0; });
        of_walls_.fill([&](double T) { return forced_disk_film(turning, rim_radius(), tire_.R0, T); });
        of_rim_.fill([&](double T) { return forced_disk_film(turning, 0.0, rim_radius(), T); });
    }
    [[nodiscard]] static double viscosity(double T) {
        return 1.716e-5 * std::pow(T / 273.15, 1.5) * 384.15 / (T + 111.0);
    }
    [[nodiscard]] static double conducts(double T) { return 0.0241 * std::pow(T / 273.15, 1.5) * 467.15 / (T + 194.0); }
    /// Nu = 0.15 Ra^(1/3) in the field of the rotation, air of 320 K; a quarter of it where the rotation keeps layers apart.
    [[nodiscard]] double cavity_film(const TwoNodeThesis& in, double radius, double outer_above_inner) const {
        const double turning = in.Fz > 0.0 ? in.V / tire_.R_R(in.Fz) : 0.0;
        const double field = std::hypot(turning * turning * radius, 9.81);
        const double rho = (220e3 + 101325.0) / (287.05 * 293.15);
        const double per_volume = field * rho * rho * 1007.0 / (320.0 * viscosity(320.0) * conducts(320.0));
        return (outer_above_inner < 0.0 ? 0.25 : 1.0) * 0.15 * conducts(320.0) *
               std::cbrt(per_volume * std::max(0.01, std::abs(outer_above_inner)));
    }
    [[nodiscard]] double liner_film(const TwoNodeThesis& in, double T, double inner_area) const {
        if (kind_ == Kind::all_heat_paths) {
            return cavity_film(in, tire_.R0 - tire_.h_tread, T - gas);
        }
        return is_section() ? 9.0 / inner_area : 0.0;
    }
    /// W/K
    [[nodiscard]] double rim_film(const TwoNodeThesis& in) const {
        return kind_ == Kind::all_heat_paths
                   ? 2.0 * pi * rim_radius() * tire_.W * cavity_film(in, rim_radius(), gas - rim)
                   : 4.0;
    }
    [[nodiscard]] double rim_radius() const { return tire_.R0 - tire_.H; }

    // The outer profile of three tangent arcs: a crown of 1 m radius, a shoulder that turns on to 45 degrees at half the
    // width, a sidewall that turns on to 120 degrees at the rim's radius.
    static double dropped(double from, double to, double length, double along) {
        const double bend = (to - from) / length;
        return (std::cos(from) - std::cos(from + bend * along)) / bend;
    }
    static constexpr double turn_2 = pi / 4.0;
    static constexpr double turn_3 = 2.0 * pi / 3.0;
    [[nodiscard]] double crown() const { return 0.3 * tire_.W; }
    [[nodiscard]] double shoulder() const { return 0.2 * tire_.W; }
    [[nodiscard]] double tread_drop(double crown_to, double shoulder_to) const {
        const double turn_1 = crown();  // over 1 m
        return dropped(0.0, turn_1, crown(), crown_to) +
               (shoulder_to > 0.0 ? dropped(turn_1, turn_2, shoulder(), shoulder_to) : 0.0);
    }
    [[nodiscard]] double wall_length() const {
        return (tire_.H - tread_drop(crown(), shoulder())) * (turn_3 - turn_2) / (std::cos(turn_2) - std::cos(turn_3));
    }
    [[nodiscard]] double bead() const { return 0.5 * tire_.W + wall_length(); }
    [[nodiscard]] double radius_at(double s) const {
        const double x = std::abs(s);
        const double edge = 0.5 * tire_.W;
        const double R = tire_.R0 - tread_drop(std::min(x, crown()), std::min(x, edge) - crown());
        return R - (x > edge ? dropped(turn_2, turn_3, wall_length(), x - edge) : 0.0);
    }

    void add_column(double length, double middle, bool tread, double start) {
        Column c{.length = length, .middle = middle, .tread = tread};
        c.radius = radius_at(middle);
        c.area = 2.0 * pi * c.radius * length;
        const double under = tread ? below_tread : below_wall;
        c.thick = cells(under, 0.2e-3 * coarse_);
        const std::vector<double> above = cells((tread ? tire_.h_tread : tire_.h_sidewall) - under, 0.4e-3 * coarse_);
        c.n_below = c.thick.size();
        c.thick.insert(c.thick.end(), above.begin(), above.end());
        c.T.assign(c.thick.size(), start);
        c.surface = c.liner = start;
        columns_.push_back(c);
    }
    static std::vector<double> cells(double thickness, double size) {
        const double n = std::round(thickness / size);
        return std::vector<double>(static_cast<std::size_t>(n), thickness / n);
    }
    /// Straight between the middles of two cells, in the heat that passes both.
    [[nodiscard]] double probe(std::size_t column) const {
        const Column& c = columns_[column];
        const double above_inside = c.thickness() - 0.010;
        std::size_t j = 0;
        double middle = 0.5 * c.thick[0];
        while (middle + 0.5 * (c.thick[j] + c.thick[j + 1]) < above_inside) {
            middle += 0.5 * (c.thick[j] + c.thick[j + 1]);
            ++j;
        }
        const double edge = middle + 0.5 * c.thick[j];
        const auto resistance = [&](double from, double to) {
            return std::max(0.0, std::min(to, edge) - from) / k(c, j) +
                   std::max(0.0, to - std::max(from, edge)) / k(c, j + 1);
        };
        const double below = resistance(middle, above_inside);
        const double above = resistance(above_inside, edge + 0.5 * c.thick[j + 1]);
        return (c.T[j] * above + c.T[j + 1] * below) / (above + below);
    }
    [[nodiscard]] double outermost() const { return is_section() ? tire_.h_tread - below_tread : 0.0018; }
    /// 1 at the middle of the outside shoulder and beyond, -1 inside.
    [[nodiscard]] double side(const Column& c) const { return std::clamp(-c.middle / (0.4 * tire_.W), -1.0, 1.0); }
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
        const bool below = j < c.n_below;
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
    [[nodiscard]] bool is_section() const { return kind_ != Kind::crown_alone && kind_ != Kind::one_rubber; }
    [[nodiscard]] bool has_disks() const { return kind_ == Kind::disks || kind_ == Kind::all_heat_paths; }
    template <class Of>
    [[nodiscard]] double sum(const Of& of) const {
        double all = 0.0;
        for (const Column& c : columns_) {
            all += of(c);
        }
        return all;
    }

    Kind kind_;
    ThesisTire tire_;
    int coarse_;
    std::vector<Column> columns_;
    // Films at the last speed and load.
    Table of_road_{.from = 600.0, .apart = 100.0};  ///< by the tread's effusivity, W s^0.5/(m2 K)
    Table of_walls_{.from = 280.0, .apart = 8.0};   ///< by the air's mean temperature, K
    Table of_rim_{.from = 280.0, .apart = 8.0};
    double V_of_tables_ = -1.0;
    double Fz_of_tables_ = -1.0;
};

}  // namespace tiretherm::support
