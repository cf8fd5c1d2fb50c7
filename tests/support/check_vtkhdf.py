#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the /VTKHDF group of result files against the VTKHDF 2.0 rules and Netloft's layout (io/formats/hdf5/LAYOUT.md).

    check_vtkhdf.py FILE...      exit 0: every rule holds; 1: each broken rule on a line of its own
"""
import sys

import h5py
import numpy as np

NODES_OF_TYPE = {1: 1, 3: 2, 5: 3}  # vertex, line, triangle


class Checker:
    def __init__(self, name):
        self.name = name
        self.broken = []

    def rule(self, holds, sentence):
        if not holds:
            self.broken.append(f"{self.name}: {sentence}")
        return bool(holds)

    def is_int64(self, dataset, shape, name):
        return self.rule(dataset is not None, f"{name} is missing") and self.rule(
            dataset.dtype == np.int64 and dataset.shape == shape,
            f"{name} is {dataset.dtype} {dataset.shape}, not int64 {shape}")


def check_root(check, root):
    kind = root.attrs.get_id("Type") if "Type" in root.attrs else None
    if check.rule(kind is not None, "attribute Type is missing"):
        stored = kind.get_type()
        check.rule(not stored.is_variable_str() and stored.get_cset() == h5py.h5t.CSET_ASCII,
                   "Type is not a fixed-length ASCII string")
        check.rule(root.attrs["Type"] == b"UnstructuredGrid", f"Type is {root.attrs['Type']!r}")
    version = np.asarray(root.attrs.get("Version", []))
    check.rule(version.dtype == np.int64 and version.tolist() in ([1, 0], [2, 0]), f"Version is {version!r}")


def count(check, root, name):
    dataset = root.get(name)
    return int(dataset[0]) if check.is_int64(dataset, (1,), name) else 0


def check_topology(check, root):
    """Checks points, cells and their types. Returns the numbers of points and cells."""
    n_points, n_cells = count(check, root, "NumberOfPoints"), count(check, root, "NumberOfCells")
    n_ids = count(check, root, "NumberOfConnectivityIds")
    connectivity, offsets, types = (root.get(name) for name in ("Connectivity", "Offsets", "Types"))
    if check.is_int64(connectivity, (n_ids,), "Connectivity") and n_ids:
        ids = connectivity[:]
        check.rule(ids.min() >= 0 and ids.max() < n_points, "Connectivity names a point that does not exist")
    good = check.is_int64(offsets, (n_cells + 1,), "Offsets")
    good &= check.rule(types is not None and types.dtype == np.uint8 and types.shape == (n_cells,),
                       "Types is not one uint8 per cell")
    if good:
        ends = offsets[:]
        check.rule(ends[0] == 0 and ends[-1] == n_ids, "Offsets does not run from 0 to NumberOfConnectivityIds")
        wanted = [NODES_OF_TYPE.get(int(t), -1) for t in types[:]]
        check.rule(np.array_equal(np.diff(ends), np.array(wanted, dtype=np.int64)),
                   "Offsets does not fit Types (vertex 1, line 2, triangle 3 nodes)")
    return n_points, n_cells


def check_slots(check, name, dataset, offsets, rows, n_steps):
    """Checks that the rows of every step are inside the dataset. Returns the offsets."""
    if not check.is_int64(offsets, (n_steps,), f"Steps offsets of {name}"):
        return None
    starts = offsets[:]
    check.rule(np.all(starts >= 0) and np.all(starts + rows <= dataset.shape[0]),
               f"Steps offsets of {name} point behind its {dataset.shape[0]} rows")
    check.rule(rows == 0 or np.all(starts % rows == 0), f"Steps offsets of {name} fall between slots")
    return starts


def check_moving(check, name, dataset, offsets, rows, n_steps):
    starts = check_slots(check, name, dataset, offsets, rows, n_steps)
    if starts is None or not rows:
        return
    slots = starts // rows
    if dataset.shape[0] == rows and n_steps > 1:
        check.rule(np.all(slots == 0), f"{name} is stored once but its offsets move")
        return
    check.rule(slots[-1] == 0, f"the newest state of {name} is not in slot 0")
    apart = slots[np.append(True, slots[1:] != slots[:-1])]
    check.rule(len(set(apart.tolist())) == len(apart) == dataset.shape[0] // rows, f"steps that are not neighbours share a slot of {name}")
    values = dataset[:]
    check.rule(values.dtype.kind in "iu" or not np.any(np.isinf(values)), f"{name} holds infinities")


def check_fields(check, root, steps, group, rows, n_steps):
    for name, dataset in root.get(group, {}).items():
        path = f"{group}/{name}"
        check.rule(dataset.dtype.kind in "fiu", f"{path} is {dataset.dtype}, not a number")
        check.rule(dataset.ndim in (1, 2), f"{path} has rank {dataset.ndim}")
        check.rule(rows == 0 or dataset.shape[0] % rows == 0, f"{path} does not hold whole slots of {rows} rows")
        check.rule("unit" in dataset.attrs, f"{path} has no unit")
        check_moving(check, path, dataset, steps.get(f"{group}Offsets/{name}"), rows, n_steps)


def check_steps(check, root, n_points, n_cells):
    steps, points = root.get("Steps"), root.get("Points")
    if not check.rule(steps is not None and points is not None, "Points or Steps is missing"):
        return
    check.rule(points.dtype.kind == "f" and points.ndim == 2 and points.shape[1] == 3,
               "Points is not a list of three reals")
    check.rule("NSteps" in steps.attrs and steps.attrs["NSteps"].dtype == np.int64, "NSteps is not an int64")
    n_steps = int(steps.attrs.get("NSteps", 0))
    check.rule(n_steps > 0, "there is no state")
    values = steps.get("Values")
    if check.rule(values is not None and values.dtype == np.float64 and values.shape == (n_steps,),
                  "Steps/Values is not one float64 per step"):
        check.rule(np.all(np.diff(values[:]) >= 0), "times run backwards")
    for name, shape, value in (("PartOffsets", (n_steps,), 0), ("NumberOfParts", (n_steps,), 1),
                               ("CellOffsets", (n_steps, 1), 0), ("ConnectivityIdOffsets", (n_steps, 1), 0)):
        if check.is_int64(steps.get(name), shape, f"Steps/{name}"):
            check.rule(np.all(steps[name][:] == value), f"Steps/{name} is not {value} throughout")
    check_moving(check, "Points", points, steps.get("PointOffsets"), n_points, n_steps)
    check_fields(check, root, steps, "PointData", n_points, n_steps)
    check_fields(check, root, steps, "CellData", n_cells, n_steps)


def check_file(name):
    check = Checker(name)
    with h5py.File(name, "r") as file:
        if check.rule("VTKHDF" in file, "there is no group /VTKHDF"):
            root = file["VTKHDF"]
            check_root(check, root)
            check_steps(check, root, *check_topology(check, root))
    return check.broken


def main(names):
    if not names:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    broken = [sentence for name in names for sentence in check_file(name)]
    print("\n".join(broken) if broken else "every VTKHDF rule holds")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
