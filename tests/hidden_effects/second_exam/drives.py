# SPDX-License-Identifier: BSD-3-Clause
"""Programmes of driving: laps, steps on a drum, sweeps on a bench, a road with stops, a session with a pit stop.

Each function draws one run and returns a dict of arrays at `time` [s]: speed [m/s], load [N], slip [rad], and what an
exam needs to know beside the tire: `transfer` [N], the part of the load that the wheel on the other side lacks; `lap` [1], the
place in the lap from 0 to 1; `pit` and `braking` [W]. Inputs go straight from moment to moment.
"""
import numpy as np

STATIC_LOAD = 3900.0                            # N
KINDS = ("race", "pits", "durability", "sweeps", "road")
INTERVAL = {"race": 1.0, "pits": 1.0, "durability": 4.0, "sweeps": 1.0, "road": 2.0}      # s between samples
MINUTES = {"race": 15.0, "pits": 15.0, "durability": 40.0, "sweeps": 15.0, "road": 25.0}
RELATED = {"race": ("race", "pits"), "pits": ("pits", "race"), "durability": ("durability",), "sweeps": ("sweeps", "race"), "road": ("road",)}


def draw_corners(random):
    """A lap as rows (duration [s], speed [m/s] at its end, slip [rad], turn -1 to 1)."""
    rows = []
    for _ in range(random.integers(6, 11)):
        corner = random.uniform(17, 48)
        top = random.uniform(max(corner + 8, 38), 68)
        turn = random.choice([-1, 1]) * random.uniform(0.5, 1.0)
        rows.append((random.uniform(4, 11), top, 0.002 * turn, 0.0))
        rows.append((random.uniform(2, 4), corner, 0.004 * turn, 0.0))
        rows.append((random.uniform(3, 7), corner * random.uniform(1.0, 1.12), np.radians(random.uniform(1.5, 4.5)) * np.sign(turn), turn))
        rows.append((1.0, corner * 1.12, 0.01 * turn, 0.3 * turn))
    return rows


def drive_laps(random, time, rows, begin, finish):
    """Laps of `rows` between two moments [s], each lap a little other than the last; standing before and after."""
    points = [(0.0, 0.0, 0.0, 0.0, 0.0), (begin, 0.0, 0.0, 0.0, 0.0)]
    moment = begin
    lap_time = sum(row[0] for row in rows)
    while moment < finish:
        pace, entry = random.uniform(0.96, 1.03), moment
        for duration, speed, slip, turn in rows:
            moment += duration / pace
            if moment >= finish:
                break
            points.append((moment, speed * pace, slip * random.uniform(0.85, 1.15), turn, (moment - entry) / lap_time))
    points += [(finish + 6, 0.0, 0.0, 0.0, 0.0), (time[-1] + 10, 0.0, 0.0, 0.0, 0.0)]
    table = np.array(points)
    columns = [np.interp(time, table[:, 0], table[:, index]) for index in range(1, 5)]
    return dict(zip(("speed", "slip", "turn", "lap"), columns))


def finish_drive(time, speed, slip, turn, lap=None, load=None, pit=None):
    """The dict of a run; without `load` [N] that of a car with downforce whose load moves across in turns."""
    lateral = turn * np.minimum(speed ** 2 / 60.0, 16.0)
    transfer = np.zeros_like(time) if load is not None else 115.0 * lateral
    if load is None:
        load = STATIC_LOAD + 0.30 * speed ** 2 + transfer
    slowing = np.maximum(0.0, -np.gradient(speed, time))
    braking = np.where(slowing > 1.0, 380.0 * slowing * speed * 0.30, 0.0)
    return dict(time=time, speed=speed, slip=slip, load=np.maximum(load, 250.0), transfer=transfer, braking=braking,
                lap=np.zeros_like(time) if lap is None else lap, pit=np.zeros_like(time) if pit is None else pit)


def race(random, time):
    """Laps from a minute on, until half a minute before the end."""
    laps = drive_laps(random, time, draw_corners(random), random.uniform(40, 70), time[-1] - random.uniform(20, 90))
    return finish_drive(time, laps["speed"], laps["slip"], laps["turn"], laps["lap"])


def pits(random, time):
    """Two stints with some minutes in the pits between them."""
    rows = draw_corners(random)
    stop, go = 0.42 * time[-1], 0.42 * time[-1] + random.uniform(180, 250)
    first = drive_laps(random, time, rows, random.uniform(30, 60), stop)
    second = drive_laps(random, time, rows, go, time[-1] - 20)
    speed, slip, turn, lap = (first[name] + second[name] for name in ("speed", "slip", "turn", "lap"))
    return finish_drive(time, speed, slip, turn, lap, pit=((time > stop + 10) & (time < go - 5)).astype(float))


