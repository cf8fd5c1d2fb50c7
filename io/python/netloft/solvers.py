# SPDX-License-Identifier: BSD-3-Clause
"""Solvers and strategies that are written in Python."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeVar, overload

from . import _netloft
from ._netloft import Problem as Problem, Search as Search
from .errors import Refused

if TYPE_CHECKING:
    from .result import Equilibrium
    from .scene import Scene

Solver = TypeVar("Solver", bound=Callable[[Problem], object])
Strategy = TypeVar("Strategy", bound=Callable[[Search], object])


@overload
def solver(function: Solver) -> Solver: ...
@overload
def solver(function: None = None, *, name: str | None = None) -> Callable[[Solver], Solver]: ...
def solver(function: Any = None, *, name: str | None = None) -> Any:
    """Makes a callable a solver, beside "newton" and the others.

    It is called with a Problem, whose `evaluate(u, tangent=True)` returns energy [J] and residual [N], whose
    `factorise()` and `solve(rhs)` work with the tangent, and whose `progress(u, energy, residual)` it has to
    call after each step: it returns whether to go on. Netloft decides whether the last point is an
    equilibrium. An exception ends the search, and is the cause of NotConverged. A later solver of the same name
    takes the place of this one.

        @netloft.solver
        def plain_newton(problem):
            u = problem.u
            energy, r = problem.evaluate(u, tangent=True)
            while problem.progress(u, energy, r) and problem.factorise(indefinite=True):
                u = u - problem.solve(r)
                energy, r = problem.evaluate(u, tangent=True)
    """
    return _component(function, name, _netloft.add_solver)


@overload
def strategy(function: Strategy) -> Strategy: ...
@overload
def strategy(function: None = None, *, name: str | None = None) -> Callable[[Strategy], Strategy]: ...
def strategy(function: Any = None, *, name: str | None = None) -> Any:
    """Makes a callable a strategy, beside "auto" and the others: how an equilibrium is found, with solvers.

    It is called with a Search, whose `solve(u, solver=…, level=…, stiffness_cap=…, compression=…, current=…)`
    solves the scene, or an easier variant of it, and returns a dict: u, ending, residual, load, energy, spent,
    iterations, factorisations. `answer(u)` reports an equilibrium of the scene itself, which Netloft judges.

        @netloft.strategy
        def soft_first(search):
            soft = search.solve(search.start, stiffness_cap=1e3)
            stage = search.solve(soft["u"])
            if stage["ending"] == "converged":
                search.answer(stage["u"])
    """
    return _component(function, name, _netloft.add_strategy)


def _component(function: Any, name: str | None, add: Callable[..., None]) -> Any:
    if function is None:
        return lambda f: _component(f, name, add)
    own = name or re.sub(r"[^a-z0-9]+", "_", function.__name__.lower()).strip("_")
    add(own, (function.__doc__ or "written in Python").strip().splitlines()[0], function)
    function.netloft_name = own
    return function


def compare(scene: Scene, solvers: Iterable[Callable[[Problem], object] | str], **options: Any) -> dict[str, dict[str, Any]]:
    """Solves a scene by several solvers, each alone, and returns a dict by their names: status, iterations,
    factorisations, seconds, and the largest distance of a node from the first answer that converged [m]. A solver that
    cannot solve such a scene, because its forces have no energy for instance, is "unfit".
    """
    import numpy

    table: dict[str, dict[str, Any]] = {}
    reference: Equilibrium | None = None
    for one in solvers:
        name: str = one if isinstance(one, str) else getattr(one, "netloft_name")
        try:
            result = scene.solve(solver=name, raises=False, **options)
        except Refused as refused:
            if refused.messages:  # about the scene, or a solver that there is not
                raise
            unknown = dict.fromkeys(("iterations", "factorisations", "seconds", "distance"), float("nan"))
            table[name] = {"status": "unfit", "reason": str(refused), "result": None, **unknown}
            continue
        row: dict[str, Any] = {"status": result.status, "reason": result.reason, "result": result}
        if reference is None and result.status == "converged":
            reference = result
        cost = result.to_dict()
        row.update(iterations=cost["iterations"], factorisations=cost["factorisations"], seconds=cost["cpu_seconds"], distance=float("nan"))
        if reference is not None:
            row["distance"] = float(numpy.linalg.norm(result.points - reference.points, axis=1).max())
        table[name] = row
    return table
