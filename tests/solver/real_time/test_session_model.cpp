// SPDX-License-Identifier: BSD-3-Clause
// A stored session is the session: every member comes back, and it goes on with the same digits. What is damaged is refused.

#include "solver/real_time/session_model.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "physics/tire_laws/measured_loss.hpp"
#include "solver/bench.hpp"
#include "solver/field_digest.hpp"
#include "solver/real_time/tunable_session.hpp"

namespace tiretherm::solver {

namespace {

Digest::Value digest_of(const SessionModel& model) {
    Digest digest;
    add_fields(digest, model.problem);
    add_fields(digest, model.start);
    add_fields(digest, model.parameters);
    return digest.value();
}

/// The problem as it is stored: without inputs over time, drawing and what only results have.
SessionModel stored(const Problem& problem, const std::vector<FreeParameter>& parameters = {}) {
    SessionModel model = session_model(problem, parameters);
    model.problem.input_signals = {};
    model.problem.mesh.drawing = {};
    model.problem.measured.clear();
    model.problem.sources.clear();
    return model;
}

}  // namespace

TEST(SessionModel, ComesBackWithAllItsMembers) {
    // The digest goes over all members, which the compiler counts.
    for (const Problem& problem : {two_node_tire(), heated_strip(30)}) {
        FreeParameter parameter;
        parameter.name = "lambda";
        parameter.companions = {{.parameter = 1, .factor = 2.0}};
        parameter.knots = {300.0, 350.0};
        const SessionModel model = stored(problem, {parameter});
        EXPECT_EQ(digest_of(session_model_from(to_bytes(model))), digest_of(model)) << problem.mesh.kind;
    }
}

TEST(SessionModel, GoesOnWithTheSameDigits) {
    const SessionModel model = session_model(two_node_tire(), {});
    TunableSession here(model);
    TunableSession there(session_model_from(to_bytes(model)));
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(here.advance(0.3).ok());
        ASSERT_TRUE(there.advance(0.3).ok());
    }
    EXPECT_EQ(here.session().channel(0), there.session().channel(0));
    EXPECT_EQ(here.state(), there.state());
}

TEST(SessionModel, RefusesWhatIsDamaged) {
    const std::string bytes = to_bytes(session_model(two_node_tire(), {}));
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 1;
    for (const std::string& wrong : {std::string(), bytes.substr(0, 20), bytes.substr(0, 60),
                                     bytes.substr(0, bytes.size() - 1), bytes + "x", "x" + bytes, flipped}) {
        EXPECT_THROW(static_cast<void>(session_model_from(wrong)), std::runtime_error) << wrong.size();
    }
    EXPECT_NO_THROW(static_cast<void>(session_model_from(bytes)));
    EXPECT_NE(token_of(bytes), token_of(flipped));
}

TEST(SessionModel, NamesTheInputsThatMakeADifference) {
    // Each input that it names changes the result when it changes; of two nodes without a laser, its power is none of them.
    const SessionModel model = session_model(two_node_tire(), {});
    std::vector<std::string_view> names;
    for (const physics::Signal* signal : model.inputs()) {
        names.push_back(signal->name);
    }
    EXPECT_NE(std::ranges::find(names, "speed"), names.end());
    EXPECT_NE(std::ranges::find(names, "vertical_load"), names.end());
    EXPECT_NE(std::ranges::find(names, "air_temperature"), names.end());
    EXPECT_EQ(std::ranges::find(names, "laser_power"), names.end());
}

}  // namespace tiretherm::solver
