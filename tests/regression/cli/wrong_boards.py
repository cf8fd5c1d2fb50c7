# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in boards, their polars, beds and ships, as in wrong_case.py. Each case is BOARD or SHIP with a change."""
from program import GOOD, changed
from wrong_case import Wrong

# A board on a warp, with a polar over two angles.
BOARD = """\
[tow]
speed = "3 kn"

[parts.warp]
type = "rope/bar"
length = "100 m"
cells = 1
sketch = [[0, 0, 0], [80, 30, -50]]
rope = { diameter = "20 mm", EA = "100 MN", density = 1025 }

[bodies.door]
type = "board/otter"
at = [80, 30, -50]
points = { warp = [-0.3, -0.8, 0] }
[bodies.door.board]
area = 4
chord = 2
span = 2
mass = 800
[bodies.door.board.polar_slip]
attack = { unit = "deg", values = [10, 40, 10, 40] }
sideslip = { unit = "deg", values = [-10, -10, 10, 10] }
lift = [0.8, 1.1, 0.8, 1.1]
drag = [0.3, 0.8, 0.3, 0.8]
side = [0, 0, 0, 0]

[[join]]
points = ["warp.end", "door.warp"]

[[hold]]
on = "warp.start"
"""

# A sheet of netting behind boards and a ship.
SHIP = """\
[gear]
extent = "half"
nodes = 60

[panels.net]
mesh = "200 mm"
twine = "pe-braided-3mm"
fore = 40
depth = 20
sides = "AN"
open = ["sides", "aft"]

[ropes.headline]
stands = "middle"
rope = "combination-3-strand-16mm"
length = "4.2 m"

[[hang]]
edge = "net.fore"
on = "headline"
ratio = 0.5

[ship]
speed = "2 kn"
warp = { rope = "6x19-fc-16mm", length = "100 m" }

[bodies.door]
type = "board/otter"
board = "flat-1.0x2.0"

[ropes.bridle]
rope = "6x19-fc-16mm"
length = "20 m"
between = ["door.sweep", "headline.end"]

[bed]
depth = "40 m"
"""


def board(name, old, new, where, says, hint="", **more):
    return Wrong(name, where and "scene.toml:" + where, says, hint, content=changed(BOARD, (old, new)), **more)


def ship(name, old, new, where, says, hint="", **more):
    return Wrong(name, where and "scene.toml:" + where, says, hint, content=changed(SHIP, (old, new)), **more)


def beside(name, text, where, says, hint="", **more):
    return Wrong(name, "scene.toml:" + where, says, hint, content=SHIP + text, **more)


ATTACK = 'attack = { unit = "deg", values = [10, 40, 10, 40] }'

