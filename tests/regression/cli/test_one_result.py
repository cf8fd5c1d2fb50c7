# SPDX-License-Identifier: BSD-3-Clause
"""All commands print the same result: `run`, `report` as text, JSON, CSV and HTML, the data of the page, and `diff` have the same numbers."""
import csv
import gzip
import html
import io
import json
import re
import unittest

import h5py

from program import SOURCE, InFreshFolder

LIBRARY = SOURCE / "gear-library/scenes"
OLD = SOURCE / "tests/regression/cli/old"  # written before results had warnings, stages and steps of a motion in their files
FEW = ["gear.nodes=80"]
SCENES = {  # name: scene, settings, more words, exit code
    "rope": ("hanging-rope.toml", ["parts.rope.cells=20"], [], 0),
    "rope-with-errors": ("hanging-rope.toml", ["parts.rope.cells=20"], ["--error", "--stages"], 0),
    "rope-with-sensitivities": ("hanging-rope.toml", ["parts.rope.cells=20"], ["--sensitivities"], 0),
    "panel-not-converged": ("dead-weight-panel.toml", ["analysis.max_iterations=2", "parts.net.cells=[8,8]"], [], 3),
    "cod-end": ("codend-from-plan.toml", FEW, [], 0),
    "half": ("four-panel.toml", FEW, [], 0),
    "whole": ("four-panel.toml", [*FEW, "gear.extent=whole", 'hold=[{on="starboard-door"},{on="port-door"}]'], [], 0),
    "swinging": ("two-panel.toml", ["gear.nodes=180"], [], 3),
    "flume": ("83-112-flume-3.0kn.toml", FEW, [], 0),
    "flume-with-sensitivities": ("83-112-flume-3.0kn.toml", FEW, ["--sensitivities"], 0),
    "without-sensitivities": ("dead-weight-panel.toml", ["analysis.max_iterations=2", "parts.net.cells=[8,8]"], ["--sensitivities"], 3),
    "boards": ("pelagic-with-doors.toml", FEW, [], 0),
    "motion": ("dynamics/elastic-pendulum.toml", ["analysis.duration=0.2"], [], 0),
}


