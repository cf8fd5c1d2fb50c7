#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Figures that do not depend on how a scene is written: turned, moved, mirrored, with parts in another order, with ends exchanged, in other units,
with two threads, in a file that another one includes.

    test_invariance.py NETLOFT
"""
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT = sys.argv[1]
METRE, FOOT = ("m", 1.0), ("ft", 0.3048)


class Frame:
    """Writes points and velocities of a scene; the scene itself is the same in every frame."""

    def __init__(self, turn=0.0, move=(0, 0, 0), mirror=False, unit=METRE):
        self.turn, self.move, self.mirror, self.unit = math.radians(turn), np.array(move, float), mirror, unit

    def direction(self, v):
        x, y, z = v
        if self.mirror:
            y = -y
        c, s = math.cos(self.turn), math.sin(self.turn)
        return np.array([c * x - s * y, s * x + c * y, z])

    def length(self, value):
        return f'"{value / self.unit[1]!r} {self.unit[0]}"'

    def point(self, *p):
        return "[" + ", ".join(self.length(float(v)) for v in self.direction(p) + self.move) + "]"

    def line(self, *points):
        return "[" + ", ".join(self.point(*p) for p in points) + "]"

    def speed(self, *v):
        per = f"{self.unit[0]}/s"
        return "[" + ", ".join(f'"{float(w) / self.unit[1]!r} {per}"' for w in self.direction(v)) + "]"

    def height(self, z):
        return self.length(z + self.move[2])


def rope(f, flip):
    ends = [(0, 0, -2), (2, 1, -9), (11, 3, -4)]
    return f"""
[parts.rope]
type = "rope/bar"
length = {f.length(14)}
cells = 20
sketch = {f.line(*(ends[::-1] if flip else ends))}
rope = {{ diameter = {f.length(0.02)}, EA = 50000, density = 1140 }}
""", ["""
[[hold]]
on = "rope.start"
""", """
[[hold]]
on = "rope.end"
"""], f"current = {f.speed(1.2, 0.3, 0)}", {"low": ("rope", "min z"), "a": ("rope.%s" % ("end" if flip else "start"), "reaction"),
                                            "b": ("rope.%s" % ("start" if flip else "end"), "reaction"), "pull": ("rope", "max tension")}


def ball_on_rope(f, flip):
    body, holds, water, take = rope(f, flip)
    ball = f"""
[parts.ball]
type = "float/float"
on = "rope.{"start" if flip else "end"}"
float = {{ mass = 20, volume = 0.005, drag_coefficient = 0.5, diameter = {f.length(0.2)} }}
"""
    free = holds[:1] if not flip else holds[1:]
    take = {"low": take["low"], "a": take["a"], "pull": take["pull"]}
    return ball, [body] + free, water, take


def net(f, flip):
    corners = [(0, -1, -4), (0, 1, -4), (0.3, 1, -6), (0.3, -1, -6)]
    if flip:  # counted from the other side
        corners = [corners[1], corners[0], corners[3], corners[2]]
    return f"""
[parts.net]
type = "priour/triangle"
panel = {{ across = 24, along = 24, bar = {f.length(0.06)} }}
cells = [8, 8]
sketch = {f.line(*corners)}
twine = {{ diameter = {f.length(0.003)}, EA = 20000, EA_compression = 0, density = 1140 }}
""", [f"""
[[hold]]
on = "net.fore"
at = {f.line(corners[0], corners[1])}
"""], f"current = {f.speed(0.7, 0.2, 0)}", {"low": ("net", "min z"), "high": ("net", "max z"), "pull": ("net.fore", "sum reaction z"),
                                            "twine": ("net", "max tension")}


def weighted_net(f, flip):
    body, holds, water, take = net(f, flip)
    chain = f"""
[parts.chain]
type = "rope/bar"
length = {f.length(1.3)}
cells = 8
sketch = {f.line((0.3, 1 if flip else -1, -6), (0.3, -1 if flip else 1, -6))}
rope = {{ diameter = {f.length(0.03)}, EA = 1e5, EA_compression = 0, density = 5000 }}

[analysis]
tolerance = 1e-10
swinging = "accepted"                          # the slack chain flutters
"""
    join = """
