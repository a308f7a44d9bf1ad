// SPDX-License-Identifier: BSD-3-Clause
// What a case with [vehicle] makes of the log of a car, against a car whose loads and slips are known.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/measurements/experiment.hpp"
#include "input/vehicle/corner_signals.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

constexpr double g = 9.80665;
constexpr std::size_t n_samples = 1201;
constexpr double step = 0.05;  // s

/// A car on a winding road. Its motion is given by formulas, and so are its loads and slips, which are written here once
/// more and share nothing with the model: 1200 kg, a = 1.4 m, b = 1.1 m, h = 0.5 m, tracks 1.5 m, 60 % of the roll
/// stiffness in front, I = m a b = 1848 kg m2, linear tires of 90 and 100 kN/rad and kN.
struct Truth {
    double V, ax, ay, r, dr;

    explicit Truth(double t)
        : V(30.0 + 3.0 * std::sin(0.2 * t)),
          ax(0.6 * std::cos(0.2 * t)),
          ay(V * 0.2 * std::sin(0.3 * t)),
          r(0.2 * std::sin(0.3 * t)),
          dr(0.06 * std::cos(0.3 * t)) {}

    [[nodiscard]] double load(bool front, bool left) const {
        const double axle = front ? 1200.0 * (g * 1.1 - ax * 0.5) / 2.5 : 1200.0 * (g * 1.4 + ax * 0.5) / 2.5;
        const double transfer = (front ? 0.6 : 0.4) * 1200.0 * ay * 0.5 / 1.5;
        return 0.5 * axle + (left ? -transfer : transfer);
    }
    [[nodiscard]] double axle_force(bool front) const {
        const double of_front = (1200.0 * ay * 1.1 + 1848.0 * dr) / 2.5;
        return front ? of_front : 1200.0 * ay - of_front;
    }
    /// Tires of an axle at one angle, with C in proportion to the load. In the mirror on the left.
    [[nodiscard]] double tan_slip_angle(bool front, bool left) const {
        const double per_load = front ? 90e3 / (0.5 * 1200.0 * g * 1.1 / 2.5) : 100e3 / (0.5 * 1200.0 * g * 1.4 / 2.5);
        return (left ? -1.0 : 1.0) * axle_force(front) / per_load / (load(front, true) + load(front, false));
    }
    /// sigma = kappa/(1 + kappa) of half an axle's force: the rear drives, brakes share 65 to 35.
    [[nodiscard]] double slip_ratio(bool front, bool left) const {
        const double share = ax >= 0.0 ? (front ? 0.0 : 1.0) : (front ? 0.65 : 0.35);
        const double per_load = front ? 90e3 / (0.5 * 1200.0 * g * 1.1 / 2.5) : 100e3 / (0.5 * 1200.0 * g * 1.4 / 2.5);
        const double sigma = 0.5 * share * 1200.0 * ax / per_load / load(front, left);
        return sigma / (1.0 - sigma);
    }
};

/// @param heads of the columns behind the time  @param line their values at a time
std::string log_of_the_truth(const std::string& heads, const std::function<std::string(const Truth&, double)>& line) {
    std::string text = "time [s]," + heads + "\n";
    for (std::size_t i = 0; i < n_samples; ++i) {
        const double t = step * static_cast<double>(i);
        text += fmt::format("{:.3f},{}\n", t, line(Truth(t), t));
    }
    return text;
}

/// @param side -1: the lateral acceleration is positive in right turns
std::string plain_log(double side = 1.0) {
    return log_of_the_truth("V [km/h],AccY [g],AccX [m/s2],yaw_rate [deg/s]", [side](const Truth& truth, double) {
        return fmt::format("{:.9f},{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, side * truth.ay / g, truth.ax,
                           truth.r * 180.0 / 3.14159265358979323846);
    });
}

const std::string columns =
    "columns = { V = \"speed\", AccY = \"lateral_acceleration\", AccX = \"longitudinal_acceleration\" }\n";

