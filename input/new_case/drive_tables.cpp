// SPDX-License-Identifier: BSD-3-Clause
// [drive], [initial] and [time] of a new case: the library's constants, or what the log says.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/new_case/case_tables.hpp"
#include "physics/celsius.hpp"
#include "physics/tire_laws/load_capacity.hpp"

namespace tiretherm::input {

namespace {

/// An input that the effects of a tire or of a specimen need, and what the library's constant is.
struct NeededInput {
    std::string_view name;
    std::string_view ground;
    bool of_tire = true;
    bool of_specimen = false;
};
constexpr std::array needed{NeededInput{"vertical_load", "that of the thesis's first warm-up"},
                            NeededInput{"speed", "that of the thesis's first warm-up"},
                            NeededInput{"laser_power", "one of the thesis's", false, true},
                            NeededInput{"air_temperature", "a room; the thesis names none", true, true},
                            NeededInput{"road_temperature", "that of the air; a road in the sun is hotter"}};

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    double count = 0.0;
    for (const double value : values) {
        sum += std::isnan(value) ? 0.0 : value;
        count += std::isnan(value) ? 0.0 : 1.0;
    }
    return sum / count;
}

/// The constant in place of an input that no log gives, and where it is from.
struct Constant {
    std::string value;
    std::string ground;
};
Constant constant(const CaseDraft& draft, const NeededInput& input) {
    constexpr double load_share = 0.8;   // of what the tire may carry: ISO 28580 measures rolling resistance so
    constexpr double speed_share = 0.8;  // of a slow tire's symbol
    const TireSize& size = draft.request.size;
    const double usual_speed = (size.truck ? 80.0 : 100.0) / 3.6;
    const std::optional<double> load = size.service ? size.service->load() : std::nullopt;
    if (const LogColumn* air = draft.column("air_temperature"); input.name == "road_temperature" && air != nullptr) {
        return {shown_celsius(mean(air->value)), "the mean of the log's air_temperature; a road in the sun is hotter"};
    }
    if (input.name == "vertical_load" && load) {
        const double carried = physics::load_capacity(*load, draft.inflation_pressure, size.load_pressure());
        return {fmt::format("{:.0f} N", 10.0 * std::round(0.1 * load_share * carried)),
                fmt::format("80 % of what load index {} carries at {:g} kPa", size.service->load_index,
                            draft.inflation_pressure * 1e-3)};
    }
    constexpr double of_thesis = 4000.0;  // N, of its first warm-up
    physics::TireOutline outline = draft.outline();
    if (size.motorcycle) {  // its pressure is higher for its load: as a passenger tire at as large a share of its pressure
        outline.inflation_pressure *= physics::TireOutline{}.inflation_pressure / size.load_pressure();
    }
    if (const double ratio = physics::load_ratio(outline);
        input.name == "vertical_load" && std::abs(ratio - 1.0) > 1e-9) {
        return {fmt::format("{:.0f} N", 10.0 * std::round(0.1 * of_thesis * ratio)),
                fmt::format("the size has no load index; that of the thesis's first warm-up in proportion to the size "
                            "at {:g} kPa",
                            draft.inflation_pressure * 1e-3)};
    }
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const double fastest = size.service ? size.service->speed().value_or(unknown) : unknown;
    if (input.name == "speed" && speed_share * fastest < usual_speed) {
        return {fmt::format("{:.0f} km/h", 3.6 * speed_share * fastest),
                fmt::format("80 % of what the speed symbol {} allows", size.service->speed_symbol)};
    }
    if (input.name == "speed" && size.truck) {
        return {fmt::format("{:.0f} km/h", 3.6 * usual_speed),
                "that of a truck, at which ISO 28580 measures its tires"};
    }
    return {draft.mesh.setting("drive", input.name), std::string(input.ground)};
}

/// Inputs that may be given, as comments.
void suggest_inputs(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    if (draft.column("slip_angle") == nullptr && draft.column("lateral_force") == nullptr) {
        writer.suggestion("slip_angle", "2 deg");
        writer.suggestion("lateral_force", "2500 N");
    }
    if (draft.mesh.name == "section" && draft.column("camber") == nullptr) {
        writer.suggestion("camber", "-2 deg");
    }
    if (draft.request.size.motorcycle && !draft.request.size.is_motorcycle_front()) {
        writer.suggestion("longitudinal_force", "200 N");
        writer.suggestion("slip_ratio", "0.005");
    }
}

void suggest_schedule(CaseWriter& writer, bool is_specimen) {
    writer.caption("Straight lines between rows may take the place of a constant, two rows at one time are a jump:");
    writer.comment_out(true);
    writer.table("drive.schedule");
    const std::string_view input = is_specimen ? "laser_power" : "speed";
    writer.entry("columns", fmt::format("[\"time [min]\", \"{} [{}]\"]", input, is_specimen ? "W" : "km/h"),
                 fmt::format("remove {} from [drive] then", input));
    writer.entry("rows",
                 is_specimen ? "[[0, 1], [10, 1], [10, 3], [20, 3]]" : "[[0, 80], [20, 80], [20, 120], [60, 120]]");
    writer.comment_out(false);
}

/// The mean of the first values of the sensors whose names end so; nothing where there is none.
std::optional<double> first_of(const CaseDraft& draft, std::string_view ending) {
    std::vector<double> found;
    for (const TemplateSensor& sensor : draft.mesh.sensors) {
        const LogColumn* column = draft.column(sensor.name);
        if (column != nullptr && sensor.name.ends_with(ending) && column->first_value()) {
            found.push_back(*column->first_value());
        }
    }
    return found.empty() ? std::nullopt : std::optional(mean(found));
}

/// Why the case has a constant in place of a column.
std::string lacking_of(const Log* log, std::string_view input) {
    if (log == nullptr) {
        return {};
    }
    const auto dropped = std::ranges::find_if(
        log->columns, [&](const LogColumn& column) { return column.is_dropped && column.suggestion == input; });
    return dropped == log->columns.end()
               ? "the log does not give it; "
               : fmt::format("the log's column {} cannot be used, {}; ", dropped->heading.name, dropped->reason);
}

}  // namespace