[[join]]
points = ["net.aft", "chain"]
"""
    if flip:
        join = join.replace('"net.aft", "chain"', '"chain", "net.aft"')
    return chain, [body, join] + holds, water, take | {"chain": ("chain", "max tension")}


def rope_on_bed(f, flip):
    ends = [(0, 0, -3), (9, 0.5, -20), (40, 0, -20)]
    take = "end" if flip else "start"
    return f"""
[parts.line]
type = "rope/bar"
length = {f.length(46)}
cells = 46
sketch = {f.line(*(ends[::-1] if flip else ends))}
rope = {{ diameter = {f.length(0.05)}, EA = 5e6, density = 4000 }}
""", [f"""
[bed]
depth = {f.length(20 - f.move[2])}
""", f"""
[parts.ground]
type = "seabed/bed"
on = "line"
seabed = {{ radius = {f.length(0.025)}, stiffness = 1e5 }}
""", """
[[hold]]
on = "line.start"
""", """
[[hold]]
on = "line.end"
"""], f"current = {f.speed(0.2, 0.4, 0)}", {"low": ("line", "min z"), "a": (f"line.{take}", "reaction"), "a_z": (f"line.{take}", "reaction z"),
                                            "pull": ("line", "max tension")}


def rope_in_profile(f, flip):
    body, holds, _, take = rope(f, flip)
    speeds = [f.direction(v) for v in ((1.5, 0, 0), (0.4, 0.5, 0))]
    column = lambda k: "[" + ", ".join(repr(float(v[k])) for v in speeds) + "]"
    return body, holds, f"current = {{ z = [{f.height(-1)}, {f.height(-9)}], x = {column(0)}, y = {column(1)} }}", take


def swinging_rope(f, flip):
    ends = [(0, 0, -2), (8, 2, -7)]
    return f"""
[parts.rope]
type = "rope/bar"
length = {f.length(math.dist(*ends))}
cells = 10
sketch = {f.line(*(ends[::-1] if flip else ends))}
rope = {{ diameter = {f.length(0.02)}, EA = 50000, density = 3000 }}
""", [f"""
[[hold]]
on = "rope.{"end" if flip else "start"}"
""", """
[analysis]
kind = "dynamic"
duration = "2 s"
output_interval = "1 s"
accuracy = 1e-4
tolerance = 1e-10
"""], f"current = {f.speed(0.2, 0.1, 0)}", {"low": ("rope", "min z"), "a": ("rope.%s" % ("end" if flip else "start"), "reaction z")}


def clump_on_rope(f, flip):
    body, holds, water, take = rope(f, flip)
    heading = -math.degrees(f.turn) * (-1 if f.mirror else 1)
    clump = f"""
[bodies.clump]
type = "body/solid"
at = {f.point(11, 3, -4)}
side = "{"port" if f.mirror else "starboard"}"
turned = {{ heading = "{heading!r} deg" }}
points = {{ eye = [{f.length(-0.6)}, 0, {f.length(0.25)}] }}
body = {{ mass = 120, volume = 0.02, centre_z = -0.15, float_x = 0.2, inertia_x = 3, inertia_y = 5, inertia_z = 5, drag_x = 0.2, drag_y = 0.4, drag_z = 0.5 }}
"""
    join = f"""
[[join]]
points = ["rope.{"start" if flip else "end"}", "clump.eye"]
"""
    take = {"low": take["low"], "a": take["a"], "pull": take["pull"], "heel": ("clump", "heel"), "trim": ("clump", "trim")}
    return clump, [body, join] + (holds[:1] if not flip else holds[1:]), water, take


def codend(f, flip):
    def panel(name, corners):
        return f"""
[parts.{name}]
type = "priour/triangle"
panel = {{ across = 40, along = 30, bar = {f.length(0.05)} }}
cells = [6, 6]
sketch = {f.line(*corners)}
twine = {{ diameter = {f.length(0.004)}, EA = 17000, EA_compression = 0, density = 1140 }}
"""
    upper = [(0, -0.6, -9.7), (0, 0.6, -9.7), (2.6, 0.6, -9.7), (2.6, -0.6, -9.7)]
    lower = [(0, 0.6, -10.3), (0, -0.6, -10.3), (2.6, -0.6, -10.3), (2.6, 0.6, -10.3)]
    seams = [("upper.right", "lower.left"), ("lower.right", "upper.left")]
    if flip:  # one of the panels drawn from the other side
        lower = [lower[1], lower[0], lower[3], lower[2]]
        seams = [("upper.right", "lower.right"), ("lower.left", "upper.left")]
    joins = "".join(f"""
