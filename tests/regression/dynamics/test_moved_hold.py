#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A hold that moves through given points: it stays at rest between two equal points, and overshoots none.

    test_moved_hold.py NETLOFT SOURCE_FOLDER
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT = sys.argv[1]
SCENE = """
[parts.rope]
type = "rope/bar"
length = 5
cells = 2
sketch = [[0, 0, 0], [0, 0, -5]]
rope = { diameter = "20 mm", EA = "50 kN", density = 3000 }
[[hold]]
on = "rope.start"
displacement = { t = [0, 1, 3, 4, 6], z = [0, 0, 0.3, 0.3, 0] }
[analysis]
kind = "dynamic"
duration = 6
output_interval = 0.1
[results]
hold = { of = "rope.start", take = "z" }
"""


class MovedHold(unittest.TestCase):
    def test_stays_between_points_that_are_alike_and_does_not_overshoot(self):
        with tempfile.TemporaryDirectory() as folder:
            scene, result = Path(folder) / "scene.toml", Path(folder) / "result.hdf"
            scene.write_text(SCENE)
            subprocess.run([NETLOFT, "run", scene, "-o", result], check=True, capture_output=True)
            with h5py.File(result) as f:
                t = f["VTKHDF/Steps/Values"][()]
                z = np.array([f["VTKHDF/Points"][first][2] for first in f["VTKHDF/Steps/PointOffsets"][()]])
        at = lambda first, last: z[(t >= first - 1e-9) & (t <= last + 1e-9)]
        np.testing.assert_allclose(at(0, 1), 0, atol=1e-12)
        np.testing.assert_allclose(at(3, 4), 0.3, atol=1e-12)
        self.assertTrue((np.diff(at(1, 3)) > 0).all())
        self.assertTrue((np.diff(at(4, 6)) < 0).all())
        # Between two points at rest the curve is the cubic 3 s^2 - 2 s^3.
        s = (t[(t >= 1) & (t <= 3)] - 1) / 2
        np.testing.assert_allclose(z[(t >= 1) & (t <= 3)], 0.3 * (3 * s**2 - 2 * s**3), atol=1e-12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
