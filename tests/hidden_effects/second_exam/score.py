#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Diagnoses sets of dirty data with the program and compares its answers with theirs.

    score.py --program tiretherm --benches cases/practice --sets FOLDER --first 0 --last 23 --out SCORES [--jobs 2] [--json FILE]

The sets are those of the second or of the third exam. Each set: `diagnose` of its base, `identify` of the base with correlated and with white noise, `compare` of both and of the extended
case on the run that was kept back. SCORES/scores.json keeps what was measured, so that a call goes on where one was interrupted;
what was found is judged anew by each call. A * stands for a true cause that was found by id, ~ by its place or in words.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile

CPU_LIMIT = 200                                  # s of a set's diagnosis, then it is ended and counted
WORSE = 1.02                                     # a prediction is worse from this ratio of rms on
VISIBLE = 0.1                                    # K, below which nobody is asked to find a cause
# Tables of an extended case that perfect runs have no use for: faults of instruments and logs, and the runs with the faults.
OF_FAULTS = re.compile(r"\[(effects\.(sensor_|camera_emissivity|clock_|input_delay|slip_angle_offset|initial_temperature|\w+_input_gain"
                       r"|\w+_temperature_drift)|\[run\]|data\b)")
# Free numbers of the case: key in answer.json, and what the case has.
OF_THE_CASE = {"air_convection.lambda_h": ("film_scale", 1.0), "strain_energy_loss.tan_delta_a": ("loss_scale", 2.14e15)}
TIMING_IDS = {"sensor_lag", "clock_delay", "input_delay", "clock_rate"}


def run_program(arguments, log):
    """Runs the program for CPU_LIMIT at most; returns exit code, CPU seconds and what it printed. What goes wrong is written to
    `log`."""
    words = [str(word) for word in arguments]
    limited = ["/bin/sh", "-c", f'ulimit -t {CPU_LIMIT} && exec "$@"', "sh", *words]
    with tempfile.TemporaryFile("w+") as told:
        process = subprocess.Popen(limited, stdout=subprocess.PIPE, stderr=told, stdin=subprocess.DEVNULL, text=True)
        text = process.stdout.read()
        process.stdout.close()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            told.seek(0)
            log.write(f"exit {process.returncode}: {' '.join(words)}\n{told.read(2000)}\n")
    return process.returncode, used.ru_utime + used.ru_stime, text


def write_bases(folder, bench, keep_candidates):
    """base.toml, the bench as it is but free to name every effect, and base_white.toml with white noise."""
    unset = "" if keep_candidates else 'unset = ["diagnose"]\n'
    (folder / "base.toml").write_text(f'include = ["{bench.resolve()}"]\n{unset}')
    (folder / "base_white.toml").write_text('include = ["base.toml"]\n\n[identify]\nnoise = "white"\n')


def kept_rms(program, case, kept_back, out, log):
    """Rms [K] of all channels together on the run that was kept back, or None."""
    if not case.exists():
        return None
    code, _, text = run_program([program, "compare", case, "--data", kept_back, "--out", out, "--json", "--no-report"], log)
    if code != 0:
        return None
    channels = json.loads(text)["channels"]
    samples = sum(channel["samples"] for channel in channels)
    return (sum(channel["samples"] * channel["rmse"] ** 2 for channel in channels) / samples) ** 0.5


def spoken_text(found):
    """All sentences of a diagnosis, in one."""
    parts = [found.get("reason"), found.get("remarks"), found.get("findings"), found.get("warnings")]
    parts += [run.get("reason") for run in found.get("runs", [])]
    return json.dumps(parts)


def named_causes(found):
    """(id, channel or None, entry or None) of what stands in the set."""
    entries = [cause for cause in found.get("causes", []) if cause.get("in_set")]
    named = [(cause["id"], cause.get("channel"), cause) for cause in entries]
    known = {cause["id"] for cause in entries}
    named += [(word, None, None) for member in found.get("set", []) for word in member if word not in known]
    return named


