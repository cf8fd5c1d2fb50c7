# SPDX-License-Identifier: BSD-3-Clause
"""What changed between two results: `diff`."""
import unittest

import h5py

from program import GOOD, SOURCE, InFreshFolder, changed

MOTION = str(SOURCE / "gear-library/scenes/dynamics/elastic-pendulum.toml")
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
            errors = sum(h["netloft/errors/solver/lowest_z"][()] for h in (f, g))
        # The net's weight in water grows with its density less that of the water, and the hold carries it.
        self.assertAlmostEqual(rows["forces/weight/net/z"]["percent"], -100 * 600 / (2000 - 1025), places=6)
        self.assertEqual(rows["forces/weight/rope/z"]["difference"], 0)
        self.assertLess(rows["results/lowest_z"]["after"], rows["results/lowest_z"]["before"])
        self.assertAlmostEqual(rows["results/lowest_z"]["error"], errors)
        self.assertTrue(rows["results/lowest_z"]["exceeds"])
        self.assertIsNone(rows["energy"]["exceeds"])  # no error of it is known

    def test_tells_people_and_marks_what_exceeds_the_errors(self):
        a, b = self.run_scene("a", GOOD), self.run_scene("b", changed(GOOD, HEAVIER))
        told = self.diff(a, b).out
        self.assertRegex(told, r"(?m)^\* results/lowest_z .* m$")
        self.assertRegex(told, r"(?m)^  energy ")
        self.assertNotIn("forces/weight/rope", told)

    def test_names_lines_and_options_that_differ(self):
        a = self.run_scene("a", GOOD, "--set", "water.gravity=9")
        b = self.run_scene("b", changed(GOOD, HEAVIER, ("[water]\n", "[water]\n# colder\n")))
        told = self.diff(a, b).out
        self.assertIn("- --set water.gravity=9\n", told)
        self.assertIn("+ b.toml:2: # colder\n", told)
        self.assertIn('- a.toml:10: twine = { diameter = "10 mm", EA = "10 kN", density = 2000 }', told)
        self.assertIn('+ b.toml:11: twine = { diameter = "10 mm", EA = "10 kN", density = 2600 }', told)
        inputs = self.diff(a, b, "--json").json()["inputs"]
        self.assertEqual(inputs["options"], {"before": ["--set water.gravity=9"], "after": []})
        self.assertEqual([line["line"] for line in inputs["files"][0]["lines"]], [2, 10, 11])

    def test_a_result_does_not_differ_from_itself(self):
        a = self.run_scene("a", GOOD)
        told = self.diff(a, a).out
        self.assertRegex(told, r"none of \d+ numbers changed\nthe inputs are the same\n$")

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
