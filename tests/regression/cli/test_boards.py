# SPDX-License-Identifier: BSD-3-Clause
"""One otter board on one warp, from any attitude, compared with another program and closed forms; boards by name and polars."""
import math
import random
import re
import tomllib
import unittest

import numpy as np
from board_alone import attitude, axes, plate
from program import SOURCE, InFreshFolder, changed
from wrong_boards import SHIP

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
        """Attitudes that it reaches from many starts; all are stable by the eigenvalues of their motion."""
        for eye, status in ((EYE, "converged"), ((-0.49, -0.5, 0.29), "converged"), ((-0.2, -0.5, 0), "converged")):
            report = self.run_scene(changed(ONE, ("[-0.3, -0.8, 0.05]", str(list(eye))))).json()
            self.assertEqual(report["status"], status, report["reason"])
            mine = report["gear"]["figures"]
            found, force = attitude(BOARD, eye, FLOW, angles_of(mine))
            np.testing.assert_allclose(angles_of(mine), found, atol=1e-8)
            eye_at = np.array([mine[f"bodies/door/{axis}"] for axis in "xyz"]) + axes(*found) @ np.array(eye)
            np.testing.assert_allclose(eye_at / np.linalg.norm(eye_at), force / np.linalg.norm(force), atol=1e-8)

    def test_a_board_that_floats_turns_until_its_pressure_meets_its_eye(self):
        """tan α = K_p ((1/2 - ξ0) chord/e - 1)/K_v, where the eye is e ahead of the middle; weight and buoyancy keep the board upright."""
        chord, span, e = 2.7, 1.8, 0.45
        A = span / chord
        Kp, xi = 2 * math.pi * A / (2 + math.sqrt(A * A + 4)), 0.25 * A**1.25 / (A**1.25 + 0.48)
        attack = math.atan(Kp * ((0.5 - xi) * chord / e - 1) / 3.1)
        self.assertLess(attack, math.radians(28), "before breakdown")
        light = changed(ONE, ("mass = 816, volume = 0.104", "mass = 1025, volume = 1, parasite = 0"), ("[-0.3, -0.8, 0.05]", f"[-{e}, -0.8, 0]"),
                        ('heading = "35 deg"', 'heading = "20 deg"'), ("[80, 30, -50]\nt", "[80, 30, 0]\nt"), ("[80, 30, -50]]", "[80, 30, 0]]"))
        np.testing.assert_allclose(angles_of(self.figures(light)), [attack, 0, 0], atol=1e-8)

    def test_a_wire_lies_deeper_where_the_bottom_is_softer(self):
        """A wire of weight w per metre sinks into the bed by half the softness plus w/k."""
        wire = """\
[parts.wire]
type = "rope/bar"
length = "10 m"
cells = 10
sketch = [[0, Y, -20], [10, Y, -20]]
rope = { diameter = "20 mm", EA = "10 MN", density = 7000 }

[bed]
depth = "20 m"
bottom = { x = [0, 0], y = [-2, 2], stiffness = [0.25, 2], friction = [1, 1], ploughing = [1, 1] }

[parts.ground]
type = "seabed/bed"
on = "wire"
seabed = { stiffness = "1 kN/m2", softness = "1 mm" }

[[hold]]
on = "wire"
axes = "xy"
[[hold]]
on = "wire.start"

[results]
z = { of = "wire.end", take = "min z" }
"""
        w = math.pi / 4 * 0.02**2 * (7000 - 1025) * 9.80665
        for y, factor in ((-5, 0.25), (5, 2), (0, (0.25 + 2) / 2)):
            ended = self.run_scene(wire.replace("Y", str(y)))
            self.assertEqual(ended.code, 0, ended.err + ended.out)
            z = ended.json()["results"]["z"]
            self.assertAlmostEqual(-z, 20 + 0.0005 + w / (1000 * factor), delta=1e-9)

    def test_from_any_attitude_it_finds_an_equilibrium_or_says_that_it_does_not(self):
        """Two attitudes are stable, found by the other program from 150 starts: it sheers out to starboard or to port. In other attitudes it is in balance, too, but swings; a run that finds no stable one with as much work again reports this."""
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
        self.assertGreaterEqual(sum(found), 35)
        self.assertGreater(min(found), 0)

    def test_a_cambered_board_on_one_warp_rests_in_no_attitude(self):
        """From 20 random attitudes: every balance on one warp is unstable (the board turns over or swings); two seem stable without masses."""
        chance, found = random.Random(23), []
        for _ in range(20):
            report = self.run_scene(turned(NAMED, [chance.uniform(-most, most) for most in (3.1, 1.2, 1.2)])).json()
            self.assertNotEqual(report["status"], "converged", report["reason"])
            if report["status"] == "unstable":
                self.assertIn("a small disturbance grows tenfold in", report["reason"])
                found.append(angles_of(report["gear"]["figures"]))
        self.assertGreater(len(found), 10)

    def test_restarts_find_the_other_attitudes_of_a_cambered_board(self):
        """Its eye is at the intersection of the lines of force at two angles of its tables, so that it balances at both: 30 degrees, and -40 with the suction inboard. Both are stable; restarts from one find the other and a third one between them."""
        angles, lift = [-60, -40, -20, -5, 5, 15, 30, 45, 60], [-.55, -.70, -.45, -.05, .55, 1.12, 1.699, 1.35, .95]
        drag, nose = [1.25, .75, .30, .12, .18, .463, 1.14, 1.45, 1.6], [.47, None, .30, .25, .55, .45, .42, .46, .48]
        chord, inboard = 1.9, -0.2
        def slope(i):  # of the line along which the force acts: aft over outward
            s, c = math.sin(math.radians(angles[i])), math.cos(math.radians(angles[i]))
            return (drag[i] * c - lift[i] * s) / (drag[i] * s + lift[i] * c)
        out, fallen = angles.index(30), angles.index(-40)
        eye = chord * (nose[out] - 0.5) + inboard * slope(out)
        nose[fallen] = (eye - inboard * slope(fallen)) / chord + 0.5
        attack = f'attack = {{ unit = "deg", values = {angles} }}'
        text = changed(ONE, ("board = { area = 4.86, chord = 2.7, span = 1.8, mass = 816, volume = 0.104, centre_z = -0.3 }",
                             f"board = {{ area = 4, chord = {chord}, span = 2.1, mass = 1025, volume = 1, centre_z = -0.3, inertia_x = 331, "
                             "inertia_y = 602, inertia_z = 271, added_y = 3500, turning_x = 640, turning_z = 480, "
                             f"polar = {{ {attack}, lift = {lift}, drag = {drag} }}, pressure = {{ {attack}, chord = {nose}, span = {[0] * 9} }} }}"),
                       ("points = { warp = [-0.3, -0.8, 0.05] }", f"points = {{ warp = [{eye!r}, {inboard}, 0] }}"),
                       ("at = [80, 30, -50]", "at = [95, 30, 0]"), ("[80, 30, -50]]", "[95, 30, 0]]"))
        for degrees in (30, -40):
            figures = self.figures(changed(text, ('heading = "35 deg"', f'heading = "{degrees + 3} deg"')))
            np.testing.assert_allclose(angles_of(figures), [math.radians(degrees), 0, 0], atol=1e-8)
        self.write("scene.toml", changed(text, ('heading = "35 deg"', 'heading = "-40 deg"')))
        report = self.netloft("run", "scene.toml", "--json", "--overwrite", "--strategy", "auto:everywhere=true,restarts=30,slice=1000").json()
        self.assertEqual(report["status"], "converged")
        self.assertEqual(len(report["shapes"]["others"]), 2, report["shapes"])
        heading = report["gear"]["spread"]["bodies/door/heading"]
        np.testing.assert_allclose([heading["least"], heading["largest"]], np.radians([-40, 30]), atol=1e-8)

    def test_a_kite_of_the_catalogue_lifts(self):
        """A board that is laid flat, with its suction side up and its nose up by 20 degrees, has the lift of a plate; with the other side up it is a depressor."""
        line = changed(NAMED, ('board = "cambered-vertical-4m2"', 'board = "kite-0.7m2"\nturns = "not"'), ("at = [80, 30, -50]", "at = [98, 0, 0]"),
                       ("[80, 30, -50]]", "[98, 0, 0]]"), ("door.warp", "door.front"))
        line += '[[hold]]\non = "door.origin"\naxes = "yz"\n'
        for heel, trim, lifts in ((-90, 20, 1), (90, -20, -1)):
            turned_so = f'turned = {{ heel = "{heel} deg", trim = "{trim} deg" }}'
            self.write("scene.toml", changed(line, ('turned = { heading = "35 deg" }', turned_so)))
            ended = self.netloft("run", "scene.toml", "--json", "--overwrite")
            self.assertEqual(ended.code, 0, ended.err)
            figures = ended.json()["gear"]["figures"]
            self.assertAlmostEqual(figures["bodies/door/attack"], math.radians(20), places=9)
            normal, _, _ = plate((math.cos(math.radians(20)), math.sin(math.radians(20)), 0), 0.7, 1.0)
            force = 0.5 * 1025 * 0.7 * FLOW[0]**2 * normal * math.cos(math.radians(20))
            self.assertAlmostEqual(figures["body_forces/door/water/z"] / (lifts * force), 1, delta=1e-9)

    def test_boards_of_the_catalogue_have_the_forces_that_their_sources_give(self):
        """"0.80 and 0.65 at 40 deg" are the coefficients of the law of the plate with the factors of the board, to the digits that are given."""
        boards = tomllib.loads((SOURCE / "gear-library/catalogue/boards.toml").read_text())["board"]
        number = lambda text: float(text.split()[0])
        found = 0
        for name, board in boards.items():
            if said := re.search(r"([\d.]+) and ([\d.]+) at (\d+) deg", board["source"]):
                lift, drag, attack = float(said[1]), float(said[2]), math.radians(float(said[3]))
                normal, _, _ = plate((math.cos(attack), math.sin(attack), 0), number(board["chord"]), number(board["span"]))
                self.assertAlmostEqual(board["lift"] * normal * math.cos(attack), lift, delta=0.01, msg=name)
                self.assertAlmostEqual(board["drag"] * (normal * math.sin(attack) + 0.05), drag, delta=0.01, msg=name)
                found += 1
            elif "those of a flat plate" not in board["source"]:
                self.assertIn("polar", board, name)
        self.assertGreaterEqual(found, 3)

    def test_leaving_a_polar_is_said(self):
        """The polar of the catalogue's cambered board begins at 15 degrees; if the board is turned inward, the water meets its back."""
        outside = self.run_scene(turned(NAMED, np.radians((-40, 20, 20)))).json()["warnings"]
        self.assertTrue(any("door" in w and "do not cover the direction of the flow" in w for w in outside), outside)


