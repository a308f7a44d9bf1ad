# SPDX-License-Identifier: BSD-3-Clause
"""What may be wrong in a set of dirty data: physics that the base model lacks, inputs and readings that are not what they say.

Each function draws one cause. `strength` is 0.5 for a small, 1 for a usual, 2 for a large one. A cause says which effects of the
catalogue would be a right answer for it (`ids`), in which sentences of a report it may be recognised (`words`, regular
expressions), and where heat of no effect would rightly be placed (`unknown`).
"""
from dataclasses import dataclass, field
from typing import Callable

import numpy as np
from scipy.signal import lfilter

CHANNELS = ("surface_temperature", "bulk_temperature", "inner_liner_temperature")
SURFACE, BULK, LINER = range(3)
CELSIUS = 273.15


@dataclass
class Run:
    """Which run a cause meets: its number from 0 on, whether it is the last to be fitted, whether it is kept back."""
    index: int
    last: bool
    kept: bool


@dataclass
class Cause:
    """One hidden fault; what it does is in the functions, of which those that are None do nothing."""
    name: str
    ids: list
    words: list = field(default_factory=list)
    unknown: list = field(default_factory=list)
    channels: list = field(default_factory=list)
    numbers: dict = field(default_factory=dict)          # true values of effects' parameters, "effect.key"
    values: dict = field(default_factory=dict)           # what was drawn, for people
    timing: bool = False
    tire: Callable = None                                # run -> numbers of the lane
    world: Callable = None                               # (drive, run): changes what the tire meets
    log: Callable = None                                 # (log, drive, run): changes what the user reads of the inputs
    instrument: Callable = None                          # (readings [moments, 3] K, time, run, air) -> readings
    layered: bool = False                                # the truth has cells where the base has two nodes


def lagged(signal, step, lag):
    """Answer of a first-order sensor with time constant `lag` [s] to a signal that is straight between steps [s]."""
    keep = np.exp(-step / lag)
    ahead = 1 - lag / step * (1 - keep)
    answer, _ = lfilter([ahead, 1 - keep - ahead], [1, -keep], signal, zi=[signal[0] * (1 - ahead)])
    return answer


def late(signal, time, delay):
    """The signal `delay` [s] later."""
    return np.interp(time - delay, time, signal)


def only(channel, change):
    """An instrument that is wrong in one channel: change(signal [K], time [s], run, air [K])."""
    def instrument(readings, time, run, air):
        readings = readings.copy()
        readings[:, channel] = change(readings[:, channel], time, run, air)
        return readings
    return instrument


def constant_tire(**numbers):
    """The same numbers of the lane in every run."""
    return lambda run: numbers


# ---- physics -------------------------------------------------------------------------------------------------------------

def radiation(random, strength):
    """The tread radiates to surroundings at the temperature of the air."""
    value = min(0.98, random.uniform(0.85, 0.97))
    return Cause("radiation", ["radiation"], numbers={"radiation.emissivity": value}, tire=constant_tire(emissivity=value))


def gas_and_rim(random, strength):
    """Gas takes heat from the liner [W/K] and gives it to a rim that warms over minutes and cools to the air."""
    liner, film = strength * random.uniform(3, 8), strength * random.uniform(2, 5)
    return Cause("gas_and_rim", ["inner_gas", "rim_conduction", "sidewall_convection"], values=dict(liner=liner, rim_film=film),
                 tire=constant_tire(liner=liner, rim_film=film, rim_cooling=random.uniform(5, 15)))


def sidewall_film(random, strength):
    """Air takes heat from the inner structure, nearly in proportion to the speed [W/K at 100 km/h]."""
    value = strength * random.uniform(3, 9)
    return Cause("sidewall_film", ["sidewall_convection", "inner_gas"], values=dict(at_100_kmh=value),
                 tire=constant_tire(sidewall=value))


def linear_film(random, strength):
    """A film that grows with the speed itself in place of its power 0.571, the same at 25 m/s."""
    value = min(1.0, strength * random.uniform(0.4, 0.9))
    return Cause("linear_film", ["convection_exponent"], values=dict(share=value), tire=constant_tire(film_linear=value))


