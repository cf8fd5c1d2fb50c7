# SPDX-License-Identifier: BSD-3-Clause
"""Many solves of one scene."""

from __future__ import annotations

import itertools
import multiprocessing
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from typing import TYPE_CHECKING, Any

from .names import Named, unknown
from .quantity import Quantity

if TYPE_CHECKING:
    import xarray

    from ._tables import Changes
    from .scene import Scene

Outcome = tuple[str, str, dict[str, Quantity]]  # status, reason, figures
Row = tuple[dict[str, Any], str, str, dict[str, Quantity]]  # values, status, reason, figures


def _solve_one(scene: Scene, changes: dict[str, Any], error: bool) -> Outcome:
    result = scene.with_(changes).solve(error=error, raises=False)
    return result.status, result.reason, dict(result.report)


def _coordinate(values: list[Any]) -> tuple[list[Any], str]:
    """The values of a variable as a coordinate: numbers with one unit ("2.5 kn" and 2.5), or texts."""
    numbers: list[Any] = []
    units: set[str] = set()
    for value in values:
        number, _, unit = value.partition(" ") if isinstance(value, str) else (value, "", getattr(value, "unit", ""))
        try:
            numbers.append(float(number))
        except (TypeError, ValueError):
            return [str(v) for v in values], ""
        units.add(unit)
    return (numbers, units.pop()) if len(units) == 1 else ([str(v) for v in values], "")


