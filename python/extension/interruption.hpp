// SPDX-License-Identifier: BSD-3-Clause
// How a call that runs without the GIL is ended: by Ctrl-C in the main thread, by `stop` in any.
#pragma once

#include <atomic>
#include <csignal>

#include "solver/stop_signal.hpp"

namespace tiretherm::python {

/// While it lives, a call of the libraries can be stopped. Ctrl-C, where it is asked for, is the call's instead of Python's, and Python's
/// handler is back at the end.
class Interruption {
public:
    /// @param by_signal in the main thread alone, which is the one that Python's signals belong to
    explicit Interruption(bool by_signal);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// From a handler, too.
    void take_signal() {
        signalled_ = true;
        scope_.ask();
    }
    [[nodiscard]] bool was_signalled() const { return signalled_; }

    /// Asks for the end of all calls that are under way.
    static void stop_all();

private:
    bool by_signal_;
    std::atomic<bool> signalled_ = false;
    Interruption* around_ = nullptr;  ///< the main thread's call that this one is made in, from its progress
    solver::StopScope scope_;
    struct sigaction before_ {};
};

}  // namespace tiretherm::python
