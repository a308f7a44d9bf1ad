// SPDX-License-Identifier: BSD-3-Clause
// Steps of 0.1 s: conduction by Crank and Nicolson, all else at the middle of the step with extrapolated temperatures,
// which is of second order too.

#include "dirty/dirty_tire_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

using std::numbers::pi;
// The tire, 225/50 R17, as the thesis prints it.
constexpr double width = 0.225;
constexpr double height = 0.1125;
constexpr double radius = 0.3308;
constexpr double tread = 0.012;
constexpr double sidewall_of_two_node = 0.009;
constexpr double sidewall_of_layers = 0.012;
constexpr double area = 2.0 * pi * radius * width;
constexpr double volumetric = 1100.0 * 1800.0;  ///< J/m3K
constexpr double gas_capacity = 70.0;           ///< J/K
constexpr double rim_capacity = 7200.0;         ///< J/K
constexpr double stefan_boltzmann = 5.670374419e-8;
constexpr std::array<double, 3> column_share{0.25, 0.5, 0.25};

/// Inputs at one moment.
struct Now {
    double V, Fz, alpha, Fy, T_air, T_road, brake;
};

Now at(const DirtyDrive& drive, double t) {
    return {dirty_value(drive.speed, t),           dirty_value(drive.vertical_load, t),
            dirty_value(drive.slip_angle, t),      dirty_value(drive.lateral_force, t),
            dirty_value(drive.air_temperature, t), dirty_value(drive.road_temperature, t),
            dirty_value(drive.brake_power, t)};
}

/// Heat of cyclic deformation, thesis (36)-(49), and its neighbours, W.
double loss(const DirtyTire& tire, const Now& in, double T_bulk) {
    if (in.V <= 0.1 || in.Fz <= 1.0) {
        return 0.0;
    }
    const double sidewall =
        tire.column.lumps || tire.column.bulk_from < 0.005 ? sidewall_of_two_node : sidewall_of_layers;
    const double length = 0.160 - 2.0 * 0.160 / (1.0 + std::exp(0.35e-3 * in.Fz));
    const double ratio = (width * tread + 2.0 * sidewall * (height - tread)) / (width * height);
    const double frequency = in.V / (2.0 * pi * 0.3483 * std::pow(in.Fz, -0.009));
    const double decades = std::log10(frequency / 52.0);
    const double x = (T_bulk + 101.6 * decades / (-8.86 - decades) + 4989.0) / 882.0;
    const double energy = in.Fz * (4.2e-6 * in.Fz / height) * ratio * height * 2.14e15 * std::exp(-x * x);
    const double over = std::max(0.0, 3.6 * in.V - tire.critical);
    return tire.lambda_sel * energy * (2.0 * pi * radius / length) * frequency *
           std::pow(in.Fz / 4500.0, tire.load_exponent) * std::exp(tire.loss_slope * (T_bulk - celsius - 60.0)) *
           (1.0 + tire.wave * over * over);
}

/// Forced film with its floor, thesis (32) without the exponential term, W/m2K.
double film(const DirtyTire& tire, double V) {
    const double length = 1.0 / (1.0 / (2.0 * radius) + 1.0 / width);
    const double at_25 = 0.025 / length * 0.318 * std::pow(25.0 * length / 1.5e-5, 0.571);
    return tire.lambda_h * std::max(30.0, V > 0.0 ? at_25 * std::pow(V / 25.0, tire.film_exponent) : 0.0);
}

/// Contact averaged over a revolution, W/K: two half-spaces that meet for l/V behind the conductance of their interface,
/// which bounds it.
double contact_in_revolutions(const DirtyTire& tire, const Now& in) {
    if (tire.contact <= 0.0 || in.V < 1.0 || in.Fz <= 1.0) {
        return 0.0;
    }
    const double length = 0.160 - 2.0 * 0.160 / (1.0 + std::exp(0.35e-3 * in.Fz));
    const double rubber = std::sqrt(0.35 * volumetric);
    const double road = std::sqrt(1.2 * 2.07e6);
    const double spaces = 2.0 * rubber * road / (rubber + road) / std::sqrt(pi * length / in.V);
    return tire.contact * 2.333e-6 * in.Fz / (1.0 / 25000.0 + 1.0 / spaces);
}

/// One column's cells with their capacities and what joins them.
struct Cells {
    std::vector<double> capacity;  ///< J/K
    std::vector<double> depth;     ///< m, of the middles
    std::size_t first_bulk = 0;
    double bulk_capacity = 0.0;
    double total = 0.0;
};

Cells cells_of(const DirtyColumn& column, double share) {
    Cells cells;
    double from = 0.0;
    for (const double d : column.thickness) {
        cells.capacity.push_back(volumetric * area * share * d);
        cells.depth.push_back(from + 0.5 * d);
        cells.first_bulk += from + 1e-9 < column.bulk_from ? 1 : 0;
        from += d;
        cells.total += cells.capacity.back();
    }
    for (std::size_t i = cells.first_bulk; i < cells.capacity.size(); ++i) {
        cells.bulk_capacity += cells.capacity[i];
    }
    return cells;
}

