#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures speed and error of a trawl of 5000 nodes that moves in real time, against a reference by another scheme.

    real_time.py NETLOFT SOURCE_FOLDER [REPEATS]

The scene of the library runs unchanged on two threads. The reference is made by another family of schemes in steps of equal
length (ARKODE's ESDIRK3, on one thread: three CPU minutes), once with h and once with h/2: the difference between these two is the
error of the reference, and has to be far below the reported error. Errors are distances between positions at equal times, over
all outputs, as fractions of the distance that the middle of the headline moves.
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import processor_time  # noqa: E402

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
REPEATS = int(sys.argv[3]) if len(sys.argv) > 3 else 1
SCENE = SOURCE / "gear-library" / "scenes" / "dynamics" / "trawl-speeds-up.toml"
HEADLINE = ("mouth_x", "mouth_y", "mouth_height")
STEP = 0.25  # step of the coarser reference [s], at most the time between outputs
OTHER_SCHEME = ["analysis.integrator=arkode", "analysis.adaptive=false", "analysis.dense=false", "analysis.tolerance=1e-5"]


class Run:
    """One run of the scene, with the CPU time of the whole program and that of the motion."""

    def __init__(self, threads, *settings):
        words = [NETLOFT, "run", SCENE, "--json", "--threads", str(threads)]
        for setting in settings:
            words += ["--set", setting]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "out.hdf"
            before = processor_time.of_children()
            done = subprocess.run([*words, "-o", file], capture_output=True, text=True, check=False)
            self.program_seconds = processor_time.of_children() - before
            if done.returncode:
                raise SystemExit(done.stderr + done.stdout)
            self.answer = json.loads(done.stdout)
            with h5py.File(file) as f:
                steps, grid = f["VTKHDF/Steps"], f["VTKHDF"]
                count, nodes = int(steps.attrs["NSteps"]), int(grid["NumberOfPoints"][0])
                self.times = steps["Values"][:count]
                self.places = np.array([grid["Points"][o:o + nodes] for o in steps["PointOffsets"][:count]])
                self.headline = np.array([f["netloft/series"][name][:count] for name in HEADLINE]).T

    def tell(self, name):
        a = self.answer
        print(f"{name}: {a['integrator']}, {a['steps']} steps of {a['shortest_step']:.3g} to {a['longest_step']:.3g} s, "
              f"{a['wall_seconds']['solver_total']:.4g} s, {a['cpu_seconds']:.4g} CPU s", flush=True)


def furthest(path, reference):
    return np.linalg.norm(path - reference, axis=-1).max()


def way_of(path):
    return np.linalg.norm(path - path[0], axis=-1).max()


def load():
    return f"load {os.getloadavg()[0]:.2f} on {os.cpu_count()} cores"


def print_factors(runs, loads):
    for run, before in zip(runs, loads):
        a = run.answer
        simulated = a["time"]
        print(f"  {before}: real-time factor {a['real_time_factor']:.3g} ({a['wall_seconds']['solver_total']:.3g} s for {simulated:g} s), "
              f"{a['cpu_seconds']:.3g} CPU s; by CPU time alone {simulated / a['cpu_seconds']:.3g}")
        rest = run.program_seconds - a["cpu_seconds"]
        print(f"    not counted: {rest:.3g} CPU s for the equilibrium at the start, reading and writing; "
              f"with them {simulated / run.program_seconds:.3g} by CPU time")


def print_errors(run, coarse, fine):
    assert np.array_equal(run.times, fine.times) and np.array_equal(coarse.times, fine.times)
    way = way_of(fine.headline)
    print(f"  the middle of the headline goes {way:.3g} m")
    for name, of in (("headline", lambda r: r.headline), ("worst node", lambda r: r.places)):
        error, own = furthest(of(run), of(fine)), furthest(of(coarse), of(fine))
        print(f"  {name}: error {error:.3g} m, {error / way:.2%} of that way; the reference's own, between its two steps, "
              f"{own:.3g} m, {own / way:.4%}")


if __name__ == "__main__":
    runs, loads = [], []
    for _ in range(REPEATS):
        loads.append(load())
        runs.append(Run(2))
        runs[-1].tell("the scene as it stands")
    print(f"{runs[0].answer['unknowns']} unknowns, {len(runs[0].places[0])} nodes, 2 threads")
    print_factors(runs, loads)
    references = []
    for h in (STEP, STEP / 2):
        references.append(Run(1, *OTHER_SCHEME, f"analysis.step={h}"))
        references[-1].tell("reference")
    print_errors(runs[0], *references)
