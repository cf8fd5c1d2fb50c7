#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The default strategy on the five open gears of FEMNET, as `netloft import` writes them: from the flat drawing, and from drawings that are perturbed.

    default_strategy.py NETLOFT FOLDER [--drawn 30] [--stages]

FOLDER has the .don and .mdg, which are not part of the repository. Every free node of a drawing is moved by a normal distribution along each axis, of
a size that is drawn evenly by its logarithm from 1 mm to 0.3 m; seeds are 1, 2, … . `--stages` runs the strategy tension/stages instead, for comparison. Judging is what the host does after each stage: it looks for balance, stability and
the distance from the equilibrium.
"""
import argparse
import json
import math
import os
import random
import statistics
import subprocess
import tempfile
from pathlib import Path

GEARS = ("01_ring_flexion", "02_netting_panel", "05_pelagic_t1", "07_bottom_b1", "09_pelagic_s3")
SMALLEST, LARGEST = 1e-3, 0.3  # [m]


def perturbed(lines, seed):
    """The lines of a mesh with its nodes moved. Holds move held nodes back."""
    draw = random.Random(seed)
    size = math.exp(draw.uniform(math.log(SMALLEST), math.log(LARGEST)))
    out, is_node = [], False
    for line in lines:
        words = line.split("#")[0].split()
        if line.startswith("["):
            is_node = line.startswith("[nodes]")
        elif is_node and len(words) == 3:
            line = " ".join(repr(float(w) + draw.gauss(0, size)) for w in words)
        out.append(line)
    return "\n".join(out) + "\n"


class Runs:
    def __init__(self, netloft, gear, folder, strategy):
        self.netloft, self.folder, self.strategy = netloft, folder, strategy
        subprocess.run([netloft, "import", "femnet", str(gear), "-o", "gear.toml"], cwd=folder, check=True, capture_output=True)
        self.lines = (folder / "gear.mesh").read_text().splitlines()
        self.pin()

    def pin(self):
        """Holds are at the positions of the drawing, not at those of perturbed nodes."""
        held = set()
        sets, name = {}, None
        for line in self.lines:
            if line.startswith("["):
                name = line.split("]")[0][5:] if line.startswith("[set ") else None
            elif name:
                sets.setdefault(name, []).extend(int(w) for w in line.split())
        scene = (self.folder / "gear.toml").read_text()
        for block in scene.split("[[hold]]")[1:]:
            held.update(sets.get(block.split('on = "*.')[1].split('"')[0], []))
        self.held = held

    def run(self, seed=0):
        mesh = "\n".join(self.lines) + "\n"
        if seed:
            moved, at = perturbed(self.lines, seed).splitlines(), -1
            is_node = False
            for i, line in enumerate(self.lines):
                if line.startswith("["):
                    is_node = line.startswith("[nodes]")
                elif is_node and len(line.split("#")[0].split()) == 3:
                    at += 1
                    if at in self.held:
                        moved[i] = line
            mesh = "\n".join(moved) + "\n"
        (self.folder / "gear.mesh").write_text(mesh)
        words = ["--strategy", self.strategy] if self.strategy else []
        ended = subprocess.run([self.netloft, "run", "gear.toml", "--json", *words], cwd=self.folder, capture_output=True, text=True,
                               env={**os.environ, "OMP_THREAD_LIMIT": "1"})
        found = json.loads(ended.stdout)
        return ended.returncode == 0, found.get("cpu_seconds", math.nan), found.get("judging_cpu_seconds", math.nan)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("netloft")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--drawn", type=int, default=30)
    parser.add_argument("--stages", action="store_true")
    a = parser.parse_args()
    print("| gear | flat drawing | CPU [s] | of which judging [s] | perturbed: converged | CPU median [s] | of which judging [s] | CPU most [s] |\n"
          "|---|---|---|---|---|---|---|---|")
    for gear in GEARS:
        with tempfile.TemporaryDirectory() as folder:
            runs = Runs(str(Path(a.netloft).resolve()), (a.folder / f"{gear}.don").resolve(), Path(folder), "tension/stages" if a.stages else "")
            flat, cpu, judging = runs.run()
            drawn = [runs.run(seed) for seed in range(1, a.drawn + 1)]
            times = [seconds for converged, seconds, judged in drawn] or [math.nan]
            judged = [judged for converged, seconds, judged in drawn] or [math.nan]
            print(f"| {gear[:2]} {gear[3:].replace('_', ' ')} | {'converged' if flat else 'not'} | {cpu:.3f} | {judging:.3f} | "
                  f"{sum(c for c, _, _ in drawn)} of {len(drawn)} | {statistics.median(times):.3f} | {statistics.median(judged):.3f} | {max(times):.3f} |", flush=True)


if __name__ == "__main__":
    main()
