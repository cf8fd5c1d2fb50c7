#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of the strategy `auto` for whole gears, which are not in the suite of hard cases.

    library_gears.py NETLOFT LIBRARY [--nodes 500,1000,1500] [--only TEXT]

Solves every scene of LIBRARY/scenes that has a whole gear, from its sketch and with each number of nodes. Prints how each solve
ended, its factorisations and processor time, and the sums.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

PIECES = ("codend-from-plan", "dead-weight-panel", "hanging-rope")  # scenes without a whole gear
DONE, NOT_CONVERGED = 0, 3


def solve(netloft, scene, nodes):
    with tempfile.TemporaryDirectory() as folder:
        ended = subprocess.run([netloft, "run", scene, "--strategy", "auto", "--set", f"gear.nodes={nodes}", "--json"],
                               cwd=folder, capture_output=True, text=True, check=False)
    if ended.returncode not in (DONE, NOT_CONVERGED):
        sys.exit(f"{scene}: exit {ended.returncode}\n{ended.stderr}")
    return json.loads(ended.stdout)


def main():
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("netloft", type=lambda name: str(Path(name).resolve()))
    p.add_argument("library", type=lambda name: Path(name).resolve())
    p.add_argument("--nodes", default="500,1000,1500")
    p.add_argument("--only", default="", help="scenes whose name contains this")
    words = p.parse_args()
    scenes = [s for s in sorted((words.library / "scenes").glob("*.toml")) if s.stem not in PIECES and words.only in s.stem]
    print("| scene | nodes | status | factorisations | CPU [s] |\n|---|---|---|---|---|")
    runs = []
    for scene in scenes:
        for nodes in words.nodes.split(","):
            run = solve(words.netloft, scene, nodes)
            runs.append(run)
            print(f"| {scene.stem} | {nodes} | {run['status']} | {run['factorisations']} | {run['cpu_seconds']:.2f} |", flush=True)
    counts = [run["factorisations"] for run in runs]
    print(f"\n{len(runs)} runs, {sum(run['status'] == 'converged' for run in runs)} converged, {sum(counts)} factorisations, "
          f"at most {max(counts)}, {sum(run['cpu_seconds'] for run in runs):.0f} s")


if __name__ == "__main__":
    main()
