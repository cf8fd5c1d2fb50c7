# SPDX-License-Identifier: BSD-3-Clause
"""A gear that a drum hauls, compared with FEMNET: positions of the nodes over ten seconds, in which 3.2 m of 8 m of rope are hauled.

FEMNET goes in steps of 0.01 s of the backward Euler method, has added mass along ropes, too, and drag by the velocity of each node. The positions differ by less than the length that is hauled in half a step of FEMNET, 2 mm.
"""
import json
import unittest
from pathlib import Path

import h5py
import numpy as np

from imported import Gear

HERE = Path(__file__).parent
METRES = 2e-3


class Motion(Gear):
    def read(self, f):
        grid = f["VTKHDF"]
        self.times, count = grid["Steps/Values"][:], grid["NumberOfPoints"][0]
        self.states = [grid["Points"][first:first + count] for first in grid["Steps/PointOffsets"][:]]

    def at(self, time):
        """Positions at the time of an output."""
        nearest = int(np.abs(self.times - time).argmin())
        assert abs(self.times[nearest] - time) < 1e-6, time
        return self.states[nearest]


class Hauling(unittest.TestCase):
    def test_a_drum_hauls_as_it_does_in_femnet(self):
        records = json.loads((HERE / "09_hauling.expected.json").read_text())["dynamic"]["records"]
        gear = Motion(HERE / "09_hauling.don", how=("--motion",), sets=("analysis.output_interval=0.01", "analysis.accuracy=1e-5"))
        self.assertNotIn("left out:", gear.said)
        furthest = 0
        for record in records:
            if record["time_s"] <= gear.times[-1]:
                there = gear.at(record["time_s"])
                furthest = max(furthest, *(np.linalg.norm(there - x, axis=1).min() for x in np.array(record["positions_m"])))
        print(f"{len(records)} records: {furthest:.2g} m from FEMNET at most")
        self.assertLess(furthest, METRES)

    def test_it_begins_where_the_gear_is_at_rest(self):
        there = json.loads((HERE / "09_hauling.expected.json").read_text())
        gear = Gear(HERE / "09_hauling.don", how=("--motion",), sets=("analysis.kind=static",))
        self.assertLess(gear.furthest(there["positions_m"]), 1e-6)


if __name__ == "__main__":
    unittest.main()
