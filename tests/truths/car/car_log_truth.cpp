// SPDX-License-Identifier: BSD-3-Clause
// Noise of the car's sensors, and the lines of an AiM export.

#include "car/car_log_truth.hpp"

#include <cmath>
#include <cstdio>
#include <functional>

#include "numerics/random_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

std::string number(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

namespace {

std::string quoted(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        line += (line.empty() ? "\"" : ",\"") + word + "\"";
    }
    return line + "\n";
}

std::string minutes(double seconds) {
    const int whole = static_cast<int>(seconds / 60.0);
    char text[32];
    std::snprintf(text, sizeof text, "%d:%06.3f", whole, seconds - 60.0 * whole);
    return text;
}

}  // namespace

std::vector<LoggedChannel> logged_channels(const Session& session, std::uint64_t seed) {
    const Circuit circuit = made_up_circuit();
    Random random(seed);
    const std::size_t n = session.time.size();
    std::vector<LoggedChannel> all;
    const auto add = [&](const std::string& name, const std::string& unit, int digits, double noise,
                         const std::function<double(std::size_t)>& value) {
        LoggedChannel channel{.name = name, .unit = unit, .digits = digits, .value = {}};
        for (std::size_t i = 0; i < n; ++i) {
            channel.value.push_back(value(i) + noise * random.normal());
        }
        all.push_back(std::move(channel));
    };
    add("GPS Speed", "km/h", 2, 0.15, [&](std::size_t i) { return 3.6 * session.speed[i]; });
    add("GPS Latitude", "deg", 7, 0.0, [&](std::size_t i) { return on_earth(circuit.place_at(session.place[i]))[0]; });
    add("GPS Longitude", "deg", 7, 0.0, [&](std::size_t i) { return on_earth(circuit.place_at(session.place[i]))[1]; });
    add("LonAcc", "g", 3, 0.02, [&](std::size_t i) { return session.forwards[i] / 9.80665; });
    add("LatAcc", "g", 3, 0.02, [&](std::size_t i) { return -session.leftwards[i] / 9.80665; });
    add("YawRate", "deg/s", 2, 0.3, [&](std::size_t i) { return session.yaw_rate[i] / degree; });
    add("Steering", "deg", 1, 0.3, [&](std::size_t i) { return session.steering[i] / degree; });
    add("Throttle", "%", 1, 0.2, [&](std::size_t i) { return 100.0 * session.throttle[i]; });
    add("Brake Pressure", "bar", 2, 0.05, [&](std::size_t i) { return session.brake[i]; });
    add("Ambient Temp", "C", 1, 0.05, [&](std::size_t) { return session.air - celsius; });
    for (std::size_t w = 0; w < n_wheels; ++w) {
        const Noise noise{.standard_deviation = 0.7, .correlated_share = 0.5, .correlation = 0.8};
        const std::vector<double> of_sensor = draw_noise(noise, session.time, random);
        add(std::string("Tire Temp ") + wheel_names[w], "C", 1, 0.0,
            [&](std::size_t i) { return session.wheels[w].surface[i] - celsius + of_sensor[i]; });
    }
    return all;
}

std::vector<LoggedChannel> logged_by_measuring_wheels(const Session& session, std::uint64_t seed) {
    std::vector<LoggedChannel> all = logged_channels(session, seed);
    Random random(seed + 1);
    for (std::size_t w = 0; w < n_wheels; ++w) {
        const WheelCourse& wheel = session.wheels[w];
        const double towards_middle = w % 2 == 0 ? -1.0 : 1.0;  // the road pushes a left wheel to the right
        const auto add = [&](const std::string& name, const std::string& unit, int digits, double noise, double scale,
                             const std::vector<double>& values, double zero = 0.0) {
            LoggedChannel channel{.name = name + " " + wheel_names[w], .unit = unit, .digits = digits, .value = {}};
            for (const double value : values) {
                channel.value.push_back(scale * value - zero + noise * random.normal());
            }
            all.push_back(std::move(channel));
        };
        add("Wheel Load", "N", 0, 15.0, 1.0, wheel.load);
        add("Slip Angle", "deg", 3, 0.02, towards_middle / degree, wheel.slip_angle);
        add("Slip Ratio", "%", 3, 0.03, 100.0, wheel.slip_ratio);
        add("Lateral Force", "N", 0, 15.0, towards_middle, wheel.lateral);
        add("Longitudinal Force", "N", 0, 15.0, 1.0, wheel.longitudinal);
        add("Brake Temp", "C", 0, 3.0, 1.0, wheel.disc, celsius);
    }
    return all;
}

HiddenInCar hidden_in_wheel_log() { return {.lambda_h = 0.95, .brake_watts = 0.0, .brake_conductance = 3.0}; }

std::string shipped_wheel_log() {
    constexpr double rate = 2.0;
    const Session session = drive_session(made_up_circuit(), Car{}, 12, 1.0 / rate, hidden_in_wheel_log());
    return aim_export(session, logged_by_measuring_wheels(session, 611), rate);
}

std::string aim_export(const Session& session, const std::vector<LoggedChannel>& channels, double rate) {
    std::vector<std::string> beacons{"Beacon Markers"};
    std::vector<std::string> segments{"Segment Times"};
    double before = 0.0;
    for (const double beacon : session.beacons) {
        beacons.push_back(number(beacon, 3));
        segments.push_back(minutes(beacon - before));
        before = beacon;
    }
    std::vector<std::string> names{"Time"};
    std::vector<std::string> units{"s"};
    for (const LoggedChannel& channel : channels) {
        names.push_back(channel.name);
        units.push_back(channel.unit);
    }
    std::string text = quoted({"Format", "AiM CSV File"}) + quoted({"Session", "Made-up circuit"}) +
                       quoted({"Vehicle", "Made-up car"}) + quoted({"Racer", "nobody"}) +
                       quoted({"Date", "Saturday, May 16, 2026"}) + quoted({"Time", "10:32 AM"}) +
                       quoted({"Sample Rate", number(rate, 0)}) + quoted({"Duration", number(session.time.back(), 3)}) +
                       quoted({"Segment", "Session"}) + quoted(beacons) + quoted(segments) + "\n" + quoted(names) +
                       quoted(units) + "\n";
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        std::vector<std::string> row{number(session.time[i], 3)};
        for (const LoggedChannel& channel : channels) {
            row.push_back(number(channel.value[i], channel.digits));
        }
        text += quoted(row);
    }
    return text;
}

std::string shipped_car_log() {
    constexpr double rate = 10.0;
    const Session session = drive_session(made_up_circuit(), Car{}, 8, 1.0 / rate);
    return aim_export(session, logged_channels(session, 601), rate);
}

}  // namespace hidden_effects
