#include "input/model/channel_value.hpp"

#include "input/text/wanted.hpp"

namespace tiretherm::input {

Wanted wanted_value(solver::Quantity quantity) {
    return quantity == solver::Quantity::temperature ? wanted::temperature : Wanted{.unit = unit_of(quantity)};
}

Wanted wanted_deviation(solver::Quantity quantity) {
    return {.unit = unit_of(quantity), .scale = Scale::difference, .low = 0.0, .above = true};
}

}  // namespace tiretherm::input
