# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong in a set: many small things at once, of the tire (`comp`), of its instruments and of its log (`inst`).

A cause is a group of numbers, each of which `COMP` or `INST` draws by a function. `ANSWERS` says which effects of the catalogue would
be a right answer for it, and which of its numbers is a parameter of an effect of the same definition.
"""
import numpy as np
from scipy.signal import lfilter

SURFACE = 0                                                     # channel
SOUND = dict(lag=0.0, delay=0.0, eps=1.0, load_gain=1.0, load_late=0.0, slip_gain=1.0)      # instruments and logs without faults


def between(low, high):
    """A function that draws evenly between two numbers."""
    return lambda random: float(random.uniform(low, high))


def scale(low, high):
    """A function that draws a factor, as often below 1 as above."""
    return lambda random: float(np.exp(random.uniform(*np.log([low, 1.0] if random.random() < 0.5 else [1.0, high]))))


COMP = {
    "sidewall_gas": dict(side=between(0.2, 2.2), liner=between(2.0, 9.0), rim=between(0.8, 3.2), rim_air=between(4.0, 15.0)),
    "contact": dict(cmul=between(1.5, 5.5), cpow=between(0.0, 0.5)),
    "film": dict(expo=between(0.40, 0.75)),
    "capacity": dict(c_carc=scale(0.80, 1.30)),
    "conductivity": dict(k_carc=scale(0.65, 1.35), k_slope=between(-0.003, 0.003)),
    "radiation": dict(rad=between(0.85, 0.97)),
    "loss_slope": dict(lslope=between(-0.003, 0.003)),
    "friction": dict(pscale=scale(0.80, 1.25), pslope=between(-0.15, -0.02)),
    "road": dict(r_off=between(-9.0, 9.0), r_drift=between(-8.0, 8.0)),
    "load_power": dict(lpow=between(-0.15, 0.15)),
    "cornering": dict(corner=between(0.5e-6, 2.0e-6)),
}
CHANCES = dict(sidewall_gas=3, contact=4, film=4, capacity=3, conductivity=4, radiation=4, loss_slope=4, friction=5, road=2, load_power=1,
               cornering=1)
TWO_NODES = dict(k_carc=scale(0.88, 1.12))                      # the link as a whole, of which the carcass is a part
INST = {
    "timing": dict(lag=between(0.4, 3.8), delay=between(0.1, 1.5)),
    "emissivity": dict(eps=between(0.93, 0.995)),
    "load": dict(load_gain=scale(0.94, 1.06), load_late=between(0.1, 0.5)),
    "slip": dict(slip_gain=scale(0.88, 1.14)),
}
ANSWERS = {
    "sidewall_gas": dict(ids=["sidewall_convection", "inner_gas", "rim_conduction"], unknown=["inside"]),
    "contact": dict(ids=["resolved_contact", "travelling_contact", "road_contact", "contact_pressure_conductance"]),
    "film": dict(ids=["convection_exponent", "wind", "groove_convection"], numbers={"convection_exponent.exponent": "expo"}),
    "capacity": dict(ids=["layer_heat_capacity", "layer_conductivity"], numbers={"layer_heat_capacity.scale": "c_carc"}),
    "conductivity": dict(ids=["layer_conductivity", "layer_heat_capacity"], numbers={"layer_conductivity.scale": "k_carc"}),
    "radiation": dict(ids=["radiation"], numbers={"radiation.emissivity": "rad"}),
    "loss_slope": dict(ids=["loss_tangent_slope", "loss_frequency_shift", "inflation_pressure_rise"],
                       numbers={"loss_tangent_slope.slope": "lslope"}),
    "friction": dict(ids=["partition_speed", "sliding_friction", "slip_input_gain"], words=["share of the friction"]),
    "road": dict(ids=["road_temperature_drift"], words=["road.{0,60}(constant|copy|not measured)"]),
    "load_power": dict(ids=["load_exponent_of_loss"], numbers={"load_exponent_of_loss.exponent": "lpow"}),
    "cornering": dict(ids=["cornering_loss"], numbers={"cornering_loss.coefficient": "corner"}),
    "timing": dict(ids=["sensor_lag", "clock_delay"], timing=True),
    "emissivity": dict(ids=["camera_emissivity", "sensor_gain"], channels=["surface_temperature"],
                       numbers={"camera_emissivity.emissivity": "eps"}),
    "load": dict(ids=["load_input_gain", "input_delay"], numbers={"load_input_gain.gain": "load_gain"}),
    "slip": dict(ids=["slip_input_gain", "sliding_friction", "partition_speed"], numbers={"slip_input_gain.gain": "slip_gain"}),
}
OF_THE_LOG = ("load_gain", "slip_gain")                         # logged over true; an effect has true over logged


def draw_causes(random, base):
    """Two to six causes of the tire, all of the instruments: {name: {key: number}}."""
    names = list(COMP)
    chances = np.array([CHANCES[name] for name in names], float)
    taken = random.choice(names, size=random.integers(2, 7), replace=False, p=chances / chances.sum())
    own = TWO_NODES if base == "two_node" else {}
    return {name: {key: own.get(key, draw)(random) for key, draw in numbers.items()}
            for name, numbers in {**{name: COMP[name] for name in taken}, **INST}.items()}


def answer(name, numbers, size):
    """A cause as answer.json has it."""
    entry = dict(ids=[], words=[], unknown=[], channels=[], timing=False, numbers={}) | ANSWERS[name]
    entry["numbers"] = {effect: 1 / numbers[key] if key in OF_THE_LOG else numbers[key] for effect, key in entry["numbers"].items()}
    return dict(name=name, size=size, values=numbers, **entry)


def log_of(programme, numbers):
    """What the user reads of the inputs, where `numbers` has faults of logs."""
    faults = {**SOUND, "r_off": 0.0, "r_drift": 0.0} | numbers
    time, log = programme["time"], dict(programme)
    log["load"] = faults["load_gain"] * np.interp(time - faults["load_late"], time, programme["load"])
    log["slip"] = faults["slip_gain"] * programme["slip"]
    log["road"] = programme["road"] - faults["r_off"] - faults["r_drift"] * time / 3600
    return log


def through_instruments(field, time, air, numbers):
    """Readings [moments, 3] in K of temperatures at `time` [s]: a grey face for the camera, then its lag, then all channels late."""
    faults = SOUND | numbers
    field = field.copy()
    field[:, SURFACE] = (faults["eps"] * field[:, SURFACE] ** 4 + (1 - faults["eps"]) * air ** 4) ** 0.25
    if faults["lag"] > 0:
        field[:, SURFACE] = first_order(field[:, SURFACE], time[1], faults["lag"])
    return np.stack([np.interp(time - faults["delay"], time, column) for column in field.T], axis=1)


def first_order(signal, step, lag):
    """A slow sensor's answer to a signal that is straight over each step [s]."""
    keep = np.exp(-step / lag)
    new = 1 - lag / step * (1 - keep)
    slow, _ = lfilter([new, 1 - keep - new], [1.0, -keep], signal, zi=[signal[0] * (1 - new)])
    return slow
