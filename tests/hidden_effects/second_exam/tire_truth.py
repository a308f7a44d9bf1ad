# SPDX-License-Identifier: BSD-3-Clause
"""Temperatures through the thickness of a rolling tire, for many tires ("lanes") at once.

The same code is the truth of an exam (fine mesh, more physics) and the model that its user has (coarse mesh, the equations of
the practice benches). Steps are implicit (SDIRK of order 2, L-stable). Inside a step the rubber is linear: its response to the
heat through the outer face is computed beforehand, so that only the temperature of that face is sought by Newton's method.
Everything is SI and kelvin. Arrays have one value a lane, [lanes], or a row for each moment, [moments, lanes].
"""
import numpy as np
from scipy.optimize import brentq
from scipy.special import erfcx

RADIUS, WIDTH, HEIGHT, CROWN = 0.3308, 0.225, 0.1125, 0.012        # m
AREA = 2 * np.pi * RADIUS * WIDTH                                 # m2, outer surface of the tread
DENSITY, HEAT_CAPACITY = 1100.0, 1800.0                            # kg/m3, J/kgK
ZERO_CELSIUS, BOLTZMANN = 273.15, 5.670374419e-8                   # K, W/m2K4
GAMMA = 1 - np.sqrt(0.5)
SIDEWALL_THICKNESS = {"layers": 0.012, "two_node": 0.009}          # m

LANE = dict(
    film_scale=1.0, loss_scale=1.0,          # lambda_h, lambda_SEL
    film_linear=0.0,                         # share of a film that grows in proportion to the speed
    emissivity=0.0,
    contact_resolved=0.0,                    # share of a contact of two half-spaces
    partition_fall=0.0,                      # s/m, the tire's share is 0.6 / (1 + fall v_s)
    friction_scale=1.0,
    cornering=0.0,                           # 1/N, heat of the carcass by Fy^2 V
    wave_gain=0.0, wave_speed=42.0,          # (km/h)^-1.5 and m/s
    loss_slope=0.0,                          # 1/K at 60 degC, of an Arrhenius law
    load_exponent=0.0,
    pressure_exponent=0.0,                   # of the gas's temperature
    liner=0.0, rim_film=0.0, rim_cooling=10.0, rim_capacity=7200.0,   # W/K, J/K
    sidewall=0.0,                            # W/K at 100 km/h
    carcass_conductivity=1.0, conductivity_slope=0.0, carcass_capacity=1.0,
    worn=0.0, wear_rate=0.0,                 # m, m/s
    probe_depth=0.010,                       # m
)
DRIVE = dict(wind=0.0, extra_conductance=0.0, extra_temperature=300.0, rim_heat=0.0)


def layered_mesh(tread_cells=48, carcass_cells=24, first_cell=4e-5):
    """Cells from the outer surface inwards: 8 mm of tread that begin with `first_cell` [m], 4 mm of carcass."""
    excess = lambda ratio: first_cell * (ratio ** tread_cells - 1) / (ratio - 1) - 0.008
    ratio = brentq(excess, 1 + 1e-9, 2.0)
    tread = first_cell * ratio ** np.arange(tread_cells)
    thickness = np.concatenate([tread, np.full(carcass_cells, 0.004 / carcass_cells)])
    inside = np.arange(thickness.size) >= tread_cells
    return dict(kind="layers", thickness=thickness, carcass=inside, conductivity=np.where(inside, 0.30, 0.40))


def two_node_mesh():
    """Two lumps of 15 % and 85 % of the mass."""
    return dict(kind="two_node", thickness=CROWN * np.array([0.15, 0.85]), carcass=np.array([False, True]))


def make_lanes(count, **values):
    """Numbers of `count` tires: those of the base model but for `values`."""
    return {name: np.broadcast_to(np.asarray(values.get(name, number), float), (count,)).copy() for name, number in LANE.items()}


def contact_length(load):
    """Length of the contact [m] under a load [N]."""
    return 0.160 - 0.320 / (1 + np.exp(0.35e-3 * load))


def resolved_coefficient(speed, load, joint=2.5e4):
    """Mean coefficient [W/m2K] of two half-spaces, rubber and asphalt, that meet for length/speed through a joint [W/m2K]."""
    rubber, asphalt = np.sqrt(0.40 * DENSITY * HEAT_CAPACITY), np.sqrt(1.2 * 2300 * 900)
    duration = contact_length(np.maximum(load, 50.0)) / np.maximum(speed, 1.0)
    root = joint * np.sqrt(duration) * (1 / rubber + 1 / asphalt)
    return joint * (erfcx(root) - 1 + 2 * root / np.sqrt(np.pi)) / root ** 2


