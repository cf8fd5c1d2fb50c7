# SPDX-License-Identifier: BSD-3-Clause
"""A scene that cannot be meant is answered with a sentence that has the part and the number, and with a cure."""
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
    """`plan` reads a scene without computing it; its answer is that of `run` before anything is computed."""
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
          '[[hold]]\non = "rope.end"\nname = "b"\n', r"rope node 12 stands still here and moves by scene.toml:12:6", "the same motion", 2),
    Meant("hold that moves and stands still", DYNAMIC + '[[hold]]\non = "rope.end"\nname = "b"\nvelocity = { t = [0, 1], x = [0, 1] }\n',
          r"rope node 12 moves here and stands still by scene.toml:12:6", "the same motion", 2),
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
    Meant("tow and its own current", ROPE + "[tow]\nspeed = 0.8\n", r"water.current is the speed of the tow once more.* 1.6 m/s", "leave it out"),
    Meant("board misspelt", gear("gears/pelagic-with-doors.toml", '[bodies.board]\ntype = "board/otzter"\n'),
          r'bodies.board.type: the plugin "board" has no element "board/otzter"; did you mean "board/otter"', "", 4),
    Meant("held in the air", ROPE.replace("-5]", "30]").replace("-10]", "28]"), r"rope lies up to 30 m above the surface", "surface = 1", 0, "run"),
    Meant("held below the bed", ROPE + '[bed]\ndepth = "3 m"\n', r"rope lies up to 4\.5\d? m below the bed", "", 0, "run"),
    Meant("stretched many times", changed('"12 m"', '"0.1 m"'), r"rope is stretched by \S+ %", "", 0, "run"),
    Meant("rope of rubber", changed('"50 kN"', "1"), r"rope is stretched by \S+ %", "", 0, "run"),
    Meant("gear that flies", gear("scenes/four-panel.toml",
          '[gear]\nnodes = 200\n[bed]\ndepth = "60 m"\n[elements.contact]\nseabed = { stiffness = "10 kN/m2" }\n'),
          r"nothing rests on the bed: \S+, the lowest of what would, is \S+ m above it; its net buoyancy is -?\d\S* N, (up|down)ward", "", 0, "run"),
    Meant("warp shorter than the depth", gear("scenes/pelagic-with-doors.toml",
          '[gear]\nnodes = 200\n[bed]\ndepth = "300 m"\n[elements.contact]\nseabed = { stiffness = "10 kN/m2" }\n'),
          r"nothing rests on the bed: .*; the longest warp is 150 m, its start 304 m above the bed: it cannot reach the bed", "", 0, "run"),
    Meant("loose hold that bears load", ROPE + "loose = true\n", r'not converged\n  the loose hold "rope.end" bears \d\S* N', "leave out `loose`", 3, "run"),
    Meant("loose hold that bears none", ROPE + '[[hold]]\non = "rope.node-6"\naxes = "y"\nloose = true\n', r"converged, stable", "", 0, "run"),
    Meant("pair of ropes to one side of a beam", BEAM % ("shoe", "shoe = [0, 2, -0.3]"),
          r"ropes.lash.between: both ropes of the pair would lead to beam.shoe, 2 m to starboard of the middle", '"port-shoe" and "starboard-shoe"', 2),
    Meant("pair of ropes to both sides of a beam", BEAM % ("shoe", "port-shoe = [0, -2, -0.3], starboard-shoe = [0, 2, -0.3]"), r"\A\Z"),
    Meant("pair of ropes to the middle of a beam", BEAM % ("tow", "tow = [0, 0, -0.3]"), r"\A\Z"),
]


class CannotBeMeant(InFreshFolder):
    def check(self, meant):
        self.write("scene.toml", meant.scene)
        said = self.netloft(meant.command, "scene.toml")
        self.assertEqual(said.code, meant.code, said.err)
        text = said.err + (said.out if meant.command == "run" else "")
        self.assertRegex(text, meant.says)
        self.assertIn(meant.cure, text)


for each in ALL:
    name = "test_" + re.sub(r"\W", "_", each.name)
    assert not hasattr(CannotBeMeant, name), f"two scenes are called {each.name}"
    setattr(CannotBeMeant, name, lambda self, each=each: self.check(each))

if __name__ == "__main__":
    unittest.main()
