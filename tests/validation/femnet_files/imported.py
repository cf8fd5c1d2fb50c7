# SPDX-License-Identifier: BSD-3-Clause
"""Gears of FEMNET that the program imports, and checks or solves in a separate folder. NETLOFT_PROGRAM names the program."""
import os
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

PROGRAM = os.environ["NETLOFT_PROGRAM"]


def mesh_of(gear, *how):
    """The mesh of an imported gear: its number of nodes, and its regions as rows of numbers."""
    with tempfile.TemporaryDirectory() as folder:
        ended = subprocess.run([PROGRAM, "import", "femnet", str(gear), "-o", "gear.toml", *how], cwd=folder, capture_output=True, text=True)
        assert ended.returncode == 0, ended.stderr
        regions, rows = {}, None
        for line in (Path(folder) / "gear.mesh").read_text().splitlines():
            words = line.split("#")[0].split()
            if line.startswith("["):
                rows = regions.setdefault(line.split("]")[0].lstrip("["), [])
            elif words and rows is not None:
                rows.append([float(w) for w in words])
        return len(regions["nodes"]), regions


def twine_sides(rows):
    """Sides of meshes in all triangles of a region: u = U + V, v = V - U."""
    UV = np.array(rows)[:, 3:].reshape(-1, 3, 2)
    a, b = UV[:, 1] - UV[:, 0], UV[:, 2] - UV[:, 0]
    return 2 * np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum()


class Gear:
    """`at`: positions of the nodes of the mesh instead of those in the file; `more`: lines added to the scene; `codes`: exit codes of a run;
    `how`: words of the import; `sets`: keys that are set for the run."""

    def __init__(self, gear, at=None, more="", codes=(0,), how=(), sets=()):
        with tempfile.TemporaryDirectory() as folder:
            self.folder = Path(folder)
            self.said = self.netloft("import", "femnet", gear, "-o", "gear.toml", *how)
            if at is not None:
                self.move(at)
            with open(self.folder / "gear.toml", "a") as scene:
                scene.write(more)
            self.report = self.netloft("run", "gear.toml", "-o", "gear.hdf", *(word for key in sets for word in ("--set", key)), codes=codes)
            self.mesh = (self.folder / "gear.mesh").read_text()
            with h5py.File(next(self.folder.glob("gear*.hdf"))) as f:
                self.read(f)

    def netloft(self, *words, codes=(0,)):
        ended = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True, timeout=240)
        assert ended.returncode in codes, ended.stdout + ended.stderr
        return ended.stdout + ended.stderr

    def move(self, at):
        lines = (self.folder / "gear.mesh").read_text().splitlines()
        begin = next(i for i, line in enumerate(lines) if line.startswith("[nodes]")) + 1
        lines[begin:begin + len(at)] = [" ".join(repr(float(x)) for x in point) for point in at]
        (self.folder / "gear.mesh").write_text("\n".join(lines) + "\n")

    def read(self, f):
        points, cells = f["VTKHDF/NumberOfPoints"][0], f["VTKHDF/NumberOfCells"][0]
        self.points = f["VTKHDF/Points"][:points]
        self.residual = f["VTKHDF/PointData/residual"][:points]
        self.reaction = f["VTKHDF/PointData/reaction"][:points]
        offsets, nodes = f["VTKHDF/Offsets"][:cells + 1], f["VTKHDF/Connectivity"][:]
        self.cells = [nodes[offsets[c]:offsets[c + 1]] for c in range(cells)]
        self.scalars = {name: value[()] for name, value in f.get("netloft/scalars", {}).items()}
        self.data = {name: f[f"VTKHDF/CellData/{name}"][:cells] for name in f["VTKHDF/CellData"]}

    def furthest(self, there):
        """Largest distance of a position from the nearest node."""
        return max(np.linalg.norm(self.points - x, axis=1).min() for x in np.asarray(there))

    def of_cells(self, name, nodes):
        """A quantity of all cells with this number of nodes, sorted."""
        return np.sort([self.data[name][c] for c, own in enumerate(self.cells) if len(own) == nodes])

    def bar_tensions(self):
        return self.of_cells("tension", 2)

    def twine_tensions(self):
        return np.sort(np.concatenate([self.of_cells("tension_u", 3), self.of_cells("tension_v", 3)]))
