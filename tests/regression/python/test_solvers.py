# SPDX-License-Identifier: BSD-3-Clause
"""Solvers in Python are used like those of plugins, and their results are judged in the same way."""
import faulthandler
import tempfile
import threading
import unittest
from pathlib import Path

import numpy
import scipy.optimize

import netloft


@netloft.solver
def damped_newton(problem):
    """Newton's method that halves steps until the residual decreases"""
    u = problem.u
    energy, r = problem.evaluate(u, tangent=True)
    while problem.progress(u, energy, r):
        if not problem.factorise(indefinite=True):
            return
        step, length = problem.solve(r), 1.0
        while length > 1e-6:
            try:
                energy, trial = problem.evaluate(u - length * step, tangent=True)
            except ValueError:  # forces are not defined there
                trial = numpy.inf
            if numpy.linalg.norm(trial) < numpy.linalg.norm(r):
                break
            length /= 2
        else:
            return
        u, r = u - length * step, trial


@netloft.solver
def krylov_root(problem):
    """scipy.optimize.root with Krylov's method"""
    last = {}

    def residual(u):
        last["energy"], r = problem.evaluate(u)
        return r

    def keep(u, r):
        problem.progress(u, last["energy"], r)

    found = scipy.optimize.root(residual, problem.u, method="krylov", callback=keep, options={"fatol": 1e-9, "maxiter": 400})
    problem.progress(found.x, *problem.evaluate(found.x))


@netloft.solver
def liar(problem):
    """A solver that moves nothing"""


@netloft.solver
def careless(problem):
    """A solver that fails"""
    raise ZeroDivisionError("no step left")



class ASolverInPython(unittest.TestCase):
    def test_stands_beside_newton(self):
        scene = netloft.load("dead-weight-panel.toml").with_({"parts.net.cells": [8, 8]})
        start = scene.solve().points + 0.001
        table = netloft.compare(scene, ["newton", damped_newton], start=start)
        self.assertEqual([row["status"] for row in table.values()], ["converged", "converged"])
        self.assertLess(table["damped_newton"]["distance"], 1e-6)
        self.assertGreater(table["damped_newton"]["factorisations"], 2)

    def test_that_needs_an_energy_is_unfit_for_drag(self):
        gear = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 150})
        table = netloft.compare(gear, ["lbfgs", "newton"])
        self.assertEqual([row["status"] for row in table.values()], ["unfit", "converged"])
        self.assertIn("conservative", table["lbfgs"]["reason"])
        with self.assertRaisesRegex(netloft.Refused, "did you mean \"newton\""):
            netloft.compare(gear, ["newtn"])

    def test_may_be_that_of_scipy(self):
        scene = netloft.load("dead-weight-panel.toml").with_({"parts.net.cells": [4, 4]})
        newton = scene.solve(solver="newton")
        start = newton.points + 0.002  # from farther off, rounding decides whether it converges
        table = netloft.compare(scene, ["newton", krylov_root], start=start)
        self.assertEqual(table["krylov_root"]["status"], "converged", table["krylov_root"]["reason"])
        self.assertLess(table["krylov_root"]["distance"], 1e-5)

    def test_never_grades_itself(self):
        with self.assertRaises(netloft.NotConverged):
            netloft.load("hanging-rope.toml").solve(solver=liar)

    def test_that_fails_is_named(self):
        with self.assertRaisesRegex(netloft.NotConverged, "no step left"):
            netloft.load("hanging-rope.toml").solve(solver=careless)

    def test_that_fails_is_the_cause(self):
        with self.assertRaises(netloft.NotConverged) as caught:
            netloft.load("hanging-rope.toml").solve(solver=careless)
        self.assertIsInstance(caught.exception.__cause__, ZeroDivisionError)
        with self.assertRaises(netloft.NotConverged) as caught:
            netloft.load("hanging-rope.toml").solve(solver=liar)
        self.assertIsNone(caught.exception.__cause__)

    def test_that_fails_is_the_cause_in_its_own_thread_only(self):
        together = threading.Barrier(2, timeout=60)

        @netloft.solver
        def out_of_range(problem):
            together.wait()
            raise IndexError("the first thread")

        @netloft.solver
        def out_of_money(problem):
            together.wait()
            raise KeyError("the second thread")

        causes = {}

        def search(solver):
            try:
                netloft.load("hanging-rope.toml").solve(solver=solver)
            except netloft.NotConverged as error:
                causes[solver.netloft_name] = type(error.__cause__)

        for _ in range(10):
            causes.clear()
            threads = [threading.Thread(target=search, args=(solver,)) for solver in (out_of_range, out_of_money)]
            [thread.start() for thread in threads]
            [thread.join() for thread in threads]
            self.assertEqual(causes, {"out_of_range": IndexError, "out_of_money": KeyError})

    def test_takes_the_place_of_an_earlier_one(self):
        for words in ("the first", "the second"):

            @netloft.solver(name="edited")
            def edited(problem, words=words):
                raise RuntimeError(words)

        with self.assertRaisesRegex(netloft.NotConverged, "the second"):
            netloft.load("hanging-rope.toml").solve(solver="edited")

    def test_that_forgot_to_factorise_is_told(self):
        @netloft.solver
        def hasty(problem):
            problem.solve(problem.u)

        with self.assertRaisesRegex(netloft.NotConverged, "call factorise"):
            netloft.load("hanging-rope.toml").solve(solver=hasty)

    def test_is_no_longer_valid_after_its_call(self):
        kept = []

        @netloft.solver
        def hoarder(problem):
            kept.append(problem)

        netloft.load("hanging-rope.toml").solve(solver=hoarder, raises=False)
        with self.assertRaisesRegex(RuntimeError, "ended"):
            kept[0].evaluate(numpy.zeros(kept[0].size))

    def test_needs_a_name_of_its_own(self):
        with self.assertRaisesRegex(netloft.Refused, "newton"):
            netloft.solver(lambda problem: None, name="newton")


