# SPDX-License-Identifier: BSD-3-Clause
"""Numbers with a unit, an error and a description."""

from __future__ import annotations

import math
from typing import Any, Self

from . import _netloft


class Quantity(float):
    """A float with its unit, its error and its description.

    `error` is the estimated error in the same unit: that of the mesh, if it was asked for, and that of the
    solver; NaN if neither is known. `least` and `largest` are the range over all equilibria that were found.
    """

    __slots__ = ("unit", "doc", "solver_error", "mesh_error", "least", "largest")

    unit: str
    doc: str
    solver_error: float
    mesh_error: float
    least: float
    largest: float

    def __new__(cls, value: float, unit: str = "", doc: str = "", solver_error: float = math.nan, mesh_error: float = math.nan,
                least: float = math.nan, largest: float = math.nan) -> Self:
        self = super().__new__(cls, value)
        self.unit, self.doc = unit, doc
        self.solver_error, self.mesh_error = solver_error, mesh_error
        self.least, self.largest = least, largest
        return self

    @property
    def error(self) -> float:
        """The estimated error, in the unit of the number."""
        known = [e for e in (self.solver_error, self.mesh_error) if not math.isnan(e)]
        return math.hypot(*known) if known else math.nan

    def __repr__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        if math.isnan(self.error):
            return f"{float(self):.6g}{unit}"
        return f"{float(self):.6g} ± {self.error:.1g}{unit}" + (" (solver)" if math.isnan(self.mesh_error) else "")

    # A multiple keeps the unit, and so does a sum of two numbers with the same unit, so that with_({path: 1.1
    # * number}) works as expected. All other results are plain floats.

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Quantity):
            return float(self) * float(other)
        product = float(self) * other
        return Quantity(product, self.unit) if _is_plain(other) else product

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        ratio = float(self) / other
        return Quantity(ratio, self.unit) if _is_plain(other) else ratio

    def __neg__(self) -> Quantity:
        return Quantity(-float(self), self.unit)

    def __add__(self, other: Any) -> Any:
        total = float(self) + other
        return Quantity(total, self.unit) if isinstance(other, Quantity) and other.unit == self.unit else total

    def __sub__(self, other: Any) -> Any:
        return self + (-other)

    __str__ = __repr__

    def __getnewargs__(self) -> Any:
        return (float(self), self.unit, self.doc, self.solver_error, self.mesh_error, self.least, self.largest)


def _is_plain(number: Any) -> bool:
    return isinstance(number, (int, float)) and not isinstance(number, Quantity)


def in_unit(value: Any, unit: str) -> float:
    """A number in `unit`: a plain one as it is, a text or a quantity with a unit converted."""
    written = value.unit if isinstance(value, Quantity) else ""
    if isinstance(value, str) or (written and written != unit):
        return _netloft.in_unit(value if isinstance(value, str) else f"{float(value)!r} {written}", unit)
    return float(value)
