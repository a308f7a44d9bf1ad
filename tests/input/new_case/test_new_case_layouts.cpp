// SPDX-License-Identifier: BSD-3-Clause
// One session of a car as five loggers write it, each in its layout, names and units: one call makes the same four tires of each.
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "input/loggers/ld_writer.hpp"
#include "input/loggers/logger_files.hpp"
#include "input/new_case/made.hpp"
#include "input/runs/read_experiment.hpp"

namespace tiretherm::input {
namespace {

using made_up::digits;

/// A channel of the session as one logger writes it.
struct SessionChannel {
    std::string name;
    std::string unit;
    std::function<double(double)> value;
};

constexpr int n_session_samples = 301;  // 30 s at 10 Hz

double bend(double t) { return 7.0 * std::sin(0.8 * t); }               // m/s2, positive in left turns
double push(double t) { return 2.0 * std::cos(0.3 * t); }               // m/s2
double pace(double t) { return 30.0 + 2.0 / 0.3 * std::sin(0.3 * t); }  // m/s
double tread_of(std::size_t corner, double t) {
    return 30.0 + 2.0 * static_cast<double>(corner) + 0.4 * t + 0.1 * std::sin(3.0 * t);  // degC
}

/// What a logger calls the quantities: speed, accelerations, yaw rate, air, treads FL FR RL RR; with their units.
struct Words {
    std::array<std::string, 9> names;
    std::string speed_unit;
    std::string acceleration_unit;
    std::string temperature_unit;
};

std::vector<SessionChannel> channels_of(const Words& words) {
    const double per_speed = words.speed_unit == "m/s" ? 1.0 : 3.6;
    std::vector<SessionChannel> all{
        {words.names[0], words.speed_unit, [per_speed](double t) { return per_speed * pace(t); }},
        {words.names[1], words.acceleration_unit, [](double t) { return bend(t) / 9.80665; }},
        {words.names[2], words.acceleration_unit, [](double t) { return push(t) / 9.80665; }},
        {words.names[3], "deg/s", [](double t) { return bend(t) / pace(t) * 180.0 / 3.14159265358979; }},
        {words.names[4], words.temperature_unit, [](double /*t*/) { return 22.0; }}};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        all.push_back(
            {words.names[5 + corner], words.temperature_unit, [corner](double t) { return tread_of(corner, t); }});
    }
    return all;
}

/// The values of a line, behind its time. @param decimals of each
std::string values_at(const std::vector<SessionChannel>& channels, double t, std::string_view before,
                      std::string_view after) {
    std::string line;
    for (const SessionChannel& channel : channels) {
        line += fmt::format("{}{}{}", before, digits(channel.value(t), 4), after);
    }
    return line;
}

std::string joined(const std::vector<SessionChannel>& channels, std::string SessionChannel::*what,
                   std::string_view before, std::string_view after) {
    std::string line;
    for (const SessionChannel& channel : channels) {
        line += fmt::format("{}{}{}", before, channel.*what, after);
    }
    return line;
}

template <typename Line>
std::string lines(Line line) {
    std::string text;
    for (int i = 0; i < n_session_samples; ++i) {
        text += line(0.1 * i) + "\r\n";
    }
    return text;
}

/// AiM and MoTeC: keys and values, an empty line, names, units, an empty line, values in quotes.
std::string key_value(const std::string& head, const std::vector<SessionChannel>& channels) {
    return head + "\r\n\"Time\"" + joined(channels, &SessionChannel::name, ",\"", "\"") + "\r\n\"s\"" +
           joined(channels, &SessionChannel::unit, ",\"", "\"") + "\r\n\r\n" +
           lines([&](double t) { return "\"" + digits(t, 3) + "\"" + values_at(channels, t, ",\"", "\""); });
}

std::string racechrono(const std::vector<SessionChannel>& channels) {
    return "This file is created using RaceChrono Pro v9.1.3 ( http://racechrono.com/ ).\nFormat,3\nSession "
           "title,\"Test\"\nCreated,16/12/2025,11:49\n\ntimestamp" +
           joined(channels, &SessionChannel::name, ",", "") + "\nunix time" +
           joined(channels, &SessionChannel::unit, ",", "") + "\n" + std::string(channels.size(), ',') + "\n" +
           lines([&](double t) { return digits(1765885743.0 + t, 3) + values_at(channels, t, ",", ""); });
}

std::string vbox(const std::vector<SessionChannel>& channels) {
    std::string units;
    for (std::size_t i = 3; i < channels.size(); ++i) {  // velocity, latacc and longacc are standard
        units += channels[i].unit + "\r\n";
    }
    return "File created on 16/12/2025 at 10:00:00\r\n\r\n[header]\r\nsatellites\r\ntime\r\nvelocity kmh\r\n" +
           joined({channels.begin() + 1, channels.end()}, &SessionChannel::name, "", "\r\n") +
           "\r\n[channel units]\r\n" + units + "\r\n[column names]\r\nsats time" +
           joined(channels, &SessionChannel::name, " ", "") + "\r\n\r\n[data]\r\n" + lines([&](double t) {
               return "009 " + made_up::clock_digits(36000.0 + t) + values_at(channels, t, " ", "");
           });
}

std::string ld(const std::vector<SessionChannel>& channels) {
    std::vector<made_up::LdChannel> all;
    for (const SessionChannel& channel : channels) {
        made_up::LdChannel& one = all.emplace_back(
            made_up::LdChannel{.name = channel.name, .unit = channel.unit, .rate = 10, .kind = 7, .size = 4});
        for (int i = 0; i < n_session_samples; ++i) {
            one.samples += made_up::LdWriter::bytes_of_float(static_cast<float>(channel.value(0.1 * i)));
        }
        one.count = n_session_samples;
    }
    return made_up::LdWriter::file(all);
}

const Words aim{{"GPS Speed", "LatAcc", "InlineAcc", "YawRate", "Ambient Temp", "Tire Temp FL", "Tire Temp FR",
                 "Tire Temp RL", "Tire Temp RR"},
                "km/h",
                "g",
                "C"};
const Words motec{{"Ground Speed", "G Force Lat", "G Force Long", "Gyro Yaw Velocity", "Air Temp Ambient",
                   "Tyre Temp FL Surface", "Tyre Temp FR Surface", "Tyre Temp RL Surface", "Tyre Temp RR Surface"},
                  "km/h",
                  "G",
                  "C"};
const Words chrono{{"speed", "lateral_acc", "longitudinal_acc", "yaw_rate", "ambient_temp", "tire_temp_front_left",
                    "tire_temp_front_right", "tire_temp_rear_left", "tire_temp_rear_right"},
                   "m/s",
                   "G",
                   ".C"};
const Words racelogic{{"velocity", "latacc", "longacc", "YawRate", "Ambient_Temp", "TyreTemp_LF", "TyreTemp_RF",
                       "TyreTemp_LR", "TyreTemp_RR"},
                      "km/h",
                      "g",
                      "C"};

class CarLayout : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static std::string text() {
        const std::map<std::string, std::string> texts{
            {"aim.csv", key_value("\"Format\",\"AiM CSV File\"\r\n\"Session\",\"Test\"\r\n", channels_of(aim))},
            {"motec.csv", key_value("\"Format\",\"MoTeC CSV File\",,,\"Workbook\",\"\"\r\n", channels_of(motec))},
            {"racechrono.csv", racechrono(channels_of(chrono))},
            {"vbox.vbo", vbox(channels_of(racelogic))},
            {"motec.ld", ld(channels_of(motec))}};
        return texts.at(GetParam());
    }
};

}  // namespace

