#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures speed and error of a bottom trawl that speeds up, turns with winches at constant tension and hauls, and resumes a killed run.

    trawl_in_motion.py NETLOFT SOURCE_FOLDER [--nodes 1000] [--accuracy 0.01] [--finer 10] [--set KEY=VALUE]... [--keep FOLDER]

Runs gear-library/scenes/dynamics/83-112-in-motion.toml on one thread at the accuracy, and at one that is `finer` times finer; --set
applies to both. The error of a node is its largest distance from its position in the finer run, at the outputs of a stage, over the
length of its path: for the node in the middle and for the worst node, with part and time. Energy is the part that the scheme dissipates
of the work of ship and winches; the error of tensions at the blocks is the root mean square over the mean, smoothed over 10 s. The
coarser run is then killed half way, resumed, and compared bit by bit. With --keep, runs that are in the folder are not repeated.
"""
import argparse
import json
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py
import numpy as np

STAGES = (("speeds up", 0, 20), ("turns", 20, 145), ("hauls", 145, 200))  # begin and end in the scene [s]
WARPS = "starboard-warp", "port-warp"


class Run:
    """One run: the program's answer and, by output, times, positions of nodes and tensions at the blocks."""

    def __init__(self, file):
        self.answer = json.loads(file.with_suffix(".json").read_text())
        with h5py.File(file) as f:
            grid, series = f["VTKHDF"], f["netloft/series"]
            nodes, self.times = int(grid["NumberOfPoints"][0]), grid["Steps/Values"][()]
            self.places = np.array([grid["Points"][o:o + nodes] for o in grid["Steps/PointOffsets"][()]])
            self.tensions = [series[f"gear/warps/{warp}/tension"][()] for warp in WARPS]

    def tell(self, name):
        a = self.answer
        loss = a["numerical_loss"]
        print(f"| {name} | {a['steps']} | {a['rejected_steps']} | {a['iterations']} | {a['cpu_seconds']:.3g} | {a['cpu_seconds'] / a['time']:.2g} "
              f"| {loss['lost'] / loss['given']:.1e} |", flush=True)


def command(asked, accuracy, file, *options):
    words = [asked.netloft, "run", asked.source / "gear-library/scenes/dynamics/83-112-in-motion.toml", "--json", "--threads", "1", "-o", file]
    for setting in [f"gear.nodes={asked.nodes}", f"analysis.accuracy={accuracy}", *asked.set]:
        words += ["--set", setting]
    return [*words, *options]


def run(asked, accuracy, folder):
    file = folder / f"{asked.nodes}-{accuracy:g}.hdf"
    if not file.exists():
        done = subprocess.run(command(asked, accuracy, file, "--overwrite"), capture_output=True, text=True, check=False)
        if done.returncode:
            raise SystemExit(done.stderr[-2000:] + done.stdout)
        file.with_suffix(".json").write_text(done.stdout)
    return Run(file)


def smoothed(values, seconds):
    return np.convolve(values, np.ones(seconds) / seconds, "valid")


def print_errors(coarse, fine):
    shared = min(len(coarse.times), len(fine.times))  # one of the runs may have ended early
    assert np.array_equal(coarse.times[:shared], fine.times[:shared])
    apart = np.linalg.norm(coarse.places[:shared] - fine.places[:shared], axis=-1)
    way = np.linalg.norm(np.diff(fine.places[:shared], axis=0), axis=-1).sum(axis=0)
    print(f"\nThe way of the node in the middle is {np.median(way):.4g} m long, until t = {fine.times[shared - 1]:g} s.\n")
    print("| it | node in the middle [%] | worst node [%] | which | at t [s] | warps' tension [%] |\n|---|---|---|---|---|---|")
    for name, begin, end in (*STAGES, ("in all", 0, np.inf)):
        of = (fine.times[:shared] >= begin) & (fine.times[:shared] <= end)
        if not of.any():
            continue
        errors = apart[of].max(axis=0) / way
        worst = int(errors.argmax())
        pull = [np.sqrt(np.mean(smoothed(a[:shared][of] - b[:shared][of], 10) ** 2)) / b[:shared][of].mean() for a, b in zip(coarse.tensions, fine.tensions)]
        print(f"| {name} | {100 * np.median(errors):.2f} | {100 * errors.max():.2f} | node {worst}, {way[worst]:.4g} m "
              f"| {fine.times[:shared][of][apart[of, worst].argmax()]:g} | {', '.join(f'{100 * p:.2f}' for p in pull)} |", flush=True)


def print_resumed(asked, accuracy, whole, folder):
    """Kills a run when half of its outputs are written, resumes it, and prints whether the result has the same bits."""
    sys.path.insert(0, str(asked.source / "tests" / "support"))
    from journal import Damaged, Journal
    file, seen = folder / "killed.hdf", 0
    part = Path(f"{file}.part")
    running = subprocess.Popen(command(asked, accuracy, file, "--overwrite"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while running.poll() is None and seen < len(whole.times) // 2:
        time.sleep(0.2)
        try:
            seen = len(Journal(part).outputs)
        except (OSError, Damaged):
            pass  # the file does not exist yet
    running.send_signal(signal.SIGKILL)
    running.wait()
    done = subprocess.run(command(asked, accuracy, file, "--resume"), capture_output=True, text=True, check=True)
    file.with_suffix(".json").write_text(done.stdout)
    again = Run(file)
    same = again.places.tobytes() == whole.places.tobytes() and all(a.tobytes() == b.tobytes() for a, b in zip(again.tensions, whole.tensions))
    print(f"\nKilled after {seen} outputs and resumed at t = {again.answer['resumed_from']:.4g} s: {'the same bits' if same else '**other bits**'}.")
    return same


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("netloft")
    words.add_argument("source", type=Path)
    words.add_argument("--nodes", type=int, default=1000)
    words.add_argument("--accuracy", type=float, default=0.01)
    words.add_argument("--finer", type=float, default=10)
    words.add_argument("--set", action="append", default=[])
    words.add_argument("--keep", type=Path)
    asked = words.parse_args()
    with tempfile.TemporaryDirectory() as there:
        folder = asked.keep or Path(there)
        print("| run | steps | rejected | iterations | CPU s | for a second | energy |\n|---|---|---|---|---|---|---|")
        runs = []
        for accuracy in (asked.accuracy, asked.accuracy / asked.finer):
            runs.append(run(asked, accuracy, folder))
            runs[-1].tell(f"{asked.nodes} nodes, accuracy {accuracy:g}")
        print_errors(*runs)
        if not print_resumed(asked, asked.accuracy, runs[0], Path(there)):
            raise SystemExit(1)


if __name__ == "__main__":
    main()
