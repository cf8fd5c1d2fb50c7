# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in scenes, with the place and words of the message (wrong_case.py)."""
from program import GOOD, changed
from wrong_case import Wrong, edit, set_to

HOLD = 'on = "net.fore"'
JOIN = 'points = ["net.aft", "rope"]'
TAKE = 'take = "min z"'

KEYS = [
    edit("missing key", 'length = "3 m"\n', "", "12:1", 'missing key "length" in parts.rope'),
    edit("missing type", 'type = "rope/bar"\n', "", "12:1", 'missing key "type" in parts.rope'),
    edit("unknown key", "EA = \"10 kN\"", "EA = \"10 kN\", colour = 3", "10:45", 'unknown key "colour" in parts.net.twine',
         'allowed here: "EA", "EA_compression", "diameter"'),
    edit("misspelt key", "tolerance", "tolerence", "27:1", 'unknown key "tolerence" in analysis', 'did you mean "tolerance"?'),
    edit("misspelt required key", "diameter", "diametre", "10:11", 'unknown key "diametre"', 'did you mean "diameter"?',
         also=[("scene.toml:10:9", 'missing key "diameter" in parts.net.twine')]),
    edit("misspelt table", "[water]", "[watre]", "1:2", 'unknown key "watre"', 'did you mean "water"?'),
    edit("wrong type", "gravity = 9.81", "gravity = true", "3:11", "water.gravity is the boolean true; an acceleration in m/s2",
         "a text such as"),
    edit("motion that nobody asked for", "tolerance = 1e-10", "tolerance = 1e-10\nduration = 5", "28:12",
         "analysis.duration: has no effect on an equilibrium", 'kind = "dynamic"'),
    edit("motion that ends before it begins", "tolerance = 1e-10", 'tolerance = 1e-10\nkind = "dynamic"\nduration = -1', "29:12",
         "analysis.duration = -1 s is outside [1e-9, 1e9] s"),
    edit("steps that may not be", "tolerance = 1e-10", 'kind = "dynamic"\nduration = 1\nshortest_step = 0.1\nlongest_step = 0.01', "29:17",
         "analysis.shortest_step: is longer than longest_step"),
    edit("first step that may not be", "tolerance = 1e-10", 'kind = "dynamic"\nduration = 1\nstep = 1e-3\nshortest_step = 1e-2', "29:8",
         "analysis.step: is shorter than shortest_step", "step = 0"),
    edit("step that may not be", "tolerance = 1e-10", 'kind = "dynamic"\nduration = 1\nstep = 0.1\nlongest_step = 0.01', "29:8",
         "analysis.step: is longer than longest_step", "adaptive = false"),
    edit("text for integers", "cells = [4, 4]", 'cells = "many"', "8:9", "an array of integers is expected"),
    edit("real for an integer", "cells = 4", "cells = 4.5", "15:9", "parts.rope.cells is the number 4.5; an integer"),
    edit("number for a text", 'type = "rope/bar"', "type = 3", "13:8", "parts.rope.type is the integer 3; a text is expected"),
    edit("hold is no array of tables", "[[hold]]", "[hold]", "22:1", "hold is a table; an array of tables", "[[hold]]"),
    edit("part is no table", "[parts.net]", "[parts]\nfloat = 3\n[parts.net]", "6:9", "parts.float: a part is a table"),
    edit("result is no table", '{ of = "net", take = "min z" }', '"min z"', "30:12", "results.lowest_z is the text"),
    Wrong("parts is no table", "scene.toml:1:9", "parts is an array of 1; a table is expected", content="parts = [1]\n"),
    Wrong("no parts", "scene.toml:1:1", 'missing key "parts"', content="[water]\n"),
    edit("points of a plan", "[[join]]", "[points.tip]\nat = [0, 0, 0]\n[[join]]", "19:1", "points: belongs to a net plan, and this scene has none",
         "[[hold]] at = [0, 0, -5]"),
    edit("ropes of a plan", "[[join]]", '[ropes.line]\nlength = "3 m"\n[[join]]', "19:1", "ropes: belongs to a net plan", 'type = "rope/bar"'),
    edit("floats of a plan", "[[join]]", '[floats.ball]\nspread = "2 along rope"\n[[join]]', "19:1", "floats: belongs to a net plan", "float/float"),
    edit("nodes of a plan", "[[join]]", "[gear]\nnodes = 100\n[[join]]", "19:1", "gear: belongs to a net plan", "cells of a part"),
    edit("elements of a plan", "[[join]]", "[elements.netting]\n[[join]]", "19:1", "elements: belongs to a net plan", "[parts.NAME]"),
    edit("hanging of a plan", "[[join]]", '[[hang]]\nedge = "net.fore"\n[[join]]', "19:1", "hang: belongs to a net plan", "[[join]]"),
    edit("misspelt panels of a plan", "[[join]]", "[panles.net]\n[[join]]", "19:2", 'unknown key "panles"', 'did you mean "panels"?'),
    Wrong("parts without a part", "scene.toml:1:1", "there are no parts", content="[parts]\n"),
    edit("tow without a speed", "[water]", "[tow]\nleeway = 0.1\n[water]", "1:1", 'missing key "speed" in tow'),
    edit("tow backwards", "[water]", '[tow]\nspeed = "-3 kn"\n[water]', "2:9", "tow.speed = -1.5433333333333334 m/s is outside [0, 50] m/s"),
    edit("tow in tons", "[water]", '[tow]\nspeed = "3 t"\n[water]', "2:9", "tow.speed"),
    edit("tow: a misspelt key", "[water]", '[tow]\nspeed = 1\nleway = 1\n[water]', "3:1", 'unknown key "leway" in tow',
         'did you mean "leeway"?'),
    edit("tow is no table", "[water]", "tow = 1.5\n[water]", "1:7", "tow is the number 1.5; a table is expected"),
    edit("duplicate key", "gravity = 9.81", "gravity = 9.81\ngravity = 9.8", "4:11", "cannot redefine existing"),
]