def _labelled(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


class Study:
    """The results of a study. `rows` has (values, status, reason, figures) for every point, the last variable
    changing fastest; `failed` those without an equilibrium. `dims` are the dimensions of its points with their
    lengths: the variables of a grid, or "point" for a list."""

    def __init__(self, scene: Scene, variables: dict[str, list[Any]], dims: dict[str, int], rows: list[Row]) -> None:
        self.scene, self.variables, self.dims, self.rows = scene, variables, dims, rows

    @property
    def failed(self) -> list[Row]:
        """The rows of points without an equilibrium."""
        return [row for row in self.rows if row[1] != "converged"]

    def to_xarray(self) -> xarray.Dataset:
        """An xarray.Dataset with a dimension for each variable and a variable for each figure; `status` has the
        outcomes. Figures of points without an equilibrium are NaN. With error=True each figure has its error of the
        mesh beside it, as "NAME/error"."""
        import numpy
        import xarray

        dims, shape = list(self.dims), list(self.dims.values())
        known: dict[str, Quantity] = {}
        status = []
        for _, outcome, _, figures in self.rows:
            status.append(outcome)
            for name, q in figures.items():
                known.setdefault(name, q)
        data: dict[str, Any] = {"status": (dims, numpy.array(status).reshape(shape))}
        for name, q in known.items():
            column = [float(row[3][name]) if row[1] == "converged" and name in row[3] else numpy.nan for row in self.rows]
            data[name] = (dims, numpy.array(column).reshape(shape), {"units": q.unit, "long_name": q.doc})
            errors = [row[3][name].mesh_error if name in row[3] else numpy.nan for row in self.rows]
            if not numpy.isnan(errors).all():
                data[f"{name}/error"] = (dims, numpy.array(errors).reshape(shape), {"units": q.unit, "long_name": "error of the mesh"})
        coords = {}
        for name, values in self.variables.items():
            numbers, unit = _coordinate(values)
            coords[name] = (name if name in self.dims else "point", numbers, {"units": unit})
        return xarray.Dataset(data, coords=coords, attrs={"scene": str(self.scene.file), "changes": list(self.scene.changes)})

    def plot(self, figure: str, axes: Any = None) -> Any:
        """A figure over the variable of a study with one, and the band of its error; returns the axes of matplotlib, which has
        to be installed. Without error=True the band is that of the solver alone, and too narrow to be seen."""
        import matplotlib.pyplot
        import numpy

        if len(self.variables) != 1:
            raise ValueError(f"a plot has one variable, and the study has {len(self.variables)}; take what it is from to_xarray()")
        [(name, values)] = self.variables.items()
        solved = [(x, row[3][figure]) for x, row in zip(_coordinate(values)[0], self.rows) if row[1] == "converged" and figure in row[3]]
        if not solved:
            raise KeyError(unknown("figure", figure, dict.fromkeys(known for row in self.rows for known in row[3])))
        x, y = [at for at, _ in solved], numpy.array([float(q) for _, q in solved])
        band = numpy.array([q.error for _, q in solved])
        axes = matplotlib.pyplot.subplots()[1] if axes is None else axes
        axes.fill_between(x, y - band, y + band, alpha=0.3)
        axes.plot(x, y, marker="o")
        axes.set(xlabel=_labelled(name, _coordinate(values)[1]), ylabel=_labelled(figure, solved[0][1].unit), title=solved[0][1].doc)
        return axes

    def __repr__(self) -> str:
        lines = Named("variable", {name: list(values) for name, values in self.variables.items()})
        return f"<netloft.Study of {len(self.rows)} points, {len(self.failed)} without an equilibrium>\n{lines!r}"


def points(ranges: Mapping[str, tuple[Any, Any]], draws: Iterable[Iterable[float]]) -> list[dict[str, Any]]:
    """The points of a design in the unit cube, as study() takes them: `ranges` is {path: (low, high)}, numbers or
    texts with a unit, and `draws` has a row for each point and a column for each path, from 0 to 1."""
    scaled: dict[str, list[Any]] = {}
    for path, column in zip(ranges, zip(*draws, strict=True), strict=True):
        (low, high), unit = _coordinate(list(ranges[path]))
        if isinstance(low, str):
            raise ValueError(f"{path}: both ends of its range have to be numbers with the same unit")
        scaled[path] = [f"{low + (high - low) * float(x)!r} {unit}" if unit else low + (high - low) * float(x) for x in column]
    return [dict(zip(scaled, values)) for values in zip(*scaled.values())]


def study(scene: Scene, variables: Changes | Mapping[str, Iterable[Any]] | Iterable[Mapping[str, Any]], workers: int = 1, error: bool = False,
          progress: Callable[[int, int], object] | None = None) -> Study:
    """Solves a scene with other values.

    variables: a grid, {"tow.speed": ["2 kn", "3 kn"], "gear.nodes": [500, 1000]}, of which all combinations are
        solved, or a list of points, each a dict of all variables.
    workers: processes (on systems that can fork). error: with the errors of the mesh.
    progress: called with the number of points done and that of all.
    Each point is solved alone, from the sketch, so that results depend neither on the others nor on the number
    of workers.
    """
    if isinstance(variables, Mapping):
        for path, values in variables.items():
            if isinstance(values, (str, int, float)):
                raise ValueError(f"{path}: {values!r} is one value; a study wants a list of them")
        grid: dict[str, Any] = dict(variables)
        columns = {path: list(values) for path, values in grid.items()}
        design = [dict(zip(columns, values)) for values in itertools.product(*columns.values())]
        dims = {path: len(values) for path, values in columns.items()}
    else:
        design = [dict(point) for point in variables]
        if any(point.keys() != design[0].keys() for point in design):
            raise ValueError("all points of a study need values of the same variables")
        columns = {path: [point[path] for point in design] for path in (design[0] if design else ())}
        dims = {"point": len(design)}
    for path, values in columns.items():
        if not values:
            raise ValueError(f"{path} has no values")
    rows: list[Row] = []

    def keep(point: dict[str, Any], outcome: Outcome) -> None:
        rows.append((point, *outcome))
        if progress is not None:
            progress(len(rows), len(design))

    if workers == 1:
        for point in design:
            keep(point, _solve_one(scene, point, error))
    else:
        with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("fork")) as pool:
            outcomes = pool.map(_solve_one, itertools.repeat(scene), design, itertools.repeat(error))
            for point, outcome in zip(design, outcomes):
                keep(point, outcome)
    return Study(scene, columns, dims, rows)
