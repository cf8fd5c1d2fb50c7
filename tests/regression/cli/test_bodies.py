# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies from a scene to a result: named points, sides, attitude, elements on their points, motion."""
import math
import unittest

import h5py
import numpy as np
from program import InFreshFolder, changed
from wrong_bodies import HANGING

# The tail hangs from a point aft of the eye; the centre of mass is not on the line between them.
LEANING = changed(HANGING, ("mass = \"800 kg\"", "mass = \"800 kg\", centre_x = 0.2, inertia_x = 60, inertia_y = 60, inertia_z = 60"),
                  ("[results]\n", "[results]\ntrim = { of = \"clump\", take = \"trim\" }\neye = { of = \"clump.eye\", take = \"z\" }\nx = { of = \"clump\", take = \"x\" }\n"))


def rotation(p):
    """The matrix of a rotation vector, by Rodrigues."""
    angle = np.linalg.norm(p)
    if angle == 0:
        return np.eye(3)
    k = np.array([[0, -p[2], p[1]], [p[2], 0, -p[0]], [-p[1], p[0], 0]]) / angle
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


class Bodies(InFreshFolder):
    def run_scene(self, text, *args):
        self.write("scene.toml", text)
        ended = self.netloft("run", "scene.toml", "--json", *args)
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        return ended.json()

    def value(self, report, name):
        return next(s["value"] for s in report["scalars"] if s["name"] == name) if isinstance(report["scalars"], list) else report["scalars"][name]

    def test_a_clump_leans_by_its_levers(self):
        """Moments about the eye: weight at (0.2, -0.5) and the tail at (0.1, -1) turn it until they balance."""
        report = self.run_scene(LEANING)
        g, rho = 9.80665, 1025
        weight = 800 * g
        lift = 0.1 * rho * g
        tail = math.pi / 4 * 0.02**2 * (7000 - rho) * g * 5
        # lever arms from the eye in body axes: mass (0.2, -0.5), volume (0, -0.5), tail (0.1, -1)
        x = weight * 0.2 + tail * 0.1
        z = (weight - lift) * 0.5 + tail * 1.0
        figures = report["gear"]["figures"]
        self.assertAlmostEqual(figures["bodies/clump/trim"], math.atan2(x, z), places=9)
        self.assertAlmostEqual(figures["bodies/clump/heel"], 0, places=9)

    def test_points_are_where_the_attitude_in_the_result_has_them(self):
        self.run_scene(LEANING)
        with h5py.File(self.folder / "scene.hdf") as f:
            bodies, points = f["netloft/bodies"], f["VTKHDF/Points"][:]
            self.assertEqual([n.decode() for n in bodies["name"]], ["clump"])
            self.assertEqual([n.decode() for n in bodies["points/name"]], ["eye", "foot"])
            origin = int(bodies["origin"][0])
            turn = f["VTKHDF/PointData/rotation"][:][origin]
            for node, place in zip(bodies["points/node"], bodies["points/place"]):
                np.testing.assert_allclose(points[node], points[origin] + rotation(turn) @ place, atol=1e-12)
            others = [i for i in range(len(points)) if i != origin]
            self.assertTrue(np.isnan(f["VTKHDF/PointData/rotation"][:][others]).all())

    def test_port_is_the_mirror_image_of_starboard(self):
        """A body in a current across the gear, pulled at a point outward of its middle: `side` and the sign of the current make its mirror image."""
        outward = changed(HANGING, ("foot = [0.1, 0, -0.5]", "foot = [0.1, 0.3, -0.5]"),
                          ("volume = 0.1 }", 'volume = 0.1, centre_y = 0.2, drag_x = 1, drag_y = 2, drag_z = 1 }\nturned = { heel = "10 deg" }'),
                          ("[parts.warp]", "[water]\ncurrent = [0.5, 0.8, 0]\n[parts.warp]"))
        port = changed(outward, ("points = {", 'side = "port"\npoints = {'), ("[0.5, 0.8, 0]", "[0.5, -0.8, 0]"))
        mine = [self.run_scene(text)["gear"]["figures"] for text in (outward, port)]
        for name, value in mine[0].items():
            sign = -1 if name.endswith("/y") else 1
            self.assertAlmostEqual(mine[1][name], sign * value, places=8, msg=name)
        self.assertGreater(abs(mine[0]["bodies/clump/heel"]), 0.05)

    def test_the_report_says_it_in_degrees(self):
        self.write("scene.toml", LEANING)
        said = self.netloft("run", "scene.toml").out
        self.assertRegex(said, r"bodies +heading \[°\] +heel \[°\] +trim \[°\]")
        again = self.netloft("report", "scene.hdf").out
        line = next(l for l in said.splitlines() if l.strip().startswith("clump "))
        self.assertIn(line, again)
        self.assertIn("1 rigid body,", self.netloft("plan", "scene.toml").out)

    def test_parts_stand_on_bodies_and_on_their_points(self):
        more = LEANING + '[parts.more]\ntype = "body/solid"\non = "clump"\nbody = { mass = "100 kg" }\n' \
                         '[parts.buoy]\ntype = "float/float"\non = "clump.foot"\nfloat = { buoyancy = "500 N" }\n'
        plain = self.run_scene(LEANING)["gear"]["figures"]["bodies/clump/trim"]
        loaded = self.run_scene(more)["gear"]["figures"]["bodies/clump/trim"]
        self.assertGreater(abs(loaded - plain), 1e-3)

    def test_a_force_turns_with_the_body_or_keeps_its_direction(self):
        """Two loads on named points that coincide at the start and separate when the body turns; the same on both sides."""
        one_axis = changed(LEANING, ("points = {", 'turns = "about x"\npoints = {'))
        text = one_axis + '[parts.push]\ntype = "force/body"\non = "clump.foot"\nforce = { y = "300 N" }\n'
        figures = self.run_scene(text)["gear"]["figures"]
        world = self.run_scene(changed(text, ("force/body", "force/constant")))["gear"]["figures"]
        plain = self.run_scene(one_axis)["gear"]["figures"]
        self.assertGreater(abs(figures["bodies/clump/heel"] - plain["bodies/clump/heel"]), 0.01)
        self.assertGreater(abs(figures["bodies/clump/heel"] - world["bodies/clump/heel"]), 1e-4)
        at = self.run_scene(changed(text, ('on = "clump.foot"', 'on = "clump"')))["gear"]["figures"]
        self.assertGreater(abs(figures["bodies/clump/heel"] - at["bodies/clump/heel"]), 1e-3)
        port = self.run_scene(changed(text, ("points = {", 'side = "port"\npoints = {')))["gear"]["figures"]
        self.assertAlmostEqual(port["bodies/clump/heel"], figures["bodies/clump/heel"], places=8)
        self.assertAlmostEqual(port["bodies/clump/y"], -figures["bodies/clump/y"], places=8)

    def test_a_triangle_stands_on_three_named_points(self):
        text = LEANING + '[parts.flag]\ntype = "catch/front"\non = ["clump.eye", "clump.foot", "tail.end"]\n' \
                         'catch = { pressure = "100 N/m2", front = -1000, volume = 0 }\n'
        self.write("scene.toml", text)
        checked = self.netloft("plan", "scene.toml")
        self.assertEqual(checked.code, 0, checked.err)
        self.assertRegex(checked.out, r"catch/front.*1 ")

    def test_it_moves(self):
        text = LEANING + '[analysis]\nkind = "dynamic"\nduration = 2\noutput_interval = 0.5\naccuracy = 1e-4\ngeneralized-alpha = { spectral_radius = 1 }\n'
        self.run_scene(text)
        with h5py.File(self.folder / "scene.hdf") as f:
            trim = f["netloft/series/trim"][:]
            numerical = f["netloft/series/energy/numerical"][:]
            kinetic = f["netloft/series/energy/kinetic"][:]
        self.assertEqual(trim[0], 0)
        self.assertGreater(np.abs(trim).max(), 0.05)
        self.assertLess(np.abs(numerical).max(), 0.05 * kinetic.max())


if __name__ == "__main__":
    unittest.main(verbosity=2)
