#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes sets of dirty data with answers: runs as a user would have them, one run kept back, and what is wrong with them.

    second_dirty_exam.py --first 0 --last 23 --out FOLDER

makes FOLDER/set000 and so on with run1.csv ..., kept_back.csv, answer.json and perfect1.csv ..., which are the runs as sound
instruments and loggers without noise would have them. A set follows from its number alone.
"""
import argparse
import dataclasses
import json
import pathlib

import numpy as np

from drives import INTERVAL, KINDS, MINUTES, RELATED, draw_drive
from hidden_causes import CELSIUS, CHANNELS, Run, draw_causes
from tire_truth import layered_mesh, make_lanes, simulate, two_node_mesh

SHEET = np.array([0.5, 0.3, 0.3])                # K, noise of the channels by their data sheets
SUBSTEPS = 2                                     # of the truth between two samples
KIND_SHARES = (0.30, 0.18, 0.15, 0.20, 0.17)   # race, pits, durability, sweeps, road
FAST = ("race", "pits", "sweeps")                # one set of five has a timing fault on one of these
NULLS = (4, 11, 17)                              # of twenty sets: nothing is hidden
LANE_DRIVES = ("speed", "load", "slip", "force", "air", "road", "wind", "extra_conductance", "extra_temperature", "rim_heat")
MULTIPLIED = ("film_scale", "loss_scale", "friction_scale")


def truth_mesh(base, causes):
    """The mesh on which the truth is computed."""
    return layered_mesh() if base == "layers" or any(cause.layered for cause in causes) else two_node_mesh()


def tire_numbers(scales, causes, run):
    """Numbers of the lane of a run: the tire's two scales and what the causes change."""
    numbers = dict(scales)
    for cause in causes:
        for name, value in (cause.tire(run) if cause.tire else {}).items():
            numbers[name] = numbers.get(name, 1.0) * value if name in MULTIPLIED else value
    return numbers


def what_happens(drive, causes, run):
    """What the tire meets in a run, and what the user reads of it: two dicts of arrays."""
    true, log = dict(drive), dict(drive)
    for cause in causes:
        if cause.world:
            cause.world(true, run)
        if cause.log:
            cause.log(log, drive, run)
    return true, log


def between_samples(signal, time, fine):
    """A signal at finer moments; a number stays one."""
    return np.interp(fine, time, signal) if np.ndim(signal) else np.full_like(fine, signal)


def stack_drives(drives, time, fine):
    """Arrays [moments, lanes] of several runs."""
    missing = dict(wind=0.0, extra_conductance=0.0, extra_temperature=300.0, rim_heat=0.0)
    return {name: np.stack([between_samples(drive.get(name, missing.get(name)), time, fine) for drive in drives], axis=1)
            for name in LANE_DRIVES}


def true_readings(plan, variants):
    """What sound loggers with the variants' instruments would read: for each variant a list of arrays [samples, 3] in K."""
    time = plan["drives"][0]["time"]
    fine = np.linspace(0, time[-1], SUBSTEPS * (time.size - 1) + 1)
    answers = [None] * len(variants)
    for layered in (False, True):
        members = [v for v, causes in enumerate(variants) if any(cause.layered for cause in causes) == layered]
        if not members:
            continue
        pairs = [(v, r) for v in members for r in range(len(plan["runs"]))]
        drives = [what_happens(plan["drives"][r], variants[v], plan["runs"][r])[0] for v, r in pairs]
        numbers = [tire_numbers(plan["scales"], variants[v], plan["runs"][r]) for v, r in pairs]
        names = set().union(*numbers)
        neutral = make_lanes(1)
        lane = make_lanes(len(pairs), **{n: [one.get(n, neutral[n][0]) for one in numbers] for n in names})
        start = np.array([plan["starts"][r] for _, r in pairs])
        field = simulate(truth_mesh(plan["base"], variants[members[0]]), lane, stack_drives(drives, time, fine), fine[1], start)
        for v in members:
            answers[v] = [apply_instruments(field[:, pairs.index((v, r))], fine, variants[v], plan, r) for r in range(len(plan["runs"]))]
    return answers


def apply_instruments(readings, fine, causes, plan, number):
    """Readings at the samples [samples, 3] from temperatures at all moments."""
    drive = plan["drives"][number]
    air = np.interp(fine, drive["time"], drive["air"])
    for cause in causes:
        if cause.instrument:
            readings = cause.instrument(readings, fine, plan["runs"][number], air)
    return readings[::SUBSTEPS]


