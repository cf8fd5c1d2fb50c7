# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in rigid bodies, as in wrong_case.py. Each case is HANGING with a change."""
from program import changed
from wrong_case import Wrong

# A clump that is joined to one rope at its eye and to a second rope at another point.
HANGING = """\
[parts.warp]
type = "rope/bar"
length = "5 m"
cells = 2
sketch = [[0, 0, 0], [0, 0, -5]]
rope = { diameter = "20 mm", EA = "100 kN", density = 7000 }

[parts.tail]
type = "rope/bar"
length = "5 m"
cells = 2
sketch = [[0, 0, -6], [0, 0, -11]]
rope = { diameter = "20 mm", EA = "100 kN", density = 7000 }

[bodies.clump]
type = "body/solid"
at = [0, 0, -5.5]
points = { eye = [0, 0, 0.5], foot = [0.1, 0, -0.5] }
body = { mass = "800 kg", volume = 0.1 }

[[join]]
points = ["warp.end", "clump.eye"]

[[join]]
points = ["clump.foot", "tail.start"]

[[hold]]
on = "warp.start"

[results]
heel = { of = "clump", take = "heel" }
"""

IN_MOTION = '[analysis]\nkind = "dynamic"\nduration = 1\n'
IN_MOTION_BY_SET = ["--set", "analysis.kind=dynamic", "--set", "analysis.duration=1"]
EYE = 'points = ["warp.end", "clump.eye"]'
POINTS = "points = { eye = [0, 0, 0.5], foot = [0.1, 0, -0.5] }"


def body(name, old, new, where, says, hint="", **more):
    return Wrong(name, where and "scene.toml:" + where, says, hint, content=changed(HANGING, (old, new)), **more)


def beside(name, text, where, says, hint="", **more):
    return Wrong(name, "scene.toml:" + where, says, hint, content=HANGING + text, **more)


