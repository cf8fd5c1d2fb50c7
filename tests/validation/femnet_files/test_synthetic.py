# SPDX-License-Identifier: BSD-3-Clause
"""Small gears in FEMNET's format, imported, solved by the default strategy, and compared with FEMNET's results.

Positions have to agree within 1e-6 m and tensions within 1e-6 N where the two solve the same equations. Where formulations differ, DIFFERENT has the size of the difference, which must not grow.
"""
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

from imported import Gear

HERE = Path(__file__).parent
SAME = ("01_two_bars", "02_netting_panel", "03_node_force_symmetry", "04_moving_bed", "06_netting2ropes", "08_free_surface",
        "09_hauling")
METRES, NEWTONS = 1e-6, 1e-6
# Bending with unstretched lengths; drag of netting beside a catch: io/scenes/import/FORMATS.md. [m]
DIFFERENT = {"07_bending_rest_angle": 2e-5, "05_catch_front": 0.048}


def solved(case, **how):
    return Gear(HERE / f"{case}.don", **how), json.loads((HERE / f"{case}.expected.json").read_text())


class Synthetic(unittest.TestCase):
    def test_gears_stand_where_femnet_has_them(self):
        for case in SAME:
            with self.subTest(case):
                gear, there = solved(case)
                self.assertNotIn("left out:", gear.said)
                self.assertLess(gear.furthest(there["positions_m"]), METRES)

    def test_differences_of_formulation_are_as_large_as_is_said(self):
        for case, size in DIFFERENT.items():
            with self.subTest(case):
                gear, there = solved(case)
                self.assertNotIn("left out:", gear.said)
                self.assertLess(gear.furthest(there["positions_m"]), size)
                self.assertGreater(gear.furthest(there["positions_m"]), 0.5 * size)

    def test_ropes_pull_as_they_do_in_femnet(self):
        for case in ("01_two_bars", "03_node_force_symmetry", "04_moving_bed", "08_free_surface", "09_hauling"):
            with self.subTest(case):
                gear, there = solved(case)
                np.testing.assert_allclose(gear.bar_tensions(), np.sort(there["bar_tensions_N"]), rtol=0, atol=NEWTONS)

    def test_twines_pull_as_they_do_in_femnet(self):
        for case in ("02_netting_panel", "03_node_force_symmetry"):
            with self.subTest(case):
                gear, there = solved(case)
                twines = np.sort(np.ravel(there["twine_tensions_N"]))
                np.testing.assert_allclose(gear.twine_tensions(), twines, rtol=0, atol=NEWTONS)

    def test_a_gear_without_a_mesh_is_divided_and_stands_as_in_femnet(self):
        """Nodes and triangles are FEMNET's, except that squares may have the other diagonal: the answer differs by less than a third of the change of FEMNET's own answer from one meshing step to the next."""
        gear = (HERE / "10_polygon_panel.don").read_text()
        meshes = json.loads((HERE / "10_polygon_panel.expected.json").read_text())["meshes"]
        corners = [np.array(mesh["corner_positions_m"]) for mesh in meshes]
        for i, mesh in enumerate(meshes):
            with self.subTest(step=mesh["meshing_step_m"]), tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "gear.don"
                path.write_text(gear.replace("Meshing step (m): 1\n", f"Meshing step (m): {mesh['meshing_step_m']}\n"))
                here = Gear(path)
                self.assertNotIn("left out:", here.said)
                self.assertEqual(len(here.points), mesh["nodes"])
                step = min(i, len(meshes) - 2)
                change = np.linalg.norm(corners[step + 1] - corners[step], axis=1).max()
                print(f"step {mesh['meshing_step_m']} m: {here.furthest(corners[i]):.2g} m from FEMNET, whose next step changes {change:.2g} m")
                self.assertLess(here.furthest(corners[i]), change / 3)

    def test_a_bar_of_five_twines_pulls_with_five_times_the_tension_of_one(self):
        """FEMNET prints the tension of all twines of a bar; here the tension is that of one twine."""
        gear, there = solved("06_netting2ropes")
        rows = [line for line in gear.mesh.splitlines() if line[:1].isdigit() and len(line.split()) == 4]
        twines = [float(line.split()[3]) > 1 for line in rows]
        here = np.sort([gear.data["tension"][c] * (5 if twines[c] else 1) for c in range(len(rows))])
        np.testing.assert_allclose(here, np.sort(there["bar_tensions_N"]), rtol=0, atol=NEWTONS)

    def test_the_front_of_a_catch_is_where_femnet_has_it(self):
        """With all nodes held at FEMNET's shape, only the front is unknown."""
        there = json.loads((HERE / "05_catch_front.expected.json").read_text())
        held = '\n[[hold]]\non = "panel-1"\n[results]\nfront = { of = "catch", take = "max front" }\n'
        gear, _ = solved("05_catch_front", at=there["positions_m"], more=held)
        self.assertAlmostEqual(gear.scalars["front"], there["front_xi_m"], delta=1e-8)


if __name__ == "__main__":
    unittest.main()
