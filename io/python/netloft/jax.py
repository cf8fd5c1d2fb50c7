# SPDX-License-Identifier: BSD-3-Clause
"""Figures of a scene as a differentiable function of JAX, which has to be installed for it.

    import netloft.jax
    height = netloft.jax.figures(gear, ["tow.speed", "ropes.headrope.length"], ["mouth/headline_height"])
    jax.jacrev(height)(jax.numpy.array([3.0, 25.3]))
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import jax
import numpy

from .bridge import Figures
from .scene import Scene


def figures(scene: Scene, numbers: Iterable[str], figures: Iterable[str]) -> Callable[[Any], Any]:
    """A function of an array of numbers, in the units of the scene, that returns an array of figures.

    It has derivatives in reverse mode, by Equilibrium.vjp(), and works under jax.jit. Numbers are those of float64
    only if JAX is told to use them (jax_enable_x64).
    """
    of = Figures(scene, numbers, figures)

    def values(x: Any) -> Any:
        return numpy.asarray(of.values(numpy.asarray(x)), x.dtype)

    def slopes(x: Any, weights: Any) -> Any:
        return numpy.asarray(of.vjp(numpy.asarray(x), numpy.asarray(weights)), x.dtype)

    @jax.custom_vjp
    def call(x: Any) -> Any:
        return jax.pure_callback(values, jax.ShapeDtypeStruct((len(of.figures),), x.dtype), x)

    def forward(x: Any) -> Any:
        return call(x), x

    def backward(x: Any, weights: Any) -> Any:
        return (jax.pure_callback(slopes, jax.ShapeDtypeStruct((len(of.numbers),), x.dtype), x, weights),)

    call.defvjp(forward, backward)
    return call