ALL = [
    body("bodies is no table", '[bodies.clump]\ntype = "body/solid"', '[bodies]\nclump = 3\n[parts.other]\ntype = "body/solid"', "16:9",
         "a body is a table, such as [bodies.door]", also=[("scene.toml:18:8", "body/solid needs a rigid body"),
         ("scene.toml:24:23", 'there is no part "clump"'), ("scene.toml:27:11", 'there is no part "clump"'), ("scene.toml:33:15", 'there is no part "clump"')]),
    body("body of a rope", 'type = "body/solid"', 'type = "rope/bar"', "16:8", "rope/bar cannot be on a rigid body", "[parts.clump]"),
    body("rope of a body", 'type = "rope/bar"\nlength = "5 m"\ncells = 2\nsketch = [[0, 0, -6]', 'type = "body/solid"\nlength = "5 m"\ncells = 2\nsketch = [[0, 0, -6]',
         "9:8", "body/solid needs a rigid body", "make one with [bodies.tail]"),
    body("no place", "at = [0, 0, -5.5]\n", "", "15:1", 'missing key "at" in bodies.clump'),
    body("place of two numbers", "at = [0, 0, -5.5]", "at = [0, 0]", "17:6", "has 2 values; 3 are expected"),
    body("point of two numbers", "eye = [0, 0, 0.5]", "eye = [0, 0]", "18:18", "has 2 values; 3 are expected"),
    body("point without a number", "eye = [0, 0, 0.5]", 'eye = "top"', "18:18", "bodies.clump.points.eye is the text"),
    body("point in millimetres of mercury", "eye = [0, 0, 0.5]", 'eye = [0, 0, "3 kg"]', "18:25", "bodies.clump.points.eye"),
    body("point with a dot", "eye = [0, 0, 0.5]", '"e.ye" = [0, 0, 0.5]', "18:21", "must not contain a dot",
         also=[("scene.toml:22:23", '"clump" has no "eye"')]),
    body("point named origin", "foot = [0.1, 0, -0.5]", "foot = [0.1, 0, -0.5], origin = [0, 0, 0]", "18:63", "is a name that every body has"),
    body("points as a list", POINTS, "points = [[0, 0, 0.5]]", "18:10", "bodies.clump.points is an array of 1; a table",
         also=[("scene.toml:22:23", '"clump" has no "eye"'), ("scene.toml:25:11", '"clump" has no "foot"')]),
    body("side of neither", "points = {", 'side = "left"\npoints = {', "18:8", '= "left" is not one of "starboard", "port"'),
    body("turned by a length", "points = {", 'turned = { heel = "3 m" }\npoints = {', "18:19", "turned.heel"),
    body("turned by several turns", "points = {", "turned = { heel = 12 }\npoints = {", "18:19", "outside [-3.15, 3.15]"),
    body("turned by an angle of no name", "points = {", "turned = { pitch = 1 }\npoints = {", "18:12", 'unknown key "pitch" in bodies.clump.turned'),
    body("turns about an axis of its own", "points = {", 'turns = "about heel"\npoints = {', "18:9", '= "about heel" is not one of "freely", "about x", "about y"'),
    body("turns about y, turned about x", "points = {", 'turned = { heel = "5 deg" }\nturns = "about y"\npoints = {', "19:9",
         "turns the body about another axis at the start"),
    body("outline of two corners", "points = {", "outline = [[0, 0, 0], [1, 0, 0]]\npoints = {", "18:11", "has 2 rows; at least 3"),
    body("negative mass", '"800 kg"', '"-800 kg"', "19:17", "-800 kg is outside [0, 1e9] kg"),
    body("mass of a length", '"800 kg"', '"800 m"', "19:17", "body.mass"),
    body("misspelt parameter", "volume", "volumne", "19:27", 'unknown key "volumne"', 'did you mean "volume"?'),
    body("no such point", "clump.eye", "clump.eey", "22:23", '"clump" has no "eey"', 'did you mean "clump.eye"?'),
    body("a point held", 'on = "warp.start"', 'on = ["warp.start", "clump.foot"]', "28:21", 'holds a point of the body "clump"', "clump.origin"),
    body("a body held", 'on = "warp.start"', 'on = ["warp.start", "clump"]', "28:21", 'holds a point of the body "clump"', 'turns = "not"'),
    body("joined to itself", 'points = ["clump.foot", "tail.start"]', 'points = ["clump.foot", "clump.eye"]', "15:1",
         '"clump.foot" is joined to a point of its own body', "put a short rope between them"),
    body("attitude of a point", 'of = "clump", take = "heel"', 'of = "clump.eye", take = "heel"', "31:35", "cannot be taken", "whole part"),
    body("attitude of a rope", 'of = "clump", take = "heel"', 'of = "tail", take = "heel"', "31:30", "cannot be taken"),
    body("a misspelt angle", 'take = "heel"', 'take = "heal"', "31:31", "cannot be taken", 'did you mean "heel"?'),
    beside("element on no body", '[parts.more]\ntype = "body/solid"\non = "tail"\n', "34:6", '"tail" is no rigid body', "[bodies]"),
    beside("element on a point of a body", '[parts.more]\ntype = "body/solid"\non = "clump.eye"\n', "34:6", '"clump.eye" is no rigid body'),
    beside("force of a body on a rope", '[parts.more]\ntype = "force/body"\non = "tail"\n', "34:6", '"tail" is no rigid body or point of one', "[bodies]"),
    beside("force at no point", '[parts.more]\ntype = "force/body"\non = "clump.fot"\n', "34:6", '"clump" has no "fot"', 'did you mean "clump.foot"?'),
    beside("force on no body", '[parts.more]\ntype = "force/body"\nat = [0, 0, 0]\n', "33:8", "force/body needs a rigid body", "[bodies.more]"),
    beside("force of a mass", '[parts.more]\ntype = "force/body"\non = "clump"\nforce = { x = "3 kg" }\n', "35:15", "force.x"),
    beside("motion of a body without inertia", IN_MOTION, "15:1",
           'the body "clump" has no moment of inertia about some axis, so that a force on it would accelerate it without bound; these keys give it: body.inertia_x, '),
    body("motion of a body with inertia about two axes", "volume = 0.1 }", "volume = 0.1, inertia_x = 20, inertia_y = 20 }" , "15:1",
         "these keys give it: body.inertia_z, body.turning_x", args=IN_MOTION_BY_SET),
    body("motion of a body without mass", 'mass = "800 kg", volume = 0.1', "drag_x = 1", "15:1",
         'the body "clump" has no mass', args=IN_MOTION_BY_SET),
    beside("a body named as a part", '[bodies.tail]\ntype = "body/solid"\nat = [0, 0, 0]\n', "32:1", 'there is a part named "tail" already'),
    beside("two bodies at one point", '[bodies.more]\ntype = "body/solid"\nat = [0, 0, -6]\npoints = { top = [0, 0, 0] }\n[[join]]\npoints = ["more.top", "clump.foot"]\n',
           "32:1", '"more.top" is joined to a point of the body "clump"', "put a short rope between them"),
    beside("origin at a point of another body", '[bodies.more]\ntype = "body/solid"\nat = [0, 0, -6]\n[[join]]\npoints = ["more.origin", "clump.foot"]\n',
           "32:1", '"more.origin" is joined to a point of the body "clump"', "put a short rope between them"),
    beside("two points for a triangle", '[parts.more]\ntype = "catch/front"\non = ["warp.end", "tail.end"]\ncatch = { pressure = 1 }\n', "34:6",
           '"warp.end" is no whole part that catch/front can use', also=[("scene.toml:34:6", '"tail.end" is no whole part')]),
    beside("points beside a part", '[parts.more]\ntype = "catch/front"\non = ["warp.end", "tail.end", "warp"]\ncatch = { pressure = 1 }\n', "34:6",
           '"warp" is no whole part that catch/front can use'),
]
