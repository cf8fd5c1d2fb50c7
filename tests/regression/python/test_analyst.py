# SPDX-License-Identifier: BSD-3-Clause
"""Steps of an analyst in a notebook: change a scene, solve it, read figures and arrays, differentiate, sweep, save."""
import gc
import html
import os
import multiprocessing
import pickle
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock
from pathlib import Path

import numpy

import netloft

GEAR = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 300})
RESULT = GEAR.solve()


class AScene(unittest.TestCase):
    def test_shows_its_numbers_by_part(self):
        self.assertEqual(float(GEAR["headrope"].length), 25.3)
        self.assertEqual(GEAR["headrope"].length.unit, "m")
        self.assertIn("unstretched length", GEAR["headrope"].length.doc)
        self.assertIn("diameter of one twine", GEAR["top-wing"].twine.diameter.doc)
        self.assertEqual(float(GEAR["tow"].speed), 3.0)
        self.assertIn("speed over the ground", GEAR.with_({"tow.speed": "2 kn"})["tow"].speed.doc)
        self.assertAlmostEqual(float(GEAR["headrope"].rope.density), 5057, delta=1)
        self.assertEqual(float(GEAR.numbers["tow.speed"]), 3.0)
        self.assertIn("length", dir(GEAR["headrope"]))
        self.assertIn("top-wing", GEAR.parts)
        self.assertEqual(len(GEAR.parts), len(set(GEAR.parts)))
        self.assertIn("25.3 m", repr(GEAR["headrope"]))

    def test_keeps_units_in_sums_and_multiples(self):
        speed = GEAR.numbers["tow.speed"]
        self.assertEqual(repr(1.1 * speed), "3.3 kn")
        self.assertEqual((speed * 2).unit, "kn")
        self.assertEqual((speed + speed - speed / 2).unit, "kn")
        self.assertIs(type(speed * speed), float)
        self.assertEqual(float(GEAR.with_({"tow.speed": 1.1 * speed}).numbers["tow.speed"]), 1.1 * 3)

    def test_is_saved_as_a_file_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            path = GEAR.with_({"tow.speed": "3.5 kn"}).save(Path(folder) / "mine.toml")
            mine = netloft.load(path)
            self.assertEqual(float(mine.numbers["tow.speed"]), 3.5)
            self.assertEqual(mine.check(), [])
            classic = GEAR.by(solver="newton:method=classic").save(Path(folder) / "classic.toml")
            self.assertEqual(netloft.load(classic).tables["analysis"]["newton"]["method"], "classic")
            with self.assertRaises(FileExistsError):
                GEAR.save(path)
            with self.assertRaisesRegex(ValueError, "item of an array"):
                GEAR.with_({"points.towing-point.at[1]": 29.0}).save(Path(folder) / "other.toml")

    def test_never_changes_itself(self):
        with self.assertRaises(AttributeError):
            GEAR.speed = 3
        other = GEAR.with_({"tow.speed": "3.5 kn"})
        self.assertEqual(GEAR.changes, ("gear.nodes=300",))
        self.assertEqual(float(other.numbers["tow.speed"]), 3.5)
        self.assertEqual(len(other.with_({"tow.speed": 1.5}).changes), 2)  # takes the place of the first

    def test_takes_quantities_arrays_and_tables(self):
        longer = GEAR.with_({"ropes.headrope.length": GEAR["headrope"].length,
                             "points.towing-point.at": numpy.array([-51.1, 28.73, -19.6])})
        numpy.testing.assert_array_equal(longer.solve().points, RESULT.points)

    def test_survives_pickling(self):
        again = pickle.loads(pickle.dumps(GEAR))
        self.assertEqual(again, GEAR)
        numpy.testing.assert_array_equal(again.solve().points, RESULT.points)


def solved_in_another_process(changes):
    return GEAR.with_(changes).solve()


