#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes sets of dirty data with answers: many small faults at once in each, read by instruments that are slow and late.

    third_dirty_exam.py --first 0 --last 31 --out FOLDER

makes FOLDER/set000 and so on with run1.csv ..., kept_back.csv, answer.json and perfect1.csv ..., which are the runs as sound
instruments and loggers without noise would have them. A set follows from its number alone. With --sound nothing
is hidden, film and loss are those of the bench, and there is no noise: what the truth and the base model differ by.
"""
import argparse
import json
import pathlib

import numpy as np

from causes import COMP, answer, draw_causes, log_of, through_instruments
from programmes import CELSIUS, KINDS, draw_programme
from rolling_tire import LANE, layered_mesh, simulate, two_lumps

CHANNELS = ("surface_temperature", "bulk_temperature", "inner_liner_temperature")
SHEET = np.array([0.5, 0.3, 0.3])                # K, noise of the channels by their data sheets
STEPS = 4                                        # of the truth in a second
NULLS = (3, 9, 16)                               # of twenty sets: nothing is hidden
INTERVALS = {1.0: 0.60, 0.2: 0.18, 2.0: 0.08, 4.0: 0.14}         # s between samples, and their shares
COARSE = dict(tread=18, carcass=8, first=2e-4)   # elements of the model that is fitted
NUDGES = np.array([0.01, 0.01, 0.2])             # of film, loss and start [K], for derivatives


def plan_set(number, sound=False):
    """All that is drawn for a set but its noise. `sound`: nothing is hidden and nothing unknown."""
    random = np.random.default_rng((3, number))
    base = "layers" if random.random() < 0.55 else "two_node"
    kind = str(random.choice(list(KINDS), p=list(KINDS.values())))
    fitted, minutes = int(random.choice([1, 2, 3], p=[0.25, 0.15, 0.60])), float(random.choice([12.0, 14.0, random.uniform(11, 25)]))
    interval = float(random.choice(list(INTERVALS), p=list(INTERVALS.values())))
    programmes = [draw_programme(random, kind, minutes, interval) for _ in range(fitted + 1)]
    causes = draw_causes(random, base)
    lam = dict(lam_h=float(np.clip(random.normal(1, 0.09), 0.8, 1.2)), lam_sel=float(np.clip(random.normal(1, 0.10), 0.75, 1.25)))
    noise = dict(sig=random.uniform([0.2, 0.12, 0.1], [0.5, 0.3, 0.3]).tolist(), rho=float(random.uniform(0.70, 0.92)))
    defects = dict(quant=float(random.choice([0.1, 0.5])), frozen=bool(random.random() < 0.3), clip=bool(random.random() < 0.1))
    starts = [programme["air"][0] + random.normal(0, 1.5) for programme in programmes]
    starts[-1] = programmes[-1]["air"][0]
    if sound or number % 20 in NULLS:
        causes, defects["frozen"], defects["clip"] = {}, False, False
    if sound:
        lam, starts = dict.fromkeys(lam, 1.0), [programme["air"][0] for programme in programmes]
        noise["sig"], defects["quant"] = [0.0, 0.0, 0.0], 0.01
    return dict(number=number, base=base, kind=kind, fitted=fitted, minutes=minutes, interval=interval, programmes=programmes,
                causes=causes, lam=lam, noise=noise, defects=defects, starts=starts, random=random)


def numbers_of(causes):
    """All numbers of some causes, in one dict."""
    return {key: value for numbers in causes.values() for key, value in numbers.items()}


def moments(seconds, parts):
    """Moments [s] that cut each second into `parts`."""
    return np.linspace(0, seconds[-1], parts * (seconds.size - 1) + 1)


def stacked(programmes, time):
    """Arrays [moments, lanes] of several programmes at other moments [s]."""
    return {name: np.stack([np.interp(time, one["time"], one[name]) for one in programmes], axis=1)
            for name in ("speed", "load", "slip", "force", "air", "road")}


def true_readings(plan, variants):
    """What loggers without noise would read each second, for each variant a list of arrays [seconds, 3] in K; the run that is
    kept back for the first variant alone."""
    pairs = [(v, r) for v in range(len(variants)) for r in range(plan["fitted"] + (v == 0))]
    numbers = [numbers_of(causes) for causes in variants]
    rows = [plan["lam"] | {key: value for key, value in numbers[v].items() if key in LANE} for v, _ in pairs]
    seconds = plan["programmes"][0]["time"]
    time = moments(seconds, STEPS)
    drive = stacked([plan["programmes"][r] for _, r in pairs], moments(seconds, 2 * STEPS))
    mesh = layered_mesh() if plan["base"] == "layers" else two_lumps()
    field = simulate(mesh, rows, drive, time[1], np.array([plan["starts"][r] for _, r in pairs]))
    found = [[] for _ in variants]
    for lane, (v, _) in enumerate(pairs):
        found[v].append(through_instruments(field[:, lane], time, drive["air"][::2, lane], numbers[v])[::STEPS])
    return found


def base_readings(plan, logs, free):
    """The base model each second, fed with logs at their interval: [seconds, lanes, channels]; `free` [lanes, 3] is film, loss
    and start [K]."""
    seconds = plan["programmes"][0]["time"]
    sampled = seconds[::max(1, round(plan["interval"]))]
    between = lambda log: {name: np.interp(seconds, sampled, np.interp(sampled, seconds, signal)) for name, signal in log.items()}
    mesh = layered_mesh(**COARSE) if plan["base"] == "layers" else two_lumps()
    rows = [dict(lam_h=film, lam_sel=loss) for film, loss, _ in free]
    drive = stacked([between(log) for log in logs], moments(seconds, 2))
    return simulate(mesh, rows, drive, 1.0, np.array(free)[:, 2])[..., :channels_of(plan)]


def channels_of(plan):
    """How many channels the base has."""
    return 3 if plan["base"] == "layers" else 2


def solve_step(model, measured, weight, parameters, plan):
    """Parameters of one variant after a step of Gauss and Newton with the case's priors, and what it leaves [K].

    `model` [seconds, runs, 4, channels] and `measured` [seconds, runs, channels] in K.
    """
    runs = measured.shape[1]
    left = measured - model[:, :, 0]
    slopes = np.zeros((2 + runs,) + left.shape)
    slopes[:2] = np.moveaxis((model[:, :, 1:3] - model[:, :, :1]), 2, 0) / NUDGES[:2, None, None, None]
    for run in range(runs):
        slopes[2 + run, :, run] = (model[:, run, 3] - model[:, run, 0]) / NUDGES[2]
    flat = (slopes * weight).reshape(2 + runs, -1)
    prior = np.array([0.1, 0.1] + [3.0] * runs) ** -2.0
    middle = np.array([1.0, 1.0] + [programme["air"][0] for programme in plan["programmes"][:runs]])
    change = np.linalg.solve(flat @ flat.T + np.diag(prior), flat @ (left * weight).ravel() + prior * (middle - parameters))
    return parameters + change, left - np.tensordot(change, slopes, axes=1)


def fit_base(plan, variants, measured):
    """Rms [K] that the base leaves of each variant's readings [seconds, runs, channels] once film, loss and starts are fitted,
    and what these become."""
    runs, every = plan["fitted"], max(1, round(plan["interval"]))
    logs = [log_of(programme, numbers_of(causes)) for causes in variants for programme in plan["programmes"][:runs] for _ in range(4)]
    found = [np.array([plan["lam"]["lam_h"], plan["lam"]["lam_sel"]] + plan["starts"][:runs]) for _ in variants]
    rms = [0.0] * len(variants)
    nudged = np.vstack([np.zeros(3), np.diag(NUDGES)])
    for _ in range(2):
        free = np.concatenate([one[[0, 1, 2 + run]] + nudged for one in found for run in range(runs)])
        model = base_readings(plan, logs, free)
        model = model.reshape(model.shape[0], len(variants), runs, 4, -1)[::every]
        for v, one in enumerate(measured):
            found[v], left = solve_step(model[:, v], one[::every], 1 / SHEET[:channels_of(plan)], found[v], plan)
            rms[v] = float(np.sqrt(np.mean(left ** 2)))
    return rms, found


def sizes(plan, variants, readings):
    """What each variant but the last, which has no cause, changes beyond film, loss and starts [K]; then what the last leaves by
    itself; and the fits."""
    runs = plan["fitted"]
    stack = lambda one: np.stack(one[:runs], axis=1)[..., :channels_of(plan)]
    lam = [plan["lam"]["lam_h"], plan["lam"]["lam_sel"]]
    sound = base_readings(plan, plan["programmes"][:runs], [[*lam, start] for start in plan["starts"][:runs]])
    nothing = stack(readings[-1])
    return fit_base(plan, variants, [sound + stack(one) - nothing for one in readings[:-1]] + [nothing])


def add_noise(plan, readings, interval):
    """Noise of which 70 % of the variance follows itself."""
    random, keep = plan["random"], plan["noise"]["rho"] ** interval
    slow = random.normal(size=readings.shape)
    for sample in range(1, len(slow)):
        slow[sample] = keep * slow[sample - 1] + np.sqrt(1 - keep ** 2) * slow[sample]
    return readings + np.array(plan["noise"]["sig"]) * (np.sqrt(0.7) * slow + np.sqrt(0.3) * random.normal(size=readings.shape))


def write_readings(plan, readings):
    """Readings [samples, 3] in degC at the log's interval, from those of each second [K]: noise, defects of the tread's sensor,
    steps; a log that is quicker than its sensors has straight lines between."""
    random, defects, interval = plan["random"], plan["defects"], plan["interval"]
    slow = max(1.0, interval)
    celsius = add_noise(plan, readings[::round(slow)] - CELSIUS, slow)
    if defects["clip"]:
        defects.setdefault("clip_at", float(np.quantile(celsius[:, 0], random.uniform(0.93, 0.995))))
        celsius[:, 0] = np.minimum(celsius[:, 0], defects["clip_at"])
    if defects["frozen"]:
        begin = random.integers(10, len(celsius) - 60 // round(slow))
        celsius[begin:begin + round(random.uniform(20, 45) / slow), 0] = celsius[begin, 0]
    steps = np.array([defects["quant"], *[min(0.1, defects["quant"])] * 2])
    celsius = np.round(celsius / steps) * steps
    if interval < 1:
        time = np.arange(0, len(celsius) - 1 + 0.5 * interval, interval)
        celsius = np.stack([np.interp(time, np.arange(len(celsius)), column) for column in celsius.T], axis=1)
    return celsius


def write_run(path, plan, log, celsius):
    """A CSV file as a user has it."""
    channels, time = channels_of(plan), np.arange(len(celsius)) * plan["interval"]
    now = {name: np.interp(time, log["time"], signal) for name, signal in log.items()}
    header = ["time [s]", "speed [km/h]", "vertical_load [N]", "slip_angle [deg]", "lateral_force [N]", "air_temperature [degC]",
              "road_temperature [degC]"] + [f"{name} [degC]" for name in CHANNELS[:channels]]
    columns = [time, now["speed"] * 3.6, now["load"], np.degrees(now["slip"]), now["force"], now["air"] - CELSIUS, now["road"] - CELSIUS]
    formats = ["%.1f", "%.2f", "%.1f", "%.4f", "%.1f", "%.1f", "%.1f"] + ["%.2f"] * channels
    np.savetxt(path, np.column_stack([*columns, celsius[:, :channels]]), fmt=",".join(formats), header=",".join(header), comments="")


def write_perfect_runs(folder, plan):
    """The runs that are fitted with true inputs and what sound instruments read of them, without noise."""
    [readings] = true_readings(plan, [{name: numbers for name, numbers in plan["causes"].items() if name in COMP}])
    interval = plan["interval"]
    for run in range(plan["fitted"]):
        programme, celsius = plan["programmes"][run], readings[run] - CELSIUS
        time = np.arange(0, programme["time"][-1] + 0.5 * interval, interval)
        sampled = np.stack([np.interp(time, programme["time"], column) for column in celsius.T], axis=1)
        write_run(folder / f"perfect{run + 1}.csv", plan, programme, sampled)


def describe(plan, rms, fits):
    """The answer: causes by size, largest first."""
    entries = [answer(name, numbers, size) for (name, numbers), size in zip(plan["causes"].items(), rms[1:])]
    return dict(number=plan["number"], base=plan["base"], kind=plan["kind"], runs=plan["fitted"], minutes=plan["minutes"],
                interval=plan["interval"], nothing_hidden=not plan["causes"],
                true=dict(film_scale=plan["lam"]["lam_h"], loss_scale=plan["lam"]["lam_sel"]),
                fitted_to_all_causes=dict(film_scale=fits[0][0], loss_scale=fits[0][1], rms=rms[0]), left_without_causes=rms[-1],
                noise=plan["noise"], defects=plan["defects"], causes=sorted(entries, key=lambda entry: -entry["size"]))


def make_set(number, folder, sound=False):
    """Writes one set into `folder`."""
    plan = plan_set(number, sound)
    variants = [plan["causes"]] + [{name: numbers} for name, numbers in plan["causes"].items()] + [{}]
    readings = true_readings(plan, variants)
    rms, fits = sizes(plan, variants, readings)
    folder.mkdir(parents=True, exist_ok=True)
    for run, programme in enumerate(plan["programmes"]):
        celsius = write_readings(plan, readings[0][run])
        name = "kept_back.csv" if run == plan["fitted"] else f"run{run + 1}.csv"
        write_run(folder / name, plan, log_of(programme, numbers_of(plan["causes"])), celsius)
    write_perfect_runs(folder, plan)
    (folder / "answer.json").write_text(json.dumps(describe(plan, rms, fits), indent=1, default=float) + "\n")


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--first", type=int, default=0, help="number of the first set")
    parser.add_argument("--last", type=int, default=23, help="number of the last set")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder of the sets")
    parser.add_argument("--sound", action="store_true", help="nothing is hidden, no noise, film and loss of the bench")
    arguments = parser.parse_args()
    for number in range(arguments.first, arguments.last + 1):
        make_set(number, arguments.out / f"set{number:03d}", arguments.sound)


if __name__ == "__main__":
    main()
