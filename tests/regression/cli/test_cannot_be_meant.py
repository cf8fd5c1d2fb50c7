# SPDX-License-Identifier: BSD-3-Clause
"""An implausible scene gets a message with the part and the number, and a hint."""
import re
import unittest
from dataclasses import dataclass

from program import SOURCE, InFreshFolder

ROPE = """\
[water]
current = [0.8, 0, 0]
[parts.rope]
type = "rope/bar"
length = "12 m"
cells = 12
sketch = [[0, 0, -5], [5, 0, -10], [9, 0, -5]]
rope = { diameter = "20 mm", EA = "50 kN", density = 1500 }
[[hold]]
on = "rope.start"
[[hold]]
on = "rope.end"
"""
DYNAMIC = ROPE + '[analysis]\nkind = "dynamic"\nduration = 0.1\n'
NET = ROPE + """\
[parts.net]
type = "priour/triangle"
panel = { across = 24, along = 24, bar = "2 mm" }
cells = [4, 4]
sketch = [[0, -0.02, -4], [0, 0.02, -4], [0, 0.02, -4.05], [0, -0.02, -4.05]]
twine = { diameter = "3 mm", EA = "20 kN", density = 1140 }
[[hold]]
on = "net.fore"
"""
LEVEL = ROPE.replace("-10]", "-5]").replace("[0.8, 0, 0]", "%s").replace('"12 m"', '"9 m"')
FLOAT = '[parts.f]\ntype = "float/float"\non = "rope.end"\nfloat = { %s }\n'
# A bag of two panels behind a beam, lashed to it on both sides.
BEAM = """\
[gear]
nodes = 100
[water]
current = [1, 0, 0]
[panels.top]
mesh = "80 mm"
twine = "pe-braided-3mm"
fore = 50
depth = 30
sides = "AN"
[panels.bottom]
mesh = "80 mm"
twine = "pe-braided-3mm"
fore = 50
depth = 30
sides = "AN"
[[join]]
edges = ["top.sides", "bottom.sides"]
[[join]]
edges = ["top.aft", "bottom.aft"]
[ropes.headline]
stands = "middle"
rope = "combination-3-strand-16mm"
length = "2 m"
[ropes.footrope]
stands = "middle"
rope = "combination-3-strand-16mm"
length = "2 m"
[[hang]]
edge = "top.fore"
on = "headline"
ratio = 0.5
[[hang]]
edge = "bottom.fore"
on = "footrope"
ratio = 0.5
[ropes.lash]
between = ["beam.%s", "footrope.end"]
rope = "short-link-10mm"
length = "0.2 m"
[bodies.beam]
type = "body/solid"
at = [0, 0, -20]
stands = "middle"
points = { %s }
body = { mass = "1200 kg", volume = 0.15, inertia_x = 1600, inertia_y = 60, inertia_z = 1600 }
[[hold]]
on = "beam.origin"
"""


@dataclass
class Meant:
    """`plan` reads a scene without computing it; its messages are those of `run` before anything is computed."""
    name: str
    scene: str
    says: str
    cure: str = ""
    code: int = 0
    command: str = "plan"


def changed(old, new, text=ROPE):
    assert old in text, f"not in the scene: {old}"
    return text.replace(old, new)


def gear(scene, more):
    return f'include = ["{SOURCE}/gear-library/{scene}"]\n{more}'


