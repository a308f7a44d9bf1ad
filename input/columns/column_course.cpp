// SPDX-License-Identifier: BSD-3-Clause
// Statistics of the courses of columns, on samples of all runs.

#include "input/columns/column_course.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t least_pairs = 20;
constexpr double copied = 0.9999;
constexpr double even = 0.999;     ///< correlation with time or distance of what counts
constexpr double jump_back = 0.3;  ///< of its range; a smaller fall is no counter's
constexpr std::size_t least_rises = 10;
constexpr std::size_t rises_a_tooth = 4;
constexpr std::size_t least_levels = 20;
constexpr double of_a_function = 1e-4;  ///< roughness along the input
constexpr double apart = 0.05;          ///< of the samples, between neighbours along an input that comes back

}  // namespace

std::size_t n_levels(const Course& course, std::size_t most) {
    std::set<double> levels;
    for (const double value : course.value) {
        if (std::isfinite(value) && levels.insert(value).second && levels.size() >= most) {
            break;
        }
    }
    return levels.size();
}

bool is_constant(const Course& course) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const double value : course.value) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    return !(high - low > 1e-6 * std::max(std::abs(low), std::abs(high)));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double mean_a = 0.0;
    double mean_b = 0.0;
    std::size_t n = 0;
    const std::size_t size = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < size; ++i) {
        if (std::isfinite(a[i]) && std::isfinite(b[i])) {
            ++n;
            mean_a += (a[i] - mean_a) / static_cast<double>(n);
            mean_b += (b[i] - mean_b) / static_cast<double>(n);
        }
    }
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        if (std::isfinite(a[i]) && std::isfinite(b[i])) {
            aa += (a[i] - mean_a) * (a[i] - mean_a);
            bb += (b[i] - mean_b) * (b[i] - mean_b);
            ab += (a[i] - mean_a) * (b[i] - mean_b);
        }
    }
    return n < least_pairs || !(aa > 0.0) || !(bb > 0.0) ? 0.0 : ab / std::sqrt(aa * bb);
}

Course detrended(const Course& course) {
    Course result = course;
    for (std::size_t r = 0; r + 1 < course.first.size(); ++r) {
        double n = 0.0;
        double mean_x = 0.0;
        double mean_y = 0.0;
        const auto each = [&](auto what) {
            for (std::size_t i = course.first[r]; i < course.first[r + 1]; ++i) {
                if (std::isfinite(course.value[i])) {
                    what(static_cast<double>(i), course.value[i]);
                }
            }
        };
        each([&](double x, double y) {
            n += 1.0;
            mean_x += (x - mean_x) / n;
            mean_y += (y - mean_y) / n;
        });
        double xx = 0.0;
        double xy = 0.0;
        each([&](double x, double y) {
            xx += (x - mean_x) * (x - mean_x);
            xy += (x - mean_x) * (y - mean_y);
        });
        const double slope = xx > 0.0 ? xy / xx : 0.0;
        for (std::size_t i = course.first[r]; i < course.first[r + 1]; ++i) {
            result.value[i] -= mean_y + slope * (static_cast<double>(i) - mean_x);
        }
    }
    return result;
}

std::vector<double> standardised(const std::vector<double>& value) {
    double n = 0.0;
    double mean = 0.0;
    for (const double v : value) {
        if (std::isfinite(v)) {
            n += 1.0;
            mean += (v - mean) / n;
        }
    }
    double square = 0.0;
    for (const double v : value) {
        square += std::isfinite(v) ? (v - mean) * (v - mean) : 0.0;
    }
    const double deviation = square > 0.0 ? std::sqrt(square / n) : 1.0;
    std::vector<double> result(value.size());
    std::ranges::transform(value, result.begin(), [&](double v) { return (v - mean) / deviation; });
    return result;
}

bool is_copy(const std::vector<double>& a, const std::vector<double>& b) {
    // The mean square of the difference of what is standardised is 2 (1 - r). Missing samples leave it that to rounding, so
    // twice that is where it is given up, and the correlation itself decides.
    const std::size_t n = std::min(a.size(), b.size());
    const double limit = 4.0 * (1.0 - copied) * static_cast<double>(n);
    double same = 0.0;
    double opposite = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        if (std::isfinite(a[i]) && std::isfinite(b[i])) {
            same += (a[i] - b[i]) * (a[i] - b[i]);
            opposite += (a[i] + b[i]) * (a[i] + b[i]);
            if (same > limit && opposite > limit) {
                return false;
            }
        }
    }
    return std::abs(correlation(a, b)) > copied;
}

