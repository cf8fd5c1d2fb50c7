# SPDX-License-Identifier: BSD-3-Clause
"""Boards and the ship in pictures and pages of a result: their positions and rotations."""
import json
import re
import struct
import unittest

import h5py
import numpy as np
from program import SOURCE, InFreshFolder, changed
from test_bodies import rotation
from test_boards import ONE

OUTLINE = [[-1.35, -0.1, -0.9], [0, 0.1, -0.9], [1.35, -0.1, -0.9], [1.35, -0.1, 0.9], [0, 0.1, 0.9], [-1.35, -0.1, 0.9]]
PLATE = changed(ONE, ("points = { warp", f"outline = {OUTLINE}\npoints = {{ warp"))
DOORS = SOURCE / "gear-library/scenes/gov-like-67m.toml"
PAIR = SOURCE / "gear-library/scenes/pair-trawl.toml"


def meshes(data):
    """Positions of triangles by name of the mesh of a binary glTF."""
    length = struct.unpack("<I", data[12:16])[0]
    document, binary = json.loads(data[20:20 + length]), data[28 + length:]
    found = {}
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            if primitive["mode"] != 4:
                continue
            view = document["bufferViews"][document["accessors"][primitive["attributes"]["POSITION"]]["bufferView"]]
            found[mesh["name"]] = np.frombuffer(binary[view["byteOffset"]:][:view["byteLength"]], "<f4").reshape(-1, 3, 3)
    return found


def area(triangles):
    return np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1).sum() / 2


class Solids(InFreshFolder):
    def exported(self, *words):
        ended = self.netloft("run", *words, "-o", "a.hdf")
        self.assertIn(ended.code, (0, 3), ended.err)
        self.assertEqual(self.netloft("export", "a.hdf", "a.glb").code, 0)
        return meshes((self.folder / "a.glb").read_bytes())

    def test_a_board_is_its_outline_as_it_is_turned(self):
        self.write("a.toml", PLATE)
        door = self.exported("a.toml")["door"]
        with h5py.File(self.folder / "a.hdf") as f:
            origin = int(f["netloft/bodies/origin"][0])
            turn, place = f["VTKHDF/PointData/rotation"][:][origin], f["VTKHDF/Points"][:][origin]
        corners = (np.array(OUTLINE) @ rotation(turn).T + place).astype("<f4")
        self.assertEqual({tuple(c) for c in door.reshape(-1, 3)}, {tuple(c) for c in corners})
        # bent along a vertical line: two flat halves, each as long as the distance from its edge to the bend
        self.assertAlmostEqual(area(door), 2 * np.hypot(1.35, 0.2) * 1.8, delta=1e-4)

    def test_a_bill_has_boards_and_their_masses(self):
        for extent in ("half", "whole"):
            with self.subTest(extent):
                self.exported(str(DOORS), "--set", "gear.nodes=200", "--set", f"gear.extent={extent}", "--set", "analysis.max_iterations=1")
                report = json.loads(self.netloft("report", "a.hdf", "--json").out)
                rows = {row["name"]: row for row in report["materials"]}
                door = rows["door"]
                self.assertEqual((door["kind"], door["part"], door["number"]), ("body", "polyvalent-4.5m2", 2))
                self.assertAlmostEqual(door["mass"], 2 * 1100)
                self.assertAlmostEqual(door["area"], 2 * 4.5)

    def test_a_damaged_outline_is_refused(self):
        self.write("a.toml", PLATE)
        self.exported("a.toml")
        for change, message in ((lambda f: f["netloft/bodies/outline/body"].__setitem__(0, 7), "refers to a body that does not exist"),
                                (lambda f: f["netloft/bodies/origin"].__setitem__(0, 10**6), "refers to a node that does not exist")):
            with self.subTest(message):
                damaged = self.folder / "b.hdf"
                damaged.write_bytes((self.folder / "a.hdf").read_bytes())
                with h5py.File(damaged, "r+") as f:
                    change(f)
                ended = self.netloft("view", "b.hdf")
                self.assertNotEqual(ended.code, 0)
                self.assertIn("damaged", ended.err)

    def test_a_bed_with_a_hill_is_a_hill(self):
        hill = '\n[bed]\ndepth = "60 m"\nrelief = { x = [0, 0, 100, 100, 200, 200], y = [-200, 200, -200, 200, -200, 200], height = [0, 0, 5, 5, 0, 0] }\n'
        self.write("a.toml", PLATE + hill)
        self.exported("a.toml")
        with h5py.File(self.folder / "a.hdf") as f:
            relief = f["netloft/seabed/relief"]
            self.assertEqual((relief["height"].shape, relief["height"][:].max(), relief["height"][0, 0]), ((65, 65), 5, 0))
        self.assertEqual(self.netloft("view", "a.hdf").code, 0)
        ground = json.loads(re.search(r'id="data">(.*?)</script>', (self.folder / "a.html").read_text(), re.S).group(1))["results"][0]["ground"]
        heights = np.array(ground["heights"]).reshape(ground["places"], -1)
        x = np.linspace(*ground["x"], ground["places"])
        top = np.abs(x - 100).argmin()
        self.assertAlmostEqual(heights.max(), heights[top].max())
        self.assertAlmostEqual(heights[top, 0], -55, delta=0.2)
        self.assertAlmostEqual(heights[0, 0], -60)  # beyond the relief it goes on as at its edge

    def test_two_ships_stand_at_their_blocks(self):
        found = self.exported(str(PAIR), "--set", "gear.nodes=200", "--set", "analysis.max_iterations=1")
        ships = found["ship"].reshape(-1, 3)
        self.assertAlmostEqual(ships[:, 1].max(), -ships[:, 1].min(), delta=1e-3)
        self.assertTrue((np.abs(ships[:, 1]) > 30).all())
        self.assertAlmostEqual(ships[:, 0].max(), 0, delta=1e-6)  # the gear is aft of the blocks, at x = 0


if __name__ == "__main__":
    unittest.main()
