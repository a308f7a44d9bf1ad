# SPDX-License-Identifier: BSD-3-Clause
"""The solver step by step, for a simulation that gives the inputs."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike

from . import _tiretherm
from ._case import Case
from ._errors import CaseError, Finding, SolverError
from ._result import Array


class Session:
    """A tire in real time. Between two steps the inputs go in a straight line; a step has no error control.

    All numbers are SI: K, m/s, N, rad, Pa, W. A session belongs to one thread at a time.

    >>> import tiretherm as tt
    >>> tire = tt.Session(tt.Case.from_file("cases/two_node/4000N_100kmh.toml"))
    >>> temperatures = tire.step(0.1, {"speed": 30.0})
    >>> tire.names
    ['surface_temperature', 'bulk_temperature']
    """

    def __init__(self, case: Case | str | PathLike[str]) -> None:
        """Raises CaseError."""
        self._case = case if isinstance(case, Case) else Case.from_file(case)
        self._case.check()
        try:
            self._native = _tiretherm.Session(str(self._case.path))
        except ValueError as error:
            raise CaseError([Finding(str(error).strip())]) from None
        self.names = [name for name, _ in self._native.outputs]
        """Of the channels, in their order."""
        self.units = [unit for _, unit in self._native.outputs]
        self.channels: Array = self._native.values
        """[channels] SI now: one array, in which each step writes."""

    @staticmethod
    def inputs() -> dict[str, str]:
        """All inputs with their units."""
        return dict(_tiretherm.Session.inputs())

    def step(self, dt: float, inputs: Mapping[str, float] | None = None, count: int = 1) -> Array:
        """Goes on by dt seconds to the inputs at the end of the step; those that are not named stay. count: of equal steps.

        Returns `channels`, the same array each time: copy what you keep. Raises ValueError for an unknown input, a value out
        of range or such a dt; SolverError, and then the session is as it was before.
        """
        try:
            if inputs:
                self._native.set(inputs if isinstance(inputs, dict) else dict(inputs))
            self._native.step(dt, count)
        except KeyError as error:
            known = ", ".join(self.inputs())
            raise ValueError(f"there is no input {error.args[0]!r}; the inputs are {known}") from None
        except RuntimeError as error:
            raise SolverError(str(error)) from None
        return self.channels

    @property
    def time(self) -> float:
        """s since the beginning."""
        return self._native.time

    @property
    def temperature(self) -> Array:
        """[nodes] K now, a copy: cells first, then the nodes of the surfaces."""
        return self._native.temperature

    def __getitem__(self, name: str) -> float:
        return float(self.channels[self.names.index(name)])