double bulk_of(const Cells& cells, const std::vector<double>& T) {
    double sum = 0.0;
    for (std::size_t i = cells.first_bulk; i < T.size(); ++i) {
        sum += cells.capacity[i] * T[i];
    }
    return sum / cells.bulk_capacity;
}

/// Conductances between neighbours at temperatures T, W/K.
void links(const DirtyTire& tire, const Cells& cells, const std::vector<double>& T, double share,
           std::vector<double>& G) {
    const DirtyColumn& column = tire.column;
    const auto k = [&](std::size_t i) {
        const double factor = column.lumps || i >= cells.first_bulk ? tire.carcass_conductivity : 1.0;
        return factor * column.conductivity[i] * (1.0 + column.slope * (T[i] - celsius - 20.0));
    };
    for (std::size_t i = 0; i + 1 < T.size(); ++i) {
        G[i] = column.lumps
                   ? area * share * k(1) / 0.010
                   : area * share / (0.5 * column.thickness[i] / k(i) + 0.5 * column.thickness[i + 1] / k(i + 1));
    }
}

/// C (T' - T)/dt = q + half of the conduction before and half of it after.
void step(const Cells& cells, const std::vector<double>& G, const std::vector<double>& q, std::vector<double>& T) {
    const std::size_t n = T.size();
    thread_local std::vector<double> diagonal;
    thread_local std::vector<double> right;
    diagonal.assign(n, 0.0);
    right.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        diagonal[i] = cells.capacity[i] / dirty_step;
        right[i] = diagonal[i] * T[i] + q[i];
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double flow = 0.5 * G[i] * (T[i + 1] - T[i]);
        right[i] += flow;
        right[i + 1] -= flow;
        diagonal[i] += 0.5 * G[i];
        diagonal[i + 1] += 0.5 * G[i];
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double factor = -0.5 * G[i - 1] / diagonal[i - 1];
        diagonal[i] += factor * 0.5 * G[i - 1];
        right[i] -= factor * right[i - 1];
    }
    T[n - 1] = right[n - 1] / diagonal[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) {
        T[i] = (right[i] + 0.5 * G[i] * T[i + 1]) / diagonal[i];
    }
}

}  // namespace

DirtyColumn dirty_lumps() {
    return {.lumps = true,
            .thickness = {0.15 * tread, 0.85 * tread},
            .conductivity = {0.29, 0.29},
            .slope = 0.00943 / 0.29,
            .bulk_from = 0.15 * tread};
}

DirtyColumn dirty_cells_of_lumps() {
    // A slab with even heat is q L/(3 k) warmer in its mean than at its surface: k L/10 mm/3 makes the link's resistance.
    DirtyColumn column{.thickness = {}, .conductivity = {}, .slope = 0.00943 / 0.29, .bulk_from = 0.15 * tread};
    const auto add = [&](double from, double to, int n, double ratio) {
        double weight = 0.0;
        for (int i = 0; i < n; ++i) {
            weight += std::pow(ratio, static_cast<double>(i) / std::max(1, n - 1));
        }
        for (int i = 0; i < n; ++i) {
            column.thickness.push_back((to - from) * std::pow(ratio, static_cast<double>(i) / std::max(1, n - 1)) /
                                       weight);
            column.conductivity.push_back(0.29 * tread / 0.010 / 3.0);
        }
    };
    add(0.0, 0.15 * tread, 8, 3.0);
    add(0.15 * tread, tread, 16, 3.0);
    return column;
}

DirtyColumn dirty_layers(int n_tread, int n_carcass, double ratio) {
    DirtyColumn column{.thickness = {}, .conductivity = {}, .bulk_from = 0.008};
    double weight = 0.0;
    for (int i = 0; i < n_tread; ++i) {
        weight += std::pow(ratio, static_cast<double>(i) / std::max(1, n_tread - 1));
    }
    for (int i = 0; i < n_tread; ++i) {
        column.thickness.push_back(0.008 * std::pow(ratio, static_cast<double>(i) / std::max(1, n_tread - 1)) / weight);
        column.conductivity.push_back(0.40);
    }
    for (int i = 0; i < n_carcass; ++i) {
        column.thickness.push_back(0.004 / n_carcass);
        column.conductivity.push_back(0.30);
    }
    return column;
}