/// @param vehicle more keys of [vehicle]  @param keys of the log
Reading read(const std::string& log, const std::string& vehicle, const std::string& keys = columns,
             const std::string& unset = "\"vehicle.friction\"") {
    const Written written;
    written.add("log.csv", log);
    const std::string base = (source_folder() / "tests/bad_cases/good/car.toml").string();
    return read_case(written.add("case.toml", "include = [\"" + base + "\"]\nunset = [" + unset + "]\n[vehicle]\n" +
                                                  vehicle + "\n[[drive.file]]\npath = \"log.csv\"\n" + keys));
}

solver::Problem problem_of(Reading reading) {
    if (!reading.problem) {
        ADD_FAILURE() << render(reading);
        return {};
    }
    return *reading.problem;
}

bool warns(const Reading& reading, std::string_view words) {
    return std::ranges::any_of(reading.warnings,
                               [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

/// Mean power of lateral sliding over the log. W
double lateral_power(const solver::Problem& problem) {
    double power = 0.0;
    for (std::size_t i = 0; i < n_samples; ++i) {
        const physics::Inputs in = problem.input_signals.at(step * static_cast<double>(i), solver::JumpSide::after);
        power += std::abs(in.lateral_force * in.speed * std::tan(in.slip_angle)) / n_samples;
    }
    return power;
}

}  // namespace

TEST(VehicleCase, LogGivesTheLoadsAndSlipsOfAKnownCar) {
    // Without smoothing everything but the yaw acceleration is exact at the samples. That one is the slope over 0.1 s:
    // off by h^2/6 of its second derivative, 0.05^2/6 x 0.0054 = 2e-6 rad/s2, times I/L less than 2e-3 N; at the ends, where
    // the slope is over 0.05 s on one side, by h/2 x 0.018 = 4.5e-4 rad/s2, 0.4 N, so these are left out.
    for (std::size_t corner = 0; corner < physics::n_corners; ++corner) {
        const std::string keys = fmt::format("corner = \"{}\"\nsmoothing = \"0 s\"\n", physics::corner_names[corner]);
        const solver::Problem problem = problem_of(read(plain_log(), keys));
        const bool front = corner < 2;
        const bool left = corner % 2 == 0;
        for (std::size_t i = 2; i + 2 < n_samples; ++i) {
            const double t = step * static_cast<double>(i);
            const Truth truth(t);
            const physics::Inputs in = problem.input_signals.at(t, solver::JumpSide::after);
            ASSERT_NEAR(in.vertical_load, truth.load(front, left), 1e-3) << t;
            ASSERT_NEAR(std::tan(in.slip_angle), truth.tan_slip_angle(front, left), 1e-6) << t;
            ASSERT_NEAR(in.slip_ratio, truth.slip_ratio(front, left), 1e-6) << t;
            ASSERT_NEAR(in.speed, truth.V + (left ? -0.75 : 0.75) * truth.r, 1e-6) << t;
        }
    }
}

TEST(VehicleCase, LoggerThatIsPositiveInRightTurnsIsFoundOut) {
    // The column has the other sign, the yaw rate says so, and the tire gets the same load.
    const Reading turned = read(plain_log(-1.0), "");
    EXPECT_TRUE(warns(turned,
                      "lateral_acceleration is taken as positive in right turns: its correlation with speed "
                      "times yaw_rate is -1.00"));
    const Reading plain = read(plain_log(), "");
    EXPECT_TRUE(warns(plain, "lateral_acceleration is taken as positive in left turns: its correlation"));
    for (const double t : {5.0, 20.0, 41.0}) {
        EXPECT_NEAR(problem_of(turned).input_signals.at(t, solver::JumpSide::after).vertical_load,
                    problem_of(plain).input_signals.at(t, solver::JumpSide::after).vertical_load, 1e-9);
    }
}

TEST(VehicleCase, WithoutYawRateTheSignIsThatOfIsoAndSaysSo) {
    // Ignored, the yaw rate tells nothing; a_y / V takes its place, and the assumption is a warning.
    const Reading reading = read(plain_log(), "", columns + "ignore = [\"yaw_rate\"]\n");
    EXPECT_TRUE(warns(reading, "lateral_acceleration is taken as positive in left turns (ISO 8855)"));
    EXPECT_TRUE(warns(reading, "yaw rate is lateral_acceleration over speed"));
    const Truth truth(20.0);
    EXPECT_NEAR(problem_of(reading).input_signals.at(20.0, solver::JumpSide::after).speed, truth.V - 0.75 * truth.r,
                1e-3);
}

TEST(VehicleCase, YawRateAloneTellsTheTurn) {
    // Here a_y = V r is exact, and a_x is the slope of the speed over 1 s: off by 0.5^2/6 x 0.024 = 1e-3 m/s2, 0.24 N.
    const Reading alone =
        read(plain_log(), "smoothing = \"0 s\"", "columns = { V = \"speed\" }\nignore = [\"AccY\", \"AccX\"]\n");
    EXPECT_TRUE(warns(alone, "lateral acceleration is speed times yaw_rate"));
    EXPECT_TRUE(warns(alone, "longitudinal acceleration is the slope of speed over 1 s"));
    EXPECT_NEAR(problem_of(alone).input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                Truth(20.0).load(true, true), 0.3);
}

TEST(VehicleCase, SteeringAloneTellsTheTurnOfALinearCar) {
    // K = m_f/C_f - m_r/C_r = 528/180e3 - 672/200e3 = -4.26667e-4; at 25 m/s and 2 deg of the road wheels
    // r = V delta/(L + K V^2) = 25 x 0.0349066/(2.5 - 0.2666667) = 0.3907454 rad/s; a_y = V r = 9.768634 m/s2:
    // dF = 0.6 x 1200 x 9.768634 x 0.5/1.5 = 2344.4721 N of 2588.9556 N.
    const std::string log = log_of_the_truth("speed [m/s],steering_wheel_angle [deg]",
                                             [](const Truth&, double) { return std::string("25,30"); });
    const Reading reading = read(log, "steering_ratio = 15", "");
    EXPECT_TRUE(warns(reading, "follow from steering_wheel_angle"));
    EXPECT_NEAR(problem_of(reading).input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                2588.9556 - 2344.4721, 1e-3);
}

TEST(VehicleCase, MeasuredLoadGoesBeforeTheComputedOne) {
    // The log's load of this wheel counts, also in its slip; the page says which inputs are computed and which are not.
    const std::string log = log_of_the_truth("speed [m/s],lateral_acceleration [m/s2],vertical_load [N]",
                                             [](const Truth&, double) { return std::string("30,2,3000"); });
    const Reading reading = read(log, "", "");
    EXPECT_TRUE(warns(reading, "at FL: vertical_load is not computed: the case gives it"));
    EXPECT_TRUE(warns(reading, "at FL: slip_angle, slip_ratio, lateral_force and longitudinal_force are"));
    const physics::Inputs in = problem_of(reading).input_signals.at(20.0, solver::JumpSide::after);
    EXPECT_EQ(in.vertical_load, 3000.0);
    // Right: 2588.9556 + 0.6 x 1200 x 2 x 0.5/1.5 = 3068.9556 N; the axle's 1056 N at tan(alpha) = Fy Fz_s/(C sum Fz).
    EXPECT_NEAR(std::tan(in.slip_angle), -1056.0 * 2588.9556 / 90e3 / 6068.9556, 1e-8);
}

TEST(VehicleCase, SmoothingKeepsNoiseOutOfTheFrictionPower) {
    // Power goes with the square of a_y: white noise of 1.5 m/s2 adds its variance, 2.25, to a mean square of 0.02 V^2/1,
    // about 18 (m/s2)^2: 12 %. A triangle over 0.4 s, 8 samples with weights (1/4) (1 - |k|/4) and a sum of squares of
    // 0.17, leaves 2 %; it takes nothing from a motion of 0.3 rad/s. Within 2 % for the luck of the draw.
    std::mt19937 random(9);
    std::normal_distribution<double> noise(0.0, 1.5);
    const std::string log =
        log_of_the_truth("V [km/h],AccY [m/s2],AccX [m/s2],yaw_rate [deg/s]", [&](const Truth& truth, double) {
            return fmt::format("{:.9f},{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, truth.ay + noise(random), truth.ax,
                               truth.r * 180.0 / 3.14159265358979323846);
        });
    const double clean = lateral_power(problem_of(read(plain_log(), "smoothing = \"0 s\"")));
    const double noisy = lateral_power(problem_of(read(log, "smoothing = \"0 s\"")));
    const Reading reading = read(log, "smoothing = \"0.4 s\"");
    const double smooth = lateral_power(problem_of(reading));
    EXPECT_GT(noisy / clean, 1.08);
    EXPECT_NEAR(smooth / clean, 1.02, 0.02);
    EXPECT_TRUE(warns(reading, "lateral_acceleration is smoothed over 0.4 s, which takes away 0.1"));
}

TEST(VehicleCase, GripThatIsNotThereIsCounted) {
    // 0.98 g on tires of friction 0.8: more than they give, at all times.
    const std::string log = log_of_the_truth("speed [m/s],lateral_acceleration [g]",
                                             [](const Truth&, double) { return std::string("30,0.98"); });
    const Written written;
    written.add("log.csv", log);
    const std::string base = (source_folder() / "tests/bad_cases/good/car.toml").string();
    const Reading slippery = read_case(written.add("case.toml", "include = [\"" + base +
                                                                    "\"]\n[vehicle]\ncorner = \"FR\"\nfriction = 0.8\n"
                                                                    "[[drive.file]]\npath = \"log.csv\"\n"));
    EXPECT_TRUE(warns(slippery, "at FR: the forces exceed what the tire can give in 100 % of the time"));
}

TEST(VehicleCase, EachRunMayHaveItsCorner) {
    // Two runs of one log: the tire at the front left in one, at the rear right in the other; the columns are inputs of the
    // car and not what a diagnosis may take for a cause.
    const Written written;
    written.add("log.csv", log_of_the_truth("V [km/h],AccY [g],AccX [m/s2],yaw_rate [deg/s],bulk_temperature [degC]",
                                            [](const Truth& truth, double t) {
                                                return fmt::format(
                                                    "{:.9f},{:.9f},{:.9f},{:.9f},{:.3f}", 3.6 * truth.V, truth.ay / g,
                                                    truth.ax, truth.r * 180.0 / 3.14159265358979323846, 30.0 + 0.1 * t);
                                            }));
    const std::string base = (source_folder() / "tests/bad_cases/good/car.toml").string();
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml",
        "include = [\"" + base + "\"]\n[vehicle]\nsmoothing = \"0 s\"\n[[run]]\nname = \"one\"\nfile = \"log.csv\"\n" +
            columns + "[[run]]\nname = \"two\"\nfile = \"log.csv\"\n" + columns + "vehicle = { corner = \"RR\" }\n"));
    ASSERT_TRUE(reading.experiment.has_value());
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_TRUE(runs[0].unused.empty());
    EXPECT_NEAR(runs[0].problem.input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                Truth(20.0).load(true, true), 1e-3);
    EXPECT_NEAR(runs[1].problem.input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                Truth(20.0).load(false, false), 1e-3);
}

