// SPDX-License-Identifier: BSD-3-Clause
// Rules on the words of a heading: which it must have, and which make it something else.

#include "input/loggers/car_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "input/text/column_names.hpp"

namespace tiretherm::input {

namespace {

using Words = std::vector<std::string>;

/// A heading is `name` if it has a word of each list that is not empty, and none of the last.
struct Rule {
    std::string_view name;
    std::string_view first;
    std::string_view second;
    std::string_view without;
    std::string_view question{};  ///< what the heading leaves open
};

constexpr std::string_view which_sign = "its sign differs from logger to logger";

constexpr std::string_view temperature = "temp temperature temps tmp t";
constexpr std::string_view pressure = "pressure press prs pres";
constexpr std::string_view acceleration = "acc accel acceleration accelerometer g gforce force";
constexpr std::string_view other_speeds =
    "wheel whl engine motor fan wind pit slip yaw roll pitch rotation gyro angular std accuracy error difference delta "
    "min max "
    "target limit limiter shaft turbo steering steer damper shock vertical east north quality sats";
constexpr std::string_view not_along = "lat lateral yaw vertical vert jerk wheel tire tyre offset raw std accuracy";
constexpr std::string_view not_across =
    "lon long longitudinal inline yaw vertical vert jerk wheel tire tyre offset raw std accuracy";
constexpr std::string_view not_yaw = "acc accel acceleration angle error offset roll pitch std accuracy";
constexpr std::string_view not_an_angle =
    "torque speed rate velocity vel force moment pressure press temp effort motor button paddle";
constexpr std::string_view not_a_pedal =
    "temp temperature tmp bias balance switch light disc disk rotor pad caliper wear fluid duct";
constexpr std::string_view not_outside =
    "intake inlet charge manifold airbox box engine cabin cockpit tire tyre brake iat plenum pressure cylinder duct in";
constexpr std::string_view not_a_road = "tire tyre brake pressure engine oil water";
constexpr std::string_view not_tread =
    "brake brakes brk disc disk rotor caliper hub pad gas tpms internal air tair pressure press core carcass bulk rim "
    "damper oil "
    "inflation cavity liner innerliner road track pyro target optimal ideal sidewall";
constexpr std::string_view not_inside =
    "brake brakes disc disk rotor caliper hub pad gas tpms air tair pressure press rim damper oil";
constexpr std::string_view not_gas = "brake brakes disc disk rotor caliper hub pad pressure press rim damper oil";
constexpr std::string_view not_inflation =
    "brake brakes brk damper oil temp temperature target cold warning ref reference";

// The surer before the less sure.
constexpr std::array of_car{
    Rule{"speed", "gps", "speed velocity vel", other_speeds},
    Rule{"speed", "gpsspeed", "", other_speeds},
    Rule{"speed", "ground vehicle car veh true", "speed velocity vel", other_speeds},
    Rule{"speed", "speed velocity groundspeed vcar", "", other_speeds},
    Rule{"longitudinal_acceleration", "lon long longitudinal inline", acceleration, not_along},
    Rule{"longitudinal_acceleration", "longacc lonacc longaccel lonaccel inlineacc glong glon longg", "", not_along},
    Rule{"lateral_acceleration", "lat lateral", acceleration, not_across},
    Rule{"lateral_acceleration", "latacc lataccel lateralacc glat latg", "", not_across},
    Rule{"yaw_rate", "yaw", "rate velocity vel speed gyro", not_yaw},
    Rule{"yaw_rate", "yawrate yawvel roty gyroz", "", not_yaw},
    Rule{"yaw_rate", "gps", "gyro", not_yaw},
    Rule{"steering_wheel_angle", "steer steering steered handwheel", "angle ang pos position wheel", not_an_angle},
    Rule{"steering_wheel_angle", "steer steering steered steerangle steeringangle steeringwheel swa", "", not_an_angle},
    Rule{"brake_pressure", "brake brakes brk", pressure,
         "rear temp temperature tmp bias balance switch light fl fr rl rr lf rf lr"},
    Rule{"brake_pressure", "brakepress brakepressure", "", "rear temp temperature tmp bias balance switch light"},
    Rule{"brake_pressure", "brake brakes brk", pressure, not_a_pedal},
    Rule{"brake_pressure", "brake brakes brk", "", not_a_pedal},
    Rule{"air_temperature", "ambient outside outdoor external ext weather", temperature, not_outside},
    Rule{"air_temperature", "airtemp ambienttemp outsidetemp tamb tair", "", not_outside},
    Rule{"air_temperature", "air", temperature, not_outside},
    Rule{"road_temperature", "track road asphalt tarmac pavement", temperature, not_a_road},
    Rule{"road_temperature", "tracktemp roadtemp ttrack troad", "", not_a_road}};
constexpr std::array of_corner{
    Rule{"gas_temperature", "tpms gas cavity", temperature, not_gas},
    Rule{"gas_temperature", "tire tyre", "tair gas air internal", not_gas},
    Rule{"bulk_temperature", "core carcass bulk", "temp temperature temps tmp t tire tyre", not_inside},
    Rule{"surface_temperature", "tire tyre tread surface surf", "temp temperature temps tmp t ir infrared surface surf",
         not_tread},
    Rule{"surface_temperature", "ir infrared irtemp tiretemp tyretemp ttire ttyre", "", not_tread},
    Rule{"inflation_pressure", "tire tyre tpms wheel", pressure, not_inflation},
    Rule{"brake_temperature", "brake brakes brk disc disk rotor", temperature, "caliper pad fluid tire tyre"},
    Rule{"brake_temperature", "braketemp disctemp", "", "caliper pad fluid"},
    Rule{"vertical_load", "fz wheelload tireload tyreload", "", "aero"},
    Rule{"vertical_load", "wheel tire tyre vertical", "load", "aero"}, Rule{"camber", "camber", "", "gain", which_sign},
    Rule{"slip_angle", "slip", "angle", "body", which_sign}, Rule{"slip_ratio", "slip", "ratio", "", which_sign},
    Rule{"inflation_pressure", "tpms tirepress tyrepress tirepressure tyrepressure", "", not_inflation},
    Rule{"inflation_pressure", "pressure press", "", not_inflation},
    // iRacing: LFtempCM is the middle of the carcass, LFtempM that of the surface.
    Rule{"bulk_temperature", "temp", "cm", not_inside}, Rule{"surface_temperature", "temp", "m", not_tread}};

constexpr std::array<std::array<std::string_view, 2>, 3> zones{{{"outside_shoulder_", "outer outside outboard out"},
                                                                {"crown_", "middle mid centre center"},
                                                                {"inside_shoulder_", "inner inside inboard in"}}};

bool contains(std::string_view list, std::string_view word) {
    for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
        const bool begins = at == 0 || list[at - 1] == ' ';
        const bool ends = at + word.size() == list.size() || list[at + word.size()] == ' ';
        if (begins && ends) {
            return true;
        }
    }
    return false;
}

bool has_any(const Words& words, std::string_view list) {
    return std::ranges::any_of(words, [&](const std::string& word) { return contains(list, word); });
}

bool agrees(const Words& words, const Rule& rule) {
    return has_any(words, rule.first) && (rule.second.empty() || has_any(words, rule.second)) &&
           !has_any(words, rule.without);
}

/// "3" or "03" of an array of readings, not "2025".
bool is_place(std::string_view word) {
    constexpr std::size_t digits = 2;
    return word.size() <= digits &&
           std::ranges::all_of(word, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

/// "LFtempCM" as LF tempCM: the letters of a corner stick to the word.
std::string with_corner_apart(std::string_view heading) {
    std::string apart(heading);
    const std::string letters = apart.substr(0, 2);
    const bool is_corner = letters == "LF" || letters == "RF" || letters == "LR" || letters == "RR" ||
                           letters == "FL" || letters == "FR" || letters == "RL";
    if (is_corner && apart.size() > 2 && std::islower(static_cast<unsigned char>(apart[2])) != 0) {
        apart.insert(2, " ");
    }
    return apart;
}

std::string corner_of(const Words& words) {
    struct Spelling {
        std::string_view corner;
        std::string_view alone;
        std::string_view axle;
        std::string_view side;
    };
    constexpr std::array spellings{Spelling{"FL", "fl lf frontleft leftfront", "front", "left"},
                                   Spelling{"FR", "fr rf frontright rightfront", "front", "right"},
                                   Spelling{"RL", "rl lr rearleft leftrear", "rear", "left"},
                                   Spelling{"RR", "rr rearright rightrear", "rear", "right"}};
    for (const Spelling& spelling : spellings) {
        if (has_any(words, spelling.alone) || (has_any(words, spelling.axle) && has_any(words, spelling.side))) {
            return std::string(spelling.corner);
        }
    }
    return {};
}

/// A reading of one tire: where across the tread, as far as a word says it.
void add_of_corner(const Words& words, const std::string& corner, std::vector<CarColumn>& found) {
    for (std::size_t i = 0; i < of_corner.size(); ++i) {
        const Rule& rule = of_corner.at(i);
        if (!agrees(words, rule)) {
            continue;
        }
        CarColumn column{
            .name = std::string(rule.name), .corner = corner, .rank = static_cast<int>(i), .question = rule.question};
        if (rule.name == "surface_temperature") {
            const auto zone = std::ranges::find_if(zones, [&](const auto& one) { return has_any(words, one[1]); });
            if (zone != zones.end()) {
                column.name = std::string((*zone)[0]) + column.name;
            } else if (const auto number = std::ranges::find_if(words, is_place); number != words.end()) {
                column.place = std::stoi(*number);
            }
        }
        found.push_back(std::move(column));
    }
}

}  // namespace

std::string corner_of(std::string_view heading) { return corner_of(words_of(with_corner_apart(heading))); }

std::vector<CarColumn> car_columns(std::string_view heading) {
    const Words words = words_of(with_corner_apart(heading));
    const std::string corner = corner_of(words);
    std::vector<CarColumn> found;
    if (!corner.empty()) {
        add_of_corner(words, corner, found);
        return found;
    }
    for (std::size_t i = 0; i < of_car.size(); ++i) {
        if (agrees(words, of_car.at(i))) {
            // Before it knows where it is a GPS makes accelerations of nothing; speeds it has best.
            const bool is_derived = is_motion(of_car.at(i).name) && has_any(words, "gps calc");
            const std::size_t rank = is_derived ? i + of_car.size() : i;
            found.push_back({.name = std::string(of_car.at(i).name), .corner = {}, .rank = static_cast<int>(rank)});
        }
    }
    return found;
}

bool is_motion(std::string_view name) {
    return name == "longitudinal_acceleration" || name == "lateral_acceleration" || name == "yaw_rate" ||
           name == "steering_wheel_angle";
}

}  // namespace tiretherm::input
