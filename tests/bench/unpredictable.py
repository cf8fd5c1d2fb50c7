#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shows which results of a chaotic motion are predictable: a slack chain falls and snaps taut, in air, with damped bars, and in water.

    unpredictable.py NETLOFT

Each motion is run from two starts that differ by 1e-9 m at one end. Columns: the largest distance of a node between both runs at the end, over the
length of an element; then, for each start, the largest tension, the lowest point, and the mean height of all nodes over the second half.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

CELLS, LENGTH = 40, 10
SCENE = """
[water]
density = {water}
gravity = 9.81
[parts.chain]
type = "rope/bar"
length = {length}
cells = {cells}
sketch = [[0, 0, 0], [1, 0, -4.9], [2, 0, 0]]
rope = {{ diameter = "20 mm", EA = "50 kN", EA_compression = 0, density = {density}, damping = {damping} }}
[[hold]]
on = "chain.start"
[analysis]
kind = "dynamic"
duration = 3
output_interval = 0.01
"""
MOTIONS = {"air": dict(water=0, density=1140, damping=0), "air, damped": dict(water=0, density=1140, damping=50),
           "water": dict(water=1025, density=7800, damping=0)}


def run(netloft, scene, accuracy, end, folder):
    output = folder / "out.hdf"
    subprocess.run([netloft, "run", scene, "-o", output, "--overwrite", "--threads", "1", "--set", f"analysis.accuracy={accuracy}",
                    "--set", f"parts.chain.sketch=[[0,0,0],[1,0,-4.9],[{end:.10g},0,0]]"], check=True, capture_output=True)
    with h5py.File(output) as f:
        def states(data, field, count):
            first = f[f"VTKHDF/Steps/{data}DataOffsets/{field}"][()]
            return np.array([f[f"VTKHDF/{data}Data/{field}"][k:k + count] for k in first])
        places = np.array([f["VTKHDF/Points"][k:k + CELLS + 1] for k in f["VTKHDF/Steps/PointOffsets"][()]])
        return places, states("Cell", "tension", CELLS)


def main():
    print(f"{'motion':12} {'accuracy':>8} {'apart':>9}   {'peak tension [N]':>16}   {'lowest [m]':>15}   {'mean height [m]':>15}")
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for name, numbers in MOTIONS.items():
            scene = folder / "scene.toml"
            scene.write_text(SCENE.format(cells=CELLS, length=LENGTH, **numbers))
            for accuracy in ("1e-1", "1e-2", "1e-3", "1e-4"):
                (a, tension_a), (b, tension_b) = (run(sys.argv[1], scene, accuracy, end, folder) for end in (2, 2 + 1e-9))
                apart = np.linalg.norm(a[-1] - b[-1], axis=-1).max() / (LENGTH / CELLS)
                half = len(a) // 2
                print(f"{name:12} {accuracy:>8} {apart:9.1e}   {np.nanmax(tension_a):7.0f} {np.nanmax(tension_b):8.0f}   "
                      f"{a[..., 2].min():7.2f} {b[..., 2].min():7.2f}   {a[half:, :, 2].mean():7.2f} {b[half:, :, 2].mean():7.2f}", flush=True)


if __name__ == "__main__":
    main()
