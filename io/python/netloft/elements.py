# SPDX-License-Identifier: BSD-3-Clause
"""Elements that are written in Python, as an energy: for trying out a model, not for speed."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from . import _netloft

if TYPE_CHECKING:
    from numpy.typing import NDArray

Energy = TypeVar("Energy", bound=Callable[..., Any])

_OUTER = 1e300  # the range of a parameter without limits


class Parameter:
    """A real parameter of an element: its SI unit ("1": a pure number), a sentence, a default and its range."""

    def __init__(self, unit: str, doc: str, default: float | None = None, low: float = 0.0, high: float = _OUTER) -> None:
        self.unit, self.doc, self.default, self.low, self.high = unit, doc, default, low, high


class _Values:
    """The parameters and data of some elements, each an array over the elements."""

    def __init__(self, names: Sequence[str], rows: Iterable[Any]) -> None:
        for name, row in zip(names, rows):
            setattr(self, name, row)


def _gradient(energy: Callable[..., Any], x: NDArray[Any], values: _Values) -> NDArray[Any]:
    """dE/dx [dof, element] by a complex step: exact to rounding, if the energy is analytic."""
    import numpy

    nodes = len(x) // 3
    gradient = numpy.empty_like(x)
    for d in range(len(x)):
        step = numpy.zeros((len(x), 1), complex)
        step[d] = 1e-200j
        gradient[d] = energy((x + step).T.reshape(-1, nodes, 3), values).imag / 1e-200
    return gradient


def _differentiated(energy: Callable[..., Any], parameters: Sequence[str], data: Sequence[str]) -> Callable[..., Any]:
    """The function that the module calls: energies, forces and tangents of a tile of elements."""
    import numpy

    widths = {"u": 3, "v": 3, "to_aft": 3}

    def derivatives(x: NDArray[Any], parameter_rows: Any, data_rows: Any, with_tangent: bool) -> tuple[NDArray[Any], ...]:
        values = _Values(parameters, parameter_rows)
        at = 0
        for name in data:
            width = widths.get(name, 1)
            setattr(values, name, data_rows[at] if width == 1 else data_rows[at : at + width].T)
            at += width
        with numpy.errstate(all="ignore"):  # what is not finite is answered by a shorter step
            energies = energy(x.T.reshape(-1, len(x) // 3, 3).astype(complex), values).real
            forces = _gradient(energy, x, values)
            tangent = numpy.zeros((0, 0, 0))
            if with_tangent:
                h = 1e-5 * numpy.maximum(numpy.ptp(x.reshape(-1, 3, x.shape[1]), axis=0).max(axis=0), 1e-3)
                tangent = numpy.empty((len(x), *x.shape))
                for d in range(len(x)):
                    step = numpy.zeros_like(x)
                    step[d] = h
                    tangent[d] = (_gradient(energy, x + step, values) - _gradient(energy, x - step, values)) / (2 * h)
                tangent = (tangent + tangent.transpose(1, 0, 2)) / 2
        return energies, forces, tangent

    return derivatives


def element(nodes: int, parameters: Mapping[str, Parameter], data: Iterable[str] = (), from_outside: bool = False,
            name: str | None = None) -> Callable[[Energy], Energy]:
    """Makes an energy an element of type "NAME/energy", whose forces and tangent follow by differentiation.

    nodes: 1 (a point), 2 (a bar, along a rope) or 3 (a triangle, in netting).
    parameters: {name: Parameter}; in a scene they are keys of a table: "spring.EA" is EA in the table spring.
    data: what the host gives for each element: "rest_length" of a bar, "u", "v" and "bar_length" of a triangle.
    from_outside: the forces need not sum to zero, because something that is no node takes them.

    The energy is called with positions [element, node, axis] in metres and an object that has parameters (by
    the last word of their names) and data as arrays over the elements. It returns one energy per element [J]. Positions are
    complex, because the gradient is found by a complex step: use sums, products, powers, numpy.sqrt and the like, no
    abs(), norm() or conj(), and decide by the real part. It is some hundred times slower than a plugin.

    A later element of the same name, nodes, parameters and data takes the place of this one in scenes that are solved
    from then on; with others it is Refused, and needs another name.

        @netloft.element(nodes=2, parameters={"spring.EA": netloft.Parameter("N", "axial stiffness")}, data=["rest_length"])
        def spring(x, of):
            "An elastic bar"
            chord = x[:, 1] - x[:, 0]
            length = numpy.sqrt((chord * chord).sum(axis=1))
            return of.EA * (length - of.rest_length) ** 2 / (2 * of.rest_length)
    """

    def make(energy: Energy) -> Energy:
        own = name or re.sub(r"[^a-z0-9]+", "-", energy.__name__.lower()).strip("-")
        doc = (energy.__doc__ or "an element in Python").strip().splitlines()[0]
        rows = [_netloft.RealParameter(key, p.unit, p.doc, p.low if p.default is None else p.default, p.low, p.high, p.default is None)
                for key, p in parameters.items()]
        short = [key.split(".")[-1] for key in parameters]
        _netloft.add_element(own, doc, nodes, rows, list(data), from_outside, _differentiated(energy, short, list(data)))
        setattr(energy, "netloft_name", f"{own}/energy")
        return energy

    return make


def check(component: Callable[..., Any] | str) -> list[tuple[str, str, str, str]]:
    """What `netloft test` says of an element: a list of (check, "passed", "skipped" or "failed", detail, hint)."""
    return _netloft.check_component(getattr(component, "netloft_name", component))