class Results(InFreshFolder):
    def said(self, *words, code):
        ended = self.netloft(*words)
        self.assertEqual(ended.code, code, ended.out[:300] + ended.err[:300])
        return ended

    def page(self, command, file, words, code):
        self.netloft(command, file, "-o", f"{command}.html", *words)
        return (self.folder / f"{command}.html").read_text()

    def check(self, file, text, code):
        """All forms of the result in a file against one another; `text` is its report."""
        report = self.said("report", file, "--json", code=code).json()
        figures = {**report["results"], **(report["gear"] or {"figures": {}})["figures"]}
        rows = csv.DictReader(io.StringIO(self.said("report", file, "--csv", code=code).out))
        self.assertEqual(figures, {row["name"]: float(row["value"]) for row in rows if not row["name"].startswith("held/")})
        with h5py.File(self.folder / file) as f:
            for name, value in figures.items():
                group = "scalars" if name in report["results"] else "gear"
                self.assertEqual(f[f"netloft/{group}/{name}"][()], value, name)
        view = self.page("view", file, [], code)
        data = json.loads(re.search(r'id="data">(.*?)</script>', view, re.S)[1])["results"][0]
        self.assertEqual({f["name"]: f["value"] for f in data["figures"]}, figures)
        self.check_text(text, report)
        self.check_sensitivities(file, text, report)
        for page in (view, self.page("report", file, [], code)):
            self.check_page(page, text)
            if report["sensitivities"]:
                self.assertIn(f"<p>{html.escape(report['sensitivities']['note'], quote=False)}.</p>", page)
            self.assertFalse(re.search("<summary>/", page), "names a file by its folder on this machine")
        self.assertRegex(self.netloft("diff", file, file).out, r"none of \d+ numbers changed")

    def check_text(self, text, report):
        for name, value in report["results"].items():
            line = re.search(rf"^  {name} +(\S+)(?: ± (\S+))? ", text, re.M)
            self.assertAlmostEqual(float(line[1]), value, delta=float(line[2] or 0) + 1e-9 * abs(value), msg=name)
        for held in report["hold_forces"]:
            line = next(line for line in text.splitlines() if line.startswith(f"    {held['name']}, held "))
            for shown, force in zip(line.split()[-3:], held["force"]):
                self.assertAlmostEqual(float(shown), force, delta=1e-5 * abs(force) + 1e-6)

    def check_sensitivities(self, file, text, report):
        """The table of the numbers that key figures depend on, in their order, and in the file."""
        found = report["sensitivities"]
        self.assertEqual("  depends most on" in text, found is not None)
        if not found:
            return
        self.assertIn(f"\n    {found['note']}\n", text)
        lines = re.findall(r"(?m)^    .*$", text[text.index("  depends most on"):text.index(found["note"])])[:-1]
        self.assertEqual(len(lines), len(found["rows"]))
        for line, row in zip(lines, found["rows"]):
            self.assertIn(f" {row['path']} ", line)
            self.assertIn(f" {row['effect']:+.3g} ", line)
            self.assertAlmostEqual(row["effect"], 0.01 * abs(row["value"]) * row["derivative"], delta=1e-12 * abs(row["effect"]))
        with h5py.File(self.folder / file) as f:
            table = f["netloft/key_sensitivities"]
            for name in ("figure", "path", "unit", "value", "derivative") if lines else ():
                stored = [cell.decode() if isinstance(cell, bytes) else cell for cell in table[name][()]]
                self.assertEqual(stored, [row[name] for row in found["rows"]], name)

    def check_page(self, page, text):
        """Every row of the tables of a report is a row of a table of the page, cell by cell."""
        cells = [[html.unescape(re.sub("<[^>]*>", "", cell)).replace("–", "-") for cell in re.findall(r"<td[^>]*>(.*?)</td>", row)]
                 for row in re.findall(r"<tr>(.*?)</tr>", page, re.S)]
        rows = [" ".join(" ".join(row).split()) for row in cells]
        text = re.sub(r"(?m)^  ± is the error.*\n(    .*\n)*", "", text)
        tables = text[:text.index("  materials ") if "  materials " in text else re.search(r"^  \d+ nodes, ", text, re.M).start()]
        seen = 0
        for line in tables.splitlines():
            if line.startswith("    ") and "equilibrium is up to" not in line and ": " not in line:
                self.assertIn(" ".join(line.split()), rows)
                seen += 1
        return seen


class OneResult(Results):
    def test_every_form_has_the_same_numbers(self):
        for name, (scene, settings, words, code) in SCENES.items():
            with self.subTest(name):
                sets = [word for setting in settings for word in ("--set", setting)]
                file = f"{name}.hdf"
                run = self.said("run", str(LIBRARY / scene), *sets, *words, "-o", file, code=code).out
                self.assertEqual(run, self.said("report", file, code=code).out)
                self.check(file, run, code)
                again = self.said("run", str(LIBRARY / scene), *sets, *words, "-o", file, "--json", code=code).json()
                self.assertEqual(again, self.said("report", file, "--json", code=code).json())

    def test_a_gear_has_all_its_tables_on_the_page(self):
        scene, settings, words, code = SCENES["boards"]
        text = self.said("run", str(LIBRARY / scene), "--set", settings[0], "-o", "b.hdf", code=0).out
        self.assertGreater(self.check_page(self.page("report", "b.hdf", [], 0), text), 50)
        for title in ("bodies", "water on bodies", "warps", "ropes across the gear", "netting", "forces by part"):
            self.assertRegex(text, rf"(?m)^  {title} ")

    def test_one_figure_has_one_name(self):
        scene, settings, words, code = SCENES["boards"]
        text = self.said("run", str(LIBRARY / scene), "--set", settings[0], "-o", "b.hdf", code=0).out
        self.assertIn("  board spread ", text)
        self.netloft("draw", "b.hdf", "-o", "b.svg", "--dimensions", "--fit", "boards")
        for shown in ((self.folder / "b.svg").read_text(), self.page("view", "b.hdf", [], 0)):
            self.assertIn("board spread", shown)
            self.assertNotIn("spread of board", shown)


