// SPDX-License-Identifier: BSD-3-Clause
// Writes a made-up session as the loggers write theirs, after their makers' descriptions; knows nothing of the reader.
#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace tiretherm::input::made_up {

/// A number with so many decimals, and a decimal comma where it is wanted.
inline std::string digits(double value, int decimals, bool comma = false) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string result = text;
    if (const std::size_t point = result.find('.'); comma && point != std::string::npos) {
        result[point] = ',';
    }
    return result;
}

/// A car on a circle of 200 m radius: 40 m/s, a lap in 10 pi s, begun half a lap before the line. Sampled every `step` s.
struct Session {
    static constexpr double radius = 200.0;    ///< m
    static constexpr double car_speed = 40.0;  ///< m/s
    static constexpr double latitude = 51.0;   ///< degrees, of the centre
    static constexpr double longitude = 7.0;

    Session(std::size_t n, double step) {
        for (std::size_t i = 0; i < n; ++i) {
            time.push_back(step * static_cast<double>(i));
        }
    }
    /// Angle from the line, at the circle's easternmost point, where the car goes north.
    static double angle(double t) { return -std::numbers::pi + car_speed * t / radius; }
    static double north(double t) { return latitude + radius * std::sin(angle(t)) / metres; }
    static double east(double t) {
        return longitude + radius * std::cos(angle(t)) / (metres * std::cos(latitude * std::numbers::pi / 180.0));
    }
    static double speed(double t) { return 3.6 * car_speed + 2.0 * std::sin(0.3 * t); }  // km/h
    static double tread(double t) { return 60.0 + 25.0 * (1.0 - std::exp(-t / 40.0)); }  // degC
    static double load(double t) { return 4000.0 + 500.0 * std::sin(0.7 * t); }          // N
    /// When the car crosses the line for the k-th time, from 0 on.
    static double crossing(int k) { return (2.0 * k + 1.0) * std::numbers::pi * radius / car_speed; }

    static constexpr double metres = 111320.0;  ///< of a degree of latitude
    std::vector<double> time;
};

/// What can differ between exports of one logger.
struct Style {
    char separator = ',';
    bool comma = false;  ///< in numbers
    bool quotes = true;
};

inline std::string line_of(const std::vector<std::string>& fields, const Style& style) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        line += (i > 0 ? std::string(1, style.separator) : "") + (style.quotes ? "\"" + fields[i] + "\"" : fields[i]);
    }
    return line + "\r\n";
}

/// A table of time, speed, load and tread temperature.
inline std::string rows_of(const Session& session, const Style& style) {
    std::string text;
    for (const double t : session.time) {
        text += line_of({digits(t, 3, style.comma), digits(Session::speed(t), 2, style.comma),
                         digits(Session::load(t), 1, style.comma), digits(Session::tread(t), 3, style.comma)},
                        style);
    }
    return text;
}

/// AiM RaceStudio: key and values in each line, an empty line, names, units, an empty line, values.
inline std::string aim_csv(const Session& session, const Style& style = {}) {
    std::vector<std::string> beacons{"Beacon Markers"};
    std::vector<std::string> segments{"Segment Times"};
    double before = 0.0;
    for (int k = 0; Session::crossing(k) < session.time.back(); ++k) {
        beacons.push_back(digits(Session::crossing(k), 3, style.comma));
        segments.push_back("0:" + digits(Session::crossing(k) - before, 3, style.comma));
        before = Session::crossing(k);
    }
    beacons.push_back(digits(session.time.back(), 3, style.comma));  // the export's end
    segments.push_back("0:" + digits(session.time.back() - before, 3, style.comma));
    std::string text;
    const std::vector<std::vector<std::string>> head{
        {"Format", "AiM CSV File"},
        {"Session", "Test"},
        {"Vehicle", "M4 GT4"},
        {"Racer", ""},
        {"Date", style.quotes ? "Tuesday, December 16, 2025" : "16/12/2025"},
        {"Time", "11:49 AM"},
        {"Sample Rate", "20"},
        {"Duration", digits(session.time.back(), 3, style.comma)},
        {"Segment", "Session"}};
    for (const auto& line : head) {
        text += line_of(line, style);
    }
    text += line_of(beacons, style) + line_of(segments, style) + "\r\n";
    text += line_of({"Time", "speed", "vertical_load", "surface_temperature"}, style);
    return text + line_of({"s", "km/h", "N", "C"}, style) + "\r\n" + rows_of(session, style);
}

/// MoTeC i2: keys with several values and gaps between them; the beacons in one field with blanks between them.
inline std::string motec_csv(const Session& session) {
    std::string beacons;
    for (int k = 0; Session::crossing(k) < session.time.back(); ++k) {
        beacons += digits(Session::crossing(k), 3) + " ";
    }
    return "\"Format\",\"MoTeC CSV File\",,,\"Workbook\",\"\"\r\n\"Venue\",\"Track\",,,\"Worksheet\",\"\"\r\n"
           "\"Log Date\",\"16/12/2025\",,,\"Origin Time\",\"0.000\",\"s\"\r\n"
           "\"Sample Rate\",\"20.000\",\"Hz\",,\"End Time\",\"100.000\",\"s\"\r\n\"Beacon Markers\",\"" +
           beacons + "\"\r\n\r\n\r\n\"Time\",\"speed\",\"vertical_load\",\"surface_temperature\"\r\n" +
           "\"s\",\"km/h\",\"N\",\"C\"\r\n\r\n\r\n" + rows_of(session, {});
}

