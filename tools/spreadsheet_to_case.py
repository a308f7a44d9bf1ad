#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a case of the two-node model from the spreadsheet of ten sheets of a PhD thesis, and says what became of each parameter.

The sheets and the place of each of their parameters: cases/convert/README.md. What a case needs and the sheets do not say is
assumed and listed, on the terminal and at the top of the case. The case is read by `tiretherm check` before it is written;
mistakes are listed all at once, at their cells.
"""

import argparse
import csv
import difflib
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections import namedtuple
from pathlib import Path

THESIS = "the thesis's 225/50 R17"
MODULUS = "not printed in the thesis: assumed for its tire, physics/cornering_stiffness.hpp"
# Of each sheet: name; other names | use | key of the case | unit; units that the thesis prints for it | value where the sheet is
# silent | reason of that value | law that it is a part of. A use is a text; a number; `on`: ON or OFF as true or false; a `word`:
# ON or OFF as "on" or "off"; a `sensor` of the case; `rate`: 1/K, which the case gives as the width of a transition; a
# `coefficient` of a law of temperature; the `scale` on which that law counts; `computed` by the program; `none`: no use.
PARAMETERS = f"""
INFO
Tyre Name; Tire Name; Name | text | title | | | the case is called like its file
Size; Tyre Size; Tire Size | text | tire.size
Initial Tyre Surface Temperature; Surface Initial Temperature; Initial Surface Temperature | number | initial.surface | degC | "air_temperature" | the tire starts as warm as the air
Initial Tyre Bulk Temperature; Bulk Initial Temperature; Initial Bulk Temperature | number | initial.bulk | degC | "air_temperature" | the tire starts as warm as the air
Air Temperature | number | drive.air_temperature | degC | "23 degC" | as the thesis's picture of the sheet shows
Track Temperature; Road Temperature | number | drive.road_temperature | degC | "23 degC" | as the thesis's picture of the sheet shows
Min Fz for no contact condition; Lowest value of Fz below that SEL and friction is zero; Minimum Fz; Min Fz | number | tire.minimum_load | N | "0 N" | as the thesis's picture of the sheet shows
PARA
Unloaded Radius | number | tire.unloaded_radius | m | | half the rim and the section height, of the size
Tread Thickness; Cross-section height; Tire cross-section thickness | number | tire.tread_thickness | mm | "12 mm" | {THESIS}
Sidewall Thickness | number | tire.sidewall_thickness | mm | "9 mm" | {THESIS}
Tire Surface Mass percentage; Tyre Surface Mass percentage; Surface Mass percentage | number | mesh.surface_mass_share | % | "15 %" | {THESIS}
Bulk Measure Point Depth; Carcass Measure Depth | number | mesh.bulk_depth | mm | "10 mm" | {THESIS}
Natural convection coeff.; Natural convection coefficient | number | effects.air_convection.floor | W/m2K | "30 W/m2K" | {THESIS}
Hc; Track-Tire Exchange coefficient; Track-tire heat exchange coefficient | number | effects.road_contact.Hc | W/m2K | "500 W/m2K" | {THESIS}
Tire Rubber Density; Tyre Rubber Density; Rubber Density | number | material.density | kg/m3 | "1100 kg/m3" | {THESIS}
Air Thermal Conductivity | number | effects.air_convection.air_conductivity | W/mK | "0.025 W/mK" | {THESIS}
Air kinematic viscosity | number | effects.air_convection.air_viscosity | m2/s | "1.5e-5 m2/s" | {THESIS}
Heat Partition coefficient | number | effects.sliding_friction.partition | 1 | 0.6 | {THESIS}
Tire Width; Tyre Width | number | tire.width | mm
Sidewall Height | number | tire.section_height | mm
Surface Mass | computed | | kg
Bulk Mass | computed | | kg
Area Ratio | computed | | 1
Characteristic Length | computed | | m
External Total Area | computed | | m2
SF
Scaling Factor Friction Long; lambda_x | number | effects.sliding_friction.lambda_x | 1 | 1 | not scaled
Scaling Factor Friction Lat; lambda_y | number | effects.sliding_friction.lambda_y | 1 | 1 | not scaled
Scaling Factor Air-Tire Therm. Exch.; lambda_h; Scaling Factor Air-Tire | number | effects.air_convection.lambda_h | 1 | 1 | not scaled
Scaling Factor Track-Tire Therm. Exch.; lambda_Hc; Scaling Factor Track-Tire | number | effects.road_contact.lambda_Hc | 1 | 1 | not scaled
Scaling Factor Cornering Stiffness; lambda_CP | number | tire.modulus.lambda_CP | 1 | 1 | not scaled
Scaling Factor SEL surface; lambda_SELsrf | number | effects.strain_energy_loss.lambda_srf | 1 | 1 | not scaled
Scaling Factor SEL bulk; lambda_SELblk | number | effects.strain_energy_loss.lambda_blk | 1 | 1 | not scaled
SEL
Reference Frequency; Reference compound frequency; Compound reference frequency | number | effects.strain_energy_loss.f0 | Hz | "52 Hz" | {THESIS}
Tand peak Temperature; Glassy transition temperature | number | tire.modulus.transition_temperature | degC | "-8 degC" | {THESIS}
Glassy-Rubbery transition range; Glassy-rubbery state transition temperature range | number | tire.modulus.transition_width | K; degC | "300 K" | {MODULUS}
Tand Maximum; Tand max | none | | 1 | | not used: the loss tangent is the Gaussian (49) of a1, b1 and c1
C1; WLF C1 Coefficient | number | effects.strain_energy_loss.C1 | 1 | -8.86 | {THESIS}
C2; WLF C2 Coefficient | number | effects.strain_energy_loss.C2 | K; - | "101.6 K" | {THESIS}
Tand Parameter a1; Tand Parameter a | number | effects.strain_energy_loss.tan_delta_a | 1 | 2.14e15 | {THESIS}
Tand Parameter b1; Tand Parameter b | number | effects.strain_energy_loss.tan_delta_b | K; - | "-4989 K" | {THESIS}
Tand Parameter c1; Tand Parameter c | number | effects.strain_energy_loss.tan_delta_c | K; - | "882 K" | {THESIS}
THRCOND
Thermal Conductivity coeff. A; Coeff A; A | coefficient | material.conductivity | W/mK/K2; -; W/mK3; W/mK^3 | | | conductivity
Thermal Conductivity coeff. B; Coeff B; B | coefficient | material.conductivity | W/mK/K; -; W/mK2; W/mK^2 | | | conductivity
Thermal Conductivity coeff. C; Coeff C; C | coefficient | material.conductivity | W/mK; - | | | conductivity
Temperature scale; Temperature unit | scale | material.conductivity | | | | conductivity
SPEHEAT
Specific heat coeff. A; Coeff A; A | coefficient | material.heat_capacity | J/kgK/K2; -; J/kgK3; J/kgK^3 | | | heat_capacity
Specific heat coeff. B; Coeff B; B | coefficient | material.heat_capacity | J/kgK/K; -; J/kgK2; J/kgK^2 | | | heat_capacity
Specific heat coeff. C; Coeff C; C | coefficient | material.heat_capacity | J/kgK; - | | | heat_capacity
Temperature scale; Temperature unit | scale | material.heat_capacity | | | | heat_capacity
ContactPatch
Contact Length max length; max length; Contact Length maximum | number | tire.contact_length_limit | mm | "160 mm" | {THESIS} | contact_length
Contact Length length curve slope; length curve slope; Contact Length curve slope; Contact Length slope | number | tire.contact_length_slope | 1/kN; - | "0.35 1/kN" | {THESIS} | contact_length
Contact Patch Coeff A; Contact Area Coeff A | number | tire.contact_area_slope | mm2/N | "2.333 mm2/N" | {THESIS} | contact_area
Contact Patch Coeff B; Contact Area Coeff B | number | tire.contact_area_at_zero | mm2 | "0 mm2" | {THESIS} | contact_area
LateralStiffness
CP computation; Cornering stiffness computation; CP | sensor | sensor.cornering_stiffness.kind | | "cornering_stiffness" | ON: a sensor cornering_stiffness
Maximum modulus; Modulus maximum; Eeq max | number | tire.modulus.belt_maximum | MPa | "330 MPa" | {MODULUS} | cornering_stiffness
Modulus delta due to contact length; Delta modulus contact length | number | tire.modulus.belt_fall | MPa | "310 MPa" | {MODULUS} | cornering_stiffness
Modulus slope due to contact length; Slope Eeq=f(Fz) | number | tire.modulus.belt_slope | 1/m; - | "-54 1/m" | {MODULUS} | cornering_stiffness
Contact length threshold; Modulus threshold contact length; l_trsh | number | tire.modulus.belt_threshold | mm | "50 mm" | {MODULUS} | cornering_stiffness
Modulus delta due to bulk temperature; Delta modulus temperature | number | tire.modulus.tread_fall | MPa | "1130 MPa" | {MODULUS} | cornering_stiffness
Modulus at the transition; Modulus mean temperature | number | tire.modulus.tread_middle | MPa | "603 MPa" | {MODULUS} | cornering_stiffness
Modulus slope due to bulk temperature; Slope Eeq=f(Tb) | rate | tire.modulus.transition_width | 1/K | | | cornering_stiffness
Horizontal shift due to bulk temperature; Horizontal shift Eeq=f(Tb); Horizontal shift | number | tire.modulus.transition_temperature | degC | | | cornering_stiffness
Radius
Loaded Radius Coeff A | number | tire.loaded_radius_slope | m/N | "-4.2e-6 m/N" | {THESIS} | loaded_radius
Loaded Radius Coeff B | number | tire.loaded_radius_at_zero | m | | the unloaded radius | loaded_radius
Rolling Radius Coeff A | number | tire.rolling_radius_factor | m | "0.3483 m" | {THESIS} | rolling_radius
Rolling Radius Coeff B | number | tire.rolling_radius_exponent | 1; 1/N | -0.009 | {THESIS} | rolling_radius
SWITCH
Switch on/off Global Friction Power; Global Friction Power; Friction Power | on | effects.sliding_friction.on | | true | the model is whole
Switch on/off Longitudinal Friction Power; Longitudinal Friction Power | word | effects.sliding_friction.longitudinal | | "on" | the model is whole
Switch on/off Lateral Friction Power; Lateral Friction Power | word | effects.sliding_friction.lateral | | "on" | the model is whole
Switch on/off Air-Tire Exchange; Air-Tire Exchange | on | effects.air_convection.on | | true | the model is whole
Switch on/off Track-Tire Exchange; Track-Tire Exchange | on | effects.road_contact.on | | true | the model is whole
Switch on/off Strain Energy generation; Strain Energy generation; SEL generation | on | effects.strain_energy_loss.on | | true | the model is whole
Switch on/off Surface-Bulk conduction; Surface-Bulk conduction | on | effects.conduction.on | | true | the model is whole
"""
# A number that a second law of the case has as well, whatever takes its place in the first.
ALSO = {"Tand peak Temperature": "effects.strain_energy_loss.tan_delta_peak"}
LOAD = "Vertical Load; Fz; Load; Vertical Load vector for "
TEMPERATURE = "Temperature; T; Bulk Temperature; Temperature Vector for lateral stiffness"
# Measured tables: sheet | first column | unit | other column | unit | key, whose last part is the law that it can stand for
TABLES = f"""
THRCOND | {TEMPERATURE} | degC | Thermal Conductivity; k; Conductivity | W/mK | material.conductivity
SPEHEAT | {TEMPERATURE} | degC | Specific heat; c; cv; Specific heat capacity | J/kgK | material.heat_capacity
ContactPatch | {LOAD}contact length; {LOAD}contact patch | N | Contact Length; Contact Length vector; Length; Equivalent contact patch length | mm | tire.contact_length
ContactPatch | {LOAD}contact length; {LOAD}contact patch | N | Contact Patch; Contact Patch vector; Contact Area; Area; Contact patch area | mm2 | tire.contact_area
LateralStiffness | {LOAD}Lateral Stiffness | N | Lateral Stiffness; Tire Lateral stiffness; Cornering Stiffness; CP | N/rad | tire.cornering_stiffness
Radius | {LOAD}Loaded Radius; {LOAD}Rolling Radius | N | Loaded Radius; Loaded Radius Vector; RL | m | tire.loaded_radius
Radius | {LOAD}Loaded Radius; {LOAD}Rolling Radius | N | Rolling Radius; Rolling Radius Vector; RR | m | tire.rolling_radius
"""
LABELS = {"ContactPatch": ("Contact Length", "Contact Patch"), "Radius": ("Loaded Radius", "Rolling Radius")}
HEADINGS = ("Value", "Values", "Unit", "Units", "Parameter", "Parameters", "Note", "Notes", "Remark", "Remarks", "Comment")
# What a case needs and the sheets have no place for: key | value | reason
FIXED = """
drive.vertical_load | "4000 N" | the sheets hold no load: that of the thesis's first warm-up
drive.speed | "100 km/h" | the sheets hold no speed: that of the thesis's first warm-up
time.end | "3600 s" | the sheets hold no duration: until the bulk has settled
time.output | "10 s" | the sheets hold no interval
sensor.surface_temperature.region | "surface" | the sheets hold no sensors
sensor.bulk_temperature.region | "bulk" | the sheets hold no sensors
drive | | the sheets hold no slip, forces or camber: free rolling, so that sliding makes no heat
"""
SOURCE = ("Essentiality of Temperature Management while Modeling and Analyzing Tires Contact Forces, PhD thesis, University of "
          "Naples Federico II, 2014: equations (31)-(71)")
HEADS = {  # the tables of the case in their order, and what stands at their heads
    "": "", "tire": "[tire]", "tire.modulus": "[tire.modulus]  # behind the cornering stiffness",
    "tire.measured": "[tire.measured]  # to stand beside the laws",
    "mesh": '[mesh]\nkind = "two_node"\nmaterial = "rubber"', "material": '[[material]]\nname = "rubber"',
    "effects.strain_energy_loss": "[effects.strain_energy_loss]", "effects.sliding_friction": "[effects.sliding_friction]",
    "effects.air_convection": '[effects.air_convection]\nexponential = "on"                  # thesis (33) as printed',
    "effects.road_contact": "[effects.road_contact]", "effects.conduction": "[effects.conduction]", "drive": "[drive]",
    "initial": "[initial]", "time": "[time]",
    **{f"sensor.{node}": f'[[sensor]]\nname = "{node}"\nkind = "region"' for node in ("surface_temperature", "bulk_temperature")},
    "sensor.cornering_stiffness": '[[sensor]]\nname = "cornering_stiffness"'}
STANDARD_LAWS = {
    "heat_capacity": ('"1800 J/kgK"', "the thesis's constant, V.1.2"),
    "conductivity": ('{ at = "20 degC", value = "0.29 W/mK", slope = "0.00943 W/mK/K", range = ["20 degC", "120 degC"] }',
                     "not printed in the thesis: the line through its 0.29 W/mK at 20 degC and 0.95 W/mK at 90 degC")}
ZERO = 273.15  # 0 degC in kelvin
NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
Parameter = namedtuple("Parameter", "sheet names use key units standard reason law")
Table = namedtuple("Table", "sheet variables variable_unit values value_unit key")
Value = namedtuple("Value", "text number unit name cell sound")
Measured = namedtuple("Measured", "table names units rows cells")  # names, units and rows: of the variables and the value
Entry = namedtuple("Entry", "key lines remark name cells unit")  # cells: of each line, or None


def fields_of(table):
    return [[field.strip() for field in line.split("|")] for line in table.strip().splitlines()]


def parameters():
    sheet = ""
    for fields in fields_of(PARAMETERS):
        if len(fields) == 1:
            sheet = fields[0]
        else:
            names, use, key, units, standard, reason, law = fields + [""] * (7 - len(fields))
            yield Parameter(sheet, tuple(names.split("; ")), use, key, tuple(units.split("; ")), standard, reason, law)


def called(text, *names):
    """Whether a cell's text is one of the names: capitals, blanks and punctuation do not count."""
    plain = [re.sub("[^0-9a-z\u0080-\U0010ffff]+", " ", name.lower()).strip() for name in (text, *names)]
    return plain[0] != "" and plain[0] in plain[1:]


