# SPDX-License-Identifier: BSD-3-Clause
"""Results: the data of `--json`, arrays, and the page for a notebook."""

from __future__ import annotations

import csv
import html
import importlib
import shutil
import tempfile
import weakref
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from . import _tiretherm

Array = npt.NDArray[np.float64]


class WorkFolder:
    """A folder that is made when it is asked for, and is there as long as the object."""

    @cached_property
    def path(self) -> Path:
        """The folder."""
        folder = tempfile.mkdtemp(prefix="tiretherm_")
        weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
        return Path(folder)


def needed(module: str, purpose: str) -> Any:
    """A package that is used where it is there.

    Raises ImportError with the name of the package and what it is wanted for.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise ImportError(f"{purpose} needs the Python package {package}, which cannot be imported: {error}") from error


def conversion(unit: str, to: str) -> tuple[float, float]:
    """Factor and offset from a unit to another. Raises ValueError where they are of other dimensions."""
    return _tiretherm.conversion(unit, to)


class Channel:
    """A channel of a run: SI values with their unit. `np.asarray` and numpy's functions take it as an array."""

    def __init__(self, name: str, values: Array, unit: str, shown: str = "", meaning: str = "") -> None:
        self.name = name
        self.values = values
        """[rows], in `unit`; a view of the run's table, which cannot be written to."""
        self.unit = unit
        self.shown_unit = shown or unit
        """In which pages show it: degC for K."""
        self.meaning = meaning

    def to(self, unit: str = "") -> Array:
        """The values in another unit, as a new array [rows]. Default: the unit in which pages show them."""
        factor, offset = conversion(self.unit, unit or self.shown_unit)
        return factor * self.values + offset

    def __array__(self, dtype: Any = None) -> npt.NDArray[Any]:
        return np.asarray(self.values, dtype)

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, index: Any) -> Any:
        return self.values[index]

    def __repr__(self) -> str:
        return f"<Channel {self.name} [{self.unit}], {len(self)} rows>"


class Fields:
    """Stored fields of a run: temperatures of all nodes at some moments, and the mesh.

    Nodes are the cells first, then surface nodes, then lumped nodes such as the gas.
    """

    def __init__(self, run: _tiretherm.RecordedRun) -> None:
        self._run = run

    @property
    def time(self) -> Array:
        """[fields] s."""
        return self._run.field_time

    @property
    def temperature(self) -> Array:
        """[fields, nodes] K."""
        return self._run.fields

    @cached_property
    def mesh(self) -> dict[str, Any]:
        """kind, cells (a number), centre [nodes, 3] m, volume [nodes] m3, layer and zone [nodes] with their names in layers and
        zones; points [n, 3] m, corners and corners_per_cell of the drawing, in VTK's order, and drawn_cell, the cell of each."""
        return self._run.mesh

    def _drawing(self) -> tuple[npt.NDArray[Any], str, int, npt.NDArray[Any]]:
        mesh = self.mesh
        name, vtk = {1: ("vertex", 1), 2: ("line", 3), 4: ("quad", 9), 8: ("hexahedron", 12)}[mesh["corners_per_cell"]]
        return mesh["corners"].reshape(-1, mesh["corners_per_cell"]), name, vtk, mesh["drawn_cell"]

    def to_meshio(self, index: int = -1) -> Any:
        """One field as a meshio.Mesh with the cell data `temperature` in K."""
        corners, name, _, cell = self._drawing()
        meshio = needed("meshio", "Fields.to_meshio")
        return meshio.Mesh(
            self.mesh["points"], [(name, corners)], cell_data={"temperature": [self.temperature[index][cell]]}
        )

    def to_pyvista(self, index: int = -1) -> Any:
        """One field as a pyvista.UnstructuredGrid with the cell data `temperature` in K."""
        corners, _, vtk, cell = self._drawing()
        pyvista = needed("pyvista", "Fields.to_pyvista")
        grid = pyvista.UnstructuredGrid({vtk: corners}, self.mesh["points"])
        grid.cell_data["temperature"] = self.temperature[index][cell]
        return grid

    def __len__(self) -> int:
        return len(self.time)


class Page:
    """What every result has: `summary`, the data that the command prints with --json, and its page."""

    def __init__(self, outcome: _tiretherm.Outcome, kind: str, source: str) -> None:
        self._outcome = outcome
        self._kind = kind
        self._source = source

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The data of the command's --json."""
        return self._outcome.data or {}

    @property
    def notes(self) -> list[str]:
        """What the call said beside its result."""
        return self._outcome.notes

    @property
    def html(self) -> str:
        """The page with its charts as one HTML file, which needs no network; about a megabyte."""
        return self._outcome.page_html(self._kind, self._source)

    def save_html(self, path: str | Path) -> None:
        """Writes the page."""
        Path(path).write_text(self.html, encoding="utf-8")

    def __str__(self) -> str:
        return self._outcome.page_text()

    def _repr_html_(self) -> str:
        return (
            '<iframe style="width: 100%; height: 720px; border: 0" '
            f'srcdoc="{html.escape(self.html, quote=True)}"></iframe>'
        )


