# SPDX-License-Identifier: BSD-3-Clause
"""One set of the exam of dirty data: the program as its user calls it, then the judgement by the run that was kept back.

A set is a folder that make_dirty_sets wrote: case.toml, run1.csv ..., kept.csv, answer.json. How a model does on the run that
was kept back is the rms, in K over all sensors that work, of `tiretherm identify` with everything fixed but the temperatures
at the start, which no model knows. All models are treated alike in that.
"""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import time

# Sizes beyond these no engineer believes: (lowest, highest) of a parameter, in the units of diagnosis.json.
BELIEVABLE = {
    "sidewall_convection.conductance": (0, 60), "inner_gas.liner": (0, 60), "inner_gas.rim": (0, 60),
    "rim_conduction.bead": (0, 60), "rim_conduction.cooling": (0, 100), "radiation.emissivity": (0, 1),
    "cornering_loss.coefficient": (0, 5e-5), "load_exponent_of_loss.exponent": (-1.2, 1.2),
    "loss_tangent_slope.slope": (-0.03, 0.03), "loss_frequency_shift.per_decade": (-40, 40),
    "convection_exponent.exponent": (0.2, 1.2), "partition_speed.slope": (-0.6, 0.6), "resolved_contact.scale": (0, 3),
    "standing_wave.critical_speed": (80, 400), "standing_wave.gain": (0, 5e-3), "drum_curvature.curvature": (0, 3.5),
    "layer_conductivity.scale": (0.3, 3), "layer_conductivity.slope": (-0.03, 0.03), "layer_heat_capacity.scale": (0.4, 2.5),
    "tread_wear.depth": (0, 0.008), "load_input_gain.gain": (0.8, 1.25), "speed_input_gain.gain": (0.85, 1.18),
    "slip_input_gain.gain": (0.4, 2.5), "road_temperature_drift.rate": (-30, 30), "air_temperature_drift.rate": (-15, 15),
    "initial_temperature.offset": (-15, 15), "camera_emissivity.emissivity": (0.8, 1), "sensor_depth.offset": (-0.005, 0.005),
    "clock_delay.delay": (-3, 3), "input_delay.*": (-3, 3), "sensor_lag.tau": (0, 30), "sensor_offset.kelvin": (-8, 8),
    "sensor_gain.excess": (-0.15, 0.15), "groove_convection.area_share": (0, 1), "natural_convection.scale": (0, 4),
    "inflation_pressure_rise.exponent": (0, 1.5), "contact_pressure_conductance.exponent": (0, 2),
}
# What is wrong with readings and logs, not with the model: with perfect instruments the base model fits what is left.
NOT_OF_THE_TIRE = {"sensor_lag", "clock_delay", "input_delay", "camera_emissivity", "sensor_offset", "quantised", "upsampled",
                   "clipped", "stuck", "load_input_gain", "speed_input_gain", "slip_input_gain", "road_temperature"}
TIMING = {"sensor_lag", "clock_delay", "input_delay"}
UNITS = {"conductance": "W/K", "liner": "W/K", "rim": "W/K", "tau": "s", "delay": "s", "kelvin": "K", "coefficient": "1/N",
         "slope": {"loss_tangent_slope": "1/K", "partition_speed": "s/m"}, "critical_speed": "km/h", "gain": {
             "standing_wave": "1/(km/h)^2"}, "vertical_load": "s", "slip_angle": "s", "speed": "s"}


class Call:
    """What came of one call of the program."""

    def __init__(self, program, words, cpu_limit):
        begin = time.monotonic()

        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
        limited = ["/bin/sh", "-c", 'ulimit -t "$0" && exec "$@"', str(int(cpu_limit))]
        with tempfile.TemporaryFile("w+") as told:  # progress, which a call of more than a minute tells, is no part of the JSON
            process = subprocess.Popen([*limited, str(program), *map(str, words)], stdout=subprocess.PIPE, stderr=told,
                                       stdin=subprocess.DEVNULL, text=True, env=environment)
            self.text = process.stdout.read()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            process.stdout.close()
            if process.returncode != 0:
                told.seek(0)
                self.text += told.read()
        self.code, self.cpu = process.returncode, used.ru_utime + used.ru_stime
        self.seconds = time.monotonic() - begin
        try:
            self.json = json.loads(self.text)
        except ValueError:
            self.json = None


def tables(text):
    """A case cut into its tables, each with its heading."""
    return re.split(r"(?m)^(?=\[)", text)


def without_instruments(text):
    """An extended case without the faults of instruments and inputs that it names, and without its runs."""
    faulty = "|".join(sorted(NOT_OF_THE_TIRE | {"sensor_gain"}))
    dropped = rf"\[effects\.({faulty})\]|\[(\[parameter\]|\[run\]|identify|diagnose)"
    return "".join(one for one in tables(text) if not re.match(dropped, one))


def starts_of(text):
    """The [[parameter]] of the starts of a case, or nothing."""
    return "".join(one for one in tables(text)
                   if one.startswith("[[parameter]]") and re.search(r"(?m)^initial\b", one))