std::string shown_celsius(double kelvin) {
    return fmt::format("{:g} degC", std::round(celsius(kelvin) * 100.0) / 100.0);
}

std::string shown_seconds(double seconds) { return fmt::format("{} s", seconds); }

void write_drive(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    writer.table("drive", draft.column("time") != nullptr ? "what the log does not give"
                                                          : "the inputs, in any unit: \"62 mph\" will do");
    const bool of_car = draft.log() != nullptr && draft.log()->is_car;
    for (const NeededInput& input : needed) {
        if (draft.is_specimen() ? !input.of_specimen : !input.of_tire) {
            continue;
        }
        if (of_car && input.name == "vertical_load" && draft.column(input.name) == nullptr &&
            draft.log()->has_motion()) {
            writer.remark("vertical_load, forces and slips of each tire follow from [vehicle] and the log.");
            continue;
        }
        if (const LogColumn* column = draft.column(input.name)) {
            writer.remark(fmt::format("{}: the log's column {}", input.name, column->title()));
            continue;
        }
        const auto [value, ground] = constant(draft, input);
        draft.assume_entry(input.name, value, ground, lacking_of(draft.log(), input.name));
    }
    if (!of_car && !draft.is_specimen()) {
        suggest_inputs(draft);
    }
    if (draft.column("time") == nullptr) {
        suggest_schedule(writer, draft.is_specimen());
    }
}

void write_initial(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    const std::optional<double> surface = first_of(draft, "surface_temperature");
    const std::optional<double> bulk = first_of(draft, "bulk_temperature");
    const std::optional<double> liner = first_of(draft, "inner_liner_temperature");
    const std::optional<double> gas = first_of(draft, "gas_temperature");
    // The inside of a tire is what its bulk reads; a liner is nearer to it than a surface, and gas follows the rim as well.
    const std::optional<double> inside = bulk ? bulk : liner ? liner : surface ? surface : gas;
    writer.table("initial");
    const bool of_corners = draft.log() != nullptr && !draft.log()->corners().empty();
    if (const std::string sensor = of_corners ? first_sensor_of_all(*draft.log()) : ""; !sensor.empty()) {
        writer.entry("temperature", sensor,
                     "of each tire: what its sensor reads first, all through the tire; assumed: it has stood a while");
        draft.assume("initial.temperature", sensor, "what each tire's sensor reads first, all through the tire");
        if (draft.mesh.name == "section" && sensor != "gas_temperature" && all_have(*draft.log(), "gas_temperature")) {
            writer.entry("gas", "gas_temperature", "of each tire: what its sensor reads first");
        }
        return;
    }
    if (!inside || of_corners) {
        const bool logged = draft.column("air_temperature") != nullptr;
        const std::string value = logged ? "air_temperature" : draft.mesh.setting("initial", "temperature");
        writer.entry("temperature", value,
                     logged ? "everywhere at the start; assumed: the log's first air_temperature"
                            : "everywhere at the start; or \"air_temperature\", that of the air");
        draft.assume("initial.temperature", value,
                     logged ? "a tire that has stood in the air of the log's first sample" : "that of air and road");
        return;
    }
    writer.entry("temperature", shown_celsius(*inside),
                 fmt::format("everywhere but in what follows: the log's first {} temperature", bulk      ? "bulk"
                                                                                               : liner   ? "inner liner"
                                                                                               : surface ? "surface"
                                                                                                         : "gas"));
    const bool thick = draft.mesh.name == "section";  // its tread is a single layer of 8 mm
    if (surface && inside != surface) {
        const double tread = thick ? 0.5 * (*surface + *inside) : *surface;
        writer.entry(thick ? "tread" : "surface", shown_celsius(tread),
                     thick ? "the mean of the log's first surface and inner temperatures"
                           : "the log's first surface temperature");
    }
    if (thick && liner && inside != liner) {
        writer.entry("liner", shown_celsius(*liner), "the log's first inner liner temperature");
    }
    if (thick && gas) {
        writer.entry("gas", shown_celsius(*gas), "the log's first gas temperature");
    }
}

void write_time(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    writer.table("time");
    if (const Log* log = draft.log(); log == nullptr) {
        writer.entry("end", draft.mesh.setting("time", "end"), "of the run, in any unit: \"1 h\"; until it is warm");
    } else if (log->use == LogUse::nothing) {
        writer.entry("start", shown_seconds(log->time.front()), "the log's first time");
        writer.entry("end", shown_seconds(log->time.back()), "the log's last time");
    } else {
        writer.remark(fmt::format("The run lasts as long as the log, from {} to {}.", shown_seconds(log->time.front()),
                                  shown_seconds(log->time.back())));
    }
    writer.entry("output", draft.mesh.setting("time", "output"),
                 "between the rows of channels.csv; \"0 s\" for every step of the solver");
    writer.suggestion("fields", "60 s");
}

}  // namespace tiretherm::input
