// SPDX-License-Identifier: BSD-3-Clause
// Writes each layout after public descriptions of it; knows nothing of the program's readers.

#include "car/car_layouts_truth.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace hidden_effects {

namespace {

constexpr double rate = 5.0;
constexpr double morning = 37920.0;  // s since midnight: 10:32

/// Channels under the names of a logger; those of no name it does not have.
std::vector<LoggedChannel> renamed(std::vector<LoggedChannel> channels, const std::array<const char*, 14>& names) {
    std::vector<LoggedChannel> kept;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (*names[i] != '\0') {
            channels[i].name = names[i];
            kept.push_back(channels[i]);
        }
    }
    return kept;
}

constexpr std::array<const char*, 14> motec_names{
    "Ground Speed",         "GPS Latitude",         "GPS Longitude",        "G Force Long",         "G Force Lat",
    "Gyro Yaw Velocity",    "Steered Angle",        "Throttle Pos",         "Brake Pressure Front", "Air Temp Ambient",
    "Tyre Temp FL Surface", "Tyre Temp FR Surface", "Tyre Temp RL Surface", "Tyre Temp RR Surface"};
constexpr std::array<const char*, 14> racechrono_names{"speed",
                                                       "latitude",
                                                       "longitude",
                                                       "longitudinal_acc",
                                                       "lateral_acc",
                                                       "yaw_rate",
                                                       "steering_angle",
                                                       "throttle_pos",
                                                       "brake_pressure",
                                                       "ambient_temp",
                                                       "tire_temp_front_left",
                                                       "tire_temp_front_right",
                                                       "tire_temp_rear_left",
                                                       "tire_temp_rear_right"};
constexpr std::array<const char*, 14> vbox_names{
    "velocity", "lat",         "long",         "LongAcc",     "LatAcc",      "YawRate",     "Steering",
    "Throttle", "Brake_Press", "Ambient_Temp", "TyreTemp_LF", "TyreTemp_RF", "TyreTemp_LR", "TyreTemp_RR"};

std::string motec_csv(const Session& session, const std::vector<LoggedChannel>& channels) {
    std::string beacons;
    for (const double beacon : session.beacons) {
        beacons += (beacons.empty() ? "" : " ") + number(beacon, 3);
    }
    std::string names = "\"Time\"";
    std::string units = "\"s\"";
    for (const LoggedChannel& channel : channels) {
        names += ",\"" + channel.name + "\"";
        units += ",\"" + (channel.unit == "g" ? "G" : channel.unit) + "\"";
    }
    std::string text =
        "\"Format\",\"MoTeC CSV File\",,,\"Workbook\",\"\"\r\n\"Venue\",\"Made-up circuit\",,,\"Worksheet\",\"\"\r\n"
        "\"Vehicle\",\"Made-up car\",,,\"Driver\",\"nobody\"\r\n\"Log Date\",\"16/05/2026\",,,\"Origin "
        "Time\",\"0.000\",\"s\"\r\n\"Sample Rate\",\"" +
        number(rate, 3) + "\",\"Hz\",,\"End Time\",\"" + number(session.time.back(), 3) +
        "\",\"s\"\r\n\"Beacon Markers\",\"" + beacons + "\"\r\n\r\n\r\n" + names + "\r\n" + units + "\r\n\r\n\r\n";
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        text += "\"" + number(session.time[i], 3) + "\"";
        for (const LoggedChannel& channel : channels) {
            text += ",\"" + number(channel.value[i], channel.digits) + "\"";
        }
        text += "\r\n";
    }
    return text;
}

std::string racechrono_csv(const Session& session, const std::vector<LoggedChannel>& channels) {
    std::string names = "timestamp,fragment_id,lap_number";
    std::string units = "unix time,,";
    std::string sources = ",,";
    for (const LoggedChannel& channel : channels) {
        names += "," + channel.name;
        units += "," + (channel.unit == "km/h" ? std::string("m/s")
                        : channel.unit == "C"  ? ".C"
                        : channel.unit == "g"  ? "G"
                                               : channel.unit);
        sources += channel.name == "speed" || channel.unit == "deg" ? ",100: gps" : ",300: canbus";
    }
    std::string text =
        "This file is created using RaceChrono Pro v9.1.3 ( http://racechrono.com/ ).\nFormat,3\nSession "
        "title,\"Made-up circuit\"\nSession type,Lap timing\nCreated,16/05/2026,10:32\nNote,\n\n" +
        names + "\n" + units + "\n" + sources + "\n";
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        std::size_t lap = 0;
        while (lap < session.beacons.size() && session.beacons[lap] <= session.time[i]) {
            ++lap;
        }
        text += number(1778920320.0 + session.time[i], 3) + ",0," + std::to_string(lap);
        for (const LoggedChannel& channel : channels) {
            const bool is_speed = channel.unit == "km/h";
            text += "," + number(channel.value[i] / (is_speed ? 3.6 : 1.0), channel.digits + (is_speed ? 1 : 0));
        }
        text += "\n";
    }
    return text;
}

/// HHMMSS.ss
std::string clock(double seconds) {
    const int whole = static_cast<int>(seconds);
    char text[64];
    std::snprintf(text, sizeof text, "%02d%02d%05.2f", whole / 3600, whole / 60 % 60, seconds - 60.0 * (whole / 60));
    return text;
}

