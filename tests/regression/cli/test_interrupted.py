# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C while a command solves many scenes: it must report it, end with 130, show its results so far and replace no file."""
import json
import os
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program import SOURCE, InFreshFolder, write_many_parts

PANEL = str(SOURCE / "gear-library/scenes/dead-weight-panel.toml")
AT_SEA = str(SOURCE / "gear-library/scenes/gov-like-67m.toml")
NEVER = ["--set", "parts.net.cells=[200,200]", "--set", "analysis.tolerance=1e-16"]
FULL_DISK = os.environ.get("NETLOFT_FULL_DISK", "")
KEPT = ("kept.csv", "kept.svg", "kept.html")
VARIABLE = '[variables.density]\nkey = "parts.net.twine.density"\nrange = ["1000 kg/m3", "1300 kg/m3"]\n'


def catches_interrupts(pid):
    caught = next(line for line in Path(f"/proc/{pid}/status").read_text().splitlines() if line.startswith("SigCgt:"))
    return bool(int(caught.split()[1], 16) & 1 << signal.SIGINT - 1)


def seconds_of(pid):
    """Processor time of a process so far [s]."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Interrupted(InFreshFolder):
    def setUp(self):
        super().setUp()
        for name in KEPT:
            self.write(name, "earlier")

    def interrupted(self, *words, is_due=lambda line: b"progress" in line and b"assembling" not in line):
        """Standard output and error of a command that is interrupted at the first line of standard error for which `is_due` holds."""
        process = subprocess.Popen(self.command(*words), cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, env=self.environment())
        self.addCleanup(process.kill)
        said = b""
        while line := process.stderr.readline():
            said += line
            if is_due(line):
                break
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 130, said + err)
        self.assertRegex(said + err, rb"(^|\n)netloft: interrupted; ")
        for name in KEPT:
            self.assertEqual((self.folder / name).read_text(), "earlier")
        return out.decode(), (said + err).decode()

    def test_a_comparison_shows_what_was_tried(self):
        out, err = self.interrupted("compare", PANEL, *NEVER, "--solver", "newton", "--solver", "ptc", "--tolerance", "1e-16:1e-2",
                                    "-o", "kept.csv", "-o", "kept.svg", "--json")
        report = json.loads(out)
        self.assertEqual(report["status"], "interrupted")
        self.assertEqual(report["methods"][0]["method"], "newton")
        self.assertIn("; not written: kept.csv, kept.svg", err)

    def test_a_refinement_shows_the_meshes_that_were_solved(self):
        out, err = self.interrupted("refine", PANEL, "--cells", "2,4,200", "--set", "analysis.tolerance=1e-16", "--json")
        report = json.loads(out)
        self.assertEqual((report["status"], len(report["meshes"]), report["missing"]), ("interrupted", 2, []))
        self.assertIn("the table has 2 of 3 meshes", err)

    def test_a_calibration_says_how_far_it_came(self):
        self.write("c.toml", f'[scenes.one]\nscene = "{PANEL}"\nset = ["parts.net.cells=[60,60]"]\n{VARIABLE}'
                   '[[measured]]\nscene = "one"\nfigure = "results/lowest_z"\nvalue = -5\ndeviation = 0.001\n')
        out, _ = self.interrupted("calibrate", "c.toml", "--json")
        report = json.loads(out)
        self.assertEqual((report["status"], report["reason"]), ("interrupted", "interrupted"))
        self.assertGreaterEqual(report["solves"], 1)

    OPTIMUM = (f'scene = "{PANEL}"\nset = ["parts.net.cells=[60,60]"]\n[variables.density]\nkey = "parts.net.twine.density"\n'
               'range = [1100, 3000]\n[variables.diameter]\nkey = "parts.net.twine.diameter"\nrange = ["5 mm", "15 mm"]\n'
               '[objective]\nmaximise = "results/lowest_z"\nunit = "m"\n'
               '[[constraints]]\nfigure = "results/top_reaction_z"\nat_least = "800 N"\n')

    def points_of(self, folder):
        file = self.folder / folder / "history.jsonl"
        return len(file.read_text().splitlines()) if file.exists() else 0

    def test_an_optimum_goes_on_where_it_ended(self):
        self.write("o.toml", self.OPTIMUM)
        whole = self.netloft("optimise", "o.toml", "--json", "-o", "whole")
        self.assertEqual(whole.code, 0, whole.err)
        process = subprocess.Popen(self.command("optimise", "o.toml"), cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, env=self.environment())
        self.addCleanup(process.kill)
        while self.points_of("o.optimum") < 2 and process.poll() is None:
            time.sleep(0.001)
        process.kill()
        process.communicate()
        self.assertGreaterEqual(self.points_of("o.optimum"), 2)
        again = self.netloft("optimise", "o.toml", "--json")
        self.assertEqual(again.code, 0, again.err)
        a, b = json.loads(whole.out), json.loads(again.out)
        self.assertEqual(a["points"], b["points"])
        self.assertLess(b["solves"], a["solves"])
        self.assertAlmostEqual(a["objective"]["after"], b["objective"]["after"], 6)

    def test_an_optimum_shows_the_best_point(self):
        self.write("o.toml", self.OPTIMUM)
        out, err = self.interrupted("optimise", "o.toml", "--json")
        self.assertEqual(json.loads(out)["status"], "interrupted")
        self.assertIn("call it again to go on", err)
        self.assertFalse((self.folder / "o.optimum/scene.toml").exists())

    def test_a_scope_table_shows_the_lengths_that_were_solved(self):
        out, err = self.interrupted("scope", AT_SEA, "--set", "gear.nodes=600", "--depth", "65:67:9", "--warp", "3.2:3.5:9", "-o",
                                    "kept.svg", "--json")
        report = json.loads(out)
        self.assertEqual(report["status"], "interrupted")
        points = [p for row in report["rows"] for p in row["points"]]
        self.assertTrue(1 <= len(points) < 81, points)
        self.assertEqual([p["why_not"] for p in points], [None] * len(points))
        self.assertIn("of 9 depths, and kept.svg is not written", err)

    def test_sensitivities_show_the_numbers_that_were_examined(self):
        out, err = self.interrupted("sensitivity", AT_SEA, "--set", "gear.nodes=2000", "-o", "kept.svg", "--json",
                                    is_due=lambda line: b"numbers" in line)
        report = json.loads(out)
        self.assertEqual(report["status"], "interrupted")
        self.assertGreaterEqual(len(report["numbers"]), 1)
        self.assertIn("numbers were examined, and kept.svg is not written", err)

    def test_a_run_is_written_without_sensitivities(self):
        process = subprocess.Popen(self.command("run", AT_SEA, "--set", "gear.nodes=2000", "--sensitivities", "-o", "run.hdf", "--json"),
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=self.environment())
        self.addCleanup(process.kill)
        while line := process.stderr.readline():
            if b"numbers" in line:
                break
        process.send_signal(signal.SIGINT)
        report = json.loads(process.communicate(timeout=100)[0])
        self.assertEqual((process.returncode, report["status"]), (130, "converged"))
        self.assertRegex(report["sensitivities"]["note"], r"^not known, because the run was interrupted: \d+ of \d+ numbers were examined$")
        self.assertEqual(self.netloft("report", "run.hdf", "--json").json(), report)

    def test_a_suite_shows_the_cases_that_were_solved(self):
        out, err = self.interrupted("hard_cases", str(SOURCE / "tests/stability"), "--solver", "newton", "--size", "small", "-o", "kept.html",
                                    is_due=lambda line: line.strip())
        self.assertRegex(err, r"interrupted; the suite ends here, after [1-9]\d* of its cases")
        self.assertIn("right", out)

    def test_a_study_says_how_to_go_on(self):
        self.write("s.toml", f'scene = "{PANEL}"\nset = ["parts.net.cells=[60,60]"]\n{VARIABLE}[design]\nsamples = 50\n')
        self.assertEqual(self.netloft("study", "plan", "s.toml").code, 0)
        out, err = self.interrupted("study", "run", "s.study", "--jobs", "1", "--json")
        done = json.loads(out)["computed"]
        self.assertIn(f"{50 - done} of 50 items left; `netloft study run s.study` computes them", err)

    def test_an_item_alone_says_so_too(self):
        self.write("s.toml", f'scene = "{PANEL}"\nset = ["parts.net.cells=[200,200]", "analysis.tolerance=1e-16"]\n{VARIABLE}'
                   '[design]\nsamples = 2\n')
        self.assertEqual(self.netloft("study", "plan", "s.toml").code, 0)
        process = subprocess.Popen(self.command("study", "run", "s.study", "--items", "1"), cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=self.environment())
        self.addCleanup(process.kill)
        while seconds_of(process.pid) < 0.5:  # it reads for a tenth of that, and solves for minutes
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn(b"netloft: interrupted; 1 of 1 item left; `netloft study run s.study` computes them", err)

    def run_with(self, **faults):
        """A run of the panel over an earlier result, with faults of tests/support/full_disk."""
        return self.netloft("run", PANEL, "-o", "p.hdf", "--json", environment=self.environment(
            LD_PRELOAD=FULL_DISK, **{f"NETLOFT_{name}": str(value) for name, value in faults.items()}))

    def deeds_of_a_run(self):
        self.assertEqual(self.run_with(FAIL_WRITE=0, COUNT_FILE=self.folder / "count").code, 0)
        count = int((self.folder / "count").read_text().split()[1])
        (self.folder / "count").unlink()
        return count

    @unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
    def test_a_result_that_takes_long_to_write_is_left_out(self):
        deeds = self.deeds_of_a_run()
        before = self.files()
        for number in (signal.SIGINT, signal.SIGTERM):
            ended = self.run_with(SIGNAL_AT=deeds // 2, SIGNAL=int(number), SLOW_WRITES=200)
            self.assertEqual(ended.code, 130, ended.err)
            self.assertEqual(ended.json()["status"], "interrupted")
            self.assertIn("netloft: interrupted; the result is not written", ended.err)
            self.assertEqual(self.files(), before)

    @unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
    def test_a_result_that_is_nearly_written_is_kept(self):
        deeds = self.deeds_of_a_run()
        earlier = self.files()["p.hdf"]
        for at in (deeds // 2, deeds - 3):
            ended = self.run_with(SIGNAL_AT=at, SIGNAL=int(signal.SIGINT))
            self.assertEqual(ended.code, 0, ended.err)
            self.assertEqual(self.files()["p.hdf~"], earlier)
            earlier = self.files()["p.hdf"]
            self.assertEqual(self.netloft("report", "p.hdf").code, 0)

    def stopped_at(self, deed, number, *words):
        """Output of a command that gets a signal at this system call; it must react within a second of processor time."""
        process = subprocess.Popen(self.command(*words, "--json"), cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, env=self.environment())
        self.addCleanup(process.kill)
        while deed not in (line := process.stderr.readline()):
            self.assertTrue(line, "it ended by itself")
        before = seconds_of(process.pid)
        process.send_signal(number)
        out, err = process.stdout.read().decode(), process.stderr.read().decode()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 130, out + err)
        self.assertLess(used.ru_utime + used.ru_stime - before, 1)
        return out, err

    def test_a_scene_that_is_read_after_others_is_left_as_well(self):
        """Then there are results to save, so that the signal must not end the program at once."""
        scene = str(SOURCE / "gear-library/scenes/two-panel.toml")
        for number in (signal.SIGINT, signal.SIGTERM):
            out, err = self.stopped_at(b'"meshing"', number, "refine", scene, "--nodes", "100,900000")
            self.assertEqual(json.loads(out)["status"], "interrupted", err)
            self.assertRegex(err, "the table has 1 of 2 meshes|the refinement ends here without a table")

    def test_a_scene_of_very_many_parts_is_left(self):
        write_many_parts(self.folder, 100000)
        for number in (signal.SIGINT, signal.SIGTERM):
            out, err = self.stopped_at(b'"reading"', number, "plan", "scene.toml")
            self.assertEqual(json.loads(out)["status"], "interrupted", err)

    def test_a_scene_that_is_being_read_is_left(self):
        """It has so many nodes that meshing takes long enough to be interrupted."""
        scene = str(SOURCE / "gear-library/scenes/two-panel.toml")
        self.write("c.toml", f'[scenes.one]\nscene = "{scene}"\nset = ["gear.nodes=300000"]\n[variables.v]\nkey = "water.density"\n'
                             'range = [1000, 1030]\n[[measured]]\nscene = "one"\nfigure = "gear/headline_height"\nvalue = 1\ndeviation = 1\n')
        self.write("s.toml", f'scene = "{scene}"\nset = ["gear.nodes=300000"]\n[variables.v]\nkey = "water.density"\nvalues = [1000, 1030]\n')
        large = [scene, "--set", "gear.nodes=300000"]
        for words in (["run", *large, "-o", "kept.hdf"], ["run", *large, "-o", "kept.hdf", "--json"], ["plan", *large], ["refine", *large],
                      ["compare", *large, "--solver", "newton"], ["scope", *large, "--depth", "20:40"], ["calibrate", "c.toml"],
                      ["study", "plan", "s.toml"],
                      ["draw", str(SOURCE / "gear-library/gears/two-panel.toml"), "--mesh", "--nodes", "300000", "-o", "kept.svg"]):
            json_asked = "--json" in words
            process = subprocess.Popen(self.command(*words), cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       env=self.environment())
            self.addCleanup(process.kill)
            while not catches_interrupts(process.pid):
                self.assertIsNone(process.poll(), "it ended by itself")
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=100)
            self.assertEqual(process.returncode, 130, err)
            self.assertIn(b"netloft: interrupted; nothing has been solved", err)
            self.assertEqual(json.loads(out)["status"] if json_asked else out, "interrupted" if json_asked else b"")
        self.assertFalse((self.folder / "kept.hdf").exists())


if __name__ == "__main__":
    unittest.main()
