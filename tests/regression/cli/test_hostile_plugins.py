# SPDX-License-Identifier: BSD-3-Clause
"""Plugins that crash, end the program or never come back: each must be named, and earlier results kept."""
import os
import signal
import subprocess
import unittest
from pathlib import Path

import h5py

from program import LINE, SOURCE, InFreshFolder

PLUGINS = Path(os.environ["NETLOFT_TEST_PLUGINS"])
AT_START = PLUGINS.parent / "hostile"

# A line of 10 m with an element of a type that is inserted.
EVIL_LINE = LINE + '%s\n[results]\nlow = { of = "line.end", take = "z" }\n'


class Hostile(InFreshFolder):
    TELLS = {**os.environ, "HOSTILE_TELLS": "1"}

    def scene(self, element=None):
        part = f'[parts.evil]\ntype = "hostile/{element}"\non = "line.end"\n' if element else ""
        self.write("line.toml", EVIL_LINE % part)
        return ["line.toml", "--plugins", str(PLUGINS), "-o", "r.hdf"]

    def wait_until_it_loops(self, run):
        """Waits until a run with the environment TELLS says that it loops."""
        self.addCleanup(run.kill)
        for line in run.stderr:
            if line == "hostile loops\n":
                return
        self.fail("it ended by itself")

    def left(self):
        return sorted(p.name for p in self.folder.iterdir() if p.name != "line.toml")


class Crashes(Hostile):
    def check(self, element, *sentences):
        run = self.netloft("run", *self.scene(element))
        self.assertEqual(run.code, 1, run.err)
        for sentence in sentences:
            self.assertIn(sentence, run.err)
        self.assertNotIn("r.hdf", self.left())

    def test_are_told_with_the_element_and_its_term(self):
        self.check("crashes", "hostile/crashes crashed in term pull (Segmentation fault)")

    def test_of_the_stack_are_told_as_such(self):
        self.check("overflows", "hostile/overflows crashed in term pull (Segmentation fault): it used up its stack")

    def test_of_the_stack_of_another_thread_are_told_too(self):
        run = self.netloft("run", *self.scene("overflows"), "--threads", "2", "--set", "parts.line.cells=4000")
        self.assertIn("it used up its stack", run.err)

    def test_an_exit_is_no_success(self):
        self.check("exits", "hostile/exits ended the program (exit) in term pull")

    def test_an_exit_in_a_check_is_no_success(self):
        run = self.netloft("test", "hostile/exits", "--plugins", str(PLUGINS))
        self.assertEqual(run.code, 1)
        self.assertIn("hostile/exits ended the program (exit) in its construction or first evaluation", run.err)


class EndlessLoops(Hostile):
    """Each is ended after two seconds, so they run at the same time."""
    LIMIT = ["--set", "analysis.max_seconds=0.2"]
    RUNS = {"element": ["element.toml", *LIMIT], "asks": ["line.toml", "--solver", "hostile/asks", *LIMIT],
            "strategy": ["line.toml", "--strategy", "hostile/insists", *LIMIT],
            "interrupted": ["line.toml", "--solver", "hostile/stalls"]}

    def setUp(self):
        super().setUp()
        self.scene()
        self.write("element.toml", EVIL_LINE % '[parts.evil]\ntype = "hostile/loops"\non = "line.end"\n')
        self.runs = {name: subprocess.Popen(
            self.command("run", *words, "--plugins", str(PLUGINS), "-o", f"{name}.hdf"), cwd=self.folder,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.TELLS) for name, words in self.RUNS.items()}

    def end_of(self, name, code, *sentences):
        out, err = self.runs[name].communicate(timeout=60)
        self.assertEqual(self.runs[name].returncode, code, err)
        for sentence in sentences:
            self.assertIn(sentence, err)
        return out

    def check_kept(self, name):
        with h5py.File(self.folder / f"{name}.hdf") as f:
            self.assertEqual(f["VTKHDF/NumberOfPoints"][0], 5)
            self.assertIn("did not return", f["netloft/status"].attrs["sentence"])

    def test_end_with_a_name_and_keep_what_was_found(self):
        self.wait_until_it_loops(self.runs["interrupted"])
        self.runs["interrupted"].send_signal(signal.SIGINT)
        self.end_of("element", 3, "hostile/loops, term pull, did not return", "analysis.max_seconds")
        out = self.end_of("asks", 3, "hostile/asks, solve, did not return")
        self.assertIn("not converged", out)
        self.check_kept("asks")
        self.end_of("strategy", 3, "hostile/insists, run, did not return")
        out = self.end_of("interrupted", 130, "hostile/stalls, solve, did not return", "after the interruption")
        self.assertIn("interrupted", out)
        self.check_kept("interrupted")


