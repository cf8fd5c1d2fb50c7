#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the longest stable step of the fixed-point scheme of the trawl-gear paper, independently in a few lines of NumPy.

    stability_limit.py NETLOFT SOURCE_FOLDER

Only the positions of the nodes at rest come from NETLOFT. Stiffness and masses of Priour's triangle are computed here, the
stiffness from the energy alone (first derivatives by complex steps, second derivatives by differences), and the highest
frequency by power iteration:
    h < 1/(√β ω_max),  ω_max² the largest eigenvalue of M⁻¹ K,  √β = 0.65                                  (1)
for two conventions of the mass: the twine alone, as in the paper, and with the added mass of water across the twine.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np
from scipy.sparse import coo_matrix

NETLOFT, SCENES = sys.argv[1], Path(sys.argv[2]) / "gear-library" / "scenes"
RHO, WATER = 2000.0, 1025.0
# EA, EA in compression [N], bar, diameter [m], H [N m/rad], meshes across and along
PANELS = {"dead-weight-panel": (1e4, 1.0, 0.6, 0.01, 0.0, 40, 40),
          "verification/stretched-panel": (10.0, 10.0, 5.7e-3, 1e-4, 1e-3, 61, 50)}


def places(scene, n):
    """Returns the positions of the nodes at rest, row by row."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rest.hdf"
        subprocess.run([NETLOFT, "run", SCENES / (scene + ".toml"), "-o", file, "--set", f"parts.net.cells=[{n},{n}]"],
                       check=True, capture_output=True)
        with h5py.File(file) as f:
            return f["VTKHDF/Points"][()]


def triangles(n):
    """Returns the triangles of n x n cells. The diagonal of cell (i, j) is (i, j)-(i+1, j+1) if i+j is even."""
    at = lambda i, j: j * (n + 1) + i
    for j in range(n):
        for i in range(n):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            yield from ((a, b, c), (a, c, d)) if (i + j) % 2 == 0 else ((a, b, d), (b, c, d))


def twine_vectors(t, n, across, along):
    """(U, V) = Σ (cu, cv) x of the corners, and bars per direction."""
    m, k = across * (t % (n + 1)) / n, along * (t // (n + 1)) / n
    u, v = m + k, k - m
    d = (u[:, 1] - u[:, 0]) * (v[:, 2] - v[:, 0]) - (u[:, 2] - u[:, 0]) * (v[:, 1] - v[:, 0])
    nxt, last = [1, 2, 0], [2, 0, 1]
    return (v[:, nxt] - v[:, last]) / d[:, None], (u[:, last] - u[:, nxt]) / d[:, None], np.abs(d) / 2


def energy(w, bars, EA, EAc, l0, H):
    """Returns the energy of every triangle from its two twine vectors (6 numbers)."""
    U, V = w[:, :3], w[:, 3:]
    L = [np.sqrt((x * x).sum(axis=1)) for x in (U, V)]
    spring = sum(np.where(x.real > l0, EA, EAc) / (2 * l0) * (x - l0) ** 2 for x in L)
    half = 0.5 * np.arccos((U * V).sum(axis=1) / (L[0] * L[1])) if H else 0
    return bars * (spring + H * half ** 2)


def stiffness(w, *material):
    """Returns the second derivatives of the energy with respect to the twine vectors, 6 x 6."""
    def gradient(at):
        columns = []
        for k in range(6):
            z = at.astype(complex)
            z[:, k] += 1e-30j
            columns.append(energy(z, *material).imag / 1e-30)
        return np.array(columns).T
    K = np.empty((len(w), 6, 6))
    step = 1e-6 * np.abs(w).max()
    for k in range(6):
        d = np.zeros(6)
        d[k] = step
        K[:, :, k] = (gradient(w + d) - gradient(w - d)) / (2 * step)
    return 0.5 * (K + K.transpose(0, 2, 1))


def highest_frequency(scene, n, added_mass):
    EA, EAc, l0, diameter, H, across, along = PANELS[scene]
    x, t = places(scene, n), np.array(list(triangles(n)))
    cu, cv, bars = twine_vectors(t, n, across, along)
    w = np.hstack([np.einsum("ec,ecr->er", cu, x[t]), np.einsum("ec,ecr->er", cv, x[t])])
    # The matrix from the corners to the twine vectors, 6 x 9.
    B = np.concatenate([np.einsum("ec,rs->ercs", c, np.eye(3)).reshape(len(t), 3, 9) for c in (cu, cv)], axis=1)
    K = np.einsum("eia,eij,ejb->eab", B, stiffness(w, bars, EA, EAc, l0, H), B)
    dof = (3 * t[:, :, None] + np.arange(3)).reshape(len(t), 9)
    size = 3 * len(x)
    K = coo_matrix((K.ravel(), (np.repeat(dof, 9, axis=1).ravel(), np.tile(dof, (1, 9)).ravel())), (size, size)).tocsr()
    M = np.zeros((len(x), 3, 3))
    third = bars * np.pi / 4 * diameter ** 2 * l0 / 3  # volume per corner of the twines of each direction
    for a in (w[:, :3], w[:, 3:]):
        s = a / np.linalg.norm(a, axis=1)[:, None]
        block = third[:, None, None] * (RHO * np.eye(3) + added_mass * WATER * (np.eye(3) - s[:, :, None] * s[:, None, :]))
        for corner in range(3):
            np.add.at(M, t[:, corner], block)
    free = np.ones(len(x))
    free[:n + 1] = 0
    if scene.endswith("stretched-panel"):
        free[-(n + 1):] = 0
    inverse = np.linalg.inv(M) * free[:, None, None]
    y, previous = np.random.default_rng(1).standard_normal((len(x), 3)), 0
    for _ in range(20000):
        y /= np.linalg.norm(y)
        y = np.einsum("nij,nj->ni", inverse, (K @ (y * free[:, None]).ravel()).reshape(-1, 3))
        largest = np.linalg.norm(y)
        if abs(largest - previous) < 1e-8 * largest:
            break
        previous = largest
    return largest ** 0.5


if __name__ == "__main__":
    print("scene                         cells   twine alone [s]   with added mass [s]")
    for panel, sizes in zip(PANELS, ((16, 32, 64), (8, 16, 32))):
        for cells in sizes:
            h = [1 / (0.65 * highest_frequency(panel, cells, added)) for added in (0.0, 1.0)]
            print(f"{panel:30} {cells:4} {h[0]:17.3g} {h[1]:21.3g}", flush=True)