def forced_film(speed):
    """Coefficient [W/m2K] of the air in forced convection, thesis (32)."""
    length = 1 / (1 / (2 * RADIUS) + 1 / WIDTH)
    return 0.025 / length * 0.318 * (np.abs(speed) * length / 1.5e-5) ** 0.571


def loss_without_tangent(drive, lane, kind):
    """Heat of deformation [W] over the loss tangent, and the shift of temperature by frequency [K]."""
    speed, load = np.abs(drive["speed"]), np.maximum(drive["load"], 1e-3)
    rolls = (speed > 0.1) & (drive["load"] > 1.0)
    ratio = (WIDTH * CROWN + 2 * SIDEWALL_THICKNESS[kind] * (HEIGHT - CROWN)) / (WIDTH * HEIGHT)
    turns = np.maximum(speed, 0.1) / (2 * np.pi * 0.3483 * load ** -0.009)
    decades = np.log10(turns / 52.0)
    heat = load * 4.2e-6 * load * ratio * (2 * np.pi * RADIUS / contact_length(np.maximum(load, 1.0))) * turns
    excess = np.maximum(0.0, (speed - lane["wave_speed"]) * 3.6)
    heat = heat * lane["loss_scale"] * (1 + lane["wave_gain"] * excess ** 1.5)
    heat = heat * (np.maximum(load, 50.0) / 4500.0) ** lane["load_exponent"]
    return np.where(rolls, heat, 0.0), 101.6 * decades / (-8.86 - decades)


def surface_terms(drive, lane):
    """What enters or leaves the outer face, but for its own temperature: a dict of [moments, lanes]."""
    speed, load = np.abs(drive["speed"]), drive["load"]
    touches = load > 1.0
    contact = np.where(touches, 2.333e-6 * load, 0.0) / AREA
    along = np.sqrt(speed ** 2 + drive["wind"] ** 2)
    linear = forced_film(25.0) * (0.10 + 0.90 * along / 25.0) * (along > 0)
    sliding = speed * np.tan(np.abs(drive["slip"]))
    share = 0.6 / (1 + lane["partition_fall"] * sliding)
    friction = lane["friction_scale"] * share * np.abs(drive["force"]) * sliding
    coefficient = (1 - lane["contact_resolved"]) * 500.0 + lane["contact_resolved"] * resolved_coefficient(speed, load)
    return dict(
        film=(1 - lane["film_linear"]) * forced_film(along) + lane["film_linear"] * linear,
        free=1 - contact, road_conductance=contact * coefficient, road=drive["road"],
        friction=np.where(touches, friction, 0.0) / AREA, air=drive["air"],
        extra=drive["extra_conductance"] / AREA, surroundings=drive["extra_temperature"])


def outer_flux(temperature, terms, lane):
    """Heat into the outer face [W/m2] at its temperature, and the slope of that [W/m2K]."""
    exponential = 8.59e-11 * np.exp(0.0879 * np.minimum(temperature, 420.0))
    total = terms["film"] + exponential
    above = total > 30.0
    film = lane["film_scale"] * np.where(above, total, 30.0) * terms["free"]
    growth = lane["film_scale"] * np.where(above, 0.0879 * exponential, 0.0) * terms["free"]
    radiation = lane["emissivity"] * BOLTZMANN
    rise = terms["air"] - temperature
    flux = film * rise + terms["road_conductance"] * (terms["road"] - temperature) + terms["friction"] \
        + radiation * (terms["air"] ** 4 - temperature ** 4) + terms["extra"] * (terms["surroundings"] - temperature)
    slope = growth * rise - film - terms["road_conductance"] - 4 * radiation * temperature ** 3 - terms["extra"]
    return flux, slope