ALL = [
    Meant("two holds that part", ROPE + '[[hold]]\non = "rope.end"\nname = "b"\nat = [9, 1, -5]\n',
          r"rope node 12 is held at \(9, 1, -5\) m here and at \(9, 0, -5\) m by scene.toml:12:6", "the same place", 2),
    Meant("held where it is sketched and elsewhere before", changed('on = "rope.end"', 'on = "rope.end"\nat = [9, 1, -5]') +
          '[[hold]]\non = "rope.end"\nname = "b"\n', r"held at \(9, 0, -5\) m here and at \(9, 1, -5\) m by scene.toml:13:6", "the same place", 2),
    Meant("two holds of one place", ROPE + '[[hold]]\non = "rope.end"\nname = "b"\nat = [9, 0, -5]\n', r"\A\Z"),
    Meant("hold that stands still and moves", changed('on = "rope.end"', 'on = "rope.end"\nvelocity = { t = [0, 1], x = [0, 1] }', DYNAMIC) +
          '[[hold]]\non = "rope.end"\nname = "b"\n', r"rope node 12 is not moved here, but is moved by scene.toml:12:6", "the same motion", 2),
    Meant("hold that moves and stands still", DYNAMIC + '[[hold]]\non = "rope.end"\nname = "b"\nvelocity = { t = [0, 1], x = [0, 1] }\n',
          r"rope node 12 is moved here, but not moved by scene.toml:12:6", "the same motion", 2),
    Meant("plane beside a place", changed('on = "rope.end"', 'on = "rope.end"\nat = [9, 1, -5]') +
          '[[hold]]\non = "rope.end"\nname = "b"\nplane = [0, 1, 0]\n',
          r"held through \(9, 0, -5\) m here and at \(9, 1, -5\) m by scene.toml:13:6", "the same place", 2),
    Meant("second hold that moves at 100 m/s", changed('on = "rope.start"', 'on = "rope.start"\nvelocity = { t = [0, 1], x = [0, 1] }',
          changed('on = "rope.end"', 'on = "rope.end"\nvelocity = { t = [0, 1], x = [0, 100] }', DYNAMIC)),
          r"scene.toml:14:12: warning: hold\[1\].velocity: the hold moves at 100 m/s", "velocity in m/s"),
    Meant("water in tons", changed("[water]", "[water]\ndensity = 1.025"), r"water.density = 1.025 kg/m3", r'density = "1.025 t/m3"'),
    Meant("water in tons that says so", changed("[water]", '[water]\ndensity = "1.025 t/m3"'), r"\A\Z"),
    Meant("water of mud", changed("[water]", "[water]\ndensity = 2000"), r"water.density = 2000 kg/m3", "sea water is"),
    Meant("air", changed("[water]", "[water]\ndensity = 0"), r"\A\Z"),
    Meant("fresh water", changed("[water]", "[water]\ndensity = 1000"), r"\A\Z"),
    Meant("rope of lead foam", changed("1500", "150000"), r"rope: rope.density = 150000 kg/m3: even a chain", "7850 is steel"),
    Meant("twine of lead foam", changed("1140", "114000", NET.replace('"2 mm"', '"20 mm"')), r"net: twine.density = 114000 kg/m3", "1140 polyamide"),
    Meant("compression stiffer than tension", changed('EA = "50 kN"', 'EA = "50 kN", EA_compression = "500 kN"'),
          r"rope: rope.EA_compression = 500000 N is greater than rope.EA = 50000 N", "EA_compression = 0", 2),
    Meant("as stiff in compression", changed('EA = "50 kN"', 'EA = "50 kN", EA_compression = "50 kN"'), r"\A\Z"),
    Meant("tolerance of one", ROPE + "[analysis]\ntolerance = 1\n", r"analysis.tolerance = 1: a force of up to 100 %", "tolerance = 1e-6"),
    Meant("tow in knots without a unit", changed("current = [0.8, 0, 0]\n", "") + "[tow]\nspeed = 40\n",
          r"tow.speed = 40 m/s, which is 77.8 kn", r'speed = "40 kn"'),
    Meant("current of a jet", changed("0.8, 0, 0", "45, 0, 0"), r"water.current reaches 45 m/s, which is 87.5 kn", '"3 kn"'),
    Meant("hold that moves at 100 m/s", changed('on = "rope.end"', 'on = "rope.end"\nvelocity = { t = [0, 1], x = [0, 100] }', DYNAMIC),
          r"moves at 100 m/s, which is 194 kn", "velocity in m/s"),
    Meant("hold that is displaced by 30 m in a second", changed('on = "rope.end"', 'on = "rope.end"\ndisplacement = { t = [0, 1], x = [0, 30] }', DYNAMIC),
          r"moves at 30 m/s", "displacement in m"),
    Meant("float that lifts more than it displaces", ROPE + FLOAT % "buoyancy = 50, volume = 0.001",
          r"f: float.buoyancy = 50 N is used; float.volume = 0.001 m3 with float.mass = 0 kg would give 10.05 N", "leave buoyancy out"),
    Meant("float whose mass contradicts it", ROPE + FLOAT % "buoyancy = 5, volume = 0.001, mass = 0.9",
          r"would give 1.226 N", "leave buoyancy out"),
    Meant("float whose mass is not known", ROPE + FLOAT % "buoyancy = 5, volume = 0.001", r"\A\Z"),
    Meant("displacement that is a place", changed('on = "rope.end"', 'on = "rope.end"\ndisplacement = { t = [0, 1], z = [-5, -4] }', DYNAMIC),
          r"hold\[1\].displacement: is not zero at t = 0", "counts from where the nodes are held"),
    Meant("twine thicker than its mesh", NET, r"net.twine: diameter = 0.003 m, and bars of 0.002 m: no mesh can open", "another unit", 2),
    Meant("rope as thick as a ship", changed('"20 mm"', '"20 m"'), r"rope.rope.diameter = 20 m is outside \[0, 10\] m", "", 2),
    Meant("bed above the surface", ROPE + "[bed]\ndepth = -20\n", r"bed.depth = -20 m is outside", "", 2),
    Meant("three nodes", gear("scenes/four-panel.toml", "[gear]\nnodes = 3\n"), r"gear.nodes: = 3 is outside", "size", 2),
    Meant("ten million nodes", gear("scenes/four-panel.toml", "[gear]\nnodes = 10000000\n"), r"gear.nodes = 10000000 is outside", "", 2),
    Meant("motion of a year", changed("duration = 0.1", "duration = 3.2e7", DYNAMIC), r"analysis.output_interval: asks for more than a million", "", 2),
    Meant("step over the longest", DYNAMIC + "step = 0.1\nlongest_step = 0.01\n", r"analysis.step: is longer than longest_step", "", 2),
    Meant("shortest step over the longest", DYNAMIC + "shortest_step = 0.1\nlongest_step = 0.01\n", r"analysis.shortest_step: is longer", "", 2),
    Meant("current far below", changed("current = [0.8, 0, 0]", "current = { z = [-500, -100], x = [1.2, 0.4] }"),
          r"water.current: the profile lies below the gear", "z points up"),
    Meant("current over depths", changed("current = [0.8, 0, 0]", "current = { z = [10, 100], x = [1.2, 0.4] }"),
          r"water.current: the profile lies above the gear", "z points up"),
    Meant("current over depths of a gear that reaches the surface",
          changed("[0.8, 0, 0]", "{ z = [0, 100], x = [1.2, 0.4] }").replace("-5]", "0]"),
          r"water.current: the profile lies above the gear", "z points up"),
    Meant("current over depths of a gear that reaches out of the water",
          changed("[0.8, 0, 0]", "{ z = [0, 100], x = [1.2, 0.4] }").replace("[9, 0, -5]", "[9, 0, 1]"),
          r"water.current: the profile lies above the surface .* only its lowest value acts", "z points up"),
    Meant("current to the depth of a level gear", LEVEL % "{ z = [-5, -1], x = [1.2, 0.4] }", r"\A\Z"),
    Meant("current from the height of a level gear", LEVEL % "{ z = [-9, -5], x = [1.2, 0.4] }", r"\A\Z"),
    Meant("tow and its own current", ROPE + "[tow]\nspeed = 0.8\n", r"water.current repeats the speed of the tow.* 1.6 m/s", "leave water.current out"),
    Meant("tow and its own profile", changed("[0.8, 0, 0]", "{ z = [-20, 0], x = [0.8, 0.8] }") + "[tow]\nspeed = 0.8\n",
          r"water.current repeats the speed of the tow", "leave water.current out"),
    Meant("tow and its own factor", changed("[0.8, 0, 0]", "{ z = [-20, 0], x = [0.4, 0.4], t = [0, 9], factor = [1, 2] }") + "[tow]\nspeed = 0.8\n",
          r"water.current repeats the speed of the tow", "leave water.current out"),
    Meant("tow and its own current in time", changed("[0.8, 0, 0]", "{ t = [0, 60], x = [0, 0.8] }") + "[tow]\nspeed = 0.8\n",
          r"water.current repeats the speed of the tow", "leave water.current out"),
    Meant("tow and a current that is its own at one height", changed("[0.8, 0, 0]", "{ z = [-20, 0], x = [0.4, 0.8] }") + "[tow]\nspeed = 0.8\n", r"\A\Z"),
    Meant("leeway in degrees without a unit", changed("[water]", "[tow]\nspeed = 1\nleeway = 3\n[water]"),
          r"tow.leeway = 3 is in radians, which makes 171.9 degrees", '"30 deg"'),
    Meant("polar in degrees without a unit", gear("gears/pelagic-with-doors.toml", "[bodies.board.board]\n"
          "polar = { attack = [15, 30, 45], lift = [0.5, 1.0, 0.8], drag = [0.2, 0.5, 0.8] }\n[bodies.board.turned]\nheading = 3\n"),
          r"(?s)polar.attack\[0\] = 15 is in radians.*turned.heading = 3 is in radians", '"30 deg"', 0, "check"),
    Meant("board misspelt", gear("gears/pelagic-with-doors.toml", '[bodies.board]\ntype = "board/otzter"\n'),
          r'bodies.board.type: the plugin "board" has no element "board/otzter"; did you mean "board/otter"', "", 4),
    Meant("held in the air", ROPE.replace("-5]", "30]").replace("-10]", "28]"), r"rope lies up to 30 m above the surface", "surface = 1", 0, "run"),
    Meant("held below the bed", ROPE + '[bed]\ndepth = "3 m"\n', r"rope lies up to 4\.5\d? m below the bed", "", 0, "run"),
    Meant("stretched many times", changed('"12 m"', '"0.1 m"'), r"rope is stretched by \S+ %", "", 0, "run"),
    Meant("rope of rubber", changed('"50 kN"', "1"), r"rope is stretched by \S+ %", "", 0, "run"),
    Meant("gear that flies", gear("scenes/four-panel.toml",
          '[gear]\nnodes = 200\n[bed]\ndepth = "60 m"\n[elements.contact]\nseabed = { stiffness = "10 kN/m2" }\n'),
          r"nothing rests on the bed: \S+, the lowest part that could, is \S+ m above the bed; the net buoyancy of the gear is -?\d\S* N, (up|down)ward", "", 0, "run"),
    Meant("warp shorter than the depth", gear("scenes/pelagic-with-doors.toml",
          '[gear]\nnodes = 200\n[bed]\ndepth = "300 m"\n[elements.contact]\nseabed = { stiffness = "10 kN/m2" }\n'),
          r"nothing rests on the bed: .*; the longest warp is 150 m, and its start is 304 m above the bed: the warp cannot reach the bed", "", 0, "run"),
    Meant("loose hold that bears load", ROPE + "loose = true\n", r'not converged\n  the loose hold "rope.end" bears \d\S* N', "leave out `loose`", 3, "run"),
    Meant("loose hold that bears none", ROPE + '[[hold]]\non = "rope.node-6"\naxes = "y"\nloose = true\n', r"converged, stable", "", 0, "run"),
    Meant("pair of ropes to one side of a beam", BEAM % ("shoe", "shoe = [0, 2, -0.3]"),
          r"ropes.lash.between: both ropes of the pair would lead to beam.shoe, 2 m to starboard of the middle", '"port-shoe" and "starboard-shoe"', 2),
    Meant("pair of ropes to both sides of a beam", BEAM % ("shoe", "port-shoe = [0, -2, -0.3], starboard-shoe = [0, 2, -0.3]"), r"\A\Z"),
    Meant("pair of ropes to the middle of a beam", BEAM % ("tow", "tow = [0, 0, -0.3]"), r"\A\Z"),
]




