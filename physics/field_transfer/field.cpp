// SPDX-License-Identifier: BSD-3-Clause
// Linear interpolation in time between the frames of a field, held beyond the first and the last.

#include "physics/field_transfer/field.hpp"

#include <algorithm>

namespace tiretherm::physics {

void Field::shares_at(double moment, std::span<double> out) const {
    std::ranges::fill(out, 0.0);
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(time, moment) - time.begin());
    if (next == 0 || next == time.size()) {
        out[next == 0 ? 0 : next - 1] = 1.0;
        return;
    }
    const double share = (moment - time[next - 1]) / (time[next] - time[next - 1]);
    out[next - 1] = 1.0 - share;
    out[next] = share;
}

void Field::watts_at(double moment, std::span<double> out) const {
    shares_at(moment, out);
    for (std::size_t k = 0; k < frames(); ++k) {
        out[k] *= watts[k];
    }
}

}  // namespace tiretherm::physics
