# SPDX-License-Identifier: BSD-3-Clause
"""Numbers with a unit, an error and a sentence."""

from __future__ import annotations

import math
from typing import Any, Self


class Quantity(float):
    """A float that knows its unit, its error and what it is.

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
        return f"{float(self):.6g} ± {self.error:.1g}{unit}"

    __str__ = __repr__

    def __getnewargs__(self) -> Any:
        return (float(self), self.unit, self.doc, self.solver_error, self.mesh_error, self.least, self.largest)
