#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A motion in which forces begin and end has a result whose series have a number for every output.

    test_columns_of_motion.py NETLOFT SOURCE_FOLDER
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT = sys.argv[1]
# A weight that is released above a bed; its rope lies on the bed, beginning at its first node.
SCENE = """
[bed]
depth = "10 m"
[bodies.clump]
type = "body/solid"
body = { mass = "100 kg", volume = "0.01 m3", inertia_x = 20, inertia_y = 20, inertia_z = 20 }
at = [0, 0, HEIGHT]
points = { sole = [0, 0, -0.1], eye = [0, 0, 0.1] }
[parts.ground]
type = "seabed/bed"
on = "clump.sole"
seabed = { stiffness = "100 kN/m2" }
[parts.rope]
type = "rope/bar"
length = "2 m"
cells = 2
sketch = [[0, 0, EYE], [2, 0, EYE]]
rope = { diameter = "20 mm", EA = "10 kN", density = 1025, damping = "1 kN s" }
[[join]]
points = ["rope.start", "clump.eye"]
[[hold]]
on = "rope.end"
[analysis]
kind = "dynamic"
duration = 0.8
output_interval = 0.05
accuracy = 0.1
"""
FALLING = SCENE.replace("HEIGHT", "-9.7").replace("EYE", "-9.6")
LYING = SCENE.replace("HEIGHT", "-9.95").replace("EYE", "-9.85")
ON_SOLE = "netloft/series/gear/body_forces/clump/ground/z"


class ColumnsOfMotion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def force_on_sole(self, scene, *settings):
        file, output = Path(self.folder.name) / "scene.toml", Path(self.folder.name) / "motion.hdf"
        file.write_text(scene)
        words = [NETLOFT, "run", file, "--threads", "1", "--overwrite", "-o", output]
        ended = subprocess.run(words + [word for s in settings for word in ("--set", s)], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        with h5py.File(output) as f:
            return f[ON_SOLE][()], f["VTKHDF/Steps/Values"][()]

    def test_of_a_force_that_comes(self):
        force, times = self.force_on_sole(FALLING)
        self.assertEqual(len(force), len(times))
        self.assertEqual(force[0], 0)
        self.assertGreater(np.nanmax(force), 100)

    def test_of_a_force_that_goes(self):
        """The weight rebounds from a bed into which it was pressed."""
        force, times = self.force_on_sole(LYING)
        self.assertEqual(len(force), len(times))
        self.assertGreater(force[0], 1000)
        self.assertEqual(force.min(), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
