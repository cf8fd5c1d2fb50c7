# SPDX-License-Identifier: BSD-3-Clause
"""One board on one warp, solved independently: Newton's method on three angles, with derivatives by differences.

The board is a flat plate (plugins/board/plate.hpp, equations (1) to (6), written down here once more), heavy and buoyant, on a
line without weight or drag. At rest the forces of water, weight and buoyancy have no moment about the eye, which are three
equations for heading, heel and trim; the line then leads along their sum.
"""
import math

import numpy as np


def axes(heading, heel, trim):
    """Columns: x aft, y outward (starboard), z up, after heel about x, trim about y, heading about z."""
    def turn(axis, angle):
        c, s = math.cos(angle), math.sin(angle)
        i, j = (axis + 1) % 3, (axis + 2) % 3
        m = np.eye(3)
        m[i, i], m[j, j], m[i, j], m[j, i] = c, c, -s, s
        return m
    return turn(2, -heading) @ turn(1, trim) @ turn(0, -heel)


def step(t):
    return 0 if t <= 0 else 1 if t >= 1 else t * t * (3 - 2 * t)


def plate(w, chord, span):
    """C_N along y, and its centre of pressure along chord and span."""
    c2, s = w[0]**2 + w[2]**2, abs(w[1])
    c = math.sqrt(c2)
    aspect = (span / chord) ** ((w[0]**2 - w[2]**2) / c2)
    Kp, Kv = 2 * math.pi * aspect / (2 + math.sqrt(aspect**2 + 4)), 3.1
    C90 = 1.11 + 0.018 * max(span / chord, chord / span)
    stall = math.radians(38) * (1 + aspect**4) ** -0.16
    ss, cs = math.sin(stall), math.cos(stall)
    rising = Kp * s * c + Kv * s * s
    falling = C90 * s + (Kp * ss * cs + Kv * ss * ss - C90 * ss) * math.tan(stall) * c / s
    half = math.radians(8)
    past = step((math.atan2(s, c) - stall + half) / (2 * half))
    normal = rising + past * (falling - rising)
    xi = 0.25 * aspect**1.25 / (aspect**1.25 + 0.48)
    way = (chord * w[0]**2 + span * w[2]**2) / c2
    ahead = (0.5 - xi) * way * Kp * c / (Kp * c + Kv * s)
    return math.copysign(normal, w[1]), -ahead * w[0] / c, -ahead * w[2] / c


def forces(board, angles, flow, rho, g):
    """(force, point) pairs in the axes of the world; points are relative to the origin of the board."""
    R = axes(*angles)
    u = np.linalg.norm(flow)
    w = R.T @ (np.array(flow) / u)
    normal, along, up = plate(w, board["chord"], board["span"])
    q = 0.5 * rho * board["area"] * u * u
    water = q * (board.get("parasite", 0) * w + np.array([0, normal, 0]))
    return [(R @ water, R @ np.array([along, 0, up])),
            (np.array([0, 0, -board["mass"] * g]), R @ np.array(board["centre"])),
            (np.array([0, 0, board["volume"] * rho * g]), R @ np.zeros(3))]


def imbalance(board, eye, angles, flow, rho, g):
    """The moment of all forces about the eye."""
    all_forces = forces(board, angles, flow, rho, g)
    at = axes(*angles) @ np.array(eye)
    return sum(np.cross(x - at, f) for f, x in all_forces)


def attitude(board, eye, flow, start, rho=1025, g=9.80665):
    """Heading, heel and trim [rad] from a guess, and the sum of forces that the line must bear."""
    a = np.array(start, float)
    for _ in range(60):
        m = imbalance(board, eye, a, flow, rho, g)
        J = np.empty((3, 3))
        for k in range(3):
            h = np.zeros(3)
            h[k] = 1e-6
            J[:, k] = (imbalance(board, eye, a + h, flow, rho, g) - imbalance(board, eye, a - h, flow, rho, g)) / 2e-6
        da = -np.linalg.solve(J, m)
        a += da * min(1, 0.2 / np.abs(da).max())
        if np.abs(da).max() < 1e-13:
            break
    return a, sum(f for f, _ in forces(board, a, flow, rho, g))


if __name__ == "__main__":
    board = {"area": 4.86, "chord": 2.7, "span": 1.8, "mass": 816, "volume": 0.104, "centre": (0, 0, -0.3), "parasite": 0.05}
    for eye in ((-0.3, -0.8, 0.05), (-0.2, -0.8, 0), (-0.25, -1.0, 0.1)):
        a, f = attitude(board, eye, (1.54, 0, 0), np.radians((35, 0, 0)))
        print(eye, np.degrees(a), f)