UNITS = [
    edit("wrong unit", '"0.6 m"', '"0.6 kg"', "7:40", "is a mass (kg); a length (m) is expected"),
    edit("unknown unit", '"0.6 m"', '"0.6 smoots"', "7:40", 'unit "smoots" in "0.6 smoots" is not known'),
    edit("wrong dimension", '"10 kN"', '"10 kN/m"', "10:36", "is a stiffness (N/m); a force (N) is expected"),
    edit("unit without quotes", '"0.6 m"', "0.6 m", "7:44", "cannot read the inline table", "in quotes"),
]

RANGES = [
    edit("out of range", '"10 kN"', '"-5 N"', "10:36", "parts.net.twine.EA = -5 N is outside [0, 1e12] N"),
    edit("NaN", "density = 2000", "density = nan", "10:55", "is not a finite number"),
    edit("infinity", "density = 2000", "density = inf", "10:55", "is not a finite number"),
    edit("NaN with a unit", "density = 2000", 'density = "nan kg/m3"', "10:55", "is not a finite number"),
    edit("no meshes", "across = 4", "across = 0", "7:20", "parts.net.panel.across = 0 is outside (0, 1e6]"),
    edit("hardly a mesh", "across = 4", "across = 1e-300", "5:1", "holds no netting"),
    edit("no cells", "cells = [4, 4]", "cells = [0, 4]", "8:10", "parts.net.cells[0] = 0 is outside [1, 100000]"),
    Wrong("cells that bars along the twines do not fit", "scene.toml:8:9", "makes cells of 1 x 2 meshes", "cells = [3, 3]",
          change=[('"priour/triangle"', '"lumped/net"'), ("cells = [4, 4]", "cells = [4, 2]")]),
    edit("a rope of no bars", "cells = 4\n", "cells = 0\n", "15:9", "parts.rope.cells = 0 is outside"),
    edit("three cells", "cells = [4, 4]", "cells = [4, 4, 4]", "8:9", "has 3 values; 2 are expected"),
    edit("tolerance of zero", "tolerance = 1e-10", "tolerance = 0", "27:13", "analysis.tolerance = 0 is outside"),
    edit("analysis nobody offers", "tolerance", 'kind = "modal"\ntolerance', "27:8", 'is not one of "static"'),
    edit("absurd cells", "cells = [4, 4]", "cells = [1000000000, 4]", "8:10", "is outside [1, 100000]"),
    edit("too many triangles", "cells = [4, 4]", "cells = [100000, 100000]", "8:9", "makes 20000000000 triangles"),
    edit("more than 64 bits", "cells = 4\n", "cells = 100000000000000000000\n", "15:30", "not representable in 64 bits"),
    edit("absurd density", "density = 2000", "density = 1e300", "10:55", "1e300 kg/m3 is outside [0, 1e6]"),
    edit("absurd sketch", "[[-2, 0, 0]", "[[-1e300, 0, 0]", "9:12", "parts.net.sketch[0][0] = -1e300 m is outside"),
]