def rope(**numbers):
    """ROPE with other material properties."""
    given = dict(diameter='"20 mm"', EA='"50 kN"', density="1500") | numbers
    return changed('diameter = "20 mm", EA = "50 kN", density = 1500', ", ".join(f"{k} = {v}" for k, v in given.items()))


def twine(density):
    return changed("1140", density, NET.replace('"2 mm"', '"20 mm"'))


def current(value):
    return changed("[0.8, 0, 0]", value)


def water(line):
    return changed("[water]", "[water]\n" + line)


def moved(way):
    return changed('on = "rope.end"', 'on = "rope.end"\n' + way, DYNAMIC)


def towed(speed, flow):
    return current(flow) + f"[tow]\nspeed = {speed}\n"


def shipped(speed):
    return gear("gears/pelagic-with-doors.toml", f"[ship]\nspeed = {speed}\n")


def floating(numbers):
    return ROPE + FLOAT % numbers


def lying(z, more=""):
    """A rope that is held straight at a height."""
    return ROPE.replace("-5]", f"{z}]").replace("-10]", f"{z}]").replace('"12 m"', '"9 m"').replace("1500", "1025") + more


def pulled(metres):
    """A rope of 5 m with hardly any stiffness, held so far apart."""
    return ROPE.replace("[0.8, 0, 0]", "[0, 0, 0]").replace("[[0, 0, -5], [5, 0, -10], [9, 0, -5]]", f"[[0, 0, -5], [{metres}, 0, -5]]").replace(
        '"12 m"', '"5 m"').replace("1500", "1025")


