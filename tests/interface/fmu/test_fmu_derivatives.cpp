// SPDX-License-Identifier: BSD-3-Clause
// Directional derivatives of an FMU are those of the step it has taken, in both versions, and asking for them changes nothing.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

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

using Derive2 = int(void*, const unsigned*, std::size_t, const unsigned*, std::size_t, const double*, double*);
using Derive3 = int(void*, const unsigned*, std::size_t, const unsigned*, std::size_t, const double*, std::size_t,
                    double*, std::size_t);

std::vector<double> all_outputs(const Fmi2& fmi, void* it, const std::vector<unsigned>& outputs) {
    std::vector<double> values(outputs.size());
    EXPECT_EQ(fmi.get_real(it, outputs.data(), outputs.size(), values.data()), sample::ok);
    return values;
}

TEST(FmuDerivatives, AreThoseOfTheStepForAllInputsAndOutputs) {
    // A master takes the step again from the state before it, with an input moved: a central quotient, known to what Newton's
    // corrections leave (5 % of the tolerance of 0.001 K, at most) over the distance.
    for (const char* name :
         {"two_node/4000N_100kmh", "section/4000N_100kmh_all_heat_paths", "practice/two_node_bench"}) {
        const UnpackedFmu fmu(library_case(name), FmiVersion::fmi2);
        Fmi2 fmi(fmu);
        Instances instances(fmi);
        void* it = instances.start("tire");
        auto* derive = fmu.find<Derive2>("fmi2GetDirectionalDerivative");
        const std::vector<unsigned> outputs = fmu.outputs();
        for (int i = 0; i < 20; ++i) {
            ASSERT_EQ(fmi.do_step(it, 5.0 * i, 5.0, 1), sample::ok);
        }
        void* state = nullptr;
        ASSERT_EQ(fmi.get_state(it, &state), sample::ok);
        for (unsigned number = 1; number < outputs.front(); ++number) {
            const post::FmuVariable& variable = fmu.packed.content.variables[number - 1];
            if (variable.role != post::FmuVariable::Role::input || variable.name == "wet") {
                continue;
            }
            const double far = 1e-3 * (variable.unit == "radian" ? 1.0 : variable.high - variable.low);
            if (variable.start - far < variable.low) {
                continue;  // a central quotient has no room
            }
            const auto moved_by = [&](double by) {
                EXPECT_EQ(fmi.set_state(it, state), sample::ok);
                EXPECT_EQ(fmi.set(it, number, variable.start + by), sample::ok);
                EXPECT_EQ(fmi.do_step(it, 100.0, 5.0, 0), sample::ok);
                return all_outputs(fmi, it, outputs);
            };
            const std::vector<double> above = moved_by(far);
            const std::vector<double> below = moved_by(-far);
            static_cast<void>(moved_by(0.0));
            std::vector<double> slopes(outputs.size());
            const double one = 1.0;
            ASSERT_EQ(derive(it, outputs.data(), outputs.size(), &number, 1, &one, slopes.data()), sample::ok)
                << variable.name;
            for (std::size_t c = 0; c < outputs.size(); ++c) {
                const double quotient = (above[c] - below[c]) / (2.0 * far);
                const double noise = 2.0 * 5e-5 / far;
                EXPECT_NEAR(slopes[c], quotient, 1e-3 * std::abs(quotient) + noise)
                    << name << ": " << fmu.packed.content.variables[outputs[c] - 1].name << " with " << variable.name;
            }
        }
        EXPECT_EQ(fmi.free_state(it, &state), sample::ok);
    }
}

