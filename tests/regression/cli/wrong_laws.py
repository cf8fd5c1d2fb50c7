# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in laws of drag, model scales, tows and floats, with the place and words of the message (wrong_case.py)."""
from wrong_case import edit

NET, WATER, JOIN = "density = 2000 }", "gravity = 9.81", "[[join]]"
CATCH = '[parts.catch]\ntype = "catch/pressure"\non = "net"\ncatch = { pressure = 100, meshes = 5 }\n'
BALL = '[parts.ball]\ntype = "float/float"\non = "rope.end"\n'

LAWS = [
    edit(name, NET, f"{NET}\ndrag = {drag}", place, says, hint, code=code)
    for name, drag, place, says, hint, code in (
        ("twine: negative knots", '{ law = "hydro/netting-twine", knots = -1 }', "11:47",
         "parts.net.drag.knots = -1 is outside [0, 10]", "", 2),
        ("twine: knots of eleven times the twines", '{ law = "hydro/netting-twine", knots = 11 }', "11:47",
         "parts.net.drag.knots = 11 is outside [0, 10]", "", 2),
        ("twine: knots in words", '{ law = "hydro/netting-twine", knots = "many" }', "11:47",
         'parts.net.drag.knots: "many" does not begin with a number', 'write a number, such as 10', 2),
        ("twine: knots as long as a metre", '{ law = "hydro/netting-twine", knots = "0.1 m" }', "11:47",
         'parts.net.drag.knots: "0.1 m" is a length (m); a pure number (1) is expected', "", 2),
        ("twine: knots of no size", '{ law = "hydro/netting-twine", knot_diameter = 0 }', "11:55",
         "parts.net.drag.knot_diameter = 0 is outside [0.1, 20]", "", 2),
        ("twine: a size of knots with a unit", '{ law = "hydro/netting-twine", knot_diameter = "5 mm" }', "11:55",
         'parts.net.drag.knot_diameter: "5 mm" is a length (m); a pure number (1) is expected', "", 2),
        ("twine: a misspelt key", '{ law = "hydro/netting-twine", knot_diametre = 2 }', "11:39",
         'unknown key "knot_diametre" in parts.net.drag', 'did you mean "knot_diameter"?', 2),
        ("twine: a cylinder nobody measured", '{ law = "hydro/netting-twine", cylinder = "takaki" }', "11:50",
         'parts.net.drag.cylinder = "takaki" is not one of "choo-casarella", "takagi"', 'did you mean "takagi"?', 2),
        ("twine: a number for a cylinder", '{ law = "hydro/netting-twine", cylinder = 2 }', "11:50",
         "parts.net.drag.cylinder is the integer 2; a text is expected", "", 2),
        ("twine: shielding that speeds up", '{ law = "hydro/netting-twine", shielding = 2.5 }', "11:51",
         "parts.net.drag.shielding = 2.5 is outside [0, 2]", "", 2),
        ("twine: shielding against the flow", '{ law = "hydro/netting-twine", shielding = -0.1 }', "11:51",
         "parts.net.drag.shielding = -0.1 is outside [0, 2]", "", 2),
        ("twine: a key of screens", '{ law = "hydro/netting-twine", measured_at = 500 }', "11:39",
         'unknown key "measured_at" in parts.net.drag', "", 2),
        ("twine: a key of another law", '{ law = "hydro/netting-twine", tangential = 0.08 }', "11:39",
         'unknown key "tangential" in parts.net.drag', "", 2),
        ("a misspelt law", '"hydro/netting-twines"', "11:8",
         'parts.net.drag: the plugin "hydro" has no law "hydro/netting-twines"; did you mean "hydro/netting-twine"?', "", 4),
        ("another misspelt law", '{ law = "hydro/knoted" }', "11:16",
         'parts.net.drag.law: the plugin "hydro" has no law "hydro/knoted"; did you mean "hydro/knotted"?', "", 4),
        ("a table without its law", "{ knots = 0.1 }", "11:10",
         'unknown key "knots" in parts.net.drag', 'allowed here: "law", "normal", "tangential", "shielding"', 2),
        ("an element for a law", '"rope/bar"', "11:8",
         'parts.net.drag: "rope/bar" is an element, and no law', "", 2),
        ("screen: measured at less than nothing", '{ law = "hydro/loland", measured_at = -1 }', "11:46",
         "parts.net.drag.measured_at = -1 is outside [0, 1e5]", "", 2),
        ("screen: measured beyond the crisis", '{ law = "hydro/loland", measured_at = 1e6 }', "11:46",
         "parts.net.drag.measured_at = 1e6 is outside [0, 1e5]", "", 2),
        ("screen: measured at a speed", '{ law = "hydro/loland", measured_at = "0.5 m/s" }', "11:46",
         'parts.net.drag.measured_at: "0.5 m/s" is a speed (m/s); a pure number (1) is expected', "", 2),
        ("screen: measured at several", '{ law = "hydro/loland", measured_at = [500] }', "11:46",
         "parts.net.drag.measured_at is an array of 1; a number is expected", "", 2),
        ("screen: measured at no number", '{ law = "hydro/loland", measured_at = nan }', "11:46",
         "parts.net.drag.measured_at = nan is not a finite number", "", 2),
        ("screen: a misspelt key", '{ law = "hydro/loland", mesured_at = 500 }', "11:32",
         'unknown key "mesured_at" in parts.net.drag', 'did you mean "measured_at"?', 2),
        ("screen: a cylinder nobody measured", '{ law = "hydro/loland", measured_at = 500, cylinder = "choo" }', "11:62",
         'parts.net.drag.cylinder = "choo" is not one of "choo-casarella", "takagi"', "", 2),
        ("screen: knots of another law", '{ law = "hydro/loland", knots = 0.1 }', "11:32",
         'unknown key "knots" in parts.net.drag', "", 2),
        ("screen: a wake nobody knows", '{ law = "hydro/loland", wake = "lolland" }', "11:39",
         'parts.net.drag.wake = "lolland" is not one of "none", "loland"', 'did you mean "loland"?', 2),
        ("knotted: negative drag", '{ law = "hydro/knotted", normal = -1 }', "11:42",
         "parts.net.drag.normal = -1 is outside [0, 10]", "", 2),
        ("knotted: drag with a unit", '{ law = "hydro/knotted", normal = "1.35 m" }', "11:42",
         'parts.net.drag.normal: "1.35 m" is a length (m); a pure number (1) is expected', "", 2),
        ("knotted: friction beyond all", '{ law = "hydro/knotted", friction = 11 }', "11:44",
         "parts.net.drag.friction = 11 is outside [0, 10]", "", 2),
        ("knotted: a slope beyond all", '{ law = "hydro/knotted", friction_slope = -11 }', "11:50",
         "parts.net.drag.friction_slope = -11 is outside [-10, 10]", "", 2),
        ("knotted: a misspelt key", '{ law = "hydro/knotted", frictions = 0.4 }', "11:33",
         'unknown key "frictions" in parts.net.drag', 'did you mean "friction"?', 2),
        ("Reynolds: true for a cylinder", '{ law = "hydro/morison-reynolds", cylinder = true }', "11:53",
         "parts.net.drag.cylinder is the boolean true; a text is expected", "", 2),
        ("Reynolds: a table of one number", '{ law = "hydro/morison-reynolds", normal = 1.2 }', "11:51",
         "parts.net.drag.normal is the number 1.2; a table is expected", "", 2),
        ("Reynolds: a table that goes back", '{ law = "hydro/morison-reynolds", normal = [[100, 1.5], [10, 2]] }', "11:51",
         "parts.net.drag.normal is an array of 2; a table is expected", "", 2),
    )
]

