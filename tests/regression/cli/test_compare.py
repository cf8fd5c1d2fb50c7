# SPDX-License-Identifier: BSD-3-Clause
"""`compare`, which shows speed and error, and the errors that `run` prints beside its results."""
import csv
import io
import math
import unittest
import xml.etree.ElementTree as xml

import h5py

from program import GOOD, SOURCE, InFreshFolder, changed

SCENES = SOURCE / "gear-library" / "scenes"
ROPE, PANEL = str(SCENES / "hanging-rope.toml"), str(SCENES / "dead-weight-panel.toml")
PENDULUM = str(SCENES / "dynamics" / "elastic-pendulum.toml")
COARSE = ["--set", "parts.net.cells=[8,8]"]
BARS = ["--set", "parts.rope.cells=40"]

# A bar that stands nearly upright on its foot: by the classic method the bar remains upright, by the
# globalised method it falls.
STANDING = """\
[water]
density = 0
[parts.bar]
type = "rope/bar"
length = "1 m"
cells = 1
sketch = [[0, 0, 0], [1e-4, 0, 0.999]]
rope = { diameter = "20 mm", EA = 1e5, EA_compression = 1e5, density = 2000 }
[[hold]]
on = "bar.start"
[results]
head_z = { of = "bar.end", take = "z" }
"""


