// SPDX-License-Identifier: BSD-3-Clause
// A call in a process of its own: its answer, and the ways in which it can fail.

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "input/hdf5/own_process.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::input {
namespace {

TEST(OwnProcess, GivesWhatTheWorkReturned) {
    int changed = 0;
    // More than the 64 kB that a pipe holds.
    const std::string long_text(1'000'000, 'x');
    EXPECT_EQ(in_own_process([&] {
                  changed = 1;
                  return long_text;
              }),
              long_text);
    EXPECT_EQ(changed, 0);
    EXPECT_EQ(in_own_process([] { return std::string(); }), "");
}

TEST(OwnProcess, ThatCrashesOrThrowsGivesNothing) {
    EXPECT_EQ(in_own_process([]() -> std::string { std::abort(); }), std::nullopt);
    EXPECT_EQ(in_own_process([]() -> std::string {
                  std::raise(SIGKILL);
                  return "killed";
              }),
              std::nullopt);
    EXPECT_EQ(in_own_process([]() -> std::string { throw std::runtime_error("damaged"); }), std::nullopt);
}

TEST(OwnProcess, ThatNeverEndsIsEnded) {
    volatile bool on = true;
    EXPECT_EQ(in_own_process(
                  [&] {
                      while (on) {
                      }
                      return std::string();
                  },
                  1),
              std::nullopt);
}

// It computes nothing, as one that waits for a lock that no thread of its own holds.
TEST(OwnProcess, ThatWaitsForEverIsEnded) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(in_own_process(
                  [] {
                      for (;;) {
                          pause();
                      }
                      return std::string();
                  },
                  1),
              std::nullopt);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

// The deadline of a call is heard where reading may be given up, and the child is not left behind.
TEST(OwnProcess, IsGivenUpWhenTheTimeIsUp) {
    const auto wait = [] {
        for (;;) {
            pause();
        }
        return std::string();
    };
    solver::stop_after(0.2);
    {
        const solver::InterruptibleReading reading;
        EXPECT_THROW(static_cast<void>(in_own_process(wait)), solver::Interrupted);
    }
    solver::stop_after(std::numeric_limits<double>::infinity());
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

}  // namespace
}  // namespace tiretherm::input