def wind(random, strength):
    """Wind [m/s] that nobody measured, in gusts of minutes, across the direction of driving."""
    mean, gust = strength * random.uniform(4, 8), random.uniform(60, 200)
    def blow(drive, run):
        drive["wind"] = mean * (1 + 0.4 * np.sin(2 * np.pi * drive["time"] / gust + run.index))
    return Cause("wind", ["convection_exponent", "natural_convection"], [r"\bwind\b"], ["surface"], values=dict(mean=mean), world=blow)


def resolved_contact(random, strength):
    """A share of the contact is that of two half-spaces that meet in each revolution."""
    value = min(1.0, strength * random.uniform(0.3, 0.6))
    return Cause("resolved_contact", ["resolved_contact", "travelling_contact", "road_contact"], values=dict(share=value),
                 tire=constant_tire(contact_resolved=value))


def loss_slope(random, strength):
    """Loss falls with temperature by an Arrhenius law beside that of the base [1/K at 60 degC]."""
    value = strength * random.choice([-1, 1]) * random.uniform(0.002, 0.005)
    return Cause("loss_slope", ["loss_tangent_slope", "loss_frequency_shift", "inflation_pressure_rise"],
                 numbers={"loss_tangent_slope.slope": value}, tire=constant_tire(loss_slope=value))


def load_exponent(random, strength):
    """Loss follows another power of the load."""
    value = strength * random.choice([-1, 1]) * random.uniform(0.08, 0.25)
    return Cause("load_exponent", ["load_exponent_of_loss"], numbers={"load_exponent_of_loss.exponent": value},
                 tire=constant_tire(load_exponent=value))


def pressure_rise(random, strength):
    """Loss falls as the gas gets hot and the pressure rises."""
    value = strength * random.uniform(0.3, 0.6)
    return Cause("pressure_rise", ["inflation_pressure_rise", "loss_tangent_slope"],
                 numbers={"inflation_pressure_rise.exponent": value}, tire=constant_tire(pressure_exponent=value))


def session_pressures(random, strength):
    """The last session, and the run that is kept back, with less pressure than those before: more loss."""
    scale = {True: 1 + strength * random.uniform(0.06, 0.12), False: 1.0}
    return Cause("session_pressures", ["inflation_pressure_rise", "strain_energy_loss"], ["(other|another|lower|higher|unlogged) pressure|pressure.{0,30}(differs|run)", "other tire|differs? from run to run"],
                 ["bulk", "carcass"], values=dict(loss_of_last_run=scale[True]),
                 tire=lambda run: dict(loss_scale=scale[run.last or run.kept]))


def other_compound(random, strength):
    """The last run is driven on another compound; the run that is kept back is not."""
    loss, friction = 1 + 0.2 * strength * random.uniform(0.7, 1.3), 1 - 0.1 * strength
    return Cause("other_compound", ["strain_energy_loss"], ["(other|another|different) compound", "other tire|differs? from run to run"], ["bulk", "carcass"],
                 values=dict(loss=loss, friction=friction),
                 tire=lambda run: dict(loss_scale=loss, friction_scale=friction) if run.last else {})


def partition_fall(random, strength):
    """The tire's share of friction falls with the speed of sliding [s/m]."""
    value = strength * random.uniform(0.08, 0.25)
    return Cause("partition_fall", ["partition_speed", "slip_input_gain", "sliding_friction"], values=dict(fall=value),
                 tire=constant_tire(partition_fall=value))


def cornering_loss(random, strength):
    """Lateral force deforms the carcass and heats it [1/N]."""
    value = strength * random.uniform(1e-6, 2.5e-6)
    return Cause("cornering_loss", ["cornering_loss"], numbers={"cornering_loss.coefficient": value},
                 tire=constant_tire(cornering=value))


def standing_wave(random, strength):
    """Above a speed [m/s] loss runs away by the power 1.5."""
    speed, gain = random.uniform(36, 43), strength * random.uniform(4e-4, 1e-3)
    return Cause("standing_wave", ["standing_wave"], values=dict(speed=speed, gain=gain),
                 tire=constant_tire(wave_speed=speed, wave_gain=gain))


def carcass_conductivity(random, strength):
    """The carcass, or the link of two nodes, conducts otherwise."""
    value = 1 + 0.15 * strength * random.choice([-1, 1]) * random.uniform(0.7, 1.2)
    return Cause("carcass_conductivity", ["layer_conductivity", "layer_heat_capacity"],
                 numbers={"layer_conductivity.scale": value}, tire=constant_tire(carcass_conductivity=value))


