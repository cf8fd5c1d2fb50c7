#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""break_rules.py GOOD.hdf: breaks one VTKHDF rule at a time in a copy and expects check_vtkhdf.py to say so."""
import pathlib
import shutil
import sys
import tempfile

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[4] / "support"))
import check_vtkhdf  # noqa: E402


def replace(group, name, values):
    attributes = dict(group[name].attrs)
    del group[name]
    group[name] = values
    group[name].attrs.update(attributes)


BREAKS = {
    "Type is not a fixed-length": lambda g: g.attrs.__setitem__("Type", "UnstructuredGrid"),
    "Version is": lambda g: g.attrs.__setitem__("Version", np.array([2, 0], np.int32)),
    "NumberOfPoints is": lambda g: replace(g, "NumberOfPoints", np.array([1], np.int32)),
    "Offsets is int64": lambda g: replace(g, "Offsets", g["Offsets"][:-1]),
    "Offsets does not fit Types": lambda g: g["Types"].__setitem__(0, 1),
    "Types is not one uint8": lambda g: replace(g, "Types", g["Types"][:].astype(np.int64)),
    "a point that does not exist": lambda g: g["Connectivity"].__setitem__(0, 10**6),
    "times run backwards": lambda g: g["Steps/Values"].__setitem__(0, 1e9),
    "point behind its": lambda g: g["Steps/PointDataOffsets/height"].__setitem__(0, 10**6),
    "the newest state of Points is not in slot 0":
        lambda g: g["Steps/PointOffsets"].__setitem__(slice(None), g["Steps/PointOffsets"][:][::-1]),
    "steps that are not neighbours share a slot of Points": lambda g: g["Steps/PointOffsets"].__setitem__(0, 0),
    "Steps/CellOffsets is": lambda g: replace(g["Steps"], "CellOffsets", g["Steps/CellOffsets"][:, 0]),
    "Steps/NumberOfParts is not 1": lambda g: g["Steps/NumberOfParts"].__setitem__(0, 2),
    "Steps offsets of PointData/part is missing": lambda g: g["Steps/PointDataOffsets"].__delitem__("part"),
    "has no unit": lambda g: g["PointData/height"].attrs.__delitem__("unit"),
    "there is no state": lambda g: g["Steps"].attrs.__setitem__("NSteps", np.int64(0)),
}


def main(good):
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        for sentence, do_break in BREAKS.items():
            copy = str(pathlib.Path(folder) / "broken.hdf")
            shutil.copy(good, copy)
            with h5py.File(copy, "r+") as file:
                do_break(file["VTKHDF"])
            if not any(sentence in found for found in check_vtkhdf.check_file(copy)):
                missed.append(f"not found: {sentence}; said: {check_vtkhdf.check_file(copy)}")
    print("\n".join(missed) if missed else f"{len(BREAKS)} broken rules found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
