#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Four tires of a car in a small master: each an instance of one FMU (FMI 2.0), driven by a quasi-static double-track model.

    tiretherm fmu cases/two_node/4000N_100kmh.toml --out tire.fmu
    python3 four_tires.py tire.fmu [seconds]

The car goes through laps of straights and corners. Load moves outwards and, when it brakes, forwards; lateral force follows the
load. Python's own modules are enough.
"""
import ctypes
import math
import sys
import tempfile
import zipfile
from pathlib import Path
from xml.etree import ElementTree

STEP = 0.01  # s
GRAVITY = 9.81
MASS, WHEELBASE, TRACK, HEIGHT, FRONT_SHARE, FRONT_ROLL_SHARE = 1350.0, 2.6, 1.55, 0.45, 0.48, 0.55
STIFFNESS = 30.0  # of a tire against slip angle, over its load, 1/rad
TIRES = {"front left": (1, 1), "front right": (1, -1), "rear left": (-1, 1), "rear right": (-1, -1)}  # axle, side

Logger = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", Logger), ("allocate", ctypes.c_void_p), ("free", ctypes.c_void_p),
                ("finished", ctypes.c_void_p), ("environment", ctypes.c_void_p)]


@Logger
def log(_environment, instance, _status, category, message):
    print(f"{instance.decode()}: {category.decode()}: {message.decode()}", file=sys.stderr)


class Fmu:
    """An FMU that has been unpacked: its functions, and its variables by name."""

    def __init__(self, file, folder):
        with zipfile.ZipFile(file) as archive:
            archive.extractall(folder)
        root = ElementTree.parse(folder / "modelDescription.xml").getroot()
        self.token = root.get("guid").encode()
        self.resources = (folder / "resources").as_uri().encode()
        self.variables = {v.get("name"): v for v in root.find("ModelVariables")}
        identifier = root.find("CoSimulation").get("modelIdentifier")
        self.library = ctypes.CDLL(str(folder / "binaries" / "linux64" / f"{identifier}.so"))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p

    def outputs(self):
        return [name for name, v in self.variables.items() if v.get("causality") == "output"]


class Tire:
    """An instance of it."""

    def __init__(self, fmu, name):
        self.fmu = fmu
        self.callbacks = Callbacks(log, None, None, None, None)
        self.it = ctypes.c_void_p(fmu.library.fmi2Instantiate(
            name.encode(), 1, fmu.token, fmu.resources, ctypes.byref(self.callbacks), 0, 0))
        if not self.it:
            sys.exit("the FMU cannot be used")
        self.call("fmi2SetupExperiment", 0, ctypes.c_double(0.0), ctypes.c_double(0.0), 0, ctypes.c_double(0.0))
        self.call("fmi2EnterInitializationMode")
        self.call("fmi2ExitInitializationMode")

    def call(self, function, *arguments):
        if getattr(self.fmu.library, function)(self.it, *arguments) != 0:
            sys.exit(f"{function} failed")

    def reference(self, name):
        return ctypes.byref(ctypes.c_uint(int(self.fmu.variables[name].get("valueReference"))))

    def set(self, name, value):
        if name in self.fmu.variables:  # what the case does not look at is no variable of the FMU
            self.call("fmi2SetReal", self.reference(name), ctypes.c_size_t(1), ctypes.byref(ctypes.c_double(value)))

    def get(self, name):
        value = ctypes.c_double()
        self.call("fmi2GetReal", self.reference(name), ctypes.c_size_t(1), ctypes.byref(value))
        return value.value

    def step(self, time):
        self.call("fmi2DoStep", ctypes.c_double(time), ctypes.c_double(STEP), 1)


def wheel(axle, side, ax, ay):
    """Load, lateral force and slip angle of a wheel, of a car in a quasi-static turn. ay > 0: to the left."""
    share = FRONT_SHARE if axle > 0 else 1.0 - FRONT_SHARE
    roll_share = FRONT_ROLL_SHARE if axle > 0 else 1.0 - FRONT_ROLL_SHARE
    static = 0.5 * MASS * GRAVITY * share
    pitch = -0.5 * axle * MASS * ax * HEIGHT / WHEELBASE
    roll = -side * roll_share * MASS * ay * HEIGHT / TRACK
    load = max(0.0, static + pitch + roll)
    axle_load = 2.0 * (static + pitch)
    force = MASS * share * ay * load / axle_load
    return load, force, force / (STIFFNESS * load) if load > 0.0 else 0.0


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 60.0
    with tempfile.TemporaryDirectory() as folder:
        fmu = Fmu(sys.argv[1], Path(folder))
        tires = {name: Tire(fmu, name) for name in TIRES}
        shown = fmu.outputs()[0]
        unit = 273.15 if fmu.variables[shown].find("Real").get("unit") == "K" else 0.0
        print(f"{shown}, each second\n     s" + "".join(f"{name:>14}" for name in tires))
        for i in range(round(seconds / STEP)):
            time = i * STEP
            corner = math.sin(0.2 * (time + STEP))
            ax, ay = -2.0 * math.sin(0.4 * (time + STEP)), 9.0 * corner
            for name, tire in tires.items():
                load, force, slip = wheel(*TIRES[name], ax, ay)
                tire.set("speed", 45.0 - 15.0 * corner**2)
                tire.set("vertical_load", load)
                tire.set("lateral_force", force)
                tire.set("slip_angle", slip)
                tire.step(time)
            if (i + 1) % round(1.0 / STEP) == 0:
                print(f"{time + STEP:6.0f}" + "".join(f"{tire.get(shown) - unit:14.2f}" for tire in tires.values()))
        for tire in tires.values():
            tire.call("fmi2Terminate")
            fmu.library.fmi2FreeInstance(tire.it)


main()