NAMES = [
    edit("hold: no such part", HOLD, 'on = "ent.fore"', "23:6", 'there is no part "ent"', 'did you mean "net"?'),
    edit("hold: no such edge", HOLD, 'on = "net.headline"', "23:6", '"net" has no "headline"', "fore-left, fore-right"),
    edit("hold: an edge without its part", HOLD, 'on = "fore"', "23:6", 'there is no part "fore"', 'did you mean "net.fore"?'),
    edit("hold: no such node", HOLD, 'on = "net.node-25"', "23:6", '"net" has no "node-25"', "node-0 to node-24"),
    edit("hold: negative node", HOLD, 'on = "net.node--1"', "23:6", '"net" has no "node--1"', "node-0 to node-24"),
    edit("hold: nothing", HOLD, 'on = ""', "23:6", "hold[0].on is empty"),
    Wrong("hold: a middle between bars", "scene.toml:21:6", '"rope" has no "middle"', "only if its number of cells is even",
          change=[("cells = 4\n", "cells = 3\n"), ("[[join]]\n" + JOIN + "\n", ""), (HOLD, 'on = "rope.middle"')]),
    edit("hold: a name twice", HOLD, HOLD + "\n[[hold]]\n" + HOLD, "25:6",
         'a hold named "net.fore" already, at scene.toml:23:6', "name ="),
    edit("join: no such part", JOIN, 'points = ["net.aft", "roop"]', "20:22", 'there is no part "roop"', "net, rope"),
    edit("join: no such end", JOIN, 'points = ["net.aft", "rope.stop"]', "20:22", '"rope" has no "stop"', "start"),
    edit("results: no such part", 'of = "net"', 'of = "nett"', "30:19", 'there is no part "nett"', 'did you mean "net"?'),
    edit("results: no such edge", 'of = "net"', 'of = "net.aftt"', "30:19", '"net" has no "aftt"', 'did you mean "net.aft"?'),
    edit("a dot in a part's name", '[[join]]', '[parts."ro.pe"]\ntype = "rope/bar"\n[[join]]', "19:1", '"ro.pe", must not contain a dot',
         also=[("scene.toml:19:1", f'missing key "{key}"') for key in ("length", "cells", "sketch", "rope")]),
    edit("a slash in a result's name", "lowest_z", '"lowest/z"', "30:14", "must not contain a slash"),
    edit("a result without a name", "lowest_z", '""', "30:6", 'the name of a result, "", must not be empty'),
    edit("a result named like a folder", "lowest_z", '"."', "30:7", "must not be made of dots only"),
]