Lead lead_of(const Course& column, const Course& sensor) {
    std::size_t shortest = column.value.size();
    for (std::size_t r = 0; r + 1 < column.first.size(); ++r) {
        shortest = std::min(shortest, column.first[r + 1] - column.first[r]);
    }
    const auto longest = static_cast<int>(shortest / 10);
    const auto at = [&](int shift) {
        std::vector<double> later(sensor.value.size(), NAN);
        for (std::size_t r = 0; r + 1 < sensor.first.size(); ++r) {
            const auto begin = static_cast<std::ptrdiff_t>(sensor.first[r]);
            const auto end = static_cast<std::ptrdiff_t>(sensor.first[r + 1]);
            for (std::ptrdiff_t i = std::max(begin, begin - shift); i < std::min(end, end - shift); ++i) {
                later[static_cast<std::size_t>(i)] = sensor.value[static_cast<std::size_t>(i + shift)];
            }
        }
        return correlation(column.value, later);
    };
    Lead best{.correlation = at(0), .together = 0.0};
    best.together = best.correlation;
    for (int shift = 1; shift <= longest; shift += std::max(1, shift / 4)) {
        for (const int one : {shift, -shift}) {
            if (const double found = at(one); std::abs(found) > std::abs(best.correlation)) {
                best.correlation = found;
                best.samples = one;
            }
        }
    }
    return best;
}

double roughness(const Course& course) {
    double steps = 0.0;
    std::size_t n_steps = 0;
    double mean = 0.0;
    double squares = 0.0;
    std::size_t n = 0;
    for (std::size_t r = 0; r + 1 < course.first.size(); ++r) {
        for (std::size_t i = course.first[r]; i < course.first[r + 1]; ++i) {
            if (!std::isfinite(course.value[i])) {
                continue;
            }
            ++n;
            const double off = course.value[i] - mean;
            mean += off / static_cast<double>(n);
            squares += off * (course.value[i] - mean);
            if (i > course.first[r] && std::isfinite(course.value[i - 1])) {
                steps += (course.value[i] - course.value[i - 1]) * (course.value[i] - course.value[i - 1]);
                ++n_steps;
            }
        }
    }
    return n_steps == 0 || !(squares > 0.0)
               ? 1.0
               : (steps / static_cast<double>(n_steps)) / (2.0 * squares / static_cast<double>(n));
}

bool counts(const std::vector<std::span<const double>>& value, const std::vector<std::span<const double>>& measure) {
    double low = INFINITY;
    double high = -INFINITY;
    double net = 0.0;
    for (const std::span<const double>& run : value) {
        std::size_t rises = 0;
        std::size_t falls = 0;
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (std::isfinite(run[i])) {
                low = std::min(low, run[i]);
                high = std::max(high, run[i]);
            }
            rises += i > 0 && run[i] > run[i - 1] ? 1 : 0;
            falls += i > 0 && run[i] < run[i - 1] ? 1 : 0;
        }
        net += static_cast<double>(rises) - static_cast<double>(falls);
    }
    const double sign = net < 0.0 ? -1.0 : 1.0;
    std::vector<double> unwrapped;
    std::vector<double> against;
    std::size_t rises = 0;
    std::size_t falls = 0;
    bool ones = true;
    for (std::size_t r = 0; r < value.size(); ++r) {
        double sum = 0.0;
        double last = NAN;
        const std::size_t begin = unwrapped.size();
        for (std::size_t i = 0; i < value[r].size(); ++i) {
            if (!std::isfinite(value[r][i])) {
                continue;
            }
            const double step = std::isfinite(last) ? sign * (value[r][i] - last) : 0.0;
            last = value[r][i];
            if (step < 0.0 && -step < jump_back * (high - low)) {
                return false;
            }
            rises += step > 0.0 ? 1 : 0;
            falls += step < 0.0 ? 1 : 0;
            ones = ones && (step == 0.0 || step == 1.0);
            sum += std::max(0.0, step);
            unwrapped.push_back(sum);
            against.push_back(measure[r][i]);
        }
        // Each run about its own mean: what one begins with is no part of what it counts.
        for (std::vector<double>* all : {&unwrapped, &against}) {
            const auto from = all->begin() + static_cast<std::ptrdiff_t>(begin);
            const double mean =
                std::accumulate(from, all->end(), 0.0) / std::max(1.0, static_cast<double>(all->end() - from));
            std::for_each(from, all->end(), [&](double& v) { v -= mean; });
        }
    }
    if (ones && rises >= 3) {
        return true;
    }
    return rises >= least_rises && rises >= rises_a_tooth * (falls + 1) && correlation(unwrapped, against) > even;
}

bool is_function(const std::vector<double>& column, const std::vector<double>& input) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < column.size(); ++i) {
        if (std::isfinite(column[i]) && std::isfinite(input[i])) {
            order.push_back(i);
        }
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return input[i]; });
    if (order.size() < 2 * least_pairs) {
        return false;
    }
    Course along{.value = {}, .first = {0, order.size()}};
    Course of_input = along;
    std::vector<double> distance;
    for (std::size_t k = 0; k < order.size(); ++k) {
        along.value.push_back(column[order[k]]);
        of_input.value.push_back(input[order[k]]);
        if (k > 0) {
            distance.push_back(std::abs(static_cast<double>(order[k]) - static_cast<double>(order[k - 1])));
        }
    }
    return n_levels(of_input, least_levels) >= least_levels && n_levels(along, least_levels) >= least_levels &&
           solver::median(std::move(distance)) > apart * static_cast<double>(column.size()) &&
           roughness(along) < of_a_function;
}

}  // namespace tiretherm::input
