// SPDX-License-Identifier: BSD-3-Clause
// Numbers by which inputs are computed: slopes beside differences of whole runs, also of what sensors read of the inputs.

#include <cmath>
#include <memory>

#include "solver/bench.hpp"
#include "solver/sensitivity/slopes.hpp"

namespace tiretherm::solver {

namespace {

/// Load and speed of a made-up car: 2 kN plus a share of its weight that swings; its speed in a turn.
class Swing final : public InputModel {
public:
    void apply(std::span<const double> numbers, InputSignals& into) const override {
        std::vector<double> time;
        std::vector<double> load;
        std::vector<double> speed;
        for (int i = 0; i <= 1200; ++i) {
            const double t = 0.5 * i;
            const double turn = std::sin(2.0 * 3.14159265358979 * t / 60.0);
            time.push_back(t);
            load.push_back(2000.0 + numbers[0] * (2.0 + numbers[1] * turn));
            speed.push_back(30.0 + 5.0 * numbers[1] * turn);
        }
        const auto put = [&](const char* name, std::vector<double> value) {
            into.replace(
                {.signal = physics::find_signal(name), .time = time, .value = std::move(value), .logged = true});
        };
        put("vertical_load", std::move(load));
        put("speed", std::move(speed));
    }
    [[nodiscard]] std::vector<const physics::Signal*> signals() const override {
        return {physics::find_signal("vertical_load"), physics::find_signal("speed")};
    }
    void add_to(Digest& digest) const override { digest.add("swing"); }
};

Problem swung_tire() {
    Problem problem = two_node_tire();
    problem.input_signals = {};
    hold(problem, "air_temperature", 296.15);
    hold(problem, "road_temperature", 300.15);
    problem.input_model = std::make_shared<Swing>();
    problem.input_numbers = {1000.0, 0.7};
    problem.input_model->apply(problem.input_numbers, problem.input_signals);
    return problem;
}

FreeParameter input_number(std::size_t index, double prior) {
    return {.name = "number",
            .unit = {},
            .kind = FreeParameter::Kind::input,
            .parameter = index,
            .layers = {},
            .knots = {},
            .nodes = {},
            .runs = {},
            .prior = prior};
}

}  // namespace

TEST(InputNumber, SlopesAreThoseOfDifferences) {
    expect_differences(swung_tire(), {input_number(0, 1000.0), input_number(1, 0.7)});
}

// The drag follows the heat that is lost, the loaded radius the load itself: both change at once, as no temperature does.
TEST(InputNumber, SensorsOfHeatAndLoadFollowIt) {
    Problem problem = swung_tire();
    hold(problem, "inflation_pressure", 2e5);
    for (const auto& [name, quantity] :
         {std::pair{"drag", Quantity::drag_force}, std::pair{"radius", Quantity::loaded_radius}}) {
        problem.channels.push_back(
            {.name = name, .meaning = "", .where = problem.channels.front().where, .quantity = quantity});
    }
    expect_differences(problem, {input_number(0, 1000.0), input_number(1, 0.7)});
}

TEST(InputNumber, MovesCommuteAndTakeBackWhatTheyDid) {
    const Problem before = swung_tire();
    Problem one = before;
    Problem other = before;
    const FreeParameter mass = input_number(0, 1000.0);
    const FreeParameter swing = input_number(1, 0.7);
    move(one, mass, 1000.0, 1200.0);
    move(one, swing, 0.7, 0.5);
    move(other, swing, 0.7, 0.5);
    move(other, mass, 1000.0, 1200.0);
    EXPECT_EQ(one.input_signals.at(15.0, JumpSide::after), other.input_signals.at(15.0, JumpSide::after));
    EXPECT_EQ(one.input_signals.at(15.0, JumpSide::after).vertical_load, 2000.0 + 1200.0 * (2.0 + 0.5));
    move(one, mass, 1200.0, 1000.0);
    move(one, swing, 0.5, 0.7);
    EXPECT_EQ(one.input_signals.at(15.0, JumpSide::after), before.input_signals.at(15.0, JumpSide::after));
}

}  // namespace tiretherm::solver