class Comparisons(InFreshFolder):
    def compare(self, scene, *words):
        return self.netloft("compare", scene, *words, "--repeats", "1")

    def report(self, scene, *words):
        ended = self.compare(scene, "--json", *words)
        self.assertEqual(ended.code, 0, ended.err)
        return ended.json()

    def test_another_solver_judges_each(self):
        report = self.report(PANEL, *COARSE, "--solver", "newton", "--solver", "relaxation", "--tolerance", "1e-8:1e-6")
        for method in report["methods"]:
            reference = method["reference"]
            self.assertTrue(reference["independent"])
            self.assertNotEqual(reference["method"].split(":")[0], method["method"].split(":")[0])
            self.assertLess(reference["residual"], 1e-9 * reference["largest_load"])
            self.assertLess(reference["uncertainty"], 1e-10 * report["size"])

    def test_errors_fall_with_the_tolerance_and_estimates_tell_them(self):
        report = self.report(PANEL, *COARSE, "--solver", "relaxation", "--tolerance", "1e-10:1e-2")
        trials = report["methods"][0]["trials"]
        self.assertEqual([round(math.log10(t["tolerance"])) for t in trials], list(range(-2, -11, -1)))
        self.assertTrue(all(t["status"] == "converged" for t in trials[1:]))
        self.assertLess(trials[-1]["error"], 1e-4 * trials[0]["error"])
        for trial in trials[2:]:
            self.assertGreater(trial["error"], 0.5 * trial["estimate"])
            self.assertLess(trial["error"], 2 * trial["estimate"])

    def test_work_is_counted_by_the_host(self):
        report = self.report(ROPE, *BARS, "--solver", "newton", "--tolerance", "1e-8")
        trial = report["methods"][0]["trials"][0]
        self.assertGreater(report["factorisation_seconds"], 0)
        self.assertAlmostEqual(trial["in_factorisations"] * report["factorisation_seconds"], trial["cpu_seconds"])
        alone = self.netloft("run", ROPE, *BARS, "--json", "--solver", "newton", "--set", "analysis.tolerance=1e-8").json()
        for count in ("iterations", "factorisations"):
            self.assertEqual(trial[count], alone[count])

    def test_another_equilibrium_is_no_error(self):
        self.write("standing.toml", STANDING)
        ended = self.compare("standing.toml", "--solver", "newton:method=classic", "--reference", "newton",
                             "--tolerance", "1e-10", "--json")
        self.assertEqual(ended.code, 0, ended.err)
        method = ended.json()["methods"][0]
        # The head of the standing bar is two lengths above that of the hanging bar, and the centre of mass is
        # one length higher: the energy is higher by m g times one length.
        weight = math.pi / 4 * 0.02**2 * 2000 * 9.80665
        self.assertAlmostEqual(method["other_equilibrium"]["distance"], 2, delta=1e-3)
        self.assertAlmostEqual(method["other_equilibrium"]["energy_difference"], weight, delta=1e-3 * weight)
        self.assertIsNone(method["trials"][0]["error"])
        spoken = self.compare("standing.toml", "--solver", "newton:method=classic", "--reference", "newton",
                              "--tolerance", "1e-10")
        self.assertIn("found another equilibrium than newton", spoken.out)

    def test_discretisation_errors_of_a_rope(self):
        report = self.report(ROPE, *BARS, "--solver", "newton", "--tolerance", "1e-10", "--cells", "80,20,40")
        mesh = report["discretisation"]
        self.assertTrue(mesh["steady"])
        self.assertAlmostEqual(mesh["order"], 2, delta=0.1)
        self.assertEqual([level["cells"] for level in mesh["levels"]], [20, 40, 80])
        # The lowest point of the catenary is a node on all meshes, and has the largest error: the closed form
        # in the scene's first lines says where it should be.
        for level in mesh["levels"]:
            own = self.netloft("run", ROPE, "--json", "--set", f"parts.rope.cells={level['cells']}").json()
            true = abs(own["results"]["sag_z"] - -2.95736530)
            self.assertGreater(level["error"], true / 2)
            self.assertLess(level["error"], true * 2)

    def test_parts_are_divided_in_proportion_or_alone(self):
        self.write("scene.toml", GOOD)
        report = self.report("scene.toml", "--solver", "newton", "--tolerance", "1e-8", "--cells", "2,4,8")
        self.assertEqual(report["discretisation"]["part"], "net")
        alone = self.compare("scene.toml", "--solver", "newton", "--cells", "rope=4,8")
        self.assertEqual(alone.code, 2)
        self.assertRegex(alone.err, r"scene.toml:20:10: error: .*only sets with equally many nodes can be joined")

    def test_files(self):
        ended = self.compare(ROPE, *BARS, "--solver", "newton", "--solver", "newton:method=classic,damping=0", "--tolerance",
                             "1e-8:1e-7", "--cells", "10,20", "-o", "a.csv", "-o", "a.svg")
        self.assertEqual(ended.code, 0, ended.err)
        rows = list(csv.DictReader(io.StringIO((self.folder / "a.csv").read_text())))
        self.assertEqual([r["kind"] for r in rows].count("discretisation"), 2)
        self.assertEqual(rows[-3]["method"], "newton:method=classic,damping=0")
        self.assertTrue(all(None not in r and None not in r.values() for r in rows))
        root = xml.parse(self.folder / "a.svg").getroot()
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        self.compare(ROPE, *BARS, "--solver", "newton", "--tolerance", "1e-8", "-o", "a.html")
        self.assertIn("<svg", (self.folder / "a.html").read_text())

    def test_who_arrives_nowhere_is_not_converged(self):
        stuck = self.compare(PANEL, *COARSE, "--solver", "newton", "--set", "analysis.max_iterations=0")
        self.assertEqual(stuck.code, 3)
        self.assertIn("no reference", stuck.out)

    def test_solvers_are_not_compared_on_motions(self):
        self.assertIn("this scene is a motion", self.refused(PENDULUM, "--solver", "newton"))
        self.assertIn("this scene is a motion", self.netloft("refine", PENDULUM).err)

    def test_a_refined_rope_tends_to_its_catenary(self):
        ended = self.netloft("refine", ROPE, "--cells", "20,40,80", "--json")
        self.assertEqual(ended.code, 0, ended.err)
        report = ended.json()
        self.assertEqual([mesh["count"] for mesh in report["meshes"]], [20, 40, 80])
        sag = next(row for row in report["quantities"] if row["name"] == "results/sag_z")
        self.assertAlmostEqual(sag["order"], 2, delta=0.05)
        self.assertAlmostEqual(sag["limit"], -2.95736530, delta=1e-6)  # the closed form, as the scene says
        self.assertAlmostEqual(sag["error"], 1.25 * abs(sag["values"][-1] - sag["limit"]))
        alone = self.netloft("run", ROPE, "--json", "--set", "parts.rope.cells=40").json()
        self.assertAlmostEqual(sag["values"][1], alone["results"]["sag_z"], delta=1e-9)
        told = self.netloft("refine", ROPE, "--cells", "20,40,80").out
        self.assertRegex(told, r"results/sag_z( +-2\.9\d+){3} +-2\.95737")

    def test_refining_says_what_did_not_converge_and_refuses_wrong_meshes(self):
        ended = self.netloft("refine", PANEL, "--cells", "2,4", "--set", "analysis.max_iterations=1")
        self.assertEqual(ended.code, 3)
        self.assertIn("missing: with 2 cells of net the result was not converged", ended.out)
        for words, sentence in ((["--nodes", "500,2000"], "no net plan"), (["--cells", "8"], "--cells 8"),
                                (["--nodes", "x"], "--nodes")):
            wrong = self.netloft("refine", PANEL, *words)
            self.assertEqual((wrong.code, wrong.out), (2, ""))
            self.assertIn(sentence, wrong.err)

    def refused(self, *words, code=2):
        ended = self.netloft("compare", *words)
        self.assertEqual(ended.code, code, ended.out + ended.err)
        self.assertEqual(ended.out, "")
        return ended.err

    def test_wrong_input(self):
        newton = ["--solver", "newton"]
        self.assertIn("--solver", self.refused(ROPE))
        self.assertIn("not empty", self.refused(ROPE, "--solver", "") + " not empty")
        self.assertIn("given twice", self.refused(ROPE, *newton, *newton))
        self.assertIn("reversed", self.refused(ROPE, *newton, "--tolerance", "1e-2:1e-8"))
        for word in ("", "x", "1e-8:", ":1e-2", "0:1", "1e-8:2", "nan", "1e-8:1e-4:1e-2"):
            self.assertIn("is no tolerance", self.refused(ROPE, *newton, "--tolerance", word), word)
        for word in ("8", "8,8", "8,x", "8,1.5", "0,8", "8,16,"):
            self.assertIn("--cells " + word, self.refused(ROPE, *newton, "--cells", word), word)
        self.assertIn("divided are rope", self.refused(ROPE, *newton, "--cells", "net=8,16"))
        self.assertIn("not a whole number of cells", self.refused(str(SCENES / "dead-weight-panel.toml"), "--set",
                                                               "parts.net.cells=[32,18]", *newton, "--cells", "8,16,32"))
        self.assertIn("-o a.png: the name of this file must end in .svg or .html or .csv", self.refused(ROPE, *newton, "-o", "a.png"))
        self.assertIn("no folder", self.refused(ROPE, *newton, "-o", "a.svg", "-o", "nowhere/a.csv"))
        self.assertIn("is no name of a solver", self.refused(ROPE, "--solver", "a b"))
        self.assertIn("damping", self.refused(ROPE, "--solver", "newton:dampinng=1"))
        self.assertIn("newton", self.refused(ROPE, "--solver", "newtom", code=4))
        self.assertEqual(self.files(), {})

    def test_the_scene_is_never_written_over(self):
        self.write("scene.csv", GOOD)
        self.assertIn("read from it", self.refused("scene.csv", "--solver", "newton", "-o", "scene.csv"))
        self.assertEqual((self.folder / "scene.csv").read_text(), GOOD)

    def test_a_scene_without_cells_has_no_mesh_to_refine(self):
        self.write("point.toml", '[parts.a]\ntype = "float/float"\nat = [0, 0, 0]\nfloat = { volume = 0.001, mass = 0.1 }\n'
                                 '[[hold]]\non = "a"\n')
        self.assertIn("nothing in this scene is divided", self.refused("point.toml", "--solver", "newton", "--cells", "8,16"))
        ended = self.netloft("run", "point.toml", "--error")
        self.assertEqual(ended.code, 2)
        self.assertIn("nothing in this scene is divided", ended.err)

    def test_nodes_by_number_are_other_nodes_on_another_mesh(self):
        self.write("scene.toml", changed(GOOD, ('of = "net"', 'of = "net.node-3"'), ("min z", "z")))
        self.assertIn("scene.toml:30:19: ", self.refused("scene.toml", "--solver", "newton", "--cells", "2,4"))


