# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a net plan that touch the bed: [elements.contact] is equivalent to parts written by hand."""
import unittest

from program import SOURCE, InFreshFolder

GOV = SOURCE / "gear-library" / "scenes" / "gov-like-67m.toml"
GEAR = SOURCE / "gear-library" / "gears" / "gov-like-with-doors.toml"
PLAIN = f"""include = ["{GEAR}"]
[gear]
extent = "half"
nodes = 300
[bed]
depth = "67 m"
[ship]
speed = "3.7 kn"
warp = {{ length = "232 m" }}
"""
BY_HAND = """
[parts.ground]
type = "seabed/bed"
on = "footrope"
seabed = { friction = 0.4, radius = "100 mm" }
[parts.bed]
type = "seabed/bed"
on = ["sweep", "lower-bridle", "upper-bridle"]
seabed = { friction = 0.4 }
[parts.shoe]
type = "seabed/bed"
on = ["door.toe", "door.heel"]
each = 0.5
seabed = { friction = 0.4, stiffness = "50 kN/m2" }
"""
BY_PLAN = """
[elements.contact]
seabed = { friction = 0.4 }
[elements.footrope]
seabed = { radius = "100 mm" }
rope = { weight_in_water = "60 N/m" }
[elements.door]
seabed = { stiffness = "50 kN/m2" }
"""
WEIGHED = """
[elements.footrope]
rope = { weight_in_water = "60 N/m" }
"""


SET_NET = """
[water]
current = [0.4, 0.1, 0]
[tow]
speed = 0
[parts.net]
type = "priour/triangle"
panel = { across = 20, along = 10, bar = "100 mm" }
cells = [10, 5]
sketch = [[0, -1.5, -18.5], [0, 1.5, -18.5], [0, 1.5, -20], [0, -1.5, -20]]
twine = { diameter = "3 mm", EA = "1 kN", density = 1140 }
[parts.leadline]
type = "rope/bar"
length = "3 m"
cells = 10
sketch = [[0, -1.5, -20], [0, 1.5, -20]]
rope = { diameter = "12 mm", EA = "50 kN", density = 6000 }
[parts.floats]
type = "float/float"
on = "net.fore"
number = 12
float = { buoyancy = "1 N" }
[parts.bridle]
type = "rope/bar"
length = "3.2 m"
cells = 8
sketch = [[0, -1.5, -20], [-1, -4.5, -20]]
rope = { diameter = "8 mm", EA = "20 kN", density = 1140 }
[[join]]
points = ["net.aft", "leadline"]
[[join]]
points = ["leadline.start", "bridle.start"]
[[hold]]
on = "bridle.end"
[results]
pull = { of = "bridle.end", take = "reaction" }
x = { of = "leadline.end", take = "x" }
y = { of = "leadline.end", take = "y" }
top = { of = "net", take = "max z" }
"""
ON_PLANE = """
[parts.bed]
type = "seabed/plane"
on = ["leadline", "bridle"]
seabed = { depth = "20 m", stiffness = "20 kN/m2", softness = "20 mm", friction = 0.5 }
"""
ON_BED = """
[bed]
depth = "20 m"
[parts.bed]
type = "seabed/bed"
on = ["leadline", "bridle"]
seabed = { stiffness = "20 kN/m2", softness = "20 mm", friction = 0.5 }
"""


