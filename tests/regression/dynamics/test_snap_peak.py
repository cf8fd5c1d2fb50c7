#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A ball that falls on a slack rope: the peak of the tension by each time scheme, compared with the closed form of an elastic rope.

    test_snap_peak.py NETLOFT SOURCE_FOLDER

T = m g + sqrt((m g)^2 + k m v^2), k = EA/l, from the energy of the ball when the rope comes taut at speed v.
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT = sys.argv[1]
LENGTH, EA, MASS, GRAVITY, FALL = 1, 2e5, 5, 9.81, 0.5
SNAP = f"""
[water]
density = 0
gravity = {GRAVITY}
[parts.rope]
type = "rope/bar"
length = {LENGTH}
cells = 1
sketch = [[0, 0, 0], [0, 0, {FALL - LENGTH}]]
rope = {{ diameter = "5 mm", EA = {EA}, EA_compression = 0, density = 1e-3 }}
[parts.ball]
type = "float/float"
on = "rope.end"
float = {{ mass = {MASS}, volume = 0 }}
[[hold]]
on = "rope.start"
[analysis]
kind = "dynamic"
duration = 0.34  # it is caught at 0.3193 s, and the rope is longest 7.9 ms later
output_interval = 1e-4
dense = true
accuracy = 1e-3
"""
SCHEMES = {
    "generalized-alpha": [],
    "generalized-alpha, radius 0.8": ["generalized-alpha.spectral_radius=0.8"],  # once went through the taut rope in one step
    "newmark": [],
    "central-difference": [],
    "energy-momentum": [],
    "arkode": [],
}


class SnapPeak(unittest.TestCase):
    def peak(self, scheme, settings):
        with tempfile.TemporaryDirectory() as folder:
            scene, out = Path(folder) / "snap.toml", Path(folder) / "snap.hdf"
            scene.write_text(SNAP)
            words = [NETLOFT, "run", scene, "--threads", "1", "-o", out, "--set", f"analysis.integrator={scheme.split(',')[0]}"]
            for setting in settings:
                words += ["--set", f"analysis.{setting}"]
            ended = subprocess.run(words, capture_output=True, text=True, check=False)
            if 'there is no plugin "arkode"' in ended.stderr:
                self.skipTest("built without SUNDIALS")
            self.assertEqual(ended.returncode, 0, ended.stderr + ended.stdout)
            with h5py.File(out) as f:
                points, count = f["VTKHDF/Points"][()], f["VTKHDF/NumberOfPoints"][0]
                lowest = min(points[first:first + count, 2].min() for first in f["VTKHDF/Steps/PointOffsets"][()])
        return EA * (-lowest / LENGTH - 1)

    def test_is_that_of_an_elastic_rope_within_two_per_cent(self):
        weight, k, v = MASS * GRAVITY, EA / LENGTH, np.sqrt(2 * GRAVITY * FALL)
        expected = weight + np.sqrt(weight**2 + k * MASS * v**2)
        for scheme, settings in SCHEMES.items():
            with self.subTest(scheme):
                off = self.peak(scheme, settings) / expected - 1
                print(f"{scheme}: {off:+.4%}")
                self.assertLess(abs(off), 0.02)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
