# SPDX-License-Identifier: BSD-3-Clause
"""Results: figures with units and errors, shapes as arrays, derivatives."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from . import _netloft
from .names import Named, unknown
from .quantity import Quantity, in_unit

if TYPE_CHECKING:
    import numpy
    import scipy.sparse
    import xarray
    from numpy.typing import NDArray

    from ._tables import Changes, Outputs
    from .scene import Scene

    Array = NDArray[numpy.float64]
    IntArray = NDArray[numpy.uint32]
    Blocks = dict[str, list[tuple[IntArray, dict[str, Any]]]]  # by the kind of cells: nodes, and data of these cells
    Cells = list[tuple[str, IntArray]]
else:

    class Outputs:
        """The outputs of elements, as known to editors (_tables.pyi)."""


def _quantity(number: tuple[Any, ...]) -> tuple[str, Quantity]:
    name, value, unit, doc, *errors = number
    return name, Quantity(value, unit, doc, *errors)


def joined(blocks: Blocks) -> tuple[Cells, dict[str, list[Array]]]:
    """Cells and data of some parts, {kind: [(nodes, {name: values})]}, as meshio.Mesh takes them."""
    import numpy

    blocks = {kind: parts for kind, parts in blocks.items() if parts}
    names = dict.fromkeys(name for parts in blocks.values() for _, data in parts for name in data)
    cells = [(kind, numpy.concatenate([nodes for nodes, _ in parts])) for kind, parts in blocks.items()]
    data = {name: [numpy.concatenate([numpy.broadcast_to(values.get(name, numpy.nan), len(nodes)) for nodes, values in parts])
                   for parts in blocks.values()] for name in names}
    return cells, data


def framed(page: str, width: str, height: int) -> Any:
    """A page in a frame of a notebook. It is no address of its own, because browsers open none beyond 2 MB."""
    import html

    try:
        from IPython.display import IFrame
    except ImportError:
        raise ImportError("view() needs IPython, which notebooks have; page(\"trawl.html\") writes the page for a browser") from None
    return IFrame("about:blank", width, height, extras=[f'srcdoc="{html.escape(page)}"'])


class PartResult(Outputs):
    """The elements of one part in a result, as arrays that cannot be written to.

    `nodes` [element, corner] are rows of Equilibrium.points. Every output of the elements is an attribute, such
    as `tension` [element]; `units` and `docs` say what they are.
    """

    def __init__(self, name: str, blocks: list[tuple[Any, ...]]) -> None:
        self.name = name
        main = max(blocks, key=lambda block: int(block[2].shape[1]))
        self.type: str = main[1]
        self.nodes: IntArray = main[2]
        self.outputs: dict[str, Array] = {}
        self.units: dict[str, str] = {}
        self.docs: dict[str, str] = {}
        for _, _, _, outputs in sorted(blocks, key=lambda block: block is not main):
            for key, (values, unit, doc) in outputs.items():
                if key not in self.outputs:
                    self.outputs[key], self.units[key], self.docs[key] = values, unit, doc

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or "outputs" not in self.__dict__:
            raise AttributeError(name)
        if name in self.outputs:
            return self.outputs[name]
        raise AttributeError(unknown(f"output of {self.name}", name, list(self.outputs)))

    def __dir__(self) -> list[str]:
        return ["name", "type", "nodes", "units", "docs", *self.outputs]

    def __repr__(self) -> str:
        lines = [f"<{self.name}: {len(self.nodes)} elements {self.type}>"]
        for name, values in self.outputs.items():
            lines.append(f"  {name:<20} {values.min():.6g} to {values.max():.6g} {self.units[name]}")
        return "\n".join(lines)


class Report:
    """The common part of all results: an outcome, figures, text."""

    def __init__(self, answer: Any) -> None:
        self._answer = answer
        self.status: str = answer.status
        self.stability: str = answer.stability
        self.reason: str = answer.reason
        self.at_fault: str = answer.at_fault
        self.warnings: tuple[str, ...] = tuple(answer.warnings)
        self.report = Named("figure", dict(map(_quantity, answer.figures())))

    def to_dict(self) -> dict[str, Any]:
        """All numbers of the result as `netloft report --json` has them."""
        numbers: dict[str, Any] = json.loads(self._answer.json())
        return numbers

    def text(self) -> str:
        """The report as text."""
        return str(self._answer.text())

    @property
    def parts(self) -> tuple[str, ...]:
        """The names of the parts."""
        raise NotImplementedError

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.parts)

    def __repr__(self) -> str:
        figures = Named("figure", {name: self.report[name] for name in self._answer.key_figures()})
        words = [self.status, self.stability, f"{len(self.warnings)} warnings (.warnings)" if self.warnings else ""]
        head = f"<{', '.join(filter(None, words))}>"
        return f"{head}\n{figures!r}" if figures else head


class Equilibrium(Report):
    """A scene and the shape at which its search ended."""

    def __init__(self, scene: Scene, answer: _netloft.Answer) -> None:
        super().__init__(answer)
        self.scene = scene
        self._blocks: dict[str, list[tuple[Any, ...]]] | None = None
        self._found: dict[tuple[tuple[str, ...], bool], tuple[list[str], list[Any]]] = {}

    # ------------------------------------------------------------ shapes

    @property
    def points(self) -> Array:
        """Positions of the nodes [node, 3] in metres; z points up and is zero at the surface."""
        return self._answer.points

    @property
    def u(self) -> Array:
        """Displacements of the unknowns from the start of the scene [m]."""
        return self._answer.u

    def _elements(self) -> dict[str, list[tuple[Any, ...]]]:
        if self._blocks is None:
            self._blocks = {}
            for block in self._answer.elements():
                self._blocks.setdefault(block[0], []).append(block)
        return self._blocks

    @property
    def parts(self) -> tuple[str, ...]:
        """The names of the parts that have elements."""
        return tuple(self._elements())

    def __getitem__(self, part: str) -> PartResult:
        blocks = self._elements().get(part)
        if blocks is None:
            raise KeyError(unknown("part", part, list(self._elements())))
        return PartResult(part, blocks)

    def mesh(self) -> tuple[Array, Cells, dict[str, list[Array]]]:
        """(points, cells, data) as meshio.Mesh takes them: `cells` is a list of ("triangle" or "line", nodes
        [cell, corner]), `data` has every output of the elements, one array for each block of cells, NaN where
        a cell has none; "part" is an index of `parts`."""
        blocks: Blocks = {"triangle": [], "line": []}
        for index, part in enumerate(self.parts):
            result = self[part]
            kind = {3: "triangle", 2: "line"}.get(result.nodes.shape[1])
            if kind and len(result.nodes):
                blocks[kind].append((result.nodes, {"part": index, **result.outputs}))
        return self.points, *joined(blocks)

    def to_xarray(self) -> xarray.Dataset:
        """An xarray.Dataset with the positions of nodes and all figures, units in their attributes."""
        import xarray

        data: dict[str, Any] = {"points": (("node", "axis"), self.points, {"units": "m"})}
        for name, q in self.report.items():
            data[name] = ((), float(q), {"units": q.unit, "long_name": q.doc, "error": q.error})
        return xarray.Dataset(data, coords={"axis": ["x", "y", "z"]},
                              attrs={"scene": str(self.scene.file), "changes": list(self.scene.changes), "status": self.status})

    def __reduce__(self) -> tuple[Any, ...]:
        """An Equilibrium is pickled as the Stored of its file, which has no scene with which to go on."""
        from .motion import stored

        return stored(self).__reduce__()

    def save(self, path: Path | str) -> None:
        """Writes the result file that `netloft run` writes. An earlier one of that name becomes NAME~."""
        self._answer.write(str(path))

    @overload
    def draw(self, path: None = None, view: str = ..., field: str = ..., width: int = ...) -> str: ...
    @overload
    def draw(self, path: Path | str, view: str = ..., field: str = ..., width: int = ...) -> Path: ...
    def draw(self, path: Path | str | None = None, view: str = "oblique", field: str = "", width: int = 1000) -> str | Path:
        """A picture of the gear, as `netloft draw` makes it: written to path (.svg or .png), or the text of an SVG.

        view: "oblique", "side", "top" or "front". field: what the colours show, such as "tension".
        """
        from .motion import stored

        return stored(self).picture(path, view, field, width=width)

    @overload
    def page(self, path: None = None) -> str: ...
    @overload
    def page(self, path: Path | str) -> Path: ...
    def page(self, path: Path | str | None = None) -> str | Path:
        """The page of `netloft view`, with the gear in three dimensions: written to path, or as a text."""
        from .motion import stored

        return stored(self).page(path)

    def view(self, width: str = "100%", height: int = 600) -> Any:
        """The page of `netloft view` in a notebook."""
        return framed(self.page(), width, height)

    def _repr_svg_(self) -> str:
        return self.draw(width=700)

    # ------------------------------------------------------------ derivatives

    def _sensitivities(self, numbers: Iterable[str] | None, check: bool = False) -> tuple[list[str], list[Any]]:
        key = (tuple(numbers or ()), check)
        if key not in self._found:
            figures, effects = self._answer.sensitivities(list(key[0]), check)
            self._found[key] = [name for name, *_ in figures], effects
        return self._found[key]

    @overload
    def gradient(self, figures: str, numbers: Iterable[str] | None = None, check: bool = ...) -> dict[str, Quantity]: ...
    @overload
    def gradient(self, figures: list[str], numbers: Iterable[str] | None = None, check: bool = ...) -> dict[str, dict[str, Quantity]]: ...
    def gradient(self, figures: str | list[str], numbers: Iterable[str] | None = None, check: bool = False) -> Any:
        """Derivatives of figures with respect to numbers of the scene: {figure: {number: derivative}}, or
        {number: derivative} if `figures` is one name. They are in the units of the figure per that of the
        number as the scene states it, in the order in which numbers are asked for; without `numbers` of all numbers of
        the scene. A number that has none (an integer, for instance) is left out, unless it was asked for: then
        ValueError says why.

        They hold as long as no member becomes slack or taut and no node touches or leaves the ground. With
        check=True they are found by a longer step as well, and are NaN where that finds others.
        """
        wanted = [figures] if isinstance(figures, str) else list(figures)
        names = self.report
        for figure in wanted:
            names[figure]  # KeyError with the likely name
        asked = [numbers] if isinstance(numbers, str) else list(numbers or ())
        index, effects = self._sensitivities(asked or list(self.scene.numbers), check)
        table: dict[str, dict[str, Quantity]] = {figure: {} for figure in wanted}
        places = {path: place for place, path in enumerate(asked)}
        for path, _, unit, why_not, slopes, marks in sorted(effects, key=lambda effect: places.get(effect[0], len(places))):
            if why_not:
                if path in asked:
                    raise ValueError(f"{path} has no derivatives: {why_not}")
                continue
            for figure in wanted:
                f = index.index(figure)
                value = float("nan") if len(marks) and marks[f] else slopes[f]
                per = f"{names[figure].unit or '1'} per {unit or '1'}"
                table[figure][path] = Quantity(value, per)
        return table[figures] if isinstance(figures, str) else table

    def jvp(self, changes: Changes | Mapping[str, float | str]) -> Named[float]:
        """The change of every figure, to first order, when numbers change. A change may have a unit, "0.1 m/s"; one
        without is in the unit in which the scene states the number."""
        total = dict.fromkeys(self.report, 0.0)
        given: dict[str, Any] = dict(changes)
        index, effects = self._sensitivities(list(given))
        for path, _, unit, why_not, slopes, _ in effects:
            if path not in given:
                continue
            if why_not:
                raise ValueError(f"{path} has no derivatives: {why_not}")
            change = in_unit(given[path], unit)
            for name, slope in zip(index, slopes):
                total[name] += float(slope) * change
        return Named("figure", total)

    def vjp(self, weights: Mapping[str, float], numbers: Iterable[str] | None = None) -> dict[str, float]:
        """The derivative of a weighted sum of figures, {"towing/pull": 1.0}, with respect to every number."""
        total: dict[str, float] = {}
        for figure, weight in weights.items():
            for path, slope in self.gradient(figure, numbers).items():
                total[path] = total.get(path, 0.0) + float(weight) * float(slope)
        return total

    # ------------------------------------------------------------ equations

    def residual(self, u: Iterable[float]) -> Array:
        """The imbalance r(u) of the forces over the unknowns [N] at displacements u [m]."""
        return self._answer.residual([float(x) for x in u])

    def tangent(self) -> scipy.sparse.csr_matrix:
        """K = dr/du at the answer [N/m], a scipy.sparse.csr_matrix."""
        from scipy.sparse import csc_matrix, tril

        values, rows, starts, symmetric = self._answer.tangent()
        size = len(starts) - 1
        K = csc_matrix((values, rows, starts), shape=(size, size))
        return (K + tril(K, -1).T if symmetric else K).tocsr()

    def solve(self, b: Array) -> Array:
        """K⁻¹ b: the displacements that additional forces −b [N] cause, to first order [m]."""
        return self._answer.solve([float(x) for x in b], False)

    def solve_adjoint(self, v: Array) -> Array:
        """K⁻ᵀ v."""
        return self._answer.solve([float(x) for x in v], True)
