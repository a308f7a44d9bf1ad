// SPDX-License-Identifier: BSD-3-Clause
// Unit and range for the value and the standard deviation of each kind of quantity.

#include "input/model/channel_value.hpp"

#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

QuantitySpec value_spec(solver::Quantity quantity) {
    return quantity == solver::Quantity::temperature ? quantity_specs::temperature
                                                     : QuantitySpec{.unit = unit_of(quantity)};
}

QuantitySpec deviation_spec(solver::Quantity quantity) {
    QuantitySpec spec{.unit = unit_of(quantity), .scale = Scale::difference, .low = 0.0, .above = true};
    if (quantity == solver::Quantity::temperature) {
        spec.high = quantity_specs::tolerance.high;
    }
    return spec;
}

}  // namespace tiretherm::input
