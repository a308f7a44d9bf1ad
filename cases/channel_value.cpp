#include "cases/channel_value.hpp"

#include "cases/wanted.hpp"

namespace tiretherm::cases {

Wanted wanted_value(solver::Quantity quantity) {
    return quantity == solver::Quantity::temperature ? wanted::temperature : Wanted{.unit = unit_of(quantity)};
}

Wanted wanted_deviation(solver::Quantity quantity) {
    return {.unit = unit_of(quantity), .scale = Scale::difference, .low = 0.0, .above = true};
}

}  // namespace tiretherm::cases