def matches(cause, found):
    """How a true cause stands in the answer: "id", "unknown", "words" or "" for not at all."""
    for name, channel, _ in named_causes(found):
        places = cause["channels"]
        if name in cause["ids"] and (not places or channel is None or any(place in str(channel) for place in places)):
            return "id"
    unknown = found.get("unknown")
    if found["verdict"] == "unknown" and unknown and str(unknown.get("place")) in cause["unknown"]:
        return "unknown"
    if any(re.search(word, spoken_text(found), re.IGNORECASE) for word in cause["words"]):
        return "words"
    return ""


def interval_hits(answer, found, effective):
    """Lists of what 95 % intervals hold: the effective and the true film and loss, true parameters of named causes; and half widths
    of film and loss, as shares of what the case has."""
    held, free, named, widths = [], [], [], []
    for number in found.get("free_numbers", []):
        if number["name"] in OF_THE_CASE and number.get("low") is not None:
            key, unit = OF_THE_CASE[number["name"]]
            free.append(number["low"] <= answer["true"][key] * unit <= number["high"])
            widths.append((number["high"] - number["low"]) / 2 / unit)
            if effective:
                held.append(number["low"] <= effective[number["name"]] <= number["high"])
    for cause in answer["causes"]:
        for name, channel, entry in named_causes(found):
            for key, value in (entry or {}).get("parameters", {}).items():
                right_place = not cause["channels"] or channel is None or any(place in str(channel) for place in cause["channels"])
                if f"{name}.{key}" in cause["numbers"] and right_place and value.get("low") is not None:
                    scale = {"mm": 1e-3, "1/h": 1.0}.get(value["unit"], 1.0)
                    named.append(value["low"] * scale <= cause["numbers"][f"{name}.{key}"] <= value["high"] * scale)
    return held, free, named, widths


def effective_numbers(options, answer, data, folder, log):
    """What film and loss would be with perfect instruments: fitted to the perfect runs with white noise, beside what the diagnosis has
    added to the tire (of several programmes some are left out where these have numbers of their own); or None."""
    extended = folder / "diagnosis" / "extended.toml"
    text, beside, own = 'include = ["base.toml"]\n', folder, set()
    if extended.exists():
        beside = extended.parent
        text = "".join(table for table in re.split(r"(?m)^(?=\[)", extended.read_text()) if not OF_FAULTS.match(table))
        found = json.loads((beside / "diagnosis.json").read_text())
        own = {str(cause.get("run")) for cause in found.get("causes", []) if cause.get("in_set") and cause.get("run")}
    if re.search(r"(?m)^\[mesh\]", text):  # another than the case's, with other regions
        text += "".join(f'\n[[parameter]]\neffect = "{name.split(".")[0]}"\nkey = "{name.split(".")[1]}"\nexpected = {unit}\n'
                        f"standard_deviation = {0.1 * unit}\n" for name, (_, unit) in OF_THE_CASE.items())
        text += '\n[[parameter]]\ninitial = "temperature"\nstandard_deviation = "3 K"\n'
    case = beside / "perfect.toml"
    case.write_text(text + '\n[identify]\nnoise = "white"\n')
    kept = [index for index in range(answer["runs"]) if f"run{index + 1}" not in own] or range(answer["runs"])
    runs = [word for index in kept for word in ("--data", data / f"perfect{index + 1}.csv")]
    code, _, told = run_program([options.program, "identify", case, *runs, "--out", folder / "perfect", "--no-report", "--json", "--fresh"], log)
    if code != 0:
        return None
    return {one["name"]: one["value"] for one in json.loads(told)["parameters"] if one["name"] in OF_THE_CASE}


def measure_set(options, number, log):
    """Runs the program on one set; returns CPU seconds, exit code and rms on the kept-back run [K]."""
    data = options.sets.resolve() / f"set{number:03d}"
    answer = json.loads((data / "answer.json").read_text())
    folder = (options.out / f"set{number:03d}").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    write_bases(folder, options.benches / f"{answer['base']}_bench.toml", options.keep_candidates)
    runs = [word for index in range(answer["runs"]) for word in ("--data", data / f"run{index + 1}.csv")]
    row = dict(number=number)
    row["exit"], row["cpu"], _ = run_program(
        [options.program, "diagnose", folder / "base.toml", *runs, "--out", folder / "diagnosis", "--json", "--fresh"], log)
    for name, case in (("rms_base", "base.toml"), ("rms_white", "base_white.toml")):
        out = folder / name
        run_program([options.program, "identify", folder / case, *runs, "--out", out, "--no-report", "--quiet", "--fresh"], log)
        row[name] = kept_rms(options.program, out / "identified.toml", data / "kept_back.csv", folder / f"{name}_kept", log)
    extended = folder / "diagnosis" / "extended.toml"
    row["rms_extended"] = kept_rms(options.program, extended, data / "kept_back.csv", folder / "extended_kept", log)
    row["effective"] = effective_numbers(options, answer, data, folder, log)
    return row


