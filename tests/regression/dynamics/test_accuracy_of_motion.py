#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Accuracy of a motion: the report has the requested and the measured accuracy, and errors fall with it in spite of snaps.

    test_accuracy_of_motion.py NETLOFT SOURCE_FOLDER
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, MOTIONS = sys.argv[1], Path(sys.argv[2]) / "tests" / "bench" / "motions"
BALL = 4  # node of snap.toml
# A chain that is sketched a fifth shorter than its length: the nodes move apart fast, and bars become taut
# within a step.
SHORT_CHAIN = ["parts.chain.sketch=[[0,0,-8],[3,0,-7.2]]", "parts.chain.rope.EA_compression=856", "analysis.duration=0.3"]

# A ball on a light bar that stands upright on its lower end. Without a disturbance the bar remains upright;
# any deviation grows as cosh(t sqrt(g/l)).
UPRIGHT = """
[water]
density = 0
gravity = 9.81
[parts.bar]
type = "rope/bar"
length = 1
cells = 1
sketch = [[0, 0, 0], [0, 0, 0.9975475]]  # compressed by the weight of the ball
rope = { diameter = "5 mm", EA = 2e4, EA_compression = 2e4, density = 1e-3 }
[parts.ball]
type = "float/float"
on = "bar.end"
float = { mass = 5, volume = 0 }
[[hold]]
on = "bar.start"
[analysis]
kind = "dynamic"
accuracy = 1e-2
check = true
duration = 7
output_interval = 0.02
"""


