# SPDX-License-Identifier: BSD-3-Clause
"""Temperatures through the crown of a rolling tire: 64 elements between 65 nodes, or two lumps, beside a gas and a rim.

Many tires ("lanes") are stepped together by ROS2, a linearly implicit method of order 2 that keeps its order whatever matrix it
uses. The matrix here has conduction, gas and rim and is renewed from time to time; what the outer face loses with its temperature,
which may grow fast, is added to it in each step. With the numbers of LANE as they stand these are the equations of the practice
benches. All is SI and kelvin; heat is per outer surface. Arrays are [lanes], [lanes, nodes] or, of what changes with time,
[moments, lanes].
"""
import numpy as np

RADIUS, WIDTH, HEIGHT, CROWN, TREAD = 0.3308, 0.225, 0.1125, 0.012, 0.008      # m
SURFACE = 2 * np.pi * RADIUS * WIDTH                            # m2
STORED = 1100.0 * 1800.0                                        # J/m3K
CELSIUS, REFERENCE = 273.15, 333.15                             # K; slopes are about 60 degC
SIDEWALL = {"layers": 0.012, "two_node": 0.009}                 # m
RIM_CAPACITY, GAS_CAPACITY = 6300.0, 70.0                       # J/K
GAMMA = 0.4                                                     # stable from 1/4 on; pulses of the surface are best between 0.4 and 0.5
RENEWAL = 20                                                    # steps between two matrices

LANE = dict(
    lam_h=1.0, lam_sel=1.0,              # scales of film and loss
    expo=0.571,                          # power of the speed in the film, which is the base's at 25 m/s
    rad=0.0,                             # emissivity of the tread
    side=0.0, liner=0.0, rim=0.0, rim_air=0.0,      # W/K: inner face to air and to gas, gas to rim, rim to air at 25 m/s
    cmul=1.0, cpow=0.0,                  # contact: a factor, and a power of the speed over 25 m/s
    k_carc=1.0, k_slope=0.0, c_carc=1.0,            # carcass: conductivity, capacity; 1/K, slope of all rubber
    lslope=0.0, lpow=0.0,                # loss: 1/K about 60 degC, and a power of the load over 4500 N
    corner=0.0,                          # 1/N, heat of the carcass over Fy^2 V
    pscale=1.0, pslope=0.0,              # tire's share of the friction: a factor, and s/m
)


