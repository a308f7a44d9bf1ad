// SPDX-License-Identifier: BSD-3-Clause
// Speed along the circuit by passes forwards and backwards, then loads, forces and slips of the wheels, then their heat.

#include "car/car_truth.hpp"

#include <algorithm>
#include <cmath>

namespace hidden_effects {

namespace {

constexpr double g = 9.80665;
constexpr double air_density = 1.19;
constexpr double engine = 152e3;         // W at the wheels
constexpr double traction = 5.2;         // m/s2
constexpr double braking = 9.0;          // m/s2
constexpr double brake_pressure = 62.0;  // bar at full braking
constexpr double pit_exit = 2.5;         // m/s2, from a standing start

double drag(const Car& car, double v) { return 0.5 * air_density * car.drag_area * v * v; }

/// Acceleration sideways that the grip leaves.
double sideways_limit(const Car& car, double v) {
    return 0.80 * car.grip * (g - 0.5 * air_density * car.lift_area * v * v / car.mass);
}

/// What is left of an acceleration forwards beside one sideways (a circle of friction).
double left_of(double whole, const Car& car, double v, double curvature) {
    const double used = v * v * std::abs(curvature) / sideways_limit(car, v);
    return whole * std::sqrt(std::max(0.0, 1.0 - used * used));
}

/// Speed of a flying lap at each point of the circuit. m/s
std::vector<double> fastest(const Circuit& circuit, const Car& car) {
    const std::size_t n = circuit.curvature.size();
    std::vector<double> v(n, 70.0);
    for (std::size_t i = 0; i < n; ++i) {
        for (int again = 0; again < 20; ++again) {  // the limit grows with the speed
            v[i] =
                std::min(70.0, std::sqrt(sideways_limit(car, v[i]) / std::max(1e-6, std::abs(circuit.curvature[i]))));
        }
    }
    for (std::size_t k = 0; k < 2 * n; ++k) {  // twice round closes the lap
        const std::size_t i = k % n;
        const std::size_t next = (i + 1) % n;
        const double push = std::min(engine / (car.mass * std::max(v[i], 5.0)), traction) - drag(car, v[i]) / car.mass;
        const double a = std::min(push, left_of(traction, car, v[i], circuit.curvature[i]));
        v[next] = std::min(v[next], std::sqrt(std::max(1.0, v[i] * v[i] + 2.0 * a * circuit.step)));
    }
    for (std::size_t k = 2 * n; k-- > 0;) {
        const std::size_t i = k % n;
        const std::size_t next = (i + 1) % n;
        const double a = left_of(braking, car, v[next], circuit.curvature[next]);
        v[i] = std::min(v[i], std::sqrt(v[next] * v[next] + 2.0 * a * circuit.step));
    }
    return v;
}

/// How hard a lap is driven: out of the pits, two to warm up, then near the limit, each a little different.
double pace(int lap) {
    constexpr std::array<double, 8> of_lap{0.78, 0.90, 0.96, 0.985, 0.99, 0.975, 0.99, 0.93};
    return of_lap[static_cast<std::size_t>(lap) % of_lap.size()];
}

/// dx/dt by central differences.
std::vector<double> rate_of(const std::vector<double>& x, double interval) {
    std::vector<double> rate(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t a = i > 0 ? i - 1 : i;
        const std::size_t b = std::min(i + 1, x.size() - 1);
        rate[i] = (x[b] - x[a]) / (interval * static_cast<double>(b - a));
    }
    return rate;
}

/// x behind by a lag of the first order, exact for straight lines between samples.
std::vector<double> behind(const std::vector<double>& x, double lag, double interval) {
    std::vector<double> y(x.size());
    y[0] = x[0];
    const double kept = std::exp(-interval / lag);
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double slope = (x[i] - x[i - 1]) / interval;
        y[i] = x[i] - lag * slope + (y[i - 1] - x[i - 1] + lag * slope) * kept;
    }
    return y;
}

/// The slip at which a tire makes a force: F = D sin(1.4 atan(B s)), with D the grip and B from the stiffness.
double slip_of(double force, double load, double grip, double stiffness) {
    constexpr double shape = 1.4;
    const double share = std::min(0.985, std::abs(force) / std::max(1.0, grip * load));
    const double slip = std::tan(std::asin(share) / shape) * grip * shape / stiffness;
    return std::copysign(slip, force);
}

void carry(const Car& car, Session& session, double interval) {
    const std::vector<double> forwards = behind(session.forwards, car.roll_lag, interval);
    const std::vector<double> leftwards = behind(session.leftwards, car.roll_lag, interval);
    const std::vector<double> yaw = rate_of(session.yaw_rate, interval);
    const double to_rear = car.wheelbase - car.to_front;
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        const double v = session.speed[i];
        const double down = -0.5 * air_density * car.lift_area * v * v;
        const double pitch = car.mass * forwards[i] * car.height / car.wheelbase;
        const double front = car.mass * g * to_rear / car.wheelbase + car.lift_share_front * down - pitch;
        const double rear = car.mass * g * car.to_front / car.wheelbase + (1.0 - car.lift_share_front) * down + pitch;
        const double roll = car.mass * leftwards[i] * car.height;
        const double over_front = car.roll_share_front * roll / car.track_front;
        const double over_rear = (1.0 - car.roll_share_front) * roll / car.track_rear;
        const std::array<double, n_wheels> load{0.5 * front - over_front, 0.5 * front + over_front,
                                                0.5 * rear - over_rear, 0.5 * rear + over_rear};
        const double turn = car.yaw_inertia * yaw[i] / car.wheelbase;
        const double side_front = car.mass * session.leftwards[i] * to_rear / car.wheelbase + turn;
        const double side_rear = car.mass * session.leftwards[i] * car.to_front / car.wheelbase - turn;
        const double along = car.mass * session.forwards[i] + drag(car, v);
        const double along_front = along < 0.0 ? car.brake_share_front * along : 0.0;
        const double along_rear = along - along_front;
        for (std::size_t w = 0; w < n_wheels; ++w) {
            WheelCourse& wheel = session.wheels[w];
            const bool is_front = w < rear_left;
            const double carried = std::max(20.0, load[w]);
            const double of_axle = carried / (is_front ? front : rear);
            wheel.load.push_back(carried);
            wheel.lateral.push_back(of_axle * (is_front ? side_front : side_rear));
            wheel.longitudinal.push_back(0.5 * (is_front ? along_front : along_rear));
            wheel.slip_angle.push_back(slip_of(wheel.lateral.back(), carried, car.grip, car.stiffness));
            wheel.slip_ratio.push_back(slip_of(wheel.longitudinal.back(), carried, car.grip, car.slip_stiffness));
        }
        const double curvature = v > 1.0 ? session.yaw_rate[i] / v : 0.0;
        const double steered =
            car.wheelbase * curvature +
            0.5 * (session.wheels[front_left].slip_angle[i] + session.wheels[front_right].slip_angle[i] -
                   session.wheels[rear_left].slip_angle[i] - session.wheels[rear_right].slip_angle[i]);
        session.steering.push_back(car.steering_ratio * steered);
        session.throttle.push_back(std::clamp(along_rear * v / engine, 0.0, 1.0));
        session.brake.push_back(along < 0.0 ? brake_pressure * -along / (car.mass * braking) : 0.0);
    }
}

