# SPDX-License-Identifier: BSD-3-Clause
"""An element whose energy is written in Python passes the checks, and gives the same equilibrium as a plugin."""
import math
import tempfile
import threading
import unittest
from pathlib import Path

import numpy

import netloft

EA, DENSITY, DIAMETER = 1e4, 2000.0, 0.02
WEIGHT = (DENSITY - 1000) * 9.81 * math.pi / 4 * DIAMETER**2  # in water [N/m]

SCENE = """
[water]
density = 1000
gravity = 9.81

[parts.rope]
type = "{type}"
length = "10 m"
cells = 20
sketch = [[-4, 0, 0], [0, 0, -2.5], [4, 0, 0]]
{table}

[[hold]]
on = "rope.start"

[[hold]]
on = "rope.end"
"""


@netloft.element(nodes=2, data=["rest_length"], from_outside=True,
                 parameters={"cord.EA": netloft.Parameter("N", "axial stiffness", low=1, high=1e9),
                             "cord.weight": netloft.Parameter("N/m", "weight in water", default=0.0, low=-1e6, high=1e6)})
def cord(x, of):
    """An elastic bar with weight"""
    chord = x[:, 1] - x[:, 0]
    length = numpy.sqrt((chord * chord).sum(axis=1))
    elastic = of.EA * (length - of.rest_length) ** 2 / (2 * of.rest_length)
    return elastic + of.weight * of.rest_length * x[:, :, 2].mean(axis=1)


class AnEnergy(unittest.TestCase):
    def solve(self, **words):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.toml"
            path.write_text(SCENE.format(**words))
            return netloft.Scene(path).solve()

    def test_conforms(self):
        self.assertEqual([row for row in netloft.check(cord) if row[1] == "failed"], [])

    def test_that_is_wrong_does_not_conform(self):
        @netloft.element(nodes=2, parameters={"bad.EA": netloft.Parameter("N", "stiffness", low=1, high=1e6)})
        def pulls_to_the_origin(x, of):
            """A bar that claims to need nothing outside"""
            return of.EA * (x * x).sum(axis=(1, 2))

        failed = [name for name, outcome, *_ in netloft.check(pulls_to_the_origin) if outcome == "failed"]
        self.assertIn("translation-changes-nothing", failed)

    def test_hangs_as_the_plugin_hangs(self):
        ours = self.solve(type="cord/energy", table=f"cord = {{ EA = {EA}, weight = {WEIGHT!r} }}")
        plugin = self.solve(type="rope/bar", table=f"rope = {{ EA = {EA}, EA_compression = {EA}, density = {DENSITY}, diameter = {DIAMETER} }}")
        self.assertEqual(ours.stability, "stable")
        self.assertLess(numpy.abs(ours.points - plugin.points).max(), 1e-8)

    def test_serves_several_threads(self):
        words = {"type": "cord/energy", "table": f"cord = {{ EA = {EA}, weight = {WEIGHT!r} }}"}
        alone, results = self.solve(**words), []
        threads = [threading.Thread(target=lambda: results.append(self.solve(**words))) for _ in range(3)]
        [thread.start() for thread in threads]
        for _ in range(20):  # reads scenes, which the others do at the same time
            netloft.load("hanging-rope.toml").tables
        [thread.join(60) for thread in threads]
        self.assertEqual(len(results), 3)
        for result in results:
            numpy.testing.assert_array_equal(result.points, alone.points)

    def test_that_is_never_defined_is_named(self):
        @netloft.element(nodes=2, parameters={"void.EA": netloft.Parameter("N", "stiffness", default=1.0)})
        def nothing_is_defined(x, of):
            """A bar that is nowhere defined"""
            return of.EA * x[:, 0, 0] * float("nan")

        with self.assertRaises(netloft.NotConverged):
            self.solve(type="nothing-is-defined/energy", table="")

    def test_takes_the_place_of_an_earlier_one(self):
        def define(factor):
            @netloft.element(nodes=2, data=["rest_length"], from_outside=True, name="edited",
                             parameters={"edited.weight": netloft.Parameter("N/m", f"{factor} times the weight", default=WEIGHT)})
            def energy(x, of):
                """A bar of fixed stiffness"""
                return cord_energy(x, of.rest_length, factor * of.weight)

        def cord_energy(x, rest_length, weight):
            chord = x[:, 1] - x[:, 0]
            length = numpy.sqrt((chord * chord).sum(axis=1))
            return EA * (length - rest_length) ** 2 / (2 * rest_length) + weight * rest_length * x[:, :, 2].mean(axis=1)

        results = []
        for factor in (1, 3):
            define(factor)
            results.append(self.solve(type="edited/energy", table=""))
        first, second = (float(r["rope"].energy.sum()) if "energy" in dir(r["rope"]) else r.points[:, 2].min() for r in results)
        self.assertNotAlmostEqual(first, second, places=3)
        for r in results:  # each goes on with the energy that it was found with
            self.assertLess(numpy.abs(r.residual(r.u)).max(), 1e-3)

    def test_with_other_parameters_needs_another_name(self):
        with self.assertRaisesRegex(netloft.Refused, "other nodes, parameters or data in this process already; give the new one another name"):
            netloft.element(nodes=2, data=["rest_length"], name="cord", parameters={"cord.EA": netloft.Parameter("N", "stiffness")})(lambda x, of: 0)
        with self.assertRaisesRegex(netloft.Refused, "a component of another kind"):
            netloft.solver(lambda problem: None, name="cord")

    def test_with_unknown_data_is_refused(self):
        with self.assertRaisesRegex(netloft.Refused, "have no data \"length_at_rest\""):
            netloft.element(nodes=2, parameters={}, data=["length_at_rest"])(lambda x, of: 0)

    def test_tells_its_parameters_to_scenes(self):
        with self.assertRaisesRegex(netloft.WrongInput, "EA"):
            self.solve(type="cord/energy", table="cord = { EA = -1.0 }")


if __name__ == "__main__":
    unittest.main()
