// SPDX-License-Identifier: BSD-3-Clause
// Keys of [effects], [[source]] and [[exchange]]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"
#include "physics/tire_laws/rolling_resistance.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> effect_tables() {
    return {
        {"effects", TableForm::table,
         "`[effects.NAME]` for each effect of the catalogue: [effects.md](effects.md) has their parameters, words and tables. An effect that is named is on. In a case with `[tire]` the thesis's effects are on unless switched off; in any other case only `conduction` is. Parameters that are not given keep their standard values.", {
            subtable("NAME", "One table for each effect that is switched on, off or changed."),
        }, true},
        {"effects.NAME", TableForm::table,
         "Beside the keys of the effect itself. Where parameters may differ from place to place, `<parameter>_by_patch`, `_by_layer`, `_by_zone` or `_by_channel` holds other values for some of them: `h_by_patch = { top = \"60 W/m2K\" }`. A table such as `profile` replaces a weight: `{ columns = [\"place [mm]\", \"weight\"], rows = [[-80, 0.8], [0, 1.1], [80, 0.8]] }`, against the arc length from the centre plane, negative outboard.", {
            flag("on", "Whether the effect acts. Default: true."),
            texts("patches", "Patches that it acts on. Default: those of the effect."),
            texts("layers", "Layers that it acts on. Default: all below the first."),
            texts("channels", "Sensors that a sensor model stands behind."),
            text("field", "File of a structural code that places the heat of friction, of the loss or of the contact ([formats](../cases/contact_fields/README.md)). Default: none."),
            choice("use", {"shape", "watts"}, "What of the field: its shape, with the total of the law, or its watts. Default: shape."),
            text("total", "File with a drum's table of the rolling resistance, which gives the total of the strain-energy loss. Default: none."),
            subtable("coastdown", "Coefficients of SAE J2452, which give the total of the strain-energy loss. Default: none."),
        }, true},
        {"effects.strain_energy_loss.coastdown", TableForm::table,
         "Rolling resistance by SAE J2452: F = p^alpha N^beta (a + b V + c V^2).", {
            quantity("alpha", {.unit = "1", .low = -5.0, .high = 5.0}, "Exponent of the pressure.").required().into<&physics::CoastdownLaw::pressure_exponent>(),
            quantity("beta", {.unit = "1", .low = -5.0, .high = 5.0}, "Exponent of the load.").required().into<&physics::CoastdownLaw::load_exponent>(),
            quantity("a", {.unit = "1", .low = 0.0, .high = 1e12}, "Constant coefficient.").required().into<&physics::CoastdownLaw::constant>(),
            quantity("b", {.unit = "1", .low = -1e12, .high = 1e12}, "Coefficient of the speed.").required().into<&physics::CoastdownLaw::linear>(),
            quantity("c", {.unit = "1", .low = -1e12, .high = 1e12}, "Coefficient of the speed squared.").required().into<&physics::CoastdownLaw::quadratic>(),
            text("pressure_unit", "Unit of p. Default: kPa."),
            text("load_unit", "Unit of N. Default: N."),
            text("speed_unit", "Unit of V. Default: km/h."),
            text("force_unit", "Unit of F. Default: N."),
        }},
        {"source", TableForm::list,
         "A heat source of the case's own: watts times a signal into a place. Formulas may use columns of the run's file, inputs, and `time` in seconds since the run's start, with `+ - * / ^`, comparisons, `&&`, `||`, `a > b ? c : d`, `abs`, `min`, `max`, `sqrt`, `exp`, `ln`, `log10`, `sin`, `cos`, `tan` and others of the library muParser, `_pi`, `_e`. Each signal counts in SI base units: 37 % is 0.37, 36 km/h is 10, 20 °C is 293.15. The formula is evaluated at the samples of its signals and is straight between them; over schedules and constants at as many points as it takes to be within 1e-4 of its largest value. A jump of a schedule takes a millisecond. A run that lacks a column of the formula is refused.", {
            name("name", "What budget, HDF5 and messages call it.").required(),
            text("follows", "Name of a column of the run's file, or a formula.").required(),
            texts("at", "Regions (`surface`, `bulk`, `gas`), layers, zones or patches, looked for in this order; one or a list. Cells share by heat capacity (at 60 °C), surfaces by area; a list has either cells or surfaces. All of it goes into the mesh: for a quarter of a specimen give a quarter of the watts.").required(),
            quantity("watts", {.unit = "W", .low = -1e9, .high = 1e9}, "Heat at a signal of 1; may be negative.").required(),
        }},
        {"exchange", TableForm::list,
         "A heat transfer of the case's own: conductance times a signal times (temperature - T) at a place. Names, formulas and places are as of `[[source]]`.", {
            name("name", "What budget, HDF5 and messages call it.").required(),
            text("follows", "Name of a column, or a formula; must not be negative. Default: 1."),
            texts("at", "As of `[[source]]`.").required(),
            quantity("conductance", {.unit = "W K-1", .low = 0.0, .high = 1e9}, "Conductance at a signal of 1.").required(),
            quantity_or_text("temperature", temperature, "A column, an input or a value such as `25 degC`. Default: `air_temperature`."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