DirtyTrace drive_dirty_tire(const DirtyTire& tire, const DirtyDrive& drive) {
    // Without asymmetry all columns are alike: one stands for them.
    const bool alike = tire.asymmetry == 0.0;
    const std::size_t n_columns = alike ? 1 : 3;
    const std::size_t crown = alike ? 0 : 1;
    const double T_start = drive.air_temperature.front();
    std::vector<Cells> cells;
    std::vector<std::vector<double>> T;
    for (std::size_t c = 0; c < n_columns; ++c) {
        cells.push_back(cells_of(tire.column, alike ? 1.0 : column_share[c]));
        std::vector<double> start(cells[c].capacity.size(), T_start + tire.shift_bulk);
        for (std::size_t i = 0; i < cells[c].first_bulk; ++i) {
            start[i] = T_start + tire.shift_surface;
        }
        T.push_back(start);
    }
    std::vector<std::vector<double>> before = T;
    std::vector<std::vector<double>> middle = T;
    const std::size_t n_cells = T.front().size();
    std::vector<double> G(n_cells - 1);
    std::vector<double> q(n_cells);
    // The starts that the cases free: that of all layers shifts gas and rim too, those of two nodes do not.
    double gas = T_start + (tire.column.bulk_from > 0.005 ? tire.shift_bulk : 0.0);
    double rim = gas;
    double gas_before = gas;
    double rim_before = rim;
    DirtyTrace trace;
    const auto record = [&] {
        for (std::size_t place = 0; place < 3; ++place) {
            const std::vector<double>& column = T[alike ? 0 : place];
            // The outer face lies half a cell further out.
            trace.surface[place].push_back(tire.column.lumps ? column[0] : 1.5 * column[0] - 0.5 * column[1]);
        }
        const std::vector<double>& column = T[crown];
        trace.bulk.push_back(bulk_of(cells[crown], column));
        std::size_t i = 0;
        while (i + 2 < n_cells && cells[crown].depth[i + 1] < 0.010) {
            ++i;
        }
        const double share = (0.010 - cells[crown].depth[i]) / (cells[crown].depth[i + 1] - cells[crown].depth[i]);
        trace.probe.push_back(tire.column.lumps ? column[1] : column[i] + share * (column[i + 1] - column[i]));
        trace.liner.push_back(column.back());
        trace.gas.push_back(gas);
    };
    record();
    for (std::size_t s = 0; s + 1 < drive.size(); ++s) {
        const Now in = at(drive, (static_cast<double>(s) + 0.5) * dirty_step);
        const double gas_middle = 1.5 * gas - 0.5 * gas_before;
        const double rim_middle = 1.5 * rim - 0.5 * rim_before;
        double T_bulk = 0.0;
        double to_gas = 0.0;
        double to_rim = tire.gas_rim * (gas_middle - rim_middle);
        for (std::size_t c = 0; c < n_columns; ++c) {
            for (std::size_t i = 0; i < n_cells; ++i) {
                middle[c][i] = 1.5 * T[c][i] - 0.5 * before[c][i];
            }
            T_bulk += (alike ? 1.0 : column_share[c]) * bulk_of(cells[c], middle[c]);
        }
        const double made = loss(tire, in, T_bulk);
        const double sliding = in.V * std::tan(std::abs(in.alpha));
        const double friction =
            in.Fz > 1.0 ? 0.6 * tire.lambda_y * (1.0 + tire.partition_slope * sliding) * std::abs(in.Fy) * sliding
                        : 0.0;
        const double S_contact = in.Fz > 1.0 ? 2.333e-6 * in.Fz : 0.0;
        const double to_air = film(tire, in.V) * (area - S_contact);
        const double to_road = 500.0 * S_contact + contact_in_revolutions(tire, in);
        for (std::size_t c = 0; c < n_columns; ++c) {
            const double share = alike ? 1.0 : column_share[c];
            const double skew = alike || c == 1 ? 1.0 : c == 0 ? 1.0 + tire.asymmetry : 1.0 - tire.asymmetry;
            const std::vector<double>& at_middle = middle[c];
            for (std::size_t i = 0; i < n_cells; ++i) {
                q[i] = share * skew * made * cells[c].capacity[i] / cells[c].total;
                if (i >= cells[c].first_bulk) {
                    q[i] +=
                        share * tire.cornering * in.Fy * in.Fy * in.V * cells[c].capacity[i] / cells[c].bulk_capacity;
                }
            }
            const double Ts = tire.column.lumps ? at_middle[0] : 1.5 * at_middle[0] - 0.5 * at_middle[1];
            q[0] += share * (skew * friction + to_air * (in.T_air - Ts) + to_road * (in.T_road - Ts) +
                             tire.emissivity * stefan_boltzmann * area * (std::pow(in.T_air, 4) - std::pow(Ts, 4)));
            const double inner = at_middle.back();
            const double into_gas = share * tire.liner * (inner - gas_middle);
            const double into_rim = share * tire.bead * (inner - rim_middle);
            q.back() += share * tire.sidewall * (in.T_air - inner) - into_gas - into_rim;
            to_gas += into_gas;
            to_rim += into_rim;
            before[c] = T[c];
            links(tire, cells[c], at_middle, share, G);
            step(cells[c], G, q, T[c]);
        }
        gas_before = gas;
        rim_before = rim;
        // Where no rim is heated it stands at the air's temperature.
        const bool has_rim = tire.bead > 0.0;
        gas += dirty_step * (to_gas - tire.gas_rim * (gas_middle - (has_rim ? rim_middle : in.T_air))) / gas_capacity;
        rim = has_rim ? rim + dirty_step *
                                  (to_rim + tire.brake_share * in.brake + tire.rim_cooling * (in.T_air - rim_middle)) /
                                  rim_capacity
                      : in.T_air;
        record();
    }
    return trace;
}

}  // namespace hidden_effects