[[join]]
points = ["{a}", "{b}"]
""" for a, b in seams)
    rim = [(0, 0.5 * math.cos(a), -10 + 0.35 * math.sin(a)) for a in np.linspace(math.pi, 0, 13)]
    under = [(0, -y, -20 - z) for _, y, z in rim]
    holds = f"""
[[hold]]
on = "upper.fore"
at = {f.line(*rim)}
[[hold]]
on = "lower.fore"
at = {f.line(*(under[::-1] if flip else under))}
"""
    closed = """
[[join]]
points = ["upper.aft", "lower.aft"]
together = true
"""
    catch = """
[parts.catch]
type = "catch/pressure"
on = ["upper", "lower"]
catch = { pressure = 400, meshes = 20 }
"""
    return panel("upper", upper), [panel("lower", lower), catch, joins, closed, holds], f"current = {f.speed(1.0, 0, 0)}", {
        "low": ("upper", "min z"), "high": ("upper", "max z"), "twine": ("upper", "max tension"), "pull": ("upper.fore", "sum reaction z")}


SCENES = [rope, ball_on_rope, net, weighted_net, rope_on_bed, rope_in_profile, swinging_rope, clump_on_rope, codend]
WAYS = {
    "turned": dict(frame=Frame(turn=37.3)),
    "moved": dict(frame=Frame(move=(1234.5, -678.9, 0))),
    "lowered": dict(frame=Frame(move=(0, 0, -8))),
    "mirrored": dict(frame=Frame(mirror=True)),
    "in feet": dict(frame=Frame(unit=FOOT)),
    "in another order": dict(reverse=True),
    "from the other end": dict(flip=True),
    "turned, moved and mirrored": dict(frame=Frame(turn=-101, move=(-50, 70, -3), mirror=True)),
    "on two threads": dict(threads=2),
    "again": dict(),
    "included by another file": dict(included=True),
}


def text_of(scene, frame=Frame(), reverse=False, flip=False):
    first, rest, water, take = scene(frame, flip)
    blocks = [first] + rest
    if "[analysis]" not in "".join(blocks):
        blocks.append("\n[analysis]\ntolerance = 1e-10\n")
    lines = [f'{name} = {{ of = "{of}", take = "{what}" }}' for name, (of, what) in take.items()]
    if reverse:
        blocks, lines = blocks[::-1], lines[::-1]
    return f"[water]\n{water}\n" + "".join(blocks) + "\n[results]\n" + "\n".join(lines) + "\n"


class Invariance(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def figures(self, scene, threads=1, included=False, **way):
        file, result = Path(self.folder.name) / "scene.toml", Path(self.folder.name) / "result.hdf"
        file.write_text(text_of(scene, **way))
        if included:
            file = file.rename(file.with_name("inner.toml"))
            outer = file.with_name("scene.toml")
            outer.write_text('include = ["inner.toml"]\n')
            file = outer
        ended = subprocess.run([NETLOFT, "run", file, "-o", result, "--overwrite", "--threads", str(threads)], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr + ended.stdout + file.read_text())
        lowered = way.get("frame", Frame()).move[2]
        with h5py.File(result) as f:
            return {name: f[f"netloft/scalars/{name}"][()] - (lowered if name in ("low", "high") else 0) for name in f["netloft/scalars"]}

    def test_figures_are_the_same_however_a_scene_is_written(self):
        runs = 0
        for scene in SCENES:
            as_written = self.figures(scene)
            for name, way in WAYS.items():
                with self.subTest(scene=scene.__name__, way=name):
                    runs += 1
                    other = self.figures(scene, **way)
                    self.assertEqual(as_written.keys(), other.keys())
                    for figure, value in as_written.items():
                        if name in ("on two threads", "again", "included by another file"):
                            self.assertEqual(other[figure], value, figure)
                        # Steps of a motion depend on the axes, because the largest error of any component
                        # decides their length.
                        within = 1e-3 if scene is swinging_rope else 1e-6
                        self.assertAlmostEqual(other[figure], value, delta=within * max(abs(value), 1e-1), msg=figure)
        self.assertEqual(runs, len(SCENES) * len(WAYS))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
