// SPDX-License-Identifier: BSD-3-Clause
// A tire as three columns (two shoulders and a crown) with gas, rim and brake, richer than the models that are fitted to it.
#pragma once

#include <cstddef>
#include <vector>

#include "dirty/dirty_drive_truth.hpp"

namespace hidden_effects {

/// How a column is cut: cells from the outside in, or two lumps with a link.
struct DirtyColumn {
    bool lumps = false;
    std::vector<double> thickness;     ///< m, of the cells
    std::vector<double> conductivity;  ///< W/mK at 20 degC, of the cells; of the link for lumps
    double slope = 0.0;                ///< W/mK/K, over the conductivity at 20 degC: 1/K
    double bulk_from = 0.0;            ///< m, depth below which rubber counts as bulk
};

/// Numbers of the tire. The defaults are those of the base models: nothing hidden.
struct DirtyTire {
    DirtyColumn column;
    double lambda_h = 1.0;
    double lambda_sel = 1.0;
    double lambda_y = 1.0;
    double shift_surface = 0.0;  ///< K, start over the first air temperature
    double shift_bulk = 0.0;     ///< K

    double sidewall = 0.0;                  ///< W/K
    double liner = 0.0, gas_rim = 0.0;      ///< W/K
    double bead = 0.0, rim_cooling = 10.0;  ///< W/K
    double brake_share = 0.0;               ///< of the brake's power, into the rim
    double emissivity = 0.0;                ///< of radiation
    double cornering = 0.0;                 ///< 1/N
    double wave = 0.0, critical = 150.0;    ///< 1/(km/h)^2, km/h
    double load_exponent = 0.0;
    double loss_slope = 0.0;  ///< 1/K
    double film_exponent = 0.571;
    double partition_slope = 0.0;       ///< s/m
    double contact = 0.0;               ///< scale of the contact in revolutions
    double carcass_conductivity = 1.0;  ///< factor on the link, or on the rubber below bulk_from
    double asymmetry = 0.0;             ///< of the shoulders' heat
};

/// Temperatures at every dirty_step, K. Places: 0 inside shoulder, 1 crown, 2 outside shoulder.
struct DirtyTrace {
    std::vector<double> surface[3];
    std::vector<double> bulk;   ///< mean of the crown's bulk
    std::vector<double> probe;  ///< at 10 mm of the crown
    std::vector<double> liner;  ///< innermost of the crown
    std::vector<double> gas;
};

/// Two lumps of 15 % and 85 % with a link of k(T_bulk) over 10 mm, as in two_node_bench.
[[nodiscard]] DirtyColumn dirty_lumps();
/// The same rubber as cells, as warm inside in the mean at 60 degC.
[[nodiscard]] DirtyColumn dirty_cells_of_lumps();
/// Tread and carcass of layers_bench. @param tread, carcass cells; growing from the outside in when there are many
[[nodiscard]] DirtyColumn dirty_layers(int tread, int carcass, double ratio);

[[nodiscard]] DirtyTrace drive_dirty_tire(const DirtyTire& tire, const DirtyDrive& drive);

}  // namespace hidden_effects