SCALES = [
    edit("scale: " + name, WATER, line, place, says, hint, code=code)
    for name, line, place, says, hint, code in (
        ("none", "model_scale = 0", "3:15",
         "water.model_scale = 0 is outside [1, 1000]", "", 2),
        ("the other way round", "model_scale = 0.125", "3:15",
         "water.model_scale = 0.125 is outside [1, 1000]", "", 2),
        ("a ratio in words", 'model_scale = "1:8"', "3:15",
         'water.model_scale: ":8" in "1:8" cannot be read as a unit', 'write products and powers as "kg/m3", "N.m/rad", "m^2"', 2),
        ("a length", 'model_scale = "8 m"', "3:15",
         'water.model_scale: "8 m" is a length (m); a pure number (1) is expected', "", 2),
        ("a misspelt key", "model_scal = 8", "3:1",
         'unknown key "model_scal" in water', 'did you mean "model_scale"?', 2),
        ("a gear of a thousand models", "model_scale = 2000", "3:15",
         "water.model_scale = 2000 is outside [1, 1000]", "", 2),
        ("true", "model_scale = true", "3:15",
         "water.model_scale is the boolean true; a number is expected", "", 2),
    )
]

TOWS = [
    edit("tow: " + name, "[water]", f"[tow]\n{lines}\n[water]", place, says, hint, code=code)
    for name, lines, place, says, hint, code in (
        ("no number", "speed = nan", "2:9",
         "tow.speed = nan is not a finite number", "", 2),
        ("faster than ships", 'speed = "120 kn"', "2:9",
         "tow.speed = 61.733333333333334 m/s is outside [0, 50] m/s", "", 2),
        ("a velocity", "speed = [1, 0, 0]", "2:9",
         "tow.speed is an array of 3; a speed in m/s is expected", 'write an SI number or a text such as "1 m/s"', 2),
        ("a speed for an angle", 'speed = 1\nleeway = "1 kn"', "3:10",
         'tow.leeway: "1 kn" is a speed (m/s); an angle (rad) is expected', "kn is the knot; the kilonewton is kN", 2),
        ("round and round", 'speed = 1\nleeway = "200 deg"', "3:10",
         "tow.leeway = 3.490658503988659 rad is outside [-3.1416, 3.1416] rad", "", 2),
    )
]

SPHERES = [
    edit("sphere: " + name, JOIN, BALL + line + "\n" + JOIN, place, says, hint, code=code)
    for name, line, place, says, hint, code in (
        ("a sphere without a diameter", 'float = { buoyancy = 20, drag_law = "sphere" }', "19:1",
         'float/float element 0 is refused: float.drag_law = "sphere" needs float.diameter', "", 2),
        ("a law nobody knows", 'float = { buoyancy = 20, diameter = 0.2, drag_law = "spheer" }', "22:53",
         'parts.ball.float.drag_law = "spheer" is not one of "constant", "sphere"', 'did you mean "sphere"?', 2),
        ("a number for a law", "float = { buoyancy = 20, diameter = 0.2, drag_law = 1 }", "22:53",
         "parts.ball.float.drag_law is the integer 1; a text is expected", "", 2),
        ("a sphere of another law", 'float = { buoyancy = 20, diameter = 0.2, drag_law = "hydro/morison" }', "22:53",
         'parts.ball.float.drag_law = "hydro/morison" is not one of "constant", "sphere"', "", 2),
    )
]

CATCHES = [edit("a catch that is longer than its netting", JOIN, CATCH + JOIN, "19:1",
                "catch/pressure element 0 is refused: catch.meshes = 5 is more than the length of the netting, 4 meshes")]

ALL = LAWS + SCALES + TOWS + SPHERES + CATCHES
