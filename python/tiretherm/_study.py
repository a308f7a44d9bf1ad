# SPDX-License-Identifier: BSD-3-Clause
"""Studies: a case run many times, in several threads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

from . import _tiretherm
from ._case import Case, toml_text
from ._errors import ProgressOption, manner, raise_for
from ._result import StudyResult, WorkFolder


class Study:
    """A case run with values on a grid, or drawn at random.

    >>> import tiretherm as tt
    >>> case = tt.Case.from_file("cases/two_node/4000N_100kmh.toml")
    >>> study = tt.Study(case, vary={"drive.speed": ["80 km/h", "120 km/h"]})
    >>> len(study.run().tables["study"]["run"])
    2
    """

    def __init__(
        self,
        case: Case,
        vary: Mapping[str, Sequence[Any]] | None = None,
        draw: Mapping[str, Mapping[str, Any]] | None = None,
        *,
        samples: int = 0,
        seed: int = 1,
        critical: str = "",
        title: str = "",
    ) -> None:
        """vary: values by address; all combinations are run. draw: by address what [[draw]] says, such as
        {"distribution": "normal", "mean": "500 W/m2K", "standard_deviation": "50 W/m2K"}, of which `samples` are drawn.
        critical: a temperature that the hottest place should not pass, "110 degC"."""
        self._case: Case | None = case
        self._work = WorkFolder()
        self._file = self._work.path / "study.toml"
        lines = [f"case = {toml_text(str(case.path))}"]
        lines += [f"title = {toml_text(title)}"] if title else []
        lines += [f"critical = {toml_text(critical)}"] if critical else []
        for key, values in (vary or {}).items():
            lines += ["[[vary]]", f"key = {toml_text(key)}", f"values = {toml_text(list(values))}"]
        for key, spread in (draw or {}).items():
            lines += ["[[draw]]", f"key = {toml_text(key)}"]
            lines += [f"{name} = {toml_text(value)}" for name, value in spread.items()]
        if samples:
            lines += ["[sample]", f"count = {samples}", f"seed = {seed}"]
        self._file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        self._shown = f"study of {case!r}"

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Study:
        """The study of a file."""
        study = cls.__new__(cls)
        study._case, study._work, study._file, study._shown = None, WorkFolder(), Path(path).absolute(), str(path)
        return study

    def run(
        self,
        *,
        threads: int = 0,
        out: str | PathLike[str] | None = None,
        fresh: bool = False,
        progress: ProgressOption = None,
    ) -> StudyResult:
        """Makes the runs that are not there yet. threads: 0 as many as the machine can do. Runs are kept in `out`, or as long as this
        object lives, so that a study which was interrupted goes on. Raises CaseError; Interrupted."""
        folder = self._work.path / "out" if out is None else Path(out)
        outcome = _tiretherm.study(
            study_file=str(self._file), directory=str(folder), threads=threads, fresh=fresh, no_report=out is None,
            **manner(progress),
        )  # fmt: skip
        result = StudyResult(outcome, "study", self._shown, folder, (self._case, self._work)) if outcome.has_page else None
        if result is not None and not outcome.signalled and not outcome.findings:
            return result  # runs of it may have failed: `failure` of the table says why
        raise_for(outcome, result, {})
        raise AssertionError("a call without a result says why")