class Tire:
    """Temperatures of all lanes, stepped together."""

    def __init__(self, mesh, lane, step, start, air):
        """`step` [s]; `start` and `air` [K] a lane: of the rubber, of gas and rim."""
        self.mesh, self.lane, self.step = mesh, lane, step
        self.layered = mesh["kind"] == "layers"
        count = start.size
        self.cells = np.repeat(start[:, None], mesh["thickness"].size, axis=1)
        self.outer, self.inner = start.copy(), start.copy()
        self.gas, self.rim, self.memory = air.copy(), air.copy(), air.copy()
        self.weight = mesh["thickness"] * mesh["carcass"] / (mesh["thickness"] * mesh["carcass"]).sum()
        self.bulk = self.bulk_before = np.full(count, start)
        self.changes = not self.layered or bool(np.any(lane["conductivity_slope"]) or np.any(lane["wear_rate"]))
        self.age = 0
        self.build()

    def build(self):
        """Capacities, conductances and the inverse matrix of a stage, at the present temperatures and wear."""
        lane, mesh, carcass = self.lane, self.mesh, self.mesh["carcass"]
        worn = np.clip(lane["worn"] + lane["wear_rate"] * self.age * self.step, 0.0, 0.0065)
        keep = np.where(carcass, 1.0, 1 - worn[:, None] / 0.008) if self.layered else np.ones((worn.size, 2))
        self.thickness = mesh["thickness"] * keep
        self.capacity = DENSITY * HEAT_CAPACITY * self.thickness * np.where(carcass, lane["carcass_capacity"][:, None], 1.0)
        slope = 1 + lane["conductivity_slope"] * (self.bulk - 333.15)
        scale = (lane["carcass_conductivity"] * slope)[:, None]
        if self.layered:
            conductivity = mesh["conductivity"] * np.where(carcass, scale, 1.0)
            half = 0.5 * self.thickness / conductivity
            link = 1 / (half[:, 1:] + half[:, :-1])
            self.skin, self.lining = half[:, 0], half[:, -1]
        else:
            link = scale * ((0.29 + 0.00943 * (self.bulk - 293.15)) / 0.010)[:, None]
            self.skin = self.lining = np.zeros(worn.size)
        self.inverse = np.linalg.inv(self.matrix(link))
        factor = GAMMA * self.step / self.capacity
        self.outer_answer = self.inverse[:, :, 0] * factor[:, :1]
        self.inner_answer = self.inverse[:, :, -1] * factor[:, -1:]
        self.factor = factor
        self.carcass_mass = (self.thickness * carcass).sum(axis=1)

    def matrix(self, link):
        """I - gamma step A of each lane, A the exchange between neighbours by `link` [W/m2K]."""
        count, cells = self.capacity.shape
        matrix = np.zeros((count, cells, cells))
        ahead = GAMMA * self.step * link / self.capacity[:, :-1]
        back = GAMMA * self.step * link / self.capacity[:, 1:]
        here = np.arange(cells)
        matrix[:, here, here] = 1.0
        matrix[:, here[:-1], here[:-1]] += ahead
        matrix[:, here[1:], here[1:]] += back
        matrix[:, here[:-1], here[1:]] = -ahead
        matrix[:, here[1:], here[:-1]] = -back
        return matrix

    def inner_flux(self, free, terms):
        """Heat into the inner face [W/m2]; `free` [K] would be its temperature without any."""
        lane = self.lane
        conductance = (lane["liner"] + terms["sidewall"]) / AREA
        wanted = (lane["liner"] * self.gas + terms["sidewall"] * terms["air"]) / AREA
        answer = self.inner_answer[:, -1] + self.lining
        return (wanted - conductance * free) / (1 + conductance * answer)

    def stage(self, known, terms, bulk):
        """Temperatures at the end of a stage that begins from `known` [lanes, cells]; `bulk` [K] softens the rubber."""
        lane = self.lane
        tangent = 2.14e15 * np.exp(-((bulk + terms["shift"] + 4989.0) / 882.0) ** 2)
        softer = lane["loss_slope"] * 333.15 ** 2 * (1 / 333.15 - 1 / bulk)
        tangent = tangent * np.exp(softer) * (self.memory / 294.15) ** -lane["pressure_exponent"]
        source = terms["loss"] * tangent / (AREA * self.thickness.sum(axis=1))
        heat = source[:, None] * self.thickness
        heat = heat + (terms["cornering"] / (AREA * self.carcass_mass))[:, None] * self.thickness * self.mesh["carcass"]
        free = (self.inverse @ (known + self.factor * heat)[:, :, None])[:, :, 0]
        inward = self.inner_flux(free[:, -1], terms)
        free = free + self.inner_answer * inward[:, None]
        answer = self.outer_answer[:, 0] + self.skin
        outer = self.outer
        for _ in range(4):
            flux, slope = outer_flux(outer, terms, lane)
            outer = outer - (outer - free[:, 0] - answer * flux) / (1 - answer * slope)
        flux = (outer - free[:, 0]) / answer
        self.outer = outer
        cells = free + self.outer_answer * flux[:, None]
        self.inner = cells[:, -1] + self.lining * inward
        return cells

    def advance_gas(self, terms):
        """Gas and rim over a step, implicitly; the inner face moves slowly beside them."""
        lane, step = self.lane, self.step
        share = step / 70.0
        self.gas = (self.gas + share * (lane["liner"] * self.inner + lane["rim_film"] * self.rim)) \
            / (1 + share * (lane["liner"] + lane["rim_film"]))
        part = step / lane["rim_capacity"]
        into = lane["rim_film"] * self.gas + lane["rim_cooling"] * terms["air"] + terms["rim_heat"]
        self.rim = (self.rim + part * into) / (1 + part * (lane["rim_film"] + lane["rim_cooling"]))
        self.memory = (self.memory + share * (9.0 * self.bulk + 4.0 * terms["air"])) / (1 + share * 13.0)

    def advance(self, middle, end):
        """One step, from the terms at its two stages."""
        if self.changes and (not self.layered or self.age % 8 == 0):
            self.build()
        trend = self.bulk - self.bulk_before
        first = self.stage(self.cells, middle, self.bulk + GAMMA * trend)
        known = self.cells + (1 - GAMMA) / GAMMA * (first - self.cells)
        self.cells = self.stage(known, end, self.bulk + trend)
        self.bulk_before, self.bulk = self.bulk, self.cells @ self.weight
        self.advance_gas(end)
        self.age += 1


