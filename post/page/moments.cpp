// SPDX-License-Identifier: BSD-3-Clause
// Thins moments to what a page holds, and packs their values.
#include "post/page/moments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "post/page/charts.hpp"
#include "post/report/base64.hpp"

namespace tiretherm::post {

namespace {

constexpr std::size_t values_on_a_page = 500'000;  ///< 1.3 MB as text
constexpr double steps = 65535.0;

/// Lowest and highest value of all moments. degC
std::pair<double, double> range_of(const std::vector<Moment>& shown) {
    double low = 1e300;
    double high = -1e300;
    const auto include = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const Moment& moment : shown) {
        std::ranges::for_each(moment.celsius, include);
        if (moment.mark) {
            include((*moment.mark)[2]);
        }
    }
    return {low, high};
}

}  // namespace

void Moments::take(Moment moment) {
    if (seen_++ % stride_ == 0) {
        moments_.push_back(moment);
        thin();
    }
    last_ = std::move(moment);
}

void Moments::thin() {
    const std::size_t most = std::clamp<std::size_t>(values_on_a_page / moments_.front().celsius.size(), 2, 120);
    if (moments_.size() <= most) {
        return;
    }
    std::vector<Moment> kept;
    for (std::size_t i = 0; i < moments_.size(); i += 2) {
        kept.push_back(std::move(moments_[i]));
    }
    moments_ = std::move(kept);
    stride_ *= 2;
}

std::vector<Moment> Moments::shown() const {
    std::vector<Moment> all = moments_;
    for (const Moment* extra : {&first(), &last_}) {
        if (std::ranges::find(all, extra->time, &Moment::time) == all.end()) {
            all.push_back(*extra);
        }
    }
    std::ranges::sort(all, {}, &Moment::time);
    return all;
}

Value Moments::data(const std::vector<Moment>& shown) const {
    const auto [low, high] = range_of(shown);
    const TimeUnit unit = time_unit(shown.back().time - shown.front().time);
    std::vector<unsigned char> bytes;
    Value::List times;
    Value::List marks;
    for (const Moment& moment : shown) {
        for (const float celsius : moment.celsius) {
            const double share = (static_cast<double>(celsius) - low) / std::max(high - low, 1e-9);
            const auto step = static_cast<std::uint16_t>(std::lround(steps * share));
            bytes.push_back(static_cast<unsigned char>(step & 0xFFU));
            bytes.push_back(static_cast<unsigned char>(step >> 8U));
        }
        times.emplace_back(rounded(moment.time / unit.seconds));
        if (moment.mark) {
            const auto [x, y, celsius] = *moment.mark;
            marks.emplace_back(Value::List{x, y, rounded(celsius, 7)});
        }
    }
    const auto hottest = std::ranges::find(shown, first().time, &Moment::time) - shown.begin();
    return {{"times", std::move(times)}, {"time_unit", unit.name}, {"low", rounded(low, 7)},
            {"high", rounded(high, 7)},  {"hottest", hottest},     {"marks", std::move(marks)},
            {"values", base64(bytes)}};
}

}  // namespace tiretherm::post