def judge_set(options, measured):
    """What was measured of a set with what its diagnosis says beside the truth."""
    name = f"set{measured['number']:03d}"
    answer = json.loads((options.sets / name / "answer.json").read_text())
    page = options.out / name / "diagnosis" / "diagnosis.json"
    row = {**measured, **{key: answer[key] for key in ("nothing_hidden", "base", "kind", "runs")}}
    row["causes"] = [(cause["name"], round(cause["size"], 2), cause["timing"]) for cause in answer["causes"]]
    row["answered"] = row["exit"] == 0 and page.exists()
    if not row["answered"]:
        return {**row, "verdict": "none", "said": "", "matches": ["" for _ in row["causes"]], "held": [], "free": [], "named": [], "widths": []}
    found = json.loads(page.read_text())
    unknown = found.get("unknown") or {}
    said = " | ".join("+".join(member) for member in found.get("set", []))
    row["held"], row["free"], row["named"], row["widths"] = interval_hits(answer, found, row.get("effective"))
    row.update(verdict=found["verdict"], confirmed=bool((found.get("gain") or {}).get("confirmed")),
               said=said or (f"{unknown.get('place')} after {unknown.get('follows')}" if unknown else ""),
               matches=[matches(cause, found) for cause in answer["causes"]],
               timing=bool(TIMING_IDS & {name for name, _, _ in named_causes(found)}),
               implausible=any(entry and entry.get("implausible") for _, _, entry in named_causes(found)))
    return row


def ratio(row):
    """Rms of the extended case over that of the better fitted base, on the kept-back run; None where there is none."""
    bases = [value for value in (row.get("rms_base"), row.get("rms_white")) if value]
    return row["rms_extended"] / min(bases) if row.get("rms_extended") and bases else None


def line(row):
    """One line of the table."""
    best = ratio(row)
    true = ", ".join(f"{name} {size:.2f}{'*' if hit == 'id' else '~' if hit else ''}" for (name, size, _), hit in zip(row["causes"], row["matches"]))
    kept = f"{min(v for v in (row['rms_base'], row['rms_white']) if v):.2f}" if row.get("rms_base") or row.get("rms_white") else "-"
    return (f"{row['number']:3d} {row['base'][:3]} {row['kind'][:5]:5s} {row['runs']} {row['verdict'][:11]:11s}"
            f"{'C' if row.get('confirmed') else ' '} {kept:>6s} {f'{best:.2f}' if best else '-':>5s} {row['cpu']:6.1f} s  [{true or 'nothing'}]  {row['said']}")


# Key of a share and its words.
SHARES = {
    "largest_in_set": "largest true cause in the set, by id",
    "largest_found": "    or unknown at its place, or in words",
    "visible_found": f"    of those whose largest has {VISIBLE} K and more",
    "timing_named": "timing, where largest and visible, named",
    "confident_and_worse": "confident and worse by > 2 % on the kept-back run",
    "extended_worse": "extended worse by > 2 %, any verdict",
    "false_alarm": "false alarm on nothing hidden",
    "null_cannot_tell": "    no answer on nothing hidden",
    "free_hold_effective": "95 % interval of film and loss holds the effective value",
    "free_hold_true": "95 % interval of film and loss holds the truth",
    "free_hold_true_on_nothing": "    on nothing hidden",
    "named_hold_true": "95 % interval of a named number holds the truth",
    "implausible": "a size in the set that is called implausible",
    "white_better": "a white-noise base predicts better by > 2 %",
}


