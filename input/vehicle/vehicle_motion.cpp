// SPDX-License-Identifier: BSD-3-Clause
// Smooths the signals of a log, finds out their signs and fills in what the log does not give.

#include "input/vehicle/vehicle_motion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"
#include "input/vehicle/at_times.hpp"
#include "input/vehicle/clock_shift.hpp"
#include "input/vehicle/turn_signs.hpp"
#include "physics/vehicle/local_mean.hpp"
#include "solver/field_digest.hpp"

namespace tiretherm::input {

namespace {

constexpr double slowest = 1.0;             ///< m/s, below which no yaw rate is taken from a_y / V
constexpr double sure = 0.5;                ///< correlation from which two signals are known to be the same
constexpr double one_clock = 0.85;          ///< correlation from which neither of two can be late
constexpr double slope_of_speed = 1.0;      ///< s, over which the acceleration is taken from the speed
constexpr double slope_of_course = 1.0;     ///< s, over which the yaw rate is taken from the course over ground
constexpr double least_of_wheelbase = 0.1;  ///< is L + K V^2 of a car whose turn the steering tells
constexpr double released = 0.02;           ///< of the highest brake pressure

using Values = std::vector<double>;

void turn_round(Values& values, TurnSign sign) {
    if (sign == TurnSign::right) {
        std::ranges::transform(values, values.begin(), std::negate<>());
    }
}

/// What is read of a log on the way to a motion.
struct Reader {
    const VehicleSettings& settings;
    const VehicleLog& log;
    InputErrors& errors;
    bool again = false;  ///< the log has been found sound, with other numbers of the car
    MotionHistory out{};
    Values speed{};
    Values turned{};  ///< rad/s, the slope of the course over ground; empty: not known
    Values yaw{};
    Values lateral{};
    Values longitudinal{};
    Road road{};

    void say(std::string sentence) { out.sources.push_back(std::move(sentence)); }

    /// Smoothed, in the axes of the car. @param name for what the smoothing takes away; empty: nothing is said
    Values smooth(const solver::SignalHistory& history, TurnSign sign, std::string_view name, double unit,
                  std::string_view unit_name) {
        const Values raw = at_times(history, out.time);
        Values value = physics::local_mean(out.time, raw, settings.smoothing);
        double square = 0.0;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            square += (raw[i] - value[i]) * (raw[i] - value[i]);
        }
        turn_round(value, sign);
        if (!name.empty() && settings.smoothing > 0.0) {
            say(fmt::format("{} is smoothed over {:.3g} s, which takes away {:.3g} {} (rms)", name, settings.smoothing,
                            std::sqrt(square / static_cast<double>(raw.size())) / unit, unit_name));
        }
        return value;
    }

    [[nodiscard]] Values speed_times(const Values& rate) const {
        Values product(speed.size());
        std::ranges::transform(speed, rate, product.begin(), std::multiplies<>());
        return product;
    }

