# SPDX-License-Identifier: BSD-3-Clause
"""Cases: a file, or a text, with other values laid over it."""

from __future__ import annotations

import csv
import difflib
import json
import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any, Union

import numpy as np

from . import _tiretherm
from ._errors import CaseError, Finding, Places, ProgressOption, findings_of, manner, raise_for, sentence
from ._result import Array, Comparison, Diagnosis, Identification, Measured, Result, WorkFolder

#: A file, several files, or columns by their headings (a dict of arrays, or a pandas.DataFrame).
Data = Union[None, str, "PathLike[str]", Mapping[str, Any], Sequence[Any], Any]

#: A value of a case: a text with its unit, a number, a truth value, a list or a table.
CaseValue = Any


def toml_text(value: CaseValue) -> str:
    """A value as TOML has it. Raises TypeError for what is none."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{json.dumps(str(k))} = {toml_text(v)}" for k, v in value.items()) + " }"
    if isinstance(value, (Sequence, np.ndarray)):
        return "[" + ", ".join(toml_text(item) for item in value) + "]"
    raise TypeError(f"{value!r} is no value of a case; write a text with its unit, a number, True or False, or a list")


def caller_place() -> tuple[str, int]:
    """File and line of the user's script that called the package."""
    frame = sys._getframe(1)
    here = Path(__file__).parent
    while frame.f_back is not None and Path(frame.f_code.co_filename).parent == here:
        frame = frame.f_back
    return frame.f_code.co_filename, frame.f_lineno


@dataclass(frozen=True)
class Effect:
    """Heat by a law in Python, for trying: each evaluation of the heat balance calls it.

    law(signal, T) gets the value that the effect follows and the temperatures of its nodes, [nodes] K. It gives the heat in W
    that the whole place would take if it were at that temperature, [nodes], and of which each node has its share: surfaces by area, layers
    by heat capacity. With the derivatives in W/K beside it, `return watts, slope`, it is called once; otherwise twice, for the difference.

    at: a region, layer, zone or patch, or a list of them. follows: a formula of inputs and columns, "speed * abs(lateral_force)".

    >>> import tiretherm as tt
    >>> def glow(signal, T):
    ...     return 5.67e-8 * 0.9 * 0.4 * (300.0**4 - T**4)  # 0.4 m2 that see surroundings of 300 K
    >>> case = tt.Case.from_file("cases/two_node/4000N_100kmh.toml")
    >>> result = case.run(effects={"glow": tt.Effect(glow, at="surface")})
    >>> float(result.budget["glow"][-1]) < 0
    True
    """

    law: Callable[[float, Array], Any]
    at: str | Sequence[str]
    follows: str = "1"