@netloft.strategy
def curious(search):
    """A strategy that asks another scene, whose parts and answer need the lock of reading"""
    rope = netloft.load("hanging-rope.toml").with_({"parts.rope.length": "10.5 m"})
    assert "rope" in rope.parts and rope.solve().status == "converged"
    stage = search.solve(search.start)
    if stage["ending"] == "converged":
        search.answer(stage["u"])


class AStrategyThatOpensScenes(unittest.TestCase):
    def setUp(self):
        faulthandler.dump_traceback_later(240, exit=True)  # it must not wait for itself
        self.addCleanup(faulthandler.cancel_dump_traceback_later)

    def test_may_do_so_in_a_solve_and_its_error_of_the_mesh(self):
        plain = netloft.load("hanging-rope.toml").solve(error=True)
        result = netloft.load("hanging-rope.toml").solve(strategy=curious, error=True)
        self.assertAlmostEqual(float(result.report["sag_z"]), float(plain.report["sag_z"]), places=6)
        self.assertAlmostEqual(result.report["sag_z"].mesh_error, plain.report["sag_z"].mesh_error, places=6)

    def test_may_do_so_in_a_calibration(self):
        rope = netloft.load("hanging-rope.toml")
        sag = rope.with_({"parts.rope.length": "10.05 m"}).solve().report["sag_z"]
        with tempfile.TemporaryDirectory() as folder:
            scene = rope.by(strategy=curious).save(Path(folder) / "rope.toml")
            search = Path(folder) / "search.toml"
            search.write_text(f"""
                [scenes.rope]
                scene = "{scene}"
                [variables.length]
                key = "parts.rope.length"
                range = ["9 m", "11 m"]
                [[measured]]
                scene = "rope"
                figure = "results/sag_z"
                value = "{float(sag)!r} m"
                deviation = "1 mm"
                """)
            self.assertAlmostEqual(float(netloft.calibrate(search).values["length"]), 10.05, places=4)


@netloft.strategy
def soft_first(search):
    """Soft members first, then the scene itself"""
    soft = search.solve(search.start, name="soft", stiffness_cap=10 * search.load, tolerance=1e-3)
    stage = search.solve(soft["u"], name="as it is")
    if stage["ending"] == "converged":
        search.answer(stage["u"])


@netloft.strategy
def coarse_first(search):
    """The coarsest mesh by pseudo-time, then each finer one"""
    u = search.transfer(0, search.start, search.levels - 1)
    for level in reversed(range(search.levels)):
        stage = search.solve(u, level=level, solver="ptc" if level else "newton")
        u = search.transfer(level, stage["u"], level - 1) if level else stage["u"]
    search.answer(u)


@netloft.strategy
def answers_anything(search):
    """Claims that the start is an equilibrium"""
    search.answer(search.start)


class AStrategyInPython(unittest.TestCase):
    def test_finds_what_auto_finds(self):
        scene = netloft.load("dead-weight-panel.toml").with_({"parts.net.cells": [16, 16]})
        auto = scene.solve()
        for own in (soft_first, coarse_first):
            with self.subTest(own.netloft_name):
                found = scene.solve(strategy=own)
                self.assertLess(numpy.abs(found.points - auto.points).max(), 1e-6)
                names = [stage["name"] for stage in found.to_dict()["stages"]]
                self.assertGreater(len(names), 1)

    def test_never_grades_itself(self):
        with self.assertRaises(netloft.NotConverged):
            netloft.load("hanging-rope.toml").solve(strategy=answers_anything)


if __name__ == "__main__":
    unittest.main()