def only_starts(text, starts):
    """The case with everything fixed but the starts, fitted with white noise. Lists of an included file are replaced."""
    kept = [one for one in tables(text) if not re.match(r"\[(\[parameter\]|\[run\]|identify|diagnose)", one)]
    return "".join(kept).rstrip() + "\n\n" + (starts_of(text) or starts) + '\n[identify]\nnoise = "white"\n'


def with_noise(text, noise):
    return re.sub(r'(?m)^noise = "\w+"', f'noise = "{noise}"', text)


def unit_of(effect, key):
    unit = UNITS.get(key)
    return unit.get(effect) if isinstance(unit, dict) else unit


def with_cause(text, cause, answer):
    """The case with a true cause switched on and its parameters free, or None where there is no effect of that name."""
    if not cause["in_catalogue"] or not cause["parameters"]:
        return None
    effect = cause["id"]
    block = [f"\n[effects.{effect}]"]
    if cause["channel"]:
        names = answer["infrared"] if cause["channel"] == "infrared" else [cause["channel"]]
        block.append("channels = " + json.dumps(names))
    if effect == "layer_conductivity":
        block.append('layers = ["%s"]' % ("bulk" if answer["base"] == "two_node" else "carcass"))
    for key, value in cause["parameters"].items():
        unit = unit_of(effect, key)
        block.append(f'{key} = "{value} {unit}"' if unit else f"{key} = {value}")
    for key in cause["parameters"]:
        block += ["\n[[parameter]]", f'effect = "{effect}"', f'key = "{key}"']
    return text.rstrip() + "\n" + "\n".join(block) + "\n"