class AccuracyOfMotion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = Path(self.folder.name) / "out.hdf"

    def ask(self, scene, *settings, text=False, exit_code=0):
        words = [NETLOFT, "run", MOTIONS / (scene + ".toml"), "--threads", "1", "--overwrite", "-o", self.output]
        for setting in settings:
            words += ["--set", setting]
        ended = subprocess.run(words + ([] if text else ["--json"]), capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, exit_code, ended.stderr + ended.stdout)
        return ended.stdout if text else json.loads(ended.stdout)

    def path_of_ball(self, accuracy):
        self.ask("snap", f"analysis.accuracy={accuracy}")
        with h5py.File(self.output) as f:
            return np.array([f["VTKHDF/Points"][first + BALL] for first in f["VTKHDF/Steps/PointOffsets"][()]])

    def test_is_told_in_the_report_in_json_and_in_the_result(self):
        told = self.ask("snap", "analysis.accuracy=1e-3")["accuracy"]
        self.assertEqual(told["asked"], 1e-3)
        self.assertAlmostEqual(told["allowed"], 1e-4, delta=1e-16)
        self.assertLessEqual(told["largest"], told["allowed"])
        self.assertGreater(told["largest"], 0.5 * told["allowed"])
        self.assertGreater(told["sum"], told["largest"])
        self.assertRegex(told["node"], r"rope node \d")
        with h5py.File(self.output) as f:
            for name in ("asked", "allowed", "largest", "sum"):
                self.assertEqual(f["netloft/accuracy/" + name][()], told[name])
        self.assertRegex(self.ask("snap", "analysis.accuracy=1e-3", text=True),
                         r"accuracy of 0\.001 requested, an error of 0\.0001 allowed for each step; the largest error of a step was [\d.e-]+ \(rope node \d+, t = [\d.]+ s\)")

    def test_of_given_steps_is_not_told(self):
        self.assertIsNone(self.ask("snap", "analysis.adaptive=false", "analysis.step=1e-3")["accuracy"])

    def test_is_what_errors_after_a_snap_fall_with(self):
        reference = self.path_of_ball(1e-5)
        errors = [np.linalg.norm(self.path_of_ball(a) - reference, axis=-1).max() for a in (1e-2, 1e-3, 1e-4)]
        self.assertLess(errors[1], 0.3 * errors[0])
        self.assertLess(errors[2], 0.02 * errors[0])

    def test_of_a_path_that_was_not_reached_is_said_with_exit_code_3(self):
        coarse = "analysis.check=true", "analysis.accuracy=1e-2"
        path = self.ask("snap", *coarse, exit_code=3)["accuracy"]["path"]
        self.assertFalse(path["reached"])
        self.assertGreater(path["error"], 1e-2)
        with h5py.File(self.output) as f:
            self.assertEqual(f["netloft/accuracy/path"][()], path["error"])
        self.assertRegex(self.ask("snap", *coarse, text=True, exit_code=3), r"warning: error of the path [\d.]+, at t = [\d.]+ s at rope node \d")

    def test_of_a_path_that_was_reached_bounds_the_error(self):
        """Before the snap, while the ball falls freely beside its slack rope."""
        free = ["analysis.integrator=energy-momentum", "analysis.duration=0.2"]
        self.ask("snap", *free, "analysis.accuracy=1e-5")
        with h5py.File(self.output) as f:
            reference = f["VTKHDF/Points"][()].reshape(-1, 5, 3)
        told = self.ask("snap", *free, "analysis.accuracy=1e-2", "analysis.check=true")["accuracy"]
        with h5py.File(self.output) as f:
            error = np.linalg.norm(f["VTKHDF/Points"][()].reshape(-1, 5, 3) - reference, axis=-1).max()
        self.assertTrue(told["path"]["reached"])
        self.assertLessEqual(error, told["path"]["error"] * told["longest_element"])

    def test_of_a_path_is_known_for_steps_that_are_given(self):
        given = ["analysis.check=true", "analysis.adaptive=false", "analysis.duration=0.1", "analysis.integrator=central-difference"]
        errors = [self.ask("snap", *given, f"analysis.step={h}")["accuracy"]["path"]["error"] for h in (2e-4, 5e-5)]
        self.assertLess(errors[1], 0.5 * errors[0])

    def test_of_a_chaotic_path_is_not_claimed_from_when_a_disturbance_has_grown_to_it(self):
        scene = Path(self.folder.name) / "upright.toml"
        scene.write_text(UPRIGHT)
        displaced = 1e-7 * np.hypot(*(2 * (0.61803398874989485 * (i + 1) % 1) - 1 for i in range(2)))  # of the ball [m]
        expected = np.arccosh(1e-2 / displaced) / np.sqrt(9.81)
        for tolerance in (1e-2, 1e-4, 1e-9):
            path = self.ask(str(scene.with_suffix("")), f"analysis.tolerance={tolerance}", exit_code=3)["accuracy"]["path"]
            self.assertAlmostEqual(path["predictable_until"], expected, delta=0.02 * expected)
            self.assertFalse(path["reached"])
        self.assertIn("the motion is chaotic", self.ask(str(scene.with_suffix("")), text=True, exit_code=3))
        hanging = self.ask(str(scene.with_suffix("")), "parts.bar.sketch=[[0,0,0],[0,0,-1]]")["accuracy"]["path"]
        self.assertTrue(hanging["reached"])
        self.assertIsNone(hanging["predictable_until"])

    def test_of_a_damper_that_sets_in_within_a_step_makes_no_energy(self):
        answer = self.ask("chain", *SHORT_CHAIN, "analysis.integrator=energy-momentum")
        self.assertGreater(answer["energies"]["loss_work"], 0)
        self.assertGreater(answer["numerical_loss"]["lost"], -1e-6 * answer["numerical_loss"]["given"])

    def test_of_explicit_steps_keeps_to_what_taut_members_allow(self):
        for scene in ("snap", "heave"):
            with self.subTest(scene=scene):
                answer = self.ask(scene, "analysis.integrator=central-difference")
                self.assertLess(answer["stable_step"], 0.01)
                self.assertLessEqual(answer["longest_step"], 0.6 * answer["stable_step"] * (1 + 1e-12))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