/// Temperature of a brake disc: 3.2 kJ/K, warmed by its wheel's braking force, cooled by 30 W/K. Heun's method.
std::vector<double> disc_of(const Session& session, const WheelCourse& wheel, double interval) {
    constexpr double capacity = 3200.0;
    constexpr double cooling = 30.0;
    const auto rate = [&](double T, std::size_t i) {
        const double power = std::max(0.0, -wheel.longitudinal[i]) * session.speed[i];
        return (power - cooling * (T - session.air)) / capacity;
    };
    std::vector<double> disc{session.air};
    for (std::size_t i = 0; i + 1 < session.time.size(); ++i) {
        const double first = rate(disc.back(), i);
        const double second = rate(disc.back() + interval * first, i + 1);
        disc.push_back(disc.back() + 0.5 * interval * (first + second));
    }
    return disc;
}

/// Both lumps of each tire, by the equations of the bench. Its friction knows a lateral force and a slip angle alone: those of
/// the same power stand in their place.
void heat(const HiddenInCar& hidden, Session& session) {
    constexpr double stand_in = 0.1;  // rad
    for (std::size_t w = 0; w < n_wheels; ++w) {
        WheelCourse& wheel = session.wheels[w];
        Programme programme{.time = session.time,
                            .speed = session.speed,
                            .vertical_load = wheel.load,
                            .slip_angle = std::vector<double>(session.time.size(), stand_in),
                            .lateral_force = {},
                            .air_temperature = std::vector<double>(session.time.size(), session.air),
                            .road_temperature = std::vector<double>(session.time.size(), session.road),
                            .throttle = {}};
        for (std::size_t i = 0; i < session.time.size(); ++i) {
            programme.lateral_force.push_back((std::abs(wheel.lateral[i]) * std::tan(std::abs(wheel.slip_angle[i])) +
                                               std::abs(wheel.longitudinal[i] * wheel.slip_ratio[i])) /
                                              std::tan(stand_in));
            programme.throttle.push_back(w < rear_left ? session.brake[i] / brake_pressure : 0.0);
        }
        constexpr std::array<double, n_wheels> warm{1.5, 1.0, 2.5, 2.0};  // K, from the way to the circuit
        const Bench bench{.lambda_h = hidden.lambda_h,
                          .lambda_sel = hidden.lambda_sel,
                          .surface_start = session.air + warm[w],
                          .bulk_start = session.air + 2.0 * warm[w],
                          .causes = {{.id = "unknown_bulk", .parameters = {{"watts", hidden.brake_watts}}}}};
        wheel.disc = disc_of(session, wheel, session.time[1] - session.time[0]);
        BenchTrace trace = drive_bench(bench, programme, 1e-7);
        if (hidden.brake_conductance > 0.0) {
            // What the disc gives depends on what it warms, by a few per cent: four rounds leave 1e-6 of it.
            constexpr double unit = 1000.0;  // W
            Bench braked = bench;
            braked.causes = {{.id = "unknown_bulk", .parameters = {{"watts", unit}}}};
            for (int round = 0; round < 4; ++round) {
                for (std::size_t i = 0; i < session.time.size(); ++i) {
                    const double watts = hidden.brake_conductance * (wheel.disc[i] - trace.bulk[i]) +
                                         (w < rear_left ? hidden.brake_watts * session.brake[i] / brake_pressure : 0.0);
                    programme.throttle[i] = watts / unit;
                }
                trace = drive_bench(braked, programme, 1e-7);
            }
        }
        wheel.surface = std::move(trace.surface);
        wheel.bulk = std::move(trace.bulk);
    }
}

}  // namespace

