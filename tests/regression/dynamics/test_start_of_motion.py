#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Starts of motions: the static equilibrium, in which a motion stays, or the positions of a result.

    test_start_of_motion.py NETLOFT SOURCE_FOLDER
"""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SCENES = sys.argv[1], Path(sys.argv[2]) / "gear-library" / "scenes"
BRIDLES = [f"{side}-{which}" for side in ("starboard", "port") for which in ("upper", "lower")]
COARSE = [f"parts.{part}{i}.cells=[6,6]" for part in ("upper", "lower") for i in (1, 2, 3, 4)] \
       + [f"parts.{rope}.cells=6" for rope in ("headline", "footrope")]
STEPS = ["analysis.longest_step=0.5", "analysis.tolerance=1e-5", "analysis.dense=true", "analysis.output_interval=1"]
STATIC = ["analysis.kind=static", "analysis.tolerance=1e-10"]
DRIFT = 1e-6  # of the gear's size, in 10 s


def towed_steadily():
    """The trawl of trawl-speeds-up, whose ship does not speed up."""
    folder = SCENES / "dynamics" / "trawl-speeds-up"
    holds = "".join(f'{{ on = "{bridle}-bridle.start" }},\n' for bridle in BRIDLES)
    return (f'include = ["{folder}/mesh.toml", "{SCENES}/validation/small-trawl/properties.toml"]\nhold = [\n{holds}]\n'
            '[analysis]\nkind = "dynamic"\nstart = "equilibrium"\nduration = 10\n')


class StartOfMotion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.trawl = self.file("trawl.toml")
        self.trawl.write_text(towed_steadily())

    def file(self, name):
        return Path(self.folder.name) / name

    def ask(self, scene, output, settings):
        words = [NETLOFT, "run", scene, "--json", "--threads", "1", "-o", self.file(output)]
        for setting in settings:
            words += ["--set", setting]
        return subprocess.run(words, capture_output=True, text=True, check=False)

    def run_to_the_end(self, *words):
        ended = self.ask(*words)
        self.assertEqual(ended.returncode, 0, ended.stderr + ended.stdout)
        return json.loads(ended.stdout)

    def places(self, output):
        """Positions of all nodes, state by state."""
        with h5py.File(self.file(output)) as f:
            points, count = f["VTKHDF/Points"][()], f["VTKHDF/NumberOfPoints"][0]
            if "Steps" not in f["VTKHDF"]:
                return points[None]
            return np.array([points[first:first + count] for first in f["VTKHDF/Steps/PointOffsets"][()]])

    def assert_stays(self, motion, start):
        at, found = self.places(motion), self.places(start)[-1]
        size = np.max(found.max(axis=0) - found.min(axis=0))
        self.assertEqual(len(at), 11)
        self.assertLess(np.abs(at - found).max() / size, DRIFT)

    def test_is_the_equilibrium_of_statics_to_the_last_bit_and_stays_there(self):
        self.run_to_the_end(self.trawl, "static.hdf", COARSE + STATIC)
        for scheme in ("generalized-alpha", "newmark"):
            with self.subTest(scheme=scheme):
                name = scheme + ".hdf"
                answer = self.run_to_the_end(self.trawl, name, COARSE + STEPS + ["analysis.integrator=" + scheme])
                self.assertGreaterEqual(answer["steps"], 20)
                self.assertLess(answer["start"]["out_of_balance"], 1e-10 * answer["start"]["largest_load"])
                self.assertEqual(self.places(name)[0].tobytes(), self.places("static.hdf")[-1].tobytes())
                self.assert_stays(name, "static.hdf")

    def test_is_where_a_result_has_the_gear(self):
        self.run_to_the_end(self.trawl, "static.hdf", COARSE + STATIC)
        answer = self.run_to_the_end(self.trawl, "moved.hdf", COARSE + STEPS + ["analysis.start=static.hdf"])
        self.assertLess(answer["start"]["out_of_balance"], 1e-8 * answer["start"]["largest_load"])
        self.assert_stays("moved.hdf", "static.hdf")

    def test_is_where_the_last_state_of_a_motion_has_the_gear(self):
        short = ["analysis.duration=0.2", "analysis.output_interval=0.1"]
        panel = SCENES / "dynamics" / "hanging-panel.toml"
        self.run_to_the_end(panel, "first.hdf", short)
        begun = self.run_to_the_end(panel, "second.hdf", short + [f"analysis.start={self.file('first.hdf')}"])
        np.testing.assert_allclose(self.places("second.hdf")[0], self.places("first.hdf")[-1], atol=1e-12)
        self.assertGreater(begun["start"]["out_of_balance"], 1)

    def test_on_another_mesh_says_how_far_from_rest_it_is(self):
        short = ["analysis.duration=0.1", "analysis.output_interval=0"]
        panel = SCENES / "dynamics" / "hanging-panel.toml"
        self.run_to_the_end(panel, "coarse.hdf", STATIC + ["parts.net.cells=[8,8]"])
        started = short + [f"analysis.start={self.file('coarse.hdf')}"]
        distance = {}
        for cells in (8, 16):
            answer = self.run_to_the_end(panel, f"on{cells}.hdf", started + [f"parts.net.cells=[{cells},{cells}]"])
            distance[cells] = answer["start"]["out_of_balance"] / answer["start"]["largest_load"]
        self.assertLess(distance[8], 1e-8)
        self.assertGreater(distance[16], 1e-3)

    def test_of_a_whole_gear_is_that_of_its_half(self):
        """The start is as near as both meshes permit; the equilibrium found from it equals that found from the sketch, to the printed digits."""
        gear, fine = self.file("undisturbed.toml"), ["gear.nodes=250", "analysis.tolerance=1e-9"]
        said = (SCENES / "83-112-flume-3.0kn.toml").read_text()  # a motion has no water that the net slows
        gear.write_text(re.sub(r"include = .*", f'include = ["{SCENES}/83-112-flume/common.toml"]', said)
                        + '[elements.netting]\ndrag = { law = "hydro/netting-twine", cylinder = "takagi", shielding = 0.85 }\n')
        of_whole = ["gear.extent=whole", 'hold=[{on="starboard-towing-point"},{on="port-towing-point"}]']
        self.run_to_the_end(gear, "half.hdf", fine)
        whole = self.run_to_the_end(gear, "whole.hdf", fine + of_whole)
        moment = fine + of_whole + ["analysis.kind=dynamic", "analysis.duration=0.001", "analysis.output_interval=0"]
        self.run_to_the_end(gear, "begun.hdf", moment + [f"analysis.start={self.file('half.hdf')}"])
        begun, found = self.places("begun.hdf")[0], self.places("whole.hdf")[-1]
        self.assertLess(np.abs(begun - found).max() / np.max(found.max(axis=0) - found.min(axis=0)), 0.01)
        words = [NETLOFT, "run", gear, "--json", "--threads", "1", "-o", self.file("again.hdf"), "--start-from", self.file("half.hdf")]
        for setting in fine + of_whole:
            words += ["--set", setting]
        again = json.loads(subprocess.run(words, capture_output=True, text=True, check=True).stdout)
        for name, value in whole["results"].items():
            self.assertAlmostEqual(again["results"][name] / value, 1, delta=1e-6)

    def test_is_nowhere_else(self):
        for word, says in (("equilibirum", 'did you mean "equilibrium"?'), ("found", "ends in .hdf"), ('""', "is no shape from which a motion can start"),
                           ("none.hdf", "there is no such file"), ("trawl.toml", "ends in .hdf"), ("3", "a text is expected")):
            with self.subTest(word=word):
                ended = self.ask(self.trawl, "out.hdf", COARSE + [f"analysis.start={word}"])
                self.assertEqual(ended.returncode, 2)
                self.assertIn(says, ended.stderr)
                self.assertFalse(self.file("out.hdf").exists())
        ended = self.ask(self.trawl, "out.hdf", COARSE + ["analysis.start=3"])
        self.assertEqual(ended.stderr.count("error:"), 1, ended.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
