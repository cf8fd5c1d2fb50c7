# SPDX-License-Identifier: BSD-3-Clause
"""What changed between two results: `diff`."""
import unittest

import h5py
import numpy

from program import GOOD, SOURCE, InFreshFolder, changed

MOTION = str(SOURCE / "gear-library/scenes/dynamics/elastic-pendulum.toml")
KEYS = ("max_iterations=900", "tolerance=1e-9", "max_seconds=900", "work=900", "tangent=exact")
HEAVIER = ("density = 2000", "density = 2600")


class Differences(InFreshFolder):
    def run_scene(self, name, text, *words):
        self.write(f"{name}.toml", text)
        ended = self.netloft("run", f"{name}.toml", *words)
        self.assertIn(ended.code, (0, 3), ended.err)
        return f"{name}.hdf"

    def diff(self, *words, code=0):
        ended = self.netloft("diff", *words)
        self.assertEqual(ended.code, code, ended.out + ended.err)
        return ended

    def test_says_what_changed_and_by_how_much(self):
        a, b = self.run_scene("a", GOOD), self.run_scene("b", changed(GOOD, HEAVIER))
        report = self.diff(a, b, "--json").json()
        rows = {row["name"]: row for row in report["quantities"]}
        with h5py.File(self.folder / a) as f, h5py.File(self.folder / b) as g:
            for name, row in rows.items():
                if name.startswith("results/"):
                    at = "netloft/scalars/" + name.removeprefix("results/")
                    self.assertEqual((row["before"], row["after"]), (f[at][()], g[at][()]))
                    self.assertAlmostEqual(row["difference"], row["after"] - row["before"])
                    self.assertAlmostEqual(row["percent"], 100 * row["difference"] / abs(row["before"]))
        # The weight of the net in water is proportional to the difference of the densities of net and water;
        # the hold bears this weight.
        self.assertAlmostEqual(rows["forces/weight/net/z"]["percent"], -100 * 600 / (2000 - 1025), places=6)
        self.assertEqual(rows["forces/weight/rope/z"]["difference"], 0)
        self.assertLess(rows["results/lowest_z"]["after"], rows["results/lowest_z"]["before"])
        self.assertIsNone(rows["results/lowest_z"]["error"])  # that of the mesh is not known
        self.assertIsNone(rows["results/lowest_z"]["exceeds"])
        self.assertIsNone(rows["energy"]["exceeds"])  # no error of it is known

    def test_tells_people_and_marks_what_exceeds_the_errors(self):
        softer = changed(GOOD, ('EA = "10 kN"', 'EA = "100 N"'))  # stretches by more than the coarse mesh is worth
        a, b = self.run_scene("a", GOOD, "--error"), self.run_scene("b", softer, "--error")
        told = self.diff(a, b, "--all").out
        self.assertRegex(told, r"(?m)^\* lowest z .* m .* %$")
        self.assertRegex(told, r"(?m)^\* results/lowest_z .* m$")
        self.assertRegex(told, r"(?m)^  energy .* ±\? J$")
        row = next(r for r in self.diff(a, b, "--json").json()["quantities"] if r["name"] == "results/lowest_z")
        with h5py.File(self.folder / a) as f, h5py.File(self.folder / b) as g:
            errors = sum(h[f"netloft/errors/{kind}/lowest_z"][()] for h in (f, g) for kind in ("solver", "mesh"))
        self.assertAlmostEqual(row["error"], errors)
        self.assertNotIn("forces/weight/rope", told)

    def test_refuses_a_newer_format_and_reads_an_older_one(self):
        a = self.run_scene("a", GOOD)
        for name, change in (("newer", lambda root: root.attrs.__setitem__("schema", 2)),
                             ("older", lambda root: root.attrs.__delitem__("schema"))):
            self.write(f"{name}.hdf", (self.folder / a).read_bytes())
            with h5py.File(self.folder / f"{name}.hdf", "r+") as f:
                change(f["netloft"])
        for words in ((a, "newer.hdf"), ("newer.hdf", a)):
            refused = self.diff(*words, code=2)
            self.assertIn("newer.hdf was written by a newer netloft, in format 2; this program reads format 1", refused.err)
        self.assertIn("a.hdf", self.diff(a, "older.hdf").out)

    def test_names_keys_and_options_that_differ(self):
        a = self.run_scene("a", GOOD, "--set", "water.gravity=9", "--solver", "newton")
        b = self.run_scene("b", changed(GOOD, HEAVIER, ("[water]\n", "[water]\n# colder\n")))
        told = self.diff(a, b).out
        self.assertIn("inputs: water.gravity: 9 -> 9.81\n        parts.net.twine.density: 2000 -> 2600\n        without --solver newton\n", told)
        inputs = self.diff(a, b, "--json").json()["inputs"]
        self.assertEqual(inputs["options"], {"before": ["--solver newton"], "after": []})
        self.assertEqual(inputs["keys"], [{"key": "water.gravity", "before": "9", "after": "9.81"},
                                          {"key": "parts.net.twine.density", "before": "2000", "after": "2600"}])
        self.assertEqual(inputs["files"], [])

    def test_compares_scenes_whatever_files_they_are_written_in(self):
        a = self.run_scene("a", GOOD)
        self.write("b.toml", 'include = ["a.toml"]\n[parts.rope.rope]\ndensity = 1200\n')
        self.assertEqual(self.netloft("run", "b.toml").code, 0)
        self.assertRegex(self.diff(a, "b.hdf").out.splitlines()[2], r"^inputs: parts.rope.rope.density: 1150 -> 1200$")

    def test_leaves_to_all_what_a_glance_does_not_need(self):
        a = self.run_scene("a", GOOD)
        b = self.run_scene("b", GOOD, *(word for i in range(5) for word in ("--set", f"analysis.{KEYS[i]}")))
        self.assertIn(" (and 2 more: --all)\n", self.diff(a, b).out)
        self.assertNotIn("more: --all", self.diff(a, b, "--all").out)

    def test_a_result_does_not_differ_from_itself(self):
        a = self.run_scene("a", GOOD)
        told = self.diff(a, a).out
        self.assertEqual(told.splitlines()[2], "inputs: the same")
        self.assertRegex(told, r"(?m)^none of \d+ numbers changed$")
        self.assertIn("largest move of a node: none\n", told)

    def test_says_that_comments_alone_changed(self):
        a, b = self.run_scene("a", GOOD), self.run_scene("b", changed(GOOD, ("[water]\n", "[water]\n# colder\n")))
        self.assertEqual(self.diff(a, b).out.splitlines()[2], "inputs: the same apart from comments and spaces")

    def test_begins_with_what_changed_in_the_input_and_the_figures(self):
        a, b = self.run_scene("a", GOOD), self.run_scene("b", changed(GOOD, HEAVIER))
        lines = self.diff(a, b).out.splitlines()
        self.assertEqual(lines[:3], ["before: a.hdf", "after:  b.hdf", "inputs: parts.net.twine.density: 2000 -> 2600"])
        self.assertRegex(lines[4], r"^  lowest z +-")
        with h5py.File(self.folder / a) as f, h5py.File(self.folder / b) as g:
            before, after = f["VTKHDF/Points"][:], g["VTKHDF/Points"][:]
            moves = numpy.linalg.norm(after - before, axis=1)
            node = moves.argmax()
            part, number = f["VTKHDF/PointData/part"][node], f["VTKHDF/PointData/node"][node]
        self.assertTrue(any(line.startswith(f"largest move of a node: {moves.max():.4g} m, ") for line in lines), lines)
        move = self.diff(a, b, "--json").json()["largest_move"]
        self.assertAlmostEqual(move["distance"], moves.max())
        self.assertIn("errors of the mesh are not known", "\n".join(lines))
        same = [i for i in range(len(moves)) if abs(moves[i] - moves.max()) < 1e-12]
        self.assertTrue((move["part"], move["node"]) == (["net", "rope"][part], number) or len(same) > 1)

    def test_marks_nothing_where_only_the_mesh_differs(self):
        a, b = self.run_scene("a", GOOD), self.run_scene("b", GOOD, "--set", "parts.net.cells=[8,8]", "--set", "parts.rope.cells=8")
        told = self.diff(a, b).out
        self.assertNotRegex(told, r"(?m)^\*")
        move = self.diff(a, b, "--json").json()["largest_move"]
        self.assertLess(move["distance"], 0.3)  # the same net: nodes lie where the other's netting is
        self.assertGreaterEqual(move["compared"], 25)

    def pair(self, base, key, value, number, *words):
        """The lines and the JSON of the difference that one changed key makes."""
        ended = self.netloft("run", base, "--set", f"{key}={value}", "-o", f"{number}.hdf", *words)
        self.assertIn(ended.code, (0, 3), ended.err)
        told = self.netloft("diff", "base.hdf", f"{number}.hdf")
        report = self.netloft("diff", "base.hdf", f"{number}.hdf", "--json").json()
        return told.out.splitlines(), report

    def check_pair(self, lines, report, key):
        self.assertTrue(any(f"{key}: " in line or f" {key} = " in line for line in lines[2:5]), (key, lines[:5]))
        rows = {row["name"]: row for row in report["quantities"]}
        figures = [rows[name] for name in report["figures"]]
        beyond = [row for row in figures if row["exceeds"]]
        self.assertEqual(figures[:len(beyond)], beyond)  # these come first
        shares = [abs(row["difference"]) / max(abs(row["before"]), abs(row["after"])) for row in beyond]
        self.assertEqual(shares, sorted(shares, reverse=True))
        stars = [line for line in lines[:10] if line.startswith("* ") and line.endswith("%")]
        self.assertEqual(len(stars), min(len(beyond), 10 - 4), lines[:10])

    def test_ten_pairs_with_errors_begin_with_what_exceeds_them(self):
        self.run_scene("base", GOOD, "--error")
        changes = [("parts.net.twine.EA", '"200 N"'), ("parts.net.twine.density", "2600"), ("parts.net.twine.diameter", '"20 mm"'),
                   ("parts.net.panel.bar", '"0.55 m"'), ("parts.rope.length", '"3.5 m"'), ("parts.rope.rope.density", "4000"),
                   ("parts.rope.rope.diameter", '"40 mm"'), ("parts.rope.rope.EA", '"1 kN"'), ("water.gravity", "9"), ("water.density", "1000")]
        for number, (key, value) in enumerate(changes):
            lines, report = self.pair("base.toml", key, value, number, "--error")
            self.check_pair(lines, report, key)

    def test_ten_pairs_of_a_trawl_begin_with_its_figures(self):
        trawl = str(SOURCE / "gear-library/scenes/83-112-flume-3.0kn.toml")
        coarse = ("--set", "gear.nodes=150")
        self.assertEqual(self.netloft("run", trawl, *coarse, "-o", "base.hdf").code, 0)
        changes = [("floats.headline.spread", '"42 along headrope"'), ("tow.speed", '"2.5 kn"'), ("ropes.upper-bridle.length", '"54 m"'),
                   ("panels.top-body.mesh", '"110 mm"'), ("ropes.footrope.length", '"34.6 m"'), ("water.density", "1025"),
                   ("ropes.lower-bridle.length", '"54.5 m"'), ("panels.top-wing.aft", "129.7"), ("ropes.headrope.length", '"25.6 m"'),
                   ("analysis.tolerance", "1e-9")]
        for number, (key, value) in enumerate(changes):
            lines, report = self.pair(trawl, key, value, number, *coarse)
            self.check_pair(lines, report, key)
            if key == "floats.headline.spread":
                self.assertRegex("\n".join(lines[:10]), r"(?m)^  headline height ")

    def test_round_off_of_a_sum_is_no_change(self):
        a = self.run_scene("a", GOOD)
        self.write("b.hdf", (self.folder / a).read_bytes())
        with h5py.File(self.folder / "a.hdf", "r+") as f, h5py.File(self.folder / "b.hdf", "r+") as g:
            f["netloft/forces/held"][0, 1], g["netloft/forces/held"][0, 1] = -8.5e-15, -3.0e-14
        self.assertIn("none of", self.diff(a, "b.hdf").out)

    def test_marks_what_is_not_converged(self):
        a = self.run_scene("a", GOOD)
        b = self.run_scene("b", GOOD, "--set", "analysis.max_iterations=1")
        ended = self.diff(a, b, code=3)
        self.assertIn("b.hdf: not converged; its numbers are those of the last point: the limit of 1 iteration", ended.out)
        self.assertEqual(self.diff(a, b, "--json", code=3).json()["status"], "not converged")

    def test_compares_scenes_that_share_nothing(self):
        a = self.run_scene("a", GOOD)
        self.assertEqual(self.netloft("run", MOTION, "-o", "motion.hdf").code, 0)
        rows = {row["name"]: row for row in self.diff(a, "motion.hdf", "--json").json()["quantities"]}
        self.assertIsNone(rows["results/lowest_z"]["after"])
        self.assertIsNone(rows["results/lowest_z"]["difference"])

    def refused(self, *words):
        ended = self.diff(*words, code=2)
        self.assertEqual(ended.out, "")
        return ended.err

    def test_refuses_what_is_no_result(self):
        a = self.run_scene("a", GOOD)
        self.write("text.hdf", "no HDF5 at all")
        with h5py.File(self.folder / "other.hdf", "w") as f:
            f["numbers"] = [1, 2]
        self.assertIn("cannot read nowhere.hdf: there is no such file", self.refused(a, "nowhere.hdf"))
        self.assertIn("cannot read text.hdf: it is not an HDF5 file", self.refused("text.hdf", a))
        self.assertIn("other.hdf is not a result of netloft", self.refused(a, "other.hdf"))
        self.assertIn("it is a folder", self.refused(a, "."))
        self.assertIn("AFTER is required", self.refused(a))
        failed = self.diff(a, "nowhere.hdf", "--json", code=2).json()
        self.assertEqual(failed["status"], "wrong input")


if __name__ == "__main__":
    unittest.main()