def conductivity_slope(random, strength):
    """Its conductivity changes with temperature otherwise [1/K about 60 degC]."""
    value = strength * random.choice([-1, 1]) * random.uniform(0.002, 0.005)
    return Cause("conductivity_slope", ["layer_conductivity", "layer_heat_capacity"], values=dict(slope=value),
                 tire=constant_tire(conductivity_slope=value))


def carcass_capacity(random, strength):
    """The carcass, or the bulk, stores more heat or less."""
    value = 1 + 0.10 * strength * random.choice([-1, 1]) * random.uniform(0.6, 1.2)
    return Cause("carcass_capacity", ["layer_heat_capacity", "layer_conductivity"], numbers={"layer_heat_capacity.scale": value},
                 tire=constant_tire(carcass_capacity=value))


def wear_over_runs(random, strength):
    """The tread gets thinner from run to run [m]."""
    each = strength * random.uniform(0.5e-3, 1.2e-3)
    return Cause("wear_over_runs", ["tread_wear"], [r"\bwear|\bworn"], values=dict(metres_a_run=each),
                 tire=lambda run: dict(worn=each * run.index))


def wear_within_run(random, strength):
    """The tread gets thinner within each run [m/s]."""
    rate = strength * random.uniform(1.0e-6, 2.0e-6)
    return Cause("wear_within_run", ["tread_wear"], [r"\bwear|\bworn"], values=dict(metres_a_second=rate),
                 tire=constant_tire(wear_rate=rate))


def tire_blankets(random, strength):
    """Blankets [W/K and K] heat the tire in the pits."""
    temperature, conductance = CELSIUS + random.uniform(70, 90), strength * random.uniform(15, 40)
    def cover(drive, run):
        drive["extra_conductance"], drive["extra_temperature"] = conductance * drive["pit"], temperature
    return Cause("tire_blankets", [], ["blanket"], ["surface", "tread"], values=dict(kelvin=temperature, watts_per_kelvin=conductance),
                 world=cover)


def rain_shower(random, strength):
    """In the last run water cools the tread for some minutes [W/K]."""
    begin, length, conductance = random.uniform(0.25, 0.6), random.uniform(90, 200), strength * random.uniform(40, 120)
    def rain(drive, run):
        start = begin * drive["time"][-1]
        falls = (drive["time"] > start) & (drive["time"] < start + length) & (drive["speed"] > 2) & run.last
        drive["extra_conductance"], drive["extra_temperature"] = conductance * falls, drive["air"] - 3
    return Cause("rain_shower", ["wet_road"], [r"\brain|shower|\bwet\b"], ["surface", "tread"], values=dict(watts_per_kelvin=conductance), world=rain)


def brake_heat(random, strength):
    """A share of the braking power warms the rim, and this the gas and the liner."""
    share, film = strength * random.uniform(0.02, 0.05), random.uniform(6, 10)
    def brake(drive, run):
        drive["rim_heat"] = share * lagged(drive["braking"], drive["time"][1] - drive["time"][0], 60.0)
    return Cause("brake_heat", ["brake_heat", "rim_conduction", "inner_gas"], ["brake"], ["bulk", "carcass", "inside"],
                 values=dict(share=share), world=brake, tire=constant_tire(liner=film, rim_film=film))


def coarse_mesh(random, strength):
    """The tire has a temperature field where the base has two nodes."""
    return Cause("coarse_mesh", ["mesh", "layer_conductivity"], ["finer mesh|coarse mesh|two nodes are too|mesh of layers"], layered=True)


# ---- inputs --------------------------------------------------------------------------------------------------------------

def load_gain(random, strength):
    """The logged load is off by a factor."""
    value = 1 + 0.10 * strength * random.choice([-1, 1]) * random.uniform(0.7, 1.2)
    def log(log, drive, run):
        log["load"] = log["load"] * value
    return Cause("load_gain", ["load_input_gain"], numbers={"load_input_gain.gain": 1 / value}, log=log)


def delay_of_input(name, random, strength):
    """An input that comes late [s]."""
    delay = strength * random.uniform(0.6, 1.4)
    def log(log, drive, run):
        log[name] = late(log[name], drive["time"], delay)
        if name == "slip":
            log["force"] = late(log["force"], drive["time"], delay)
    return Cause(f"{name}_late", ["input_delay", "clock_delay"], timing=True, values=dict(delay=delay), log=log)


