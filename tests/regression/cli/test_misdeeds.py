# SPDX-License-Identifier: BSD-3-Clause
"""Every function of a plugin with every fault: the run must not succeed nor leave a complete result, and must name the plugin.

The table of functions and faults is made below; tests/support/misdeeds has the plugin. `python3 test_misdeeds.py --table`
prints the table with the answers of the program.
"""
import sys
import unittest

import h5py

from program import InFreshFolder
from test_hostile_plugins import LINE, PLUGINS

FOLDER = PLUGINS.parent / "misdeeds"

ENDS = ["exit", "quick_exit", "_exit", "_Exit", "pthread_exit", "terminate", "abort", "crash", "divide", "recursion"]
ESCAPES = ["throw", "throw_int"]
MODES = ["rounding", "subnormals", "traps"]
BOUNDARY = [*ENDS, *ESCAPES, *MODES]  # what no function of a plugin may do
STATUS = ["error", "no_status"]

# For each function, the component that a command must use to reach it (see SCENES), and its misdeeds besides
# those of BOUNDARY.
FUNCTIONS = {
    "create": ("element", [*STATUS, "endless_words", "wild_fault"]),
    "term": ("element", [*STATUS, "endless_words", "wild_fault", "nan"]),
    "outputs": ("element", []),
    "destroy": ("element", []),
    "law": ("law", [*STATUS, "nan"]),
    "solve": ("solver", ["endless_words", "nan", "nulls", "lie", "no_status"]),
    "step": ("integrator", [*STATUS, "endless_words", "nan", "nothing", "stops", "still_positions", "ignores_forces", "backwards"]),
    "order": ("integrator", []),
    "stable_step": ("integrator", []),
    "run": ("strategy", [*STATUS, "endless_words", "nothing", "wild_stage", "wild_solver"]),
    "explain": ("strategy", [*STATUS, "endless_words", "endless_text"]),
    "describe": ("element", ["error"]),
    "table": ("element", ["null_name", "null_element_name", "null_term_name", "null_create", "null_elements", "null_rows", "null_function",
                          "null_solver_name", "huge_elements", "huge_terms", "huge_parameters", "huge_count", "no_size", "no_element_size",
                          "huge_size", "wild_stencil", "control_characters"]),
}
TABLE = [(function, deed) for function, (_, own) in FUNCTIONS.items()
         for deed in ([] if function == "table" else BOUNDARY) + own] + [("solve", "jump"), ("run", "jump")]
# Misdeeds that are permitted results, which the program judges: its message says that nothing was found, and
# need not name the component, because the user has chosen it.
HONEST = {"term": ["nan"], "law": ["nan"], "solve": ["nan", "nulls", "lie", "endless_words"], "step": ["nan", "error", "endless_words"], "run": ["nothing", "wild_stage", "wild_solver"]}

SCENES = {
    "element": LINE,
    "law": LINE.replace("gravity = 9.81", "gravity = 9.81\ncurrent = [1, 0, 0]").replace("cells = 4", 'cells = 4\ndrag = "misdeeds/law"'),
    "solver": LINE, "strategy": LINE,
    "integrator": LINE + '[analysis]\nkind = "dynamic"\nduration = 0.2\nintegrator = "misdeeds/integrator"\n',
}
WORDS = {"solver": ["--solver", "misdeeds/solver"], "strategy": ["--strategy", "misdeeds/strategy"]}
EVIL = '[parts.evil]\ntype = "misdeeds/element"\non = "line.end"\n'


