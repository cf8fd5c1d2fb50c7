#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A whole trawl that speeds up, turns and hauls: its doors stay upright, few steps are rejected, and a killed run continues with the same bits.

    test_trawl_in_motion.py NETLOFT SOURCE_FOLDER
"""
import json
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests" / "support"))
from journal import Damaged, Journal
from test_killed_motion import first_difference, series_of

SCENE = SOURCE / "gear-library" / "scenes" / "dynamics" / "83-112-in-motion.toml"
DOORS = "starboard-door", "port-door"


def command(output, *settings, options=()):
    words = [NETLOFT, "run", SCENE, "--threads", "1", "--json", "-o", output, *options]
    return words + [word for setting in settings for word in ("--set", setting)]


class TrawlInMotion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = Path(self.folder.name) / "trawl.hdf"

    def run_it(self, *settings, options=()):
        ended = subprocess.run(command(self.output, *settings, options=options), capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr[-1000:] + ended.stdout[-1000:])
        return json.loads(ended.stdout)

    def expect_doors_that_stand(self, spread_from, spread_to, largest_heel=45):
        with h5py.File(self.output) as f:
            gear = f["netloft/series/gear"]
            for door in DOORS:
                self.assertLess(np.degrees(np.abs(gear[f"bodies/{door}/heel"][()])).max(), largest_heel)
            spread = gear["pairs/door/spread"][()]
        self.assertGreater(spread.min(), spread_from)
        self.assertLess(spread.max(), spread_to)

    def test_begins_with_doors_that_stand_and_spread(self):
        for nodes in (100, 300, 1000):
            with self.subTest(nodes=nodes):
                answer = self.run_it(f"gear.nodes={nodes}", "analysis.duration=0.01")
                self.assertEqual([w for w in answer["warnings"] if "board" in w or "door" in w], [])
                self.expect_doors_that_stand(50, 70)

    def test_speeds_up_and_turns_in_few_tries(self):
        """Newton's steps with unsymmetric tangents once raised the residual, and time steps were shortened until they did not."""
        answer = self.run_it("gear.nodes=300", "ship.warp.winch={t=[0,9],speed=[0,0]}", "analysis.duration=40",
                             'ship.path.heading=["0 deg","0 deg","45 deg"]')
        self.assertEqual(answer["warnings"], [])
        self.expect_doors_that_stand(60, 70)
        self.assertLess(answer["steps"] + answer["rejected_steps"], 40)

    def test_turns_by_a_right_angle_on_held_tension_and_hauls(self):
        """This coarse gear has more drag than that of the scene, so another tension keeps the length. When the haul ends, the gear slackens and its inner door leans."""
        answer = self.run_it("gear.nodes=120", 'ship.warp.winch[1].tension=["20.6 kN"]')
        self.expect_doors_that_stand(35, 75, 60)
        with h5py.File(self.output) as f:
            gear, series = f["netloft/series/gear/warps"], f["netloft/series"]
            for warp in "starboard-warp", "port-warp":
                length, tension = gear[f"{warp}/length"][()], gear[f"{warp}/tension"][()]
                self.assertLess(np.abs(length[:20] - 240).max(), 1e-9)
                self.assertLess(np.abs(tension[26:145] - 20.6e3).max(), 1e3)
                self.assertAlmostEqual(length[145] - length[200], 50, delta=1e-9)
            self.assertGreater(gear["port-warp/length"][145] - gear["starboard-warp/length"][145], 5)
            self.assertGreater(abs(series["mouth_y"][-1]), 50)
        energies = answer["energies"]
        self.assertLess(abs(energies["numerical"]), 1e-3 * (abs(energies["work_of_holds"]) + abs(energies["work_of_winches"])))

    def test_says_that_doors_lie_over(self):
        answer = self.run_it("gear.nodes=290", 'ship.speed="2 kn"', 'ship.path.speed=["2 kn","3 kn","3 kn"]', "analysis.duration=0.01")
        self.assertEqual(len(answer["warnings"]), 2)
        for door, sentence in zip(DOORS, answer["warnings"]):
            self.assertRegex(sentence, f"at t = 0 s {door} has fallen over: its top is turned inward by 1[0-9][0-9]°")

    def test_goes_on_to_the_same_bits_after_a_kill(self):
        """Its winches stand still, hold a tension, and haul."""
        settings = ("gear.nodes=100", "analysis.duration=20", "analysis.output_interval=0.1",
                    'ship.warp.winch=[{t=[0,6],speed=[0,0]},{t=[6],tension=["17.5 kN"]},{t=[12,14],speed=[0,-0.5]}]')
        self.run_it(*settings)
        wanted = series_of(self.output)
        self.output.unlink()
        part, in_the_way = Path(str(self.output) + ".part"), Path(str(self.output) + ".new")
        in_the_way.mkdir()  # no result is made, so that the journal stays even if this process sleeps until the motion has ended
        run = subprocess.Popen(command(self.output, *settings), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while run.poll() is None:
            try:
                if len(Journal(part).outputs) >= 60:
                    break
            except (OSError, Damaged):
                time.sleep(1e-3)
        run.send_signal(signal.SIGKILL)
        run.wait()
        in_the_way.rmdir()
        self.assertTrue(part.exists())
        answer = self.run_it(*settings, options=("--resume",))
        self.assertGreater(answer["resumed_from"], 0)
        self.assertIsNone(first_difference(series_of(self.output), wanted))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
