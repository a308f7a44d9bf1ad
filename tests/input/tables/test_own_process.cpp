// SPDX-License-Identifier: BSD-3-Clause
// A call in a process of its own: its answer, and the ways in which it can fail.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "input/tables/own_process.hpp"

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

}  // namespace
}  // namespace tiretherm::input