class AResult(unittest.TestCase):
    def test_comes_back_from_other_processes_as_its_file(self):
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            results = pool.map(solved_in_another_process, [{}, {"tow.speed": "1.6 m/s"}])
        self.assertEqual([type(r) for r in results], [netloft.Stored] * 2)
        self.assertEqual({k: float(v) for k, v in results[0].report.items()}, {k: float(v) for k, v in RESULT.report.items()})
        self.assertNotEqual(results[1].report["mouth/headline_height"], RESULT.report["mouth/headline_height"])
        numpy.testing.assert_array_equal(results[0].points(), RESULT.points)
        again = pickle.loads(pickle.dumps(results[0]))  # whose file is gone
        self.assertEqual(again.page(), results[0].page())
        other = GEAR.with_({"tow.speed": "1.6 m/s"}).solve(start=again)
        self.assertAlmostEqual(float(other.report["mouth/headline_height"]), float(results[1].report["mouth/headline_height"]), places=3)

    def test_that_is_none_keeps_its_shape_in_other_processes(self):
        with self.assertRaises(netloft.NotConverged) as caught:
            netloft.load("dead-weight-panel.toml").with_({"analysis.max_iterations": 1}).solve(solver="newton")
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertIsInstance(again, netloft.NotConverged)
        self.assertEqual(str(again), str(caught.exception))
        numpy.testing.assert_array_equal(again.result.points(), caught.exception.result.points)

    def test_has_figures_with_units_and_errors(self):
        height = RESULT.report["mouth/headline_height"]
        self.assertEqual(height.unit, "m")
        self.assertTrue(height.doc)
        self.assertLess(height.error, 1e-4)
        self.assertIn("±", repr(height))
        with_mesh = GEAR.solve(error=True).report["mouth/headline_height"]
        self.assertEqual(float(with_mesh), float(height))
        self.assertGreater(with_mesh.mesh_error, 1e-3)

    def test_has_arrays_that_outlive_it_and_cannot_be_written(self):
        result = GEAR.solve()
        points, tension = result.points, result["headrope"].tension
        copies = points.copy(), tension.copy()
        del result
        gc.collect()
        for i in range(3):
            GEAR.solve()
        numpy.testing.assert_array_equal(points, copies[0])
        numpy.testing.assert_array_equal(tension, copies[1])
        with self.assertRaises(ValueError):
            points[0, 0] = 1

    def test_has_tensions_that_hold_the_headrope(self):
        rope = RESULT["headrope"]
        self.assertEqual(rope.units["tension"], "N")
        ends = RESULT.points[rope.nodes]
        stretched = numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()
        self.assertAlmostEqual(stretched, float(GEAR["headrope"].length) / 2, delta=0.05)  # half of it is modelled

    def test_has_a_mesh_a_page_and_a_file(self):
        points, cells, data = RESULT.mesh()
        self.assertEqual([kind for kind, _ in cells], ["triangle", "line"])
        for values in data.values():
            self.assertEqual([len(v) for v in values], [len(nodes) for _, nodes in cells])
        self.assertLess(max(nodes.max() for _, nodes in cells), len(points))
        wing = data["part"][0] == RESULT.parts.index("top-wing")
        numpy.testing.assert_array_equal(data["tension"][0][wing], RESULT["top-wing"].tension)
        self.assertIn("<svg", RESULT.draw())
        self.assertIn("<!DOCTYPE html>", RESULT.page()[:200])
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "trawl.hdf"
            RESULT.save(path)
            stored = netloft.read(path)
            self.assertEqual(dict(stored.report), dict(RESULT.report))
            numpy.testing.assert_array_equal(stored.points(), RESULT.points)

    def test_becomes_a_dataset(self):
        data = RESULT.to_xarray()
        self.assertEqual(data["mouth/headline_height"].attrs["units"], "m")
        self.assertEqual(data["points"].shape, RESULT.points.shape)


    def test_shows_itself_in_a_notebook(self):
        """The page is in the frame itself: browsers refuse an address that is as long."""
        display = types.ModuleType("IPython.display")
        display.IFrame = lambda *words, **more: (words, more)
        with unittest.mock.patch.dict(sys.modules, {"IPython": types.ModuleType("IPython"), "IPython.display": display}):
            (address, width, height), more = RESULT.view(height=500)
        self.assertEqual((address, width, height), ("about:blank", "100%", 500))
        page = html.unescape(more["extras"][0].removeprefix('srcdoc="').removesuffix('"'))
        self.assertIn("<!DOCTYPE html>", page[:200])
        self.assertNotRegex(page, r'(src|href)="https?:')  # works offline
        with unittest.mock.patch.dict(sys.modules, {"IPython.display": None}), self.assertRaisesRegex(ImportError, "page"):
            RESULT.view()