def load_late(random, strength):
    """The load comes late [s]."""
    return delay_of_input("load", random, 1.5 * strength)


def slip_late(random, strength):
    """Slip angle and lateral force come late [s]."""
    return delay_of_input("slip", random, strength)


def load_constant(random, strength):
    """The log has one load [N] for the whole run."""
    value = 3900.0 + strength * random.uniform(0, 500)
    def log(log, drive, run):
        log["load"] = np.full_like(log["load"], value)
    return Cause("load_constant", ["load_input_gain", "load_exponent_of_loss"], ["vertical_load.{0,60}constant|constant.{0,60}load"],
                 ["bulk", "carcass"], log=log)


def slip_zero(random, strength):
    """The slip angle has a zero error."""
    value = np.radians(strength * random.choice([-1, 1]) * random.uniform(0.15, 0.4))
    def log(log, drive, run):
        log["slip"] = log["slip"] + value
    return Cause("slip_zero", ["slip_angle_offset"], ["zero error|slip_angle_offset|offset of the slip"], ["surface", "tread"],
                 values=dict(degrees=float(np.degrees(value))), log=log)


def slip_gain(random, strength):
    """The logged slip angle is off by a factor."""
    value = 1 + 0.15 * strength * random.choice([-1, 1]) * random.uniform(0.7, 1.3)
    def log(log, drive, run):
        log["slip"] = log["slip"] / value
    return Cause("slip_gain", ["slip_input_gain", "sliding_friction", "partition_speed"],
                 numbers={"slip_input_gain.gain": value}, log=log)


def speed_mph(random, strength):
    """Speed in mph under a heading of km/h."""
    def log(log, drive, run):
        log["speed"] = log["speed"] / 1.609344
    return Cause("speed_mph", ["speed_input_gain"], ["mph|mile"], log=log)


def speed_gain(random, strength):
    """The logged speed is off by a factor."""
    value = 1 + 0.05 * strength * random.choice([-1, 1]) * random.uniform(0.6, 1.3)
    def log(log, drive, run):
        log["speed"] = log["speed"] / value
    return Cause("speed_gain", ["speed_input_gain"], numbers={"speed_input_gain.gain": value}, log=log)


def other_wheel(random, strength):
    """Load, lateral force and slip angle are those of the wheel on the other side."""
    toe = np.radians(random.uniform(-0.2, 0.2))
    def log(log, drive, run):
        ratio = (drive["load"] - 2 * drive["transfer"]) / drive["load"]
        log["load"], log["force"] = np.maximum(log["load"] * ratio, 200.0), log["force"] * np.clip(ratio, 0.1, 4)
        log["slip"] = log["slip"] + toe
    return Cause("other_wheel", [], ["mirrored|the other side|left and right|other wheel"], log=log)


def road_not_measured(random, strength):
    """The log has the first temperature of the air for the road, which is warmer [K] and drifts."""
    offset, rate = strength * random.uniform(5, 12), random.uniform(-10, 10)
    def log(log, drive, run):
        log["road"] = np.full_like(log["road"], log["air"][0])
    def world(drive, run):
        drive["road"] = drive["road"] + offset + rate * drive["time"] / 3600
    return Cause("road_not_measured", ["road_temperature_drift"], ["road.{0,60}(constant|copy)"], values=dict(offset=offset), log=log, world=world)


def sun_round_lap(random, strength):
    """Half of each lap lies in the sun, half in the shade [K]; the log has the mean."""
    swing = strength * random.uniform(6, 12)
    def world(drive, run):
        drive["road"] = drive["road"] + swing * np.sign(np.sin(2 * np.pi * drive["lap"]))
    return Cause("sun_round_lap", ["road_temperature_drift"], ["road.{0,40}(lap|sun|shade)"], ["surface", "tread"], values=dict(swing=swing), world=world)


def air_in_fahrenheit(random, strength):
    """Air temperature in degF under a heading of degC."""
    def log(log, drive, run):
        log["air"] = CELSIUS + 32 + 1.8 * (log["air"] - CELSIUS)
    return Cause("air_in_fahrenheit", [], ["degF|fahrenheit"], log=log)


def air_drift(random, strength):
    """The air round the tire leaves the logged one [K/h]."""
    rate = strength * random.choice([-1, 1]) * random.uniform(6, 14)
    def world(drive, run):
        drive["air"] = drive["air"] + rate * drive["time"] / 3600
    return Cause("air_drift", ["air_temperature_drift"], numbers={"air_temperature_drift.rate": rate}, world=world)


