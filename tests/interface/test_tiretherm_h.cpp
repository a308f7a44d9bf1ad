// SPDX-License-Identifier: BSD-3-Clause
// The C interface: the numbers of the C++ session, errors as numbers and messages, no allocation in a step.

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "interface/tiretherm.h"
#include "post/report/file.hpp"
#include "solver/time_integration/session.hpp"
#include "tests/post/scratch.hpp"

// Counts every allocation of this executable, those of C libraries too. The sanitizers bring their own allocator.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {
std::atomic<long> allocations{0};
}
extern "C" {
void* __libc_malloc(std::size_t size);  // NOLINT: the name is glibc's
void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
}
#endif

namespace tiretherm {
namespace {

const std::string two_node = TIRETHERM_SOURCE_DIR "/cases/two_node/4000N_100kmh.toml";

struct Closer {
    void operator()(tiretherm_session* session) const { tiretherm_close(session); }
};
using Tire = std::unique_ptr<tiretherm_session, Closer>;

Tire open(const std::string& file) {
    std::array<char, 2000> message{};
    Tire tire(tiretherm_open(file.c_str(), message.data(), message.size()));
    EXPECT_NE(tire, nullptr) << message.data();
    EXPECT_STREQ(message.data(), "");
    return tire;
}

TEST(TirethermH, GivesTheNumbersOfTheSession) {
    const Tire tire = open(two_node);
    const solver::Problem problem = *input::read_case(two_node).problem;
    physics::Inputs inputs = problem.input_signals.at(problem.settings.start, solver::JumpSide::after);
    inputs.time = 0.0;
    solver::Session session(problem, inputs);
    const int speed = tiretherm_find_input("speed");
    ASSERT_STREQ(tiretherm_input_name(speed), "speed");
    EXPECT_STREQ(tiretherm_input_unit(speed), "m s-1");
    for (int i = 1; i <= 100; ++i) {
        inputs.speed = 30.0 + std::sin(0.1 * i);
        ASSERT_EQ(tiretherm_set_input(tire.get(), speed, inputs.speed), TIRETHERM_OK);
        ASSERT_EQ(tiretherm_step(tire.get(), 0.5), TIRETHERM_OK) << tiretherm_message(tire.get());
        ASSERT_TRUE(session.advance(0.5, inputs).ok());
    }
    EXPECT_EQ(tiretherm_time(tire.get()), session.time());
    ASSERT_EQ(tiretherm_output_count(tire.get()), static_cast<int>(problem.channels.size()));
    for (int i = 0; i < tiretherm_output_count(tire.get()); ++i) {
        const std::size_t channel = static_cast<std::size_t>(i);
        EXPECT_EQ(tiretherm_output(tire.get(), i), session.channel(channel));
        EXPECT_EQ(tiretherm_output_name(tire.get(), i), problem.channels[channel].name);
        EXPECT_EQ(tiretherm_find_output(tire.get(), tiretherm_output_name(tire.get(), i)), i);
    }
    ASSERT_EQ(tiretherm_temperature_count(tire.get()), session.temperature().size());
    for (std::size_t n = 0; n < session.temperature().size(); ++n) {
        EXPECT_EQ(tiretherm_temperatures(tire.get())[n], session.temperature()[n]);
    }
}

TEST(TirethermH, SaysAllThatIsWrongWithACaseAndCutsWhatHasNoRoom) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "bad.toml", "titel = \"x\"\n[time]\nend = \"5 kg\"\n");
    std::array<char, 4000> message{};
    EXPECT_EQ(tiretherm_open((scratch / "bad.toml").c_str(), message.data(), message.size()), nullptr);
    const std::string text = message.data();
    EXPECT_NE(text.find("bad.toml:1"), std::string::npos) << text;
    EXPECT_NE(text.find("titel"), std::string::npos) << text;
    EXPECT_NE(text.find("bad.toml:3"), std::string::npos) << text;
    std::array<char, 8> small{};
    EXPECT_EQ(tiretherm_open((scratch / "bad.toml").c_str(), small.data(), small.size()), nullptr);
    EXPECT_EQ(std::string(small.data()), text.substr(0, 7));
    EXPECT_EQ(tiretherm_open((scratch / "none.toml").c_str(), nullptr, 0), nullptr);
    EXPECT_EQ(tiretherm_open(nullptr, message.data(), message.size()), nullptr);
    EXPECT_STREQ(message.data(), "no case file was named");
}

TEST(TirethermH, RefusesWhatIsNoInputAndNoStepAndStaysAsItWas) {
    const Tire tire = open(two_node);
    const int air = tiretherm_find_input("air_temperature");
    ASSERT_EQ(tiretherm_step(tire.get(), 1.0), TIRETHERM_OK);
    const double before = tiretherm_output(tire.get(), 0);
    for (const double wrong : {std::nan(""), 1e9, -1.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(tiretherm_set_input(tire.get(), air, wrong), TIRETHERM_BAD_ARGUMENT);
        EXPECT_NE(std::string(tiretherm_message(tire.get())).find("air_temperature"), std::string::npos);
    }
    EXPECT_EQ(tiretherm_set_input(tire.get(), tiretherm_input_count(), 1.0), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_set_input(tire.get(), tiretherm_find_input("no such"), 1.0), TIRETHERM_BAD_ARGUMENT);
    for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(tiretherm_step(tire.get(), wrong), TIRETHERM_BAD_ARGUMENT);
        EXPECT_STREQ(tiretherm_message(tire.get()), "a step must be positive");
    }
    EXPECT_EQ(tiretherm_output(tire.get(), 0), before);
    EXPECT_EQ(tiretherm_time(tire.get()), 1.0);
    ASSERT_EQ(tiretherm_step(tire.get(), 1.0), TIRETHERM_OK);
    EXPECT_STREQ(tiretherm_message(tire.get()), "");
    EXPECT_TRUE(std::isnan(tiretherm_output(tire.get(), -1)));
    EXPECT_EQ(tiretherm_output_name(tire.get(), 1000), nullptr);
    EXPECT_EQ(tiretherm_input_name(-1), nullptr);
}

TEST(TirethermH, NoSessionIsAnErrorAndNoCrash) {
    tiretherm_close(nullptr);
    EXPECT_EQ(tiretherm_step(nullptr, 1.0), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_set_input(nullptr, 0, 1.0), TIRETHERM_BAD_ARGUMENT);
    EXPECT_TRUE(std::isnan(tiretherm_output(nullptr, 0)));
    EXPECT_EQ(tiretherm_temperatures(nullptr), nullptr);
    EXPECT_EQ(tiretherm_output_count(nullptr), 0);
    EXPECT_STREQ(tiretherm_message(nullptr), "there is no session");
    EXPECT_STRNE(tiretherm_version(), "");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(TirethermH, AllocatesNothingInAStep) {
    for (const char* file : {"/cases/two_node/4000N_100kmh.toml", "/cases/layers/two_conductivities.toml"}) {
        const Tire tire = open(std::string(TIRETHERM_SOURCE_DIR) + file);
        const int speed = tiretherm_find_input("speed");
        const auto drive = [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                ASSERT_EQ(tiretherm_set_input(tire.get(), speed, 30.0 + std::sin(0.01 * i)), TIRETHERM_OK);
                ASSERT_EQ(tiretherm_step(tire.get(), 0.001), TIRETHERM_OK);
            }
        };
        drive(0, 20);
        const long before = allocations;
        drive(20, 2020);
        EXPECT_EQ(allocations - before, 0) << file;
    }
}
#endif

}  // namespace
}  // namespace tiretherm
