// SPDX-License-Identifier: BSD-3-Clause
// An FMU gives the numbers of the session, its states and parameters are those of the session, and its instances do not know each other.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "solver/time_integration/session.hpp"
#include "tests/interface/allocations.hpp"
#include "tests/interface/fmu/importer.hpp"

#ifndef TIRETHERM_NO_FMU  // not in every build there is one: see cmake/fmu.cmake
namespace tiretherm {
namespace {

using post::FmiVersion;
using sample::Fmi2;
using sample::Fmi3;
using sample::Instances;
using sample::library_case;
using sample::tires;
using sample::UnpackedFmu;
using sample::with_parameters;

double speed_at(int i) { return 30.0 + 5.0 * std::sin(0.1 * i); }
double load_at(int i) { return i % 7 == 0 ? 0.0 : 4000.0 + 300.0 * std::sin(0.3 * i); }  // lifted off now and then

TEST(Fmu, GivesTheNumbersOfTheSessionToTheLastBit) {
    for (const char* name : {"two_node/4000N_100kmh", "layers/two_conductivities", "section/4000N_100kmh",
                             "section/4000N_100kmh_all_heat_paths", "laser/one_watt"}) {
        const UnpackedFmu fmu(library_case(name), FmiVersion::fmi2);
        Fmi2 fmi(fmu);
        Instances instances(fmi);
        void* it = instances.start("tire");
        const solver::Problem problem = *input::read_case(library_case(name)).problem;
        physics::Inputs inputs = problem.input_signals.at(problem.settings.start, solver::JumpSide::after);
        inputs.time = 0.0;
        solver::Session session(problem, inputs);
        double time = 0.0;
        for (int i = 0; i < 60; ++i) {
            const double size = i % 3 == 0 ? 0.25 : 0.5;
            if (const unsigned speed = fmu.number("speed")) {
                inputs.speed = speed_at(i);
                ASSERT_EQ(fmi.set(it, speed, inputs.speed), sample::ok);
            }
            if (const unsigned load = fmu.number("vertical_load")) {
                inputs.vertical_load = load_at(i);
                ASSERT_EQ(fmi.set(it, load, inputs.vertical_load), sample::ok);
            }
            ASSERT_EQ(fmi.do_step(it, time, size, 1), sample::ok) << fmi.log.back().text;
            ASSERT_TRUE(session.advance(size, inputs).ok());
            time += size;
        }
        const std::vector<unsigned> outputs = fmu.outputs();
        ASSERT_EQ(outputs.size(), problem.channels.size());
        for (std::size_t c = 0; c < outputs.size(); ++c) {
            EXPECT_EQ(fmi.value(it, outputs[c]), session.channel(c)) << name << " " << problem.channels[c].name;
        }
        EXPECT_EQ(fmi.terminate(it), sample::ok);
    }
}

TEST(Fmu, BothVersionsGiveTheSameNumbers) {
    const UnpackedFmu second(tires, FmiVersion::fmi2);
    const UnpackedFmu third(tires, FmiVersion::fmi3);
    Fmi2 fmi2(second);
    Fmi3 fmi3(third);
    Instances instances(fmi2);
    void* a = instances.start("a");
    void* b = fmi3.make("b");
    ASSERT_NE(b, nullptr);
    ASSERT_EQ(fmi3.enter(b, false, 0.0, 100.0, true, 200.0), sample::ok);
    ASSERT_EQ(fmi3.exit(b), sample::ok);
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(fmi2.set(a, second.number("speed"), speed_at(i)), sample::ok);
        ASSERT_EQ(fmi3.set_one(b, third.number("speed"), speed_at(i)), sample::ok);
        ASSERT_EQ(fmi2.do_step(a, 0.5 * i, 0.5, 1), sample::ok);
        const Fmi3::Step step = fmi3.step(b, 100.0 + 0.5 * i, 0.5);
        ASSERT_EQ(step.status, sample::ok);
        EXPECT_FALSE(step.event || step.terminate || step.early);
        EXPECT_EQ(step.last, 100.0 + 0.5 * (i + 1));
        EXPECT_EQ(fmi3.value(b, 0), step.last) << "the time is variable 0";
    }
    EXPECT_EQ(fmi2.value(a, second.outputs()[0]), fmi3.value(b, third.outputs()[0]));
    // Past the stop time that it was told, it does not go.
    EXPECT_EQ(fmi3.step(b, 110.0, 91.0).status, sample::error);
    EXPECT_EQ(fmi3.terminate(b), sample::error) << "after an error it is terminated";
    fmi3.free_instance(b);
}

TEST(Fmu, InstancesAreIndependent) {
    // Two at once, at different speeds, are each as it is alone; also of two FMUs in one process.
    const UnpackedFmu one(tires, FmiVersion::fmi2);
    const UnpackedFmu two(library_case("layers/two_conductivities"), FmiVersion::fmi2);
    Fmi2 fmi(one);
    Fmi2 other_fmi(two);
    Instances instances(fmi);
    Instances others(other_fmi);
    const auto drive = [&](void* it, double speed, int i) {
        EXPECT_EQ(fmi.set(it, one.number("speed"), speed), sample::ok);
        EXPECT_EQ(fmi.do_step(it, i, 1.0, 1), sample::ok);
    };
    void* alone = instances.start("alone");
    for (int i = 0; i < 20; ++i) {
        drive(alone, 25.0, i);
    }
    void* a = instances.start("a");
    void* b = instances.start("b");
    void* c = others.start("c");
    for (int i = 0; i < 20; ++i) {
        drive(a, 25.0, i);
        drive(b, 40.0, i);
        EXPECT_EQ(other_fmi.do_step(c, i, 1.0, 1), sample::ok);
    }
    EXPECT_EQ(fmi.value(a, one.outputs()[0]), fmi.value(alone, one.outputs()[0]));
    EXPECT_GT(fmi.value(b, one.outputs()[0]), fmi.value(a, one.outputs()[0]));
}

TEST(Fmu, AStateIsRestoredToTheBitAlsoFromBytes) {
    const sample::Scratch scratch;
    const UnpackedFmu fmu(with_parameters(scratch), FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    Instances instances(fmi);
    void* it = instances.start("it");
    const auto drive = [&](void* instance, int from, int to) {
        for (int i = from; i < to; ++i) {
            EXPECT_EQ(fmi.set(instance, fmu.number("speed"), speed_at(i)), sample::ok);
            EXPECT_EQ(fmi.do_step(instance, i, 1.0, 0), sample::ok);
        }
        return fmi.value(instance, fmu.outputs()[0]);
    };
    ASSERT_EQ(fmi.set(it, fmu.number("air_convection.lambda_h"), 2.0), sample::ok);
    drive(it, 0, 10);
    void* state = nullptr;
    ASSERT_EQ(fmi.get_state(it, &state), sample::ok);
    const double on = drive(it, 10, 30);
    ASSERT_EQ(fmi.set(it, fmu.number("air_convection.lambda_h"), 3.0), sample::ok);
    ASSERT_EQ(fmi.set_state(it, state), sample::ok);
    EXPECT_EQ(fmi.value(it, fmu.number("air_convection.lambda_h")), 2.0);
    EXPECT_EQ(drive(it, 10, 30), on);

    std::size_t size = 0;
    ASSERT_EQ(fmi.state_size(it, state, &size), sample::ok);
    std::string bytes(size, '\0');
    ASSERT_EQ(fmi.serialise(it, state, bytes.data(), size), sample::ok);
    ASSERT_EQ(fmi.free_state(it, &state), sample::ok);
    EXPECT_EQ(state, nullptr);
    void* other = fmi.make("other");  // not even initialized
    ASSERT_EQ(fmi.deserialise(other, bytes.data(), size, &state), sample::ok);
    ASSERT_EQ(fmi.set_state(other, state), sample::ok);
    EXPECT_EQ(drive(other, 10, 30), on);
    ASSERT_EQ(fmi.free_state(other, &state), sample::ok);
    EXPECT_EQ(fmi.deserialise(other, bytes.data(), 10, &state), sample::error);
    EXPECT_EQ(fmi.deserialise(other, bytes.data(), size - 8, &state), sample::error);
    bytes[3] ^= 1;  // of the token
    EXPECT_EQ(fmi.deserialise(other, bytes.data(), size, &state), sample::error);
    EXPECT_EQ(state, nullptr);
    fmi.free_instance(other);
}

TEST(Fmu, ParametersActFromTheNextStepOnAndAnInitialTemperatureBeforeTheFirst) {
    const sample::Scratch scratch;
    const UnpackedFmu fmu(with_parameters(scratch), FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    const unsigned lambda = fmu.number("air_convection.lambda_h");
    const unsigned initial = lambda + 1;
    const unsigned output = fmu.outputs()[0];
    ASSERT_NE(lambda, 0u);
    Instances instances(fmi);
    void* plain = instances.start("plain");
    void* moved = instances.start("moved");
    void* warm = instances.all.emplace_back(fmi.make("warm"));
    ASSERT_EQ(fmi.set(warm, initial, 10.0), sample::ok);
    ASSERT_EQ(fmi.set_up(warm, 0, 0.0, 0.0, 0, 0.0), sample::ok);
    ASSERT_EQ(fmi.enter(warm), sample::ok);
    EXPECT_NEAR(fmi.value(warm, output), fmi.value(plain, output) + 10.0, 1e-9) << "also in initialization mode";
    ASSERT_EQ(fmi.exit(warm), sample::ok);
    for (int i = 0; i < 30; ++i) {
        if (i == 10) {
            EXPECT_EQ(fmi.value(moved, output), fmi.value(plain, output));
            ASSERT_EQ(fmi.set(moved, lambda, 4.0), sample::ok);
            EXPECT_EQ(fmi.value(moved, output), fmi.value(plain, output));
        }
        for (void* it : {plain, moved, warm}) {
            ASSERT_EQ(fmi.do_step(it, i, 1.0, 1), sample::ok);
        }
    }
    EXPECT_LT(fmi.value(moved, output), fmi.value(plain, output));
    EXPECT_GT(fmi.value(warm, output), fmi.value(plain, output));
    EXPECT_EQ(fmi.set(moved, lambda, 100.0), sample::discard) << "beyond the bound of the [[parameter]]";
    EXPECT_EQ(fmi.set(warm, initial, 0.0), sample::error) << "it is fixed";
}

#ifdef TIRETHERM_COUNTS_ALLOCATIONS
TEST(Fmu, AllocatesNothingInAStep) {
    for (const char* name : {"two_node/4000N_100kmh", "layers/two_conductivities"}) {
        const UnpackedFmu fmu(library_case(name), FmiVersion::fmi2);
        Fmi2 fmi(fmu);
        Instances instances(fmi);
        void* it = instances.start("tire");
        const unsigned speed = fmu.number("speed");
        const unsigned output = fmu.outputs()[0];
        double time = 0.0;
        const auto drive = [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                ASSERT_EQ(fmi.set(it, speed, speed_at(i)), sample::ok);
                ASSERT_EQ(fmi.do_step(it, time, 0.001, 1), sample::ok);
                ASSERT_GT(fmi.value(it, output), 0.0);
                time += 0.001;
            }
        };
        drive(0, 20);
        const long before = sample::allocations;
        drive(20, 2020);
        EXPECT_EQ(sample::allocations - before, 0) << name;
        EXPECT_GT(before, 0) << "allocations of the shared object are counted";
    }
}
#endif

TEST(FmuLong, AStepIsTimedBesideThatOfTheSession) {
    // Layers of some hundred cells, the speed set before each step and an output read after it. Blocks of both take turns, and the
    // fastest of each counts: what else the machine does makes a block slower, never faster.
    const std::string name = library_case("layers/two_conductivities");
    const UnpackedFmu fmu(name, FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    Instances instances(fmi);
    void* it = instances.start("tire");
    const solver::Problem problem = *input::read_case(name).problem;
    physics::Inputs inputs = problem.input_signals.at(problem.settings.start, solver::JumpSide::after);
    inputs.time = 0.0;
    solver::Session session(problem, inputs);
    const unsigned speed = fmu.number("speed");
    const unsigned output = fmu.outputs()[0];
    const auto seconds_of = [](const auto& block) {
        const auto begin = std::chrono::steady_clock::now();
        block();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    constexpr int steps = 1000;
    double of_fmu = 1e9;
    double of_session = 1e9;
    double last_of_session = 0.0;
    double last_of_fmu = 1.0;
    for (int block = 0; block < 60; ++block) {
        of_session = std::min(of_session, seconds_of([&] {
                                  for (int i = 0; i < steps; ++i) {
                                      inputs.speed = speed_at(i);
                                      ASSERT_TRUE(session.advance(0.01, inputs).ok());
                                      last_of_session = session.channel(0);
                                  }
                              }));
        of_fmu = std::min(of_fmu, seconds_of([&] {
                              for (int i = 0; i < steps; ++i) {
                                  ASSERT_EQ(fmi.set(it, speed, speed_at(i)), sample::ok);
                                  ASSERT_EQ(fmi.do_step(it, 0.01 * (steps * block + i), 0.01, 1), sample::ok);
                                  last_of_fmu = fmi.value(it, output);
                              }
                          }));
    }
    EXPECT_EQ(last_of_fmu, last_of_session);
    std::printf("%zu temperatures: a step of the session %.2f us, of the FMU %.2f us, ratio %.3f\n",
                session.temperature().size(), 1e6 * of_session / steps, 1e6 * of_fmu / steps, of_fmu / of_session);
}

}  // namespace
}  // namespace tiretherm
#endif
