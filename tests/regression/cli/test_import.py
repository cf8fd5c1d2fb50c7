# SPDX-License-Identifier: BSD-3-Clause
"""Gears and meshes of other programs: imported scenes are solved and give the known answers."""
import math
import unittest

from program import GOOD, SOURCE, InFreshFolder, changed

MOORING = """\
--------------------- MoorDyn Input File ------------------------------------
a rope between two points, and another one on the bed
---------------------- LINE TYPES -----------------------------------
TypeName   Diam    Mass/m   EA     BA/-zeta   EI   Cd   Ca   CdAx   CaAx
(name)     (m)     (kg/m)   (N)    (N-s/-)    (-)  (-)  (-)  (-)    (-)
wire       0.05    12       2e7    -1         0    1.2  1    0.1    0
---------------------- POINTS ---------------------------------------
ID   Attachment  X    Y   Z     Mass  Volume  CdA  Ca
(#)  (word/ID)   (m)  (m) (m)   (kg)  (m^3)   (m^2) (-)
1    Fixed       0    0   -5    0     0       0    0
2    Coupled     80   0   -25   0     0       0    0
3    Fixed       0    20  -5    0     0       0    0
4    Fixed       40   20  -60   0     0       0    0
---------------------- LINES ----------------------------------------
ID  LineType  AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name)    (ID)    (ID)    (m)      (-)     (-)
1   wire      1       2       95       160     -
2   wire      3       4       100      100     -
---------------------- OPTIONS -----------------------------------------
60     WtrDpth   depth
1000   WtrDnsty  density
9.81   g
---------------------- need this line ------------------------------------
"""

# The net of program.GOOD hangs from its rope, which is held at both ends.
HANGING = changed(GOOD, ('length = "3 m"', 'length = "4.4 m"'), ("[[-2, 0, -4], [2, 0, -4]]", "[[-2, 0, 0], [2, 0, 0]]"),
                  ('"net.aft", "rope"', '"net.fore", "rope"'), ('on = "net.fore"', 'on = ["rope.start", "rope.end"]'),
                  ('lowest_z = { of = "net", take = "min z" }',
                   'lowest_z = { of = "net", take = "min z" }\npull = { of = "rope", take = "max tension" }'))


def on_mesh(scene, mesh):
    """The same gear on a mesh, in which parts share nodes instead of being joined."""
    return changed(scene, ('panel = { across = 4, along = 4, bar = "0.6 m" }\ncells = [4, 4]\n'
                           "sketch = [[-2, 0, 0], [2, 0, 0], [2, 0, -4], [-2, 0, -4]]\n", f'mesh = "{mesh}"\npanel = {{ bar = "0.6 m" }}\n'),
                   ("cells = 4\nsketch = [[-2, 0, 0], [2, 0, 0]]\n", f'mesh = "{mesh}"\n'),
                   ('[[join]]\npoints = ["net.fore", "rope"]\n', ""))


def elastic_catenary(x, z, length, EA, w):
    """H and V at the upper end of a rope whose lower end is at the distance x and z lower (Irvine 1981, eqs. 2.23, 2.24)."""
    def reach(H, V):
        W = w * length
        s = length / EA
        lower, upper = (V - W) / H, V / H
        return (H * s + H / w * (math.asinh(upper) - math.asinh(lower)),
                s * (V - W / 2) + H / w * (math.hypot(1, upper) - math.hypot(1, lower)))
    H, V = w * length, w * length
    for _ in range(200):
        fx, fz = reach(H, V)
        e = 1e-6
        a, b = (reach(H * (1 + e), V)[0] - fx) / (H * e), (reach(H, V * (1 + e))[0] - fx) / (V * e)
        c, d = (reach(H * (1 + e), V)[1] - fz) / (H * e), (reach(H, V * (1 + e))[1] - fz) / (V * e)
        det = a * d - b * c
        dH, dV = ((x - fx) * d - (z - fz) * b) / det, ((z - fz) * a - (x - fx) * c) / det
        step = min(1, 0.5 * H / abs(dH) if dH else 1)
        H, V = H + step * dH, V + step * dV
    return H, V