def listed(names):
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def printable(text):
    return "".join(c if c.isprintable() else " " for c in text)


def number_text(number):
    return repr(float(number)).removesuffix(".0")


def quoted(text):
    return json.dumps(text, ensure_ascii=False)


def quantity(number, unit):
    return number_text(number) if unit in ("1", "") else quoted(f"{number_text(number)} {unit}")


def plain_unit(written):
    """A unit as a case writes it: without brackets and raised digits, "W/m 2 K" without blanks."""
    unit = re.sub(r"^\[(.*)\]$", r"\1", written.strip()).strip().replace("Kg", "kg").replace("\u00a0", " ")
    unit = re.sub("[\u00b0\u00ba]C|\u2103", "degC", unit).translate(str.maketrans("\u00b2\u00b3", "23"))
    head, slash, tail = unit.partition("/")
    return head + slash + tail.replace(" ", "") if slash else unit


class Refused(Exception):
    """The spreadsheet cannot be read: sentence and remedy."""


def needed(module):
    try:
        return __import__(module)
    except ImportError:
        raise Refused(f"Python's module {module}, which reads such a workbook, is missing",
                      f"apt-get install python3-{module}") from None


def cell_text(value):
    if isinstance(value, (bool, type(None))):
        return str(value or "").upper() or ("FALSE" if value is False else "")
    return number_text(value) if isinstance(value, (int, float)) else str(value).strip()