class Misdeeds(InFreshFolder):
    def run_with(self, function, deed):
        kind = FUNCTIONS[function][0]
        is_jump = deed == "jump"  # over functions of the program, from an element to the method that had it called
        part = EVIL if kind == "element" or is_jump else ""
        self.write("line.toml", SCENES[kind] % part)
        misdeed = "term jump" if is_jump else f"{function} {deed}"
        return self.netloft("run", "line.toml", "--plugins", str(FOLDER), "-o", "r.hdf", "--threads", "1", *WORDS.get(kind, []),
                            environment=self.environment(MISDEED=misdeed))

    def verdict_of(self):
        """What the result file says, if there is one."""
        path = self.folder / "r.hdf"
        if not path.exists():
            return None
        with h5py.File(path) as f:
            return str(f["netloft/status"].attrs["outcome"])

    def clear(self):
        for path in self.folder.iterdir():
            path.unlink()

    def test_without_one_every_component_is_used(self):
        for kind, code in (("element", 0), ("law", 0), ("integrator", 0), ("strategy", 0), ("solver", 3)):
            with self.subTest(kind):
                self.clear()
                self.write("line.toml", SCENES[kind] % (EVIL if kind == "element" else ""))
                run = self.netloft("run", "line.toml", "--plugins", str(FOLDER), "-o", "r.hdf", *WORDS.get(kind, []))
                self.assertEqual(run.code, code, run.err + run.out)

    def test_of_every_function_are_answered(self):
        for function, deed in TABLE:
            with self.subTest(function=function, deed=deed):
                self.clear()
                run = self.run_with(function, deed)
                said = run.err + run.out
                self.assertIn(run.code, (1, 2, 3, 4), said)
                if deed not in HONEST.get(function, []):
                    self.assertIn("misdeeds", said)
                self.assertNotIn("the program itself", said)
                if function != "destroy":  # which is called when the result is whole
                    self.assertIn(self.verdict_of(), (None, "not converged", "not finished"), said)

    def lowest(self, file):
        return self.netloft("report", file, "--json").json()["results"]["low"]

    def test_that_change_no_answer_change_no_verdict(self):
        """A strategy that changes its answer, which the program must notice; and an integrator that overwrites foreign memory."""
        for function, deed in (("run", "lie"), ("run", "nan"), ("run", "calls_itself"), ("step", "nulls")):
            with self.subTest(function=function, deed=deed):
                self.clear()
                self.assertEqual(self.run_with(function, deed).code, 0)
                right = self.netloft("run", "line.toml", "-o", "right.hdf", "--plugins", str(FOLDER))
                self.assertEqual(right.code, 0)
                self.assertAlmostEqual(self.lowest("r.hdf"), self.lowest("right.hdf"), 6)

    def test_are_told_with_the_function(self):
        for function, deed, sentence in (
                ("term", "_exit", "misdeeds/element ended the program (exit) in term pull"),
                ("create", "exit", "misdeeds/element ended the program (exit) in create"),
                ("law", "crash", "misdeeds/law crashed in evaluate (Segmentation fault)"),
                ("law", "rounding", "misdeeds/law left another floating-point mode"),
                ("term", "throw", "misdeeds/element let an exception out of term pull: unfinished"),
                ("run", "pthread_exit", "misdeeds/strategy let an exception out of run"),
                ("run", "jump", "misdeeds/strategy jumped over functions of the program (longjmp) in run"),
                ("solve", "traps", "misdeeds/solver left another floating-point mode (rounding, subnormal numbers or traps) behind in solve"),
                ("explain", "endless_text", "the strategy misdeeds/strategy explains what it does with more than"),
                ("explain", "error", "the strategy misdeeds/strategy failed to explain what it does"),
                ("step", "nothing", "the integrator misdeeds/integrator does not follow the equation of motion"),
                ("term", "no_status", "misdeeds/element, term pull returned 77, which is no status")):
            with self.subTest(function=function, deed=deed):
                self.clear()
                run = self.run_with(function, deed)
                self.assertIn(sentence, run.err + run.out)

    def test_are_no_success_in_checks(self):
        for function, (kind, _) in FUNCTIONS.items():
            for deed in ("_exit", "pthread_exit", "throw", "rounding") if function not in ("table", "order", "stable_step") else ():
                with self.subTest(function=function, deed=deed):
                    run = self.netloft("test", str(FOLDER / "misdeeds.so"), environment=self.environment(MISDEED=f"{function} {deed}"))
                    self.assertIn(run.code, (1, 4), run.err + run.out)


def print_table():
    test = Misdeeds()
    for function, deed in TABLE:
        test.setUp()
        run = test.run_with(function, deed)
        lines = [line for line in (run.err + run.out).splitlines() if "misdeeds" in line] or (run.err + run.out).splitlines() or [""]
        print(f"| {function} | {deed} | {run.code} | {test.verdict_of() or 'none'} | {lines[0][:150]} |", flush=True)
        test.doCleanups()


if __name__ == "__main__":
    print_table() if "--table" in sys.argv else unittest.main()
