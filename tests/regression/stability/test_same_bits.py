# SPDX-License-Identifier: BSD-3-Clause
"""Stages and results have the same bits with one thread, with two, and while other processes keep the machine busy.

NETLOFT_PROGRAM names the program, NETLOFT_SOURCE_DIR the source tree.
"""
import os
import unittest
from pathlib import Path

from same_bits import Busy, run

PROGRAM = os.environ["NETLOFT_PROGRAM"]
SOURCE = Path(os.environ["NETLOFT_SOURCE_DIR"])
LIBRARY = SOURCE / "gear-library" / "scenes"
HARD = SOURCE / "tests" / "stability" / "scenes"

# Ropes and netting, forces with and without a potential, contact, friction, a catch, a net plan: all the
# features by which strategies choose their attempts.
SCENES = (
    (LIBRARY / "hanging-rope.toml", ()),
    (LIBRARY / "dead-weight-panel.toml", ("parts.net.cells=[12,12]",)),
    (LIBRARY / "verification" / "stretched-panel.toml", ("parts.net.cells=[12,12]",)),
    (LIBRARY / "verification" / "codend-with-catch.toml", ("parts.codend.cells=[8,9]",)),
    (LIBRARY / "verification" / "rope-dragged-over-seabed.toml", ()),
    (LIBRARY / "four-panel.toml", ("gear.nodes=120",)),
    (HARD / "pelagic-trawl.toml", ()),
    (HARD / "fish-cage.toml", ()),
    (HARD / "gill-net.toml", ()),
    (HARD / "buoy-on-chain.toml", ()),
)


class SameBits(unittest.TestCase):
    def same_as_alone(self, threads):
        for scene, settings in SCENES:
            with self.subTest(scene=scene.stem):
                answer, data = run(PROGRAM, scene, settings, threads)
                alone, kept = self.alone(scene, settings)
                self.assertEqual(answer, alone)
                self.assertEqual(sorted(data), sorted(kept))
                self.assertEqual([name for name in data if data[name] != kept[name]], [])

    answers = {}

    def alone(self, scene, settings):
        if scene not in self.answers:
            self.answers[scene] = run(PROGRAM, scene, settings, 1)
        return self.answers[scene]

    def test_what_is_compared_is_there(self):
        answer, data = self.alone(*SCENES[0])
        self.assertEqual(answer["status"], "converged")
        self.assertIn("factorisations", answer)
        self.assertIn("VTKHDF/Points", data)
        self.assertNotIn("netloft/cost/total", data)

    def test_other_settings_have_other_bits(self):
        _, coarse = run(PROGRAM, SCENES[1][0], ("parts.net.cells=[8,8]",), 1)
        self.assertNotEqual(coarse["VTKHDF/Points"], self.alone(*SCENES[1])[1]["VTKHDF/Points"])

    def test_with_two_threads(self):
        self.same_as_alone(2)

    def test_beside_busy_processes(self):
        with Busy():
            self.same_as_alone(1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