def xlsx_sheets(path):
    openpyxl = needed("openpyxl")
    warnings.simplefilter("ignore")  # of styles
    computed, written = openpyxl.load_workbook(path, data_only=True), openpyxl.load_workbook(path)
    for sheet in computed.worksheets:  # a formula that was never computed has no value, and shows itself
        rows = sheet.iter_rows(max_row=min(sheet.max_row, 10000), max_col=min(sheet.max_column, 256))
        formulas = written[sheet.title]
        yield sheet.title, [[cell_text(formulas[c.coordinate].value if c.value is None else c.value) for c in row] for row in rows]


def xls_sheets(path):
    xlrd = needed("xlrd")
    with open(os.devnull, "w") as log, xlrd.open_workbook(path, logfile=log, ragged_rows=True) as book:
        special = {xlrd.XL_CELL_BOOLEAN: lambda value: bool(value), xlrd.XL_CELL_ERROR: xlrd.error_text_from_code.get}
        for sheet in book.sheets():
            rows = [sheet.row(r) for r in range(sheet.nrows)]
            yield sheet.name, [[cell_text(special.get(cell.ctype, lambda value: value)(cell.value)) for cell in row] for row in rows]


def csv_sheets(folder):
    for file in sorted(file for file in folder.iterdir() if file.suffix.lower() == ".csv" and file.is_file()):
        content = file.read_bytes()
        try:
            lines = content.decode("utf-8-sig").splitlines()
        except UnicodeDecodeError:
            lines = content.decode("cp1252", "replace").splitlines()
        separator = max("\t;,", key=lambda sign: sum(sign in line for line in lines))  # a note may hold any of them
        yield file.stem, [[cell.strip() for cell in row] for row in csv.reader(lines, delimiter=separator)]