class Case:
    """A case that can be run, compared with data, fitted and diagnosed.

    Values are read and set by their addresses, as studies and `tiretherm run --change` have them, with units:

    >>> import tiretherm as tt
    >>> case = tt.Case.from_file("cases/two_node/4000N_100kmh.toml")
    >>> case["drive.speed"] = "120 km/h"
    >>> case["drive.speed"]
    '120 km/h'
    >>> round(float(case.run().channels["bulk_temperature"].to("degC")[-1]))  # degC after an hour
    68

    A file is not changed. What is wrong with a value is said by `check` and by all that runs the case.
    """

    def __init__(self, file: str | PathLike[str]) -> None:
        self._file = Path(file).absolute()
        self._shown = str(file)
        self._values: dict[str, CaseValue] = {}
        self._unset: list[str] = []
        self._places: dict[str, tuple[str, int]] = {}
        self._work = WorkFolder()
        self._text: WorkFolder | None = None  # of a case that is a text
        self._folders: dict[str, WorkFolder] = {}  # of measured calls that have not come to a result

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Case:
        """The case of a file. Raises FileNotFoundError where there is none; its content is checked when it is run."""
        if not Path(path).is_file():
            raise FileNotFoundError(f"there is no file {path}")
        return cls(path)

    @classmethod
    def from_text(cls, text: str, name: str = "case") -> Case:
        """A case of a TOML text. Paths in it are absolute, or lead from a temporary folder to nowhere."""
        work = WorkFolder()
        path = work.path / f"{name}.toml"
        path.write_text(text, encoding="utf-8")
        case = cls(path)
        case._text = work
        return case

    def copy(self) -> Case:
        """The same case, whose values can be set independently."""
        other = Case(self._file)
        other._shown = self._shown
        other._values, other._unset = dict(self._values), list(self._unset)
        other._places = dict(self._places)
        other._text = self._text
        return other

    # Values

    def __getitem__(self, address: str) -> Any:
        """The value as it is written: a text with its unit, a number, True or False. Raises KeyError."""
        if address in self._values:
            return self._values[address]
        values = dict(self.items())
        if address in values:
            return values[address]
        near = difflib.get_close_matches(address, values, 3)
        raise KeyError(address + (f"; did you mean {' or '.join(near)}?" if near else ""))

    def __setitem__(self, address: str, value: CaseValue) -> None:
        toml_text(value)
        if address in self._unset:
            self._unset.remove(address)
        self._values[address] = value
        self._places[address] = caller_place()

    def __delitem__(self, address: str) -> None:
        """Takes a value away, as `unset` does."""
        if self._values.pop(address, None) is None or address in dict(_tiretherm.case_values(str(self._file))):
            self._unset.append(address)
            self._places[address] = caller_place()

    def __contains__(self, address: object) -> bool:
        return address in self._values or address in dict(self.items())

    def __iter__(self) -> Iterator[str]:
        return (address for address, _ in self.items())

    def items(self) -> list[tuple[str, Any]]:
        """All addresses with their values. Empty where the case cannot be read."""
        skipped = ("include", "unset", "set")
        found = _tiretherm.case_values(str(self.path))
        return [(address, _plain(text)) for address, text in found if address.split(".")[0] not in skipped]

    # The file that the libraries read

    @property
    def path(self) -> Path:
        """The file of the case as it is now: the original, or one that includes it and sets values."""
        return self._written()[0]

    def _written(self, effects: Mapping[str, Effect] | None = None) -> tuple[Path, Places]:
        if not self._values and not self._unset and not effects:
            return self._file, {}
        path = self._work.path / "cases" / f"{_tiretherm.case_name(str(self._file))}.toml"
        lines = [f"include = [{toml_text(str(self._file))}]"]
        places: dict[tuple[str, int], tuple[str, int]] = {}
        if self._unset:
            lines.append("unset = [")
            for address in self._unset:
                lines.append(f"  {toml_text(address)},")
                places[(str(path), len(lines))] = self._places[address]
            lines.append("]")
        lines.append("[set]")
        for address, value in self._values.items():
            lines.append(f"{toml_text(address)} = {toml_text(value)}")
            places[(str(path), len(lines))] = self._places[address]
        for name, effect in (effects or {}).items():
            values = {"name": name, "at": effect.at, "follows": effect.follows, "watts": "1 W"}
            for line in ("[[source]]", *(f"{key} = {toml_text(value)}" for key, value in values.items())):
                lines.append(line)
                places[(str(path), len(lines))] = caller_place()
        path.parent.mkdir(parents=True, exist_ok=True)
        text = "\n".join(lines) + "\n"
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
        return path, places

    def check(self, run: str = "") -> list[str]:
        """Reads the case as `run` does, without running it. @returns its warnings, a sentence each. Raises CaseError."""
        path, places = self._written()
        findings, warnings, _ = _tiretherm.check(str(path), run)
        if findings:
            raise CaseError(findings_of(findings, places), warnings)
        return warnings

    # Calls

    def run(
        self,
        run: str = "",
        *,
        out: str | PathLike[str] | None = None,
        field_interval: float = 0.0,
        fresh: bool = False,
        what_if: bool = False,
        changes: Sequence[str] = (),
        sensors: Mapping[str, Callable[[float, Array], float]] | None = None,
        effects: Mapping[str, Effect] | None = None,
        progress: ProgressOption = None,
    ) -> Result:
        """Simulates the case, of a car all its tires.

        run: which [[run]]; default the first. out: a folder for the files of `tiretherm run`; default none, and all is in
        memory. field_interval: s between stored fields; 0 as the case says. changes: as --change. sensors: functions of
        the time in s and the temperatures of all nodes in K, [nodes], which become channels; each is called at every row of
        output (some 1 us and what it does itself) and must not keep the array. effects: by name, beside those of the case.

        Raises CaseError; SolverError; Interrupted after Ctrl-C, whose `result` has the rows up to then.
        """
        path, places = self._written(effects)
        laws = {name: effect.law for name, effect in (effects or {}).items()}
        outcome = _tiretherm.run(
            case_file=str(path), run=run, directory="" if out is None else str(out), field_interval=field_interval,
            fresh=fresh, what_if=what_if, changes=list(changes), sensors=list((sensors or {}).items()),
            laws=laws, **manner(progress),
        )  # fmt: skip
        folder = None if out is None else Path(out)
        result = Result(outcome, self._shown, folder) if outcome.runs and outcome.has_page else None
        raise_for(outcome, result, places)
        if result is None:
            raise CaseError([Finding(sentence(outcome) or "there is no result")])
        return result

    def compare(
        self, data: Data = None, *, out: str | PathLike[str] | None = None, progress: ProgressOption = None
    ) -> Comparison:
        """Simulates the measured runs without fitting. data: in the place of the case's own runs."""
        return self._measured(Comparison, "compare", data, out, progress, {})

    def identify(
        self,
        data: Data = None,
        *,
        profile: bool = False,
        plan: bool = False,
        leave_out: str = "",
        correlation_time: float = 10.0,
        out: str | PathLike[str] | None = None,
        fresh: bool = False,
        progress: ProgressOption = None,
    ) -> Identification:
        """Fits the [[parameter]] values to measured runs. A call that was interrupted goes on when it is made again."""
        if leave_out not in ("", "lap", "run"):
            raise CaseError([Finding(f'leave_out is "{leave_out}"', 'write "lap" or "run"')])
        more = {
            "fresh": fresh, "profile": profile, "plan": plan, "leave_out": leave_out,
            "correlation_time": correlation_time,
        }  # fmt: skip
        return self._measured(Identification, "identify", data, out, progress, more)

    def diagnose(
        self,
        data: Data = None,
        *,
        time_limit: float = 0.0,
        by_run: bool | None = None,
        out: str | PathLike[str] | None = None,
        fresh: bool = False,
        progress: ProgressOption = None,
    ) -> Diagnosis:
        """Finds which effects the model lacks. time_limit: s, after which the best answer so far is given, or SolverError raised
        where there is none. by_run: each run alone, too; default: where that is quick."""
        more = {
            "fresh": fresh, "time_limit": time_limit, "by_run": by_run is True, "no_by_run": by_run is False,
        }  # fmt: skip
        return self._measured(Diagnosis, "diagnose", data, out, progress, more)

    def _measured(
        self,
        kind: type[Measured],
        command: str,
        data: Data,
        out: str | PathLike[str] | None,
        progress: ProgressOption,
        more: dict[str, Any],
    ) -> Measured:
        path, places = self._written()
        # An interrupted fit goes on from what is in its folder, which is the case's own until it has come to a result.
        work = self._folders.setdefault(command, WorkFolder())
        folder = work.path if out is None else Path(out)
        outcome = getattr(_tiretherm, command)(
            case_file=str(path), data=self._data_files(data), directory=str(folder), no_report=out is None, **more,
            **manner(progress),
        )  # fmt: skip
        result: Measured | None = None
        if outcome.has_page:
            result = kind(outcome, command, self._shown, folder, (self, work))
            del self._folders[command]
        raise_for(outcome, result, places)
        if result is None:
            raise CaseError([Finding(sentence(outcome) or "there is no result")])
        return result

    def _data_files(self, data: Data) -> list[str]:
        if data is None:
            return []
        if isinstance(data, (str, PathLike)):
            return [str(data)]
        if isinstance(data, Mapping) or hasattr(data, "columns"):
            return [self._csv_of(data, 0)]
        return [self._csv_of(d, i) if isinstance(d, Mapping) or hasattr(d, "columns") else str(d) for i, d in enumerate(data)]

    def _csv_of(self, columns: Any, number: int) -> str:
        """Columns as a CSV file, with all digits."""
        path = self._work.path / f"data_{number + 1}.csv"
        names = list(columns.columns) if hasattr(columns, "columns") else list(columns)
        arrays = [np.asarray(columns[name]) for name in names]
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(names)
            writer.writerows([_cell(value) for value in row] for row in zip(*arrays))
        return str(path)

    def __repr__(self) -> str:
        changed = "".join(f", {address} = {value!r}" for address, value in self._values.items())
        return f"<Case {self._shown}{changed}>"


def _cell(value: Any) -> str:
    return repr(value.item()) if isinstance(value, np.floating) else str(value)


def _plain(text: str) -> Any:
    if text in ("true", "false"):
        return text == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