HOLDS = [
    edit("nothing is held", "[[hold]]\n" + HOLD + "\n", "", "5:1", 'connected to nothing that is held: it would drift away; add a [[hold]] on "net"'),
    edit("held along one axis", HOLD, HOLD + '\naxes = "x"', "5:1", "connected to nothing that is held along y, z"),
    edit("a rope joined to nothing", "[[join]]\n" + JOIN + "\n", "", "12:1", "rope node 0 is connected to nothing that is held"),
    edit("axes on nodes that stay in a plane", HOLD, 'on = "net.left"\nplane = [1, 1, 0]\n[[hold]]\non = "net.fore"\naxes = "xz"', "26:6",
         'a node of "net.fore" is held in another way already', "leave it out of one"),
    edit("at beside plane", HOLD, HOLD + "\nplane = [1, 0, 0]\nat = [0, 0, 0]", "25:6", "hold[0].at: cannot be combined with along or plane", "sketch"),
    edit("axes beside along", HOLD, HOLD + '\nalong = [1, 0, 0]\naxes = "x"', "24:9", "give only one of along, plane and axes"),
    edit("along nothing", HOLD, HOLD + "\nalong = [0, 0, 0]", "24:9", "has no direction"),
    edit("axes: no axis", HOLD, HOLD + '\naxes = "w"', "24:8", '"w" is not made of the letters x, y and z'),
    edit("axes: none", HOLD, HOLD + '\naxes = ""', "24:8", "hold[0].axes: holds nothing", "leave the key out"),
    edit("axes: a number", HOLD, HOLD + "\naxes = 3", "24:8", "hold[0].axes is the integer 3; a text is expected"),
    edit("at: many nodes in a point", HOLD, HOLD + "\nat = [0, 0, 0]", "24:6", "5 nodes cannot be held in one point", "two or more"),
    edit("at: many nodes on a line of no length", HOLD, HOLD + "\nat = [[1, 0, 0], [1, 0, 0]]", "24:6", "5 nodes cannot be held in one"),
    edit("at: a word", HOLD, HOLD + '\nat = "sketh"', "24:6", 'is not one of "sketch"', 'did you mean "sketch"?'),
    edit("at: two coordinates", HOLD, HOLD + "\nat = [1, 2]", "24:6", "hold[0].at has 2 values; 3 are expected"),
    edit("at: no points", HOLD, HOLD + "\nat = []", "24:6", "hold[0].at has 0 rows; at least 1"),
    edit("at: NaN", HOLD, HOLD + "\nat = [[0, 0, nan], [1, 1, 1]]", "24:14", "is not a finite number"),
    edit("a corner held at two places", HOLD,
         HOLD + '\nat = [[-1, 0, 0], [1, 0, 0]]\n[[hold]]\non = "net.left"\nat = [[5, 0, 0], [-1, 0, -4]]', "27:6",
         "net node 0 is held at (5, 0, 0) m here and at (-1, 0, 0) m by scene.toml:24:6", "the same place"),
]

JOINS = [
    edit("join: many to one", JOIN, 'points = ["net.aft", "rope.start"]', "20:10",
         '"net.aft" has 5 nodes, "rope.start" has 1', "the same cells"),
    edit("join: one alone", JOIN, 'points = ["net.aft"]', "20:10", "has 1 value; at least 2 are expected"),
    edit("join: a point to itself", JOIN, JOIN + '\n[[join]]\npoints = ["rope.start", "rope.start"]', "22:10",
         '"rope.start" is joined to itself'),
    edit("join: both ends of a bar", "[[join]]\n" + JOIN, '[[join]]\npoints = ["rope.start", "net.aft-left"]\n'
         '[[join]]\npoints = ["rope.node-1", "net.aft-left"]', "22:10", '"rope" element 0 would have two of its corners in one'),
    Wrong("join: a tube one cell wide", "scene.toml:20:10", '"net" element 0 would have two of its corners in one node', "more cells",
          change=[("cells = [4, 4]", "cells = [1, 4]"), (JOIN, 'points = ["net.left", "net.right"]')]),
    edit("join: a rope gathered in a point", JOIN, 'points = ["rope"]\ntogether = true', "20:10",
         '"rope" element 0 would have two of its corners in one'),
    edit("join: together is no word", JOIN, JOIN + '\ntogether = "yes"', "21:12", "join[0].together is the text"),
]

TUBE = "tube = { from = [0, 0, 0], to = [0, 0, -4], radius = 1 }"
TUBES = [
    edit("tube: beside a sketch", "[parts.rope]", TUBE + "\n[parts.rope]", "12:8", "is given beside sketch", "leave one of them out"),
    edit("tube: of no length", "sketch = [[-2, 0, 0], [2, 0, 0], [2, 0, -4], [-2, 0, -4]]", TUBE.replace("-4", "0"), "9:33",
         "is where the tube begins"),
    edit("tube: radius below nothing", "sketch = [[-2, 0, 0], [2, 0, 0], [2, 0, -4], [-2, 0, -4]]", TUBE.replace("= 1", "= -1"), "9:54",
         "parts.net.tube.radius = -1 m is outside"),
]

