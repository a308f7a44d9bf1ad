// SPDX-License-Identifier: BSD-3-Clause
// Logs of phones and engine tuners: tables like any other, which a word at their beginning names. A format is an entry of the list.

#include <array>
#include <span>

#include "input/loggers/csv_layout.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

/// A program's files.
struct MarkedFormat {
    std::string_view name;
    std::string_view mark;    ///< in one of the first lines
    std::string_view second;  ///< in one of them besides
    std::span<const KnownColumn> known;
};

// The phone's axes after it was aligned: x to the side, y along the car.
constexpr std::array trackaddict{KnownColumn{"Time", "", "s"},
                                 KnownColumn{"Heading", "", "deg"},
                                 KnownColumn{"Latitude", "", "deg"},
                                 KnownColumn{"Longitude", "", "deg"},
                                 KnownColumn{"Accel X", "Accel X (lateral)", "g"},
                                 KnownColumn{"Accel Y", "Accel Y (longitudinal)", "g"},
                                 KnownColumn{"Accel Z", "", "g"}};
constexpr std::array racecapture{KnownColumn{"Interval", "time", "ms"}, KnownColumn{"AccelX", "AccelX (lateral)", "g"},
                                 KnownColumn{"AccelY", "AccelY (longitudinal)", "g"},
                                 KnownColumn{"Yaw", "Yaw (rate)", "deg/s"}};
constexpr std::array torque{KnownColumn{"Latitude", "", "deg"}, KnownColumn{"Longitude", "", "deg"},
                            KnownColumn{"Bearing", "", "deg"}, KnownColumn{"Altitude", "", "m"}};
constexpr std::array formats{MarkedFormat{"TrackAddict CSV", "# RaceRender Data", "", trackaddict},
                             MarkedFormat{"RaceCapture log", "\"|\"", "\"Interval\"|", racecapture},
                             MarkedFormat{"Torque CSV", "GPS Time", "Device Time", torque},
                             MarkedFormat{"Accessport CSV", "AP Info:", "Time (sec)", {}},
                             MarkedFormat{"TunerStudio .msl", "Capture Date:", "", {}}};

/// The last heading of an Accessport says of the device what would be a column, and has no values.
void take_device(CsvLayout& layout) {
    std::string_view& names = layout.lines.names.text;
    std::size_t at = names.find("AP Info:");
    if (at == std::string_view::npos) {
        return;
    }
    layout.description.details.push_back({"Device", printable(names.substr(at + 8))});
    at -= at > 0 && names[at - 1] == '"' ? 1 : 0;
    names = trim(names.substr(0, at));
    names.remove_suffix(names.ends_with(',') ? 1 : 0);
}

}  // namespace

std::optional<CsvLayout> find_marked_layout(std::string_view text) {
    constexpr int searched = 4;  // lines
    std::string_view rest = text;
    for (int i = 0; i < searched && next_line(rest); ++i) {
    }
    const std::string_view begin = text.substr(0, text.size() - rest.size());
    for (const MarkedFormat& format : formats) {
        if (begin.find(format.mark) == std::string_view::npos || begin.find(format.second) == std::string_view::npos) {
            continue;
        }
        CsvLayout layout;
        layout.description.format = format.name;
        layout.lines = find_head_lines(text);
        take_device(layout);
        layout.separator = separator_of(layout.lines.names.text);
        layout.known.assign(format.known.begin(), format.known.end());
        return layout;
    }
    return std::nullopt;
}

}  // namespace tiretherm::input
