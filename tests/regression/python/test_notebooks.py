# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run, cell by cell, and find what they say."""
import ast
import contextlib
import io
import json
import os
import tempfile
import unittest

from blocks import FOLDER, blocks


def show(value):
    """What a notebook does with the last value of a cell."""
    return [getattr(value, name)() for name in ("_repr_svg_", "__repr__") if hasattr(value, name)]


def run(name):
    """The names after all cells, in an empty folder, and what was printed."""
    names, printed, here = {}, io.StringIO(), os.getcwd()
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(printed):
        os.chdir(folder)
        try:
            for cell in blocks(FOLDER / f"notebooks/{name}.ipynb"):
                tree = ast.parse(cell)
                last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
                exec(compile(tree, name, "exec"), names)
                if last:
                    show(eval(compile(ast.Expression(last.value), name, "eval"), names))
        finally:
            os.chdir(here)
    return names, printed.getvalue()


class Notebooks(unittest.TestCase):
    def test_have_no_outputs(self):
        files = sorted((FOLDER / "notebooks").glob("*.ipynb"))
        self.assertEqual([file.stem for file in files], ["design", "flume", "own_solver"])
        for file in files:
            for cell in json.loads(file.read_text())["cells"]:
                if cell["cell_type"] == "code":
                    self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), file.name)

    def test_meet_the_flume(self):
        names, printed = run("flume")
        for knots, (height, spread, tension) in names["errors"].items():  # as tests/validation/flume.py allows
            self.assertLess(abs(height), 0.12 if knots == "2.0" else 0.08)
            self.assertLess(abs(spread), 0.06)
            self.assertLess(abs(tension), 0.05)
        self.assertAlmostEqual(*names["powers"], delta=0.08)
        self.assertEqual(len(printed.splitlines()), 1 + 5 + 4)

    def test_design_a_gear(self):
        names, _ = run("design")
        heights = names["heights"]
        self.assertGreater(heights["12 floats"], 1.1 * heights["as drawn"])
        self.assertLess(heights["3 kn"], heights["as drawn"])
        self.assertIn("panels.upper", names["hint"])

    def test_judge_solvers(self):
        names, _ = run("own_solver")
        for case, table in names["tables"].items():
            self.assertEqual(table["newton"]["status"], "converged", case)
        found = {solver: [table[solver]["status"] for table in names["tables"].values()].count("converged") for solver in ("textbook", "shifted")}
        self.assertEqual(found, {"textbook": 2, "shifted": 4})
        for case, distances in names["distances"].items():
            self.assertLess(max(distances.values()), 1e-3, case)


if __name__ == "__main__":
    unittest.main()