ALL = [
    board("polar with a gap", "10, 40, 10, 40", "10, 40, 10, 45", "21:10", "there is no row for attack = ", "one for every pair"),
    board("polar with a row twice", "10, 40, 10, 40", "10, 10, 10, 40", "21:10", "there are two rows for attack = "),
    board("column too short", "lift = [0.8, 1.1, 0.8, 1.1]", "lift = [0.8, 1.1, 0.8]", "23:8", "has 3 values; 4 are expected"),
    board("column without values", ATTACK, 'attack = { unit = "deg" }', "21:10", 'missing key "values"',
          also=[("scene.toml:22:37", "has 4 values; 1 is expected"), ("scene.toml:23:8", "has 4 values"), ("scene.toml:24:8", "has 4 values"), ("scene.toml:25:8", "has 4 values")]),
    board("column without a unit", ATTACK, "attack = { values = [10, 40, 10, 40] }", "21:10", 'missing key "unit"'),
    board("angles in metres", 'attack = { unit = "deg"', 'attack = { unit = "m"', "21:19", ""),
    board("angles in no unit", 'attack = { unit = "deg"', 'attack = { unit = "degs"', "21:19", ""),
    board("a column of another polar", "side = [0, 0, 0, 0]", "moment = [0, 0, 0, 0]", "25:1", 'unknown key "moment"', also=[("scene.toml:20:1", 'missing key "side"')]),
    board("two polars", "span = 2\n", "span = 2\npolar = { attack = [0.2, 0.6], lift = [1, 1], drag = [1, 1] }\n", "11:1", "board.polar and board.polar_slip"),
    board("a polar that does not ascend", "span = 2\n", "span = 2\npressure = { attack = [0.6, 0.2], chord = [0.3, 0.4], span = [0, 0] }\n", "19:23", "does not ascend"),
    board("polar of no name", "span = 2\n", 'span = 2\npolar = "camberred-low-aspect"\n', "19:9", "camberred-low-aspect", "cambered-low-aspect"),
    board("board without an area", "area = 4\n", "", "15:1", 'missing key "area"'),
    board("board of no height", "span = 2\n", "span = 0\n", "18:8", "is outside [0.01, 100] m"),
    board("mass over displaced water", "mass = 800\n", 'mass = "800 N"\n', "19:8", "board.mass"),
    board("ground softer than sand", "span = 2\n", "span = 2\npower = 5\n", "19:9", "is outside [1, 3]"),
    board("a side of nobody", "points = {", 'side = "left"\npoints = {', "14:8", "left"),
    board("bed without a depth", "[tow]", "[bed]\nslope_x = 0.1\n[tow]", "1:1", 'missing key "depth" in bed'),
    board("bed in fathoms of time", "[tow]", '[bed]\ndepth = "40 s"\n[tow]', "2:9", "bed.depth"),
    board("bed as steep as a wall", "[tow]", "[bed]\ndepth = 40\nslope_y = 20\n[tow]", "3:11", "outside [-10, 10]"),
    board("relief with a gap", "[tow]", "[bed]\ndepth = 40\nrelief = { x = [0, 1, 0], y = [0, 0, 1], height = [0, 0, 0] }\n[tow]", "3:16",
          "there is no row for x = "),
    board("shoes without a bed", "[[join]]", '[parts.shoe]\ntype = "seabed/bed"\non = "door.warp"\n[[join]]', "27:1",
          "seabed/bed needs the bed of the scene, but there is none", "[bed] depth"),
    board("a ship without a gear", "[tow]", '[ship]\nspeed = "3 kn"\n[tow]', "1:1", "needs a net plan, but the scene has none"),
    ship("ship without a speed", 'speed = "2 kn"\n', "", "23:1", 'missing key "speed" in ship'),
    ship("ship without a warp", 'warp = { rope = "6x19-fc-16mm", length = "100 m" }\n', "", "23:1", "warp"),
    ship("warp of no length", ', length = "100 m" }', " }", "25:8", 'missing key "length" in ship.warp'),
    ship("warp of no rope", 'rope = "6x19-fc-16mm", length = "100 m"', 'length = "100 m"', "25:8", "rope"),
    ship("warp to nowhere", 'length = "100 m" }', 'length = "100 m", to = "door.wrap" }', "25:56", 'there is no point "door.wrap"'),
    ship("blocks under one another", 'speed = "2 kn"', 'speed = "2 kn"\nblock = { height = "4 m", gap = "-6 m" }', "25:33", "ship.block.gap"),
    ship("unequal warps of half a gear", 'length = "100 m" }', 'length = "100 m", length_port = "110 m" }', "2:10", "a different length to port", 'extent = "whole"'),
    ship("a body of half a gear", 'type = "board/otter"', 'stands = "alone"\ntype = "board/otter"', "2:10", "exists only once", 'extent = "whole"'),
    ship("a side of a pair", 'type = "board/otter"', 'side = "port"\ntype = "board/otter"', "28:8", "is given by the net plan"),
    ship("a leg to no point", "door.sweep", "door.swep", "34:11", 'there is no point "door.swep"', "door.sweep"),
    ship("a leg to no board", "door.sweep", "dor.sweep", "34:11", 'there is no point "dor.sweep"', "door.sweep"),
    ship("a body named as a rope", "[bodies.door]", "[bodies.bridle]", "27:1", 'there is something named "bridle" already'),
    ship("board of no name", '"flat-1.0x2.0"', '"flat-1x2"', "29:9", "flat-1x2", also=[("scene.toml:25:8", "no body has a point")]),
    ship("two that a warp may lead to", "[ropes.bridle]", '[bodies.other]\ntype = "board/otter"\nboard = "flat-1.0x2.0"\n[ropes.bridle]', "25:8",
         "more than one body has a point"),
    ship("warp that is pushed", 'length = "100 m" }', 'length = "100 m", tension = "-12 kN" }', "25:61", "ship.warp.tension = -12000 N is outside (0, 1e9] N"),
    ship("warp of a mass", 'length = "100 m" }', 'length = "100 m", tension = "12 kg" }', "25:61", "ship.warp.tension"),
    ship("tension of one warp alone", 'length = "100 m" }', 'length = "100 m", tension_port = "12 kN" }', "25:66", "is given without a tension of the starboard warp", "give tension beside tension_port"),
    ship("unequal winches of half a gear", 'length = "100 m" }', 'length = "100 m", tension = "12 kN", tension_port = "13 kN" }', "2:10", "a different tension to port",
         'extent = "whole"'),
    ship("tension without a length to begin with", ', length = "100 m" }', ', tension = "12 kN" }', "25:8", 'missing key "length" in ship.warp'),
    ship("winch at rest", 'length = "100 m" }', 'length = "100 m", winch = { tension = "12 kN" } }', "25:59", "nothing moves in a static analysis"),
    ship("winch of who goes through time", 'length = "100 m" }', 'length = "100 m", tension = "12 kN" }\n[analysis]\nsolver = "newmark"', "25:61", "is an integrator",
         "another solver"),
    beside("bottom of nothing", "bottom = { x = [0, 0], y = [-10, 10], stiffness = [0, 0], friction = [1, 1], ploughing = [1, 1] }\n", "38:51", "is outside (0, 1e6]"),
    beside("bottom that pulls", "bottom = { x = [0, 0], y = [-10, 10], stiffness = [1, 1], friction = [-1, -1], ploughing = [1, 1] }\n", "38:70", "is outside [0, 1e6]"),
    beside("bottom without friction", "bottom = { x = [0, 0], y = [-10, 10], stiffness = [1, 1], ploughing = [1, 1] }\n", "38:10", 'missing key "friction"'),
    beside("bottom with a gap", "bottom = { x = [0, 1, 0], y = [0, 0, 1], stiffness = [1, 1, 1], friction = [1, 1, 1], ploughing = [1, 1, 1] }\n", "38:16", "there is no row for x = "),
    beside("bottom of one side of half a gear", "bottom = { x = [0, 0], y = [-10, 10], stiffness = [1, 2], friction = [1, 1], ploughing = [1, 1] }\n", "38:10",
           "differs between the two sides"),
    Wrong("bottom that nothing feels", f"scene.toml:{GOOD.count(chr(10)) + 3}:10", "has no effect", "seabed/bed",
          content=GOOD + "[bed]\ndepth = 40\nbottom = { x = [0, 0], y = [-10, 10], stiffness = [1, 1], friction = [1, 1], ploughing = [1, 1] }\n"),
    beside("a warp of one's own", '[ropes.warp]\nrope = "6x19-fc-16mm"\nlength = 3\n', "25:8", 'there is something named "warp" already'),
    beside("towed twice", "[tow]\nspeed = 1\n", "24:9", "ship.speed is given beside [tow]"),
    beside("bed across half a gear", "slope_y = 0.1\n", "38:11", "differs between the two sides", 'extent = "whole"'),
    beside("relief of one side of half a gear", "relief = { x = [0, 0], y = [-10, 10], height = [0, 1] }\n", "38:10", "differs between the two sides"),
]