MESH = 'nodes = 0\nsize = "0.3 m"\nfiner = { bridle = 2 }'  # the same in the half and in the whole
SHOE = """
[parts.shoe]
type = "seabed/bed"
on = ["door.toe", "door.heel"]
each = 0.5
seabed = { stiffness = "50 kN/m2", friction = 0.4 }

[elements.bridle]
rope = { density = 6000 }

[analysis]
tolerance = 1e-11
"""


class Towed(InFreshFolder):
    def figures(self, text):
        self.write("scene.toml", text)
        ended = self.netloft("run", "scene.toml", "--json")
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        return ended.json()["gear"]["figures"]

    def test_half_a_gear_stands_for_the_whole(self):
        half = self.figures(changed(SHIP, ("nodes = 60", MESH)) + SHOE)
        whole = self.figures(changed(SHIP, ('"half"', '"whole"'), ("nodes = 60", MESH)) + SHOE)
        same = [name for name in half if name in whole and name.split("/")[0] in ("mouth", "pairs", "towing")]
        self.assertEqual([name for name in half if name.startswith("pairs/") and name not in same], [], "one name in the half and in the whole")
        self.assertLessEqual({"pairs/door/" + name for name in ("spread", "heel", "attack", "z", "spread_force", "ground_share")}, set(same))
        self.assertIn("towing/pull", same)
        for name in same:
            self.assertLess(abs(half[name] - whole[name]), 1e-8 * max(1, abs(half[name])), name)
        for name in ("heading", "heel", "trim"):
            self.assertLess(abs(half["bodies/door/" + name] - whole["bodies/starboard-door/" + name]), 1e-8, name)
            self.assertLess(abs(half["bodies/door/" + name] - whole["bodies/port-door/" + name]), 1e-8, name)
        self.assertGreater(half["pairs/door/spread"], 6, "boards spread farther than the blocks")

    def test_power_of_towing_goes_into_the_parts(self):
        """The powers add up to pull times speed."""
        text = changed(SHIP, ('speed = "2 kn"', 'speed = "2 kn"\nefficiency = 0.12')) + SHOE
        figures = self.figures(text)
        parts = {name: value for name, value in figures.items() if name.startswith("power/")}
        self.assertEqual(list(parts), ["power/" + name for name in ("netting", "ropes", "bodies", "warps", "ground")])
        self.assertAlmostEqual(sum(parts.values()) / figures["towing/power"], 1, delta=2e-5)
        self.assertAlmostEqual(parts["power/bodies"], figures["drag_by_part/door/x"] * 2 * 1852 / 3600, places=6)
        self.assertAlmostEqual(parts["power/ground"], figures["ground/friction_x"] * 2 * 1852 / 3600, delta=1e-6 * parts["power/netting"])
        said = self.netloft("report", "scene.hdf").out
        self.assertRegex(said, r"power of towing +\[kW\]\n( +\w+ +[\d.]+\n)* +netting +%.3f\n" % (parts["power/netting"] / 1000))
        self.assertAlmostEqual(float(re.search(r"towing fuel +([\d.]+) kg/h", said)[1]), figures["towing/fuel"] * 3600, places=4)

    def test_half_a_gear_whose_boards_have_crossed_is_no_answer(self):
        start = 'board = "flat-1.0x2.0"\nat = [88.4, -20.4, -39.5]\nturned = { heading = "129 deg", heel = "12 deg", trim = "180 deg" }'
        for scene, crossed in ((SHIP, False), (changed(SHIP, ('board = "flat-1.0x2.0"', start)), True)):
            self.write("scene.toml", scene + SHOE)
            ended = self.netloft("run", "scene.toml", "--json", "--overwrite")
            result = ended.json()
            self.assertEqual((ended.code, result["status"]), (3, "not converged") if crossed else (0, "converged"))
            self.assertEqual("have crossed. A whole gear has no such equilibrium" in result["reason"], crossed, result["reason"])
            self.assertEqual("warning: at the start door, " in self.netloft("plan", "scene.toml").err, crossed)

    def test_a_whole_gear_whose_boards_have_crossed_is_no_answer(self):
        start = 'board = "flat-1.0x2.0"\nat = [88.4, -20.4, -39.5]\nturned = { heading = "129 deg", heel = "12 deg", trim = "180 deg" }'
        self.write("scene.toml", changed(SHIP, ('board = "flat-1.0x2.0"', start), ('"half"', '"whole"')) + SHOE)
        ended = self.netloft("run", "scene.toml", "--json")
        self.assertEqual((ended.code, ended.json()["status"]), (3, "not converged"))
        self.assertRegex(ended.json()["reason"], r"^starboard-door is \S+ m to port of port-door: they have crossed\. No gear is meant to have this shape")
        warnings = ended.json()["warnings"]
        self.assertTrue(any(w.startswith("starboard-door is ") and w.endswith(" m to port of port-door: they have crossed") for w in warnings), warnings)


if __name__ == "__main__":
    unittest.main(verbosity=2)