class Contact(InFreshFolder):
    def test_a_set_net_lies_on_the_bed_of_the_scene_as_on_a_plane(self):
        values = {}
        for name, bed in (("plane", ON_PLANE), ("bed", ON_BED), ("smooth", ON_BED.replace("0.5", "0"))):
            self.write("net.toml", SET_NET + bed)
            ended = self.netloft("run", "net.toml", "--json", "--overwrite")
            self.assertEqual(ended.code, 0, ended.err + ended.out)
            self.assertNotIn("this type has friction only on a ground that moves", ended.err + ended.out)
            values[name] = ended.json()["results"]
        for name, value in values["plane"].items():
            self.assertAlmostEqual(values["bed"][name], value, delta=1e-7 * abs(value), msg=name)
        self.assertGreater(abs(values["smooth"]["y"] - values["bed"]["y"]), 0.5, "friction holds the leadline back")

    def figures(self, text):
        self.write("scene.toml", text)
        ended = self.netloft("run", "scene.toml", "--json", "--overwrite")
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        return ended.json()["gear"]["figures"]

    def test_by_the_plan_is_contact_by_hand(self):
        for extent in ("half", "whole"):
            scene = PLAIN.replace('"half"', f'"{extent}"')
            by_hand, by_plan = self.figures(scene + WEIGHED + BY_HAND), self.figures(scene + BY_PLAN)
            for name, value in by_hand.items():
                if not name.startswith(("drag_by_part", "weight_in_water_by_part", "body_forces")):
                    self.assertAlmostEqual(by_plan[name], value, delta=1e-6 * max(1, abs(value)), msg=f"{extent}: {name}")
            self.assertAlmostEqual(by_plan["weight_in_water_by_part/footrope"], 60 * 47.2, delta=1e-6)

    def test_the_footrope_is_shown_along_its_length(self):
        figures = self.figures(PLAIN + BY_PLAN)
        stretches = [f"footrope/{20 * k}-{20 * (k + 1)}%/" for k in range(5)]
        for total, one in (("length", "touching"), ("force", "force")):
            self.assertAlmostEqual(sum(figures[at + one] for at in stretches), figures[f"ground/footrope_{total}"], delta=1e-6 * figures["ground/footrope_force"])
        for at in stretches:
            self.assertAlmostEqual(figures[at + "force_per_metre"] * 47.2 / 5, figures[at + "force"], delta=1e-6)
        self.assertIn("footrope on the bed", self.netloft("report", "scene.hdf").out)
        self.assertGreater(figures["bodies/door/above_bed"], 0.5, "a board of 1.8 m stands on its shoe")

    def test_pieces_along_a_rope_lift_it_off_the_bed(self):
        """Half the diameter of the largest piece."""
        discs = '[floats.discs]\nfloat = { diameter = "400 mm", volume = 0, mass = "1 kg" }\nspread = "200 along footrope"\n'
        lowest = '[results]\nz = { of = "footrope", take = "min z" }\n'
        scene = PLAIN + BY_PLAN.replace('seabed = { radius = "100 mm" }\n', "") + lowest
        self.write("a.toml", scene)
        self.write("b.toml", scene + discs)
        z = [self.netloft("run", name, "--json").json()["results"]["z"] for name in ("a.toml", "b.toml")]
        self.assertAlmostEqual(z[1] - z[0], 0.2, delta=0.02)

    def test_a_footrope_without_a_bed_is_a_warning(self):
        self.write("scene.toml", PLAIN)
        warned = self.netloft("plan", "scene.toml").err
        self.assertIn("the footrope passes through the bed: no part carries the gear there", warned)
        self.assertIn("hint: [elements.contact]", warned)
        self.write("scene.toml", PLAIN + BY_PLAN)
        self.assertNotIn("passes through", self.netloft("plan", "scene.toml").err)

    def test_wrong_input_is_answered_with_its_place(self):
        for added, place, answers in (
                ("[elements.headline]\nseabed = { radius = 1 }\n" + BY_PLAN, "10:1", ("elements.headline: has the key seabed, but does not touch the bed",)),
                ("[elements.footrope]\nseabed = { radius = 1 }\n", "10:1", ("no [elements.contact] makes the plan rest on the bed", "[elements.contact]")),
                ("[elements.contact]\nsebed = { radius = 1 }\n", "11:1", ('unknown key "sebed"', 'did you mean "seabed"?')),
                ("[elements.contact]\nseabed = { fricton = 1 }\n", "11:12", ('unknown key "fricton"', 'did you mean "friction"?')),
                ("[elements.contact]\nseabed = { radius = \"20 m\" }\n", "11:21", ("is outside [0, 10] m",)),
                ("[elements.contact]\ntype = \"rope/bar\"\n", "11:8", ("elements.contact.type: rope/bar does not rest on the bed of the scene", "such as seabed/bed")),
                ("[elements.footrope]\nrope = { weight_in_water = \"5 kg\" }\n", "11:28", ("N/m",)),
        ):
            self.write("scene.toml", PLAIN + added)
            ended = self.netloft("plan", "scene.toml")
            self.assertEqual(ended.code, 2, added)
            self.assertIn(f"scene.toml:{place}: error", ended.err, added)
            for answer in answers:
                self.assertIn(answer, ended.err, added)
        self.write("scene.toml", PLAIN.replace('[bed]\ndepth = "67 m"\n', "") + BY_PLAN)
        self.assertIn("elements.contact: there is no bed that the gear could touch", self.netloft("plan", "scene.toml").err)


if __name__ == "__main__":
    unittest.main()