# For each limit, a value just inside it, which gives no warning, and a value just outside it, which gives
# one; both are within 10 % of the limit.
LIMITS = [
    ("lightest water", water("density = 910"), water("density = 890"), r"water.density = 890"),
    ("heaviest water", water("density = 1240"), water("density = 1260"), r"water.density = 1260"),
    ("thinnest water", water("viscosity = 0.56e-6"), water("viscosity = 0.54e-6"), r"water.viscosity = 5.4e-07 m2/s"),
    ("thickest water", water("viscosity = 1.95e-6"), water("viscosity = 2.05e-6"), r"water.viscosity = 2.05e-06 m2/s"),
    ("least gravity", water("gravity = 9.76"), water("gravity = 9.7"), r"water.gravity = 9.7 m/s2"),
    ("most gravity", water("gravity = 10"), water("gravity = 10.1"), r"water.gravity = 10.1 m/s2"),
    ("steepest bed along x", ROPE + "[bed]\ndepth = 60\nslope_x = -0.98\n", ROPE + "[bed]\ndepth = 60\nslope_x = -1.02\n", r"bed.slope_x = -1.02"),
    ("steepest bed along y", ROPE + "[bed]\ndepth = 60\nslope_y = 0.98\n", ROPE + "[bed]\ndepth = 60\nslope_y = 1.02\n", r"bed.slope_y = 1.02"),
    ("densest rope", rope(density="80000"), rope(density="81000"), r"rope.density = 81000 kg/m3: even a chain"),
    ("lightest rope", rope(density="101"), rope(density="99"), r'rope.density = 99 kg/m3: even cork .*"99 t/m3"'),
    ("densest twine", twine("22500"), twine("22700"), r"twine.density = 22700 kg/m3: osmium"),
    ("lightest twine", twine("101"), twine("99"), r"twine.density = 99 kg/m3: even cork"),
    ("thickest rope", rope(diameter="0.99"), rope(diameter="1.01"), r"rope.diameter = 1.01 m: no rope"),
    ("stiffness in compression", rope(EA_compression='"49 kN"'), rope(EA_compression='"51 kN"'), r"EA_compression = 51000 N is greater", 2),
    ("lightest mass of a float", floating("buoyancy = 7.1, volume = 0.001, mass = 0.5"), floating("buoyancy = 7.2, volume = 0.001, mass = 0.5"), "float.buoyancy = 7.2 N is used"),
    ("greatest mass of a float", floating("buoyancy = 3.2, volume = 0.001, mass = 0.5"), floating("buoyancy = 3.1, volume = 0.001, mass = 0.5"), "float.buoyancy = 3.1 N is used"),
    ("buoyancy of a float of unknown mass", floating("buoyancy = 12, volume = 0.001"), floating("buoyancy = 12.1, volume = 0.001"), "float.buoyancy = 12.1 N is used"),
    ("longest float by its volume", floating('volume = "83 L", diameter = 0.2'), floating('volume = "84.5 L", diameter = 0.2'), "the float displaces 0.0845 m3"),
    ("longest float by its buoyancy", floating("buoyancy = 830, diameter = 0.2"), floating("buoyancy = 850, diameter = 0.2"), "the float displaces 0.0845"),
    ("weakest float", floating("buoyancy = 4.3, diameter = 0.2"), floating("buoyancy = 4.1, diameter = 0.2"), r'float.buoyancy = 4.1 N, and the water .*"4.1 kgf"'),
    ("lightest float", floating("volume = 0.1, mass = 0.51"), floating("volume = 0.1, mass = 0.49"), "makes 4.9 kg/m3"),
    ("densest weight", floating("volume = 0.001, mass = 22.5"), floating("volume = 0.001, mass = 22.7"), "makes 2.27e.04 kg/m3"),
    ("most share of a length", rope(length_share="{ t = [0, 9], share = [1, 9.9] }"), rope(length_share="{ t = [0, 9], share = [1, 10.1] }"),
     r"rope.length_share reaches 10.1 times"),
    ("coarsest tolerance", ROPE + "[analysis]\ntolerance = 0.0099\n", ROPE + "[analysis]\ntolerance = 0.0101\n", r"analysis.tolerance = 0.0101"),
    ("fastest tow", towed("9.9", "[0, 0, 0]"), towed("10.1", "[0, 0, 0]"), r"tow.speed = 10.1 m/s"),
    ("fastest ship", shipped("9.9"), shipped("10.1"), r"ship.speed = 10.1 m/s"),
    ("fastest current", current("[7, 7, 0]"), current("[7.1, 7.1, 0]"), r"water.current reaches 10.04 m/s"),
    ("fastest profile", current("{ z = [-20, 0], x = [1, 9.9] }"), current("{ z = [-20, 0], x = [1, 10.1] }"), r"water.current reaches 10.1 m/s"),
    ("fastest profile with a factor", current("{ z = [-20, 0], x = [1, 3.3], t = [0, 9], factor = [1, 3] }"),
     current("{ z = [-20, 0], x = [1, 3.4], t = [0, 9], factor = [1, 3] }"), r"water.current reaches 10.2 m/s"),
    ("fastest current in time", current("{ t = [0, 60], x = [0, -9.9] }"), current("{ t = [0, 60], x = [0, -10.1] }"), r"water.current reaches 10.1 m/s"),
    ("current like the tow", towed("1", "[1.021, 0, 0]"), towed("1", "[1.019, 0, 0]"), r"repeats the speed of the tow"),
    ("profile above the gear", current("{ z = [-5.1, 20], x = [1, 2] }"), current("{ z = [-4.9, 20], x = [1, 2] }"), r"the profile lies above the gear"),
    ("profile below the gear", LEVEL % "{ z = [-20, -5], x = [1, 2] }", LEVEL % "{ z = [-20, -5.1], x = [1, 2] }", r"the profile lies below the gear"),
    ("fastest hold by its velocity", moved("velocity = { t = [0, 1], x = [0, 19.5] }"), moved("velocity = { t = [0, 1], x = [0, 20.5] }"), r"moves at 20.5 m/s"),
    ("fastest hold by its displacement", moved("displacement = { t = [0, 1], x = [0, 19.5] }"), moved("displacement = { t = [0, 1], x = [0, 20.5] }"), r"moves at 20.5 m/s"),
    ("fewest nodes", gear("scenes/four-panel.toml", "[gear]\nnodes = 20\n"), gear("scenes/four-panel.toml", "[gear]\nnodes = 19\n"), r"gear.nodes: = 19 is outside", 2),
    ("most outputs", DYNAMIC.replace("0.1", "99000"), DYNAMIC.replace("0.1", "101000"), r"asks for more than a million", 2),
    ("longest step", DYNAMIC + "step = 0.1\nlongest_step = 0.1\n", DYNAMIC + "step = 0.1\nlongest_step = 0.095\n", r"analysis.step: is longer", 2),
    ("shortest step", DYNAMIC + "step = 0.1\nshortest_step = 0.1\n", DYNAMIC + "step = 0.1\nshortest_step = 0.105\n", r"analysis.step: is shorter", 2),
    ("shortest and longest step", DYNAMIC + "shortest_step = 0.1\nlongest_step = 0.1\n", DYNAMIC + "shortest_step = 0.1\nlongest_step = 0.095\n",
     r"shortest_step: is longer", 2),
    ("thickest twine", changed('"3 mm"', '"1.9 mm"', NET), changed('"3 mm"', '"2 mm"', NET), r"no mesh can open", 2),
    ("rope as thick as long", rope(diameter="0.99").replace('"12 m"', '"1 m"').replace("cells = 12", "cells = 2"),
     rope(diameter="1").replace('"12 m"', '"1 m"').replace("cells = 12", "cells = 2"), r"diameter = 1 m, and a length of 1 m", 2),
    ("above the surface", lying(0.49), lying(0.52), r"rope lies up to 0.5\d* m above the surface", 0, "run"),
    ("below the bed", lying(-5.45, "[bed]\ndepth = 5\n"), lying(-5.52, "[bed]\ndepth = 5\n"), r"rope lies up to 0.5\d* m below the bed", 0, "run"),
    ("most strain", pulled(7.4), pulled(7.6), r"rope is stretched by 52 %", 0, "run"),
]


