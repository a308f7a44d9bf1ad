// SPDX-License-Identifier: BSD-3-Clause
// A child made by fork, with a pipe for its answer and limits of its own.

#include "input/hdf5/own_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>

#include "solver/stop_signal.hpp"

namespace tiretherm::input {

namespace {

bool write_all(int file, const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t now = write(file, bytes.data() + done, bytes.size() - done);
        if (now < 0 && errno != EINTR) {
            return false;
        }
        done += now > 0 ? static_cast<std::size_t>(now) : 0;
    }
    return true;
}

/// A child that is ended and waited for when it goes, whatever has come of it.
class Child {
public:
    Child(pid_t process, int pipe) : process_(process), pipe_(pipe) {}
    ~Child() {
        close(pipe_);
        if (process_ > 0) {
            kill(process_, SIGKILL);
            static_cast<void>(status());
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// All that it writes until it closes its end. @returns nothing where that takes longer
    [[nodiscard]] std::optional<std::string> output(std::chrono::seconds longest) const {
        constexpr int tick = 50;  // ms, between two looks at the clock and the stop signal
        const auto end = std::chrono::steady_clock::now() + longest;
        std::string bytes;
        std::array<char, 65536> piece{};
        while (std::chrono::steady_clock::now() < end) {
            solver::leave_reading_if_stopped();
            pollfd ready{.fd = pipe_, .events = POLLIN, .revents = 0};
            if (poll(&ready, 1, tick) <= 0) {
                continue;
            }
            const ssize_t now = read(pipe_, piece.data(), piece.size());
            if (now > 0) {
                bytes.append(piece.data(), static_cast<std::size_t>(now));
            } else if (now == 0 || errno != EINTR) {
                return bytes;
            }
        }
        return std::nullopt;
    }

    /// Waits for its end. @returns how that was, as waitpid says it
    int status() {
        int status = 0;
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        return status;
    }

private:
    pid_t process_;
    int pipe_;
};

// Not a recursive mutex: that knows its owner by a number which is another one in a child.
std::mutex turns;
thread_local int turns_of_thread = 0;

pid_t fork_between_turns() {
    const LibraryTurn turn;
    return fork();
}

[[noreturn]] void answer(int pipe, const std::function<std::string()>& work, unsigned cpu_seconds) {
    const rlimit no_core{.rlim_cur = 0, .rlim_max = 0};
    const rlimit time{.rlim_cur = cpu_seconds, .rlim_max = cpu_seconds + 1};
    setrlimit(RLIMIT_CORE, &no_core);
    setrlimit(RLIMIT_CPU, &time);
    if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        dup2(nowhere, STDERR_FILENO);
    }
    bool done = false;
    try {
        done = write_all(pipe, work());
    } catch (...) {
        done = false;  // told by the exit code
    }
    _exit(done ? 0 : 1);  // without destructors, which are the parent's to run
}

}  // namespace

LibraryTurn::LibraryTurn() {
    if (turns_of_thread++ == 0) {
        turns.lock();
    }
}

LibraryTurn::~LibraryTurn() {
    if (--turns_of_thread == 0) {
        turns.unlock();
    }
}

std::optional<std::string> in_own_process(const std::function<std::string()>& work, unsigned cpu_seconds) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        return work();  // no further process: the work is done in this one
    }
    const pid_t child = fork_between_turns();
    if (child == 0) {
        answer(ends[1], work, cpu_seconds);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return work();
    }
    Child running(child, ends[0]);
    std::optional<std::string> bytes = running.output(std::chrono::seconds(4 * cpu_seconds));
    if (!bytes) {
        return std::nullopt;
    }
    const int status = running.status();
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::move(bytes) : std::nullopt;
}

}  // namespace tiretherm::input