// 1350 kg with half of it in front, 0.48 m high, tracks of 1.55 m, 55 % of the roll stiffness in front, wheelbase 2.6 m: the values
// that `new` assumes. At 2 s the car turns left by 7 sin(1.6) = 6.997 m/s2 and gains 2 cos(0.6) = 1.651 m/s2:
// Fz_front = 1350 (9.80665/2 - 1.651 0.48/2.6) = 6208 N, transfer 0.55 1350 6.997 0.48/1.55 = 1609 N: FL 1495 N, FR 4713 N. Behind
// 7031 N and 1316 N: RL 2200 N, RR 4832 N. The log has 4 decimals, and the smoothing over 0.2 s takes 0.1 % of 0.13 Hz away: below 20 N.
TEST_P(CarLayout, GivesTheSameFourTires) {
    const Written written;
    written.add(GetParam(), text());
    const NewCase made = make(written, "225/50 R17", "", GetParam());
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_TRUE(made.missing.empty());
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    ASSERT_EQ(runs.size(), 4U);
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const MeasuredRun& run = runs[corner];
        const double start = run.problem.settings.start;
        const physics::Inputs in = run.problem.input_signals.at(start + 2.0, solver::JumpSide::after);
        const double load = corner == 0 ? 1495.0 : corner == 1 ? 4713.0 : corner == 2 ? 2200.0 : 4832.0;
        EXPECT_NEAR(in.vertical_load, load, 20.0) << run.corner;
        EXPECT_NEAR(in.air_temperature, 295.15, 1e-3);
        ASSERT_EQ(run.series.size(), 1U);
        ASSERT_EQ(run.series[0].value.size(), static_cast<std::size_t>(n_session_samples));
        for (std::size_t i = 0; i < run.time.size(); i += 50) {
            EXPECT_NEAR(run.time[i] - start, 0.1 * static_cast<double>(i), 1e-6);
            EXPECT_NEAR(run.series[0].value[i] - 273.15, tread_of(corner, 0.1 * static_cast<double>(i)), 1e-3);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Loggers, CarLayout,
                         testing::Values("aim.csv", "motec.csv", "racechrono.csv", "vbox.vbo", "motec.ld"),
                         [](const auto& layout) {
                             std::string name = layout.param;
                             name[name.find('.')] = '_';
                             return name;
                         });

}  // namespace tiretherm::input
