// SPDX-License-Identifier: BSD-3-Clause
// Cuts a record at its jumps, and judges the pieces by whether they live and by what is on either side of them.

#include "input/measurements/dead_stretches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

/// What a measured quantity does not do from one sample to the next.
struct Movement {
    std::string_view si;
    double jump = 0.0;  ///< a smaller one is none
    double rate = 0.0;  ///< per s; a slower one is none
    double flat = 0.0;  ///< range of what stands still
    double low = 0.0;   ///< what lies beyond is of no tire, road or air
    double high = 0.0;
    double longest = std::numeric_limits<double>::infinity();      ///< s; what is longer may be meant
    bool at_ends = true;                                           ///< a record may begin or end with it
    std::size_t steady = std::numeric_limits<std::size_t>::max();  ///< samples: what stands for longer is measured, too
};
// A tire's surface gains some 50 K/s in a burnout, and goes on; a car brakes with 5 g at most and does not speed up with 1.5 g.
// A schedule stands, too, and for longer than a receiver is lost. The air's temperature stands in many samples of a logger, in
// steps of 1 degC.
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array movements{
    Movement{"K", 8.0, 5.0, 0.5, zero_celsius - 39.5, zero_celsius + 400.0, infinite, true, 100},
    Movement{"m s-1", 3.0, 15.0, 0.5, -150.0, 150.0, 30.0, false}};
constexpr double aftermath = 0.25;              ///< of the jump: the largest step after one that was measured is larger
constexpr std::size_t aftermath_samples = 10;   ///< beside a jump
constexpr double slowest_jump = 2.0;            ///< s between its samples: in a longer time a laser heats by anything
constexpr std::size_t least_at_end = 2;         ///< samples, at the start or the end of a record
constexpr std::size_t least_live = 3;           ///< samples
constexpr double constant_share = 0.2;          ///< of the samples: a record that stands for longer may be meant
constexpr std::size_t changes_of_measured = 5;  ///< in what is measured; what somebody wrote by hand has fewer
constexpr std::size_t least_dead = 3;           ///< samples, in the middle of a record: what is shorter is an outlier
constexpr double shortest_dead = 0.5;           ///< s, likewise
constexpr double comes_back = 0.5;   ///< of the smaller jump: the distance between where it left and came back
constexpr double most_jumps = 0.05;  ///< of the samples

/// A part of the record between two jumps.
struct Piece {
    std::size_t first = 0;
    std::size_t end = 0;  ///< one past the last
    bool is_flat = false;
    std::size_t changes = 0;  ///< from one sample to the next

    [[nodiscard]] std::size_t size() const { return end - first; }
};

class WatchedChannel {
public:
    WatchedChannel(const std::vector<double>& time, const std::vector<double>& value, const Movement& movement,
                   const Happens& happens)
        : time_(time), value_(value), movement_(movement), happens_(happens) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (i == 0 || jumps_to(i)) {
                pieces_.push_back({.first = i, .end = i});
            }
            pieces_.back().end = i + 1;
        }
        for (Piece& piece : pieces_) {
            measure(piece);
        }
    }

    [[nodiscard]] std::vector<Stretch> dead() const {
        std::vector<Stretch> found;
        if (static_cast<double>(pieces_.size() - 1) > std::max(2.0, most_jumps * static_cast<double>(value_.size()))) {
            return found;
        }
        const auto lives = [&](const Piece& piece) {
            return piece.size() >= least_live && !is_beyond(piece) &&
                   (!piece.is_flat ||
                    static_cast<double>(piece.size()) >= constant_share * static_cast<double>(value_.size()));
        };
        for (std::size_t p = 0; p < pieces_.size();) {
            if (lives(pieces_[p])) {
                ++p;
                continue;
            }
            const std::size_t first = p;
            while (p < pieces_.size() && !lives(pieces_[p])) {
                ++p;
            }
            if (is_dead(first, p)) {
                found.push_back({.first = pieces_[first].first, .length = pieces_[p - 1].end - pieces_[first].first});
            }
        }
        return found;
    }

