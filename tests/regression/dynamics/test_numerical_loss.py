#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""If the scheme removes a twentieth of the supplied energy, the report of a motion warns, with time and place.

    test_numerical_loss.py NETLOFT SOURCE_FOLDER
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

NETLOFT, SCENES = sys.argv[1], Path(sys.argv[2]) / "gear-library" / "scenes" / "dynamics"
LENGTH, EA, MASS, GRAVITY, FALL = 1, 2e4, 5, 9.81, 0.99
CAUGHT = np.sqrt(2 * FALL / GRAVITY)  # [s]
# A ball falls from the point where its slack rope is held, until the rope stops it.
SNAP = f"""
[water]
density = 0
gravity = {GRAVITY}
[parts.rope]
type = "rope/bar"
length = {LENGTH}
cells = 1
sketch = [[0, 0, 0], [0, 0, {FALL - LENGTH}]]
rope = {{ diameter = "5 mm", EA = {EA}, EA_compression = 0, density = 1e-3 }}
[parts.ball]
type = "float/float"
on = "rope.end"
float = {{ mass = {MASS}, volume = 0 }}
[[hold]]
on = "rope.start"
[analysis]
kind = "dynamic"
duration = 1.2
output_interval = 0.05
"""


LONG_STEPS = ("adaptive=false", "step=0.02")  # two to three in the time in which the rope throws the ball back


class NumericalLoss(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.snap = Path(self.folder.name) / "snap.toml"
        self.snap.write_text(SNAP)

    def ask(self, scene, *settings, text=False):
        words = [NETLOFT, "run", scene, "--threads", "1", "--overwrite", "-o", Path(self.folder.name) / "out.hdf"]
        for setting in settings:
            words += ["--set", "analysis." + setting]
        ended = subprocess.run(words + ([] if text else ["--json"]), capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr + ended.stdout)
        return ended.stdout if text else json.loads(ended.stdout)

    def test_of_a_snap_is_told_with_time_and_place(self):
        answer = self.ask(self.snap, *LONG_STEPS)
        loss = answer["numerical_loss"]
        self.assertTrue(loss["is_large"])
        self.assertAlmostEqual(loss["lost"], answer["energies"]["numerical"], delta=1e-9)
        self.assertAlmostEqual(loss["given"], MASS * GRAVITY * FALL, delta=0.1 * MASS * GRAVITY * FALL)
        self.assertLess(loss["from"], CAUGHT + np.pi * np.sqrt(MASS * LENGTH / EA))
        self.assertGreater(loss["until"], CAUGHT)
        self.assertEqual(loss["node"], "rope node 1")
        self.assertRegex(self.ask(self.snap, *LONG_STEPS, text=True), r"warning: the time scheme removed [\d.]+ J of the [\d.]+ J .* at rope node 1")

    def test_of_a_snap_in_fine_steps_is_none(self):
        self.assertFalse(self.ask(self.snap, "accuracy=1e-3")["numerical_loss"]["is_large"])

    def test_of_a_snap_in_a_damped_rope_is_none(self):
        damped = ("stiffness_damping=0.02", "accuracy=1e-4")
        self.assertFalse(self.ask(self.snap, *damped)["numerical_loss"]["is_large"])
        self.assertNotIn("warning", self.ask(self.snap, *damped, text=True))

    def test_of_a_smooth_motion_is_none(self):
        smooth = (SCENES / "released-rope.toml", "duration=2")
        self.assertFalse(self.ask(*smooth)["numerical_loss"]["is_large"])

    def test_is_not_known_without_a_budget(self):
        self.assertIsNone(self.ask(self.snap, "energy_budget=false")["numerical_loss"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
