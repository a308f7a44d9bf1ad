# SPDX-License-Identifier: BSD-3-Clause
"""What may go wrong, and how the calls of the extension module become results or exceptions."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Optional

from . import _tiretherm

DONE, INPUT_ERROR, NUMERICAL_FAILURE, INTERRUPTED = 0, 1, 2, 130

#: True: a line on stderr; a callable: gets the line as a text, at most ten times a second; None: as True on a terminal.
ProgressOption = Optional["bool | Callable[[str], Any]"]


@dataclass(frozen=True)
class Finding:
    """One error in a case or in a call, with its place and its remedy."""

    message: str
    remedy: str = ""
    file: str = ""
    """As the user would type it; empty where the error has no place."""
    line: int = 0
    """From 1; 0: the file as a whole."""
    column: int = 0
    source: str = ""
    """The line of the file."""
    code: str = "other"

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}: " if self.line else f"{self.file}: " if self.file else ""
        return f"{place}{self.message}" + (f"; {self.remedy}" if self.remedy else "")


class Error(Exception):
    """The base of all exceptions of this package."""


class CaseError(Error, ValueError):
    """A case, a file or a call is wrong. All errors are in `findings`."""

    def __init__(self, findings: Iterable[Finding], warnings: Iterable[str] = ()) -> None:
        self.findings = list(findings)
        self.warnings = list(warnings)
        super().__init__("\n".join(str(finding) for finding in self.findings))


class SolverError(Error, ArithmeticError):
    """The heat balance has no solution, or a search did not end. `result` is what there is up to then, or None."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C came. `result` is what there is up to then, or None."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


class Stopped(Error):
    """Another thread called `stop`. `result` is what there is up to then, or None."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


def stop() -> None:
    """Asks all calls that are under way in any thread to end; they raise `Stopped` with what they have."""
    _tiretherm.stop()


def manner(progress: ProgressOption) -> dict[str, Any]:
    """How a call is made, for the extension module."""
    is_callable = callable(progress)
    shown = sys.stderr.isatty() if progress is None else bool(progress)
    return {
        "by_signal": threading.current_thread() is threading.main_thread(),
        "quiet": not shown and not is_callable,
        "progress": progress if is_callable else None,
    }


def sentence(outcome: _tiretherm.Outcome) -> str:
    """Why there is no result."""
    parts = outcome.refused + ([outcome.remedy] if outcome.remedy else [])
    return "; ".join(parts)


#: Of lines that the package itself has written: where in the user's script they come from.
Places = Mapping[tuple[str, int], tuple[str, int]]


def findings_of(found: Iterable[Mapping[str, Any]], places: Places) -> list[Finding]:
    """The errors that the extension module has found."""
    findings = []
    for one in found:
        place = (one["file"], one["line"])
        file, line = places.get(place, place)
        is_moved = place in places
        findings.append(
            Finding(one["message"], one["remedy"], file, line, 0 if is_moved else one["column"], one["source"], one["code"])
        )
    return findings


def raise_for(outcome: _tiretherm.Outcome, result: Any, places: Places) -> None:
    """Raises what a call came to, unless it came to a result."""
    if outcome.findings:
        raise CaseError(findings_of(outcome.findings, places), outcome.warnings)
    if outcome.signalled:
        raise Interrupted(sentence(outcome) or "stopped", result)
    if outcome.exit == INTERRUPTED:
        raise Stopped(sentence(outcome) or "stopped", result)
    if outcome.refused and outcome.exit == NUMERICAL_FAILURE:
        raise SolverError(sentence(outcome), result)
    if outcome.refused and outcome.exit == INPUT_ERROR:
        raise CaseError([Finding("; ".join(outcome.refused), outcome.remedy)], outcome.warnings)