class Motions(InFreshFolder):
    def compare(self, *words):
        return self.netloft("compare", PENDULUM, *words, "--repeats", "1", "--set", "analysis.duration=1",
                            "--set", "analysis.output_interval=0.1")

    def report(self, *words):
        ended = self.compare("--json", *words)
        self.assertEqual(ended.code, 0, ended.err)
        return ended.json()

    def test_are_held_against_the_path_of_another_integrator(self):
        report = self.report("--integrator", "energy-momentum", "--integrator", "generalized-alpha", "--accuracy", "1e-4:1e-1")
        for method in report["integrators"]:
            trials, reference = method["trials"], method["reference"]
            self.assertTrue(reference["independent"])
            self.assertNotEqual(reference["integrator"], method["integrator"])
            self.assertAlmostEqual(reference["accuracy"], 1e-5)
            self.assertEqual([round(math.log10(t["accuracy"])) for t in trials], [-1, -2, -3, -4])
            self.assertTrue(all(t["status"] == "finished" and t["factorisations"] > 0 for t in trials))
            self.assertLess(trials[-1]["error"], 0.1 * trials[0]["error"])
            self.assertLess(reference["distance_of_another"], trials[-1]["error"])

    def test_errors_are_those_of_the_paths_that_runs_write(self):
        report = self.report("--integrator", "generalized-alpha", "--reference", "energy-momentum", "--accuracy", "1e-2")
        paths = []
        for name, accuracy in (("generalized-alpha", "1e-2"), ("energy-momentum", "1e-3")):
            out = self.folder / (name + ".hdf")
            ended = self.netloft("run", PENDULUM, "--set", "analysis.duration=1", "--set", "analysis.output_interval=0.1",
                                 "--set", "analysis.integrator=" + name, "--set", "analysis.accuracy=" + accuracy, "-o", out)
            self.assertEqual(ended.code, 0, ended.err)
            with h5py.File(out) as f:
                count, steps = f["VTKHDF/NumberOfPoints"][0], f["VTKHDF/Steps/PointOffsets"][()]
                paths.append([f["VTKHDF/Points"][first:first + count] for first in steps])
        apart = max(((a - b)**2).sum(axis=1).max()**0.5 for a, b in zip(*paths))
        self.assertAlmostEqual(report["integrators"][0]["trials"][0]["error"], apart, delta=1e-9 * apart)

    def test_that_are_lost_are_called_lost(self):
        """Steps of constant length that are far too long for the fixed-point iteration of the paper."""
        ended = self.compare("--integrator", "newmark:corrector=fixed-point", "--integrator", "energy-momentum", "--accuracy",
                             "1e-1", "--set", "analysis.adaptive=false", "--set", "analysis.step=0.1", "-o", "a.svg",
                             "-o", "a.csv")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertRegex(ended.out, r"newmark:corrector=fixed-point +1e-01 lost +- ")
        self.assertIn("newmark:corrector=fixed-point: lost at 1e-01: ", ended.out)
        self.assertIn("newmark:corrector=fixed-point (lost at 1e-01)", (self.folder / "a.svg").read_text())
        rows = list(csv.DictReader(io.StringIO((self.folder / "a.csv").read_text())))
        self.assertEqual([(r["kind"], r["status"]) for r in rows], [("motion", "lost"), ("motion", "finished")])

    def test_ends_with_its_budget_of_work(self):
        words = ["--integrator", "newmark", "--integrator", "generalized-alpha", "--set", "analysis.work=0.1"]
        ended = self.compare("--json", *words, "--accuracy", "1e-3:1e-1")
        self.assertEqual(ended.code, 0, ended.err)
        for method in ended.json()["integrators"]:
            self.assertEqual([t["status"] for t in method["trials"]], ["finished", "finished", "out of work"])
            self.assertRegex(method["trials"][-1]["reason"], r"the budget of work was spent at t = 0\.\d+ s")
        told = self.compare(*words, "--accuracy", "1e-3")
        self.assertEqual(told.code, 3)
        self.assertIn("newmark: no reference because no other integrator completed the motion", told.out)
        self.assertIn("newmark: out of work at 1e-03: the budget of work was spent at t = 0.", told.out)

    def test_an_integrator_that_is_not_installed_has_a_row(self):
        ended = self.compare("--json", "--integrator", "symplectic", "--integrator", "newmark", "--accuracy", "1e-2", "-o", "a.svg")
        self.assertEqual(ended.code, 0, ended.err)
        absent = ended.json()["integrators"][0]
        self.assertEqual((absent["integrator"], absent["reference"], len(absent["trials"])), ("symplectic", None, 1))
        self.assertEqual(absent["trials"][0]["status"], "not installed")
        self.assertIsNone(absent["trials"][0]["cpu_seconds"])
        self.assertNotIn("symplectic", (self.folder / "a.svg").read_text())
        told = self.compare("--integrator", "symplectic", "--integrator", "newmark", "--accuracy", "1e-2")
        self.assertRegex(told.out, r'symplectic +1e-02 not installed +- +- ')
        self.assertIn('symplectic: not installed at 1e-02: there is no plugin "symplectic" here', told.out)
        for words in (["symplectic"], ["newmrk", "newmark"]):
            with self.subTest(words=words):
                refused = self.compare(*[w for name in words for w in ("--integrator", name)], "--accuracy", "1e-2")
                self.assertEqual(refused.code, 4)
                self.assertIn("there is no plugin", refused.err)

    def test_wrong_input(self):
        words = ["--integrator", "newmark"]
        for more, sentence in ((["--solver", "newton"], "give one kind only"), (["--cells", "8,16"], "--cells"),
                               (["--accuracy", "2"], "is no accuracy"), (["--accuracy", "1e-1:1e-3"], "reversed"),
                               (["--integrator", "newmark"], "given twice"), (["--integrator", "newmark:x=1"], "x")):
            ended = self.netloft("compare", PENDULUM, *words, *more)
            self.assertEqual((ended.code, ended.out), (2, ""), more)
            self.assertIn(sentence, ended.err)
        self.assertIn("this scene is static", self.netloft("compare", PENDULUM, *words, "--set", "analysis.kind=static").err)
        self.assertIn("--accuracy is that of motions", self.netloft("compare", ROPE, "--solver", "newton", "--accuracy", "1e-2").err)


