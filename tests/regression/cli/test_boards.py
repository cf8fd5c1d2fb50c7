# SPDX-License-Identifier: BSD-3-Clause
"""One otter board on one warp against another program and closed forms, from any attitude; named boards and polars."""
import math
import random
import unittest

import numpy as np
from board_alone import attitude, axes, imbalance
from program import InFreshFolder, changed

ONE = """\
[tow]
speed = "1.5433333333333334 m/s"

[parts.warp]
type = "rope/bar"
length = "100 m"
cells = 1
sketch = [[0, 0, 0], [80, 30, -50]]
rope = { diameter = "20 mm", EA = "100 MN", density = 1025 }
drag = { law = "hydro/morison", normal = 0, tangential = 0 }

[bodies.door]
type = "board/otter"
board = { area = 4.86, chord = 2.7, span = 1.8, mass = 816, volume = 0.104, centre_z = -0.3 }
at = [80, 30, -50]
turned = { heading = "35 deg" }
points = { warp = [-0.3, -0.8, 0.05] }

[[join]]
points = ["warp.end", "door.warp"]

[[hold]]
on = "warp.start"
"""
BOARD = {"area": 4.86, "chord": 2.7, "span": 1.8, "mass": 816, "volume": 0.104, "centre": (0, 0, -0.3), "parasite": 0.05}
EYE, FLOW = (-0.3, -0.8, 0.05), (1.5433333333333334, 0, 0)
NAMED = changed(ONE, ("board = { area = 4.86, chord = 2.7, span = 1.8, mass = 816, volume = 0.104, centre_z = -0.3 }",
                      'board = "cambered-vertical-4m2"'), ("points = { warp = [-0.3, -0.8, 0.05] }\n", ""))


def angles_of(figures):
    return np.array([figures[f"bodies/door/{name}"] for name in ("heading", "heel", "trim")])


def turned(text, angles):
    return changed(text, ('turned = { heading = "35 deg" }', "turned = {{ heading = {!r}, heel = {!r}, trim = {!r} }}".format(*map(float, angles))))


def is_same(one, other):
    return np.abs(axes(*one) - axes(*other)).max() < 1e-7


class Boards(InFreshFolder):
    def run_scene(self, text):
        self.write("scene.toml", text)
        return self.netloft("run", "scene.toml", "--json")

    def figures(self, text):
        ended = self.run_scene(text)
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        return ended.json()["gear"]["figures"]

    def test_a_board_on_a_warp_stands_where_another_program_has_it(self):
        for eye in (EYE, (-0.49, -0.5, 0.29), (-0.2, -0.5, 0)):
            mine = self.figures(changed(ONE, ("[-0.3, -0.8, 0.05]", str(list(eye)))))
            found, force = attitude(BOARD, eye, FLOW, angles_of(mine))
            np.testing.assert_allclose(angles_of(mine), found, atol=1e-8)
            eye_at = np.array([mine[f"bodies/door/{axis}"] for axis in "xyz"]) + axes(*found) @ np.array(eye)
            np.testing.assert_allclose(eye_at / np.linalg.norm(eye_at), force / np.linalg.norm(force), atol=1e-8)

    def test_a_board_that_floats_turns_until_its_pressure_meets_its_eye(self):
        """tan α = K_p ((1/2 - ξ0) chord/e - 1)/K_v, where the eye lies e ahead of the middle; weight and buoyancy keep it upright."""
        chord, span, e = 2.7, 1.8, 0.45
        A = span / chord
        Kp, xi = 2 * math.pi * A / (2 + math.sqrt(A * A + 4)), 0.25 * A**1.25 / (A**1.25 + 0.48)
        attack = math.atan(Kp * ((0.5 - xi) * chord / e - 1) / 3.1)
        self.assertLess(attack, math.radians(28), "before breakdown")
        light = changed(ONE, ("mass = 816, volume = 0.104", "mass = 1025, volume = 1, parasite = 0"), ("[-0.3, -0.8, 0.05]", f"[-{e}, -0.8, 0]"),
                        ('heading = "35 deg"', 'heading = "20 deg"'), ("[80, 30, -50]\nt", "[80, 30, 0]\nt"), ("[80, 30, -50]]", "[80, 30, 0]]"))
        np.testing.assert_allclose(angles_of(self.figures(light)), [attack, 0, 0], atol=1e-8)

    def test_from_any_attitude_it_finds_an_equilibrium_or_says_that_it_does_not(self):
        """Two attitudes are stable, found by the other program from 150 starts: it sheers out to starboard or to port."""
        stable = [np.radians(a) for a in ((72.064944612, 35.624608949, 30.538656910), (-24.7506, 61.4105, 20.1022))]
        stable = [attitude(BOARD, EYE, FLOW, a)[0] for a in stable]
        chance, found = random.Random(23), [0, 0]
        for _ in range(50):
            start = [chance.uniform(-most, most) for most in (3.1, 1.2, 1.2)]
            ended = self.run_scene(turned(ONE, start))
            report = ended.json()
            if ended.code != 0:
                self.assertNotEqual(report["stability"], "stable", start)
                continue
            angles = angles_of(report["gear"]["figures"])
            which = [k for k, a in enumerate(stable) if is_same(angles, a)]
            self.assertEqual(len(which), 1, f"{start} -> {angles}")
            found[which[0]] += 1
        self.assertGreaterEqual(sum(found), 45)
        self.assertGreater(min(found), 0)


    def test_a_cambered_board_of_the_catalogue_has_two_stable_attitudes(self):
        """Each is found from a start near it, is stable, and is where it was when it starts there."""
        found = [angles_of(self.figures(turned(NAMED, np.radians(a)))) for a in ((35, 0, 0), (-40, 20, 20))]
        self.assertFalse(is_same(*found))
        for angles in found:
            ended = self.run_scene(turned(NAMED, angles))
            self.assertEqual(ended.json()["stability"], "stable")
            self.assertTrue(is_same(angles_of(ended.json()["gear"]["figures"]), angles))

    def test_leaving_a_polar_is_said(self):
        """The polar of the catalogue's cambered board begins at 15 degrees; turned inward the water passes it from behind."""
        outside = self.run_scene(turned(NAMED, np.radians((-40, 20, 20)))).json()["warnings"]
        self.assertTrue(any("door" in w and "have no numbers" in w for w in outside), outside)


if __name__ == "__main__":
    unittest.main(verbosity=2)
