// SPDX-License-Identifier: BSD-3-Clause
// Regular end of a command on Ctrl-C or SIGTERM.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <limits>

namespace tiretherm::solver {

/// From now on Ctrl-C (SIGINT) and SIGTERM request a regular end; the second signal ends the program at once.
void install_stop_handlers();

/// What asks for an end.
struct StopRequest {
    std::atomic<bool> asked = false;
    std::atomic<std::int64_t> deadline = std::numeric_limits<std::int64_t>::max();  ///< ns of the steady clock
};

/// How one of several computations in a program is ended, while the others go on. While it lives, what its thread does belongs to it, with
/// the tasks that this thread shares out.
class StopScope {
public:
    StopScope();
    ~StopScope();
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

    /// Asks for its end, from any thread or from the handler of a signal.
    void ask() { request_.asked = true; }

private:
    StopRequest request_;
    void* around_;  ///< what the thread belongs to when this one has ended
};

/// Whether the user has asked for an end, of the program or of the present scope, or the time is up.
[[nodiscard]] bool stop_requested();

/// From so many seconds on, counted from now, an end counts as asked for: of the present scope, or else of the program.
/// @param seconds of wall time; infinite: never
void stop_after(double seconds);
/// Whether the time of `stop_after` is up and nobody asked.
[[nodiscard]] bool is_time_up();

/// The user has asked for an end: leaves a computation of many simulations, whose caller says what it was.
class Interrupted : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

/// @errors Interrupted when the user has asked for an end
void leave_if_stopped();

/// While it lives, the readers of this thread give up when the user asks for an end. Without it they go on to their end:
/// what is read again late in a call, beside results that are still to be written, is not given up.
class InterruptibleReading {
public:
    InterruptibleReading();
    ~InterruptibleReading();
    InterruptibleReading(const InterruptibleReading&) = delete;
    InterruptibleReading& operator=(const InterruptibleReading&) = delete;
};

/// For every loop of a reader over lines, columns or files. @errors Interrupted, see InterruptibleReading
void leave_reading_if_stopped();

}  // namespace tiretherm::solver
