# SPDX-License-Identifier: BSD-3-Clause
"""Five gears of FEMNET's data folder. They are no part of the repository: NETLOFT_FEMNET names the folder of the .don and .mdg, and
NETLOFT_REAL_GEARS that of FEMNET's answers in the format femnet-neutral/1 (else the folder real-gears beside the first).

Where FEMNET has a gear in balance, every node has to be so here, as far as FEMNET's own answer is: what is left there, of up to 8e-6 N, is
known from an independent evaluation of its formulas. And the default strategy has to find an equilibrium of every gear.
"""
import json
import os
import sys
import unittest
from pathlib import Path

import numpy as np

from imported import Gear, mesh_of, twine_sides

SKIPPED = 77
FOLDER = os.environ.get("NETLOFT_FEMNET")
NEWTONS = 1e-6
GEARS = ("01_ring_flexion", "02_netting_panel", "05_pelagic_t1", "07_bottom_b1", "09_pelagic_s3")
NO_STEP = '\n[analysis]\nstrategy = "direct"\nmax_iterations = 0\n'


def answer(gear):
    folder = Path(os.environ.get("NETLOFT_REAL_GEARS", Path(FOLDER).parent / "real-gears"))
    return json.loads((folder / f"{gear}.json").read_text())


class Originals(unittest.TestCase):
    def test_gears_are_in_balance_where_femnet_has_them(self):
        for name in GEARS:
            with self.subTest(name):
                there = answer(name)["reference"]
                gear = Gear(Path(FOLDER) / f"{name}.don", at=there["positions"], more=NO_STEP, codes=(0, 3))
                self.assertNotIn("left out:", gear.said)
                self.assertLess(gear.furthest(there["positions"]), 1e-12)
                self.assertLess(np.abs(gear.residual).max(), there["independent_max_component_N"] + NEWTONS)
                np.testing.assert_allclose(gear.bar_tensions(), np.sort(there["bar_tensions_N"]), rtol=0, atol=NEWTONS)
                if there["twine_tensions_N"]:
                    twines = np.sort(np.ravel(there["twine_tensions_N"]))
                    np.testing.assert_allclose(gear.twine_tensions(), twines, rtol=0, atol=NEWTONS)

    def test_gears_divided_here_have_the_netting_and_the_ropes_of_their_meshes(self):
        for name in GEARS:
            path = Path(FOLDER) / f"{name}.don"
            (nodes, there), (own_nodes, here) = mesh_of(path), mesh_of(path, "--divide")
            print(f"{name}: {nodes} nodes, divided here {own_nodes}")
            for region in there:
                with self.subTest(f"{name} {region}"):
                    self.assertIn(region, here)
                    if region.startswith("triangles"):
                        self.assertAlmostEqual(twine_sides(here[region]) / twine_sides(there[region]), 1, delta=1e-5)
                    if region.startswith("bars"):
                        self.assertEqual((here[region][0][2], here[region][-1][3]), (0, 1))

    def test_the_default_strategy_finds_an_equilibrium(self):
        for name in GEARS:
            with self.subTest(name):
                there = answer(name)
                gear = Gear(Path(FOLDER) / f"{name}.don")
                held = np.sum([r["force_N"] for r in there["reference"]["reactions"]], axis=0)
                whole = [n for n in there["nodes"] if any(n["symmetry"])] == []
                if whole:  # FEMNET doubles what acts on a plane of symmetry
                    np.testing.assert_allclose(gear.reaction.sum(axis=0), held, rtol=0, atol=2e-3 * np.abs(held).max())


if __name__ == "__main__":
    if not FOLDER:
        print("NETLOFT_FEMNET does not name the folder of the gears")
        sys.exit(SKIPPED)
    unittest.main()