# ---- readings ------------------------------------------------------------------------------------------------------------

def surface_lag_and_delay(random, strength):
    """The sensor of the tread is slow and late [s]."""
    lag, delay = strength * random.uniform(0.6, 1.6), strength * random.uniform(0.4, 1.2)
    change = lambda signal, time, run, air: late(lagged(signal, time[1] - time[0], lag), time, delay)
    return Cause("surface_lag_and_delay", ["sensor_lag", "clock_delay"], channels=[CHANNELS[SURFACE]], timing=True,
                 values=dict(lag=lag, delay=delay), instrument=only(SURFACE, change))


def probe_lag(random, strength):
    """The probe is slow [s]."""
    lag = strength * random.uniform(5, 12)
    change = lambda signal, time, run, air: lagged(signal, time[1] - time[0], lag)
    return Cause("probe_lag", ["sensor_lag", "clock_delay"], channels=[CHANNELS[BULK]], timing=True,
                 numbers={"sensor_lag.tau": lag}, instrument=only(BULK, change))


def clock_rate(random, strength):
    """The clock of the temperatures is fast or slow by some tenths of a per cent."""
    rate = strength * random.choice([-1, 1]) * random.uniform(0.001, 0.002)
    def instrument(readings, time, run, air):
        return np.stack([np.interp(time * (1 + rate), time, column) for column in readings.T], axis=1)
    return Cause("clock_rate", ["clock_delay", "clock_rate"], ["clock.{0,40}(rate|fast|slow|ppm)"], timing=True, values=dict(rate=rate),
                 instrument=instrument)


def drift(random, strength):
    """A channel drifts through the session, from run to run [K a run]."""
    channel, rate = random.choice([SURFACE, BULK]), strength * random.choice([-1, 1]) * random.uniform(1.0, 2.5)
    change = lambda signal, time, run, air: signal + rate * (time / time[-1] + run.index)
    return Cause("drift", ["sensor_offset", "sensor_gain", "sensor_drift"], ["(sensor|channel|reading).{0,60}drift|changes with time"], channels=[CHANNELS[channel]],
                 values=dict(kelvin_a_run=rate), instrument=only(channel, change))


def swapped(random, strength, other=LINER):
    """Two channels change places."""
    order = [other if channel == SURFACE else SURFACE if channel == other else channel for channel in range(3)]
    return Cause("swapped", [], ["swap|exchanged|interchanged|change places"],
                 instrument=lambda readings, time, run, air: readings[:, order])


def swapped_on_two_nodes(random, strength):
    """Surface and bulk change places."""
    return swapped(random, strength, BULK)


def surface_in_fahrenheit(random, strength):
    """Tread temperature in degF under a heading of degC."""
    change = lambda signal, time, run, air: CELSIUS + 32 + 1.8 * (signal - CELSIUS)
    return Cause("surface_in_fahrenheit", [], ["degF|fahrenheit"], instrument=only(SURFACE, change))


def gain(random, strength):
    """A channel is off in proportion to what lies over 25 degC."""
    channel, excess = random.choice([SURFACE, BULK]), strength * random.choice([-1, 1]) * random.uniform(0.02, 0.05)
    change = lambda signal, time, run, air: signal + excess * (signal - CELSIUS - 25)
    ids = ["sensor_gain"] + (["camera_emissivity"] if channel == SURFACE else [])
    return Cause("gain", ids, channels=[CHANNELS[channel]], numbers={"sensor_gain.excess": excess}, instrument=only(channel, change))


def emissivity(random, strength):
    """The camera takes a grey surface for black."""
    value = 1 - 0.05 * strength * random.uniform(0.7, 1.4)
    change = lambda signal, time, run, air: (value * signal ** 4 + (1 - value) * air ** 4) ** 0.25
    return Cause("emissivity", ["camera_emissivity", "sensor_gain"], channels=[CHANNELS[SURFACE]],
                 numbers={"camera_emissivity.emissivity": value}, instrument=only(SURFACE, change))


