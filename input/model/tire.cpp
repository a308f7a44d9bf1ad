// SPDX-License-Identifier: BSD-3-Clause
// Reads [tire]: size designation such as 225/50 R17, dimensions, laws of the load, moduli of the cornering stiffness
// and the .tir property file.

#include <array>
#include <cmath>

#include "input/model/law.hpp"
#include "input/model/tire.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "input/tire_property_file/tir_file.hpp"
#include "input/tire_property_file/tire_size.hpp"
#include "physics/tire_laws/scaled_tire.hpp"

namespace tiretherm::input {

namespace {

using physics::Tire;

/// A law of the load: its table, and the numbers that describe it otherwise.
struct Law {
    std::string_view table;
    std::optional<physics::Curve> Tire::*member;
    QuantitySpec value;
    std::string_view number;  ///< a key of [tire]
};

constexpr QuantitySpec radius{.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0};
const std::array laws{
    Law{"contact_length", &Tire::contact_length_table, {.unit = "m", .low = 0.0, .high = 5.0}, "contact_length_limit"},
    Law{"contact_area", &Tire::contact_area_table, {.unit = "m2", .low = 0.0, .high = 5.0}, "contact_area_slope"},
    Law{"loaded_radius", &Tire::loaded_radius_table, radius, "loaded_radius_slope"},
    Law{"rolling_radius", &Tire::rolling_radius_table, radius, "rolling_radius_factor"},
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

/// The moduli of the cornering stiffness: [tire.modulus].
void read_modulus(TomlTable& tire, solver::Handling& into) {
    TomlTable table = tire.subtable("modulus");
    physics::EquivalentModulus& m = into.modulus;
    table.read_into(m);
    table.read_into(into);
    if (m.dE >= m.E_max) {
        table.add_error("belt_fall", "the belt's modulus would fall to nothing", "let it be smaller than belt_maximum");
    }
    if (m.dE_T >= 2.0 * m.E_mid) {
        table.add_error("tread_fall", "the tread's modulus would fall to nothing",
                        "let it be smaller than twice tread_middle");
    }
}

/// The Magic Formula's coefficients: property_file, beside the file that names it.
void read_property_file(TomlTable& tire, solver::Handling& into) {
    if (const std::optional<std::string> path = tire.text("property_file")) {
        const SourceLocation mentioned = tire.place("property_file");
        if (const auto file = read_tir_file(tire.errors().beside(mentioned, *path), mentioned, tire.errors())) {
            into.magic_formula = file->law_on_the_right();
            if (file->is_left) {
                tire.errors().warn(mentioned,
                                   "TYRESIDE of the property file is LEFT: its mirror image counts, as the inputs are "
                                   "those of a tire on the right");
            }
        }
    }
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
    read_modulus(tire, read.handling);
    read_property_file(tire, read.handling);
    std::vector<std::string> borrowed;
    for (const Law& law : laws) {
        into.*law.member = read_curve(tire, law.table, quantity_specs::load, law.value);
        if (!tire.has(law.table) && !tire.has(law.number)) {
            borrowed.emplace_back(law.table);
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