/// Positions in minutes, west positive; the line across the road, 20 m wide.
std::string vbox_vbo(const Session& session, const std::vector<LoggedChannel>& channels) {
    const Circuit circuit = made_up_circuit();
    const std::array<double, 2> here = circuit.place_at(0.0);
    const std::array<double, 2> next = circuit.place_at(1.0);
    const auto end = [&](double side) {
        const std::array<double, 2> place =
            on_earth({here[0] - 10.0 * side * (next[1] - here[1]), here[1] + 10.0 * side * (next[0] - here[0])});
        return number(-60.0 * place[1], 6) + " +" + number(60.0 * place[0], 6);
    };
    std::string header;
    std::string units;
    std::string names = "sats time";
    for (const LoggedChannel& channel : channels) {
        const bool is_standard = channel.name == "velocity" || channel.name == "lat" || channel.name == "long" ||
                                 channel.name == "LongAcc" || channel.name == "LatAcc";
        header += (channel.name == "velocity" ? "velocity kmh"
                   : channel.name == "lat"    ? "latitude"
                   : channel.name == "long"   ? "longitude"
                                              : channel.name) +
                  "\r\n";
        units += is_standard ? "" : channel.unit + "\r\n";
        names += " " + channel.name;
    }
    std::string text = "File created on 16/05/2026 at 10:50:00\r\n\r\n[header]\r\nsatellites\r\ntime\r\n" + header +
                       "\r\n[channel units]\r\n" + units + "\r\n[comments]\r\nLog Rate (Hz) : " + number(rate, 2) +
                       "\r\n\r\n[laptiming]\r\nStart " + end(-1.0) + " " + end(1.0) +
                       " \xC2\xAC Start / Finish\r\n\r\n[column names]\r\n" + names + " \r\n\r\n[data]\r\n";
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        text += "009 " + clock(morning + session.time[i]);
        for (const LoggedChannel& channel : channels) {
            text += channel.name == "lat"    ? " +" + number(60.0 * channel.value[i], 6)
                    : channel.name == "long" ? " " + number(-60.0 * channel.value[i], 6)
                                             : " " + number(channel.value[i], channel.digits);
        }
        text += "\r\n";
    }
    return text;
}

template <typename Whole>
std::string bytes_of(Whole value) {
    std::string bytes;
    for (std::size_t i = 0; i < sizeof(Whole); ++i) {
        bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
    }
    return bytes;
}

std::string padded(std::string text, std::size_t length) {
    text.resize(length, '\0');
    return text;
}

/// Little-endian: a head of 1 KiB, a linked list of channel records of 124 bytes, 32-bit floating point samples.
std::string motec_ld(const Session& session, const std::vector<LoggedChannel>& channels) {
    constexpr std::uint32_t first = 0x400;
    constexpr std::uint32_t size = 124;
    const auto n = static_cast<std::uint32_t>(channels.size());
    const auto samples = static_cast<std::uint32_t>(session.time.size());
    const std::uint32_t data = first + n * size;
    std::string head = bytes_of(std::uint32_t{0x40}) + bytes_of(std::uint32_t{0}) + bytes_of(first) + bytes_of(data);
    head.resize(0x5E, '\0');
    head += padded("16/05/2026", 0x20) + padded("10:32:00", 0x60) + padded("Made-up car", 0x80) + "Made-up circuit";
    std::string text = padded(head, first);
    for (std::uint32_t i = 0; i < n; ++i) {
        const LoggedChannel& channel = channels[i];
        std::string record = bytes_of(i == 0 ? 0 : first + (i - 1) * size) +
                             bytes_of(i + 1 == n ? 0 : first + (i + 1) * size) + bytes_of(data + 4 * samples * i) +
                             bytes_of(samples);
        for (const int one : {0, 7, 4, static_cast<int>(rate), 0, 1, 1, 0}) {
            record += bytes_of(static_cast<std::uint16_t>(one));
        }
        record += padded(channel.name.substr(0, 31), 32) + padded(channel.name.substr(0, 7), 8) +
                  padded(channel.unit == "g" ? "G" : channel.unit, 12);
        text += padded(record, size);
    }
    for (const LoggedChannel& channel : channels) {
        for (const double value : channel.value) {
            text +=
                bytes_of(std::bit_cast<std::uint32_t>(static_cast<float>(std::stod(number(value, channel.digits)))));
        }
    }
    return text;
}

std::string motec_ldx(const Session& session) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<LDXFile Locale=\"English_Australia.1252\" DefaultLocale=\"C\" Version=\"1.6\">\n "
        "<Layers>\n  "
        "<Layer>\n   <MarkerBlock>\n    <MarkerGroup Name=\"Beacons\" Index=\"3\">\n";
    for (std::size_t i = 0; i < session.beacons.size(); ++i) {
        text += "     <Marker Version=\"100\" ClassName=\"BCN\" Name=\"Manual." + std::to_string(i + 1) +
                "\" Flags=\"77\" Time=\"" + number(1e6 * session.beacons[i], 3) + "\"/>\n";
    }
    return text + "    </MarkerGroup>\n   </MarkerBlock>\n  </Layer>\n </Layers>\n</LDXFile>\n";
}

}  // namespace

Session shipped_logger_session() { return drive_session(made_up_circuit(), Car{}, 3, 1.0 / rate); }

std::vector<LoggerFile> shipped_logger_files() {
    const Session session = shipped_logger_session();
    const std::vector<LoggedChannel> all = logged_channels(session, 621);
    return {{"motec.csv", motec_csv(session, renamed(all, motec_names))},
            {"motec.ld", motec_ld(session, renamed(all, motec_names))},
            {"motec.ldx", motec_ldx(session)},
            {"racechrono.csv", racechrono_csv(session, renamed(all, racechrono_names))},
            {"vbox.vbo", vbox_vbo(session, renamed(all, vbox_names))}};
}

}  // namespace hidden_effects
