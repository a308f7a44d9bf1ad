# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

version: str

class RecordedRun:
    name: str
    corner: str
    channels: list[tuple[str, str, str, str]]
    effects: list[str]
    time: Array
    values: Array
    watts: Array
    joules: Array
    stored: Array
    field_time: Array
    fields: Array
    mesh: dict[str, Any]
    hottest: dict[str, Any]
    coldest: dict[str, Any]
    energy_closure: float
    steps: int
    message: str
    is_stopped: bool

class Outcome:
    exit: int
    signalled: bool
    refused: list[str]
    remedy: str
    warnings: list[str]
    notes: list[str]
    text: str
    runs: list[RecordedRun]
    findings: list[dict[str, Any]]
    has_page: bool
    data: dict[str, Any] | None
    def page_text(self) -> str: ...
    def page_html(self, kind: str, source: str) -> str: ...

class Session:
    outputs: list[tuple[str, str]]
    values: Array
    time: float
    temperature: Array
    def __init__(self, case_file: str) -> None: ...
    def set(self, inputs: dict[str, float]) -> None: ...
    def step(self, dt: float, count: int) -> None: ...
    @staticmethod
    def inputs() -> list[tuple[str, str]]: ...

def check(case_file: str, run: str) -> tuple[list[dict[str, Any]], list[str], list[str]]: ...
def case_name(file: str) -> str: ...
def case_values(file: str) -> list[tuple[str, str]]: ...
def conversion(from_: str, to: str) -> tuple[float, float]: ...
def stop() -> None: ...
def run(*, case_file: str, run: str, directory: str, field_interval: float, fresh: bool, what_if: bool,
        changes: list[str], sensors: list[tuple[str, Callable[..., float]]], laws: dict[str, Callable[..., Any]],
        by_signal: bool, quiet: bool, progress: Any) -> Outcome: ...
def compare(*, case_file: str, data: list[str], directory: str, no_report: bool, by_signal: bool, quiet: bool,
            progress: Any) -> Outcome: ...
def identify(*, case_file: str, data: list[str], directory: str, fresh: bool, no_report: bool, profile: bool, plan: bool,
             leave_out: str, correlation_time: float, by_signal: bool, quiet: bool, progress: Any) -> Outcome: ...
def diagnose(*, case_file: str, data: list[str], directory: str, fresh: bool, no_report: bool, time_limit: float,
             by_run: bool, no_by_run: bool, by_signal: bool, quiet: bool, progress: Any) -> Outcome: ...
def study(*, study_file: str, directory: str, threads: int, fresh: bool, no_report: bool, by_signal: bool, quiet: bool,
          progress: Any) -> Outcome: ...