// Written once more, in steps of 5 ms: 5000 J/K, 40 W/K, and the front left wheel's 32.5 % of m a_x wherever the car slows down. The
// program smooths the signals over 0.2 s, which blunts the power by less than 1 %.
TEST(VehicleCase, BrakeWarmsUpByThePowerOfBraking) {
    const solver::Problem problem = problem_of(read(plain_log(), "corner = \"FL\"\ndrag_area = \"0 m2\""));
    const auto inputs = [&](double t) { return problem.input_signals.at(t, solver::JumpSide::after); };
    const double air = inputs(0.0).air_temperature;
    double T = air;
    double hottest = air;
    for (int i = 0; i < 12000; ++i) {
        const Truth truth(0.005 * i);
        const double power = std::max(0.0, -0.325 * 1200.0 * truth.ax) * (truth.V - 0.75 * truth.r);
        T += 0.005 * (power - 40.0 * (T - air)) / 5000.0;
        hottest = std::max(hottest, T);
        if (i % 1000 == 0) {
            EXPECT_NEAR(inputs(0.005 * (i + 1)).brake_temperature, T, 0.01 * (hottest - air) + 0.02) << 0.005 * i;
        }
    }
    EXPECT_GT(hottest - air, 10.0);
    const solver::Problem stated =
        problem_of(read(plain_log(), "corner = \"FL\"\nbrake_heat_capacity = \"10 kJ/K\"\nbrake_cooling = \"0 W/K\""));
    EXPECT_LT(stated.input_signals.at(30.0, solver::JumpSide::after).brake_temperature, hottest);
}

