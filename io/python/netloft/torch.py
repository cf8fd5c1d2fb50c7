# SPDX-License-Identifier: BSD-3-Clause
"""Figures of a scene as a differentiable function of PyTorch, which has to be installed for it.

    import netloft.torch
    height = netloft.torch.figures(gear, ["tow.speed", "ropes.headrope.length"], ["mouth/headline_height"])
    x = torch.tensor([3.0, 25.3], dtype=torch.float64, requires_grad=True)
    height(x).sum().backward()
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import torch

from .bridge import Figures
from .scene import Scene


def figures(scene: Scene, numbers: Iterable[str], figures: Iterable[str]) -> Callable[[Any], Any]:
    """A function of a tensor of numbers, in the units of the scene, that returns a tensor of figures.

    Its argument may also be a dict {number: tensor without dimensions}. Derivatives are those of Equilibrium.vjp()
    and, in forward mode, of jvp(); there are no second ones. Raises what Scene.solve() raises.
    """
    of = Figures(scene, numbers, figures)

    def call(numbers: Any) -> Any:
        if isinstance(numbers, dict):
            numbers = torch.stack([torch.as_tensor(x, dtype=torch.float64) for x in of.vector(numbers)])
        return _Solve.apply(numbers, of)

    return call


class _Solve(torch.autograd.Function):
    @staticmethod
    def forward(context: Any, numbers: Any, of: Figures) -> Any:
        context.at, context.of = numbers.tolist(), of
        return numbers.new_tensor(of.values(context.at))

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(context: Any, weights: Any) -> Any:
        return weights.new_tensor(context.of.vjp(context.at, weights.tolist())), None

    @staticmethod
    def jvp(context: Any, changes: Any, _: None) -> Any:
        return changes.new_tensor(context.of.jvp(context.at, changes.tolist()))