    void read_course();
    Witness witness();
    TurnSign settle(std::string_view name, TurnSign stated, const Values& acceleration);
    bool read_yaw_rate();
    bool read_steering();
    void add_turn_error(const std::string& what, const std::string& remedy);
    bool clocks_differ(const Told& one, Told other, bool may_be_turned);
    bool read_lateral();
    bool agree_in_size(std::string_view name, const Values& acceleration, const Values& expected,
                       std::string_view what);
    [[nodiscard]] Values of_turn() const { return road.for_tires(speed_times(yaw)); }  ///< V r less what a bank gives
    bool read_longitudinal();
};

/// The rate at which the car turns over ground. While it stands a receiver makes directions up.
void Reader::read_course() {
    const CourseOverGround& course = log.course;
    if (course.course.time.empty()) {
        return;
    }
    const double window = course.window(std::max(slope_of_course, settings.smoothing));
    turned = at_times(
        {.time = course.course.time, .value = physics::local_slope(course.course.time, course.course.value, window)},
        out.time);
    for (std::size_t i = 0; i < turned.size(); ++i) {
        turned[i] = std::abs(speed[i]) < slowest ? 0.0 : turned[i];
    }
}

/// The course over ground, or else the steering, whose sign is known where the case says it.
Witness Reader::witness() {
    if (!turned.empty()) {
        return {.told = {fmt::format("the course by {}", log.course.source), speed_times(turned)},
                .is_course = true,
                .is_sure = true};
    }
    if (log.steering_wheel_angle.time.empty()) {
        return {};
    }
    const Values steered = smooth(log.steering_wheel_angle, settings.steering, "", 1.0, "");
    return {.told = {"steering_wheel_angle", speed_times(speed_times(steered))},
            .is_sure = settings.steering != TurnSign::automatic};
}

/// @param stated automatic: not  @param acceleration that the signal tells
TurnSign Reader::settle(std::string_view name, TurnSign stated, const Values& acceleration) {
    const Witness beside = witness();
    const double r = beside.told.acceleration.empty() ? 0.0 : correlation(acceleration, beside.told.acceleration);
    const bool is_late = beside.is_course && std::abs(r) < one_clock &&
                         clocks_differ({std::string(name), acceleration}, beside.told, true);
    if (is_late || std::abs(r) <= sure) {
        return stated;  // of two clocks the sign of their correlation says nothing
    }
    const Settled settled = settle_sign(name, stated, r, beside);
    out.course_agrees = beside.is_course ? settled.agrees * std::abs(r) : 0.0;
    if (!settled.sentence.empty()) {
        say(settled.sentence);
    }
    return settled.sign;
}

bool Reader::read_yaw_rate() {
    if (!log.yaw_rate.time.empty()) {
        yaw = smooth(log.yaw_rate, TurnSign::left, "yaw_rate", 1.0, "rad/s");
        const TurnSign settled = settle("yaw_rate", settings.yaw_rate, speed_times(yaw));
        if (settled == settings.yaw_rate) {
            say(fmt::format("yaw_rate is taken as positive in {} turns (yaw_rate_sign)", turns(settled)));
        }
        turn_round(yaw, settled);
        return true;
    }
    if (!log.lateral_acceleration.time.empty()) {
        return true;  // from it
    }
    if (!turned.empty()) {
        yaw = turned;
        say(fmt::format(
            "yaw rate is the slope of the course over ground by {}, over {:.3g} s, and 0 where the car is "
            "slower than {:.3g} km/h: the change of the sideslip angle is neglected",
            log.course.source, log.course.window(std::max(slope_of_course, settings.smoothing)), 3.6 * slowest));
        return true;
    }
    return log.steering_wheel_angle.time.empty() || read_steering();
}

/// The turns are not known. Where a column that says nothing is used in place of one that moves, that one is the remedy.
void Reader::add_turn_error(const std::string& what, const std::string& remedy) {
    const auto dead = std::ranges::find_if(
        log.remarks, [](const ErrorText& one) { return !one.remedy.empty() && !is_along_the_car(one.about); });
    const bool has_other = dead != log.remarks.end();
    errors.add(settings.place, has_other ? fmt::format("{}; {}", what, dead->what) : what,
               has_other ? dead->remedy : remedy);
}

/// The turns of a linear car from its steering.
bool Reader::read_steering() {
    const double ratio = settings.numbers[VehicleNumber::steering_ratio];
    if (std::isnan(ratio)) {
        add_turn_error("the turns follow from steering_wheel_angle, but the steering ratio is not given",
                       "add steering_ratio = 15, the steering wheel's angle over that of the road wheels");
        return false;
    }
    const physics::Vehicle vehicle = vehicle_of(settings.numbers, settings.kind);
    const double gradient = vehicle.understeer_gradient();
    const double wheelbase = vehicle.wheelbase();
    const double fastest = std::ranges::max(speed);
    if (!again && wheelbase + gradient * fastest * fastest <= least_of_wheelbase * wheelbase) {
        errors.add(settings.place,
                   fmt::format("the car oversteers and is near its critical speed of {:.4g} km/h, where the steering "
                               "does not tell the turn",
                               3.6 * std::sqrt(wheelbase / -gradient)),
                   "log lateral_acceleration or yaw_rate, or correct the cornering stiffnesses");
        return false;
    }
    const Values steer = smooth(log.steering_wheel_angle, settings.steering, "steering_wheel_angle", 1.0, "rad");
    yaw.resize(speed.size());
    for (std::size_t i = 0; i < speed.size(); ++i) {
        const double length = wheelbase + gradient * speed[i] * speed[i];
        yaw[i] = speed[i] * steer[i] / ratio / std::max(length, least_of_wheelbase * wheelbase);
    }
    say(
        fmt::format("yaw rate and lateral acceleration follow from steering_wheel_angle, positive to the {}, by the "
                    "steady turn of a linear car with an understeer gradient of {:.3g} deg/g: near the limit of grip "
                    "they are too high",
                    turns(settings.steering), gradient * physics::standard_gravity * 180.0 / 3.14159265358979));
    return true;
}

/// @returns false after an error: an acceleration is not as large as another signal says
bool Reader::agree_in_size(std::string_view name, const Values& acceleration, const Values& expected,
                           std::string_view what) {
    // On a bank that nobody wrote down an accelerometer reads less than the turn; a wrong unit is a tenth, or ten times.
    const bool may_be_less = !log.vertical_acceleration.time.empty() && name == "lateral_acceleration";
    const std::optional<ErrorText> wrong = wrong_size(name, acceleration, expected, what, may_be_less ? 0.15 : 0.5);
    if (wrong) {
        errors.add(settings.place, *wrong);
    }
    return !wrong;
}

/// Whether one of two signals that tell the same is late beside the other; says so.
bool Reader::clocks_differ(const Told& one, Told other, bool may_be_turned) {
    if (again) {
        return false;
    }
    const bool is_mended = other.name == "speed" && log.speed_is_brought_back;
    const std::vector<std::string> remarks = clock_remarks(out.time, one, std::move(other), may_be_turned);
    if (!is_mended) {
        out.sources.insert(out.sources.end(), remarks.begin(), remarks.end());
    }
    return !remarks.empty();
}

bool Reader::read_lateral() {
    road = road_of(settings, log, {out.time, speed, yaw.empty() ? turned : yaw}, out.sources);
    const solver::SignalHistory& logged = log.lateral_acceleration;
    if (logged.time.empty()) {
        if (yaw.empty()) {
            add_turn_error(
                "no cornering signal: neither lateral_acceleration nor yaw_rate nor "
                "steering_wheel_angle nor a heading or positions is a column",
                "rename one: columns = { AccY = \"lateral_acceleration\" }");
            return false;
        }
        lateral = of_turn();
        if (!log.yaw_rate.time.empty()) {
            say("lateral acceleration is speed times yaw_rate: the change of the sideslip angle is neglected");
        }
        return true;
    }
    TurnSign sign = settings.lateral_acceleration;
    lateral = smooth(logged, TurnSign::left, "lateral_acceleration", physics::standard_gravity, "g");
    if (!yaw.empty()) {
        const Values turn = of_turn();
        const double r = correlation(lateral, turn);
        const bool is_late = clocks_differ({"lateral_acceleration", lateral}, {"speed times yaw_rate", turn}, true);
        if (!is_late && !agree_in_size("lateral_acceleration", lateral, turn, "speed times yaw_rate")) {
            return false;
        }
        const TurnSign seen = r < 0.0 ? TurnSign::right : TurnSign::left;
        const bool is_sure = !is_late && std::abs(r) > sure;
        if (sign != TurnSign::automatic && is_sure && seen != sign) {
            errors.add(settings.place,
                       fmt::format("lateral_acceleration_sign says positive in {} turns, but beside speed times "
                                   "yaw_rate it is positive in {} ones (r = {:.2f})",
                                   turns(sign), turns(seen), r),
                       "correct lateral_acceleration_sign or yaw_rate_sign: the wrong tire would be loaded");
            return false;
        }
        if (sign == TurnSign::automatic && is_sure) {
            sign = seen;
            say(
                fmt::format("lateral_acceleration is taken as positive in {} turns: its correlation with speed times "
                            "yaw_rate is {:.2f}",
                            turns(sign), r));
        }
    }
    if (yaw.empty()) {
        sign = settle("lateral_acceleration", sign, lateral);
    }
    if (sign == TurnSign::automatic) {
        sign = TurnSign::left;
        say("lateral_acceleration is taken as positive in left turns (ISO 8855); many loggers have it the other way: "
            "say so with lateral_acceleration_sign");
    }
    turn_round(lateral, sign);
    if (yaw.empty()) {
        yaw = road.of_tires(lateral);
        for (std::size_t i = 0; i < yaw.size(); ++i) {
            yaw[i] = std::abs(speed[i]) < slowest ? 0.0 : yaw[i] / speed[i];
        }
        say("yaw rate is lateral_acceleration over speed");
    }
    return true;
}

bool Reader::read_longitudinal() {
    const double window = std::max(slope_of_speed, settings.smoothing);
    const Values slope = road.uphill(physics::local_slope(out.time, speed, window));
    if (log.longitudinal_acceleration.time.empty()) {
        longitudinal = slope;
        say(fmt::format("longitudinal acceleration is the slope of speed over {:.3g} s",
                        std::max(slope_of_speed, settings.smoothing)));
        return true;
    }
    longitudinal = smooth(log.longitudinal_acceleration, TurnSign::left, "longitudinal_acceleration",
                          physics::standard_gravity, "g");
    const Values smoothed = physics::local_mean(out.time, longitudinal, 2.0 * slope_of_speed);
    const double r = correlation(smoothed, slope);
    if (r >= -sure && clocks_differ({"longitudinal_acceleration", smoothed}, {"speed", slope}, false)) {
        return true;
    }
    if (r < -sure) {
        errors.add(settings.place,
                   {.what = fmt::format("longitudinal_acceleration is positive where the speed falls (r = {:.2f})", r),
                    .remedy = "turn the sign of the column: positive is speeding up",
                    .about = "longitudinal_acceleration"});
        return false;
    }
    return agree_in_size("longitudinal_acceleration", smoothed, slope, "the slope of speed");
}

std::optional<MotionHistory> read_motion(const VehicleSettings& settings, const VehicleLog& log, InputErrors& errors,
                                         bool again) {
    if (log.speed.time.empty()) {
        errors.add(settings.place, "the speed of the car is not given",
                   "give the run's file a column speed, or rename one: columns = { V = \"speed\" }");
        return std::nullopt;
    }
    Reader reader{.settings = settings, .log = log, .errors = errors, .again = again};
    reader.out.time = clock_of(log);
    if (reader.out.time.size() < 2) {
        // A constant speed and nothing else that is logged.
        static_cast<void>(log.lateral_acceleration.time.empty() && reader.read_lateral());
        if (!log.lateral_acceleration.time.empty()) {
            errors.add(settings.place, "the signals of the car have no time in common", "choose from and to");
        }
        return std::nullopt;
    }
    reader.speed = reader.smooth(log.speed, TurnSign::left, "", 1.0, "");
    for (const ErrorText& dead : log.remarks) {
        reader.say(dead.remedy.empty() ? dead.what : fmt::format("{}; {}", dead.what, dead.remedy));
    }
    reader.read_course();
    if (!reader.read_yaw_rate() || !reader.read_lateral() || !reader.read_longitudinal()) {
        return std::nullopt;
    }
    const std::optional<Values> vertical =
        vertical_motion(settings, log, {reader.out.time, reader.lateral, reader.road}, reader.out.sources, errors);
    if (!vertical) {
        return std::nullopt;
    }
    const bool turns_are_known = !log.yaw_rate.time.empty();  // a slope of the course is too rough for another one
    const auto yaw_acceleration = physics::local_slope(reader.out.time, reader.yaw, std::max(settings.smoothing, 0.1));
    if (!turns_are_known) {
        reader.say("without yaw_rate the moment that turns the car about its vertical axis is neglected");
    }
    const Values brake = log.brake_pressure.time.empty() ? Values{} : at_times(log.brake_pressure, reader.out.time);
    const double pressed = brake.empty() ? 0.0 : released * std::ranges::max(brake);
    if (!brake.empty()) {
        reader.say("where brake_pressure is below 2 % of its highest value, the driven wheels slow the car down");
    }
    for (std::size_t i = 0; i < reader.out.time.size(); ++i) {
        reader.out.motion.push_back(
            {.speed = reader.speed[i],
             .longitudinal_acceleration = reader.longitudinal[i],
             .lateral_acceleration = reader.lateral[i],
             .vertical_acceleration = vertical->empty() ? physics::standard_gravity : (*vertical)[i],
             .yaw_rate = reader.yaw[i],
             .yaw_acceleration = turns_are_known ? yaw_acceleration[i] : 0.0,
             .brakes_released = !brake.empty() && brake[i] <= pressed});
    }
    return std::move(reader.out);
}

}  // namespace

solver::Digest::Value motion_origin(const VehicleSettings& settings, const VehicleLog& log) {
    solver::Digest digest;
    solver::add_fields(digest, log);
    const physics::Vehicle vehicle = vehicle_of(settings.numbers, settings.kind);
    solver::add_fields(digest, settings.has_gravity);
    for (const double number :
         {settings.smoothing, settings.bank, settings.slope, settings.numbers[VehicleNumber::steering_ratio],
          vehicle.understeer_gradient(), vehicle.wheelbase()}) {
        digest.add(number);
    }
    for (const TurnSign sign :
         {settings.lateral_acceleration, settings.yaw_rate, settings.steering, settings.bank_sign}) {
        digest.add(sign);
    }
    return digest.value();
}

std::optional<MotionHistory> motion_of(const VehicleSettings& settings, const VehicleLog& log, InputErrors& errors) {
    return read_motion(settings, log, errors, false);
}

MotionHistory motion_again(const VehicleSettings& settings, const VehicleLog& log) {
    InputErrors none;  // of a log that is sound
    return read_motion(settings, log, none, true).value();
}

}  // namespace tiretherm::input
