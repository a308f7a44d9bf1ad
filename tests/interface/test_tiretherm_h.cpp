// SPDX-License-Identifier: BSD-3-Clause
// The C interface: the numbers of the C++ session, errors as numbers and messages, no allocation in a step.

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "interface/tiretherm.h"
#include "post/report/file.hpp"
#include "solver/time_integration/session.hpp"
#include "tests/interface/allocations.hpp"
#include "tests/post/scratch.hpp"

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

TEST(TirethermH, AStateGoesOnWithTheSameDigitsInThisSessionAndInAnother) {
    const Tire tire = open(two_node);
    const int speed = tiretherm_find_input("speed");
    const auto drive = [&](tiretherm_session* session) {
        std::vector<double> all;
        for (int i = 0; i < 50; ++i) {
            EXPECT_EQ(tiretherm_set_input(session, speed, 30.0 + std::sin(0.1 * i)), TIRETHERM_OK);
            EXPECT_EQ(tiretherm_step(session, i % 3 == 0 ? 0.4 : 0.1), TIRETHERM_OK);
            all.push_back(tiretherm_output(session, 0));
        }
        return all;
    };
    drive(tire.get());
    std::vector<double> state(tiretherm_state(tire.get(), nullptr, 0));
    ASSERT_EQ(tiretherm_state(tire.get(), state.data(), state.size()), state.size());
    const double time = tiretherm_time(tire.get());
    const std::vector<double> on = drive(tire.get());
    ASSERT_EQ(tiretherm_restore(tire.get(), state.data(), state.size()), TIRETHERM_OK);
    EXPECT_EQ(tiretherm_time(tire.get()), time);
    EXPECT_EQ(drive(tire.get()), on);
    const Tire other = open(two_node);
    ASSERT_EQ(tiretherm_restore(other.get(), state.data(), state.size()), TIRETHERM_OK);
    EXPECT_EQ(drive(other.get()), on);
}

TEST(TirethermH, RefusesWhatIsNoStateAndStaysAsItWas) {
    const Tire tire = open(two_node);
    ASSERT_EQ(tiretherm_step(tire.get(), 1.0), TIRETHERM_OK);
    std::vector<double> state(tiretherm_state(tire.get(), nullptr, 0));
    EXPECT_EQ(tiretherm_state(tire.get(), state.data(), 3), state.size());
    ASSERT_EQ(tiretherm_state(tire.get(), state.data(), state.size()), state.size());
    const double before = tiretherm_output(tire.get(), 0);
    for (const std::size_t wrong : {std::size_t{0}, std::size_t{5}, state.size() - 1}) {
        EXPECT_EQ(tiretherm_restore(tire.get(), state.data(), wrong), TIRETHERM_BAD_ARGUMENT);
        EXPECT_STREQ(tiretherm_message(tire.get()), "this is no state of the session's case");
        EXPECT_EQ(tiretherm_output(tire.get(), 0), before);
    }
    EXPECT_EQ(tiretherm_restore(tire.get(), nullptr, 3), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_restore(nullptr, state.data(), state.size()), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_state(nullptr, nullptr, 0), 0u);
}

TEST(TirethermH, AParameterThatIsSetBeforeTheFirstStepIsThatOfTheCase) {
    // The case with the number and the case whose session is given it are the same run.
    const sample::Scratch scratch;
    const auto write = [&](const std::string& name, const std::string& lambda) {
        post::replace_file(scratch / name,
                           "include = \"" + two_node + "\"\n[effects.air_convection]\nlambda_h = " + lambda +
                               "\n[[parameter]]\neffect = \"air_convection\"\n" + "key = \"lambda_h\"\n");
        return (scratch / name).string();
    };
    const Tire given = open(write("given.toml", "1.4"));
    const Tire moved = open(write("moved.toml", "1.0"));
    ASSERT_EQ(tiretherm_parameter_count(moved.get()), 1);
    EXPECT_STREQ(tiretherm_parameter_name(moved.get(), 0), "air_convection.lambda_h");
    EXPECT_STREQ(tiretherm_parameter_unit(moved.get(), 0), "1");
    EXPECT_EQ(tiretherm_parameter(moved.get(), 0), 1.0);
    ASSERT_EQ(tiretherm_set_parameter(moved.get(), 0, 1.4), TIRETHERM_OK);
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(tiretherm_step(given.get(), 0.5), TIRETHERM_OK);
        ASSERT_EQ(tiretherm_step(moved.get(), 0.5), TIRETHERM_OK);
    }
    EXPECT_EQ(tiretherm_output(moved.get(), 0), tiretherm_output(given.get(), 0));
    // Later it acts from there: temperatures stay, and it is warmer with less convection.
    const double now = tiretherm_output(moved.get(), 0);
    ASSERT_EQ(tiretherm_set_parameter(moved.get(), 0, 1.0), TIRETHERM_OK);
    EXPECT_EQ(tiretherm_output(moved.get(), 0), now);
    EXPECT_EQ(tiretherm_set_parameter(moved.get(), 0, -1e9), TIRETHERM_BAD_ARGUMENT);
    EXPECT_NE(std::string(tiretherm_message(moved.get())).find("air_convection.lambda_h"), std::string::npos);
    EXPECT_EQ(tiretherm_set_parameter(moved.get(), 1, 1.0), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_parameter(moved.get(), 0), 1.0);
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(tiretherm_step(given.get(), 0.5), TIRETHERM_OK);
        ASSERT_EQ(tiretherm_step(moved.get(), 0.5), TIRETHERM_OK);
    }
    EXPECT_GT(tiretherm_output(moved.get(), 0), tiretherm_output(given.get(), 0));
}

#ifdef TIRETHERM_COUNTS_ALLOCATIONS
TEST(TirethermH, SaysThatThereIsNoMemoryForAState) {
    const Tire tire = open(two_node);
    const std::size_t size = tiretherm_state(tire.get(), nullptr, 0);
    std::vector<double> state(size);
    ASSERT_EQ(tiretherm_state(tire.get(), state.data(), size), size);
    const std::vector<double> before = state;
    sample::allocations_left = 0;
    const std::size_t found = tiretherm_state(tire.get(), state.data(), size);
    const int refused = tiretherm_set_input(tire.get(), -1, 1.0);  // whose reason is a text
    sample::allocations_left = std::numeric_limits<long>::max();
    EXPECT_EQ(found, 0u);
    EXPECT_EQ(refused, TIRETHERM_FAILED);
    EXPECT_STREQ(tiretherm_message(tire.get()), "out of memory");
    EXPECT_EQ(state, before);
    EXPECT_EQ(tiretherm_state(tire.get(), state.data(), size), size);
    EXPECT_EQ(state, before);
}

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
        const long before = sample::allocations;
        drive(20, 2020);
        EXPECT_EQ(sample::allocations - before, 0) << file;
    }
}
#endif

}  // namespace
}  // namespace tiretherm
