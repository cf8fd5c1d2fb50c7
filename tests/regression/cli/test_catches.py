# SPDX-License-Identifier: BSD-3-Clause
"""A catch in netting that is cut into several panels: panels that are cut and sewn together again mesh to mesh give the same result."""
import math
import unittest

from program import InFreshFolder

WITHIN = 0.01  # with 600 nodes in a half, other triangles change the drag of the catch by up to 0.8 %, the length by 0.05 %
TWINE = 'mesh = "90 mm"\ntwine = "pe-braided-4mm"\n'


def panel(name, depth, fore=44, more='sides = "AN"'):
    return f"[panels.{name}]\n{TWINE}fore = {fore}\ndepth = {depth}\n{more}\n"


def sewn(*seams):
    return "".join(f'[[join]]\nedges = ["{a}", "{b}"]\n' for a, b in seams)


OPEN = 'sides = "AN"\nopen = "fore"'
TWO_SIDES = 'sides = [{{ name = "a", cut = "AN", depth = {} }}, {{ name = "b", cut = "AN" }}]\nopen = "fore"'
TAPER = ('aft = 20\nsides = "3N2B in"', 'aft = 20\nsides = "3N2B in"\nopen = "fore"')

# name -> text of the plan, and panels from the fore end on each side, upper panels first
CUTS = {
    "whole": (panel("upper", 52, more=OPEN) + panel("lower", 52, more=OPEN)
              + sewn(("upper.sides", "lower.sides"), ("upper.aft", "lower.aft")), ["upper"], ["lower"]),
    "across, above": (panel("upper", 26, more=OPEN) + panel("after", 26) + panel("lower", 52, more=TWO_SIDES.format(26))
                      + sewn(("upper.sides", "lower.a"), ("after.sides", "lower.b"), ("upper.aft", "after.fore"),
                             ("after.aft", "lower.aft")), ["upper", "after"], ["lower"]),
    "across, all round, in three": (
        panel("upper", 26, more=OPEN) + panel("second", 13) + panel("third", 13)
        + panel("lower", 26, more=OPEN) + panel("under", 13) + panel("last", 13)
        + sewn(("upper.sides", "lower.sides"), ("second.sides", "under.sides"), ("third.sides", "last.sides"),
               ("upper.aft", "second.fore"), ("second.aft", "third.fore"), ("lower.aft", "under.fore"),
               ("under.aft", "last.fore"), ("third.aft", "last.aft")),
        ["upper", "second", "third"], ["lower", "under", "last"]),
    "along, above": (panel("upper", 52, 22, 'stands = "pair"\ninner = "AN"\nouter = "AN"\nopen = "fore"')
                     + panel("lower", 52, more=OPEN)
                     + sewn(("upper.inner", "upper.inner"), ("upper.outer", "lower.sides"), ("upper.aft", "lower.aft")),
                     ["upper"], ["lower"]),
}
TAPERED = {
    "whole": (panel("upper", 48, more=TAPER[1]) + panel("lower", 48, more=TAPER[1])
              + sewn(("upper.sides", "lower.sides"), ("upper.aft", "lower.aft")), ["upper"], ["lower"]),
    "across, all round": (
        panel("upper", 24, more=TAPER[1].replace("20", "32")) + panel("after", 24, 32, TAPER[0])
        + panel("lower", 24, more=TAPER[1].replace("20", "32")) + panel("under", 24, 32, TAPER[0])
        + sewn(("upper.sides", "lower.sides"), ("after.sides", "under.sides"), ("upper.aft", "after.fore"),
               ("lower.aft", "under.fore"), ("after.aft", "under.aft")), ["upper", "after"], ["lower", "under"]),
}


def hold(edge, up, extent):
    """A ring of 0.4 m, from the middle outwards, or from port to starboard."""
    turns = [k / 12 for k in range(0 if extent == "half" else -12, 13)]
    at = [[0, round(0.4 * math.sin(t * math.pi / 2), 6), round(up * 0.4 * math.cos(t * math.pi / 2), 6)] for t in turns]
    return f'[[hold]]\non = "{edge}"\nat = {at}\n'


def scene(cut, catch, extent):
    plan, above, below = cut
    ends = f'["{above[-1]}.aft", "{below[-1]}.aft"]'
    on = str(above + below).replace("'", '"')
    return (f'{plan}[gear]\nextent = "{extent}"\nnodes = {600 if extent == "half" else 1200}\n'
            '[water]\ncurrent = ["1.3 m/s", 0, 0]\n[elements.netting]\ntwine = { EA_compression = 0 }\n'
            f'[parts.catch]\non = {on}\n{catch}'
            f'[[join]]\npoints = {ends}\ntogether = true\n'
            f'{hold(above[0] + ".fore", 1, extent)}{hold(below[0] + ".fore", -1, extent)}'
            f'[results]\nlength = {{ of = "{above[-1]}.aft", take = "max x" }}\n'
            'front = { of = "catch", take = "max front" }\n')


PRESSURE = 'type = "catch/pressure"\ncatch = { speed = "1.3 m/s", %s }\n'
FRONT = 'type = "catch/front"\ncatch = { speed = "1.3 m/s", volume = "%s m3", front = 2.8 }\n'


class Catches(InFreshFolder):
    def solved(self, cut, catch, extent="half"):
        self.write("scene.toml", scene(cut, catch, extent))
        ended = self.netloft("run", "scene.toml", "--json", "--overwrite", "--threads", "1")
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        told = ended.json()
        drag = told["gear"]["figures"]
        return {**told["results"], "drag": drag["drag/all/x"], "drag of the catch": drag["drag_by_part/catch/x"]}

    def assertAlike(self, cuts, catch, extent="half"):
        whole = self.solved(cuts["whole"], catch, extent)
        for name, cut in cuts.items():
            if name == "whole": continue
            one = self.solved(cut, catch, extent)
            for figure, value in whole.items():
                self.assertAlmostEqual(one[figure], value, delta=WITHIN * abs(value), msg=f"{name}, {catch}, {figure}")
        return whole

    def test_a_volume_fills_cut_netting_as_it_fills_netting_in_one_piece(self):
        self.assertAlike(CUTS, PRESSURE % 'volume = "0.35 m3"')
        self.assertAlike(TAPERED, PRESSURE % 'volume = "0.2 m3"')
        self.assertAlike(CUTS, FRONT % 0.35)
        self.assertAlike(TAPERED, FRONT % 0.2)

    def test_a_part_of_the_last_panels_is_filled_and_a_part_of_those_ahead(self):
        """Cuts are 13 and 26 meshes from the end, and 24 in the tapered one."""
        across = {name: cut for name, cut in CUTS.items() if not name.startswith("along")}
        for meshes in (8, 20, 30):
            self.assertAlike(across, PRESSURE % f"meshes = {meshes}", "whole")
        self.assertAlike(TAPERED, PRESSURE % "meshes = 30", "whole")

    def test_as_many_meshes_can_be_filled_as_all_panels_have_together(self):
        self.write("scene.toml", scene(CUTS["across, above"], PRESSURE % "meshes = 53", "half"))
        self.assertIn("catch.meshes = 53 is more than the length of the netting, 52 meshes", self.netloft("run", "scene.toml").err)


if __name__ == "__main__":
    unittest.main()