def read_sheets(path):
    """The sheets as names and rows of texts. What kind of file it is, its content says."""
    kinds = "give an .xls or .xlsx workbook, or a folder with INFO.csv, PARA.csv and so on"
    try:
        if path.is_dir():
            return list(csv_sheets(path))
        if path.exists() and not path.is_file():
            raise Refused(f"{path}: it is no regular file", kinds)
        with open(path, "rb") as file:
            head = file.read(4)
        reader = xlsx_sheets if head.startswith(b"PK") else xls_sheets if head == b"\xd0\xcf\x11\xe0" else None
        if reader is None:
            raise Refused(f"{path}: the file is {'no workbook' if head else 'empty'}", kinds)
        return list(reader(path))
    except Refused:
        raise
    except OSError as error:
        raise Refused(f"{path}: it cannot be read: {error.strerror or error}", kinds) from None
    except Exception as error:  # the libraries raise errors of any kind where a workbook is damaged or has a password
        reason = printable(str(error)) or type(error).__name__
        raise Refused(f"{path}: the workbook is damaged or has a password ({reason})", "save it anew, as .xlsx, without one") from None


class Cell(str):
    """The text of a cell, which knows where it stands."""

    def __new__(cls, text, place, order):
        cell = super().__new__(cls, text)
        cell.place, cell.order = place, order
        return cell