class Imports(InFreshFolder):
    def imported(self, what, *more):
        ended = self.netloft("import", what, *more, "-o", "scene.toml", "--color", "never")
        self.assertEqual(ended.code, 0, ended.err)
        return ended

    def solved(self, results):
        has_results = "\n[results]\n" in (self.folder / "scene.toml").read_text()
        with open(self.folder / "scene.toml", "a") as scene:
            scene.write(("" if has_results else "\n[results]\n") + results)
        ended = self.netloft("run", "scene.toml", "--json")
        self.assertEqual(ended.code, 0, ended.err + ended.out)
        return ended.json()["results"]

    def test_the_table_on_its_page_is_two_ropes_and_a_weight(self):
        page = (SOURCE / "io/scenes/import/TABLE.md").read_text()
        self.write("gear.csv", page.split("```csv\n")[1].split("```")[0])
        self.imported("table", "gear.csv")
        depth = -self.solved('z = { of = "rope.node-1", take = "z" }\n')["z"]
        # 5 kg hang on two ropes that weigh nothing in water: 2 T depth/l = 5 g, T = EA (l/l0 - 1)
        pull = lambda d: 2 * 60000 * (math.hypot(2, d) / 2.1 - 1) * d / math.hypot(2, d) - 5 * 9.80665
        low, high = 0.5, 1.0
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if pull(middle) < 0 else (low, middle)
        self.assertAlmostEqual(depth, low, delta=1e-6)

    def test_a_mooring_hangs_in_a_catenary_and_lies_on_its_bed(self):
        self.write("lines.txt", MOORING)
        said = self.imported("moordyn", "lines.txt").err
        self.assertIn("lines.txt:11:6: warning: point-2 is held at its position", said)
        figures = self.solved('top = { of = "line-1", take = "max tension" }\nlow = { of = "line-2", take = "min z" }\n')
        w = (12 - 1000 * math.pi * 0.05 ** 2 / 4) * 9.81
        H, V = elastic_catenary(80, 20, 95, 2e7, w)
        # Netloft reports the tension at the middle of a bar, here of the first of 160 bars
        self.assertAlmostEqual(figures["top"] / math.hypot(H, V - w * 95 / 320), 1, delta=2e-4)
        self.assertAlmostEqual(figures["low"], -60, delta=1e-3)
        # FairTen is the tension at the second end, and equals the net force on its node
        self.assertAlmostEqual(figures["AnchTen1"] / math.hypot(H, V), 1, delta=1e-4)
        self.assertAlmostEqual(figures["FairTen1"] / math.hypot(H, V - w * 95), 1, delta=1e-4)

    def test_lines_of_two_types_that_meet_on_the_bed_lie_on_it(self):
        """At their common node, the bed is as stiff as under half a bar of each rope."""
        text = changed(MOORING, ("---------------------- POINTS", "rope       0.1     10       1e7    -1         0    1.2  1    0.1    0\n"
                                 "---------------------- POINTS"),
                       ("4    Fixed       40   20  -60 ", "4    Fixed       0   20  -60 "), ("3    Fixed       0    20  -5 ", "3    Free        20    20  -60 "),
                       ("2   wire      3       4       100      100     -", "2   wire      4       3       21       21     -\n3   rope      3       2       90       90     -"))
        self.write("lines.txt", text)
        self.imported("moordyn", "lines.txt")
        figures = self.solved('joint = { of = "line-2.end", take = "z" }\n')
        self.assertAlmostEqual(figures["joint"], -60, delta=1e-2)
        self.assertNotIn("FairTen2", figures, "two lines end there")

    def test_a_gear_that_hangs_on_a_loose_hold_is_no_answer(self):
        """The file has no hold against the lateral force of an oblique current on the two bars."""
        gears = SOURCE / "tests/validation/femnet_files"
        gear = (gears / "01_two_bars.don").read_text(encoding="latin-1")
        self.write("g.don", changed(gear, ("Displacement X,Y,Z: 1  1  1", "Displacement X,Y,Z: 1  0  1")))
        self.write("g.mdg", (gears / "01_two_bars.mdg").read_text(encoding="latin-1"))
        self.assertIn("an equilibrium in which this hold bears load is not valid", self.imported("femnet", "g.don").err)
        ended = self.netloft("run", "scene.toml", "--json")
        self.assertEqual((ended.code, ended.json()["status"]), (3, "not converged"))
        self.assertRegex(ended.json()["reason"], r'^the loose hold "loose-1" bears 10\.8 N')
        self.assertEqual(self.netloft("report", "scene.hdf").code, 3)

    def test_what_is_wrong_is_said_and_nothing_is_written(self):
        self.write("gear.csv", "node,x,y,z\na,0,0,zero\n")
        ended = self.netloft("import", "table", "gear.csv", "--color", "never")
        self.assertEqual(ended.code, 2)
        self.assertIn('gear.csv:2:7: error: z = "zero" is no number', ended.err)
        self.assertEqual(set(self.files()), {"gear.csv"})
        self.write("gear.csv", "node,x,y,z,hold\na,0,0,0,xyz\nb,1,0,0,xyz\nbar,from,to,diameter,EA,density\nrope,a,b,0.01,1e5,1000\n")
        for words, what in ((("table", "gear.csv", "-o", "gear.hdf"), "-o gear.hdf: the name of this file must end in .toml"),
                            (("--check", "."), "--check .: there is no GEAR.don in it"),
                            (("table", "--check", "."), "--check is for FEMNET; the format is table"),
                            (("--check", ".", "-o", "a.toml"), "--output excludes --check")):
            ended = self.netloft("import", *words)
            self.assertEqual((ended.code, set(self.files())), (2, {"gear.csv"}))
            self.assertIn(what, ended.err)
        for words in (("table", "gear.csv", "--divide"), ("moordyn", "gear.csv", "--mesh", "gear.mdg"), ("orcaflex", "gear.csv"),
                      ("table", "nowhere.csv"), ("table",)):
            self.assertEqual(self.netloft("import", *words).code, 2, words)

    def test_the_scene_never_replaces_what_was_imported(self):
        table = "node,x,y,z,hold\na,0,0,0,xyz\nb,1,0,0,xyz\nbar,from,to,diameter,EA,density\nrope,a,b,0.01,1e5,1000\n"
        self.write("gear.toml", table)
        self.assertNotEqual(self.netloft("import", "table", "gear.toml", "-o", "gear.toml").code, 0)
        self.assertEqual(self.files()["gear.toml"].decode(), table)

    def test_a_result_is_an_input_in_every_format(self):
        self.write("first.toml", HANGING)
        first = self.netloft("run", "first.toml", "-o", "gear.hdf", "--json").json()["results"]
        for ending, error in (("mesh", 1e-6), ("obj", 1e-6), ("vtk", 1e-6)):
            ended = self.netloft("export", "gear.hdf", f"again.{ending}")
            self.assertEqual(ended.code, 0, ended.err)
            self.write("again.toml", on_mesh(HANGING, f"again.{ending}"))
            ended = self.netloft("run", "again.toml", "--json")
            self.assertEqual(ended.code, 0, ended.err)
            for name, value in first.items():
                self.assertAlmostEqual(ended.json()["results"][name], value, delta=error * abs(value), msg=f"{ending} {name}")


if __name__ == "__main__":
    unittest.main()
