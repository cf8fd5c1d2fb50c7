# SPDX-License-Identifier: BSD-3-Clause
"""Figures as functions of numbers, for libraries that differentiate (torch.py, jax.py)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from .names import unknown
from .quantity import Quantity

if TYPE_CHECKING:
    from .result import Equilibrium
    from .scene import Scene


class Figures:
    """Figures of a scene as a function of some of its numbers, each in the unit of the scene.

    Every figure belongs to the equilibrium that is found from that of the scene itself, on the same mesh. So it depends on the numbers alone, not on those before, and it is smooth as long as no other equilibrium is found.
    """

    def __init__(self, scene: Scene, numbers: Iterable[str], figures: Iterable[str]) -> None:
        self.scene, self.numbers, self.figures = scene, list(numbers), list(figures)
        self._written = [scene.numbers[path] for path in self.numbers]  # KeyError with the likely name
        self.reference = scene.solve()
        for figure in self.figures:
            self.reference.report[figure]
        self._last: tuple[tuple[float, ...], Equilibrium] | None = None

    def vector(self, numbers: Mapping[str, Any]) -> list[Any]:
        """The values of a dict of numbers in their order. Those that it leaves out are as in the scene."""
        for path in numbers:
            if path not in self.numbers:
                raise KeyError(unknown("number", path, self.numbers))
        return [numbers.get(path, float(written)) for path, written in zip(self.numbers, self._written)]

    def solve(self, numbers: Iterable[float]) -> Equilibrium:
        """The equilibrium at these numbers, a list of floats. The last one is kept."""
        numbers = tuple(map(float, numbers))
        if len(numbers) != len(self.numbers):
            raise ValueError(f"{len(numbers)} numbers are given, and the function has {len(self.numbers)}: {', '.join(self.numbers)}")
        if self._last is None or self._last[0] != numbers:
            changes = {path: Quantity(x, written.unit) for path, x, written in zip(self.numbers, numbers, self._written)}
            self._last = numbers, self.scene.with_(changes).solve(start=self.reference, mesh_of=self.reference)
        return self._last[1]

    def values(self, numbers: Iterable[float]) -> list[float]:
        """The figures, a list of floats."""
        report = self.solve(numbers).report
        return [float(report[figure]) for figure in self.figures]

    def jvp(self, numbers: Iterable[float], changes: Iterable[float]) -> list[float]:
        """The changes of the figures, to first order, by changes of the numbers."""
        change = self.solve(numbers).jvp(dict(zip(self.numbers, changes)))
        return [change[figure] for figure in self.figures]

    def vjp(self, numbers: Iterable[float], weights: Iterable[float]) -> list[float]:
        """The derivatives of the weighted sum of the figures."""
        slopes = self.solve(numbers).vjp(dict(zip(self.figures, weights)), self.numbers)
        return [slopes[path] for path in self.numbers]
