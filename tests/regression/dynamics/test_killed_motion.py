#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A motion that is killed at random instants: its file opens, holds every output that was there, and goes on to the same bits.

    test_killed_motion.py NETLOFT SOURCE_FOLDER [TRIALS]
"""
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

os.environ["HDF5_USE_FILE_LOCKING"] = "FALSE"  # to look at a file that is being written
import h5py
import numpy as np

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
TRIALS = int(sys.argv[3]) if len(sys.argv) > 3 else 4  # tests/nightly: 100
SCENE = SOURCE / "gear-library" / "scenes" / "dynamics" / "released-rope.toml"
SEED = 20240607


def command(output, *options):
    return [NETLOFT, "run", SCENE, "-o", output, "--set", "analysis.output_interval=0.02", *options]


def states_in(file):
    with h5py.File(file, "r") as f:
        return int(f["VTKHDF/Steps"].attrs["NSteps"])


def series_of(file):
    """Every number of every state, in order of time; names to arrays [state, ...]."""
    with h5py.File(file, "r") as f:
        grid, steps = f["VTKHDF"], f["VTKHDF/Steps"]
        count = int(steps.attrs["NSteps"])
        points, cells = int(grid["NumberOfPoints"][0]), int(grid["NumberOfCells"][0])
        out = {"time": steps["Values"][:count]}
        out["points"] = np.array([grid["Points"][o:o + points] for o in steps["PointOffsets"][:count]])
        for group, rows in (("PointData", points), ("CellData", cells)):
            for name, data in grid[group].items():
                offsets = steps[group + "Offsets"][name][:count]
                out[f"{group}/{name}"] = np.array([data[o:o + rows] for o in offsets])
        def add(name, data):
            if isinstance(data, h5py.Dataset):
                out["series/" + name] = data[:count]
        f["netloft/series"].visititems(add)
        return out


def first_difference(a, b):
    """Of the states that both have; None if there is none."""
    for name, values in a.items():
        count = min(len(values), len(b[name]))
        if values[:count].tobytes() != b[name][:count].tobytes():
            return name
    return None


class KilledMotion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.whole = Path(cls.folder.name) / "whole.hdf"
        begun = time.time()
        subprocess.run(command(cls.whole), check=True, capture_output=True)
        cls.seconds = time.time() - begun
        cls.wanted = series_of(cls.whole)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def kill_after(self, output, seconds):
        """States seen in the file before it was killed; None if it was too early or too late to tell."""
        part = Path(str(output) + ".part")
        run = subprocess.Popen(command(output), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        seen, end = 0, time.time() + seconds
        while time.time() < end and run.poll() is None:
            try:
                seen = max(seen, states_in(part))
            except (OSError, KeyError):
                pass  # not there yet, or between two flushes of this very copy
        run.send_signal(signal.SIGKILL)
        run.wait()
        return seen

    def test_opens_holds_and_goes_on_to_the_same_bits(self):
        rng = random.Random(SEED)
        tried = 0
        for trial in range(20 * TRIALS):
            if tried == TRIALS:
                break
            output = Path(self.folder.name) / f"killed-{trial}.hdf"
            part = Path(str(output) + ".part")
            seen = self.kill_after(output, self.seconds * rng.uniform(0.05, 1))
            if seen == 0 or not part.exists():
                continue  # before the first output, or after the last
            tried += 1
            with self.subTest(trial=trial, seen=seen):
                held = series_of(part)
                self.assertGreaterEqual(len(held["time"]), seen)
                self.assertIsNone(first_difference(held, self.wanted))
                subprocess.run(command(output, "--resume"), check=True, capture_output=True)
                resumed = series_of(output)
                self.assertEqual(len(resumed["time"]), len(self.wanted["time"]))
                self.assertIsNone(first_difference(resumed, self.wanted))
                self.assertFalse(part.exists())
        self.assertEqual(tried, TRIALS)

    def test_refuses_to_go_on_with_another_scene(self):
        output = Path(self.folder.name) / "other.hdf"
        part = Path(str(output) + ".part")
        for _ in range(50):
            if self.kill_after(output, 0.6 * self.seconds) and part.exists():
                break
        run = subprocess.run(command(output, "--resume", "--set", "water.gravity=1"), capture_output=True, text=True,
                             check=False)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("another scene", run.stderr)

    def test_tells_the_last_output_when_nothing_is_left_to_do(self):
        whole, again = Path(self.folder.name) / "pulled.hdf", Path(self.folder.name) / "again.hdf"
        first = json.loads(subprocess.run(command(whole, "--json"), check=True, capture_output=True).stdout)
        shutil.copy(whole, str(again) + ".part")  # as a kill after the last output leaves it
        second = json.loads(subprocess.run(command(again, "--json", "--resume"), check=True, capture_output=True).stdout)
        self.assertNotEqual(first["results"]["pull"], 0)
        self.assertEqual(second["results"], first["results"])
        with h5py.File(again) as f:
            self.assertEqual(f["netloft/scalars/pull"][()], first["results"]["pull"])

    def test_says_that_there_is_nothing_to_go_on_from(self):
        run = subprocess.run(command(Path(self.folder.name) / "none.hdf", "--resume"), capture_output=True, text=True,
                             check=False)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("none.hdf.part to go on from", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