def base_lanes(free, runs):
    """Numbers and starts of four lanes a run: as they stand, and with film, loss and start changed for the derivatives."""
    film, loss, start = [], [], []
    for parameters in free:
        for run in range(runs):
            film += list(parameters[0] + np.array([0, 0.01, 0, 0]))
            loss += list(parameters[1] + np.array([0, 0, 0.01, 0]))
            start += list(parameters[2 + run] + np.array([0, 0, 0, 0.2]))
    return make_lanes(len(film), film_scale=film, loss_scale=loss), np.array(start)


def solve_step(model, measured, weight, parameters):
    """Next parameters of one variant, and what the fit leaves [K]: one step of Gauss and Newton with the case's priors.

    `model` [samples, runs, 4, channels] and `measured` [samples, runs, channels] in K.
    """
    runs = measured.shape[1]
    left = measured - model[:, :, 0]
    slopes = np.zeros((2 + runs,) + left.shape)
    slopes[0], slopes[1] = (model[:, :, 1] - model[:, :, 0]) / 0.01, (model[:, :, 2] - model[:, :, 0]) / 0.01
    for run in range(runs):
        slopes[2 + run, :, run] = (model[:, run, 3] - model[:, run, 0]) / 0.2
    rows = (slopes * weight).reshape(2 + runs, -1)
    prior = np.array([0.1, 0.1] + [3.0] * runs) ** -2.0
    pull = prior * (np.array([1.0, 1.0] + [0.0] * runs) - parameters)
    change = np.linalg.solve(rows @ rows.T + np.diag(prior), rows @ (left * weight).ravel() + pull)
    return parameters + change, left - np.tensordot(change, slopes, axes=1)


def fit_base(plan, variants, readings):
    """Rms [K] that the base model leaves of each variant's readings once film, loss and starts are fitted; and the fits."""
    runs, time = plan["fitted"], plan["drives"][0]["time"]
    mesh = layered_mesh(16, 8, 2e-4) if plan["base"] == "layers" else two_node_mesh()
    channels = 3 if plan["base"] == "layers" else 2
    logs = [what_happens(plan["drives"][r], causes, plan["runs"][r])[1] for causes in variants for r in range(runs) for _ in range(4)]
    drive = stack_drives(logs, time, time)
    free = [np.concatenate([[1.0, 1.0], np.zeros(runs)]) for _ in variants]
    rms = [0.0] * len(variants)
    for _ in range(3):
        lane, shift = base_lanes(free, runs)
        field = simulate(mesh, lane, drive, time[1], drive["air"][0] + shift)[..., :channels]
        field = field.reshape(time.size, len(variants), runs, 4, channels)
        for v in range(len(variants)):
            measured = np.stack(readings[v][:runs], axis=1)[..., :channels]
            free[v], left = solve_step(field[:, v], measured, 1 / SHEET[:channels], free[v])
            free[v][:2] = np.clip(free[v][:2], 0.2, 3.0)
            rms[v] = float(np.sqrt(np.mean(left ** 2)))
    return rms, free


def draw_noise(random, shape, interval, noise):
    """Noise [K] of [samples, 3]: 70 % of its variance follows itself, 30 % is white."""
    keep = noise["correlation_1s"] ** interval
    slow = random.normal(size=shape)
    for sample in range(1, shape[0]):
        slow[sample] = keep * slow[sample - 1] + np.sqrt(1 - keep ** 2) * slow[sample]
    return np.array(noise["sigma"]) * (np.sqrt(0.7) * slow + np.sqrt(0.3) * random.normal(size=shape))


def write_run(path, log, readings, quantum, channels):
    """A CSV file as a user has it; `readings` [samples, 3] in K, written in steps of `quantum` [K]."""
    header = ["time [s]", "speed [km/h]", "vertical_load [N]", "slip_angle [deg]", "lateral_force [N]", "air_temperature [degC]",
              "road_temperature [degC]"] + [f"{name} [degC]" for name in CHANNELS[:channels]]
    celsius = np.round((readings[:, :channels] - CELSIUS) / quantum) * quantum
    columns = [log["time"], log["speed"] * 3.6, log["load"], np.degrees(log["slip"]), log["force"], log["air"] - CELSIUS,
               log["road"] - CELSIUS] + list(celsius.T)
    formats = ["%.1f", "%.2f", "%.1f", "%.4f", "%.1f", "%.1f", "%.1f"] + ["%.2f"] * channels
    np.savetxt(path, np.column_stack(columns), fmt=",".join(formats), header=",".join(header), comments="")