def cells_of(rows, sheet, title):
    """The rows as cells, each with some empty ones at its end: a value and its unit may be asked for anywhere."""
    width = max(map(len, rows), default=0) + 3
    letters = [chr(ord("A") + c) if c < 26 else chr(ord("A") + c // 26 - 1) + chr(ord("A") + c % 26) for c in range(min(width, 702))]
    return [[Cell(text, f"{title}!{letters[min(c, 701)]}{r + 1}", (sheet, r, c))
             for c, text in enumerate(row + [""] * (width - len(row)))] for r, row in enumerate(rows)]


class Sheets:
    """What the sheets say, and what is wrong with them."""

    def __init__(self, path):
        self.path, self.errors, self.warnings, self.values, self.measured = path, [], [], {}, []
        self.parameters, self.tables = list(parameters()), [Table(*fields) for fields in fields_of(TABLES)]
        names, sheets = list(dict.fromkeys(p.sheet for p in self.parameters)), read_sheets(path)
        self.known = [next((name for name in names if called(title, name)), None) for title, _ in sheets]
        for s, ((title, rows), name) in enumerate(zip(sheets, self.known)):
            if name:
                self.scan(name, cells_of(rows, s, title))
        self.check_names(names, [title for (title, _), name in zip(sheets, self.known) if not name])

    def wrong(self, cell, what, remedy=""):
        """@param cell None: the spreadsheet as a whole"""
        place = f"{self.path}, {cell.place}" if cell is not None else str(self.path)
        self.errors.append((cell.order if cell is not None else (math.inf,), place, what, remedy))

    def check_names(self, names, strange):
        if not any(self.known):
            self.wrong(None, f"none of the ten sheets is there; there is {listed(strange) or 'nothing'}",
                       f"the sheets are {listed(names)} (of a folder: INFO.csv ...), see cases/convert/README.md")
            return
        for name in names:
            count, near = self.known.count(name), difflib.get_close_matches(name, strange, 1)
            if count > 1:
                self.wrong(None, f"there are {count} sheets {name}", "keep one of them")
            elif count == 0:
                self.wrong(None, f"there is no sheet {name}", f"rename {near[0]}?" if near else
                           f"add it; one with a title alone takes all defaults of {name}")
        self.warnings += [f"the sheet {title} is none of the ten and is not read" for title in strange]
        if not any(p.key == "tire.size" for p in self.values):
            self.wrong(None, "the sheet INFO has no Size", "add a row: Size, 225/50 R17")

    def scan(self, sheet, rows):
        """Rows of `name, value, unit, note` or two such groups side by side, and measured tables."""
        labels, r = {}, 0
        while r < len(rows):
            filled = [cell for cell in rows[r] if cell]
            is_read = filled and not filled[0].startswith("#") and not all(called(cell, *HEADINGS) for cell in filled)
            taken = self.scan_tables(sheet, rows[r:], filled) if is_read else 1
            if not taken:
                self.scan_row(sheet, rows[r], labels)
            r += taken or 1

    def scan_row(self, sheet, row, labels):
        def find(text):
            return next((p for p in self.parameters if p.sheet == sheet and called(text, *p.names)), None)

        c, first = 0, True
        while c < len(row) - 2:
            label = labels.get(c - 1, "")
            parameter = find(f"{label} {row[c]}") or find(row[c]) if row[c] else None
            if called(row[c], *LABELS.get(sheet, ())):
                labels[c] = row[c]  # holds for the rows below it, too
            elif parameter:
                self.take(parameter, *row[c:c + 3])
                first, c = False, c + 2
            elif row[c] and first:  # behind a parameter there may stand a note
                self.unknown(sheet, row[c], f"{label} {row[c]}".strip(), row[c + 1:])
                return
            c += 1

    def unknown(self, sheet, cell, text, behind):
        if NUMBER.fullmatch(cell):
            self.wrong(cell, f"{cell} stands in the place of a parameter's name", "begin a remark with #")
        elif any(other and not called(other, *HEADINGS) for other in behind):  # alone it is a title
            home = next((p.sheet for p in self.parameters if called(cell, *p.names)), None)
            near = difflib.get_close_matches(text, [p.names[0] for p in self.parameters if p.sheet == sheet], 1)
            self.wrong(cell, f'{sheet} has no parameter "{text}"', f"it belongs into the sheet {home}" if home else
                       f"did you mean `{near[0]}`?" if near else "see cases/convert/README.md, or begin a remark with #")

    def take(self, parameter, name, cell, unit_cell):
        """A parameter with its value and unit; without a value it is not there."""
        title, text, number, unit, sound = parameter.names[0], cell, None, plain_unit(unit_cell), True
        if not cell:
            return
        if parameter in self.values:
            alias = "" if called(name, title) else f', here as "{name}"'
            self.wrong(name, f"{title} stands twice{alias}, first at {self.values[parameter].name.place}", "remove one of them")
            return
        if parameter.use in ("on", "word", "sensor", "scale"):
            choices = {"degC": ("degC", "C", "Celsius"), "K": ("K", "kelvin")} if parameter.use == "scale" else {
                "ON": ("on", "1", "true", "yes"), "OFF": ("off", "0", "false", "no")}
            text = next((word for word, names in choices.items() if called(plain_unit(cell), *names)), None)
            sound = text is not None
            if not sound:
                self.wrong(cell, f'{title} is "{cell}"', f"write {' or '.join(choices)}")
        elif parameter.use != "text":
            number, unit = self.number(title, cell, unit)
            sound = number is not None
            if unit in parameter.units or parameter.units[0] == "1" and unit in ("", "-"):
                unit = parameter.units[0]
        self.values[parameter] = Value(text, number, unit, name, cell, sound)

    def number(self, name, cell, unit):
        """A number and its unit, which it may bring itself where the unit has no cell of its own ("")."""
        found = NUMBER.match(cell)
        rest = cell[found.end():].strip() if found else cell
        if found and math.isfinite(float(found[0])) and (not rest or unit == "" and rest[0] != ","):
            return float(found[0]), plain_unit(rest) or unit
        comma = found and rest.startswith(",")
        self.wrong(cell, f'{name} is "{cell}"' + (", with a comma in the number" if comma else "; a number is wanted"),
                   "write a decimal point" if comma else "open and save the workbook, which computes it" if cell[0] == "=" else "")
        return None, unit

    def scan_tables(self, sheet, rows, filled):
        """The measured tables under a row of headings. Returns how many rows they take, 0 where the row is no such heading."""
        heads = {cell: re.fullmatch(r"(.*?)\s*(\[.*\])?", cell).groups("") for cell in filled}
        variable, unit = heads[filled[0]]
        tables = [t for t in self.tables if t.sheet == sheet and unit and len(filled) > 1 and called(variable, *t.variables.split("; "))]
        if not tables:
            return 0
        known = [*TEMPERATURE.split("; "), *(title for t in tables for title in t.values.split("; "))]
        for cell in filled[1:]:
            if not called(heads[cell][0], *known):
                self.wrong(cell, f'{sheet} has no column "{heads[cell][0]}"',
                           f"its columns are {listed([t.values.split('; ')[0] for t in tables])}")
        columns = [cell.order[2] for cell in filled]
        end = next((r for r in range(1, len(rows)) if not any(rows[r][c] for c in columns)), len(rows))
        for table in tables if end > 1 else ():
            head = next((cell for cell in filled if called(heads[cell][0], *table.values.split("; "))), None)
            if head is not None and any(m.table == table for m in self.measured):
                self.wrong(head, f"a second column {heads[head][0]}", "keep one of them")
            elif head is not None:
                # The stiffness has two variables; of other tables a temperature is the first column or nothing.
                second = [cell for cell in filled[1:] if called(heads[cell][0], *TEMPERATURE.split("; "))]
                used = [filled[0], *(second if table.key.endswith("stiffness") else []), head]
                names = [table.variables.split("; ")[0], *(heads[cell][0] for cell in used[1:-1]), table.values.split("; ")[0]]
                units = [plain_unit(heads[cell][1]) for cell in used]
                self.read_table(table, names, units, [[row[cell.order[2]] for cell in used] for row in rows[1:end]])
        return end

    def read_table(self, table, names, units, rows):
        measured = Measured(table, names, units, [], [])
        for row in rows:
            for name, cell in zip(names[:-1], row):
                if row[-1] and not cell:
                    self.wrong(row[-1], f"{names[-1]} is given without {name}")
            numbers = [self.number(name, cell, None)[0] if cell else None for name, cell in zip(names, row)]
            if None not in numbers:
                measured.rows.append(numbers)
                measured.cells.append(row[-1])
        if measured.rows:
            self.measured.append(measured)


class Case:
    """The case that the sheets make: its entries, what they do not say and what has no place in a case."""

    def __init__(self, sheets):
        self.sheets, self.entries, self.missing, self.unmapped, self.mapped, self.laws = sheets, [], [], [], 0, {}
        for parameter in sheets.parameters:
            if parameter.use not in ("coefficient", "scale", "computed"):
                self.parameter(parameter)
        self.entries.append(Entry("sources", [f"[{quoted(SOURCE)}]"], "", "sources", [None], ""))
        for law in STANDARD_LAWS:
            self.law(law, *(p for p in sheets.parameters if p.key == f"material.{law}"))
        for measured in sheets.measured:
            self.table(measured)
        for key, value, reason in fields_of(FIXED):
            self.assume(key, value, reason)
        if not any(entry.key == "tire.size" for entry in self.entries):  # an error; the rest is checked all the same
            self.entries.append(Entry("tire.size", ['"225/50 R17"'], "", "Size", [None], ""))

    def assume(self, key, value, reason, sheet="", name=""):
        if value:
            self.entries.append(Entry(key, [value], "assumed", name or key, [None], ""))
        block = key.removesuffix(".kind")
        self.missing.append((block, value if block == key else "", reason, sheet, name))

    def parameter(self, parameter):
        sheet, name, use, key = parameter.sheet, parameter.names[0], parameter.use, parameter.key
        value = self.sheets.values.get(parameter)
        rival = next((p for p, v in self.sheets.values.items() if p != parameter and v.sound and key and p.key == key and
                      p.sheet == "LateralStiffness"), None)
        if name in ALSO and value and value.sound:
            written = [quantity(value.number, value.unit)]
            self.entries.append(Entry(ALSO[name], written, f"{sheet}: {name}", name, [value.cell], parameter.units[0]))
        if value is None or not value.sound:
            if parameter.reason and use != "none" and not rival and not self.table_for(parameter.law):
                self.assume(key, parameter.standard, parameter.reason, sheet, name)
        elif use == "none" or rival:
            shown = value.text if value.unit in ("", "1", "-") else f"{number_text(value.number)} {value.unit}"
            reason = f"{rival.names[0]} of {rival.sheet} takes its place" if rival else parameter.reason
            self.unmapped.append((sheet, name, shown, reason))
        else:
            self.mapped += 1
            on = value.text == "ON"
            written = {"text": quoted(value.text), "on": "true" if on else "false", "word": '"on"' if on else '"off"',
                       "sensor": parameter.standard}.get(use) or quantity(value.number, value.unit)
            if use == "rate":  # a = -2 ln(0.003)/dT, (71) with the errata's natural logarithm
                if value.unit != parameter.units[0] or value.number <= 0:
                    self.sheets.wrong(value.cell, f"{name} is {value.text} {value.unit}; above 0 {parameter.units[0]} is wanted")
                    return
                written = quantity(-2 * math.log(0.003) / value.number, "K")
            if use != "sensor" or on:
                self.entries.append(Entry(key, [written], f"{sheet}: {name}", name, [value.cell], parameter.units[0]))

    def table_for(self, law):
        """The measured table that takes the place of a law whose coefficients are left out."""
        given = any(p.law == law and p.use != "scale" for p in self.sheets.values)
        return next((m for m in self.sheets.measured if law and not given and m.table.key.endswith(f".{law}")), None)

    def table(self, measured):
        """A table in the place of its law; of the tire beside it, where the law's coefficients are given."""
        table, (block, _, law) = measured.table, measured.table.key.rpartition(".")
        if self.table_for(law) or block == "tire":
            self.mapped += 1
            key = table.key if self.table_for(law) else f"tire.measured.{law}"
            of_load = ["vertical_load", "bulk_temperature"] if law == "cornering_stiffness" else ["load"]
            variables = ["temperature"] if block == "material" else of_load
            heads = ", ".join(quoted(f"{name} [{unit}]") for name, unit in
                              zip([*variables[:len(measured.names) - 1], law], measured.units))
            lines = [f"{{ columns = [{heads}], rows = [",
                     *(f"    [{', '.join(map(number_text, row))}]," for row in measured.rows), "] }"]
            cells = [measured.cells[0], *measured.cells, measured.cells[-1]]
            self.entries.append(Entry(key, lines, f"{table.sheet}: {measured.names[-1]}", measured.names[-1], cells, ""))

    def law(self, law, *of):
        """A law k or c = A T^2 + B T + C, of its coefficients; about 0 degC, whatever scale the sheet counts on."""
        *given, scale = [self.sheets.values.get(p) for p in of]
        sheet, key, names = of[0].sheet, f"material.{law}", [p.names[0] for p in of]
        if self.table_for(law):
            return
        if not given[2] or not all(value.sound for value in (*given, scale) if value):
            first = next((i for i in range(2) if given[i]), None)
            if first is not None and not given[2]:
                self.sheets.wrong(given[first].name, f"{names[first]} is given without coeff. C",
                                  "give all three, a 0 where there is none")
            self.assume(key, *STANDARD_LAWS[law], sheet, "coefficients A, B, C")
            return
        a, b, c = (value.number if value else 0.0 for value in given)
        units = [value.unit if value else p.units[0] for p, value in zip(of, given)]
        own_units = units == [p.units[0] for p in of[:3]]
        if (a or b) and scale is None:
            reason = "the thesis does not say on which scale: degrees Celsius, as in its other sheets"
            self.missing.append((f"{key}.at", '"0 degC"', reason, sheet, names[3]))
        elif (a or b) and scale.text == "K":
            c, b = c + ZERO * (b + ZERO * a), b + 2 * ZERO * a
            if not own_units:
                self.sheets.wrong(given[2].cell, f"the law of {sheet} counts in kelvin, in {listed(units)}",
                                  f"write {listed([p.units[0] for p in of[:3]])}")
                self.assume(key, *STANDARD_LAWS[law], sheet, "coefficients A, B, C")
                return
        # The thesis's own k turns negative below -10.8 degC; where it was measured the range changes nothing.
        if own_units:
            self.laws[law] = lambda t: c + t * (b + t * a)
        turn = min(max(-b / (2 * a), -40.0), 200.0) if a else 0.0
        is_held = own_units and min(map(self.laws[law], (-40.0, turn, 200.0))) <= 0
        curvature, slope, value = (quantity(*term) for term in zip((a, b, c), units))
        text = f'at = "0 degC", value = {value}, slope = {slope}, curvature = {curvature}'
        text += ', range = ["20 degC", "120 degC"]' if is_held else ""
        self.entries.append(Entry(key, [f"{{ {text} }}"], f"{sheet}: coefficients A, B, C", f"the law of {sheet}",
                                  [given[2].cell], of[2].units[0]))
        self.mapped += sum(value is not None for value in (*given, scale))
        self.missing += [(f"{key}.{part}", quantity(0.0, p.units[0]), "no such term", sheet, p.names[0])
                         for p, value, part in zip(of, given, ("curvature", "slope", "value")) if not value]

    def lines(self):
        """The text of the case line by line, with the entry and the number of the entry's line that it comes from."""
        for table, head in HEADS.items():
            entries = [entry for entry in self.entries if entry.key.rpartition(".")[0] == table]
            if entries and head:
                yield from ((line, None, 0) for line in ["", *head.split("\n")])
            for entry in entries:
                remark = f"  # {printable(entry.remark)}" if entry.remark else ""
                for i, line in enumerate(entry.lines):
                    yield line if i else f"{entry.key.rpartition('.')[2]} = {line}{remark}", entry, i

    def compare(self):
        """Lists what the program computes itself, and measured tables that stand beside the law which the case takes."""
        for p, value in self.sheets.values.items():
            if p.use == "computed" and value.sound:
                shown = quantity(value.number, value.unit).strip('"')
                self.unmapped.append((p.sheet, p.names[0], shown, "the program computes it"))
        for table, names, units, rows, _ in self.sheets.measured:
            block, _, law = table.key.rpartition(".")
            if block == "material" and not self.table_for(law):
                self.unmapped.append((table.sheet, f"{names[1]} against {names[0]}", f"{len(rows)} rows",
                                      "the law of the same sheet is used" + self.furthest(table, law, units, rows)))

    def furthest(self, table, law, units, rows):
        """Where table and law differ most; nothing where one of them is in units of its own."""
        value = self.laws.get(law)
        if value is None or units != [table.variable_unit, table.value_unit]:
            return ""
        x, y = max(rows, key=lambda row: abs(value(row[0]) / row[1] - 1) if row[1] else math.inf)
        return f"; furthest off at {x:.6g} {units[0]}: measured {y:.4g} {units[1]}, law {value(x):.4g} {units[1]}"

    def listing(self):
        """What was assumed and what was left out, a line each."""
        yield "Not in the sheets and assumed:"
        for key, value, reason, sheet, name in self.missing:
            yield f"    {key}{f' = {value}' if value else ''}{f' ({sheet}: {name})' if sheet else ''}: {reason}"
        if self.unmapped:
            yield "In the sheets, but without a place in a case:"
        yield from (f"    {sheet}: {name} = {value}: {reason}" for sheet, name, value, reason in self.unmapped)

    def text(self):
        head = ["Made by tools/spreadsheet_to_case.py of the ten sheets of a thesis's spreadsheet: the two-node model.",
                "To run it otherwise, write a case that includes this one and says what differs.", *self.listing()]
        return "\n".join([*(f"# {printable(line)}" for line in head), "", *(line for line, _, _ in self.lines()), ""])


def check(case, stem, program):
    """Lets the program read the case, and tells what it finds at the cells that it comes from."""
    lines, sheets = list(case.lines()), case.sheets
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, f"{stem}.toml")
        file.write_text("\n".join(line for line, _, _ in lines) + "\n", encoding="utf-8")
        told = json.loads(subprocess.run([program, "check", file, "--json"], capture_output=True, text=True, check=False).stdout)

    def of(number, sentence):
        entry, i = lines[number - 1][1:] if number else (None, 0)
        if entry is None:
            return None, None, sentence
        key = entry.key.rpartition(".")[2]
        sentence = entry.name + (sentence[len(key):] if sentence.startswith(key) else f": {sentence}")
        assumed = "" if entry.cells[i] is not None else f" ({key} is assumed, the sheets do not say it)"
        return entry, entry.cells[i], sentence + assumed

    for mistake in told["errors"]:
        entry, cell, what = of(mistake["line"], mistake["message"])
        is_unit = entry and entry.unit and re.search("without a unit|not a unit| is wanted$", what)
        sheets.wrong(cell, what, f"write {entry.unit}" if is_unit else mistake["remedy"])
    for warning in told["warnings"]:
        number, sentence = re.fullmatch(r"(?:.*?\.toml:(\d+)(?::\d+)?: )?(.*)", warning, re.DOTALL).groups()
        sheets.warnings.append(of(int(number or 0), sentence)[2])


def convert(options):
    sheets = Sheets(options.sheet)
    case = Case(sheets)
    case.compare()
    target = options.out / f"{options.sheet.stem if options.sheet.is_file() else options.sheet.resolve().name}.toml"
    root = Path(__file__).resolve().parents[1]  # of the repository, or share/tiretherm where it is installed
    places = ("tiretherm", root / "build/release/tiretherm", root.parent.parent / "bin/tiretherm")
    program = options.program or next(filter(shutil.which, places), None)
    if program and any(sheets.known):
        check(case, target.stem, program)
    borrowed = [name for _, value, _, sheet, name in case.missing if value and sheet in ("ContactPatch", "Radius")]
    size = next((value.text for p, value in sheets.values.items() if p.key == "tire.size"), "225/50 R17")
    if borrowed and not called(size, "225/50 R17", "225/50R17"):
        sheets.warnings.append(f"{listed(borrowed)} of the {size}: taken from {THESIS}; give its own")
    for _, place, what, remedy in sorted(sheets.errors, key=lambda error: error[0]):
        print(printable(f"{place}: {what}"), f"\n    remedy: {printable(remedy)}" if remedy else "", sep="", file=sys.stderr)
    if sheets.errors:
        count = len(sheets.errors)
        raise Refused(f"{count} error{'s' * (count > 1)}; no case was written", "")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with open(target, "w" if options.force else "x", encoding="utf-8") as file:
            file.write(case.text())
    except FileExistsError:
        raise Refused(f"{target} exists and is left as it is",
                      "replace it with --force, or write elsewhere with --out DIR") from None
    except OSError as error:
        raise Refused(f"{target} cannot be written: {error.strerror}", "choose another directory with --out") from None
    print(f"{target}: a case of the two-node model")
    print(f"  {case.mapped} parameters of {sum(map(bool, sheets.known))} sheets have their place in it")
    print(*map(printable, case.listing()), *(f"warning: {printable(warning)}" for warning in sheets.warnings), sep="\n")
    print(f"It runs with: tiretherm run {target}" if program else
          f"It was not checked, for the program was not found: tiretherm check {target}, or give --program FILE")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, epilog=(
        "An .xlsx needs the Debian package python3-openpyxl, an .xls python3-xlrd.\nExit code: 0 the case was written, 1 an error.\n"
        "Example:\n  tools/spreadsheet_to_case.py cases/convert/thesis_225_50_R17.xlsx --out out/my_cases"))
    parser.add_argument("sheet", type=Path, metavar="SHEET", help="workbook (.xls, .xlsx), or a folder with a CSV file of each sheet")
    parser.add_argument("--out", type=Path, default=Path("."), metavar="DIR",
                        help="where the case goes, called like the spreadsheet; default: here")
    parser.add_argument("--force", action="store_true", help="replace a case that is there already")
    parser.add_argument("--program", metavar="FILE",
                        help="tiretherm, where it is neither on the path nor built beside this script")
    try:
        convert(parser.parse_args())
    except Refused as refusal:
        sentence, remedy = refusal.args
        sys.exit(f"{sentence}; {remedy}" if remedy else sentence)


if __name__ == "__main__":
    main()