def durability(random, time):
    """Speed and load in steps on a drum, with one stop; little slip."""
    edges, levels = [0.0, 60.0], [(0.0, 1500.0, 0.0)]
    while edges[-1] < time[-1]:
        stands = len(levels) in (3, 7) and levels[-1][0] > 0
        edges.append(edges[-1] + random.uniform(150, 420))
        speed = 0.0 if stands else random.uniform(55, 185) / 3.6
        levels.append((speed, random.uniform(2200, 7000), np.radians(random.choice([0.0, 0.0, 0.6, 1.2]))))
    starts, levels = np.array(edges[:len(levels)]), np.array(levels)
    corners = np.sort(np.concatenate([starts[1:] - 0.01, starts[1:] + 8.0]))
    held = np.repeat(levels, 2, axis=0)[1:-1]
    speed, load, slip = (np.interp(time, corners, held[:, index]) for index in range(3))
    return finish_drive(time, speed, slip, 0 * time, load=load)


def sweeps(random, time):
    """A bench: blocks of one speed and load, some with the slip angle swept to and fro."""
    speed, load, slip = np.zeros_like(time), np.full_like(time, 1500.0), np.zeros_like(time)
    moment = 40.0
    while moment < time[-1]:
        length = random.uniform(40, 110)
        inside = (time >= moment) & (time < moment + length)
        speed[inside] = 0.0 if random.random() < 0.10 else random.choice([50, 80, 100, 120, 150]) / 3.6
        load[inside] = random.choice([2100, 3200, 4500, 5600, 6800])
        if random.random() < 0.6:
            period, largest = random.uniform(8, 30), np.radians(random.uniform(1.0, 4.0))
            phase = (time[inside] - moment) / period
            slip[inside] = largest * (2 / np.pi) * np.arcsin(np.sin(2 * np.pi * phase))
        moment += length
    smooth = np.ones(5) / 5
    speed, load = np.convolve(speed, smooth, "same"), np.convolve(load, smooth, "same")
    return finish_drive(time, speed, slip, 0 * time, load=load)


def road(random, time):
    """Town with stops, country roads and a motorway."""
    rows, moment = [(0.0, 0.0, 0.0)], 0.0
    while moment < time[-1]:
        top = random.choice([13.9, 19.4, 27.8, 33.3, 38.9])
        gain = top / random.uniform(1.2, 2.4)
        stay = random.uniform(15, 60) if top < 20 else random.uniform(60, 200)
        halt = random.uniform(5, 70) if top < 20 or random.random() < 0.2 else 0.0
        rows += [(moment + halt, 0.0 if halt else rows[-1][1], 0.0), (moment + halt + gain, top, 0.004)]
        moves = np.arange(moment + halt + gain + 5, moment + halt + gain + stay, 9.0)
        rows += [(place, top * random.uniform(0.85, 1.05), random.normal(0, 0.008)) for place in moves]
        moment += halt + gain + stay + top / 2.5
        rows.append((moment, 0.0 if random.random() < 0.7 else top * 0.7, 0.0))
    table = np.array(sorted(rows))
    speed, slip = np.interp(time, table[:, 0], table[:, 1]), np.interp(time, table[:, 0], table[:, 2])
    return finish_drive(time, speed, slip, np.clip(slip / 0.02, -1, 1))


def lateral_force(load, slip, stiffness=62e3, friction=1.08):
    """Lateral force [N], negative for a positive slip angle [rad]."""
    limit = friction * np.maximum(load, 1.0)
    return -limit * np.tanh(stiffness * (load / (load + 900.0)) * slip / limit)


def draw_drive(random, kind):
    """A run of `kind`, with surroundings: air and road [K], steady but for slow changes that are logged."""
    time = np.arange(0.0, MINUTES[kind] * 60 + 0.5 * INTERVAL[kind], INTERVAL[kind])
    drive = globals()[kind](random, time)
    drive["force"] = lateral_force(drive["load"], drive["slip"])
    wave = np.sin(2 * np.pi * (time / random.uniform(900, 2400) + random.random()))
    air = 273.15 + random.uniform(14, 29)
    drive["air"] = air + 0.4 * wave
    drive["road"] = air + random.uniform(2, 16) + 0.8 * wave
    return drive
