#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Waves move floating bodies as in linear theory, are equal for equal seeds, and wrong waves give errors with places.

    test_waves.py NETLOFT SOURCE_FOLDER
"""
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SCENE = sys.argv[1], Path(sys.argv[2]) / "gear-library" / "scenes" / "dynamics" / "float-in-waves.toml"
GRAVITY, DENSITY, AMPLITUDE, PERIOD, DAMPING = 9.81, 1025, 0.02, 6, 0.3
OMEGA = 2 * math.pi / PERIOD
# A box of 1 m2 that floats half immersed, on a soft line to the bed.
BOX = f"""
[water]
gravity = {GRAVITY}
waves = {{ height = {2 * AMPLITUDE}, period = {PERIOD}, ramp = 12 }}
[parts.line]
type = "rope/bar"
length = "18 m"
cells = 1
sketch = [[0, 0, -20.5], [0, 0, -0.5]]
rope = {{ EA = 18000, diameter = "0.1 mm", density = 1025 }}
[parts.box]
type = "float/box"
on = "line.end"
box = {{ mass = 400, length_x = 1, length_y = 1, height = 1.2, added_mass = 200 }}
[[hold]]
on = "line.start"
[analysis]
kind = "dynamic"
start = "equilibrium"
accuracy = 1e-4
mass_damping = {DAMPING}
duration = 84
output_interval = 0.1
"""
WRONG = {
    "height = 0, period = 6": "height",
    "height = -1, period = 6": "height",
    "period = 6": "height",
    'height = "2 kg", period = 6': "height",
    "height = 1": "period",
    "height = 1, period = 0": "period",
    "height = 9, period = 6": "breaks",
    "height = 1, period = 6, depth = -5": "depth",
    "height = 0.01, period = 30, depth = 2": "longer than 20 times the depth",
    'height = 1, period = 6, direction = "2 m"': "direction",
    "height = 1, period = 6, ramp = -1": "ramp",
    'height = 1, period = 6, spectrum = "pierson"': "spectrum",
    "height = 1, period = 6, seed = 3": "regular",
    "height = 1, period = 6, peakedness = 2": "regular",
    'height = 1, period = 6, spectrum = "jonswap", peakedness = 0.5': "peakedness",
    'height = 1, period = 6, spectrum = "jonswap", components = 0': "components",
    'height = 1, period = 6, spectrum = "jonswap", seed = -1': "seed",
    'height = 1, period = 6, spectrum = "jonswap", phase = 1': "phase",
    'height = 1, period = 6, stretching = "some"': "stretching",
    "height = 1, period = 6, lenght = 3": "lenght",
}


def oscillator(mass, stiffness, force):
    """Amplitude of mass (x'' + c x') + stiffness x = force e^(i w t)."""
    return abs(force / (stiffness - mass * OMEGA**2 + 1j * DAMPING * mass * OMEGA))


class Waves(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_scene(self, text, *settings, code=0):
        scene = self.folder / "scene.toml"
        scene.write_text(text)
        words = [NETLOFT, "run", scene, "--threads", "1", "--overwrite", "-o", self.folder / "out.hdf"]
        for setting in settings:
            words += ["--set", setting]
        ended = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, code, ended.stderr + ended.stdout)
        return ended.stdout + ended.stderr

    def frames(self):
        """Times, and the positions of all nodes at each."""
        with h5py.File(self.folder / "out.hdf") as f:
            points, count = f["VTKHDF/Points"][()], f["VTKHDF/NumberOfPoints"][0]
            places = [points[first:first + count] for first in f["VTKHDF/Steps/PointOffsets"][()]]
            return f["VTKHDF/Steps/Values"][()], np.array(places)

    def amplitude(self, axis):
        """Amplitude of the last node at the period of the waves, over the last four periods."""
        t, places = self.frames()
        x = places[:, -1, axis]
        last = t > t[-1] - 4 * PERIOD + 1e-6
        return abs(2 * np.mean(x[last] * np.exp(-1j * OMEGA * t[last])))

    def test_a_float_on_a_line_answers_like_its_linear_oscillator(self):
        self.run_scene(SCENE.read_text())
        k, volume, mass, added, length = OMEGA**2 / GRAVITY, 0.1, 30, 0.5, 5
        displaced = DENSITY * volume
        expected = oscillator(mass + added * displaced, (displaced - mass) * GRAVITY / length,
                              (1 + added) * displaced * AMPLITUDE * OMEGA**2 * math.exp(-3 * k))
        self.assertLess(abs(self.amplitude(0) / expected - 1), 0.01, expected)

    def test_a_box_on_a_line_heaves_like_its_linear_oscillator(self):
        self.run_scene(BOX)
        k, draught = OMEGA**2 / GRAVITY, 0.5
        expected = oscillator(600, DENSITY * GRAVITY + 1000,
                              DENSITY * GRAVITY * AMPLITUDE - 200 * AMPLITUDE * OMEGA**2 * math.exp(-k * draught))
        self.assertLess(abs(self.amplitude(2) / expected - 1), 0.01, expected)

    def test_the_same_seed_is_the_same_motion_to_the_bit(self):
        sea = 'water.waves={ height = 0.04, period = 6, spectrum = "jonswap", seed = %d, components = 20 }'
        ends = []
        for seed in (5, 5, 6):
            self.run_scene(SCENE.read_text(), sea % seed, "analysis.duration=5")
            ends.append(self.frames()[1].tobytes())
        self.assertEqual(ends[0], ends[1])
        self.assertNotEqual(ends[0], ends[2])

    def test_wrong_waves_are_located_errors(self):
        for keys, named in WRONG.items():
            with self.subTest(keys):
                text = SCENE.read_text()
                text = re.sub(r"waves = .*", "waves = { " + keys + " }", text)
                line = next(i for i, row in enumerate(text.splitlines(), 1) if row.startswith("waves"))
                said = self.run_scene(text, code=2)
                self.assertRegex(said, rf"scene\.toml:{line}:\d+: error: [^\n]*water\.waves")
                self.assertIn(named, said)

    def test_waves_in_a_static_analysis_or_without_gravity_are_errors(self):
        text = SCENE.read_text()
        static = re.sub(r"\[analysis\].*?\[results\]", "[results]", text, flags=re.S)
        self.assertRegex(self.run_scene(static, code=2), r"scene\.toml:\d+:\d+: error: water\.waves: have no effect in a static")
        still = text.replace("gravity = 9.81", "gravity = 0")
        self.assertRegex(self.run_scene(still, code=2), r"scene\.toml:\d+:\d+: error: water\.waves\.height: is given in water without gravity")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