/// RaceChrono, format 3: names, units and sources; two speeds; the tread every second line; seconds since 1970.
inline std::string racechrono_csv(const Session& session) {
    std::string text =
        "This file is created using RaceChrono Pro v9.1.3 ( http://racechrono.com/ ).\nFormat,3\nSession "
        "title,\"Test\"\n"
        "Session type,Lap timing\nTrack name,\"Circle\"\nDriver name,\nCreated,16/12/2025,11:49\nNote,\n\n"
        "timestamp,fragment_id,lap_number,elapsed_time,latitude,longitude,speed,speed,vertical_load,surface_"
        "temperature\n"
        "unix time,,,s,deg,deg,m/s,m/s,N,.C\n,,,,100: gps,100: gps,100: gps,calc,300: canbus,300: canbus\n";
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        const double t = session.time[i];
        int lap = 0;
        while (Session::crossing(lap) <= t) {
            ++lap;
        }
        text += digits(1765885743.25 + t, 3) + ",0," + std::to_string(lap) + "," + digits(t, 3) + "," +
                digits(Session::north(t), 7) + "," + digits(Session::east(t), 7) + "," +
                digits(Session::speed(t) / 3.6, 3) + "," + digits(Session::speed(t) / 3.6 + 1.0, 3) + "," +
                digits(Session::load(t), 1) + "," + (i % 2 == 0 ? digits(Session::tread(t), 3) : "") + "\n";
    }
    return text;
}

/// RaceChrono, format 2: units in round brackets and the source behind a star.
inline std::string racechrono_csv_2(const Session& session) {
    std::string text =
        "This file is created using RaceChrono v7.0.8 ( http://racechrono.com/ ).\nFormat,2\nSession title,\"Test\"\n\n"
        "Time (s),Lap #,Speed (km/h) *gps,Speed (km/h) *canbus,vertical_load (N),surface_temperature (C)\n";
    for (const double t : session.time) {
        text += digits(t, 3) + ",1," + digits(Session::speed(t), 2) + "," + digits(Session::speed(t) + 1.0, 2) + "," +
                digits(Session::load(t), 1) + "," + digits(Session::tread(t), 3) + "\n";
    }
    return text;
}

/// HHMMSS.ss of seconds since midnight, beyond 24 h from 0 on again.
inline std::string clock_digits(double seconds) {
    const double of_day = std::fmod(seconds, 86400.0);
    const auto hours = static_cast<int>(of_day / 3600.0);
    const auto minutes = static_cast<int>((of_day - 3600.0 * hours) / 60.0);
    char text[64];
    std::snprintf(text, sizeof text, "%02d%02d%05.2f", hours, minutes, of_day - 3600.0 * hours - 60.0 * minutes);
    return text;
}

/// VBOX: positions in minutes, west positive; times of the day; a start line of 30 m at the circle's easternmost point.
/// @param start s since midnight
inline std::string vbox_vbo(const Session& session, double start) {
    const double line_west = Session::longitude + (Session::radius - 15.0) / (Session::metres * std::cos(0.890117918));
    const double line_east = Session::longitude + (Session::radius + 15.0) / (Session::metres * std::cos(0.890117918));
    const std::string minutes = "+" + digits(60.0 * Session::latitude, 6);
    std::string text =
        "File created on 16/12/2025 at 23:59:00\r\n\r\n[header]\r\nsatellites\r\ntime\r\nlatitude\r\nlongitude\r\n"
        "velocity kmh\r\nheading\r\nheight\r\nvertical_load\r\nsurface_temperature\r\n\r\n[channel "
        "units]\r\nN\r\nC\r\n\r\n"
        "[comments]\r\nLog Rate (Hz) : 20.00\r\n\r\n[laptiming]\r\nStart " +
        digits(-60.0 * line_west, 6) + " " + minutes + " " + digits(-60.0 * line_east, 6) + " " + minutes +
        " \xC2\xAC Start / Finish\r\n\r\n[column names]\r\n"
        "sats time lat long velocity heading height vertical_load surface_temperature \r\n\r\n[data]\r\n";
    for (const double t : session.time) {
        text += "009 " + clock_digits(start + t) + " +" + digits(60.0 * Session::north(t), 6) + " " +
                digits(-60.0 * Session::east(t), 6) + " " + digits(Session::speed(t), 3) + " 000.00 +0100.00 " +
                digits(Session::load(t), 1) + " " + digits(Session::tread(t), 3) + "\r\n";
    }
    return text;
}

}  // namespace tiretherm::input::made_up