private:
    [[nodiscard]] bool jumps_to(std::size_t i) const {
        const double step = std::abs(value_[i] - value_[i - 1]);
        const double interval = time_[i] - time_[i - 1];  // 0: a schedule says so
        return interval > 0.0 && interval <= slowest_jump && step >= movement_.jump &&
               step >= movement_.rate * interval;
    }
    /// Whether a piece stands where nothing measured is.
    [[nodiscard]] bool is_beyond(const Piece& piece) const {
        return piece.is_flat && (value_[piece.first] < movement_.low || value_[piece.first] > movement_.high);
    }
    void measure(Piece& piece) const {
        const auto begin = value_.begin() + static_cast<std::ptrdiff_t>(piece.first);
        const auto end = value_.begin() + static_cast<std::ptrdiff_t>(piece.end);
        const auto [low, high] = std::minmax_element(begin, end);
        piece.is_flat = *high - *low <= movement_.flat;
        for (std::size_t i = piece.first + 1; i < piece.end; ++i) {
            piece.changes += value_[i] != value_[i - 1] ? 1 : 0;
        }
    }
    /// Whether the record goes on without an aftermath beside a jump. @param from the sample there  @param step 1 or -1
    [[nodiscard]] bool goes_on(std::size_t from, int step, const Piece& live, double jump) const {
        auto at = static_cast<std::ptrdiff_t>(from);
        double largest = 0.0;
        for (std::size_t n = 0; n < aftermath_samples; ++n, at += step) {
            const std::ptrdiff_t next = at + step;
            if (next < static_cast<std::ptrdiff_t>(live.first) || next >= static_cast<std::ptrdiff_t>(live.end)) {
                break;
            }
            largest = std::max(largest,
                               std::abs(value_[static_cast<std::size_t>(next)] - value_[static_cast<std::size_t>(at)]));
        }
        return largest <= aftermath * jump;
    }
    /// Whether the pieces from one on and before another, none of which lives, are no reading.
    [[nodiscard]] bool is_dead(std::size_t begin, std::size_t end) const {
        const bool at_start = begin == 0;
        const bool at_end = end == pieces_.size();
        const std::size_t first = pieces_[begin].first;
        const std::size_t last = pieces_[end - 1].end - 1;
        const double before = at_start ? 0.0 : std::abs(value_[first] - value_[first - 1]);
        const double after = at_end ? 0.0 : std::abs(value_[last + 1] - value_[last]);
        const bool may_be = (at_start || at_end) ? movement_.at_ends && !(at_start && at_end)
                                                 : time_[last] - time_[first] <= movement_.longest;
        const bool none_has_it = is_beyond(pieces_[begin]);
        const auto is_measured = [&](const Piece& live) {
            return none_has_it || live.changes >= changes_of_measured || live.size() >= movement_.steady;
        };
        if (!may_be || (!at_start && !is_measured(pieces_[begin - 1])) || (!at_end && !is_measured(pieces_[end])) ||
            (!at_start && happens_(time_[first - 1], time_[first])) ||
            (!at_end && happens_(time_[last], time_[last + 1])) ||
            (!at_start && !goes_on(first - 1, -1, pieces_[begin - 1], before)) ||
            (!at_end && !goes_on(last + 1, 1, pieces_[end], after))) {
            return false;
        }
        if (at_start || at_end) {
            return last - first + 1 >= least_at_end;
        }
        return (last - first + 1 >= least_dead && time_[last] - time_[first] >= shortest_dead &&
                std::abs(value_[last + 1] - value_[first - 1]) < comes_back * std::min(before, after));
    }

    const std::vector<double>& time_;
    const std::vector<double>& value_;
    const Movement& movement_;
    const Happens& happens_;
    std::vector<Piece> pieces_;
};

std::string shown(double value, std::string_view si) {
    return si == "K" ? fmt::format("{} degC", three_digits(celsius(value)))
                     : fmt::format("{} km/h", three_digits(value * 3.6));
}

std::string shown_jump(double jump, std::string_view si) {
    return si == "K" ? fmt::format("{} K", three_digits(jump)) : shown(jump, si);
}

}  // namespace

std::vector<Stretch> dead_stretches(const std::vector<double>& time, const std::vector<double>& value,
                                    std::string_view si, const Happens& happens) {
    const auto movement = std::ranges::find(movements, si, &Movement::si);
    if (movement == movements.end() || value.size() < least_live + 1) {
        return {};
    }
    return WatchedChannel(time, value, *movement, happens).dead();
}

std::string sentence_of_dead(const std::vector<Stretch>& dead, const std::vector<double>& time,
                             const std::vector<double>& value, std::string_view si) {
    const Stretch& longest = *std::ranges::max_element(dead, {}, &Stretch::length);
    const std::size_t last = longest.first + longest.length - 1;
    const std::size_t before = longest.first > 0 ? longest.first : last + 1;
    const double jump = std::abs(value[before] - value[before - 1]);
    const std::string more = dead.size() == 1 ? "" : fmt::format("; so do {} more stretches", dead.size() - 1);
    return fmt::format(
        "stands at {} from {:.6g} s to {:.6g} s and jumps by {} in {:.2g} s, which nothing measured does{}",
        shown(value[longest.first], si), time[longest.first], time[last], shown_jump(jump, si),
        time[before] - time[before - 1], more);
}

std::string remove_dead(const std::vector<double>& time, std::vector<double>& value, std::string_view si,
                        const Happens& happens) {
    const auto remove = [&](const std::vector<double>& at, const std::vector<double>& known, const auto& row) {
        const std::vector<Stretch> dead = dead_stretches(at, known, si, happens);
        std::string sentence = dead.empty() ? std::string() : sentence_of_dead(dead, at, known, si);
        for (const Stretch& stretch : dead) {
            for (std::size_t k = stretch.first; k < stretch.first + stretch.length; ++k) {
                value[row(k)] = std::numeric_limits<double>::quiet_NaN();
            }
        }
        return sentence;
    };
    if (std::ranges::all_of(value, [](double v) { return std::isfinite(v); })) {
        return remove(time, value, [](std::size_t k) { return k; });
    }
    std::vector<double> known_time;
    std::vector<double> known;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (std::isfinite(value[i])) {
            known_time.push_back(time[i]);
            known.push_back(value[i]);
            index.push_back(i);
        }
    }
    return remove(known_time, known, [&](std::size_t k) { return index[k]; });
}

}  // namespace tiretherm::input
