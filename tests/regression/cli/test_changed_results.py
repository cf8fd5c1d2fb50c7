# SPDX-License-Identifier: BSD-3-Clause
"""Results with undamaged bytes whose numbers contradict each other."""
import shutil
import unittest

import h5py
import numpy as np

from program import GOOD, InFreshFolder


def replace(file, path, values):
    attributes = dict(file[path].attrs)
    del file[path]
    file[path] = values
    for name, value in attributes.items():
        file[path].attrs[name] = value


class Changed(InFreshFolder):
    @classmethod
    def setUpClass(cls):
        cls.good = cls("netloft")
        cls.good.setUp()
        cls.addClassCleanup(cls.good.doCleanups)
        cls.good.write("a.toml", GOOD)
        assert cls.good.netloft("run", "a.toml").code == 0

    def check(self, change, sentence):
        file = self.folder / "b.hdf"
        shutil.copy(self.good.folder / "a.hdf", file)
        with h5py.File(file, "r+") as f:
            change(f)
        for words in (["export", "b.hdf", "b.csv"], ["report", "b.hdf"]):
            ended = self.netloft(*words)
            if ended.code == 2:
                break
        self.assertEqual(ended.code, 2, ended.err)
        self.assertRegex(ended.err, r"^netloft: .*b\.hdf")
        self.assertIn(sentence, ended.err)

    def test_cells_that_begin_before_the_first_node(self):
        def change(f):
            offsets = f["VTKHDF/Offsets"][:]
            offsets[0] = -1
            f["VTKHDF/Offsets"][:] = offsets
        self.check(change, "its cells are cut off")

    def test_cells_on_nodes_that_overflow(self):
        def change(f):
            f["VTKHDF/Connectivity"][0] = 2**32 + 1
        self.check(change, "a cell refers to a node that does not exist")

    def test_places_on_panels_without_room_for_all_corners(self):
        self.check(lambda f: replace(f, "VTKHDF/CellData/panel_corners", np.zeros((36, 2))),
                   "its places on panels holds 72 numbers, its mesh has 216")

    def test_a_shape_without_heights(self):
        def change(f):
            replace(f, "VTKHDF/Points", f["VTKHDF/Points"][:, :2])
        self.check(change, "its shape holds")

    def test_a_state_that_begins_nowhere(self):
        self.check(lambda f: replace(f, "VTKHDF/Steps/PointOffsets", np.zeros(0, dtype="i8")),
                   "has no place for state 0")

    def test_an_attribute_with_several_texts(self):
        def change(f):
            del f["netloft/status"].attrs["outcome"]
            f["netloft/status"].attrs["outcome"] = np.array([b"converged"] * 50)
        self.check(change, "it is not one text")

    def test_a_group_that_holds_itself(self):
        def change(f):
            f["netloft/scalars/again"] = f["netloft/scalars"]
        self.check(change, "is a group that also appears in another group, possibly in itself")

    def test_a_part_that_is_no_number(self):
        self.check(lambda f: f["VTKHDF/CellData/part"].__setitem__(0, -7), "it has a part without a number")


if __name__ == "__main__":
    unittest.main()