def layered_mesh(tread=44, carcass=20, first=6e-5):
    """Elements from the outer face inwards, of the tread geometric from `first` [m] on, of the carcass even."""
    low, high = 1.0, 2.0
    for _ in range(60):
        ratio = 0.5 * (low + high)
        low, high = (ratio, high) if first * np.sum(ratio ** np.arange(tread)) < TREAD else (low, ratio)
    length = np.concatenate([first * ratio ** np.arange(tread), np.full(carcass, (CROWN - TREAD) / carcass)])
    inside = np.arange(length.size) >= tread
    half = lambda lengths: 0.5 * (np.append(lengths, 0.0) + np.append(0.0, lengths))
    probe = np.zeros(length.size + 1)
    probe[tread + carcass // 2] = 1.0
    return dict(kind="layers", length=length, inside=inside, outer=half(np.where(inside, 0.0, length)),
                inner=half(np.where(inside, length, 0.0)), probe=probe)


def two_lumps():
    """Lumps of 15 % and 85 % of the mass; the second is the bulk."""
    return dict(kind="two_node", length=np.array([0.010]), inside=np.array([True]), outer=CROWN * np.array([0.15, 0.0]),
                inner=CROWN * np.array([0.0, 0.85]), probe=np.array([0.0, 1.0]))


def make_lanes(rows):
    """Numbers of the lanes from a dict of each, which has what differs from LANE."""
    return {name: np.array([row.get(name, value) for row in rows], float) for name, value in LANE.items()}


def film_of_speed(speed, exponent):
    """Forced film [W/m2K] with the base's value at 25 m/s."""
    along = 1 / (1 / (2 * RADIUS) + 1 / WIDTH)
    at_25 = 0.025 / along * 0.318 * (25.0 * along / 1.5e-5) ** 0.571
    return at_25 * (speed / 25.0) ** exponent


def loss_and_shift(drive, lane, kind):
    """Loss of deformation over the loss tangent [W/m2], and what frequency adds to the temperature that it is taken at [K]."""
    speed, load = drive["speed"], np.maximum(drive["load"], 1.0)
    rolls = (speed > 0.1) & (drive["load"] > 1.0)
    section = (WIDTH * CROWN + 2 * SIDEWALL[kind] * (HEIGHT - CROWN)) / (WIDTH * HEIGHT)
    frequency = np.maximum(speed, 0.1) / (2 * np.pi * 0.3483 * load ** -0.009)
    contact = 0.160 * np.tanh(0.175e-3 * load)
    watts = lane["lam_sel"] * 4.2e-6 * load ** 2 * section * 2 * np.pi * RADIUS / contact * frequency * (load / 4500.0) ** lane["lpow"]
    decades = np.log10(frequency / 52.0)
    return np.where(rolls, watts, 0.0) / SURFACE, -101.6 * decades / (8.86 + decades)


def forcing(drive, lane, kind):
    """All that acts on the tires but for their temperatures: a dict of [moments, lanes]."""
    speed, load = drive["speed"], drive["load"]
    touches = load > 1.0
    share = np.where(touches, 2.333e-6 * load / SURFACE, 0.0)
    sliding = speed * np.abs(np.tan(drive["slip"]))
    friction = 0.6 * lane["pscale"] * np.exp(lane["pslope"] * sliding) * np.abs(drive["force"]) * sliding
    loss, shift = loss_and_shift(drive, lane, kind)
    return dict(
        loss=loss, shift=shift, free=1 - share, film=film_of_speed(speed, lane["expo"]), air=drive["air"], road=drive["road"],
        contact=500.0 * lane["cmul"] * share * (np.maximum(speed, 1.0) / 25.0) ** lane["cpow"],
        friction=np.where(touches, friction, 0.0) / SURFACE, cornering=lane["corner"] * drive["force"] ** 2 * speed / SURFACE,
        rim_air=lane["rim_air"] / SURFACE * (0.2 + 0.8 * speed / 25.0))


class Tires:
    """Temperatures [lanes, nodes + 2] of all tires: the nodes from the outer face inwards, gas, rim."""

    def __init__(self, mesh, lane, start, air):
        """`start` and `air` [K] a lane: of the rubber, of gas and rim."""
        self.mesh, self.lane, self.nodes = mesh, lane, mesh["outer"].size
        self.state = np.concatenate([np.repeat(start[:, None], self.nodes, axis=1), air[:, None], air[:, None]], axis=1)
        rubber = STORED * (mesh["outer"] + mesh["inner"] * lane["c_carc"][:, None])
        gas_and_rim = np.broadcast_to([GAS_CAPACITY / SURFACE, RIM_CAPACITY / SURFACE], (start.size, 2))
        self.capacity = np.concatenate([rubber, gas_and_rim], axis=1)
        self.heat_share = (mesh["outer"] + mesh["inner"]) / CROWN
        self.bulk_share = mesh["inner"] / mesh["inner"].sum()
        self.liner, self.rim = lane["liner"] / SURFACE, lane["rim"] / SURFACE

    def links(self):
        """Conductances between neighbours [W/m2K] at the present temperatures."""
        lane, mesh = self.lane, self.mesh
        rubber = self.state[:, :self.nodes]
        middle = 0.5 * (rubber[:, 1:] + rubber[:, :-1]) if mesh["kind"] == "layers" else rubber[:, 1:]
        own = np.where(mesh["inside"], 0.30, 0.40) if mesh["kind"] == "layers" else 0.29 + 0.00943 * (middle - 293.15)
        scale = np.where(mesh["inside"], lane["k_carc"][:, None], 1.0) * (1 + lane["k_slope"][:, None] * (middle - REFERENCE))
        return own * scale / mesh["length"]

    def rates(self, state, links, now):
        """Time derivative [K/s] of a state under the forcing of one moment."""
        lane, last = self.lane, self.nodes - 1
        rubber, gas, rim = state[:, :self.nodes], state[:, -2], state[:, -1]
        bulk, outer, inner = rubber @ self.bulk_share, rubber[:, 0], rubber[:, last]
        tangent = 2.14e15 * np.exp(-((bulk + now["shift"] + 4989.0) / 882.0) ** 2)
        tangent = tangent * np.maximum(0.1, 1 + lane["lslope"] * (bulk - REFERENCE))
        power = np.zeros_like(state)
        power[:, :self.nodes] = (now["loss"] * tangent)[:, None] * self.heat_share + now["cornering"][:, None] * self.bulk_share
        flow = links * np.diff(rubber, axis=1)
        power[:, :last] += flow
        power[:, 1:last + 1] -= flow
        power[:, 0] += self.into_face(outer, now)[0]
        power[:, last] += lane["side"] / SURFACE * (now["air"] - inner) + self.liner * (gas - inner)
        power[:, -2] = self.liner * (inner - gas) + self.rim * (rim - gas)
        power[:, -1] = self.rim * (gas - rim) + now["rim_air"] * (now["air"] - rim)
        return power / self.capacity

    def into_face(self, outer, now):
        """Heat into the outer face [W/m2] at its temperature, and what this loses with each kelvin [W/m2K]."""
        lane = self.lane
        hot = 8.59e-11 * np.exp(0.0879 * np.minimum(outer, 430.0))
        film = lane["lam_h"] * now["free"] * np.maximum(30.0, now["film"] + hot)
        growth = np.where(now["film"] + hot > 30.0, 0.0879 * hot, 0.0) * lane["lam_h"] * now["free"]
        radiated = lane["rad"] * 5.670374419e-8
        flux = now["friction"] + film * (now["air"] - outer) + now["contact"] * (now["road"] - outer)
        loss = film + growth * np.maximum(0.0, outer - now["air"]) + now["contact"] + 4 * radiated * outer ** 3
        return flux + radiated * (now["air"] ** 4 - outer ** 4), loss

    def stage_inverse(self, links, step):
        """Inverse of I - gamma step A, where A has conduction, gas and rim."""
        count, size = self.state.shape
        matrix = np.zeros((count, size, size))
        place, last = np.arange(self.nodes), self.nodes - 1
        for one, other, conductance in ((place[:-1], place[1:], links), ([last], [size - 2], self.liner[:, None]),
                                        ([size - 2], [size - 1], self.rim[:, None])):
            matrix[:, one, one] += conductance
            matrix[:, other, other] += conductance
            matrix[:, one, other] -= conductance
            matrix[:, other, one] -= conductance
        return np.linalg.inv(np.eye(size) + GAMMA * step * matrix / self.capacity[:, :, None])

    def advance(self, inverse, step, now, then):
        """One step, from the forcing of its two ends."""
        links = self.links()
        loss = GAMMA * step * self.into_face(self.state[:, 0], then)[1] / self.capacity[:, 0]
        factor = (loss / (1 + loss * inverse[:, 0, 0]))[:, None] * inverse[:, :, 0]

        def solve(right):
            answer = (inverse @ right[:, :, None])[:, :, 0]
            return answer - factor * answer[:, :1]

        first = solve(self.rates(self.state, links, now))
        ahead = solve(self.rates(self.state + step * first, links, then) - 2 * first)
        self.state = self.state + step * (1.5 * first + 0.5 * ahead)

    def readings(self):
        """Outer face, probe and inner face [lanes, 3]."""
        rubber = self.state[:, :self.nodes]
        return np.stack([rubber[:, 0], rubber @ self.mesh["probe"], rubber[:, -1]], axis=1)


def step_ends(acting):
    """Forcing at the begin and the end of each step, from that at half steps: moved so that the mean of both is Simpson's, for
    friction goes with the square of a slip that rises within a step."""
    ends = []
    for place in (slice(0, -1, 2), slice(2, None, 2)):
        ends.append({})
        for name, value in acting.items():
            excess = value[1::2] - 0.5 * (value[:-1:2] + value[2::2])
            ends[-1][name] = value[place] + 2 / 3 * excess
    return ends


def simulate(mesh, rows, drive, step, start):
    """Readings [steps + 1, lanes, 3] in K.

    `rows`: a dict of numbers for each lane; `drive`: speed [m/s], load [N], slip [rad], force [N], air and road [K], each
    [moments, lanes] at moments half a `step` [s] apart; `start` [K] a lane.
    """
    lane = make_lanes(rows)
    begins, ends = step_ends(forcing(drive, lane, mesh["kind"]))
    tires = Tires(mesh, lane, start, drive["air"][0])
    found = [tires.readings()]
    renewal = RENEWAL if mesh["kind"] == "layers" else 1
    for moment in range(begins["air"].shape[0]):
        if moment % renewal == 0:
            inverse = tires.stage_inverse(tires.links(), step)
        tires.advance(inverse, step, *({name: value[moment] for name, value in one.items()} for one in (begins, ends)))
        found.append(tires.readings())
    return np.array(found)
