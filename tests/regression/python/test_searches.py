# SPDX-License-Identifier: BSD-3-Clause
"""Optimisations and calibrations in Python are those of the command line."""
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import netloft

PROGRAM, SOURCE = os.environ["NETLOFT_PROGRAM"], Path(os.environ["NETLOFT_SOURCE_DIR"])
PAGE = (SOURCE / "io/studies/STUDY.md").read_text()
LEAST_DRAG = re.search(r"^```toml least-drag.toml\n(.*?)^```", PAGE, re.M | re.S)[1].replace("gear-library", str(SOURCE / "gear-library"))
ROPE = SOURCE / "gear-library/scenes/hanging-rope.toml"
LENGTH = f"""
[scenes.rope]
scene = "{ROPE}"
[variables.length]
key = "parts.rope.length"
range = ["9 m", "11 m"]
[[measured]]
scene = "rope"
figure = "results/sag_z"
value = "{{}} m"
deviation = "1 mm"
"""


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name) / "search.toml"

    def by_program(self, command, *options):
        words = [PROGRAM, command, self.path, "--json", *options]
        return json.loads(subprocess.run(words, capture_output=True, text=True, cwd=self.folder.name, check=True).stdout)


class AnOptimum(Files):
    def test_is_that_of_the_command_line(self):
        self.path.write_text(LEAST_DRAG)
        found = netloft.optimise(self.path, folder=Path(self.folder.name) / "own")
        self.assertEqual(found.to_dict(), self.by_program("optimise", "-o", "by-program"))
        self.assertEqual(found.values["across"].unit, "m")
        again = found.scene.solve().report
        self.assertAlmostEqual(again["drag/all/x"] / 1000 / found.objective, 1, delta=0.01)  # its mesh is made anew
        self.assertGreater(again["mouth/headline_height"], 1.98)

    def test_goes_on_where_it_was(self):
        self.path.write_text(LEAST_DRAG)
        first = netloft.optimise(self.path, folder=self.folder.name)
        second = netloft.optimise(self.path, folder=self.folder.name)
        self.assertGreater(first.to_dict()["solves"], 1)
        self.assertEqual(second.to_dict()["solves"], 0)
        self.assertEqual(dict(first.values), dict(second.values))

    def test_without_a_feasible_point_says_so(self):
        self.path.write_text(LEAST_DRAG.replace('at_least = "2 m"', 'at_least = "9 m"'))
        with self.assertRaisesRegex(netloft.NotConverged, "infeasible"):
            netloft.optimise(self.path)
        self.assertEqual(netloft.optimise(self.path, raises=False).status, "infeasible")


class ACalibration(Files):
    def test_finds_what_was_measured(self):
        scene = netloft.load(ROPE)
        length = 1.01 * float(scene.numbers["parts.rope.length"])
        sag = scene.with_({"parts.rope.length": length}).solve().report["sag_z"]
        self.path.write_text(LENGTH.format(float(sag)))
        found = netloft.calibrate(self.path)
        self.assertAlmostEqual(found.values["length"], length, places=4)
        self.assertGreater(found.deviations["length"], 0)
        self.assertAlmostEqual(found.scenes["rope"].solve().report["sag_z"], sag, places=4)
        by_program = self.by_program("calibrate")
        self.assertEqual({**found.to_dict(), "cpu_seconds": 0}, {**by_program, "cpu_seconds": 0})


class AMistake(Files):
    def test_in_a_file_is_answered_as_on_the_command_line(self):
        self.path.write_text(LEAST_DRAG.replace("minimise", "minimize"))
        with self.assertRaisesRegex(netloft.WrongInput, "did you mean"):
            netloft.optimise(self.path)
        self.path.write_text(LENGTH.format(1).replace("results/sag_z", "results/sag_y"))
        with self.assertRaisesRegex(netloft.WrongInput, "sag_y"):
            netloft.calibrate(self.path)
        for search in (netloft.optimise, netloft.calibrate):
            with self.assertRaisesRegex(FileNotFoundError, "no such file"):
                search("/nowhere/search.toml")


if __name__ == "__main__":
    unittest.main()
