// SPDX-License-Identifier: BSD-3-Clause
// The inputs of a run against time, and the times that its steps have to see.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "physics/signals.hpp"
#include "solver/shared_samples.hpp"

namespace tiretherm::solver {

/// Which value counts at a jump: the one before or the one after.
enum class JumpSide : std::uint8_t { before, after };

/// One input against time, linear between its points and held beyond them. Two points at the same time are a jump.
struct Series {
    const physics::Signal* signal = nullptr;
    SharedSamples time;   ///< s, not descending
    SharedSamples value;  ///< SI
    bool logged = false;  ///< a logger's samples, which do not bound the step; otherwise a schedule, which does

    [[nodiscard]] double at(double t, JumpSide side) const;
};

/// All input signals of a run. A signal without a series keeps the value of Inputs{} unless `add` gave a constant.
class InputSignals {
public:
    void add(const physics::Signal& signal, double constant);
    void add(Series series);
    /// The same in the place of what is given for this signal; steps still end where that had its points.
    void replace(Series series);

    /// Times a step must end on though no input has a point there: jumps of signals that are no inputs. @param times s
    void add_break_times(SharedSamples times);
    /// Times between which the inputs, and what follows from them, are averaged in pieces as between the samples of a
    /// log: those of a user's signal, or of a field that follows time. @param times s
    void add_sample_times(SharedSamples times);

    /// Takes what a series says a time later, now: of a log that is late. A log is read off at its own samples, between them by
    /// straight lines; the points of a schedule move. @param delay s; negative: the log is early
    void advance(const physics::Signal& signal, double delay);

    /// Takes each value `factor` times and `by` added, in all of its course. @param by SI
    void move(const physics::Signal& signal, double factor, double by);

    /// The run's start, from which effects that drift count. @param t s
    void start_at(double t) { start_ = t; }

    [[nodiscard]] bool gives(const physics::Signal& signal) const;
    [[nodiscard]] physics::Inputs at(double t, JumpSide side) const;
    /// Times a step must end on: points of schedules, jumps of logged series, break times. Ascending, unique.
    [[nodiscard]] const std::vector<double>& stops() const { return stops_; }
    /// Times of logged samples of any series, and sample times. Ascending, unique.
    [[nodiscard]] const std::vector<double>& samples() const { return samples_; }
    [[nodiscard]] std::span<const Series> series() const { return series_; }
    [[nodiscard]] const physics::Inputs& constants() const { return constants_; }
    /// Calls take(member) for all that the inputs are made of: does not compile where one is forgotten.
    template <typename Take>
    void visit_members(const Take& take) const {
        const auto& [constants, start, given, series, stops, samples] = *this;
        (take(constants), take(start), take(given), take(series), take(stops), take(samples));
    }

private:
    physics::Inputs constants_;
    double start_ = 0.0;
    std::vector<const physics::Signal*> given_;
    std::vector<Series> series_;
    SharedSamples stops_;
    SharedSamples samples_;
};

}  // namespace tiretherm::solver
