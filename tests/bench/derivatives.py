#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the derivatives of `netloft sensitivity` with pairs of equilibria, and their cost with that of a solve.

    derivatives.py NETLOFT SOURCE_FOLDER [--numbers 6] [--seed 1] [--only TEXT]

For scenes of the library with 300 nodes, numbers are drawn at random from those with derivatives. The scene is solved at 1e-4 of the
number below and above it, to a tolerance of 1e-10. Prints, for every scene, the pairs of a number and a key figure, how many agree
within 1e-4 of the largest change of the figure by one percent of any number, and how many of the others `--check` marks. Then the
processor time of all derivatives of the 83-112 with 2000 nodes over that of its solve, the median of five pairs.
"""
import argparse
import json
import random
import resource
import statistics
import subprocess
import tempfile
from pathlib import Path

SCENES = ["hanging-rope", "dead-weight-panel", "codend-from-plan", "83-112-flume-2.0kn", "83-112-flume-4.0kn", "83-112-at-sea-66m",
          "gov-like-31m", "gov-like-111m", "pelagic-with-doors", "pair-trawl", "two-panel", "four-panel"]
STEP, SAME = 1e-4, 1e-4
PRECISE = ["--set", "analysis.tolerance=1e-10"]


def ask(program, *words):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
    return json.loads(done.stdout) if done.returncode == 0 else None


def solve(program, scene, settings):
    with tempfile.TemporaryDirectory() as folder:
        answer = ask(program, "run", scene, *settings, "--json", "-o", f"{folder}/o.hdf")
    return answer and {**answer["results"], **(answer.get("gear") or {}).get("figures", {})}


def beside(number, value):
    unit = number["unit"]
    return ["--set", f'{number["path"]}="{value!r} {unit}"' if unit else f'{number["path"]}={value!r}']


def row(program, scene, options):
    size = ["--set", "gear.nodes=300"] if solve(program, scene, ["--set", "gear.nodes=300"]) else []  # else it has no gear
    found = ask(program, "sensitivity", scene, *size, *PRECISE, "--check", "--json")
    if not found:
        return f"| {scene.stem} | no equilibrium | | | | |", (0, 0, 0)
    numbers = [n for n in found["numbers"] if "per_unit" in n and n["value"] and any(n["per_unit"])]
    largest = [max(abs(n["per_unit"][f] * n["value"]) for n in numbers) for f in range(len(found["figures"]))]
    pairs = good = marked = lost = 0
    worst = 0
    for number in random.Random(f"{options.seed} {scene.stem}").sample(numbers, min(options.numbers, len(numbers))):
        h = STEP * abs(number["value"])
        above, below = (solve(program, scene, [*size, *PRECISE, *beside(number, number["value"] + way)]) for way in (h, -h))
        for f, figure in enumerate(found["figures"]):
            if not largest[f]:
                continue  # the figure depends on nothing
            if not above or not below:
                lost += 1
                continue
            by_equilibria = (above[figure["name"]] - below[figure["name"]]) / (2 * h)
            error = abs(by_equilibria - number["per_unit"][f]) * abs(number["value"]) / largest[f]
            pairs += 1
            good += error <= SAME
            marked += error > SAME and number["depends_on_step"][f]
            worst = max(worst, error if not number["depends_on_step"][f] else 0)
    return f"| {scene.stem} | {pairs} | {good} | {marked} | {worst:.0e} | {lost} |", (pairs, good, marked)


def seconds(*words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(list(map(str, words)), capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def cost(program, scene):
    size = ["--threads", "1", "--set", "gear.nodes=2000"]
    numbers = [word for table in ("hang", "points", "elements", "tow", "water", "parts") for word in ("--to", table)]
    count = sum("per_unit" in n for n in ask(program, "sensitivity", scene, *size, *numbers, "--json")["numbers"])
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for i in range(5):
            run = seconds(program, "run", scene, *size, "-o", f"{folder}/{i}.hdf")
            ratios.append((seconds(program, "sensitivity", scene, *size, *numbers) - run) / run)
    return count, statistics.median(ratios)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("source", type=Path)
    parser.add_argument("--numbers", type=int, default=6)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    print("| scene | pairs | agree | others that are marked | largest difference of one that is not marked | pairs without both equilibria |\n|---|---|---|---|---|---|")
    total = (0, 0, 0)
    for name in SCENES:
        if options.only in name:
            text, counts = row(options.program, options.source / "gear-library/scenes" / f"{name}.toml", options)
            total = tuple(a + b for a, b in zip(total, counts))
            print(text, flush=True)
    print(f"| all | {total[0]} | {total[1]} | {total[2]} | | |\n")
    count, ratio = cost(options.program, options.source / "gear-library/scenes/83-112-flume-3.0kn.toml")
    print(f"Derivatives of all figures of the 83-112 with 2000 nodes with respect to {count} numbers: {ratio:.2f} of the time of a run.")


main()
