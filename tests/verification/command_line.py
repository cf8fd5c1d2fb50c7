#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs `netloft run` on scenes of the gear library, and compares results with those of an independent program.

    command_line.py NETLOFT SOURCE_FOLDER

The panel is compared node by node in the result file, other numbers in the JSON on standard output.
"""
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
SCENES = SOURCE / "gear-library" / "scenes"
NODE_TOLERANCE = 1e-8  # m
RELATIVE_TOLERANCE = 1e-9
MESHES = 40  # across and along the panel
DONE, NOT_CONVERGED = 0, 3  # exit codes


def read_level(cells):
    """Energy, elastic energy, lowest z, top reaction; rows of column, row, x, z."""
    values, nodes = [], []
    for line in (SOURCE / "tests" / "verification" / "data" / "hanging-panel.txt").read_text().splitlines():
        word, *numbers = line.split()
        if word == "level":
            here = int(numbers[0]) == cells
            if here:
                values = [float(x) for x in numbers[1:]]
        elif word == "node" and here:
            nodes.append([float(x) for x in numbers])
    return values, np.array(nodes)


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "result.hdf"

    def run_scene(self, scene, *options, exit_code=DONE):
        run = subprocess.run([NETLOFT, "run", SCENES / scene, "-o", self.file, "--json", *options],
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, exit_code, run.stdout + run.stderr)
        return json.loads(run.stdout)

    def positions(self):
        """Panel coordinates in meshes and positions of all nodes."""
        with h5py.File(self.file) as f:
            n = f["VTKHDF/NumberOfPoints"][0]
            return f["VTKHDF/PointData/panel_uv"][:n], f["VTKHDF/Points"][:n]

    def status(self):
        with h5py.File(self.file) as f:
            return dict(f["netloft/status"].attrs)

    def check_panel(self, cells, *options):
        answer = self.run_scene("dead-weight-panel.toml", "--set", f"parts.net.cells=[{cells},{cells}]", *options)
        self.assertEqual((answer["status"], answer["stability"]), ("converged", "stable"))
        self.assertEqual(self.status()["outcome"], "converged")
        (energy, _, lowest_z, top), nodes = read_level(cells)
        self.assertLess(abs(answer["results"]["lowest_z"] - lowest_z), NODE_TOLERANCE)
        self.assertLess(abs(answer["energy"] / energy - 1), RELATIVE_TOLERANCE)
        self.assertLess(abs(answer["results"]["top_reaction_z"] / top - 1), RELATIVE_TOLERANCE)
        uv, x = self.positions()
        for i, j, x_wanted, z_wanted in nodes:
            at = np.argmin(np.linalg.norm(uv - np.array([i, j]) * MESHES / cells, axis=1))
            np.testing.assert_allclose(uv[at], np.array([i, j]) * MESHES / cells, atol=1e-12)
            np.testing.assert_allclose(x[at], [x_wanted, 0, z_wanted], rtol=0, atol=NODE_TOLERANCE)

    def test_panel_hangs_as_the_independent_program_says(self):
        self.check_panel(32)

    def test_panel_hangs_the_same_from_a_sketch_that_is_too_long(self):
        self.check_panel(16, "--set", "parts.net.sketch=[[-16,0,0],[16,0,0],[16,0,-54],[-16,0,-54]]")

    def test_panel_is_the_net_twine_by_twine_when_one_word_is_switched(self):
        # result of the independent program that models every twine as a bar
        answer = self.run_scene("dead-weight-panel.toml", "--set", "parts.net.type=lumped/net", "--set",
                                f"parts.net.cells=[{MESHES},{MESHES}]")
        self.assertEqual((answer["status"], answer["stability"]), ("converged", "stable"))
        self.assertLess(abs(answer["results"]["lowest_z"] + 42.67468699107), NODE_TOLERANCE)
        self.assertLess(abs(answer["energy"] / -58151.570400698 - 1), RELATIVE_TOLERANCE)
        self.assertLess(abs(answer["results"]["top_reaction_z"] / 2884.660640009 - 1), RELATIVE_TOLERANCE)

    def test_classic_newton_fails_on_the_panel_and_says_so(self):
        answer = self.run_scene("dead-weight-panel.toml", "--solver", "newton:method=classic", "--set",
                                "analysis.max_iterations=100", exit_code=NOT_CONVERGED)
        self.assertEqual(answer["status"], "not converged")
        self.assertIn("net node", answer["at_fault"])
        self.assertIn("limit of 100 iterations", answer["reason"])
        marked = self.status()
        self.assertEqual(marked["outcome"], "not converged")
        self.assertEqual(marked["sentence"], answer["reason"])

    def test_classic_newton_meets_a_singular_tangent_on_the_unstretched_panel(self):
        height = 48 * math.sqrt(1 - (32 / 48)**2)
        answer = self.run_scene("dead-weight-panel.toml", "--solver", "newton:method=classic", "--set",
                                f"parts.net.sketch=[[-16,0,0],[16,0,0],[16,0,-{height}],[-16,0,-{height}]]",
                                exit_code=NOT_CONVERGED)
        self.assertIn("singular", answer["reason"])
        self.assertEqual(self.status()["outcome"], "not converged")

    def test_heated_wire_hangs_deeper_than_the_cold_one(self):
        # code_aster, validation V6.02.114; the error of 200 straight bars is below 2e-5
        for scene, z, tension in (("catenary-cold.toml", -6.352161, 13206.24),
                                  ("catenary-heated.toml", -8.195452, 10241.73)):
            results = self.run_scene(f"verification/{scene}")["results"]
            self.assertLess(abs(results["midpoint_z"] / z - 1), 2e-5)
            self.assertLess(abs(results["horizontal_tension"] / tension - 1), 2e-5)

    def test_braced_square_hangs_on_one_diagonal(self):
        # code_aster, validation SSNL105
        results = self.run_scene("verification/braced-square.toml")["results"]
        self.assertLess(abs(results["tension_taut_cable"] - 1000 * math.sqrt(2)), 0.014)
        self.assertLess(abs(results["tension_lower"] + 1000), 0.01)
        self.assertEqual(results["tension_slack_cable"], 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