class Derivatives(unittest.TestCase):
    def test_agree_with_equilibria_beside(self):
        step = 1e-4
        for path, unit in (("tow.speed", " kn"), ("points.towing-point.at[1]", " m")):
            value = float(GEAR.numbers[path])
            sides = [GEAR.with_({path: f"{value * (1 + s)}{unit}"}).solve(start=RESULT) for s in (step, -step)]
            for figure in ("mouth/headline_height", "drag/all/x"):
                slope = (sides[0].report[figure] - sides[1].report[figure]) / (2 * step * value)
                found = RESULT.gradient(figure, [path])[path]
                self.assertAlmostEqual(found / slope, 1, delta=2e-3, msg=f"{figure} by {path}")

    def test_of_both_modes_are_the_same(self):
        numbers = ["tow.speed", "ropes.headrope.length"]
        self.assertEqual(list(RESULT.gradient("drag/all/x", numbers)), numbers)
        self.assertEqual(list(RESULT.gradient("drag/all/x", numbers[::-1])), numbers[::-1])
        knots, metres = RESULT.jvp({"tow.speed": "0.1 kn"})["drag/all/x"], RESULT.jvp({"tow.speed": "0.1 m/s"})["drag/all/x"]
        self.assertAlmostEqual(RESULT.jvp({"tow.speed": 0.1})["drag/all/x"], knots, places=6)
        self.assertAlmostEqual(metres / knots, 3600 / 1852, places=6)
        everything = RESULT.gradient("drag/all/x")
        self.assertIn("elements.top-wing.twine.diameter", everything)  # of the catalogue
        self.assertNotIn("panels.top-codend.twines", everything)  # an integer
        jvp = RESULT.jvp({"tow.speed": 0.1, "ropes.headrope.length": 0.2})
        vjp = RESULT.vjp({"drag/all/x": 1.0}, numbers)
        self.assertAlmostEqual(jvp["drag/all/x"], 0.1 * vjp["tow.speed"] + 0.2 * vjp["ropes.headrope.length"], places=6)

    def test_of_the_residual_are_the_tangent(self):
        rng = numpy.random.default_rng(1)
        chain = netloft.load("hanging-rope.toml").solve()
        K, direction = chain.tangent(), rng.normal(size=len(chain.u))
        h = 1e-6
        numeric = (chain.residual(chain.u + h * direction) - chain.residual(chain.u - h * direction)) / (2 * h)
        self.assertLess(numpy.abs(numeric - K @ direction).max(), 1e-6 * numpy.abs(K @ direction).max())

    def test_by_the_adjoint_satisfy_the_dot_product_identity(self):
        rng = numpy.random.default_rng(2)
        v, w = rng.normal(size=(2, len(RESULT.u)))
        K, adjoint = RESULT.tangent(), RESULT.solve_adjoint(w)
        self.assertLess(abs(adjoint @ (K @ v) - w @ v), 1e-11 * numpy.linalg.norm(w) * numpy.linalg.norm(v))


class AStudyWithErrors(unittest.TestCase):
    def test_has_them_beside_its_figures(self):
        data = netloft.study(GEAR, {"tow.speed": ["2.5 kn", "3.5 kn"]}, error=True).to_xarray()
        self.assertTrue((data["drag/all/x/error"].values > 0).all())
        self.assertEqual(data["drag/all/x/error"].attrs["units"], "N")


class AMotion(unittest.TestCase):
    def test_falls_freely_at_first(self):
        rope = netloft.load("dynamics/released-rope.toml")
        seen = []
        motion = netloft.simulate(rope, times=numpy.linspace(0, 0.1, 11), progress=lambda t, end: seen.append((t, end)))
        numpy.testing.assert_allclose(motion.times, numpy.linspace(0, 0.1, 11), atol=1e-12)
        self.assertAlmostEqual(seen[-1][0], 0.1)
        data = motion.to_xarray()
        self.assertEqual(data["points"].dims, ("time", "node", "axis"))
        self.assertEqual(data["time"].attrs["units"], "s")
        self.assertTrue((data["points"].sel(axis="z").min("node").diff("time") <= 1e-12).all())
        _, cells, fields = motion.mesh(0)
        self.assertEqual(len(fields["tension"][0]), len(cells[0][1]))

    def test_wants_times_in_equal_steps(self):
        with self.assertRaisesRegex(ValueError, "equal steps"):
            netloft.load("dynamics/released-rope.toml").simulate(times=[0, 1, 3])


class AStudy(unittest.TestCase):
    def test_becomes_a_dataset_with_units(self):
        study = netloft.study(GEAR, {"tow.speed": ["2.5 kn", "3.5 kn"], "gear.nodes": [150, 200]})
        data = study.to_xarray()
        self.assertEqual(data["tow.speed"].attrs["units"], "kn")
        self.assertNotIn("drag/all/x/error", data)
        self.assertEqual(data["drag/all/x"].shape, (2, 2))
        self.assertTrue((data["drag/all/x"].sel({"tow.speed": 3.5}).values > data["drag/all/x"].sel({"tow.speed": 2.5}).values).all())

    def test_is_plotted_with_the_band_of_its_error(self):
        import matplotlib

        matplotlib.use("agg")
        study = netloft.study(GEAR, {"tow.speed": ["2.5 kn", "3 kn", "3.5 kn"]}, error=True)
        axes = study.plot("mouth/headline_height")
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("tow.speed [kn]", "mouth/headline_height [m]"))
        heights = [row[3]["mouth/headline_height"] for row in study.rows]
        numpy.testing.assert_array_equal(axes.lines[0].get_xydata(), list(zip([2.5, 3.0, 3.5], heights)))
        band = axes.collections[0].get_paths()[0].vertices
        for speed, height in zip([2.5, 3.0, 3.5], heights):
            edge = band[band[:, 0] == speed, 1]
            self.assertAlmostEqual(edge.max() - edge.min(), 2 * height.error)
        with self.assertRaisesRegex(KeyError, "did you mean 'mouth/headline_height'"):
            study.plot("mouth/headline")
        with self.assertRaisesRegex(ValueError, "one variable"):
            netloft.study(GEAR, {"tow.speed": [1.5], "gear.nodes": [150]}).plot("mouth/area")

    def test_keeps_points_without_an_answer_apart(self):
        with self.assertRaisesRegex(netloft.WrongInput, "did you mean"):
            netloft.study(GEAR, {"tow.sped": [1, 2]})
        study = netloft.study(GEAR.with_({"analysis.strategy": "direct"}), {"analysis.max_iterations": [1, 200]})
        self.assertEqual([row[1] for row in study.rows], ["not converged", "converged"])
        self.assertTrue(numpy.isnan(study.to_xarray()["drag/all/x"].values[0]))


