// SPDX-License-Identifier: BSD-3-Clause
// An FMU keeps to the standard: what it exports and needs, the calling sequence, values out of range, the categories of its log.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/interface/fmu/importer.hpp"

#ifndef TIRETHERM_NO_FMU  // not in every build there is one: see cmake/fmu.cmake
namespace tiretherm {
namespace {

using post::FmiVersion;
using sample::Fmi2;
using sample::Fmi3;
using sample::Instances;
using sample::tires;
using sample::UnpackedFmu;

TEST(Fmu, ExportsWhatTheStandardAsksFor) {
    const UnpackedFmu fmu(tires, FmiVersion::fmi3);
    EXPECT_STREQ(fmu.find<const char*()>("fmi2GetVersion")(), "2.0");
    EXPECT_STREQ(fmu.find<const char*()>("fmi2GetTypesPlatform")(), "default");
    EXPECT_STREQ(fmu.find<const char*()>("fmi3GetVersion")(), "3.0");
    for (const char* type : {"Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64",
                             "UInt64", "Boolean", "String", "Binary", "Clock"}) {
        EXPECT_NE(dlsym(fmu.library, (std::string("fmi3Get") + type).c_str()), nullptr) << type;
        EXPECT_NE(dlsym(fmu.library, (std::string("fmi3Set") + type).c_str()), nullptr) << type;
    }
    for (const char* type : {"Real", "Integer", "Boolean", "String"}) {
        EXPECT_NE(dlsym(fmu.library, (std::string("fmi2Get") + type).c_str()), nullptr) << type;
        EXPECT_NE(dlsym(fmu.library, (std::string("fmi2Set") + type).c_str()), nullptr) << type;
    }
    // Nothing of the solver, of the C++ library or of CHOLMOD.
    EXPECT_EQ(dlsym(fmu.library, "cholmod_start"), nullptr);
    EXPECT_EQ(dlsym(fmu.library, "omp_get_max_threads"), nullptr);
}

TEST(Fmu, NeedsNoLibraryBesideGlibc) {
    const UnpackedFmu fmu(tires, FmiVersion::fmi2);
    const std::string so = (fmu.folder / "binaries/linux64" / (fmu.packed.content.identifier + ".so")).string();
    const std::string list = (fmu.folder / "needed").string();
    ASSERT_EQ(std::system(("readelf -d '" + so + "' | grep -E 'NEEDED|RPATH|RUNPATH|TEXTREL' >'" + list + "'").c_str()),
              0);
    std::ifstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        const bool is_glibc = line.find("[libc.so.6]") != std::string::npos ||
                              line.find("[libm.so.6]") != std::string::npos ||
                              line.find("[ld-linux-x86-64.so.2]") != std::string::npos;
        EXPECT_TRUE(is_glibc) << line;
    }
}

TEST(Fmu, RefusesWrongSequencesWithAMessage) {
    const UnpackedFmu fmu(tires, FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    const std::string token = fmu.packed.content.token;
    const std::string uri = "file://" + (fmu.folder / "resources").string();
    const auto says = [&](const std::string& part) {
        ASSERT_FALSE(fmi.log.empty());
        EXPECT_NE(fmi.log.back().text.find(part), std::string::npos) << fmi.log.back().text;
        EXPECT_EQ(fmi.log.back().status, sample::error);
        EXPECT_EQ(fmi.log.back().category, "logStatusError");
    };
    fmi.free_instance(fmi.make("sets the log up"));
    EXPECT_EQ(fmi.instantiate("x", 1, "another token", uri.c_str(), &fmi.callbacks, 0, 0), nullptr);
    says("another token");
    EXPECT_EQ(fmi.instantiate("x", 0, token.c_str(), uri.c_str(), &fmi.callbacks, 0, 0), nullptr);
    says("co-simulation");
    EXPECT_EQ(fmi.instantiate("x", 1, token.c_str(), "file:///no%20such%20folder", &fmi.callbacks, 0, 0), nullptr);
    says("/no such folder/session.bin");
    EXPECT_EQ(fmi.instantiate("", 1, token.c_str(), uri.c_str(), &fmi.callbacks, 0, 0), nullptr);
    says("no name");

    void* it = fmi.make("tire");
    ASSERT_NE(it, nullptr);
    const auto again = [&] {
        ASSERT_EQ(fmi.reset(it), sample::ok);
        ASSERT_EQ(fmi.set_up(it, 0, 0.0, 0.0, 0, 0.0), sample::ok);
        ASSERT_EQ(fmi.enter(it), sample::ok);
    };
    EXPECT_EQ(fmi.enter(it), sample::error);
    says("fmi2SetupExperiment has to be called before");
    EXPECT_EQ(fmi.set_up(it, 0, 0.0, 0.0, 0, 0.0), sample::error) << "after an error only a reset helps";
    says("terminated");
    again();
    EXPECT_EQ(fmi.do_step(it, 0.0, 1.0, 1), sample::error);
    says("fmi2DoStep: it cannot be called while the instance is in initialization mode");
    again();
    ASSERT_EQ(fmi.exit(it), sample::ok);
    EXPECT_EQ(fmi.do_step(it, 5.0, 1.0, 1), sample::error);
    says("from 5 s, where the instance is at 0 s");
    for (const double wrong : {0.0, -1.0, std::nan("")}) {
        again();
        ASSERT_EQ(fmi.exit(it), sample::ok);
        EXPECT_EQ(fmi.do_step(it, 0.0, wrong, 1), sample::error);
    }
    again();
    ASSERT_EQ(fmi.exit(it), sample::ok);
    EXPECT_EQ(fmi.set(it, fmu.outputs()[0], 300.0), sample::error);
    says("cannot be set");
    again();
    EXPECT_EQ(fmi.value(it, 9999), -1.0);
    says("there is no variable 9999");
    EXPECT_EQ(fmi.do_step(nullptr, 0.0, 1.0, 1), sample::error);
    again();
    ASSERT_EQ(fmi.exit(it), sample::ok);
    EXPECT_EQ(fmi.terminate(it), sample::ok);
    EXPECT_EQ(fmi.terminate(it), sample::error);
    fmi.free_instance(it);
    fmi.free_instance(nullptr);
}

TEST(Fmu, AValueOutOfRangeIsDiscardedAndNothingIsSet) {
    const UnpackedFmu fmu(tires, FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    Instances instances(fmi);
    void* it = instances.start("tire");
    const double before = fmi.value(it, fmu.number("speed"));
    for (const double wrong : {1e9, -1e9, std::nan("")}) {
        const unsigned numbers[] = {fmu.number("speed"), fmu.number("vertical_load")};
        const double values[] = {20.0, wrong};
        EXPECT_EQ(fmi.set_real(it, numbers, 2, values), sample::discard);
        EXPECT_NE(fmi.log.back().text.find("vertical_load"), std::string::npos);
        EXPECT_EQ(fmi.log.back().category, "logStatusDiscard");
        EXPECT_EQ(fmi.value(it, fmu.number("speed")), before);
    }
    EXPECT_EQ(fmi.do_step(it, 0.0, 1.0, 1), sample::ok);
}

TEST(Fmu, GoesThroughTheSequenceOfASimulatorThatKeepsItsStateInAFile) {
    // As the FMI project's own simulator does it: start values before the experiment, inputs in initialization mode and before each
    // step, communication points by multiplication, a stop time; then an instance that begins with the bytes of a file and is
    // never initialized. That one frees the state by the state itself in the place of its pointer's address; older versions of FMPy hand
    // over a zero behind the bytes.
    const UnpackedFmu fmu(tires, FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    const unsigned speed = fmu.number("speed");
    const unsigned load = fmu.number("vertical_load");
    const unsigned output = fmu.outputs()[0];
    constexpr double start = 3.0;
    constexpr double interval = 0.1;
    const auto steps = [&](void* it, int from, int to) {
        for (int i = from; i < to; ++i) {
            const double point = i == 0 ? start : start + i * interval;
            EXPECT_EQ(fmi.set(it, speed, 20.0 + i), sample::ok);
            EXPECT_EQ(fmi.do_step(it, point, start + (i + 1) * interval - point, 1), sample::ok) << fmi.log.back().text;
        }
        return fmi.value(it, output);
    };
    void* it = fmi.make("instance1", false);
    ASSERT_EQ(fmi.set(it, load, 3500.0), sample::ok);
    ASSERT_EQ(fmi.set_up(it, 0, 0.0, start, 1, start + 20 * interval), sample::ok);
    ASSERT_EQ(fmi.enter(it), sample::ok);
    ASSERT_EQ(fmi.set(it, speed, 20.0), sample::ok);
    ASSERT_EQ(fmi.exit(it), sample::ok);
    steps(it, 0, 10);
    void* state = nullptr;
    std::size_t size = 0;
    ASSERT_EQ(fmi.get_state(it, &state), sample::ok);
    ASSERT_EQ(fmi.state_size(it, state, &size), sample::ok);
    std::string file(size, '\0');
    ASSERT_EQ(fmi.serialise(it, state, file.data(), size), sample::ok);
    ASSERT_EQ(fmi.free_state(it, &state), sample::ok);
    const double straight_on = steps(it, 10, 20);
    EXPECT_EQ(fmi.do_step(it, start + 20 * interval, interval, 1), sample::error) << "past the stop time";
    fmi.free_instance(it);

    void* other = fmi.make("instance1", false);
    ASSERT_EQ(fmi.deserialise(other, file.c_str(), file.size() + 1, &state), sample::ok);
    ASSERT_EQ(fmi.set_state(other, state), sample::ok);
    ASSERT_EQ(fmi.free_state(other, static_cast<void**>(state)), sample::ok);
    ASSERT_EQ(fmi.set(other, load, 3500.0), sample::ok);
    EXPECT_EQ(steps(other, 10, 20), straight_on);
    EXPECT_EQ(fmi.terminate(other), sample::ok);
    state = nullptr;
    EXPECT_EQ(fmi.free_state(other, &state), sample::ok) << "there is none";
    EXPECT_EQ(fmi.set_state(other, other), sample::error) << "an instance is no state";
    fmi.free_instance(other);
}

TEST(Fmu, LogsByCategories) {
    const UnpackedFmu fmu(tires, FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    auto* set_logging = fmu.find<int(void*, int, std::size_t, const char* const*)>("fmi2SetDebugLogging");
    void* it = fmi.make("tire", false);
    EXPECT_TRUE(fmi.log.empty());
    const char* events[] = {"logEvents"};
    ASSERT_EQ(set_logging(it, 1, 1, events), sample::ok);
    ASSERT_EQ(fmi.set_up(it, 0, 0.0, 3.0, 0, 0.0), sample::ok);
    ASSERT_EQ(fmi.enter(it), sample::ok);
    ASSERT_EQ(fmi.exit(it), sample::ok);
    ASSERT_EQ(fmi.log.size(), 1u);
    EXPECT_EQ(fmi.log[0].category, "logEvents");
    EXPECT_EQ(fmi.log[0].text, "initialized at 3 s");
    const char* unknown[] = {"logEverything"};
    EXPECT_EQ(set_logging(it, 1, 1, unknown), sample::error);
    fmi.free_instance(it);
}

TEST(Fmu, Version3HasNoEventModeAndRefusesOtherKinds) {
    const UnpackedFmu fmu(tires, FmiVersion::fmi3);
    Fmi3 fmi(fmu);
    EXPECT_EQ(fmi.make("tire", true), nullptr);
    EXPECT_NE(fmi.log.back().text.find("event mode"), std::string::npos);
    auto* exchange = fmu.find<void*(const char*, const char*, const char*, bool, bool, void*, Fmi3::LogMessage)>(
        "fmi3InstantiateModelExchange");
    EXPECT_EQ(exchange("x", "", "", false, false, nullptr, nullptr), nullptr);
    void* it = fmi.make("tire");
    EXPECT_NEAR(fmi.value(it, fmu.number("speed")), 100.0 / 3.6, 1e-9) << "start values, before initialization";
    EXPECT_EQ(fmu.find<int(void*)>("fmi3EnterStepMode")(it), sample::error);
    fmi.free_instance(it);
}

}  // namespace
}  // namespace tiretherm
#endif