RESULTS = [
    edit("take: no such quantity", TAKE, 'take = "max stress"', "30:33", '"stress" cannot be taken of "net"', "tension"),
    edit("take: a slip", TAKE, 'take = "max tensoin"', "30:33", '"tensoin" cannot be taken of', 'did you mean "max tension"?'),
    edit("take: a longer word", TAKE, 'take = "minimum z"', "30:33", '"minimum z" cannot be taken of', 'did you mean "min z"?'),
    edit("take: of many, but not which", TAKE, 'take = "z"', "30:33", '"net" has many values; say which', '"min z"'),
    edit("take: tension of an edge", 'of = "net", take = "min z"', 'of = "net.aft", take = "max tension"', "30:37",
         '"tension" cannot be taken of "net.aft"', 'of the whole part, of = "net"'),
    edit("take: nothing", TAKE, 'take = ""', "30:33", "results.lowest_z.take: is empty"),
    edit("take: a reaction where nothing is held", 'of = "net", take = "min z"', 'of = "rope", take = "sum reaction z"', "30:34",
         'nothing of "rope" is held', "[[hold]]"),
]

FILES = [
    Wrong("empty file", "", "scene.toml is empty", content=""),
    Wrong("binary file", "", "scene.toml is a binary file", content=bytes(range(256)) * 4),
    Wrong("not UTF-8", "", "is not UTF-8 text: line 1", content=("# Hänger\n" + GOOD).encode("latin-1")),
    edit("syntax error", "[water]", "[water", "1:7", "cannot read the table header: expected ']'"),
    edit("nested 10 000 deep", "gravity = 9.81", "gravity = " + "[" * 10000 + "]" * 10000, "3:267", "nested value depth"),
    edit("a name of 200 kB", HOLD, f'on = "{"a" * 200000}"', "23:6", 'there is no part "aaaa', "net, rope"),
    Wrong("include: a cycle", "b.toml:1:12", "include cycle: scene.toml -> b.toml -> scene.toml",
          change=[("[water]", 'include = ["b.toml"]\n[water]')], files={"b.toml": 'include = ["scene.toml"]\n'}),
    edit("include: no such file", "[water]", 'include = ["b.toml"]\n[water]', "1:12", "b.toml cannot be opened: No such file"),
    edit("include: a text", "[water]", 'include = "b.toml"\n[water]', "1:11", "include is not an array", 'include = ["'),
    edit("include: a binary file", "[water]", 'include = ["b.toml"]\n[water]', "1:12", "b.toml is a binary file",
         files={"b.toml": b"\x7fELF\0\1"}),
    edit("include: a folder", "[water]", 'include = ["."]\n[water]', "1:12", "is a directory"),
    Wrong("an error in an included file", "b.toml:2:18", "analysis.max_iterations = -1 is outside",
          change=[("[water]", 'include = ["b.toml"]\n[water]')], files={"b.toml": "[analysis]\nmax_iterations = -1\n"}),
]

PLUGINS = [
    edit("misspelt plugin", "priour/triangle", "priur/triangle", "6:8", 'there is no plugin "priur"; did you mean "priour"?', "tried", code=4),
    edit("unknown plugin", "priour/triangle", "otter/board", "6:8", 'there is no plugin "otter"', "otter.so", code=4),
    edit("unknown element", "priour/triangle", "priour/quad", "6:8", 'has no element "priour/quad"; there is: priour/triangle', code=4),
    edit("type without a plugin", "priour/triangle", "triangle", "6:8", "a type is written plugin/element"),
    edit("type with a path", "priour/triangle", "../../bin/sh", "6:8", 'there is no plugin ".."', code=4),
    edit("a solver as element", "priour/triangle", "newton/newton", "6:8", '"newton/newton" is a solver, and no element'),
    edit("an element as strategy", 'solver = "newton"', 'strategy = "rope/bar"', "26:12", '"rope/bar" is an element, and no strategy'),
    edit("empty type", "priour/triangle", "", "6:8", "parts.net.type: is empty"),
    edit("unknown solver", '"newton"', '"newtn"', "26:10", 'there is no plugin "newtn"; did you mean "newton"?', code=4),
    edit("unknown integrator", "tolerance = 1e-10", 'kind = "dynamic"\nintegrator = "Newmark"', "28:14", 'analysis.integrator: there is no plugin "Newmark"; did you mean "newmark"?',
         code=4),
    edit("an element as solver", '"newton"', '"rope"', "26:10", 'the plugin "rope" has no solver'),
    edit("empty solver", '"newton"', '""', "26:10", "analysis.solver: is empty"),
    edit("solver parameter out of range", "tolerance", "newton = { damping = -1 }\ntolerance", "27:22",
         "analysis.newton.damping = -1 is outside [0, 64]"),
    edit("unknown solver parameter", "tolerance", "newton = { dampng = 1 }\ntolerance", "27:12",
         'unknown key "dampng" in analysis.newton', 'did you mean "damping"?'),
    edit("a choice that is none", "tolerance", 'newton = { method = "clasic" }\ntolerance', "27:21",
         'is not one of "globalised", "classic"', 'did you mean "classic"?'),
]