class Set:
    """One set and what is asked of it."""

    def __init__(self, folder, program, settings):
        self.folder, self.program, self.settings = pathlib.Path(folder), program, settings
        self.answer = json.loads((self.folder / "answer.json").read_text())
        self.case = (self.folder / "case.toml").read_text()

    def identify(self, name, text, files, beside=None):
        """Fits a case that is written beside the set's own, or into the folder `beside`; its result, or None."""
        case = (beside or self.folder) / f"{name}.toml"
        case.write_text(text)
        out = self.folder / f"out_{name}"
        words = ["identify", case, "--json", "--fresh", "--out", out]
        for file in files:
            words += ["--data", self.folder / file]
        call = Call(self.program, words, self.settings.cpu)
        if call.json is None or "channels" not in call.json:
            return None
        call.json["out"] = out
        return call.json

    def on_kept(self, name, text, beside=None, starts=None):
        """Rms on the run that was kept back, K, with the starts fitted."""
        result = self.identify(name, only_starts(text, starts or starts_of(self.case)), [self.answer["kept"]], beside)
        if result is None:
            return None
        squares = [(one["samples"], one["rmse_after"]) for one in result["channels"]
                   if one["name"] not in self.answer["stuck"]]
        n = sum(samples for samples, _ in squares)
        return (sum(samples * rms * rms for samples, rms in squares) / n) ** 0.5 if n else None

    def of_fitted(self, name, result, starts=None):
        """The same of a case that fitted() has written."""
        return self.on_kept(f"kept_{name}", result[0], self.folder / f"out_{name}", starts) if result and result[0] else None

    def fitted(self, name, text):
        """A case fitted to the runs; the text of identified.toml and the numbers, or None."""
        result = self.identify(name, text, self.answer["runs"])
        if result is None:
            return None
        path = result["out"] / "identified.toml"
        return (path.read_text() if path.exists() else None), result

    def evaluate(self):
        answer = self.answer
        row = {"seed": answer["seed"], "base": answer["base"], "style": answer["style"], "programme": answer["programme"]}
        data = [word for run in answer["runs"] for word in ("--data", self.folder / run)]
        call = Call(self.program, ["diagnose", self.folder / "case.toml", *data, "--no-by-run", "--json", "--fresh", "--out",
                                   self.folder / "out"], self.settings.cpu)
        found = call.json if call.json and "verdict" in call.json else None
        row["cpu"] = round(call.cpu, 2)
        row["verdict"] = found["verdict"] if found else ("time" if call.cpu >= self.settings.cpu - 1 else "failed")
        if not found:
            row["message"] = call.text[-300:]
        self.judge_causes(row, found)
        if self.settings.kept:
            self.judge_kept(row, found)
        return row

    def judge_causes(self, row, found):
        answer = self.answer
        members = [one for one in found["causes"] if one["in_set"]] if found else []
        ids = {one["id"] for one in members}
        if found and (found["verdict"] == "unknown" or (found.get("unknown") and not members)):
            ids.add("unknown")
        row["set"] = sorted(ids)
        row["causes"] = {f"{one['id']}{' of ' + one['channel'] if one['channel'] else ''}":
                         [round(one["rms"], 3), round(one["rms_left"], 3)] for one in answer["causes"]}
        nameable = [one for one in answer["causes"] if one["in_catalogue"] or one["accepted"]]

        def in_set(cause):
            return bool(ids & {cause["id"], *cause["accepted"]})

        for key, size in (("largest", "rms"), ("largest_left", "rms_left")):
            seen = [one for one in nameable if one[size] > self.settings.seen]
            if seen:
                cause = max(seen, key=lambda one: one[size])
                row[key] = [cause["id"], in_set(cause)]
                if cause["timing"] and key == "largest":
                    row["timing"] = [cause["id"], in_set(cause), bool(ids & TIMING)]
        row["absurd"] = sorted({f"{one['id']}.{key} {number['value']:.3g}" for one in members
                                for key, number in one["parameters"].items() if is_absurd(one, key, number)})
        row["intervals"] = self.intervals(members)

    def intervals(self, members):
        """Of each number that is in the set and true: whether its interval holds the truth."""
        held = []
        for cause in self.answer["causes"]:
            if cause["id"] == "resolved_contact":  # the truth's law is not the catalogue's: its scale is not that scale
                continue
            own = self.answer["infrared"] if cause["channel"] == "infrared" else [cause["channel"]]
            for one in members:
                elsewhere = one["channel"] in self.answer["sensors"] and one["channel"] not in own
                if one["id"] != cause["id"] or elsewhere:
                    continue
                for key, true in cause["parameters"].items():
                    number = one["parameters"].get(key)
                    if number and number["high"] > number["low"]:
                        held.append([f"{one['id']}.{key}", true, number["low"], number["high"],
                                     number["low"] <= true <= number["high"]])
        return held

    def judge_kept(self, row, found):
        """Kept-back run: extended case, base as fitted (two kinds of noise), as it stands, and the best true addition."""
        scores = {"stands": self.on_kept("stands", self.case)}
        for noise in ("correlated", "white"):
            result = self.fitted(noise, with_noise(self.case, noise))
            scores[noise] = self.of_fitted(noise, result)
            if result and noise == "correlated":
                row["free"], row["perfect"] = self.free_numbers(found, result[1])
        extended = self.folder / "out" / "extended.toml"
        if found and extended.exists():
            # Beside its own include, at the place that it was written for.
            scores["extended"] = self.on_kept("kept_extended", extended.read_text(), self.folder / "out")
        best = None
        causes = sorted(self.answer["causes"], key=lambda one: -one["rms_left"])[: self.settings.oracle]
        for i, cause in enumerate(causes):
            text = (self.folder / "fine.toml").read_text() if cause["id"] == "mesh" else with_cause(self.case, cause,
                                                                                                   self.answer)
            result = self.fitted(f"oracle{i}", with_noise(text, "white")) if text else None
            score = self.of_fitted(f"oracle{i}", result, starts_of(text or self.case))
            if score is not None and (best is None or score < best[1]):
                best = [cause["id"], score]
        row["kept"] = {key: value for key, value in scores.items() if value is not None}
        row["oracle"] = best
        bases = [row["kept"][key] for key in ("correlated", "white") if key in row["kept"]]
        if not bases:
            return
        base = min(bases)
        after = row["kept"].get("extended", base)
        row["change"] = after / base - 1.0
        row["confirmed"] = bool(found and found.get("gain", {}).get("confirmed"))
        row["confident"] = row["confirmed"] or row["verdict"] == "named"
        row["removed"] = 1.0 - after / base
        if best:
            row["oracle_removed"] = 1.0 - best[1] / base
        if len(bases) == 2:
            row["white_better"] = row["kept"]["white"] < row["kept"]["correlated"] / 1.02

    def free_part(self):
        """The [[parameter]] of the case, and white noise."""
        free = "".join(one for one in tables(self.case) if one.startswith("[[parameter]]"))
        return "\n" + free.rstrip() + '\n\n[identify]\nnoise = "white"\n'

    def free_numbers(self, found, identified):
        """Free numbers of the base: [name, true, effective, low, high]; effective is what they would be fitted to on the same
        runs with perfect instruments and inputs, beside what the diagnosis has added to the tire. Of the diagnosis, where it
        states them, else of identify. Beside them the largest rms of the base so fitted, K, where it has all that the tire
        has: the truth's own error."""
        stated = (found or {}).get("free_numbers") or identified["parameters"]
        runs = [run.replace("run", "perfect") for run in self.answer["runs"]]
        perfect = self.identify("perfect", with_noise(self.case, "white"), runs)
        extended = self.folder / "out" / "extended.toml"
        text = without_instruments(extended.read_text()) if found and extended.exists() else ""
        beside = self.identify("perfect_extended", text + self.free_part(), runs, self.folder / "out") if text else perfect
        effective = {one["name"]: one["value"] for one in (beside or perfect or {"parameters": []})["parameters"]}
        numbers = [[one["name"], self.answer["free"][one["name"]], effective.get(one["name"]), one["low"], one["high"]]
                   for one in stated if one["name"] in self.answer["free"] and one.get("low") is not None]
        is_whole = all(one["id"] in NOT_OF_THE_TIRE for one in self.answer["causes"])
        rest = max(one["rmse_after"] for one in perfect["channels"]) if perfect and is_whole else None
        return numbers, rest


def is_absurd(cause, key, number):
    if cause.get("bound"):
        return True
    ends = BELIEVABLE.get(f"{cause['id']}.{key}") or BELIEVABLE.get(f"{cause['id']}.*")
    return ends is not None and not ends[0] <= number["value"] <= ends[1]
