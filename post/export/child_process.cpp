// SPDX-License-Identifier: BSD-3-Clause
// fork and exec with two pipes that are read as they fill; the exec's own failure comes back through a third.
#include "post/export/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>

namespace tiretherm::post {

namespace {

using Clock = std::chrono::steady_clock;

/// Both ends of a pipe, closed with it.
struct Pipe {
    std::array<int, 2> end{-1, -1};

    Pipe() { failed = pipe2(end.data(), O_CLOEXEC) != 0; }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(std::size_t i) {
        if (end[i] >= 0) {
            close(end[i]);
            end[i] = -1;
        }
    }
    bool failed = false;
};

[[noreturn]] void become(const std::vector<char*>& arguments, const Pipe& out, const Pipe& err, const Pipe& failure) {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out.end[1], STDOUT_FILENO);
    dup2(err.end[1], STDERR_FILENO);
    execv(arguments.front(), arguments.data());
    const int reason = errno;
    const ssize_t ignored = write(failure.end[1], &reason, sizeof reason);
    _exit(ignored > 0 ? 127 : 126);
}

/// Takes what is there. @returns false at the end
bool drain(int file, std::string& text) {
    std::array<char, 65536> piece{};
    const ssize_t now = read(file, piece.data(), piece.size());
    if (now > 0) {
        text.append(piece.data(), static_cast<std::size_t>(now));
    }
    return now > 0 || (now < 0 && errno == EINTR);
}

/// Reads until both pipes are closed or the program has ended and nothing more comes. @returns whether it was let do that
ChildResult::End collect(pid_t child, Pipe& out, Pipe& err, ChildResult& result, int& status,
                         const std::function<bool()>& keep_on) {
    constexpr int tick = 50;  // ms
    bool ended = false;
    for (;;) {
        std::array<pollfd, 2> ends{pollfd{out.end[0], POLLIN, 0}, pollfd{err.end[0], POLLIN, 0}};
        const int ready = poll(ends.data(), ends.size(), tick);
        if (ready > 0) {
            if (ends[0].revents != 0 && !drain(out.end[0], result.out)) {
                out.close_end(0);
            }
            if (ends[1].revents != 0 && !drain(err.end[0], result.err)) {
                err.close_end(0);
            }
        }
        ended = ended || waitpid(child, &status, WNOHANG) == child;
        // Children of its own may hold the pipes open when it has ended.
        if (ended && ready <= 0) {
            return ChildResult::End::exited;
        }
        if (!keep_on()) {
            kill(-child, SIGKILL);
            while (!ended && waitpid(child, &status, 0) < 0 && errno == EINTR) {
            }
            return ChildResult::End::timed_out;
        }
    }
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& command, std::chrono::milliseconds limit,
                      const std::function<bool()>& stopped) {
    ChildResult result;
    Pipe out;
    Pipe err;
    Pipe failure;
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    const pid_t child = out.failed || err.failed || failure.failed ? -1 : fork();
    if (child == 0) {
        become(arguments, out, err, failure);
    }
    if (child < 0) {
        result.code = errno;
        return result;
    }
    setpgid(child, child);  // here and there, so that neither needs the other to be first
    out.close_end(1);
    err.close_end(1);
    failure.close_end(1);
    int reason = 0;
    if (read(failure.end[0], &reason, sizeof reason) == sizeof reason) {
        result.code = reason;
        waitpid(child, nullptr, 0);
        return result;
    }
    const Clock::time_point deadline = Clock::now() + limit;
    bool asked_to_stop = false;
    int status = 0;
    result.end = collect(child, out, err, result, status, [&] {
        asked_to_stop = stopped();
        return !asked_to_stop && Clock::now() < deadline;
    });
    kill(-child, SIGKILL);  // what it has left running
    if (result.end == ChildResult::End::timed_out) {
        result.end = asked_to_stop ? ChildResult::End::stopped : ChildResult::End::timed_out;
    } else if (WIFSIGNALED(status)) {
        result.end = ChildResult::End::killed_by_signal;
        result.code = WTERMSIG(status);
    } else {
        result.code = WEXITSTATUS(status);
    }
    return result;
}

std::optional<std::filesystem::path> find_program(const std::vector<std::string>& names) {
    const char* path = std::getenv("PATH");
    for (const std::string& name : names) {
        std::istringstream folders(path != nullptr ? path : "");
        for (std::string folder; std::getline(folders, folder, ':');) {
            const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
            std::error_code error;
            if (std::filesystem::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0) {
                return file;
            }
        }
    }
    return std::nullopt;
}

}  // namespace tiretherm::post
