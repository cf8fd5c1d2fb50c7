#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A trawl of two ships in motion against its half and its mirror image, and a catch that grows slowly against equilibria.

    test_pair_and_catch.py NETLOFT SOURCE_FOLDER
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
PAIR = f"""
include = ["{SOURCE}/gear-library/gears/pair-trawl.toml"]
[elements.netting]
twine = {{ EA_compression = 0 }}
[gear]
size = "6 m"
[analysis]
kind = "dynamic"
start = "equilibrium"
integrator = "energy-momentum"
energy-momentum = {{ spectral_radius = 0.3 }}
solver = "chord"
tangent = "exact"
duration = 12
output_interval = 1
tolerance = 1e-8
"""
FASTER = '{ t = [0, 8], speed = ["2.5 kn", "3 kn"] }'
CATCH = f"""
include = ["{SOURCE}/gear-library/scenes/verification/codend-with-catch.toml"]
[water]
current = [1.5, 0, 0]
[parts.codend]
cells = [8, 16]
[analysis]
tolerance = 1e-8
"""


class Motion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_it(self, text, *settings):
        scene, output = Path(self.folder.name) / "a.toml", Path(self.folder.name) / "a.hdf"
        scene.write_text(text)
        words = [NETLOFT, "run", scene, "--threads", "1", "--json", "--overwrite", "-o", output]
        ended = subprocess.run(words + [w for s in settings for w in ("--set", s)], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr[-1000:] + ended.stdout[-1000:])
        return json.loads(ended.stdout), output

    def figures(self, output):
        with h5py.File(output) as f:
            gear, found = f["netloft/series/gear"], {}
            gear.visititems(lambda name, at: found.update({name: at[()]}) if hasattr(at, "shape") else None)
        return found


class TwoShips(Motion):
    def test_equal_paths_are_those_of_the_half_behind_one_ship(self):
        _, output = self.run_it(PAIR, f"ship.path={FASTER}", f"ship.path_port={FASTER}")
        whole = self.figures(output)
        _, output = self.run_it(PAIR, f"ship.path={FASTER}", "gear.extent=half")
        half = self.figures(output)
        for name in ("mouth/headline_height", "mouth/upper_wing_spread", "drag/all/x", "towing/pull"):
            apart = np.abs(whole[name] - half[name]).max() / np.abs(half[name]).max()
            self.assertLess(apart, 1e-5, name)
        self.assertGreater(whole["towing/pull"][-1], 1.1 * whole["towing/pull"][0])

    def test_ships_that_part_leave_the_gear_symmetric(self):
        def path(degrees):
            return f'{{ t = [0, 8], speed = ["2.5 kn", "2.5 kn"], heading = ["0 deg", "{degrees} deg"] }}'

        _, output = self.run_it(PAIR, f"ship.path={path(10)}", f"ship.path_port={path(-10)}")
        found = self.figures(output)
        for key in ("tension", "out_at_start"):
            starboard, port = found[f"warps/starboard-warp/{key}"], found[f"warps/port-warp/{key}"]
            self.assertLess(np.abs(starboard - port).max(), 1e-5 * starboard.max(), key)
        out = found["warps/port-warp/out_at_start"]
        self.assertGreater(out[-1], 1.02 * out[0])


class GrowingCatch(Motion):
    """A slow motion goes through equilibria, and ends at that of the whole catch."""

    MOVES = ('analysis.kind="dynamic"', 'analysis.start="equilibrium"', 'analysis.solver="chord"', 'analysis.tangent="exact"', 'analysis.duration=60', 'analysis.output_interval=20')

    def catch(self, volume, growth=""):
        return f'parts.catch.catch={{pressure="1614.375 Pa",volume={volume}{growth}}}'

    def test_goes_through_the_equilibria_of_the_catches_between(self):
        at_rest = [self.run_it(CATCH, self.catch(volume))[0]["results"] for volume in (6, 8, 10)]
        for scheme in "generalized-alpha", "energy-momentum":
            _, output = self.run_it(CATCH, self.catch(10, ",growth={t=[0,40],share=[0.6,1]}"), *self.MOVES, f"analysis.integrator={scheme}")
            with h5py.File(output) as f:
                for name in ("length", "largest_radius", "drag"):
                    self.expect_between(f["netloft/series"][name][()], [one[name] for one in at_rest], name)

    def expect_between(self, moved, at_rest, name):
        small, middle, whole = at_rest
        grown = abs(whole - small)
        self.assertGreater(grown, 0.01 * abs(small), name)
        self.assertLess(abs(moved[0] - small), 1e-4 * grown, name)
        self.assertLess(abs(moved[1] - middle), 0.05 * grown, name)  # half of it, while it grows
        self.assertLess(abs(moved[3] - whole), 1e-2 * grown, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
