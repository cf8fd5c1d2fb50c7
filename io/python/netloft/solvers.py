# SPDX-License-Identifier: BSD-3-Clause
"""Solvers and strategies that are written in Python."""

import re

from . import _netloft


def solver(function=None, *, name=None):
    """Makes a callable a solver, beside "newton" and the others.

    It is called with a Problem, whose `evaluate(u, tangent=True)` returns energy [J] and residual [N], whose
    `factorise()` and `solve(rhs)` work with the tangent, and whose `progress(u, energy, residual)` it has to
    call after each step: it returns whether to go on. Netloft decides whether the last point is an
    equilibrium. An exception ends the search.

        @netloft.solver
        def plain_newton(problem):
            u = problem.u
            energy, r = problem.evaluate(u, tangent=True)
            while problem.progress(u, energy, r) and problem.factorise(indefinite=True):
                u = u - problem.solve(r)
                energy, r = problem.evaluate(u, tangent=True)
    """
    return _component(function, name, _netloft.add_solver)


def strategy(function=None, *, name=None):
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


def _component(function, name, add):
    if function is None:
        return lambda f: _component(f, name, add)
    own = name or re.sub(r"[^a-z0-9]+", "_", function.__name__.lower()).strip("_")
    add(own, (function.__doc__ or "written in Python").strip().splitlines()[0], function)
    function.netloft_name = own
    return function


def compare(scene, solvers, **options):
    """Solves a scene by several solvers, each alone, and returns a dict by their names: status, iterations,
    factorisations, seconds, and the largest distance of a node from the first answer that converged [m].
    """
    import numpy

    table, reference = {}, None
    for one in solvers:
        name = getattr(one, "netloft_name", one)
        result = scene.solve(solver=name, raises=False, **options)
        row = {"status": result.status, "reason": result.reason, "result": result}
        if reference is None and result.status == "converged":
            reference = result
        cost = result.to_dict()
        row.update(iterations=cost["iterations"], factorisations=cost["factorisations"], seconds=cost["cpu_seconds"], distance=float("nan"))
        if reference is not None:
            row["distance"] = float(numpy.linalg.norm(result.points - reference.points, axis=1).max())
        table[name] = row
    return table
