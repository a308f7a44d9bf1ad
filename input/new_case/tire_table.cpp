// SPDX-License-Identifier: BSD-3-Clause
// [tire] of a new case: dimensions from the size, laws of the load scaled from the thesis's 225/50 R17.
#include <cmath>

#include <fmt/format.h>

#include "input/new_case/case_tables.hpp"
#include "physics/tire_laws/scaled_tire.hpp"

namespace tiretherm::input {

namespace {

std::string in_mm(double metres, int digits) { return fmt::format("{:.{}f} mm", metres * 1e3, digits); }

/// A number to some digits, its exponent without a leading zero: -4.2e-6.
std::string short_number(double value, int digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    const std::size_t exponent = text.find("e-0");
    return exponent == std::string::npos ? text : text.erase(exponent + 2, 1);
}

/// Comments of the laws: those of the thesis's tire itself, or of one that is scaled from it.
struct Reasons {
    std::string_view radius, length_limit, length_slope, area, loaded, rolling, exponent;
};
constexpr Reasons thesis{"R0, thesis V",
                         "l = l_max - 2 l_max/(1 + exp(k Fz)), thesis (57)",
                         "k of (57)",
                         "S_cont = A + B Fz, thesis (35)",
                         "R_L = A + B Fz, thesis (37)",
                         "R_R = A (Fz/1 N)^B, thesis (62)",
                         "B of (62)"};
constexpr Reasons scaled{
    "without load; assumed: rim radius + H + 2.4 mm, the surplus of the thesis's tire",
    "l_max of the contact's length, thesis (57); assumed: 160 mm in proportion to the radius",
    "k of (57); assumed: 0.35 1/kN over the ratio of the vertical stiffnesses",
    "S_cont = A + B Fz, thesis (35); assumed: the thesis's mean contact pressure, in proportion to the inflation",
    "R_L = A + B Fz, thesis (37); assumed: -4.2e-6 m/N over the ratio of the vertical stiffnesses",
    "R_R = A (Fz/1 N)^B, thesis (62); assumed: 348.3 mm in proportion to the radius",
    "B of (62); as the thesis's tire: a belt hardly changes its length"};

void write_laws(CaseWriter& writer, const physics::Tire& tire, const Reasons& why) {
    writer.entry("contact_length_limit", in_mm(tire.contact_length_limit, 0), why.length_limit);
    writer.entry("contact_length_slope", fmt::format("{} 1/kN", short_number(tire.contact_length_slope, 3)),
                 why.length_slope);
    writer.entry("contact_area_at_zero", fmt::format("{} m2", short_number(tire.contact_area_at_zero, 4)), "A of (35)");
    writer.entry("contact_area_slope", fmt::format("{} m2/N", short_number(tire.contact_area_slope, 4)), why.area);
    writer.entry("loaded_radius_at_zero", in_mm(tire.loaded_radius_at_zero, 1), "A of (37): the unloaded radius");
    writer.entry("loaded_radius_slope", fmt::format("{} m/N", short_number(tire.loaded_radius_slope, 3)), why.loaded);
    writer.entry("rolling_radius_factor", in_mm(tire.rolling_radius_factor, 1), why.rolling);
    writer.entry("rolling_radius_exponent", short_number(tire.rolling_radius_exponent, 3), why.exponent);
}

std::string more_than_thesis(double metres) {
    return std::abs(metres) < 1e-9 ? ", as the thesis's tire"
                                   : fmt::format("; assumed: {:.0f} mm {} than a passenger tire's",
                                                 std::abs(metres) * 1e3, metres > 0.0 ? "more" : "less");
}

}  // namespace

void write_tire(CaseDraft& draft) {
    const TireSize& size = draft.request.size;
    const physics::TireOutline outline = draft.outline();
    const physics::Tire tire = physics::scaled_tire(outline);
    const physics::TireOutline base;
    const bool is_thesis = std::abs(size.radius() - 0.5 * base.rim_diameter - base.section_height) < 1e-9 &&
                           std::abs(size.width - base.width) < 1e-9 &&
                           draft.inflation_pressure == base.inflation_pressure;
    const double ratio = physics::vertical_stiffness(outline) / physics::vertical_stiffness(base);
    const physics::Tire base_tire;
    CaseWriter& writer = draft.writer;
    if (!size.assumption.empty()) {
        draft.assume("tire.size", size.text, size.assumption);
    }
    if (is_thesis) {
        writer.caption(
            "The tire of the thesis (V.5): replace what you have measured of yours. Each law of the load may also be a "
            "table: contact_length = { columns = [\"load [kN]\", \"length [mm]\"], rows = [[2, 60], [4, 97]] }");
    } else {
        writer.caption(fmt::format(
            "Only the size is known of the tire. Its laws of the load are those of the thesis's 225/50 R17, scaled at "
            "{:g} kPa with a vertical stiffness {:.3f} times as high (ratio of Rhyne's formula for belted radials, "
            "Tire Science and Technology 33(3), 2005). Replace what you have measured. Each law may also be a table: "
            "contact_length = {{ columns = [\"load [kN]\", \"length [mm]\"], rows = [[2, 60], [4, 97]] }}",
            draft.inflation_pressure * 1e-3, ratio));
        draft.assume("tire", "laws of the load",
                     fmt::format("scaled from the thesis's 225/50 R17 at {:g} kPa{}{}", draft.inflation_pressure * 1e-3,
                                 draft.pressure_ground.empty() ? "" : ", ", draft.pressure_ground));
    }
    writer.table("tire");
    writer.entry(
        "size", size.text,
        fmt::format("W = {:.5g} mm, H = {:.5g} mm, rim {:g} in{}{}", size.width * 1e3, size.section_height * 1e3,
                    size.rim_diameter / 0.0254, size.assumption.empty() ? "" : "; assumed: ", size.assumption));
    const Reasons& why = is_thesis ? thesis : scaled;
    writer.entry("unloaded_radius", in_mm(tire.unloaded_radius, 1), why.radius);
    writer.entry("tread_thickness", in_mm(draft.tread_thickness, 0),
                 "through crown and tread" + more_than_thesis(draft.tread_thickness - base_tire.tread_thickness));
    writer.entry("sidewall_thickness", in_mm(draft.sidewall_thickness, 0),
                 "of the sidewall" + more_than_thesis(draft.sidewall_thickness - base_tire.sidewall_thickness));
    write_laws(writer, tire, why);
    writer.entry("reference_pressure", fmt::format("{:g} kPa", draft.inflation_pressure * 1e-3),
                 fmt::format("{}{}at which these laws hold; they follow drive.inflation_pressure where it is given",
                             draft.pressure_ground, draft.pressure_ground.empty() ? "" : "; "));
    if (draft.mesh.name == "section") {  // the case has drum_curvature, which counts from there
        writer.entry("loss_drum_diameter", "1.707 m",
                     "of the drum on which the loss was measured; assumed: the thesis's was that of ISO 28580");
    }
}

}  // namespace tiretherm::input
