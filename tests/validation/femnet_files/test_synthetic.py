# SPDX-License-Identifier: BSD-3-Clause
"""Small gears in FEMNET's format, imported, solved by the default strategy, and held against what FEMNET found.

Positions have to agree within 1e-6 m and tensions within 1e-6 N where the two solve the same equations. NETLOFT_PROGRAM names the program.
"""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

PROGRAM = os.environ["NETLOFT_PROGRAM"]
HERE = Path(__file__).parent
SAME = ("01_two_bars", "02_netting_panel", "03_node_force_symmetry", "06_netting2ropes", "08_free_surface", "09_hauling")
METRES, NEWTONS = 1e-6, 1e-6


class Gear:
    """A gear imported and solved in a folder of its own."""

    def __init__(self, case):
        with tempfile.TemporaryDirectory() as folder:
            self.said = self.netloft(folder, "import", "femnet", HERE / f"{case}.don", "-o", "gear.toml")
            self.netloft(folder, "run", "gear.toml", "-o", "gear.hdf")
            self.mesh = (Path(folder) / "gear.mesh").read_text()
            with h5py.File(Path(folder) / "gear.hdf") as f:
                self.read(f)
        self.expected = json.loads((HERE / f"{case}.expected.json").read_text())

    @staticmethod
    def netloft(folder, *words):
        ended = subprocess.run([PROGRAM, *map(str, words)], cwd=folder, capture_output=True, text=True, timeout=120)
        assert ended.returncode == 0, ended.stdout + ended.stderr
        return ended.stderr

    def read(self, f):
        points, cells = f["VTKHDF/NumberOfPoints"][0], f["VTKHDF/NumberOfCells"][0]
        self.points = f["VTKHDF/Points"][:points]
        offsets, nodes = f["VTKHDF/Offsets"][:cells + 1], f["VTKHDF/Connectivity"][:]
        self.cells = [nodes[offsets[c]:offsets[c + 1]] for c in range(cells)]
        self.tension = {name: f[f"VTKHDF/CellData/{name}"][:cells] for name in f["VTKHDF/CellData"]}

    def furthest(self):
        """Largest distance of a node of FEMNET's from the node here that is nearest."""
        there = np.array(self.expected["positions_m"])
        assert len(there) == len(self.points)
        return max(np.linalg.norm(self.points - x, axis=1).min() for x in there)

    def bar_tensions(self):
        return np.sort([self.tension["tension"][c] for c, nodes in enumerate(self.cells) if len(nodes) == 2])

    def twine_tensions(self):
        return np.sort([self.tension[name][c] for c, nodes in enumerate(self.cells) if len(nodes) == 3
                        for name in ("tension_u", "tension_v")])


class Synthetic(unittest.TestCase):
    def test_gears_stand_where_femnet_has_them(self):
        for case in SAME:
            with self.subTest(case):
                gear = Gear(case)
                self.assertNotIn("left out:", gear.said)
                self.assertLess(gear.furthest(), METRES)

    def test_ropes_pull_as_they_do_in_femnet(self):
        for case in ("01_two_bars", "03_node_force_symmetry", "08_free_surface", "09_hauling"):
            with self.subTest(case):
                gear = Gear(case)
                np.testing.assert_allclose(gear.bar_tensions(), np.sort(gear.expected["bar_tensions_N"]), rtol=0, atol=NEWTONS)

    def test_twines_pull_as_they_do_in_femnet(self):
        for case in ("02_netting_panel", "03_node_force_symmetry"):
            with self.subTest(case):
                gear = Gear(case)
                there = np.sort(np.ravel(gear.expected["twine_tensions_N"]))
                np.testing.assert_allclose(gear.twine_tensions(), there, rtol=0, atol=NEWTONS)

    def test_a_bar_of_five_twines_pulls_with_five_times_the_tension_of_one(self):
        gear = Gear("06_netting2ropes")
        # FEMNET prints the sum of a bar's twines, here the tension is that of one.
        there = np.sort(gear.expected["bar_tensions_N"])
        here = np.sort(np.concatenate([5 * np.array([t for c, t in self.of_part(gear, "twines")]),
                                       [t for c, t in self.of_part(gear, "bars")]]))
        self.assertEqual(len(there), len(here))
        np.testing.assert_allclose(here, there, rtol=0, atol=NEWTONS)

    @staticmethod
    def of_part(gear, kind):
        """Cells of the regions of a kind, which come in the order of the mesh: tension of each."""
        lines = gear.mesh.splitlines()
        begin = next(i for i, line in enumerate(lines) if line.startswith(f"[{kind} "))
        count = next(i for i, line in enumerate(lines[begin + 1:]) if not line.strip() or line.startswith("["))
        before = sum(1 for line in lines[:begin] if line and line[0].isdigit() and len(line.split()) == 4)
        return [(c, gear.tension["tension"][c]) for c in range(before, before + count)]


if __name__ == "__main__":
    unittest.main()
