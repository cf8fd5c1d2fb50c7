#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A motion that is killed at random instants: its file can be read, has every earlier output, and the run continues with the same bits.

    test_killed_motion.py NETLOFT SOURCE_FOLDER [TRIALS]
"""
import json
import random
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import h5py
import numpy as np

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests" / "support"))
from journal import Damaged, Journal
TRIALS = int(sys.argv[3]) if len(sys.argv) > 3 else 4  # tests/nightly: 100
SCENE = SOURCE / "gear-library" / "scenes" / "dynamics" / "released-rope.toml"
SEED = 20240607


def command(output, *options):
    return [NETLOFT, "run", SCENE, "-o", output, "--set", "analysis.output_interval=0.002", *options]


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


def rows_of(item, data):
    """The numbers that XDMF finds in the bytes of the result."""
    assert (item.get("Format"), item.get("Endian"), item.get("Precision")) == ("Binary", "Little", "8")
    shape = [int(n) for n in item.get("Dimensions").split()]
    return np.frombuffer(data, "<f8", int(np.prod(shape)), int(item.get("Seek"))).reshape(shape)


def first_difference(a, b):
    """The first array whose common states differ; None if all are equal."""
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
        subprocess.run(command(cls.whole), check=True, capture_output=True)
        cls.wanted = series_of(cls.whole)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def kill_at(self, output, outputs):
        """The outputs in the journal just before the kill, which comes after this number of outputs. No result is made of them, so that
        the journal is there even if this process sleeps until the motion has ended."""
        part, in_the_way = Path(str(output) + ".part"), Path(str(output) + ".new")
        in_the_way.mkdir()
        run = subprocess.Popen(command(output), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        seen = 0
        while seen < outputs and run.poll() is None:
            try:
                seen = len(Journal(part).outputs)
            except (OSError, Damaged):
                pass  # not there yet, or not begun
        run.send_signal(signal.SIGKILL)
        run.wait()
        in_the_way.rmdir()
        return seen

    def test_opens_holds_and_goes_on_to_the_same_bits(self):
        rng = random.Random(SEED)
        for trial in range(TRIALS):
            output = Path(self.folder.name) / f"killed-{trial}.hdf"
            part = Path(str(output) + ".part")
            seen = self.kill_at(output, rng.randrange(1, len(self.wanted["time"])))
            with self.subTest(trial=trial, seen=seen):
                held = Journal(part).series()
                self.assertGreaterEqual(len(held["time"]), seen)
                self.assertIsNone(first_difference(held, self.wanted))
                subprocess.run(command(output, "--resume"), check=True, capture_output=True)
                resumed = series_of(output)
                self.assertEqual(len(resumed["time"]), len(self.wanted["time"]))
                self.assertIsNone(first_difference(resumed, self.wanted))
                self.assertFalse(part.exists())

    def test_refuses_to_go_on_with_another_scene(self):
        output = Path(self.folder.name) / "other.hdf"
        self.kill_at(output, 1)
        run = subprocess.run(command(output, "--resume", "--set", "water.gravity=1"), capture_output=True, text=True,
                             check=False)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("another scene", run.stderr)

    def test_tells_the_last_output_when_nothing_is_left_to_do(self):
        whole, again = Path(self.folder.name) / "pulled.hdf", Path(self.folder.name) / "again.hdf"
        first = json.loads(subprocess.run(command(whole, "--json"), check=True, capture_output=True).stdout)
        in_the_way = Path(str(again) + ".new")
        in_the_way.mkdir()  # all outputs are there, but no result can be made of them
        stuck = subprocess.run(command(again), capture_output=True, text=True, check=False)
        self.assertEqual(stuck.returncode, 1)
        self.assertIn("again.hdf.new: it is a folder", stuck.stderr)
        self.assertEqual(Journal(str(again) + ".part").status[0], "finished")
        in_the_way.rmdir()
        second = json.loads(subprocess.run(command(again, "--json", "--resume"), check=True, capture_output=True).stdout)
        self.assertNotEqual(first["results"]["pull"], 0)
        self.assertEqual(second["results"], first["results"])
        with h5py.File(again) as f:
            self.assertEqual(f["netloft/scalars/pull"][()], first["results"]["pull"])
        self.assertIsNone(first_difference(series_of(again), self.wanted))

    def test_has_an_index_that_points_at_each_state(self):
        """NAME.xdmf is for viewers that read one state of a VTKHDF group only: rows of the arrays, by state."""
        grids = ElementTree.parse(self.whole.with_suffix(".xdmf")).getroot().findall("./Domain/Grid/Grid")
        self.assertEqual(len(grids), len(self.wanted["time"]))
        data = self.whole.read_bytes()
        for i in (0, 1, 1000, len(grids) - 1):
            self.assertEqual(float(grids[i].find("Time").get("Value")), self.wanted["time"][i])
            arrays = {"points": grids[i].find("Geometry/DataItem")}
            for one in grids[i].findall("Attribute"):
                group = {"Node": "PointData", "Cell": "CellData"}[one.get("Center")]
                arrays[f"{group}/{one.get('Name')}"] = one.find("DataItem")
            self.assertEqual(len(arrays), 9)
            for name, item in arrays.items():
                self.assertEqual(item.text, self.whole.name)
                np.testing.assert_array_equal(rows_of(item, data), self.wanted[name][i], name)

    def test_has_an_index_that_points_at_its_cells(self):
        """By XDMF's numbers of shapes: 1 several points, 2 a line of several points, both followed by how many; 4 a triangle."""
        cells = ElementTree.parse(self.whole.with_suffix(".xdmf")).getroot().find("./Domain/Grid/Grid/Topology")
        item = cells.find("DataItem")
        numbers = np.frombuffer(self.whole.read_bytes(), "<i8", int(item.get("Dimensions")), int(item.get("Seek")))
        with h5py.File(self.whole) as f:
            nodes, first = f["VTKHDF/Connectivity"][()], f["VTKHDF/Offsets"][()]
        self.assertEqual(int(cells.get("NumberOfElements")), len(first) - 1)
        wanted = []
        for begin, end in zip(first, first[1:]):
            wanted += {1: [1, 1], 2: [2, 2], 3: [4]}[end - begin] + list(nodes[begin:end])
        self.assertEqual(list(numbers), wanted)

    def test_says_that_there_is_nothing_to_go_on_from(self):
        run = subprocess.run(command(Path(self.folder.name) / "none.hdf", "--resume"), capture_output=True, text=True,
                             check=False)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("none.hdf.part to go on from", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
