# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run, cell by cell, and give the results that their texts state."""
import json
import math
import re
import sys
import tempfile
import unittest
from pathlib import Path

from blocks import FOLDER

sys.path.append(str(FOLDER / "notebooks"))
import render

NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
# Numbers that depend on rounding: errors of the solver, numbers of factorisations, and distances between
# equal shapes.
OF_ROUNDING = re.compile(r"± \S+|\d+ f\.|\d\.\d+e-\d+|: 0\.0\b")


def parts_of(page):
    """The words of a page between its numbers, and the numbers."""
    text = re.sub(r" +", " ", OF_ROUNDING.sub("", page))
    return NUMBER.split(text), [float(n) for n in NUMBER.findall(text)]


class Notebooks(unittest.TestCase):
    def run_notebook(self, name):
        """The names after all cells. The page beside the notebook must equal that of this run."""
        with tempfile.TemporaryDirectory() as folder:
            page, names = render.render(FOLDER / f"notebooks/{name}.ipynb", Path(folder))
            pictures = sorted(path.name for path in Path(folder).iterdir())
        kept = (FOLDER / f"notebooks/{name}.md").read_text()
        (words, numbers), (kept_words, kept_numbers) = parts_of(page), parts_of(kept)
        self.assertEqual(words, kept_words, f"{name}.md is of an older notebook; run render.py")
        for number, known in zip(numbers, kept_numbers):
            self.assertTrue(math.isclose(number, known, rel_tol=2e-3, abs_tol=2e-3), f"{name}.md has {known} instead of {number}; run render.py")
        self.assertEqual(pictures, sorted(re.findall(r"!\[.*\]\((.*)\)", kept)))
        for picture in pictures:
            self.assertEqual((FOLDER / "notebooks" / picture).read_bytes()[:4], b"\x89PNG")
        return names

    def test_have_no_outputs(self):
        files = sorted((FOLDER / "notebooks").glob("*.ipynb"))
        self.assertEqual([file.stem for file in files], ["design", "flume", "own_solver"])
        for file in files:
            for cell in json.loads(file.read_text())["cells"]:
                if cell["cell_type"] == "code":
                    self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), file.name)

    def test_meet_the_flume(self):
        names = self.run_notebook("flume")
        for knots, (height, spread, tension) in names["errors"].items():  # as tests/validation/flume.py allows
            self.assertLess(abs(height), 0.12 if knots == "2.0" else 0.08)
            self.assertLess(abs(spread), 0.06)
            self.assertLess(abs(tension), 0.05)
        self.assertAlmostEqual(*names["powers"], delta=0.08)

    def test_design_a_gear(self):
        names = self.run_notebook("design")
        heights = names["heights"]
        self.assertGreater(heights["12 floats"], 1.1 * heights["as drawn"])
        self.assertLess(heights["3 kn"], heights["as drawn"])
        self.assertIn("panels.upper", names["hint"])

    def test_judge_solvers(self):
        names = self.run_notebook("own_solver")
        for case, table in names["tables"].items():
            self.assertEqual(table["newton"]["status"], "converged", case)
        found = {solver: [table[solver]["status"] for table in names["tables"].values()].count("converged") for solver in ("textbook", "shifted")}
        self.assertEqual(found, {"textbook": 2, "shifted": 4})
        for case, distances in names["distances"].items():
            self.assertLess(max(distances.values()), 1e-3, case)


if __name__ == "__main__":
    unittest.main()
