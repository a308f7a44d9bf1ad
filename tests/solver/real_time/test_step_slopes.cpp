// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of a step: those of a linear tire in closed form, those of a nonlinear one as difference quotients come to them, and the
// session goes on with the same digits.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/real_time/tunable_session.hpp"

namespace tiretherm::solver {

namespace {

const physics::Signal& signal(std::string_view name) { return *physics::find_signal(name); }

std::vector<double> slopes_of(const TunableSession& session, const SessionDirection& direction) {
    std::vector<double> slopes(session.model().problem.channels.size());
    const Status status = session.find_slopes(direction, slopes);
    EXPECT_TRUE(status.ok()) << status.message;
    return slopes;
}
SessionDirection along(std::string_view name, double rate = 1.0) {
    return {.inputs = {{&signal(name), rate}}, .parameters = {}};
}

/// Two nodes, a link of constant conductance and a constant film: C dT/dt = -K T + (hA, 0)' T_air.
struct LinearTire {
    static constexpr double area = 0.9;
    static constexpr double conductance = 0.29 * area / 0.010;
    static constexpr double surface = 1100.0 * 1800.0 * 0.001;  // J/K
    static constexpr double bulk = 1100.0 * 1800.0 * 0.006;

    static Problem problem(double film) {
        Problem tire;
        tire.mesh = mesh::build(
            mesh::TwoNode{.area = area, .surface_volume = 0.001, .bulk_volume = 0.006, .bulk_depth = 0.010});
        tire.materials.assign(2, material(physics::Curve::constant(0.29)));
        tire.link_laws = {physics::Curve::constant(0.29)};
        act(tire, "conduction");
        act(tire, "still_air", {{"h", film}});
        tire.effects.back().patches = {0};
        hold(tire, "air_temperature", 300.0);
        tire.initial = {330.0, 350.0};
        tire.channels = {{.name = "surface", .meaning = "", .where = tire.mesh.regions[0].mean},
                         {.name = "bulk", .meaning = "", .where = tire.mesh.regions[1].mean}};
        return tire;
    }

