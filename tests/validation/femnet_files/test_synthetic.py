# SPDX-License-Identifier: BSD-3-Clause
"""Small gears in FEMNET's format, imported, solved by the default strategy, and held against what FEMNET found.

Positions have to agree within 1e-6 m and tensions within 1e-6 N where the two solve the same equations. Where they do not, the
difference of formulation stands in DIFFERENT with its size, which must not grow.
"""
import json
import unittest
from pathlib import Path

import numpy as np

from imported import Gear

HERE = Path(__file__).parent
SAME = ("01_two_bars", "02_netting_panel", "03_node_force_symmetry", "04_moving_bed", "06_netting2ropes", "08_free_surface",
        "09_hauling")
METRES, NEWTONS = 1e-6, 1e-6
# Bending with unstretched lengths; drag of netting beside a catch: io/import/README.md. [m]
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

    def test_a_bar_of_five_twines_pulls_with_five_times_the_tension_of_one(self):
        """FEMNET prints the sum of a bar's twines, here the tension is that of one."""
        gear, there = solved("06_netting2ropes")
        rows = [line for line in gear.mesh.splitlines() if line[:1].isdigit() and len(line.split()) == 4]
        twines = [float(line.split()[3]) > 1 for line in rows]
        here = np.sort([gear.data["tension"][c] * (5 if twines[c] else 1) for c in range(len(rows))])
        np.testing.assert_allclose(here, np.sort(there["bar_tensions_N"]), rtol=0, atol=NEWTONS)

    def test_the_front_of_a_catch_is_where_femnet_has_it(self):
        """Of the shape that FEMNET found, all nodes held: the front is what is left to find."""
        there = json.loads((HERE / "05_catch_front.expected.json").read_text())
        held = '\n[[hold]]\non = "panel-1"\n[results]\nfront = { of = "catch", take = "max front" }\n'
        gear, _ = solved("05_catch_front", at=there["positions_m"], more=held)
        self.assertAlmostEqual(gear.scalars["front"], there["front_xi_m"], delta=1e-8)


if __name__ == "__main__":
    unittest.main()