// The rear tires are twice as stiff as the front ones: for the forces of the turn, far below the grip, they need half of the slip angle,
// within 5 % for the curvature. The front tires do not know of it.
TEST(VehicleCase, RearTiresMayHaveAFileOfTheirOwn) {
    const std::string tir = (source_folder() / "tests/input/data/made_up.tir").string();
    std::ifstream in(tir);
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t key = text.find("PKY1");
    ASSERT_NE(key, std::string::npos);
    const std::size_t number = text.find_first_of("-0123456789", text.find('=', key));
    const std::size_t end = text.find_first_not_of("-+.eE0123456789", number);
    text.replace(number, end - number, fmt::format("{}", 2.0 * std::stod(text.substr(number, end - number))));
    const Written written;
    const std::string stiff = written.add("stiff.tir", text);
    const std::string unset =
        R"("vehicle.friction", "vehicle.front_cornering_stiffness", "vehicle.rear_cornering_stiffness",
"vehicle.front_slip_stiffness", "vehicle.rear_slip_stiffness")";
    const auto slip_angle = [&](const std::string& corner, const std::string& rear) {
        const solver::Problem problem = problem_of(
            read(plain_log(), "corner = \"" + corner + "\"\nproperty_file = \"" + tir + "\"\n" + rear, columns, unset));
        return problem.input_signals.at(5.0, solver::JumpSide::after).slip_angle;
    };
    const std::string other = "rear_property_file = \"" + stiff + "\"\n";
    EXPECT_EQ(slip_angle("FR", other), slip_angle("FR", ""));
    const double alike = slip_angle("RR", "");
    EXPECT_GT(std::abs(alike), 1e-3);
    EXPECT_NEAR(slip_angle("RR", other) / alike, 0.5, 0.025);
}