class Manners(unittest.TestCase):
    def test_nothing_is_printed(self):
        code = "import netloft; g = netloft.load('83-112-flume-3.0kn.toml').with_({'gear.nodes': 20000}); g.check(); g.solve()"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_ctrl_c_ends_a_solve_with_the_shape_so_far(self):
        big = GEAR.with_({"gear.nodes": 20000})
        began = []
        timer = threading.Timer(3, lambda: (began.append(time.monotonic()), os.kill(os.getpid(), signal.SIGINT)))
        timer.start()
        with self.assertRaises(netloft.Interrupted) as caught:
            big.solve()
        self.assertTrue(began)
        self.assertIsInstance(caught.exception, KeyboardInterrupt)
        self.assertEqual(caught.exception.result.status, "interrupted")
        self.assertGreater(len(caught.exception.result.points), 10000)

    def test_ctrl_c_does_not_wait_for_a_long_step(self):
        @netloft.solver
        def sleeper(problem):
            """A step as long as one of a very large mesh"""
            time.sleep(4)

        sent = []
        threading.Timer(0.5, lambda: (sent.append(time.monotonic()), os.kill(os.getpid(), signal.SIGINT))).start()
        with self.assertRaises(netloft.Interrupted) as caught:
            netloft.load("hanging-rope.toml").solve(solver=sleeper)
        self.assertLess(time.monotonic() - sent[0], 2)
        self.assertEqual(netloft.load("hanging-rope.toml").solve().status, "converged")  # meanwhile
        self.assertEqual(caught.exception.result.status, "interrupted")
        self.assertGreater(time.monotonic() - sent[0], 2)

    def test_the_interpreter_may_end_during_a_step_that_was_left(self):
        code = """if True:
            import netloft, os, signal, threading, time
            @netloft.solver
            def sleeper(problem):
                time.sleep(2)
            threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
            try:
                netloft.load("hanging-rope.toml").solve(solver=sleeper, progress=lambda *numbers: None)
            except netloft.Interrupted as interrupted:
                print("interrupted")
            """
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "interrupted\n", ""))

    def test_progress_may_end_a_solve(self):
        calls = []

        def stop(iteration, residual, load):
            calls.append((iteration, residual, load))
            if len(calls) == 3:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            GEAR.solve(progress=stop)
        self.assertTrue(all(load > 0 for _, _, load in calls))

    def test_other_threads_run_during_a_solve(self):
        ticks = []
        done = threading.Event()
        ticker = threading.Thread(target=lambda: [ticks.append(time.sleep(0.01)) for _ in iter(done.is_set, True)])
        ticker.start()
        GEAR.with_({"gear.nodes": 3000}).solve()
        done.set()
        ticker.join()
        self.assertGreater(len(ticks), 5)

    def test_threads_may_solve_at_once(self):
        results = [None] * 4

        def solve(i):
            results[i] = GEAR.with_({"tow.speed": f"{3 + 0.1 * (i % 2)} kn"}).solve()

        threads = [threading.Thread(target=solve, args=(i,)) for i in range(4)]
        [t.start() for t in threads]
        [t.join() for t in threads]
        numpy.testing.assert_array_equal(results[0].points, RESULT.points)
        numpy.testing.assert_array_equal(results[1].points, results[3].points)

    def test_memory_stays(self):
        rope = netloft.load("hanging-rope.toml")

        def use(times):
            for i in range(times):
                result = rope.with_({"analysis.max_iterations": 100 + i % 2}).solve()
                result.points, result.report, result.to_dict()
            gc.collect()
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

        before = use(100)
        self.assertLess(use(300), 1.02 * before)


if __name__ == "__main__":
    unittest.main()
