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
        row = re.match(r"^(.{30}) (\S.*?) +(\d+) of (\d+) ", line)
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


def exam_dirty(entry, sources, run):
    """Shares, verdicts and gains of the exam on dirty data, as tests/hidden_effects/dirty_exam sums them up."""
    script, *words = entry["record"].split()
    result = sources.scratch / "exam_dirty.json"
    run([str(ROOT / script), *words, "--program", str(sources.program), "--maker",
         str(sources.tests / "truths" / "make_dirty_sets"), "--json", str(result)], ROOT)
    found = json.loads(result.read_text())
    del found["rows"]
    return found


def exam_sets(entry, sources, run):
    """Figures of an exam on dirty data whose sets a `maker` makes on the way."""
    script, *words = entry["record"].split()
    place = sources.scratch / pathlib.Path(entry["maker"]).stem
    result = place / "figures.json"
    run([str(ROOT / entry["maker"]), *words, "--out", str(place / "sets")], ROOT)
    run([str(ROOT / script), *words, "--jobs", "2", "--program", str(sources.program), "--benches",
         str(ROOT / "cases" / "practice"), "--sets", str(place / "sets"), "--out", str(place / "scores"), "--json", str(result)], ROOT)
    return json.loads(result.read_text())


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
    """Parameters from a camera's frames, with what the correction for the grid moved them by."""
    result = json.loads(run([str(sources.program), "identify", "cases/laser/imaging/imaging.toml", "--json", "--out",
                             str(sources.scratch / "imaging")], ROOT))
    names = [one["name"] for one in result["parameters"]]
    return {"parameters": {one["name"]: {key: one[key] for key in ("value", "low", "high", "moved_by_grid_correction")}
                           for one in result["parameters"]},
            "absorptivity_and_emissivity": result["correlation"][names.index("laser.absorptivity")][
                names.index("camera.emissivity")]}


def laser_plans(entry, sources, run):
    """Standard deviations that a plan foresees for cases/laser/identify.toml with one thing changed."""
    folder = ROOT / "cases" / "laser"
    case = (folder / "identify.toml").read_text().replace('file = "', f'file = "{folder}/')

    def changed(old, new, where=""):
        begin = case.index(where)
        if old not in case[begin:]:
            raise ValueError(f"cases/laser/identify.toml has no {old!r}")
        return case[:begin] + case[begin:].replace(old, new)

    def without(name):
        """The case without the table of a list that has this name."""
        tables = re.split(r"(?m)^(?=\[)", case)
        kept = [table for table in tables if f'name = "{name}"' not in table]
        if len(kept) + 1 != len(tables):
            raise ValueError(f"cases/laser/identify.toml has no single {name!r}")
        return "".join(kept)

    beside = '[[sensor]]\nname = "beside_the_spot"\nkind = "point"\nradius = "12 mm"\ndepth = "0 mm"\nstandard_deviation = "0.5 K"\n\n'
    cases = {"as_it_is": case,
             "absorptivity": changed("standard_deviation = 0.03", "standard_deviation = 0.005"),
             "second_place": case.replace("[[parameter]]", beside + "[[parameter]]", 1),
             "films": changed('standard_deviation = "3 W/m2K"', 'standard_deviation = "0.5 W/m2K"'),
             "radius": changed('standard_deviation = "0.1 mm"', 'standard_deviation = "0.01 mm"'),
             "without_one_and_a_half_watts": without("one_and_a_half_watts"),
             "without_three_watts": without("three_watts"),
             "without_probe": without("inner_liner_temperature")}
    asked = {"K1_90": "K1.conductivity at 90 degC", "K2_90": "K2.conductivity at 90 degC",
             "K2_140": "K2.conductivity at 140 degC", "absorptivity": "laser.absorptivity"}
    found = {}
    for name, text in cases.items():
        path = sources.scratch / f"{name}.toml"
        path.write_text(text)
        plan = json.loads(run([str(sources.program), "identify", str(path), "--plan", "--json", "--out",
                               str(sources.scratch / name)], ROOT))
        deviations = {one["name"]: one["standard_deviation"] for one in plan["parameters"]}
        found[name] = {key: deviations[parameter] for key, parameter in asked.items()}
    return found


def hot_spot_study(entry, sources, run):
    """Samples of the hot spot of the whole tire, and how many pass 95 degC."""
    out = sources.scratch / "hot_spot_study"
    run([str(sources.program), "study", "cases/studies/fmvss_139_hot_spot.toml", "--quiet", "--out",
         str(out)], ROOT)
    with open(out / "study.csv", newline="") as file:
        hottest = [float(row["hottest [degC]"]) for row in csv.DictReader(file)]
    above = sum(kelvin > 95.0 for kelvin in hottest)
    z, n = 1.959964, len(hottest)
    p = above / n
    half = z * (p * (1 - p) / n + z * z / (4 * n * n)) ** 0.5
    ends = [(p + z * z / (2 * n) + side * half) / (1 + z * z / n) for side in (-1, 1)]
    return {"samples": n, "mean": statistics.mean(hottest), "standard_deviation": statistics.stdev(hottest),
            "share": p, "low": ends[0], "high": ends[1]}


def benchmarks(entry, sources, run):
    """Seconds and counters of each benchmark, in the median of its repetitions."""
    found = {"machine": machine()}
    for name in ("section_hour", "sensitivities", "layers_step"):
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
            found[name].setdefault(row["run_name"].split("/")[0], one)
    alone = found["sensitivities"]
    for name, kind in (("sensitivities", "with_16"), ("adjoint", "adjoint")):
        ratios = [alone[f"{inputs}_{kind}"]["seconds"] / alone[f"{inputs}_alone"]["seconds"] for inputs in ("constant", "logged")]
        found[f"{name}_low"], found[f"{name}_high"] = min(ratios), max(ratios)
    thomas = found["layers_step"]["thomas_factor_and_solve"]["seconds"]
    found["session_ratio"] = found["layers_step"]["session_step"]["seconds"] / thomas
    return found


def compared(entry, sources, run):
    """benchmarks/compare and benchmarks/threads write their records themselves."""
    script = ROOT / entry["record"].split(",")[0]
    run([str(script)], ROOT)
    return json.loads((ROOT / f"docs/records/{entry['name']}.json").read_text())


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