TEST(FmuDerivatives, ChangeNothing) {
    const sample::Scratch scratch;
    const UnpackedFmu fmu(with_parameters(scratch), FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    Instances instances(fmi);
    auto* derive = fmu.find<Derive2>("fmi2GetDirectionalDerivative");
    const auto bytes_of = [&](void* it) {
        void* state = nullptr;
        std::size_t size = 0;
        EXPECT_EQ(fmi.get_state(it, &state), sample::ok);
        EXPECT_EQ(fmi.state_size(it, state, &size), sample::ok);
        std::string bytes(size, '\0');
        EXPECT_EQ(fmi.serialise(it, state, bytes.data(), size), sample::ok);
        EXPECT_EQ(fmi.free_state(it, &state), sample::ok);
        return bytes;
    };
    void* asked = instances.start("asked");
    void* left_alone = instances.start("left alone");
    const unsigned knowns[] = {fmu.number("speed"), fmu.number("air_convection.lambda_h")};
    const double seed[] = {1.0, 0.5};
    const std::vector<unsigned> outputs = fmu.outputs();
    std::vector<double> slopes(outputs.size());
    for (int i = 0; i < 40; ++i) {
        for (void* it : {asked, left_alone}) {
            ASSERT_EQ(fmi.set(it, knowns[0], 30.0 + std::sin(i)), sample::ok);
            ASSERT_EQ(fmi.do_step(it, i, 1.0, 1), sample::ok);
        }
        ASSERT_EQ(derive(asked, outputs.data(), outputs.size(), knowns, 2, seed, slopes.data()), sample::ok);
        ASSERT_NE(slopes[0], 0.0);
        ASSERT_EQ(all_outputs(fmi, asked, outputs), all_outputs(fmi, left_alone, outputs)) << i;
    }
    EXPECT_EQ(bytes_of(asked), bytes_of(left_alone));
}

TEST(FmuDerivatives, BothVersionsGiveTheSame) {
    const UnpackedFmu second(tires, FmiVersion::fmi2);
    const UnpackedFmu third(tires, FmiVersion::fmi3);
    Fmi2 fmi2(second);
    Fmi3 fmi3(third);
    Instances instances(fmi2);
    void* a = instances.start("a");
    void* b = fmi3.make("b");
    ASSERT_EQ(fmi3.enter(b, false, 0.0, 0.0, false, 0.0), sample::ok);
    auto* derive2 = second.find<Derive2>("fmi2GetDirectionalDerivative");
    auto* derive3 = third.find<Derive3>("fmi3GetDirectionalDerivative");
    const unsigned known = second.number("speed");
    const std::vector<unsigned> outputs = second.outputs();
    const double seed = 1.0;
    std::vector<double> from2(outputs.size());
    std::vector<double> from3(outputs.size(), -1.0);
    // Temperatures begin as the case says, whatever the inputs are.
    ASSERT_EQ(derive3(b, outputs.data(), outputs.size(), &known, 1, &seed, 1, from3.data(), from3.size()), sample::ok);
    EXPECT_EQ(from3, std::vector<double>(outputs.size(), 0.0));
    ASSERT_EQ(fmi3.exit(b), sample::ok);
    ASSERT_EQ(fmi2.do_step(a, 0.0, 2.0, 1), sample::ok);
    ASSERT_EQ(fmi3.step(b, 0.0, 2.0).status, sample::ok);
    ASSERT_EQ(derive2(a, outputs.data(), outputs.size(), &known, 1, &seed, from2.data()), sample::ok);
    ASSERT_EQ(derive3(b, outputs.data(), outputs.size(), &known, 1, &seed, 1, from3.data(), from3.size()), sample::ok);
    EXPECT_EQ(from2, from3);
    EXPECT_GT(from2[0], 0.0) << "rolling faster heats";
    // No adjoint ones, as the description says.
    EXPECT_EQ(
        third.find<Derive3>("fmi3GetAdjointDerivative")(b, outputs.data(), 1, &known, 1, &seed, 1, from3.data(), 1),
        sample::error);
    fmi3.free_instance(b);
}

TEST(FmuDerivatives, RefuseWhatIsNoUnknownOrNoKnown) {
    const sample::Scratch scratch;
    const UnpackedFmu fmu(with_parameters(scratch), FmiVersion::fmi2);
    Fmi2 fmi(fmu);
    Instances instances(fmi);
    auto* derive = fmu.find<Derive2>("fmi2GetDirectionalDerivative");
    const unsigned speed = fmu.number("speed");
    const unsigned output = fmu.outputs()[0];
    const unsigned initial = fmu.number("air_convection.lambda_h") + 1;
    double slope = 0.0;
    const auto ask = [&](void* it, unsigned unknown, unsigned known, double seed) {
        return derive(it, &unknown, 1, &known, 1, &seed, &slope);
    };
    const auto says = [&](const std::string& part) {
        EXPECT_NE(fmi.log.back().text.find(part), std::string::npos) << fmi.log.back().text;
    };
    void* it = instances.all.emplace_back(fmi.make("tire"));
    EXPECT_EQ(ask(it, output, speed, 1.0), sample::error);
    says("while the instance is instantiated");
    const auto started = [&] {
        void* another = instances.start("another");
        EXPECT_EQ(fmi.do_step(another, 0.0, 1.0, 1), sample::ok);
        return another;
    };
    EXPECT_EQ(ask(started(), speed, speed, 1.0), sample::error);
    says("is no output");
    EXPECT_EQ(ask(started(), output, output, 1.0), sample::error);
    says("cannot be set");
    EXPECT_EQ(ask(started(), output, 0, 1.0), sample::error);
    EXPECT_EQ(ask(started(), output, 9999, 1.0), sample::error);
    says("is unknown");
    EXPECT_EQ(ask(started(), output, initial, 1.0), sample::error);
    says("fixed after initialization");
    EXPECT_EQ(ask(started(), output, speed, std::nan("")), sample::error);
    says("seed");
    // After a state was restored, the step that led to it is not known; the next one is.
    it = started();
    void* state = nullptr;
    ASSERT_EQ(fmi.get_state(it, &state), sample::ok);
    EXPECT_EQ(ask(it, output, speed, 1.0), sample::ok);
    ASSERT_EQ(fmi.set_state(it, state), sample::ok);
    EXPECT_EQ(ask(it, output, speed, 1.0), sample::discard);
    says("the last step is not known");
    ASSERT_EQ(fmi.do_step(it, 1.0, 1.0, 1), sample::ok);
    EXPECT_EQ(ask(it, output, speed, 1.0), sample::ok);
    EXPECT_EQ(fmi.free_state(it, &state), sample::ok);
}

}  // namespace
}  // namespace tiretherm
#endif
