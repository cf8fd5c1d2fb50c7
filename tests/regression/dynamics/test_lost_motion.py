#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A motion whose scheme creates energy is reported as lost, and a correct motion is not.

    test_lost_motion.py NETLOFT SOURCE_FOLDER [thorough]

Thorough, as tests/nightly calls it, every scheme runs without the energy budget, too.
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SCENES = sys.argv[1], Path(sys.argv[2]) / "gear-library" / "scenes" / "dynamics"
BUDGETS = ("true", "false") if "thorough" in sys.argv[3:] else ("true",)
CENTRAL = ["integrator=central-difference"]
FIXED_POINT = ["integrator=newmark", "newmark.corrector=fixed-point"]
FIXED = ["adaptive=false", "dense=true"]


class Run:
    def __init__(self, scene, *settings):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "out.hdf"
            words = [NETLOFT, "run", SCENES / (scene + ".toml"), "--json", "--threads", "1", "-o", file]
            for setting in settings:
                words += ["--set", "analysis." + setting]
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            self.code, self.answer = done.returncode, json.loads(done.stdout)
            with h5py.File(file) as f:
                first, count = f["VTKHDF/Steps/PointOffsets"][0], f["VTKHDF/NumberOfPoints"][0]
                self.first_positions = f["VTKHDF/Points"][first:first + count]
                kept = f["netloft/status"].attrs
                self.outcome, self.sentence = (str(kept[name], "utf-8") if isinstance(kept[name], bytes) else kept[name]
                                               for name in ("outcome", "sentence"))


def limit_of(scene, scheme):
    """Longest stable step, from the tangent at the start."""
    return Run(scene, *scheme, "duration=1e-5").answer["stable_step"]


class LostMotion(unittest.TestCase):
    def expect_lost(self, run):
        self.assertNotEqual(run.code, 0)
        self.assertEqual(run.answer["status"], "not finished")
        self.assertIn("the motion is lost", run.answer["reason"])
        self.assertRegex(run.answer["reason"], r"node \d+ moves at")
        self.assertEqual(run.outcome, "not finished")
        self.assertEqual(run.sentence, run.answer["reason"])

    def expect_found(self, run):
        self.assertEqual(run.code, 0)
        self.assertEqual(run.answer["status"], "finished", run.answer["reason"])
        self.assertEqual(run.outcome, "finished")

    def test_central_differences_beyond_their_limit(self):
        limit = limit_of("towed-rope-speeds-up", CENTRAL)
        for budget in ("true", "false"):
            with self.subTest(energy_budget=budget):
                settings = [*CENTRAL, *FIXED, f"energy_budget={budget}"]
                self.expect_found(Run("towed-rope-speeds-up", *settings, f"step={0.98 * limit}"))
                self.expect_lost(Run("towed-rope-speeds-up", *settings, f"step={1.05 * limit}"))

    def test_the_fixed_point_beyond_its_limit(self):
        limit = limit_of("elastic-pendulum", FIXED_POINT)
        settings = [*FIXED_POINT, *FIXED, "newmark.corrections=900", "duration=1"]
        self.expect_found(Run("elastic-pendulum", *settings, f"step={0.97 * limit}"))
        beyond = Run("elastic-pendulum", *settings, f"step={1.05 * limit}")
        self.assertNotEqual(beyond.code, 0)
        self.assertIn("too long: the step does not settle", beyond.answer["reason"])
        self.assertEqual(beyond.outcome, "not finished")

    def test_stiff_bars_under_a_scheme_that_damps_nothing(self):
        self.expect_lost(Run("pendulum-of-bars", "integrator=newmark"))

    def test_scenes_as_they_are(self):
        for scene in sorted(SCENES.glob("*.toml")):
            with self.subTest(scene=scene.stem):
                # Whole trawls take from half a minute to seven minutes; tests/bench/real_time.py runs the
                # first of them.
                if scene.stem != "83-112-in-motion":  # which the test of all scenes begins
                    self.expect_found(Run(scene.stem, *(["duration=1"] if scene.stem == "trawl-speeds-up" else [])))

    def test_start_is_the_equilibrium_of_statics_to_the_digit(self):
        for scene in ("trawl-speeds-up", "towed-rope-speeds-up"):
            with self.subTest(scene=scene):
                moving = Run(scene, "duration=1e-3")
                still = Run(scene, "kind=static", "tolerance=1e-10")  # to which the start of a motion is found
                self.expect_found(moving)
                self.assertEqual(still.code, 0)
                np.testing.assert_array_equal(moving.first_positions, still.first_positions)

    def test_schemes_within_their_limits(self):
        for scene, seconds in (("elastic-pendulum", 2), ("hanging-panel", 5), ("released-rope", 2),
                               ("towed-rope-speeds-up", 40), ("panel-in-current", 0.2)):
            for scheme in (CENTRAL, FIXED_POINT, ["integrator=newmark", "newmark.chi=-0.3"]):
                for budget in BUDGETS:
                    with self.subTest(scene=scene, scheme=scheme, energy_budget=budget):
                        self.expect_found(Run(scene, *scheme, f"energy_budget={budget}", f"duration={seconds}"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