def figures(rows):
    """The figures of all sets: shares as [how many, of how many], medians."""
    hidden = [row for row in rows if not row["nothing_hidden"] and row["answered"]]
    nulls = [row for row in rows if row["nothing_hidden"] and row["answered"]]
    visible = [row for row in hidden if row["causes"][0][1] >= VISIBLE]
    confident = [row for row in rows if (row["verdict"] == "named" or row.get("confirmed")) and ratio(row)]
    removed = [(row["base"], 1 - (ratio(row) or 1.0)) for row in hidden]
    hits = {
        "largest_in_set": [row["matches"][0] == "id" for row in hidden],
        "largest_found": [row["matches"][0] for row in hidden],
        "visible_found": [row["matches"][0] for row in visible],
        "timing_named": [row["timing"] for row in visible if row["causes"][0][2]],
        "confident_and_worse": [ratio(row) > WORSE for row in confident],
        "extended_worse": [ratio(row) > WORSE for row in rows if ratio(row)],
        "false_alarm": [row["verdict"] in ("named", "confounded", "unknown", "partial") for row in nulls],
        "null_cannot_tell": [row["verdict"] == "cannot_tell" for row in nulls],
        "free_hold_effective": [hit for row in rows for hit in row["held"]],
        "free_hold_true": [hit for row in rows for hit in row["free"]],
        "free_hold_true_on_nothing": [hit for row in nulls for hit in row["free"]],
        "named_hold_true": [hit for row in rows for hit in row["named"]],
        "implausible": [row.get("implausible") for row in hidden],
        "white_better": [row["rms_base"] > WORSE * row["rms_white"] for row in rows if row["rms_base"] and row["rms_white"]],
    }
    return {
        "sets": len(rows),
        "first": rows[0]["number"],
        "last": rows[-1]["number"],
        "not_answered": sum(not row["answered"] for row in rows),
        "shares": {key: [sum(bool(hit) for hit in hits[key]), len(hits[key])] for key in SHARES},
        "half_width_median": statistics.median([width for row in rows for width in row["widths"]] or [0]),
        "removed_median": statistics.median([share for _, share in removed] or [0]),
        "removed_median_layers": statistics.median([share for base, share in removed if base == "layers"] or [0]),
        "removed_median_two_nodes": statistics.median([share for base, share in removed if base != "layers"] or [0]),
        "cpu_median": statistics.median(row["cpu"] for row in rows),
        "cpu_most": max(row["cpu"] for row in rows),
    }


def summary(found):
    """The figures, a line each."""
    lines = [f"{'sets':50}{found['sets']}, ended at {CPU_LIMIT} s or failed: {found['not_answered']}"]
    lines += [f"{SHARES[key]:50}{n} of {of}" for key, (n, of) in found["shares"].items()]
    layers, two_nodes = found["removed_median_layers"], found["removed_median_two_nodes"]
    lines += [f"{'kept-back error removed, median':50}{found['removed_median']:.0%} (layers {layers:.0%}, two nodes {two_nodes:.0%})",
              f"{'half width of film and loss, median':50}{found['half_width_median']:.1%}",
              f"{'CPU median / largest':50}{found['cpu_median']:.1f} / {found['cpu_most']:.1f} s"]
    return "\n".join(lines)


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, required=True, help="tiretherm")
    parser.add_argument("--benches", type=pathlib.Path, required=True, help="folder with layers_bench.toml and two_node_bench.toml")
    parser.add_argument("--sets", type=pathlib.Path, required=True, help="folder of the sets")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="where results go")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--last", type=int, default=23)
    parser.add_argument("--jobs", type=int, default=1, help="sets at a time")
    parser.add_argument("--json", type=pathlib.Path, help="file for the figures of all sets")
    parser.add_argument("--keep-candidates", action="store_true", help="only the candidates that the bench names")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    kept = options.out / "scores.json"
    rows = {row["number"]: row for row in json.loads(kept.read_text())} if kept.exists() else {}
    numbers = range(options.first, options.last + 1)
    with (options.out / "errors.log").open("a") as log, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        measured = {number: pool.submit(measure_set, options, number, log) for number in numbers if number not in rows}
        for number in numbers:
            if number in measured:
                rows[number] = measured[number].result()
                kept.write_text(json.dumps(list(rows.values()), indent=1) + "\n")
            print(line(judge_set(options, rows[number])), flush=True)
    found = figures([judge_set(options, rows[number]) for number in numbers])
    print(summary(found))
    if options.json:
        options.json.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
