#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The work of the default strategy on each gear of the library, divided by that of the best of its attempts alone.

  attempts.py NETLOFT SOURCE_FOLDER [--nodes 1000] [--only TEXT]

Work is counted in Newton iterations of the scene, and includes the judgement of stability. A single attempt is stopped when it has done as much work as the default strategy, because only cheaper attempts count.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

PIECES = ("codend-from-plan", "dead-weight-panel", "hanging-rope")  # scenes without a whole gear
ATTEMPTS = {"coarse-to-fine": "coarse-to-fine:by=auto:restarts=0,then=tension/only:least_slack=0.33", "tension-stages": "tension/stages", "direct": "direct",
            "stiffness-steps": "stiffness-steps", "pseudo-time": "pseudo-time"}


def solve(program, scene, strategy, nodes, work=None):
    with tempfile.TemporaryDirectory() as folder:
        budget = ["--set", f"analysis.work={work:.0f}"] if work else []
        ended = subprocess.run([program, "run", scene, "--strategy", strategy, "--threads", "1", "--json", "-o", f"{folder}/found.hdf",
                                "--set", f"gear.nodes={nodes}", *budget], capture_output=True, text=True)
    report = json.loads(ended.stdout) if ended.stdout.startswith("{") else {}
    if "stages" not in report:
        sys.exit(f"{scene}: {ended.stderr}{ended.stdout}")
    return report


def row_of(program, scene, nodes):
    whole = solve(program, scene, "auto", nodes)
    alone = {name: solve(program, scene, strategy, nodes, whole["work"] + 1) for name, strategy in ATTEMPTS.items()}
    arrived = {name: one["work"] for name, one in alone.items() if one["status"] == "converged"}
    best = min(arrived, key=arrived.get, default=None)
    ratio = whole["work"] / arrived[best] if best else None
    cheapest = f"{best} | {arrived[best]:.0f} | {ratio:.2f}" if best else "none | | "
    print(f"| {scene.stem} | {nodes} | {whole['status']} | {whole['work']:.0f} | {cheapest} |", flush=True)
    return ratio


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program", type=lambda name: str(pathlib.Path(name).resolve()))
    options.add_argument("source", type=pathlib.Path)
    options.add_argument("--nodes", default="1000")
    options.add_argument("--only", default="")
    asked = options.parse_args()
    scenes = [s for s in sorted((asked.source / "gear-library/scenes").glob("*.toml")) if s.stem not in PIECES and asked.only in s.stem]
    print("| scene | nodes | ended | work of `auto` | cheapest attempt | its work alone | ratio |\n|---|---|---|---|---|---|---|")
    ratios = [row_of(asked.program, scene, nodes) for scene in scenes for nodes in asked.nodes.split(",")]
    known = sorted(ratio for ratio in ratios if ratio)
    if known:
        print(f"\n{len(ratios)} runs: the ratio is {statistics.median(known):.2f} in the median, at most "
              f"{known[int(0.9 * (len(known) - 1))]:.2f} in nine of ten, {known[-1]:.2f} at worst.")


if __name__ == "__main__":
    main()