// A fit moves a number of the car; what the tire then gets is what a case with that number would give it.
TEST(VehicleCase, MovedNumberIsThatOfACaseWithIt) {
    const std::string tir = (source_folder() / "tests/input/data/made_up.tir").string();
    struct Move {
        std::string_view key;
        std::string before;
        double value;
        std::string text;
        bool of_file = false;
        std::string beside{};  ///< what else it needs
        std::string unset{};
    };
    const std::vector<Move> moves{
        {"mass", "\"1200 kg\"", 1400.0, "\"1400 kg\""},
        {"wheelbase", "\"2.5 m\"", 2.7, "\"2.7 m\""},
        {"front_track", "\"1.5 m\"", 1.6, "\"1.6 m\""},
        {"rear_track", "\"1.5 m\"", 1.7, "\"1.7 m\""},
        {"centre_of_gravity_height", "\"0.5 m\"", 0.6, "\"60 cm\""},
        {"front_weight_share", "0.44", 0.5, "0.5"},
        {"yaw_inertia", "\"1848 kg m2\"", 2000.0, "\"2000 kg m2\""},
        {"front_roll_centre_height", "\"0 m\"", 0.1, "\"10 cm\""},
        {"rear_roll_centre_height", "\"0 m\"", 0.1, "\"10 cm\""},
        {"front_roll_stiffness_share", "0.6", 0.5, "0.5"},
        {"front_toe_in", "\"0 rad\"", 0.002, "\"0.002 rad\""},
        {"rear_toe_in", "\"0 rad\"", 0.002, "\"0.002 rad\""},
        {"drag_area", "\"0 m2\"", 0.8, "\"0.8 m2\""},
        {"air_density", "\"1.2 kg/m3\"", 1.0, "\"1 kg/m3\"", false, "drag_area = \"0.8 m2\"\n"},
        {"downforce_area", "\"0.5 m2\"", 1.5, "\"1.5 m2\"", false, "front_downforce_share = 0.4\n"},
        {"front_downforce_share", "0.4", 0.6, "0.6", false, "downforce_area = \"1.5 m2\"\n"},
        {"front_drive_share", "0.3", 0.5, "0.5", false, "driven_axle = \"all\"\n"},
        {"centre_of_gravity_behind_front_axle", "\"1.4 m\"", 1.2, "\"1.2 m\"", false, "",
         ", \"vehicle.front_weight_share\""},
        {"front_brake_share", "0.65", 0.7, "0.7"},
        {"front_cornering_stiffness", "\"90 kN/rad\"", 110e3, "\"110 kN/rad\""},
        {"rear_cornering_stiffness", "\"100 kN/rad\"", 110e3, "\"110 kN/rad\""},
        {"front_slip_stiffness", "\"90 kN\"", 110e3, "\"110 kN\""},
        {"rear_slip_stiffness", "\"100 kN\"", 110e3, "\"110 kN\""},
        {"friction", "1.1", 1.3, "1.3"},
        {"friction_scale", "1", 1.2, "1.2", true},
        {"stiffness_scale", "1", 1.2, "1.2", true},
        {"brake_heat_capacity", "\"5 kJ/K\"", 8000.0, "\"8 kJ/K\""},
        {"brake_cooling", "\"40 W/K\"", 70.0, "\"70 W/K\""}};
    for (const physics::Corner corner : {physics::Corner::front_left, physics::Corner::rear_right}) {
        const std::string at =
            fmt::format("corner = \"{}\"\n", physics::corner_names[static_cast<std::size_t>(corner)]);
        for (const Move& move : moves) {
            constexpr std::string_view stiffnesses = R"(, "vehicle.front_cornering_stiffness",
"vehicle.rear_cornering_stiffness", "vehicle.front_slip_stiffness", "vehicle.rear_slip_stiffness")";
            const std::string unset =
                fmt::format("\"vehicle.friction\"{}{}", move.of_file ? stiffnesses : std::string_view(), move.unset);
            const std::string tires = move.of_file             ? "property_file = \"" + tir + "\"\n"
                                      : move.key == "friction" ? ""
                                                               : "friction = 1.1\n";
            const auto car_with = [&](const std::string& text) {
                return problem_of(read(plain_log(), at + tires + move.beside + fmt::format("{} = {}\n", move.key, text),
                                       columns, unset));
            };
            const solver::Problem other = car_with(move.text);
            solver::Problem moved = car_with(move.before);
            const auto spec = std::ranges::find(vehicle_numbers(), move.key, &VehicleNumberSpec::key);
            ASSERT_NE(spec, vehicle_numbers().end()) << move.key;
            const solver::FreeParameter number{.name = std::string(move.key),
                                               .unit = {},
                                               .kind = solver::FreeParameter::Kind::input,
                                               .parameter = static_cast<std::size_t>(spec - vehicle_numbers().begin()),
                                               .layers = {},
                                               .knots = {},
                                               .nodes = {},
                                               .runs = {}};
            const solver::Problem before = moved;
            solver::move(moved, number, solver::value_of(moved, number), move.value);
            double change = 0.0;
            for (std::size_t i = 0; i < n_samples; ++i) {
                const double t = step * static_cast<double>(i);
                const physics::Inputs ours = moved.input_signals.at(t, solver::JumpSide::after);
                const physics::Inputs theirs = other.input_signals.at(t, solver::JumpSide::after);
                const physics::Inputs old = before.input_signals.at(t, solver::JumpSide::after);
                ASSERT_NEAR(ours.vertical_load, theirs.vertical_load, 1e-8) << move.key;
                ASSERT_NEAR(ours.slip_angle, theirs.slip_angle, 1e-9) << move.key;
                ASSERT_NEAR(ours.slip_ratio, theirs.slip_ratio, 1e-9) << move.key;
                ASSERT_NEAR(ours.lateral_force, theirs.lateral_force, 1e-8) << move.key;
                ASSERT_NEAR(ours.longitudinal_force, theirs.longitudinal_force, 1e-8) << move.key;
                ASSERT_NEAR(ours.speed, theirs.speed, 1e-9) << move.key;
                ASSERT_NEAR(ours.brake_temperature, theirs.brake_temperature, 1e-8) << move.key;
                change = std::max(
                    {change, std::abs(ours.vertical_load - old.vertical_load),
                     1e4 * std::abs(ours.slip_angle - old.slip_angle), 1e4 * std::abs(ours.slip_ratio - old.slip_ratio),
                     std::abs(ours.lateral_force - old.lateral_force), 1e2 * std::abs(ours.speed - old.speed),
                     std::abs(ours.brake_temperature - old.brake_temperature)});
            }
            const bool is_of_front = move.key == "front_toe_in" || move.key == "front_cornering_stiffness" ||
                                     move.key == "front_slip_stiffness";
            const bool is_of_rear = move.key.starts_with("rear_");
            const bool counts_here = corner == physics::Corner::front_left ? !is_of_rear : !is_of_front;
            EXPECT_TRUE(change > 0.1 || !counts_here) << move.key << " changes nothing";
        }
    }
}