    using Pair = std::array<double, 2>;
    static Pair flow(const Pair& T, double film, double air) {
        const double through = conductance * (T[1] - T[0]);
        return {through + film * area * (air - T[0]), -through};
    }
    /// C T + s K T = right, with a source s hA T_air for the surface that is in `right` already.
    static Pair solve(double s, double film, const Pair& right) {
        const double a = surface + s * (conductance + film * area);
        const double b = -s * conductance;
        const double d = bulk + s * conductance;
        const double determinant = a * d - b * b;
        return {(d * right[0] - b * right[1]) / determinant, (a * right[1] - b * right[0]) / determinant};
    }
    /// TR-BDF2: C T_i = C T_0 + dt sum_j a_ij q_j with rows (0, 0, 0), (d, d, 0), (w, w, d).
    static Pair step(const Pair& T, double film, double air_from, double air_to, double dt) {
        const double d = 1.0 - 0.5 * std::numbers::sqrt2;
        const double w = 0.25 * std::numbers::sqrt2;
        const double between = air_from + (2.0 - std::numbers::sqrt2) * (air_to - air_from);
        const double s = d * dt;
        const Pair q0 = flow(T, film, air_from);
        const Pair T1 =
            solve(s, film, {surface * T[0] + s * q0[0] + s * film * area * between, bulk * T[1] + s * q0[1]});
        const Pair q1 = flow(T1, film, between);
        return solve(s, film,
                     {surface * T[0] + w * dt * (q0[0] + q1[0]) + s * film * area * air_to,
                      bulk * T[1] + w * dt * (q0[1] + q1[1])});
    }
};

}  // namespace

TEST(StepSlopes, OfALinearTireAreThoseInClosedForm) {
    // With the state at the begin held and the air's temperature u going straight to u_1, of the two implicit stages
    //     (C + s K) S_1 = s g gamma                             g = (hA, 0)', gamma = 2 - sqrt 2, s = d dt
    //     (C + s K) S_2 = w dt (g gamma - K S_1) + s g          S = dT/du_1
    constexpr double film = 40.0;
    const double gamma = 2.0 - std::numbers::sqrt2;
    const double w = 0.25 * std::numbers::sqrt2;
    TunableSession session(session_model(LinearTire::problem(film), {}));
    for (const double dt : {0.1, 1.0, 20.0, 500.0}) {
        const double air = session.inputs().air_temperature;
        ASSERT_EQ(session.set_input(signal("air_temperature"), air + 3.0), "");
        ASSERT_TRUE(session.advance(dt).ok());
        const double s = (1.0 - 0.5 * std::numbers::sqrt2) * dt;
        const double g = film * LinearTire::area;
        const LinearTire::Pair first = LinearTire::solve(s, film, {s * g * gamma, 0.0});
        const LinearTire::Pair lost = LinearTire::flow(first, film, 0.0);  // -K S_1
        const LinearTire::Pair S =
            LinearTire::solve(s, film, {w * dt * (g * gamma + lost[0]) + s * g, w * dt * lost[1]});
        const std::vector<double> slopes = slopes_of(session, along("air_temperature", 2.0));
        for (std::size_t c = 0; c < 2; ++c) {
            // Channels are differences over 0.002 K of temperatures near 300 K with 16 digits: 3e-11.
            EXPECT_NEAR(slopes[c], 2.0 * S[c], 1e-10) << dt << " s";
        }
        EXPECT_GT(S[0], 0.0);
        EXPECT_LT(S[0], 1.0);
    }
}

TEST(StepSlopes, WithAParameterAreThoseOfTheStepWrittenOut) {
    // The film's h acts over the whole step, also in its first stage; the step of the two nodes is written out above.
    FreeParameter h;
    h.name = "still_air.h";
    h.effect = 1;
    h.low = 1.0;
    h.high = 200.0;
    TunableSession session(session_model(LinearTire::problem(40.0), {h}));
    const LinearTire::Pair T0{330.0, 350.0};
    ASSERT_EQ(session.set_input(signal("air_temperature"), 290.0), "");
    ASSERT_TRUE(session.advance(30.0).ok());
    const std::vector<double> slopes = slopes_of(session, {.inputs = {}, .parameters = {{0, 1.0}}});
    const LinearTire::Pair above = LinearTire::step(T0, 40.01, 300.0, 290.0, 30.0);
    const LinearTire::Pair below = LinearTire::step(T0, 39.99, 300.0, 290.0, 30.0);
    for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_NEAR(session.session().channel(c), LinearTire::step(T0, 40.0, 300.0, 290.0, 30.0)[c], 1e-9);
        // A quotient over 0.02 of temperatures with 16 digits is known to 6e-12, its bend to (0.01/40)^2 of the slope.
        EXPECT_NEAR(slopes[c], (above[c] - below[c]) / 0.02, 1e-7 * std::abs(slopes[0])) << c;
    }
}

namespace {

/// What a step of the session leads to when an input or a parameter is moved before it.
std::vector<double> after_step(TunableSession& session, const std::vector<double>& state, const physics::Signal* input,
                               double by, double dt) {
    EXPECT_TRUE(session.restore(state));
    if (input != nullptr) {
        EXPECT_EQ(session.set_input(*input, session.inputs().*input->member + by), "");
    } else {
        EXPECT_EQ(session.set_parameter(0, session.parameter(0) + by), "");
        session.apply_parameters();
    }
    EXPECT_TRUE(session.advance(dt).ok());
    return {session.session().channel(0), session.session().channel(1)};
}

Problem nonlinear_tire() {
    Problem problem = two_node_tire();
    problem.settings.tolerance = 1e-9;  // what is left of Newton's corrections is small beside the differences
    return problem;
}
FreeParameter film_of_air(const Problem& problem) {
    FreeParameter film;
    film.name = "air_convection.lambda_h";
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        film.effect = problem.effects[e].effect->id == "air_convection" ? e : film.effect;
    }
    film.parameter =
        static_cast<std::size_t>(physics::find_parameter(*physics::find_effect("air_convection"), "lambda_h"));
    film.low = 0.1;
    film.high = 10.0;
    return film;
}

}  // namespace

