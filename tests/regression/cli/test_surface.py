# SPDX-License-Identifier: BSD-3-Clause
"""Partly dry parts compared with closed forms: a floating box on a line, and bars at the surface and half out of the water."""
import math
import unittest

from program import InFreshFolder

DENSITY, GRAVITY = 1000, 9.81
DEPTH, LENGTH, EA, MASS, HEIGHT, CD = 10, 9.3, 5000, 600, 1.2, 1.1

BOX = f"""
[water]
density = {DENSITY}
gravity = {GRAVITY}
current = [SPEED, 0, 0]
[parts.line]
type = "rope/bar"
length = {LENGTH}
cells = 1
sketch = [[0, 0, {-DEPTH}], [0.1, 0, -0.5]]
rope = {{ EA = {EA}, diameter = 1e-7, density = {DENSITY} }}
[parts.box]
type = "float/box"
on = "line.end"
box = {{ mass = {MASS}, length_x = 1, length_y = 1, height = {HEIGHT}, drag_x = {CD} }}
[[hold]]
on = "line.start"
[results]
x = {{ of = "line.end", take = "x" }}
z = {{ of = "line.end", take = "z" }}
pull = {{ of = "line", take = "max tension" }}
"""

BAR = f"""
[water]
density = {DENSITY}
gravity = {GRAVITY}
current = [SPEED, 0, 0]
[parts.bar]
type = "rope/bar"
length = 4
cells = 1
sketch = SKETCH
rope = {{ EA = 1e10, EA_compression = 1e10, diameter = 0.1, density = OWN, surface = 1 }}
drag = {{ law = "hydro/morison", normal = {CD}, tangential = 0 }}
HOLD
[results]
x = {{ of = "bar.end", take = "x" }}
z = {{ of = "bar.end", take = "z" }}
"""


def root(f, low, high):
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return low


class Surface(InFreshFolder):
    def found(self, scene):
        self.write("scene.toml", scene)
        ended = self.netloft("run", "scene.toml", "--json")
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        return ended.json()["results"]

    def test_a_box_on_a_line_floats_deeper_by_its_pull(self):
        """rho g A d = m g + EA ((DEPTH - d)/LENGTH - 1), d how deep the box is immersed."""
        d = (MASS * GRAVITY + EA * (DEPTH / LENGTH - 1)) / (DENSITY * GRAVITY + EA / LENGTH)
        here = self.found(BOX.replace("SPEED", "0"))
        self.assertAlmostEqual(here["z"], -d, delta=1e-8)
        self.assertAlmostEqual(here["pull"], DENSITY * GRAVITY * d - MASS * GRAVITY, delta=1e-5)

    def test_a_box_on_a_line_leans_with_the_current_by_what_is_immersed(self):
        """T cos a = rho g A d - m g, T sin a = rho/2 C L d c^2, l cos a = DEPTH - d, T = EA (l/LENGTH - 1)."""
        speed = 1.5

        def pull(d):
            return math.hypot(DENSITY * GRAVITY * d - MASS * GRAVITY, DENSITY / 2 * CD * d * speed ** 2)

        def excess(d):
            up = DENSITY * GRAVITY * d - MASS * GRAVITY
            return up / pull(d) * LENGTH * (1 + pull(d) / EA) - (DEPTH - d)

        d = root(excess, MASS / DENSITY, HEIGHT)
        here = self.found(BOX.replace("SPEED", str(speed)))
        self.assertAlmostEqual(here["z"], -d, delta=1e-7)
        self.assertAlmostEqual(here["pull"], pull(d), delta=1e-3)

    def test_a_bar_floats_with_the_share_of_it_wet_that_its_density_says(self):
        """Its ends are cubes of half its volume, h wide: the wet fraction (h/2 - z)/h is its density over that of water."""
        h = (4 * math.pi * 0.1 ** 2 / 8) ** (1 / 3)
        for own in (200, 500, 850):
            hold = '[[hold]]\non = "bar.start"\naxes = "xy"\n[[hold]]\non = "bar.end"\naxes = "xy"\n' \
                   '[parts.guide]\ntype = "rope/bar"\nlength = 5\ncells = 1\nsketch = [[0, 0, -1], [0, 0, 0.01]]\n' \
                   'rope = { EA = 1, EA_compression = 0, diameter = 1e-7, density = 1000 }\n[[hold]]\non = "guide.start"\n' \
                   '[[join]]\npoints = ["guide.end", "bar.start"]\n'
            here = self.found(BAR.replace("SPEED", "0").replace("SKETCH", "[[0, 0, 0.01], [4, 0, 0.01]]").replace("OWN", str(own))
                              .replace("HOLD", hold))
            self.assertAlmostEqual(here["z"], h * (0.5 - own / DENSITY), delta=1e-8)

    def test_a_bar_that_is_half_out_of_the_water_leans_by_its_lower_half(self):
        """The dry upper end has neither drag nor buoyancy: q cos^2 a = (own - rho) V g sin a, q = rho/2 C D L c^2."""
        own, speed, length, diameter = 3000, 1.2, 4, 0.1
        q = DENSITY / 2 * CD * diameter * length * speed ** 2
        w = (own - DENSITY) * math.pi * diameter ** 2 / 4 * length * GRAVITY
        s = (-w + math.hypot(w, 2 * q)) / (2 * q)
        here = self.found(BAR.replace("SPEED", str(speed)).replace("SKETCH", "[[0, 0, 2], [0.3, 0, -2]]").replace("OWN", str(own))
                          .replace("HOLD", '[[hold]]\non = "bar.start"\n'))
        self.assertAlmostEqual(here["x"], length * s, delta=1e-6)
        self.assertAlmostEqual(here["z"], 2 - length * math.sqrt(1 - s * s), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
