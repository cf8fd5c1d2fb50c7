# SPDX-License-Identifier: BSD-3-Clause
"""Many solves of one scene."""

import itertools
import multiprocessing
from concurrent.futures import ProcessPoolExecutor

from .errors import WrongInput
from .names import Named


def _solve_one(scene, changes, error):
    try:
        result = scene.with_(changes).solve(error=error, raises=False)
    except WrongInput as wrong:
        return "wrong input", str(wrong), {}
    return result.status, result.reason, dict(result.report)


def _coordinate(values):
    """The values of a variable as a coordinate: numbers with one unit ("2.5 kn" and 2.5), or texts."""
    numbers, units = [], set()
    for value in values:
        number, _, unit = value.partition(" ") if isinstance(value, str) else (value, "", getattr(value, "unit", ""))
        try:
            numbers.append(float(number))
        except (TypeError, ValueError):
            return [str(v) for v in values], ""
        units.add(unit)
    return (numbers, units.pop()) if len(units) == 1 else ([str(v) for v in values], "")


class Study:
    """The results of a study. `rows` has (values, status, reason, figures) for every point, the last variable
    changing fastest; `failed` those without an equilibrium."""

    def __init__(self, scene, variables, rows):
        self.scene, self.variables, self.rows = scene, variables, rows

    @property
    def failed(self):
        return [row for row in self.rows if row[1] != "converged"]

    def to_xarray(self):
        """An xarray.Dataset with a dimension for each variable and a variable for each figure; `status` has the
        outcomes. Figures of points without an equilibrium are NaN."""
        import numpy
        import xarray

        shape = [len(values) for values in self.variables.values()]
        dims = list(self.variables)
        known, status = {}, []
        for values, outcome, _, figures in self.rows:
            status.append(outcome)
            for name, q in figures.items():
                known.setdefault(name, q)
        data = {"status": (dims, numpy.array(status).reshape(shape))}
        for name, q in known.items():
            column = [float(row[3][name]) if row[1] == "converged" and name in row[3] else numpy.nan for row in self.rows]
            data[name] = (dims, numpy.array(column).reshape(shape), {"units": q.unit, "long_name": q.doc})
        coords = {}
        for name, values in self.variables.items():
            numbers, unit = _coordinate(values)
            coords[name] = (name, numbers, {"units": unit})
        return xarray.Dataset(data, coords=coords, attrs={"scene": str(self.scene.file), "changes": list(self.scene.changes)})

    def __repr__(self):
        lines = Named("variable", {name: list(values) for name, values in self.variables.items()})
        return f"<netloft.Study of {len(self.rows)} points, {len(self.failed)} without an equilibrium>\n{lines!r}"


def study(scene, variables, workers=1, error=False, progress=None):
    """Solves a scene for all combinations of values: study(gear, {"tow.speed": ["2 kn", "3 kn"], "gear.nodes": [500, 1000]}).

    Each point is solved alone, from the sketch, so that results depend neither on the others nor on the number
    of workers. workers: processes (on systems that can fork). error: with the errors of the mesh.
    progress: called with the number of points done and that of all.
    """
    variables = {path: list(values) for path, values in variables.items()}
    for path, values in variables.items():
        if not values:
            raise ValueError(f"{path} has no values")
    points = [dict(zip(variables, values)) for values in itertools.product(*variables.values())]
    rows = []

    def keep(point, outcome):
        rows.append((point, *outcome))
        if progress is not None:
            progress(len(rows), len(points))

    if workers == 1:
        for point in points:
            keep(point, _solve_one(scene, point, error))
    else:
        with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("fork")) as pool:
            outcomes = pool.map(_solve_one, itertools.repeat(scene), points, itertools.repeat(error))
            for point, outcome in zip(points, outcomes):
                keep(point, outcome)
    return Study(scene, variables, rows)