TEST(StepSlopes, OfANonlinearTireAreWhatDifferenceQuotientsComeTo) {
    // A central quotient is off by its bend, a fourth of it at half the distance. Richardson's limit of two of them is the
    // slope to the fourth power of the distance.
    const Problem problem = nonlinear_tire();
    TunableSession session(session_model(problem, {film_of_air(problem)}));
    for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(session.set_input(signal("speed"), 25.0 + 0.2 * i), "");
        ASSERT_TRUE(session.advance(2.0).ok());
    }
    const std::vector<double> state = session.state();
    const auto check = [&](const physics::Signal* input, double far, const SessionDirection& direction) {
        static_cast<void>(after_step(session, state, input, 0.0, 3.0));
        // Of the parameter no step is known after it was set; a step without a move is the one meant.
        ASSERT_TRUE(session.restore(state));
        ASSERT_TRUE(session.advance(3.0).ok());
        const std::vector<double> slopes = slopes_of(session, direction);
        std::array<std::vector<double>, 2> quotients;
        for (int k = 0; k < 2; ++k) {
            const double by = far / (k + 1);
            const std::vector<double> above = after_step(session, state, input, by, 3.0);
            const std::vector<double> below = after_step(session, state, input, -by, 3.0);
            quotients[static_cast<std::size_t>(k)] = {(above[0] - below[0]) / (2.0 * by),
                                                      (above[1] - below[1]) / (2.0 * by)};
        }
        for (std::size_t c = 0; c < 2; ++c) {
            const double wide = std::abs(quotients[0][c] - slopes[c]);
            const double close = std::abs(quotients[1][c] - slopes[c]);
            const double limit = (4.0 * quotients[1][c] - quotients[0][c]) / 3.0;
            EXPECT_NEAR(slopes[c], limit, 2e-6 * std::abs(limit)) << c;
            if (wide > 1e-4 * std::abs(limit)) {
                EXPECT_NEAR(wide / close, 4.0, 0.2) << c;
            }
        }
    };
    check(&signal("speed"), 4.0, along("speed"));
    check(&signal("vertical_load"), 800.0, along("vertical_load"));
    check(&signal("air_temperature"), 10.0, along("air_temperature"));
    check(nullptr, 0.3, {.inputs = {}, .parameters = {{0, 1.0}}});
}

TEST(StepSlopes, OfAMeshFollowItsPropertiesItsSurfacesAndASensorsLag) {
    // Surfaces without capacity follow a film at once, also at the begin of the step; heat capacity acts on what is stored there, too.
    // The channels: mean of the strip, its mean and a surface as a slow sensor shows them.
    Problem problem = heated_strip(20);
    problem.settings.tolerance = 1e-10;
    problem.channels.push_back(problem.channels.front());
    problem.channels.push_back({.name = "surface", .meaning = "", .where = {{problem.mesh.n_cells}, {1.0}}});
    act(problem, "sensor_lag", {{"tau", 15.0}});
    problem.effects.back().channels = {1, 2};
    FreeParameter film;
    film.name = "still_air.h";
    film.effect = 1;
    FreeParameter capacity;
    capacity.name = "heat_capacity";
    capacity.kind = FreeParameter::Kind::heat_capacity;
    capacity.layers = {0};
    capacity.knots = {300.0};
    FreeParameter conductivity = capacity;
    conductivity.kind = FreeParameter::Kind::conductivity;
    TunableSession session(session_model(problem, {film, capacity, conductivity}));
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(session.advance(20.0).ok());
    }
    const std::vector<double> state = session.state();
    const auto stepped = [&](std::size_t index, double to) {
        EXPECT_TRUE(session.restore(state));
        EXPECT_EQ(session.set_parameter(index, to), "");
        session.apply_parameters();
        EXPECT_TRUE(session.advance(20.0).ok());
        return std::array{session.session().channel(0), session.session().channel(1), session.session().channel(2)};
    };
    for (std::size_t index = 0; index < 3; ++index) {
        ASSERT_TRUE(session.restore(state));
        ASSERT_TRUE(session.advance(20.0).ok());
        std::vector<double> slopes(3);
        ASSERT_TRUE(session.find_slopes({.inputs = {}, .parameters = {{index, 1.0}}}, slopes).ok());
        const double value = session.parameter(index);
        const auto above = stepped(index, 1.001 * value);
        const auto below = stepped(index, 0.999 * value);
        for (std::size_t c = 0; c < 3; ++c) {
            // The quotient's bend is some (1e-3)^2 of it; Newton's corrections leave less than 1e-11 K over it.
            const double quotient = (above[c] - below[c]) / (0.002 * value);
            EXPECT_NEAR(slopes[c], quotient, 1e-5 * std::abs(quotient)) << "parameter " << index << ", channel " << c;
            EXPECT_NE(quotient, 0.0);
        }
    }
}