// The turn that the steering tells, and its limit of ten times that of a car without slip beyond the critical speed, which only a fit
// can pass: L + K V^2 = 2.5 - 4.26667e-4 x 25^2 = 2.233 m with 90 kN/rad in front, 0.25 m where it would be less.
TEST(VehicleCase, MovedSteeringTellsAnotherTurn) {
    const std::string log = log_of_the_truth("speed [m/s],steering_wheel_angle [deg]",
                                             [](const Truth&, double) { return std::string("25,3"); });
    const auto number = [](VehicleNumber of) {
        return solver::FreeParameter{.name = {},
                                     .unit = {},
                                     .kind = solver::FreeParameter::Kind::input,
                                     .parameter = static_cast<std::size_t>(of),
                                     .layers = {},
                                     .knots = {},
                                     .nodes = {},
                                     .runs = {}};
    };
    const auto load = [](const solver::Problem& problem) {
        return problem.input_signals.at(20.0, solver::JumpSide::after).vertical_load;
    };
    solver::Problem moved = problem_of(read(log, "steering_ratio = 15", ""));
    solver::move(moved, number(VehicleNumber::steering_ratio), 15.0, 12.0);
    EXPECT_NEAR(load(moved), load(problem_of(read(log, "steering_ratio = 12", ""))), 1e-8);
    // K = 528/18e6 - 672/200e3 = -3.33067e-3: L + K V^2 = 0.418 m with 9 MN/rad in front; 40 kN/rad behind make it 528/18e6 -
    // 672/80e3 = -8.37067e-3 and L + K V^2 < 0, so that r = V delta/0.25 m with delta = 3 deg/15: a_y = 25^2 0.00349066/0.25 =
    // 8.72665 m/s2, and FL carries 2588.9556 - 0.6 1200 8.72665 0.5/1.5 = 494.56 N.
    solver::Problem oversteering = problem_of(read(log, "steering_ratio = 15", ""));
    solver::move(oversteering, number(VehicleNumber::front_cornering_stiffness), 90e3, 9e6);
    solver::move(oversteering, number(VehicleNumber::rear_cornering_stiffness), 100e3, 40e3);
    EXPECT_NEAR(load(oversteering), 494.56, 0.01);
}

}  // namespace tiretherm::input