Session drive_session(const Circuit& circuit, const Car& car, int laps, double interval, const HiddenInCar& hidden) {
    const std::vector<double> v_of = fastest(circuit, car);
    const auto lap_of = [&](double s) { return static_cast<int>(std::floor(s / circuit.length())); };
    const auto limit = [&](double s) {
        const auto i = static_cast<std::size_t>(s / circuit.step) % v_of.size();
        return pace(lap_of(s)) * v_of[i];
    };
    Session session;
    constexpr double before_line = 60.0;  // m: the pits
    double s = circuit.length() - before_line;
    double v = 0.5;
    constexpr int fine = 20;
    const double dt = interval / fine;
    double t = 0.0;
    for (long i = 0; lap_of(s) < laps + 1; ++i) {  // the way out of the pits counts as lap 0
        const double now = interval * static_cast<double>(i);
        session.time.push_back(now);
        session.place.push_back(s - circuit.length());
        session.speed.push_back(v);
        session.yaw_rate.push_back(v * circuit.curvature_at(s));
        session.leftwards.push_back(v * v * circuit.curvature_at(s));
        for (int k = 0; k < fine; ++k) {
            const double wish = limit(s);
            v = std::clamp(wish, v - braking * dt, v + (t < 30.0 ? pit_exit : traction) * dt);
            const int lap = lap_of(s);
            s += v * dt;
            t += dt;
            if (lap_of(s) != lap) {
                session.beacons.push_back(t);
            }
        }
    }
    session.forwards = rate_of(session.speed, interval);
    carry(car, session, interval);
    heat(hidden, session);
    return session;
}

}  // namespace hidden_effects
