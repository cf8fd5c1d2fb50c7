# SPDX-License-Identifier: BSD-3-Clause
"""Reports of progress: one line in a terminal, lines in a log, events for programs."""
import json
import os
import pty
import re
import subprocess
import unittest

from program import SOURCE, InFreshFolder, write_many_parts

PANEL = str(SOURCE / "gear-library/scenes/dead-weight-panel.toml")
NEVER = ["--set", "parts.net.cells=[200,200]", "--set", "analysis.tolerance=1e-16"]
VARIABLE = '[variables.density]\nkey = "parts.net.twine.density"\nrange = ["1000 kg/m3", "1300 kg/m3"]\n'


class Progress(InFreshFolder):
    def started(self, *words, **streams):
        process = subprocess.Popen(self.command(*words), cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   env=self.environment(TERM="xterm"), **streams)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def first_line(self, *words):
        return self.started(*words, stderr=subprocess.PIPE).stderr.readline().decode()

    def test_a_terminal_has_one_line_that_is_written_again_and_again(self):
        ours, its = pty.openpty()
        self.addCleanup(os.close, ours)
        self.started("run", PANEL, *NEVER, stderr=its)
        os.close(its)
        said = b""
        while said.count(b"\r") < 4:
            said += os.read(ours, 4096)
        self.assertNotIn(b"\n", said)
        lines = said.decode().split("\r\x1b[K")[1:]
        for line in lines[:-1]:
            self.assertRegex(line, r"^\[=* *\] stage 1, iteration \d+, residual [-+.e\d]+ N of [-+.e\d]+ N, [\d.]+ s gone")
        iterations = [int(re.search(r"iteration (\d+)", line)[1]) for line in lines[:-1]]
        self.assertEqual(iterations, sorted(set(iterations)))

    def test_a_comparison_has_events_for_programs(self):
        event = json.loads(self.first_line("compare", PANEL, *NEVER, "--solver", "newton", "--tolerance", "1e-16:1e-16", "--json"))
        self.assertEqual(event["event"], "progress")

    def test_meshing_names_the_panel_and_counts_nodes(self):
        words = ("draw", str(SOURCE / "gear-library/gears/two-panel.toml"), "--mesh", "--nodes", "900000", "-o", "a.svg")
        event = json.loads(self.first_line(*words, "--json"))
        self.assertEqual(event["event"], "progress")
        self.assertGreater(event["nodes"], 1000)
        self.assertGreaterEqual(event["seconds"], 2)
        self.assertRegex(self.first_line(*words), r'^progress meshing="[\w-]+" nodes=\d+ seconds=[\d.]+$')

    def test_reading_names_the_part_and_counts_parts(self):
        write_many_parts(self.folder, 100000)
        event = json.loads(self.first_line("plan", "scene.toml", "--json"))
        self.assertEqual(event["event"], "progress")
        self.assertIn("reading", event)
        self.assertGreaterEqual(event["seconds"], 2)

    def test_a_study_counts_its_items(self):
        self.write("s.toml", f'scene = "{PANEL}"\n{VARIABLE}[design]\nsamples = 200\n')
        self.assertEqual(self.netloft("study", "plan", "s.toml").code, 0)
        event = json.loads(self.first_line("study", "run", "s.study", "--jobs", "1", "--json"))
        self.assertEqual((event["event"], event["of"]), ("progress", 200))
        self.assertTrue(1 <= event["items"] < 200, event)
        self.assertRegex(self.first_line("study", "run", "s.study", "--jobs", "1"), r"^progress items=\d+ of=\d+ seconds=[\d.]+( left=\d+)?$")

    def test_a_calibration_counts_its_solves(self):
        self.write("c.toml", f'[scenes.one]\nscene = "{PANEL}"\nset = ["parts.net.cells=[60,60]"]\n{VARIABLE}'
                   '[[measured]]\nscene = "one"\nfigure = "results/lowest_z"\nvalue = -5\ndeviation = 0.001\n')
        event = json.loads(self.first_line("calibrate", "c.toml", "--json"))
        self.assertEqual((event["event"], event["of"]), ("progress", None))
        self.assertGreaterEqual(event["solves"], 1)


if __name__ == "__main__":
    unittest.main()