class CannotBeMeant(InFreshFolder):
    def answer(self, command, scene):
        self.write("scene.toml", scene)
        said = self.netloft(command, "scene.toml", *(["--overwrite"] if command == "run" else []))
        return said.code, said.err + (said.out if command == "run" else "")

    def check(self, meant):
        code, text = self.answer(meant.command, meant.scene)
        self.assertEqual(code, meant.code, text)
        self.assertRegex(text, meant.says)
        self.assertIn(meant.cure, text)

    def check_limit(self, within, beyond, says, code=0, command="plan"):
        given, text = self.answer(command, within)
        self.assertEqual(given, 0, text)
        self.assertNotIn("warning", text)
        given, text = self.answer(command, beyond)
        self.assertEqual(given, code, text)
        self.assertRegex(text, "(?s)" + says)


for each in ALL:
    name = "test_" + re.sub(r"\W", "_", each.name)
    assert not hasattr(CannotBeMeant, name), f"two scenes are called {each.name}"
    setattr(CannotBeMeant, name, lambda self, each=each: self.check(each))

for title, *limit in LIMITS:
    setattr(CannotBeMeant, "test_limit_of_" + re.sub(r"\W", "_", title), lambda self, limit=limit: self.check_limit(*limit))

if __name__ == "__main__":
    unittest.main()
