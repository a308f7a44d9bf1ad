// SPDX-License-Identifier: BSD-3-Clause
// Draws laps with straights, brakes and corners, or steps of speed, load and slip.

#include "dirty/dirty_drive_truth.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/random_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

constexpr double wheel_mass = 380.0;  // kg, a quarter of a car

/// Appends moments to a drive; ramps are straight.
class Driver {
public:
    Driver(const DirtyTrack& track, std::uint64_t seed) : track_(track), random_(seed) {
        air_ = track.air + random_.uniform(-3.0, 3.0);
        road_ = air_ + track.road_over_air + random_.uniform(-2.0, 2.0);
        road_rate_ = random_.uniform(-4.0, 6.0) / 3600.0;
        load_ = 300.0;
    }

    /// To another state within `seconds`, everything straight.
    void move(double seconds, double speed, double load, double slip, bool brakes) {
        const auto n = static_cast<int>(std::max(1.0, std::round(seconds / dirty_step)));
        const double V = speed_;
        const double Fz = load_;
        const double alpha = slip_;
        for (int i = 1; i <= n; ++i) {
            const double share = static_cast<double>(i) / n;
            speed_ = V + share * (speed - V);
            load_ = Fz + share * (load - Fz);
            slip_ = alpha + share * (slip - alpha);
            const double deceleration = std::max(0.0, (V - speed) / (n * dirty_step));
            append(brakes ? wheel_mass * deceleration * speed_ : 0.0, speed > V ? 1.0 : brakes ? 0.0 : 0.3);
        }
    }

    void append(double brake, double throttle) {
        const double t = static_cast<double>(drive_.size()) * dirty_step;
        const double most = track_.grip * load_;
        drive_.speed.push_back(speed_);
        drive_.vertical_load.push_back(load_);
        drive_.slip_angle.push_back(slip_);
        drive_.lateral_force.push_back(-most * std::tanh(track_.stiffness * slip_ / most));
        drive_.brake_power.push_back(brake);
        drive_.air_temperature.push_back(air_);
        drive_.road_temperature.push_back(road_ + road_rate_ * t);
        drive_.throttle.push_back(throttle);
        drive_.gear.push_back(std::clamp(std::floor(speed_ / 10.0) + 1.0, 1.0, 6.0));
        distance_ += speed_ * dirty_step;
        drive_.lap_distance.push_back(distance_);
    }

    void lap(double end) {
        distance_ = 0.0;
        for (const DirtyTrack::Corner& corner : track_.corners) {
            if (seconds() > end) {
                return;
            }
            const auto about = [&](double x) { return x * random_.uniform(0.94, 1.06); };
            const double top = std::max(about(corner.top_speed), speed_ + 1.0);
            const double slow = std::min(about(corner.speed), top - 1.0);
            move((top - speed_) / random_.uniform(2.5, 4.5), top, track_.straight_load, 0.0, false);
            move((top - slow) / random_.uniform(5.0, 9.0), slow, 1.1 * track_.straight_load, 0.0, true);
            const double slip = about(corner.slip);
            const double load = about(corner.load);
            move(random_.uniform(0.5, 1.0), slow, load, slip, false);
            move(about(corner.duration), slow, load, slip, false);
            move(random_.uniform(0.4, 0.9), slow, track_.straight_load, 0.0, false);
        }
    }

    void hold() {
        const double kind = random_.uniform();
        double speed = random_.uniform(30.0 / 3.6, track_.top_speed);
        double load = random_.uniform(1500.0, 7000.0);
        double slip = 0.0;
        double duration = random_.uniform(60.0, 240.0);
        if (kind < 0.08) {
            speed = 50.0 / 3.6;
            load = 250.0;
        } else if (kind > 0.6) {
            slip = (random_.uniform() < 0.5 ? -1.0 : 1.0) * random_.uniform(0.5, 2.5) * degree;
            duration = random_.uniform(20.0, 90.0);
        }
        move(random_.uniform(2.0, 6.0), speed, load, slip, speed < speed_);
        move(duration, speed, load, slip, false);
    }

    [[nodiscard]] double seconds() const { return static_cast<double>(drive_.size()) * dirty_step; }
    [[nodiscard]] Random& random() { return random_; }
    [[nodiscard]] DirtyDrive& drive() { return drive_; }

private:
    const DirtyTrack& track_;
    Random random_;
    DirtyDrive drive_;
    double speed_ = 0.0, load_ = 0.0, slip_ = 0.0;
    double air_ = 0.0, road_ = 0.0, road_rate_ = 0.0, distance_ = 0.0;
};

}  // namespace

DirtyTrack draw_dirty_track(std::uint64_t seed, bool laps) {
    Random random(seed);
    DirtyTrack track;
    track.straight_load = random.uniform(3200.0, 4600.0);
    track.top_speed = random.uniform(140.0, 200.0) / 3.6;
    track.grip = random.uniform(0.95, 1.2);
    track.stiffness = random.uniform(50e3, 75e3);
    track.air = random.uniform(14.0, 30.0) + celsius;
    track.road_over_air = random.uniform(1.0, 14.0);
    const int n = laps ? static_cast<int>(random.uniform(5.0, 10.0)) : 0;
    for (int i = 0; i < n; ++i) {
        DirtyTrack::Corner corner;
        corner.speed = random.uniform(55.0, 120.0) / 3.6;
        corner.top_speed = corner.speed + random.uniform(30.0, 90.0) / 3.6;
        corner.duration = random.uniform(2.0, 7.0);
        const bool outside = random.uniform() < 0.6;
        corner.slip = (outside ? 1.0 : -1.0) * random.uniform(0.8, 2.8) * degree;
        corner.load = track.straight_load * (outside ? random.uniform(1.2, 1.6) : random.uniform(0.5, 0.8));
        track.corners.push_back(corner);
    }
    return track;
}

DirtyDrive draw_dirty_drive(const DirtyTrack& track, double minutes, std::uint64_t seed) {
    Driver driver(track, seed);
    driver.append(0.0, 0.0);
    driver.move(driver.random().uniform(10.0, 40.0), 0.0, 300.0, 0.0, false);
    const double end = 60.0 * minutes;
    while (driver.seconds() < end) {
        if (track.corners.empty()) {
            driver.hold();
        } else {
            driver.lap(end);
        }
    }
    // Cut at the end, so that a set has the length that was drawn for it.
    DirtyDrive& drive = driver.drive();
    const auto n = static_cast<std::size_t>(std::round(end / dirty_step)) + 1;
    for (std::vector<double>* signal :
         {&drive.speed, &drive.vertical_load, &drive.slip_angle, &drive.lateral_force, &drive.brake_power,
          &drive.air_temperature, &drive.road_temperature, &drive.throttle, &drive.gear, &drive.lap_distance}) {
        signal->resize(std::min(n, signal->size()));
    }
    return std::move(drive);
}

double dirty_value(const std::vector<double>& signal, double time) {
    const double place = std::clamp(time / dirty_step, 0.0, static_cast<double>(signal.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), signal.size() - 2);
    const double share = place - static_cast<double>(i);
    return signal[i] + share * (signal[i + 1] - signal[i]);
}

}  // namespace hidden_effects