OPTIONS = [
    set_to("set: unknown key", "parts.net.cell=[4,4]", 'unknown key "cell" in parts.net', 'did you mean "cells"?'),
    set_to("set: unknown part", "parts.nett.cells=[4,4]", "parts.nett.type: is missing", 'did you mean the part "net"?'),
    set_to("set: through an array", "parts.net.cells.x=4", "parts.net.cells is not a table", "set the whole array"),
    set_to("set: through a number", "water.density.x=4", "water.density is not a table"),
    set_to("set: out of range", "water.density=-4", "water.density = -4 kg/m3 is outside [0, 3000] kg/m3"),
    set_to("set: no equals sign", "parts.net.cells", "there is no '=' in parts.net.cells", "--set parts.net.cells=[64,64]"),
    Wrong("set: no path", "--set", '"" is not a path of dotted keys', args=["--set", "=4"]),
    Wrong("solver option: a wrong word", "--set analysis.newton.method", 'is not one of "globalised", "classic"',
          'did you mean "classic"?', args=["--solver", "newton:method=clasic"]),
    Wrong("solver option: no equals sign", "", '"method" is not key=value', args=["--solver", "newton:method"]),
    Wrong("solver option: no name", "", '"" is no name of a solver', args=["--solver", ":method=classic"]),
    Wrong("solver option: no pair", "", "nothing follows the colon", args=["--solver", "newton:"]),
    Wrong("solver option: nothing", "", "--solver: must not be empty", args=["--solver", ""]),
    Wrong("set: a value, and then its table", "", "--set water={} undoes --set water.density=1000", args=["--set", "water.density=1000", "--set", "water={}"]),
    Wrong("solver option: set as well", "", "--solver newton undoes --set analysis.solver=ptc", args=["--set", "analysis.solver=ptc", "--solver", "newton"]),
    Wrong("strategy option: set as well", "", "--strategy direct undoes --set analysis.strategy=auto", args=["--strategy", "direct", "--set", "analysis.strategy=auto"]),
    Wrong("solver option: a parameter that is set as well", "", "--solver newton:damping=1 undoes --set analysis.newton.damping=2",
          args=["--solver", "newton:damping=1", "--set", "analysis.newton.damping=2"]),
    Wrong("strategy of a motion from its sketch", "", "--strategy finds equilibria, and this motion does not begin at an equilibrium", change=[("tolerance = 1e-10", 'kind = "dynamic"\nduration = 1')],
          args=["--strategy", "direct"]),
    Wrong("option nobody knows", "", "--frobnicate", args=["--frobnicate"]),
    Wrong("no thread at all", "", "--threads: Value 0 not in range", args=["--threads", "0"]),
    Wrong("plugin folder that is none", "", "is no folder", args=["--plugins", "nowhere"]),
    Wrong("the result over the scene", "", "the scene is read from it", args=["-o", "scene.toml"]),
]

RIDER = ('[[join]]', '[parts.more]\ntype = "rope/bar"\non = "rope"\n'
         'rope = { diameter = 0.01, EA = 1e3, density = 1e3 }\n[[join]]')