def plan_set(number):
    """All that is drawn for a set but its noise."""
    random = np.random.default_rng(number)
    base = "two_node" if number % 3 == 2 else "layers"
    timing = number % 5 == 3
    kind, fitted = str(random.choice(FAST if timing else KINDS, p=None if timing else KIND_SHARES)), int(random.choice([1, 2, 3, 3]))
    kinds = [kind] * fitted + [str(random.choice(RELATED[kind]))]
    drives = [draw_drive(random, one) for one in kinds]
    runs = [Run(index, index == fitted - 1, index == fitted) for index in range(fitted + 1)]
    starts = [drive["air"][0] + (0.0 if run.kept else random.normal(0, 2)) for drive, run in zip(drives, runs)]
    scales = dict(film_scale=float(np.clip(random.normal(1, 0.08), 0.8, 1.2)), loss_scale=float(np.clip(random.normal(1, 0.08), 0.8, 1.2)))
    causes = draw_causes(random, base, kind, fitted, timing)
    if number % 20 in NULLS:
        causes = []
    loud = random.random() < (0.34 if not causes else 0.12)
    noise = dict(sigma=[float(s) for s in SHEET * random.uniform(0.8, 1.05, 3) * (2.0 if loud else 1.0)], doubled=bool(loud),
                 correlation_1s=float(random.uniform(0.6, 0.95)), quantum=float(random.choice([0.01, 0.1, 0.1, 0.1, 0.5])))
    return dict(number=number, base=base, kind=kind, kinds=kinds, fitted=fitted, drives=drives, runs=runs, starts=starts, scales=scales,
                causes=causes, noise=noise, random=random)


def write_perfect_runs(folder, plan, channels):
    """The runs that are fitted with true inputs and what sound instruments read of them, without noise."""
    sound = [dataclasses.replace(cause, instrument=None) for cause in plan["causes"]]
    [readings] = true_readings(plan, [sound])
    for drive, run in zip(plan["drives"][:plan["fitted"]], plan["runs"]):
        true, _ = what_happens(drive, sound, run)
        write_run(folder / f"perfect{run.index + 1}.csv", true, readings[run.index], 0.01, channels)


def describe(plan, rms, free):
    """The answer: causes by size, largest first."""
    named = [dict(name=cause.name, size=size, ids=cause.ids, words=cause.words, unknown=cause.unknown, channels=cause.channels,
                  timing=cause.timing, numbers=cause.numbers, values=cause.values, strength_free=dict(film=fit[0], loss=fit[1]))
             for cause, size, fit in zip(plan["causes"], rms[1:], free[1:])]
    return dict(number=plan["number"], base=plan["base"], kind=plan["kind"], kept_back_kind=plan["kinds"][-1], runs=plan["fitted"],
                minutes=MINUTES[plan["kind"]], interval=INTERVAL[plan["kind"]], nothing_hidden=not plan["causes"], true=plan["scales"],
                fitted_to_all_causes=dict(film_scale=free[0][0], loss_scale=free[0][1], rms=rms[0]), noise=plan["noise"],
                causes=sorted(named, key=lambda cause: -cause["size"]))


def make_set(number, folder):
    """Writes one set into `folder`."""
    plan = plan_set(number)
    variants = [plan["causes"]] + [[cause] for cause in plan["causes"]]
    readings = true_readings(plan, variants)
    rms, free = fit_base(plan, variants, readings)
    folder.mkdir(parents=True, exist_ok=True)
    channels, interval = (3 if plan["base"] == "layers" else 2), INTERVAL[plan["kind"]]
    for index, (drive, run) in enumerate(zip(plan["drives"], plan["runs"])):
        noisy = readings[0][index] + draw_noise(plan["random"], readings[0][index].shape, interval, plan["noise"])
        _, log = what_happens(drive, plan["causes"], run)
        name = "kept_back.csv" if run.kept else f"run{index + 1}.csv"
        write_run(folder / name, log, noisy, plan["noise"]["quantum"], channels)
    write_perfect_runs(folder, plan, channels)
    text = json.dumps(describe(plan, rms, free), indent=1, default=float)
    (folder / "answer.json").write_text(text + "\n")


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--first", type=int, default=0, help="number of the first set")
    parser.add_argument("--last", type=int, default=23, help="number of the last set")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder of the sets")
    arguments = parser.parse_args()
    for number in range(arguments.first, arguments.last + 1):
        make_set(number, arguments.out / f"set{number:03d}")


if __name__ == "__main__":
    main()
