# SPDX-License-Identifier: BSD-3-Clause
"""Results in files: equilibria and motions, their shapes, pictures and pages."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from . import _netloft
from .errors import Interrupted, NotConverged
from .names import Named, unknown
from .result import Equilibrium, Report, framed, joined

if TYPE_CHECKING:
    import xarray

    from .result import Array, Cells
    from .scene import Scene


class Stored(Report):
    """A result in a file: an equilibrium, or a motion with a state at each of `times` [s]. It can be pickled, with all that
    its file holds."""

    def __init__(self, stored: _netloft.Stored, path: Path | str, content: bytes | None = None) -> None:
        super().__init__(stored)
        self.path = Path(path)
        self.times: Array = stored.times
        self._content = content  # of a file that is no more

    def __reduce__(self) -> tuple[Any, ...]:
        return stored_from, (self.path.read_bytes() if self._content is None else self._content, self.path)

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of the fields of cells, such as "tension"."""
        return tuple(self._answer.fields())

    @property
    def parts(self) -> tuple[str, ...]:
        """The names of the parts."""
        return tuple(dict.fromkeys(name for _, _, names in self._answer.mesh().values() for name in names))

    @property
    def series(self) -> Named[Array]:
        """Numbers over time: {name: array [time]}, with units in `units_of_series`."""
        return Named("series", {name: values for name, (values, _) in self._answer.series().items()})

    @property
    def units_of_series(self) -> dict[str, str]:
        """The units of the series, by their names."""
        return {name: unit for name, (_, unit) in self._answer.series().items()}

    def points(self, state: int = -1) -> Array:
        """Positions of the nodes in a state [node, 3], in metres."""
        return self._answer.points(state)

    def field(self, name: str, state: int = -1) -> Array:
        """A field, one number for each cell of the file; NaN for cells without a value."""
        if name not in self.fields:
            raise KeyError(unknown("field", name, list(self.fields)))
        return self._answer.field(name, state)

    def mesh(self, state: int = -1) -> tuple[Array, Cells, dict[str, list[Array]]]:
        """(points, cells, data), as Equilibrium.mesh()."""
        fields = {name: self.field(name, state) for name in self.fields}
        parts = {name: index for index, name in enumerate(self.parts)}
        blocks = {}
        for kind, (nodes, numbers, names) in self._answer.mesh().items():
            if len(nodes):
                data = {name: values[numbers] for name, values in fields.items()}
                blocks[kind] = [(nodes, {"part": [parts[name] for name in names], **data})]
        return self.points(state), *joined(blocks)

    def to_xarray(self) -> xarray.Dataset:
        """An xarray.Dataset: series over time, and positions [time, node, axis], with units."""
        import numpy
        import xarray

        data: dict[str, Any] = {"points": (("time", "node", "axis"), numpy.stack([self.points(i) for i in range(max(1, len(self.times)))]), {"units": "m"})}
        units = self.units_of_series
        for name, values in self.series.items():
            padded = numpy.full(max(1, len(self.times)), numpy.nan)
            padded[: len(values)] = values
            data[name] = ("time", padded, {"units": units[name]})
        times = self.times if len(self.times) else [0.0]
        return xarray.Dataset(data, coords={"time": ("time", times, {"units": "s"}), "axis": ["x", "y", "z"]}, attrs={"status": self.status})

    @overload
    def picture(self, path: None = None, view: str = ..., field: str = ..., state: int = ..., width: int = ...) -> str: ...
    @overload
    def picture(self, path: Path | str, view: str = ..., field: str = ..., state: int = ..., width: int = ...) -> Path: ...
    def picture(self, path: Path | str | None = None, view: str = "oblique", field: str = "", state: int = -1, width: int = 1000) -> str | Path:
        """A picture of a state: written to path (.svg or .png), or returned as the text of an SVG."""
        if path is not None and Path(path).suffix not in (".svg", ".png"):
            raise ValueError(f"{path}: a picture is written as .svg or .png")
        is_png = path is not None and Path(path).suffix == ".png"
        if field and field != "part" and field not in self.fields:
            raise ValueError(unknown("field", field, list(self.fields)))
        content = self._answer.picture(is_png, view, field, state, width)
        if path is None:
            return content.decode()
        Path(path).write_bytes(content)
        return Path(path)

    @overload
    def page(self, path: None = None, most_states: int = ...) -> str: ...
    @overload
    def page(self, path: Path | str, most_states: int = ...) -> Path: ...
    def page(self, path: Path | str | None = None, most_states: int = 60) -> str | Path:
        """The page of `netloft view` in one file, written to path or returned as a text."""
        text = _netloft.page([self._answer], most_states)
        if path is None:
            return text
        Path(path).write_text(text, encoding="utf-8")
        return Path(path)

    def view(self, width: str = "100%", height: int = 600) -> Any:
        """The page of `netloft view` in a notebook."""
        return framed(self.page(), width, height)

    def _repr_svg_(self) -> str:
        return self.picture(width=700)


def read(path: Path | str) -> Stored:
    """The result in a file that `netloft run` or Equilibrium.save() wrote."""
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such result file")
    return Stored(_netloft.Stored(path), path)


def stored_from(content: bytes, path: Path) -> Stored:
    """The result in the bytes of a file that had this path."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "result.hdf"
        file.write_bytes(content)
        return Stored(_netloft.Stored(file), path, content)


def stored(equilibrium: Equilibrium) -> Stored:
    """An equilibrium as the result that its file would hold."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / (equilibrium.scene.file.stem + ".hdf")
        equilibrium.save(path)
        return Stored(_netloft.Stored(path), path, path.read_bytes())


def simulate(scene: Scene, times: Iterable[float] | None = None, output: Path | str | None = None,
             progress: Callable[[float, float], object] | None = None) -> Stored:
    """The motion of a scene with `analysis.kind = "dynamic"`.

    times: the times of the outputs [s], from 0 on in equal steps; without them those of the scene.
    output: the result file; without it the motion is kept in memory only.
    progress: called after each step with the time reached and that of the end [s].
    Raises WrongInput, Refused, NotConverged (whose `result` has the motion so far), Interrupted.
    """
    if times is not None:
        scene = scene.with_(_outputs_at(times))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(output) if output else Path(folder) / (scene.file.stem + ".hdf")
        file, warnings, ended_by = scene._opened.simulate(path, progress)
        motion = Stored(_netloft.Stored(file), file, None if output else file.read_bytes()) if file.is_file() else None
        if motion is not None:
            motion.warnings = (*motion.warnings, *(w for w in warnings if w not in motion.warnings))
        if isinstance(ended_by, KeyboardInterrupt):
            raise Interrupted(motion) from ended_by
        if ended_by is not None:
            raise ended_by
        assert motion is not None, "a motion that ends by itself has a file"
        if motion.status != "finished":
            raise NotConverged(motion)
        return motion


def _outputs_at(wanted: Iterable[float]) -> dict[str, float]:
    times = [float(t) for t in wanted]
    step = times[-1] / (len(times) - 1) if len(times) > 1 else 0
    if not step > 0 or any(abs(t - i * step) > 1e-9 * times[-1] for i, t in enumerate(times)):
        raise ValueError("the times of outputs begin at 0 and grow in equal steps, as numpy.linspace(0, 10, 101) does")
    return {"analysis.duration": times[-1], "analysis.output_interval": step}