class EndlessLoopsElsewhere(Hostile):
    """Every other command that calls plugins ends likewise."""
    LIMIT = "analysis.max_seconds=0.2"

    def ends(self, code, *words, says, out=""):
        run = self.netloft(*words, "--plugins", str(PLUGINS))
        self.assertEqual(run.code, code, run.err)
        self.assertRegex(run.err, says)
        self.assertIn(out, run.out)

    def test_in_a_comparison(self):
        self.scene()
        self.ends(3, "compare", "line.toml", "--solver", "newton", "--solver", "hostile/asks", "--set", self.LIMIT,
                  says=r"hostile/asks, solve, did not return for \d+ s .*; the comparison ends here without a table")

    def test_in_a_comparison_for_a_program(self):
        self.scene()
        run = self.netloft("compare", "line.toml", "--solver", "hostile/stalls", "--set", self.LIMIT, "--plugins", str(PLUGINS), "--json")
        self.assertEqual(run.code, 3, run.err)
        self.assertEqual(run.json()["status"], "not converged")
        self.assertIn("hostile/stalls, solve, did not return", run.json()["reason"])

    def test_in_a_refinement(self):
        self.scene()
        self.ends(3, "refine", "line.toml", "--solver", "hostile/stalls", "--set", self.LIMIT,
                  says=r"hostile/stalls, solve, did not return for \d+ s .*; the refinement ends here without a table")

    def test_in_the_suite_which_shows_what_it_has(self):
        self.ends(3, "hard_cases", str(SOURCE / "tests/stability"), "--solver", "newton", "--solver", "hostile/stalls", "--case", "hanging",
                  "--size", "small", "--seconds-per-case", "0.2",
                  says=r"hostile/stalls, solve, did not return for \d+ s .*; the suite ends here, after 0 of its cases", out="stability, seed 1")

    def test_in_a_study(self):
        self.scene("loops")
        self.write("s.toml", 'scene = "line.toml"\npath = []\nset = ["%s"]\n[variables.g]\nkey = "water.gravity"\nvalues = [9, 10]\n' % self.LIMIT)
        self.ends(0, "study", "plan", "s.toml", says="^")
        says = r"hostile/loops, term pull, did not return for \d+ s .*; item 1 has no record"
        self.ends(1, "study", "run", "s.study", says="item 1: the worker ended with exit code 3: " + says)
        self.assertRegex(next((self.folder / "s.study" / "items").glob("*.failed")).read_text(), "hostile/loops, term pull, did not return")

    def calibration(self, solver):
        self.write("c.toml", '[scenes.a]\nscene = "line.toml"\nset = ["%s", "analysis.solver=%s"]\n[variables.g]\nkey = "water.gravity"\nrange = [9, 10]\n'
                   '[[measured]]\nscene = "a"\nfigure = "results/low"\nvalue = "-10 m"\ndeviation = "1 m"\n' % (self.LIMIT, solver))
        return ["calibrate", "c.toml"]

    def test_in_a_calibration(self):
        self.scene()
        self.ends(3, *self.calibration("hostile/stalls"),
                  says=r"hostile/stalls, solve, did not return for \d+ s .*; the calibration ends here without an answer")

    def test_in_a_calibration_before_its_first_solve(self):
        self.scene("loops")
        self.ends(3, *self.calibration("newton"),
                  says=r"hostile/loops, term pull, did not return for \d+ s .*; the calibration ends here without an answer")

    def test_in_checks(self):
        self.ends(1, "test", "hostile/loops", "--seconds", "0.3",
                  says=r"hostile/loops did not return from (the check [a-z-]+|its construction or first evaluation) within its processor time")

    def test_in_checks_that_are_interrupted(self):
        run = subprocess.Popen(self.command("test", "hostile/loops", "--plugins", str(PLUGINS)), stderr=subprocess.PIPE, text=True,
                               env=self.TELLS)
        self.wait_until_it_loops(run)
        run.send_signal(signal.SIGINT)
        err = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 130)
        self.assertRegex(err, r"hostile\S* was interrupted in ")


class HarmAtTheStart(InFreshFolder):
    def check(self, name, sentence):
        run = self.netloft("test", str(AT_START / f"{name}.so"))
        self.assertEqual(run.code, 4, run.err)
        self.assertIn(f"{name}.so: {sentence}", run.err)

    def test_an_exit_is_told(self):
        self.check("exits_at_once", "ended the program while it was opened")

    def test_no_exit_code_passes_for_an_end(self):
        self.check("ends_with_any_code", "ended the program while it was opened")

    def test_memory_without_end_is_told(self):
        self.check("eats_memory", "needed more than 1024 MiB of memory when it was opened")

    def test_a_word_that_is_nowhere_is_told(self):
        self.check("wild_word", "crashed while it was opened (Segmentation fault)")

    def test_list_goes_on_without_them(self):
        run = self.netloft("list", "--plugins", str(AT_START))
        self.assertIn("rope/bar", run.out)
        for name in ("exits_at_once", "eats_memory", "ends_with_any_code", "wild_word"):
            self.assertIn(f"{name}.so", run.out + run.err)


if __name__ == "__main__":
    unittest.main()
