# SPDX-License-Identifier: BSD-3-Clause
"""Numbers with a unit, an error and a sentence."""

import math


class Quantity(float):
    """A float that knows its unit, its error and what it is.

    `error` is the estimated error in the same unit: that of the mesh, if it was asked for, and that of the
    solver; NaN if neither is known. `least` and `largest` are the range over all equilibria that were found.
    """

    __slots__ = ("unit", "doc", "solver_error", "mesh_error", "least", "largest")

    def __new__(cls, value, unit="", doc="", solver_error=math.nan, mesh_error=math.nan, least=math.nan, largest=math.nan):
        self = super().__new__(cls, value)
        self.unit, self.doc = unit, doc
        self.solver_error, self.mesh_error = solver_error, mesh_error
        self.least, self.largest = least, largest
        return self

    @property
    def error(self):
        known = [e for e in (self.solver_error, self.mesh_error) if not math.isnan(e)]
        return math.hypot(*known) if known else math.nan

    def __repr__(self):
        unit = f" {self.unit}" if self.unit else ""
        if math.isnan(self.error):
            return f"{float(self):.6g}{unit}"
        return f"{float(self):.6g} ± {self.error:.1g}{unit}"

    __str__ = __repr__

    def __getnewargs__(self):
        return (float(self), self.unit, self.doc, self.solver_error, self.mesh_error, self.least, self.largest)