def rider(name, old, new, where, says, hint="", **more):
    return Wrong(name, "scene.toml:" + where, says, hint, change=[RIDER, (old, new)], **more)


OWN = '"more" uses nodes of other parts and has none of its own'
RIDERS = [
    rider("on: no such part", 'on = "rope"', 'on = "rpoe"', "21:6", 'there is no part "rpoe"', 'did you mean "rope"?'),
    rider("on: a number", 'on = "rope"', "on = 3", "21:6", "parts.more.on is the integer 3"),
    rider("on: nothing", 'on = "rope"', "on = []", "21:6", "has 0 values; at least 1 is expected"),
    rider("on: another kind of part", 'on = "rope"', 'on = "net"', "21:6", '"net" is no whole part that rope/bar can use'),
    rider("on: an edge of netting", 'on = "rope"', 'on = "net.aft"', "21:6", '"net.aft" is no whole part that rope/bar'),
    rider("on: a part twice", 'on = "rope"', 'on = ["rope", "rope"]', "21:15", '"rope" is named twice'),
    rider("on: itself", 'on = "rope"', 'on = "more"', "21:6", OWN),
    rider("a part on others in a join", JOIN, 'points = ["net.aft", "more"]', "24:22", OWN, "name the parts in its `on`"),
    rider("a part on others in a hold", HOLD, 'on = "more"', "27:6", OWN),
    rider("an end of a part on others", HOLD, 'on = "more.start"', "27:6", OWN),
    rider("heights of a part on others", 'of = "net"', 'of = "more"', "34:34", OWN),
]

CURRENTS = [
    edit("current: " + name, "gravity = 9.81", f"current = {current}", place, says)
    for name, current, place, says in (
        ("a number", "1.5", "3:11", "an array of values in m/s is expected"),
        ("two components", "[1, 0]", "3:11", "water.current has 2 values; 3 are expected"),
        ("a mass", '["1 kg", 0, 0]', "3:12", "is a mass (kg); a speed (m/s) is expected"),
        ("NaN", "[nan, 0, 0]", "3:12", "is not a finite number"),
        ("no heights", "{ x = [1] }", "3:11", 'missing key "z" in water.current'),
        ("a column too short", "{ z = [0, -5], x = [1] }", "3:30", "water.current.x has 1 value; 2 are expected"),
        ("a height twice", "{ z = [0, 0], x = [1, 2] }", "3:17", "has the same height twice"),
        ("times that go back", "{ t = [1, 0], x = [1, 2] }", "3:17", "does not ascend"),
        ("heights without a velocity", "{ z = [0, -5] }", "3:11", "has no x, y or up, so that the water would be still"),
        ("a velocity of another name", "{ z = [0, -5], vx = [1, 1] }", "3:26", 'unknown key "vx" in water.current'),
        ("times without a velocity", "{ t = [0, 5] }", "3:11", "has no x, y or up"),
        ("an empty unit", '{ unit = "", values = [1, 0, 0] }', "3:20", "water.current.unit: is empty"),
        ("too fast in its unit", '{ unit = "kn", values = [100, 0, 0] }', "3:36", "values[0] = 100 kn = 51.4444 m/s is outside [-50, 50] m/s"),
        ("a unit like that of a pressure", '["0.9 mps", 0, 0]', "3:12", 'unit "mps" in "0.9 mps" is not known'),
    )
]

GUIDES = [
    edit("velocity: times that go back", HOLD, HOLD + "\nvelocity = { t = [1, 0], x = [1, 2] }", "24:18", "does not ascend"),
    edit("velocity: a column too short", HOLD, HOLD + "\nvelocity = { t = [0, 1], x = [1] }", "24:30",
         "has 1 value; 2 are expected"),
    edit("velocity of nothing", HOLD, HOLD + "\nvelocity = { t = [0, 1] }", "24:12", "has no x, y or z, so that nothing would move"),
    Wrong("velocity of another name", "scene.toml:24:26", 'unknown key "up" in hold[0].velocity',
          change=[(HOLD, HOLD + "\nvelocity = { t = [0, 1], up = [0, 1] }"), ("tolerance = 1e-10", 'kind = "dynamic"\nduration = 1')]),
    edit("displacement of nothing", HOLD, HOLD + "\ndisplacement = { t = [0, 1] }", "24:16", "has no x, y or z"),
    edit("velocity and displacement", HOLD, HOLD + "\nvelocity = { t = [0] }\ndisplacement = { t = [0] }", "24:12",
         "is given beside displacement"),
]

