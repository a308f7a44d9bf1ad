// SPDX-License-Identifier: BSD-3-Clause
// Reads [tire]: size designation such as 225/50 R17, dimensions and laws of the load.

#include <array>
#include <cmath>

#include "input/model/handling.hpp"
#include "input/model/law.hpp"
#include "input/model/tire.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "input/tire_property_file/tire_size.hpp"
#include "physics/tire_laws/scaled_tire.hpp"

namespace tiretherm::input {

namespace {

using physics::Tire;

using physics::MeasuredLaws;

constexpr QuantitySpec radius{.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0};
const std::array laws{
    LoadLaw{"contact_length",
            &Tire::contact_length_table,
            &MeasuredLaws::contact_length,
            {.unit = "m", .low = 0.0, .high = 5.0},
            "contact_length_limit"},
    LoadLaw{"contact_area",
            &Tire::contact_area_table,
            &MeasuredLaws::contact_area,
            {.unit = "m2", .low = 0.0, .high = 5.0},
            "contact_area_slope"},
    LoadLaw{"loaded_radius", &Tire::loaded_radius_table, &MeasuredLaws::loaded_radius, radius, "loaded_radius_slope"},
    LoadLaw{"rolling_radius", &Tire::rolling_radius_table, &MeasuredLaws::rolling_radius, radius,
            "rolling_radius_factor"},
};

void read_size(TomlTable& tire, Tire& into) {
    const std::optional<std::string> text = tire.text("size");
    if (!text) {
        return;
    }
    const std::variant<TireSize, ErrorText> read = read_tire_size(*text);
    if (const auto* error = std::get_if<ErrorText>(&read)) {
        tire.add_error("size", error->what, error->remedy);
        return;
    }
    const TireSize& size = std::get<TireSize>(read);
    into.name = size.text;
    into.width = size.width;
    into.section_height = size.section_height;
    into.unloaded_radius = size.radius();
}

void check(const TomlTable& tire, const Tire& read, double nominal_radius) {
    if (read.tread_thickness >= read.section_height) {
        tire.add_error("tread_thickness", "the tread is thicker than the section is high");
    }
    if (2.0 * read.sidewall_thickness >= read.width) {
        tire.add_error("sidewall_thickness", "two sidewalls are thicker than the tire is wide");
    }
    if (!read.loaded_radius_table && read.loaded_radius_at_zero > read.unloaded_radius * (1.0 + 1e-9)) {
        tire.add_error("loaded_radius_at_zero", "the loaded radius at zero load is larger than the unloaded radius");
    }
    if (std::abs(read.unloaded_radius / nominal_radius - 1.0) > 0.05) {
        tire.errors().warn(tire.place("unloaded_radius"), "unloaded_radius is {:.1f} mm, but a {} has about {:.1f} mm",
                           read.unloaded_radius * 1e3, read.name, nominal_radius * 1e3);
    }
}

}  // namespace

std::span<const LoadLaw> load_laws() { return laws; }

TireTable read_tire(TomlTable& root) {
    TomlTable tire = root.subtable("tire");
    TireTable read{.given = tire.exists(), .has_density = tire.has("density")};
    if (!read.given) {
        return read;
    }
    Tire& into = read.tire;
    const std::size_t before = tire.errors().count();
    read_size(tire, into);
    const double nominal_radius = into.unloaded_radius;
    tire.read_into(into);
    into.reference_pressure = tire.quantity("reference_pressure").value_or(physics::TireOutline{}.inflation_pressure);
    // Behind the size and its radius, from which it follows.
    if (!tire.has("loaded_radius_at_zero")) {
        into.loaded_radius_at_zero = into.unloaded_radius;
    }
    read.handling = read_handling(tire);
    std::vector<std::string> borrowed;
    for (const LoadLaw& law : laws) {
        into.*law.member = read_curve(tire, law.name, quantity_specs::load, law.value);
        if (!tire.has(law.name) && !tire.has(law.number)) {
            borrowed.emplace_back(law.name);
        }
    }
    if (tire.errors().count() > before) {
        return read;
    }
    check(tire, into, nominal_radius);
    const bool thesis_size = into.name.starts_with("225/50 R17") || into.name.starts_with("225/50R17");
    if (!thesis_size && !borrowed.empty()) {
        tire.errors().warn(tire.place(), "{} of the {} taken from the thesis's 225/50 R17: give {}", listed(borrowed),
                           into.name + (borrowed.size() > 1 ? " are" : " is"),
                           borrowed.size() > 1 ? "its own laws" : "its own law");
    }
    return read;
}

}  // namespace tiretherm::input
