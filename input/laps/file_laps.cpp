// SPDX-License-Identifier: BSD-3-Clause
// Finds the columns of laps and positions by their names.

#include "input/laps/file_laps.hpp"

#include <algorithm>
#include <cctype>
#include <variant>

#include "input/laps/track_laps.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/text/column_names.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

/// Whether a name says this direction, and nothing else but where it comes from: "GPS_Lat", "Latitude (deg)", "posLng".
bool is_of_receiver(std::string_view name, std::string_view direction) {
    std::size_t found = 0;
    for (const std::string& word : words_of(name)) {
        const bool is_number = std::isdigit(static_cast<unsigned char>(word.front())) != 0;
        const bool says = has_word(direction, word);
        if (!says && !is_number && !has_word(column_words::of_receiver, word)) {
            return false;
        }
        found += says ? 1 : 0;
    }
    return found == 1;
}

bool is_latitude(std::string_view name) { return is_of_receiver(name, column_words::latitude); }
bool is_longitude(std::string_view name) { return is_of_receiver(name, column_words::longitude); }

std::variant<Conversion, UnitError> to_degree(const ColumnHead& head) {
    return conversion(meant_unit(head.heading.unit.value_or("deg"), "degree"), "degree", Scale::absolute);
}

/// An angle, too: a "Bearing [degC]" is a part of a rig.
bool is_heading(const ColumnHead& head) {
    return is_of_receiver(head.heading.name, column_words::course) &&
           std::holds_alternative<Conversion>(to_degree(head));
}

int find_column(const DataFile& file, bool (*is)(std::string_view name)) {
    const auto found =
        std::ranges::find_if(file.heads(), [&](const ColumnHead& head) { return is(head.heading.name); });
    return found == file.heads().end() ? -1 : static_cast<int>(found - file.heads().begin());
}

/// Degrees of a column of positions, which is in degrees or in minutes of them.
void to_degrees(std::vector<double>& values, const ColumnHead& head, double sign) {
    const auto read = to_degree(head);
    const auto* found = std::get_if<Conversion>(&read);
    for (double& value : values) {
        value = sign * (found != nullptr ? found->to_si(value) : value);
    }
}

}  // namespace

bool is_of_position(std::string_view name) { return is_latitude(name) || is_longitude(name); }

std::optional<Positions> read_positions(const DataFile& file, const std::vector<double>& time,
                                        const InputErrors& errors) {
    const int latitude = find_column(file, is_latitude);
    const int longitude = find_column(file, is_longitude);
    if (latitude < 0 || longitude < 0) {
        return std::nullopt;
    }
    DataFile::Samples north = file.samples(latitude, time, errors);
    DataFile::Samples east = file.samples(longitude, time, errors);
    if (north.value.empty() || north.time.size() != east.time.size()) {
        return std::nullopt;
    }
    Positions positions{
        .time = std::move(north.time), .latitude = std::move(north.value), .longitude = std::move(east.value)};
    to_degrees(positions.latitude, file.heads()[static_cast<std::size_t>(latitude)], 1.0);
    to_degrees(positions.longitude, file.heads()[static_cast<std::size_t>(longitude)],
               file.description().west_is_positive ? -1.0 : 1.0);
    return positions;
}

std::vector<WrittenHeading> read_headings(const DataFile& file, const std::vector<double>& time,
                                          const InputErrors& errors) {
    std::vector<WrittenHeading> found;
    for (std::size_t i = 0; i < file.heads().size(); ++i) {
        const ColumnHead& head = file.heads()[i];
        DataFile::Samples written =
            is_heading(head) ? file.samples(static_cast<int>(i), time, errors) : DataFile::Samples{};
        if (!written.value.empty()) {
            to_degrees(written.value, head, 1.0);
            found.push_back(
                {.column = head.heading.name, .time = std::move(written.time), .degrees = std::move(written.value)});
        }
    }
    return found;
}

bool tells_course(const DataFile& file) {
    return std::ranges::any_of(file.heads(), is_heading) ||
           (find_column(file, is_latitude) >= 0 && find_column(file, is_longitude) >= 0);
}

bool counts_laps(std::string_view name) { return has_word(column_words::laps, bare_name(name)); }

Laps find_laps(const DataFile& file, const std::vector<double>& time, const std::optional<StartLine>& line, bool search,
               const InputErrors& errors) {
    if (time.size() < 2) {
        return {};
    }
    const auto by_line = [&](const std::optional<StartLine>& across, const Positions& positions, LapSource source) {
        Laps found{.source = source};
        if (across) {
            found.laps = laps_between(crossings_of(positions, *across), time.front(), time.back());
        }
        if (found.laps.empty()) {
            found = {};
            found.nearest = across ? std::optional(nearest_to(positions, *across)) : std::nullopt;
        }
        return found;
    };
    if (line) {
        const std::optional<Positions> positions = read_positions(file, time, errors);
        return positions ? by_line(line, *positions, LapSource::start_line) : Laps{};
    }
    if (Laps found{.source = LapSource::markers,
                   .laps = laps_between(file.description().markers, time.front(), time.back())};
        !found.laps.empty()) {
        return found;
    }
    if (const int column = find_column(file, counts_laps); column >= 0) {
        const DataFile::Samples number = file.samples(column, time, errors);
        Laps found{.source = LapSource::column, .column = file.heads()[static_cast<std::size_t>(column)].heading.name};
        found.laps = laps_by_counter(number.time, number.value);
        if (!found.laps.empty()) {
            return found;
        }
    }
    if (file.description().start_line || search) {
        if (const std::optional<Positions> positions = read_positions(file, time, errors)) {
            std::optional<StartLine> of_file = file.description().start_line;
            if (of_file) {
                of_file = line_across(*positions, *of_file);
            }
            Laps found = by_line(of_file, *positions, LapSource::start_line);
            return found.laps.empty() && search
                       ? by_line(find_start_line(*positions), *positions, LapSource::closed_track)
                       : found;
        }
    }
    return {};
}

}  // namespace tiretherm::input