TEST(StepSlopes, AddUpAlongADirection) {
    const Problem problem = nonlinear_tire();
    TunableSession session(session_model(problem, {film_of_air(problem)}));
    ASSERT_TRUE(session.advance(5.0).ok());
    const std::vector<double> speed = slopes_of(session, along("speed"));
    const std::vector<double> air = slopes_of(session, along("air_temperature"));
    const std::vector<double> film = slopes_of(session, {.inputs = {}, .parameters = {{0, 1.0}}});
    const std::vector<double> both = slopes_of(
        session,
        {.inputs = {{&signal("speed"), 2.0}, {&signal("air_temperature"), -3.0}, {&signal("vertical_load"), 0.0}},
         .parameters = {{0, 0.5}}});
    for (std::size_t c = 0; c < 2; ++c) {
        const double sum = 2.0 * speed[c] - 3.0 * air[c] + 0.5 * film[c];
        EXPECT_NEAR(both[c], sum, 1e-6 * std::abs(3.0 * air[c])) << c;
    }
    EXPECT_EQ(slopes_of(session, {}), (std::vector<double>{0.0, 0.0}));
}

TEST(StepSlopes, LeaveTheSessionAsItIs) {
    // Also after a step that was refused, and with steps of several lengths: the kept factors are not touched.
    for (const Problem& problem : {two_node_tire(), heated_strip(60)}) {
        TunableSession asked(session_model(problem, {}));
        TunableSession left_alone(session_model(problem, {}));
        for (int i = 0; i < 40; ++i) {
            for (TunableSession* session : {&asked, &left_alone}) {
                ASSERT_EQ(session->set_input(signal("air_temperature"), 300.0 + 5.0 * std::sin(0.4 * i)), "");
                ASSERT_TRUE(session->advance(i % 3 == 0 ? 0.2 : 1.5).ok());
                ASSERT_FALSE(session->advance(-1.0).ok());
            }
            static_cast<void>(slopes_of(asked, along("air_temperature")));
            ASSERT_EQ(asked.session().channel(0), left_alone.session().channel(0)) << i;
        }
        EXPECT_EQ(asked.state(), left_alone.state());
    }
}

TEST(StepSlopes, BeforeTheFirstStepAreThoseOfTheBegin) {
    FreeParameter initial;
    initial.name = "initial";
    initial.kind = FreeParameter::Kind::initial;
    initial.nodes = {0, 1};
    TunableSession session(session_model(two_node_tire(), {initial}));
    const std::vector<double> with_start = slopes_of(session, {.inputs = {}, .parameters = {{0, 1.0}}});
    EXPECT_NEAR(with_start[0], 1.0, 1e-9);
    EXPECT_NEAR(with_start[1], 1.0, 1e-9);
    EXPECT_EQ(slopes_of(session, along("speed")), (std::vector<double>{0.0, 0.0}));
}

TEST(StepSlopes, AreRefusedWhereTheStepIsNotKnown) {
    const Problem problem = two_node_tire();
    TunableSession session(session_model(problem, {film_of_air(problem)}));
    std::vector<double> slopes(2);
    const auto known = [&] { return session.find_slopes(along("speed"), slopes).ok(); };
    EXPECT_TRUE(known());
    ASSERT_TRUE(session.advance(1.0).ok());
    EXPECT_TRUE(known());
    ASSERT_TRUE(session.restore(session.state()));
    EXPECT_FALSE(known());
    ASSERT_TRUE(session.advance(1.0).ok());
    EXPECT_TRUE(known());
    ASSERT_EQ(session.set_parameter(0, 2.0), "");
    session.apply_parameters();
    EXPECT_FALSE(known());
    ASSERT_TRUE(session.advance(1.0).ok());
    EXPECT_TRUE(known());
}

TEST(StepSlopes, AtABoundGoToOneSide) {
    TunableSession session(session_model(LinearTire::problem(40.0), {}));
    ASSERT_EQ(session.set_input(signal("air_temperature"), signal("air_temperature").high), "");
    ASSERT_TRUE(session.advance(1.0).ok());
    const std::vector<double> at_bound = slopes_of(session, along("air_temperature"));
    ASSERT_EQ(session.set_input(signal("air_temperature"), 300.0), "");
    ASSERT_TRUE(session.advance(1.0).ok());
    EXPECT_NEAR(at_bound[0], slopes_of(session, along("air_temperature"))[0], 1e-9)
        << "of a linear tire it is the same";
}

}  // namespace tiretherm::solver