BED = '[parts.bed]\ntype = "seabed/plane"\non = "rope"\nseabed = { depth = 5 }\n'
NOTHING = [
    edit("an axis twice", HOLD, HOLD + '\naxes = "xyx"', "24:8", "hold[0].axes: names x twice"),
    edit("an angle that nothing holds", 'EA = "10 kN", ', 'EA = "10 kN", opening_angle = 0.3, ', "10:9",
         "opening_angle has no effect", "EI or opening_stiffness"),
    edit("velocity where nothing moves", HOLD, HOLD + "\nvelocity = { t = [0, 1], x = [0, 1] }", "24:12",
         "nothing moves in a static analysis", 'kind = "dynamic"'),
    edit("displacement where nothing moves", HOLD, HOLD + "\ndisplacement = { t = [0, 1], x = [0, 1] }", "24:16",
         "nothing moves in a static analysis", 'kind = "dynamic"'),
    edit("a float of nothing", "[[join]]", '[parts.ball]\ntype = "float/float"\non = "rope.end"\nfloat = {}\n[[join]]', "22:9",
         "parts.ball.float: is an empty table, which says nothing"),
    edit("twine as thick as its bar", 'diameter = "10 mm"', 'diameter = "0.6 m"', "10:9",
         "diameter = 0.6 m, and bars of 0.6 m: no mesh can open"),
    Wrong("twine as thick as its bar, lumped", "scene.toml:10:9", "and bars of 0.6 m: no mesh can open",
          change=[('"priour/triangle"', '"lumped/net"'), ('diameter = "10 mm"', 'diameter = "0.7 m"')]),
    edit("a rope as thick as it is long", 'diameter = "20 mm"', 'diameter = "3 m"', "17:8",
         "diameter = 3 m, and a length of 3 m"),
    edit("a bed above the gear", "[[join]]", BED.replace("5", "-0.5") + "[[join]]", "19:1",
         "bed: the whole gear is below this bed, by 0.5 m or more", "which counts downwards"),
    edit("two beds under one rope", "[[join]]", BED + BED.replace("parts.bed", "parts.sand") + "[[join]]", "23:1",
         "sand and bed at scene.toml:19:1 carry the same nodes", "one bed"),
    edit("a catalogue folder that is not there", "[water]", 'catalogue = ["nowhere"]\n[water]', "1:13", "there is no folder"),
    edit("a catalogue folder that is a file", "[water]", 'catalogue = ["scene.toml"]\n[water]', "1:13", "is no folder"),
    Wrong("a catalogue folder of a plan that is not there", "scene.toml:1:13", "there is no folder",
          content='catalogue = ["nowhere"]\n[panels.net]\nmesh = "80 mm"\ntwine = { diameter = "2 mm", EA = 1e3, density = 960 }\n'
                  'fore = 20\ndepth = 20\nsides = "AN"\n'),
]

SEVERAL = [
    Wrong("several at once", "scene.toml:3:11", 'water.gravity: "9.81 m" is a length',
          change=[("gravity = 9.81", 'gravity = "9.81 m"'), ('bar = "0.6 m"', "bar = -1"), ('length = "3 m"\n', ""),
                  (HOLD, 'on = "net.four"'), (TAKE, 'take = "min q"')],
          also=[("scene.toml:7:40", "parts.net.panel.bar = -1 m is outside"),
                ("scene.toml:12:1", 'missing key "length"'),
                ("scene.toml:22:6", '"net" has no "four"'),
                ("scene.toml:29:33", '"q" cannot be taken of')]),
]

ALL = KEYS + UNITS + RANGES + NAMES + HOLDS + JOINS + TUBES + RESULTS + FILES + PLUGINS + OPTIONS + RIDERS + CURRENTS + GUIDES + NOTHING + SEVERAL
