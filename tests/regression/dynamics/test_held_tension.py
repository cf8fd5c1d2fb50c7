#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Warps on winches that hold a tension: a trawl that speeds up and turns has the same tension on both sides, and a killed run continues with the same bits.

    test_held_tension.py NETLOFT SOURCE_FOLDER
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
SCENE = SOURCE / "gear-library" / "scenes" / "dynamics" / "83-112-in-motion.toml"
WARPS = "starboard-warp", "port-warp"
HELD, BAND = 16.5e3, 1.5e3  # [N]; the first is what the blocks bear at 3 kn with 240 m


class HeldTension(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = Path(self.folder.name) / "trawl.hdf"

    def run_it(self, *settings):
        words = [NETLOFT, "run", SCENE, "--threads", "1", "--json", "--overwrite", "-o", self.output, "--set", "gear.nodes=100"]
        words += [word for setting in settings for word in ("--set", setting)]
        ended = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr[-1000:] + ended.stdout[-1000:])
        with h5py.File(self.output) as f:
            gear = f["netloft/series/gear"]
            series = [{key: gear[f"warps/{warp}/{key}"][()] for key in ("tension", "length", "paying_out")} for warp in WARPS]
        return json.loads(ended.stdout), series

    def test_is_held_while_the_ship_speeds_up_and_turns(self):
        answer, (starboard, port) = self.run_it(
            f'ship.warp.winch={{tension="{HELD} N",max_speed="2 m/s",band="{BAND} N"}}',
            'ship.path={t=[0,5,10,40],speed=["3 kn","3 kn","3.25 kn","3.25 kn"],heading=["0 deg","0 deg","0 deg","20 deg"]}', "analysis.duration=24")
        for warp in starboard, port:
            self.assertLess(np.abs(warp["tension"] - HELD).max(), 0.15 * BAND)
            self.assertGreater(warp["length"][12] - warp["length"][0], 0.3)  # a faster ship pays out
        self.assertLess(np.abs(starboard["tension"] / port["tension"] - 1).max(), 0.01)
        self.assertGreater(port["length"][-1] - starboard["length"][-1], 1)  # which the turn to starboard does
        energies = answer["energies"]
        given = abs(energies["work_of_holds"])  # most of it taken out again by the winches
        self.assertLess(abs(energies["numerical"]), 1e-3 * given)

    def test_begins_with_the_length_that_bears_it(self):
        _, (starboard, port) = self.run_it('ship.warp.tension="16.4 kN"', "ship.warp.winch={}", 'ship.path={t=[0,9],speed=["3 kn","3 kn"]}', "analysis.duration=4")
        for warp in starboard, port:
            self.assertLess(np.abs(warp["tension"] - 16.4e3).max(), 1)
            self.assertLess(np.ptp(warp["length"]), 0.01)
        self.assertGreater(abs(starboard["length"][0] - 240), 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
