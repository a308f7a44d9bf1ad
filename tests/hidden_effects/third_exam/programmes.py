# SPDX-License-Identifier: BSD-3-Clause
"""Programmes of driving, as knots a second apart: laps of a circuit, blocks on a bench, an oval.

Each function draws one run and returns speed [m/s], load [N] and slip [rad] at `time` [s]; between knots they are straight.
"""
import numpy as np

KINDS = {"race": 0.42, "bench": 0.35, "oval": 0.23}             # and their shares
TOP_SPEED = 75.0                                                # m/s
CELSIUS = 273.15                                                # K
STIFFNESS, FRICTION = 60e3, 1.05                                # N/rad, 1


def draw_circuit(random):
    """Corners of a circuit, each (top speed [m/s] before it, speed in it, seconds to the top, of braking, in it, slip [rad])."""
    corners = []
    for _ in range(random.integers(5, 12)):
        inside = random.uniform(12, 42)
        top = min(TOP_SPEED, inside + random.uniform(6, 45))
        slip = np.radians(random.uniform(0.8, 3.7)) * random.choice([-1, 1])
        corners.append((top, inside, random.integers(3, 11), random.integers(2, 4), random.integers(3, 7), slip))
    return corners


def drive_lap(random, corners):
    """Knots [seconds, 3] of one lap: speed, slip, share of the transfer of load."""
    knots = []
    for top, inside, rises, falls, stays, slip in corners:
        pace, grip = random.uniform(0.97, 1.02), random.uniform(0.93, 1.07)
        begin = knots[-1][0] if knots else 15.0
        knots += [(speed, 0.0, 0.0) for speed in np.linspace(begin, top * pace, rises + 1)[1:]]
        knots += [(speed, 0.0, 0.0) for speed in np.linspace(top * pace, inside * pace, falls + 1)[1:]]
        knots += [(inside * pace * (1 + 0.01 * second), slip * grip, np.sign(slip)) for second in range(stays)]
    return knots


def with_load(random, time, speed, slip, turn):
    """Load of a wheel: its share of the car, downforce, and what moves across in turns and to and fro."""
    transfer = random.uniform(1000, 1500) * turn * np.minimum(1.0, (speed / 25.0) ** 2)
    along = -random.uniform(15, 30) * np.gradient(speed, time)
    load = random.uniform(3200, 3700) + random.uniform(0.3, 0.6) * speed ** 2 + transfer + along
    return speed, np.maximum(load, 300.0), slip


def race(random, time):
    """Laps of one circuit, of which no two are alike; in half of the runs the car stands for some minutes."""
    circuit, knots = draw_circuit(random), []
    while len(knots) < time.size:
        knots += drive_lap(random, circuit)
    speed, slip, turn = np.array(knots[:time.size]).T
    if random.random() < 0.5:
        begin = random.integers(time.size // 3, time.size - 60)
        stands = slice(begin, begin + random.integers(50, 200))
        speed[stands], slip[stands], turn[stands] = 0.0, 0.0, 0.0
    return with_load(random, time, speed, slip, turn)


def bench(random, time):
    """Blocks of one speed, load and slip angle, with ramps of some seconds; without load for half a minute, and at rest at times."""
    edges, levels = [0.0], [(0.0, 0.0, 0.0)]
    moment = random.uniform(25, 40)
    while moment < time[-1]:
        rests = random.random() < 0.2
        speed, load = (0.0, 190.0) if rests else (random.uniform(45, 180) / 3.6, random.uniform(1800, 6800))
        slip = 0.0 if rests or random.random() < 0.5 else np.radians(random.uniform(-2.2, 2.2))
        ramp = random.uniform(2, 5)
        edges += [moment, moment + ramp]
        levels += [levels[-1], (speed, load, slip)]
        moment += ramp + random.uniform(60, 320)
    levels = np.array(levels)
    return tuple(np.interp(time, edges, column) for column in levels.T)


def oval(random, time):
    """Steady laps between two speeds, loaded in the banked turns; stints of some minutes with slow laps between."""
    straight, turn_speed = random.uniform(40, 65), random.uniform(0.8, 1.0)
    lap = random.uniform(35, 70)
    phase = 2 * np.pi * time / lap
    inside = np.clip(1.5 * np.sin(2 * phase), 0.0, 1.0)
    stint = random.uniform(180, 400)
    slow = np.interp(time % (stint + 70), [0, 15, stint, stint + 20, stint + 50, stint + 70], [0.45, 1, 1, 0.45, 0.45, 0.45])
    speed = straight * slow * (1 - (1 - turn_speed) * inside)
    slip = -np.radians(random.uniform(0.4, 1.8)) * inside * slow * random.uniform(0.9, 1.1, time.size)
    load = random.uniform(3300, 4600) + (0.25 * speed ** 2 + random.uniform(400, 1500) * slow ** 2) * inside
    return speed, load, slip


def lateral_force(load, slip):
    """Lateral force [N], negative for a positive slip angle."""
    limit = FRICTION * np.maximum(load, 1.0)
    return -limit * np.tanh(STIFFNESS * slip / limit)


def draw_programme(random, kind, minutes, interval):
    """A run: a dict of arrays at knots a second apart, with air and road [K]; straight between samples `interval` [s] apart."""
    time = np.arange(4 * round(15 * minutes) + 1.0)
    speed, load, slip = {"race": race, "bench": bench, "oval": oval}[kind](random, time)
    wave = np.sin(2 * np.pi * (time / random.uniform(1500, 4000) + random.random()))
    air = CELSIUS + random.uniform(13, 33) + random.uniform(0.1, 0.7) * (wave - wave[0])
    road = np.full_like(time, air[0] + random.uniform(0.5, 13.0))
    run = dict(time=time, speed=speed, load=load, slip=slip, force=lateral_force(load, slip), air=air, road=road)
    every = max(1, round(interval))
    return {name: np.interp(time, time[::every], signal[::every]) for name, signal in run.items()}
