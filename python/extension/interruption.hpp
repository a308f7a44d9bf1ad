// SPDX-License-Identifier: BSD-3-Clause
// How a call that runs without the GIL is ended: by Ctrl-C in the main thread, by `stop` in any.
#pragma once

#include <csignal>

namespace tiretherm::python {

/// While it lives, a call of the libraries can be stopped. Ctrl-C, where it is asked for, sets a flag instead of being Python's, and
/// Python's handler is back at the end. What asks for an end ends all calls that are under way.
class Interruption {
public:
    /// @param by_signal in the main thread alone, which is the one that Python's signals belong to
    explicit Interruption(bool by_signal);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Whether Ctrl-C has come since it began.
    [[nodiscard]] bool was_signalled() const;

private:
    bool by_signal_;
    struct sigaction before_ {};
};

/// Asks for the end of all calls that are under way.
void stop();

}  // namespace tiretherm::python
