# SPDX-License-Identifier: BSD-3-Clause
"""Compares FEMNET's moments of bending and clamps, which use actual lengths of bars, with Netloft's, which use unstretched lengths: equilibria of gear 07 by both, with softer and softer ropes. Needs numpy; prints the table of README.md.

Gear 07: two ropes of 1.5 m in three bars each, clamped to one another at 120 degrees. FEMNET's answer is the check of the formulas.
"""
import json
from pathlib import Path

import numpy as np

FEMNET = np.array(json.loads((Path(__file__).parent / "07_bending_rest_angle.expected.json").read_text())["positions_m"])
CURRENT, WATER, GRAVITY = np.array([0.4, 0, 0]), 1025.0, 9.81
LENGTH, DIAMETER, DENSITY, DRAG, FRICTION = 0.5, 0.03, 950.0, 1.2, 0.08  # of a bar [m], [kg/m3]
ROPE, EI = [0, 0, 0, 1, 1, 1], [80.0, 60.0]  # rope of each bar; [N m2]
LOAD = np.array([0, 6, -20.0])  # on the last node [N]
FREE = slice(6, 21)  # the first two nodes are held


def bar_forces(x, EA):
    """Tension, weight in water and drag, half at each end."""
    forces = np.zeros_like(x)
    for k in range(6):
        w = x[k + 1] - x[k]
        e, length = w / np.linalg.norm(w), np.linalg.norm(w)
        pull = EA * (length - LENGTH) / LENGTH * e
        lift = LENGTH * np.pi * DIAMETER**2 / 4 * GRAVITY * (WATER - DENSITY)
        speed = np.linalg.norm(CURRENT)
        along, across = e @ CURRENT / speed, CURRENT - (CURRENT @ e) * e
        q = WATER / 2 * DRAG * LENGTH * DIAMETER * speed**2
        water = q * (1 - along**2) * across / max(np.linalg.norm(across), 1e-12) + FRICTION * q * along * abs(along) * e
        forces[k] += pull + water / 2 + [0, 0, lift / 2]
        forces[k + 1] += -pull + water / 2 + [0, 0, lift / 2]
    return forces


def moments(x, lengths_are_present):
    """Forces of bending within a rope, and of the clamp where the ropes meet."""
    forces = np.zeros_like(x)
    for k in range(5):
        a, b = x[k + 1] - x[k], x[k + 2] - x[k + 1]
        la, lb = np.linalg.norm(a), np.linalg.norm(b)
        is_clamp = ROPE[k] != ROPE[k + 1]
        turn = np.arccos(np.clip(a @ b / (la * lb), -1, 1))
        if np.sin(turn) < 1e-9: continue
        beyond = turn - (np.radians(60) if is_clamp else 0)
        stiffness = min(EI) if is_clamp else EI[ROPE[k]]
        p, q = (la, lb) if lengths_are_present else (LENGTH, LENGTH)
        m = 2 * stiffness * np.sin(beyond) / np.sqrt(p * p + q * q + 2 * p * q * np.cos(beyond)) / (la * lb * np.sin(turn))
        first, last = m * (a * (a @ b) / la**2 - b), m * (a - b * (a @ b) / lb**2)
        forces[k] += first
        forces[k + 2] += last
        forces[k + 1] -= first + last
    return forces


def residual(x, EA, lengths_are_present):
    forces = bar_forces(x, EA) + moments(x, lengths_are_present)
    forces[6] += LOAD
    return forces.ravel()[FREE]


def equilibrium(EA, lengths_are_present, start):
    """By Newton's method with central differences; steps are halved until the residual falls."""
    def f(free):
        x = np.concatenate([start.ravel()[:6], free]).reshape(-1, 3)
        return residual(x, EA, lengths_are_present)

    free, h = start.ravel()[FREE].copy(), 1e-7
    for _ in range(200):
        r = f(free)
        if np.linalg.norm(r) < 1e-9: break
        slope = np.array([(f(free + h * d) - f(free - h * d)) / (2 * h) for d in np.eye(15)]).T
        step, t = np.linalg.solve(slope, -r), 1.0
        while t > 1e-4 and np.linalg.norm(f(free + t * step)) >= np.linalg.norm(r): t /= 2
        free = free + t * step
    assert np.linalg.norm(f(free)) < 1e-8, "no equilibrium"
    return np.concatenate([start.ravel()[:6], free]).reshape(-1, 3)


def main():
    assert abs(equilibrium(1e5, True, FEMNET) - FEMNET).max() < 1e-6, "these are not the formulas of FEMNET"
    print("| EA [N] | largest strain | positions differ by [m] |\n|---|---|---|")
    femnet = netloft = FEMNET
    for EA in (1e5, 1e4, 1e3, 200):
        femnet, netloft = equilibrium(EA, True, femnet), equilibrium(EA, False, netloft)
        strain = (np.linalg.norm(np.diff(femnet, axis=0), axis=1) / LENGTH - 1).max()
        print(f"| {EA:g} | {strain:.1e} | {abs(femnet - netloft).max():.1e} |")


if __name__ == "__main__":
    main()