def stage_terms(drive, lane, kind):
    """All that does not depend on temperatures: dict of [moments, lanes]."""
    terms = surface_terms(drive, lane)
    terms["loss"], terms["shift"] = loss_without_tangent(drive, lane, kind)
    terms["cornering"] = lane["cornering"] * drive["force"] ** 2 * np.abs(drive["speed"])
    terms["sidewall"] = lane["sidewall"] * (0.12 + 0.88 * (np.abs(drive["speed"]) / 27.8) ** 0.8)
    terms["rim_heat"] = drive["rim_heat"]
    return terms


def probe_weights(mesh, depth):
    """Shares of the cells [lanes, cells] in the temperature at a `depth` [m] a lane, straight between their middles."""
    middle = np.cumsum(mesh["thickness"]) - 0.5 * mesh["thickness"]
    return np.array([[np.interp(place, middle, unit) for unit in np.eye(middle.size)] for place in depth])


def read(tire, weights):
    """Surface, probe and inner face of all lanes [lanes, 3] in K; of two nodes surface and bulk twice."""
    if not tire.layered:
        return np.stack([tire.cells[:, 0], tire.cells[:, 1], tire.cells[:, 1]], axis=-1)
    return np.stack([tire.outer, (tire.cells * weights).sum(axis=1), tire.inner], axis=-1)


def simulate(mesh, lane, drive, step, start):
    """Readings [moments, lanes, 3] in K: surface, probe, inner face.

    `drive`: speed [m/s], load [N], slip [rad], force [N], air and road [K] and what DRIVE names, each [moments, lanes], straight
    between moments that are `step` [s] apart. `start` [K] a lane.
    """
    shape = drive["speed"].shape
    full = {name: np.broadcast_to(np.asarray(drive.get(name, DRIVE.get(name)), float), shape) for name in {**drive, **DRIVE}}
    middle = {name: (1 - GAMMA) * value[:-1] + GAMMA * value[1:] for name, value in full.items()}
    middle, end = stage_terms(middle, lane, mesh["kind"]), stage_terms({n: v[1:] for n, v in full.items()}, lane, mesh["kind"])
    tire = Tire(mesh, lane, step, start, full["air"][0])
    readings = np.empty(shape + (3,))
    weights = probe_weights(mesh, lane["probe_depth"])
    readings[0] = read(tire, weights)
    for moment in range(shape[0] - 1):
        tire.advance({n: v[moment] for n, v in middle.items()}, {n: v[moment] for n, v in end.items()})
        readings[moment + 1] = read(tire, weights)
    return readings