class Tire:
    """One tire of a run: time, channels, heat and fields. Everything in SI units and kelvin."""

    def __init__(self, run: _tiretherm.RecordedRun) -> None:
        self._run = run
        self.fields = Fields(run)

    @property
    def name(self) -> str:
        """Of the run; empty where the case has no [[run]]."""
        return self._run.name

    @property
    def time(self) -> Array:
        """[rows] s."""
        return self._run.time

    @cached_property
    def channels(self) -> dict[str, Channel]:
        """The sensors by their names."""
        values = self._run.values
        return {
            name: Channel(name, values[:, i], unit, shown, meaning)
            for i, (name, unit, shown, meaning) in enumerate(self._run.channels)
        }

    @cached_property
    def budget(self) -> dict[str, Channel]:
        """Heat into the tire by each effect, [rows] W."""
        watts = self._run.watts
        return {name: Channel(name, watts[:, i], "W") for i, name in enumerate(self._run.effects)}

    @cached_property
    def heat(self) -> dict[str, Channel]:
        """The same since the start, [rows] J; `stored` is what is left in the tire."""
        joules = self._run.joules
        heat = {name: Channel(name, joules[:, i], "J") for i, name in enumerate(self._run.effects)}
        heat["stored"] = Channel("stored", self._run.stored, "J")
        return heat

    @property
    def hottest(self) -> dict[str, Any]:
        """The highest temperature of all steps: temperature in K, time in s, node, place in words."""
        return self._run.hottest

    @property
    def coldest(self) -> dict[str, Any]:
        """The lowest one."""
        return self._run.coldest

    @property
    def is_stopped(self) -> bool:
        """Whether the run was ended before its end."""
        return self._run.is_stopped

    def to_pandas(self) -> Any:
        """The channels as a pandas.DataFrame in SI units, a row for each time."""
        pandas = needed("pandas", "to_pandas")
        index = pandas.Index(self.time, name="time [s]")
        return pandas.DataFrame({name: c.values for name, c in self.channels.items()}, index=index)

    def to_xarray(self) -> Any:
        """Channels, heat and fields as an xarray.Dataset with units."""
        xarray = needed("xarray", "to_xarray")
        variables: dict[str, Any] = {
            name: ("time", c.values, {"units": c.unit, "long_name": c.meaning}) for name, c in self.channels.items()
        }
        variables.update({f"heat_{name}": ("time", c.values, {"units": "W"}) for name, c in self.budget.items()})
        variables["temperature"] = (("field_time", "node"), self.fields.temperature, {"units": "K"})
        return xarray.Dataset(
            variables,
            {"time": ("time", self.time, {"units": "s"}), "field_time": ("field_time", self.fields.time)},
        )

    def plot(self, *names: str, ax: Any = None) -> Any:
        """Draws channels over time with matplotlib, in the units of the pages. @returns the axes"""
        chosen = names or tuple(self.channels)
        axes = ax or needed("matplotlib.pyplot", "plot").subplots()[1]
        for name in chosen:
            channel = self.channels[name]
            axes.plot(self.time, channel.to() if channel.unit else channel.values, label=f"{name} [{channel.shown_unit}]")
        axes.set_xlabel("time [s]")
        axes.legend()
        return axes


class Result(Page, Tire):
    """A run. Of a car with [[corner]] tables the arrays are those of its first tire; `tires` has all."""

    def __init__(self, outcome: _tiretherm.Outcome, source: str, folder: Path | None) -> None:
        Page.__init__(self, outcome, "run", source)
        Tire.__init__(self, outcome.runs[0])
        self.tires = {run.corner or run.name: Tire(run) for run in outcome.runs}
        """By their corners FL, FR, RL, RR; of a single tire one entry."""
        self.folder = folder
        """Of the files, where they were asked for."""

    def __repr__(self) -> str:
        return f"<Result of {self._source}: {len(self.time)} rows, channels {', '.join(self.channels)}>"


class Table(Mapping[str, "npt.NDArray[Any]"]):
    """The columns of a CSV file by their headings: arrays of numbers, or of texts where a cell is none."""

    def __init__(self, path: Path) -> None:
        with path.open(newline="", encoding="utf-8") as file:
            lines = (line for line in file if not line.startswith("#"))
            rows = list(csv.reader(lines))
        heads, cells = (rows[0], rows[1:]) if rows else ([], [])
        self._columns = {head: _column([row[i] if i < len(row) else "" for row in cells]) for i, head in enumerate(heads)}

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def to_pandas(self) -> Any:
        """The same as a pandas.DataFrame."""
        return needed("pandas", "to_pandas").DataFrame(self._columns)


def _column(cells: list[str]) -> npt.NDArray[Any]:
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array(cells)


class Files(Page):
    """A result with files: a comparison, a fit, a diagnosis, a study."""

    def __init__(self, outcome: _tiretherm.Outcome, kind: str, source: str, folder: Path, keep: Any) -> None:
        super().__init__(outcome, kind, source)
        self.folder = folder
        """Where its files are. A folder that was not named with `out` is gone when nothing refers to the result."""
        self._keep = keep

    @cached_property
    def tables(self) -> dict[str, Table]:
        """Its CSV files as arrays, by their names: `tables["residuals"]["time [s]"]`."""
        return {path.stem: Table(path) for path in sorted(self.folder.glob("*.csv"))}

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self._source}: tables {', '.join(self.tables)}>"


class Comparison(Files):
    """Simulated beside measured, channel by channel. Differences are simulated - measured."""


class Identification(Files):
    """A fit: values and 95 % intervals in `summary`, residuals in `tables["identify"]`."""

    @property
    def case_file(self) -> Path:
        """The case with the fitted values, for Case.from_file. It includes the original: take it before `result` goes."""
        return self.folder / "identified.toml"

    @property
    def has_converged(self) -> bool:
        """Whether the search came to its end."""
        return self._outcome.exit == 0


class Diagnosis(Files):
    """The verdict and its causes in `summary`."""

    @property
    def case_file(self) -> Path | None:
        """The case with the cause switched on, for Case.from_file; None where there is none."""
        path = self.folder / "extended.toml"
        return path if path.is_file() else None


class StudyResult(Files):
    """A row for each run in `tables["study"]`."""


Measured = TypeVar("Measured", Comparison, Identification, Diagnosis)