class Errors(InFreshFolder):
    def test_stand_beside_every_result(self):
        ended = self.netloft("run", ROPE, "--error")
        self.assertEqual(ended.code, 0, ended.err)
        line = next(line for line in ended.out.splitlines() if line.strip().startswith("sag_z"))
        self.assertRegex(line, r"-2\.957\d* ± 0\.0+\d+ m ")
        self.assertIn("(order 2.0)", line)

    def test_of_the_mesh_are_true(self):
        # Values of the closed form in the first lines of the scene.
        exact = {"horizontal_tension": 2.99708988, "sag_z": -2.95736530, "end_tension": 5.82945518}
        for bars in ("16", "40", "200"):
            report = self.netloft("run", ROPE, "--error", "--json", "--set", "parts.rope.cells=" + bars).json()
            for name, value in exact.items():
                true, found = abs(report["results"][name] - value), report["errors"][name]
                self.assertGreater(found["mesh"], true / 2, (bars, name))
                self.assertLess(found["mesh"], true * 2, (bars, name))
                self.assertAlmostEqual(found["mesh_order"], 2, delta=0.3)

    def test_of_the_solver_are_true(self):
        tight = self.netloft("run", PANEL, *COARSE, "--json").json()
        for tolerance in ("1e-3", "1e-5"):
            loose = self.netloft("run", PANEL, *COARSE, "--json", "--solver", "relaxation", "--set",
                                 "analysis.tolerance=" + tolerance).json()
            for name in ("lowest_z", "largest_tension"):
                true = abs(loose["results"][name] - tight["results"][name])
                self.assertGreater(true, 10 * tight["errors"][name]["solver"])
                self.assertGreater(loose["errors"][name]["solver"], true / 2, (name, tolerance))
                self.assertLess(loose["errors"][name]["solver"], true * 2, (name, tolerance))

    def test_are_in_the_file(self):
        report = self.netloft("run", ROPE, *BARS, "--error", "--json").json()
        with h5py.File(self.folder / report["output"]) as f:
            self.assertEqual(f["netloft/errors/nodes"][()], report["node_error"])
            for name, errors in report["errors"].items():
                self.assertEqual(f["netloft/errors/solver"][name][()], errors["solver"])
                self.assertEqual(f["netloft/errors/mesh"][name][()], errors["mesh"])
                self.assertEqual(f["netloft/errors/mesh_order"][name][()], errors["mesh_order"])
        self.netloft("run", ROPE, *BARS)
        with h5py.File(self.folder / report["output"]) as f:
            self.assertIn("solver", f["netloft/errors"])
            self.assertNotIn("mesh", f["netloft/errors"])

    def test_are_not_claimed_where_nothing_converged(self):
        report = self.netloft("run", PANEL, *COARSE, "--error", "--json", "--solver", "newton", "--set", "analysis.max_iterations=2").json()
        self.assertIsNone(report["node_error"])
        self.assertIn("did not converge", report["mesh_note"])
        self.assertTrue(all(e["solver"] is None and e["mesh"] is None for e in report["errors"].values()))


if __name__ == "__main__":
    unittest.main()