class Numbers(Results):
    def test_are_rounded_to_their_error(self):
        scene, settings, words, code = SCENES["half"]
        text = self.said("run", str(LIBRARY / scene), "--set", settings[0], "--error", "-o", "h.hdf", code=0).out
        report = self.said("report", "h.hdf", "--json", code=0).json()["gear"]
        height, error = re.search(r"headline height +([\d.]+) ± ([\d.]+) m ", text).groups()
        self.assertLessEqual(len(error.lstrip("0.")), 2)
        self.assertEqual(len(height.partition(".")[2]), len(error.partition(".")[2]))
        self.assertAlmostEqual(float(height), report["figures"]["mouth/headline_height"], delta=float(error))
        self.assertNotIn("±?", text)

    def test_without_an_error_of_the_mesh_one_line_says_so(self):
        text = self.said("run", str(LIBRARY / "hanging-rope.toml"), "-o", "r.hdf", code=0).out
        self.assertNotIn("±", text)
        self.assertEqual(text.count("errors of the mesh are not known"), 1)

    def test_round_off_of_a_table_of_forces_is_zero(self):
        words = ["run", str(LIBRARY / "dead-weight-panel.toml"), "--set", "analysis.max_iterations=2", "-o", "p.hdf"]
        held = re.search(r"^    top, held +(\S+) +(\S+) +(\S+)$", self.said(*words, code=3).out, re.M)
        with h5py.File(self.folder / "p.hdf") as f:
            self.assertLess(0, abs(f["netloft/forces/held"][0, 0]))  # 5e-12 N beside 7 kN
        self.assertEqual(held[1], "0")

    def test_instability_is_said_once(self):
        text = self.said("run", str(LIBRARY / "two-panel.toml"), "--set", "gear.nodes=180", "-o", "t.hdf", code=3).out
        self.assertEqual(text.splitlines()[0], "two-panel: unstable equilibrium, swinging")


class OldFiles(Results):
    def test_are_reported_with_all_that_they_hold(self):
        for name, sentence in (("rope", "largest residual "), ("gear", "largest residual "), ("motion", "t = 0.2 s was reached")):
            with self.subTest(name):
                self.write(f"{name}.hdf", gzip.decompress((OLD / f"{name}.hdf.gz").read_bytes()))
                text = self.said("report", f"{name}.hdf", code=0).out
                self.assertIn(sentence, text)
                self.assertIn(f"written to {name}.hdf by netloft 0.1.0", text)
                self.check(f"{name}.hdf", text, 0)
                self.assertEqual(self.netloft("draw", f"{name}.hdf").code, 0)

    def test_have_their_materials(self):
        self.write("gear.hdf", gzip.decompress((OLD / "gear.hdf.gz").read_bytes()))
        rows = {row["name"]: row for row in self.said("report", "gear.hdf", "--json", code=0).json()["materials"]}
        with h5py.File(self.folder / "gear.hdf") as f:
            cells = f["VTKHDF/CellData/part"][:] == list(f["netloft/parts/name"].asstr()).index("top")
            tension = max(f[f"VTKHDF/CellData/tension_{axis}"][:][cells].max() for axis in "uv")
        self.assertEqual(rows["top"]["load"], tension)
        self.assertGreater(rows["headline"]["utilisation"], 0)

    def test_have_their_netting_to_cut(self):
        """Values of the plan of the gear: gear-library/gears/83-112-eastern.toml."""
        scene = str(SOURCE / "gear-library/scenes/83-112-flume-3.0kn.toml")
        ended = self.said("run", scene, "--set", "gear.nodes=150", "--json", "-o", "gear.hdf", code=0)
        wing = {"name": "top-wing", "number": 2, "mesh": 0.1016, "twine": "pa-twisted-2.3mm", "twines": 1, "laid": "diamond", "fore": 3,
                "aft": 127.5, "deep": 95.5, "pieces": 1, "outer": "3B1M out 25.8, 5B1P in 70", "inner": "5B1M out 95.5"}
        self.assertEqual(ended.json()["netting"][0], wing)
        self.assertEqual(self.said("report", "gear.hdf", "--json", code=0).json()["netting"], ended.json()["netting"])
        self.assertIn("3B1M out 25.8, 5B1P in 70", self.said("report", "gear.hdf", code=0).out)


if __name__ == "__main__":
    unittest.main()
