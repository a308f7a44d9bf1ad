# SPDX-License-Identifier: BSD-3-Clause
"""How docs/figures --record makes the files of this folder: one function a `reader` of docs/figures.toml.

Each runs a command that takes too long for every check, and returns what the pages need of it. `run` is docs/figures' own.
"""

import csv
import json
import os
import pathlib
import re
import resource
import statistics

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def machine():
    """Processor and number of threads: times mean nothing without them."""
    name = next((line.split(":")[1].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
                 if line.startswith("model name")), "unknown processor")
    return f"{name}, {os.cpu_count()} threads"


# What the table of the long test asks (tests/hidden_effects/exam/exam_table.cpp), by the names that the pages use.
QUESTIONS = {
    "no_false_alarm": r"^no false alarm",
    "detected": r"^detected",
    "first_or_confounded": r"^(right name|true effect).* first, or",
    "in_set": r"^(truth|true .*) in the set, when detected",
    "no_wrong_name": r"^no wrong name",
    "first_pair": r"^the first pair",
    "pair_alone": r"^both and nothing else$",
    "recognised": r"^recognised as unknown",
    "place": r"^its place",
    "signal": r"^its signal",
    "size": r"^size within its interval",
}


def exam(entry, sources, run):
    """Shares of right answers of ExamBenchLong, from the table that it prints: {group: {question: [right, count]}}"""
    words = entry["record"].split()
    environment = dict(word.split("=", 1) for word in words if re.match(r"^[A-Z_]+=", word))
    filters = [word for word in words if word.startswith("--")]
    text = run([str(sources.tests / "test_hidden_effects"), *filters], sources.tests, environment)
    head = re.search(r"(\d{4}-\d\d-\d\d) \d\d:\d\d, (\w+), seeds (\d+) to (\d+), (\d+)", text)
    shares = {}
    for line in text.splitlines():
        row = re.match(r"^(.{30}) (.{40}) +(\d+) of (\d+) ", line)
        if row is None:
            continue
        for key, pattern in QUESTIONS.items():
            if re.search(pattern, row.group(2).strip()):
                shares.setdefault(row.group(1).strip(), {})[key] = [int(row.group(3)), int(row.group(4))]
    singles = [group for name, group in shares.items() if ", single," in name]

    def total(key):
        return [sum(group[key][i] for group in singles) for i in (0, 1)]

    return {"papers": int(head.group(5)), "first_seed": int(head.group(3)), "shares": shares,
            "singles_first": total("first_or_confounded")[0], "singles_in_set": total("in_set")[0],
            "singles_sizes": total("size")}


def coverage(entry, sources, run):
    """How many intervals hold the truth, from the rows that the long tests print (tests/support/coverage.hpp)."""
    text = run([str(sources.tests / "test_hidden_effects"), "--gtest_filter=*RecoveryLong.*"], sources.tests)
    found = {"bench": {}, "laser": {}}
    for line in text.splitlines():
        row = re.match(r"^(.{32}) +\d+ of +\d+ +([\d.]+) % .*bias/width ([-+.\d]+)", line)
        if row:
            name = row.group(1).strip()
            law = re.match(r"(K[12])\.conductivity at (\d+)", name)
            found["laser" if law or "laser" in name or "still_air" in name else "bench"][
                f"{law.group(1)} {law.group(2)}" if law else name] = {
                    "share": float(row.group(2)), "bias": float(row.group(3))}
    return found


def imaging(entry, sources, run):
    """K1 at 90 degC from a camera's frames."""
    result = json.loads(run([str(sources.program), "identify", "cases/laser/imaging/imaging.toml", "--json", "--out",
                             str(sources.scratch / "imaging")], ROOT))
    one = next(p for p in result["parameters"] if p["name"] == "K1.conductivity at 90 degC")
    return {"K1_90": {key: one[key] for key in ("value", "low", "high")}}


def hot_spot_study(entry, sources, run):
    """Samples of the hot spot of the whole tire, and how many pass 110 degC."""
    out = sources.scratch / "hot_spot_study"
    run([str(sources.program), "study", "cases/studies/fmvss_139_hot_spot.toml", "--quiet", "--no-pictures", "--out",
         str(out)], ROOT)
    with open(out / "study.csv", newline="") as file:
        hottest = [float(row["hottest [degC]"]) for row in csv.DictReader(file)]
    above = sum(kelvin > 110.0 for kelvin in hottest)
    z, n = 1.959964, len(hottest)
    p = above / n
    half = z * (p * (1 - p) / n + z * z / (4 * n * n)) ** 0.5
    ends = [(p + z * z / (2 * n) + side * half) / (1 + z * z / n) for side in (-1, 1)]
    return {"samples": n, "mean": statistics.mean(hottest), "standard_deviation": statistics.stdev(hottest),
            "share": p, "low": ends[0], "high": ends[1]}


def benchmarks(entry, sources, run):
    """Seconds and counters of each benchmark, in the median of its repetitions."""
    found = {"machine": machine()}
    for name in ("section_hour", "sensitivities", "slab"):
        report = sources.scratch / f"{name}.json"
        run([str(sources.benchmarks / f"bench_{name}"), f"--benchmark_out={report}", "--benchmark_out_format=json"], ROOT)
        found[name] = {}
        for row in json.loads(report.read_text())["benchmarks"]:
            if row["run_type"] == "aggregate" and row["aggregate_name"] != "median":
                continue
            unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[row["time_unit"]]
            seconds = row["real_time"] * unit
            one = {"seconds": seconds}
            if "steps" in row:
                one["steps"] = int(row["steps"])
            for part in ("assembly", "factor", "solve", "output"):
                if f"{part}_s" in row:
                    one[part] = row[f"{part}_s"] / seconds
            found[name][row["run_name"].split("/")[0]] = one
    alone = found["sensitivities"]
    ratios = [alone[f"{inputs}_with_16"]["seconds"] / alone[f"{inputs}_alone"]["seconds"] for inputs in ("constant", "logged")]
    found["sensitivities_low"], found["sensitivities_high"] = min(ratios), max(ratios)
    found["slab_ratio"] = found["slab"]["slab_by_cvode"]["seconds"] / found["slab"]["slab_by_tiretherm"]["seconds"]
    return found


def diagnosis_times(entry, sources, run):
    """Simulations and processor seconds of a diagnosis of each bench: seconds of the clock depend on what else runs."""
    puzzle = [word for i in (1, 2, 3) for word in ("--data", f"cases/practice/puzzle{i}.csv")]
    calls = {"two_node": ["two_node_bench"], "two_node_puzzle": ["two_node_bench", *puzzle],
             "layers": ["layers_bench"], "section": ["section_bench"], "laser": ["laser_bench"]}
    found = {"machine": machine()}
    for name, (case, *more) in calls.items():
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        result = json.loads(run([str(sources.program), "diagnose", f"cases/practice/{case}.toml", *more, "--json", "--out",
                                 str(sources.scratch / name)], ROOT))
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        found[name] = {"simulations": result["simulations"],
                       "cpu": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}
    return found