def dirty_window(random, strength):
    """The window of the infrared sensor lets less through from minute to minute."""
    fall = 0.07 * strength * random.uniform(0.7, 1.3)
    def change(signal, time, run, air):
        clear = 1 - fall * time / time[-1]
        return (clear * signal ** 4 + (1 - clear) * air ** 4) ** 0.25
    return Cause("dirty_window", ["camera_emissivity", "sensor_gain", "sensor_drift"], ["window of the (sensor|camera|infrared)|(sensor|channel|reading).{0,60}drift|changes with time"],
                 channels=[CHANNELS[SURFACE]], values=dict(fall=fall), instrument=only(SURFACE, change))


def replaced(random, strength):
    """From the second run on another sensor reads the tread."""
    excess, kelvin = -0.04 * strength * random.uniform(0.6, 1.3), strength * random.uniform(-1.5, -0.5)
    change = lambda signal, time, run, air: signal + (run.index > 0) * (excess * (signal - CELSIUS - 25) + kelvin)
    return Cause("replaced", ["camera_emissivity", "sensor_gain", "sensor_offset"], ["replaced|another instrument|differs? from run to run"],
                 channels=[CHANNELS[SURFACE]], values=dict(excess=excess, kelvin=kelvin), instrument=only(SURFACE, change))


def offset(random, strength):
    """A channel is off by the same amount [K]."""
    channel, kelvin = random.choice([SURFACE, BULK]), strength * random.choice([-1, 1]) * random.uniform(0.8, 2.0)
    change = lambda signal, time, run, air: signal + kelvin
    return Cause("offset", ["sensor_offset"], channels=[CHANNELS[channel]], numbers={"sensor_offset.kelvin": kelvin},
                 instrument=only(channel, change))


def probe_depth(random, strength):
    """The probe sits deeper or shallower than stated [m]."""
    value = strength * random.choice([-1, 1]) * random.uniform(0.4e-3, 0.9e-3)
    return Cause("probe_depth", ["sensor_depth"], channels=[CHANNELS[BULK]], numbers={"sensor_depth.offset": value},
                 tire=constant_tire(probe_depth=0.010 + value))


PHYSICS = [radiation, gas_and_rim, sidewall_film, linear_film, resolved_contact, loss_slope, load_exponent, pressure_rise,
           partition_fall, cornering_loss, carcass_conductivity, conductivity_slope, carcass_capacity]
INPUTS = [load_gain, load_late, slip_late, slip_zero, slip_gain, speed_mph, speed_gain, road_not_measured, air_in_fahrenheit, air_drift]
READINGS = [surface_lag_and_delay, surface_lag_and_delay, surface_lag_and_delay, probe_lag, clock_rate, drift, surface_in_fahrenheit, gain, emissivity, dirty_window, offset]
TIMING = [surface_lag_and_delay, surface_lag_and_delay, surface_lag_and_delay, probe_lag, clock_rate, slip_late, load_late]


def choices(base, kind, runs):
    """The causes that a set can have, in three groups: physics, inputs, readings."""
    physics, inputs, readings = list(PHYSICS), list(INPUTS), list(READINGS)
    several, layers, car = runs > 1, base == "layers", kind in ("race", "pits", "road")
    physics += [rain_shower, wind] * car + [session_pressures] * several + [other_compound] * (runs > 2) + [wear_within_run] * layers
    physics += [wear_over_runs] * (layers and several) + [coarse_mesh] * 4 * (not layers)
    physics += [tire_blankets] * 4 * (kind == "pits") + [brake_heat] * 2 * (kind in ("race", "pits"))
    physics += [standing_wave] * (kind in ("race", "pits", "durability"))
    inputs += [load_constant, other_wheel] * car + [sun_round_lap] * (kind in ("race", "pits"))
    readings += [replaced] * several + [probe_depth] * layers + [swapped if layers else swapped_on_two_nodes]
    return physics, inputs, readings


def draw_causes(random, base, kind, runs, timing=False):
    """One to three causes, of the physics and, on fast programmes, of readings at most two; with `timing` one of them is late or slow."""
    count = random.integers(1, 4)
    groups = choices(base, kind, runs)
    order = random.permutation([0, 0, 1, 2, 2] if kind in ("race", "sweeps") else [0, 0, 1, 2])[:count]
    causes = [TIMING[random.integers(len(TIMING))](random, random.choice([1.0, 2.0]))] if timing else []
    for group in order[:count - len(causes)]:
        taken = [cause.name for cause in causes]
        free = [draw for draw in groups[group] if draw.__name__ not in taken]
        causes.append(free[random.integers(len(free))](random, random.choice([0.5, 1.0, 2.0])))
    return causes
