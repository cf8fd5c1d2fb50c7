#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests whether the 90 % intervals of a calibration contain the true values in 90 % of all cases.

    calibration_coverage.py NETLOFT LIBRARY [--draws 200] [--seed 1]

Draws true values from the prior, makes measurements of them by the model and adds noise, calibrates, and counts how often
the 90 % intervals of the variables contain the true values, and those of the predictions a measurement that the calibration
did not use. The variables are drag and mass of a towed wire, from four measurements at two speeds.
"""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile

VARIABLES = {"drag": ("parts.wire.drag.normal", 0.8, 2.0, 1.4, 0.15), "density": ("parts.wire.rope.density", 3000, 7000, 5000, 300)}
SPEEDS = {"slow": 1.0, "fast": 1.8}
NOISE = {"end_x": 1.0, "top": 150.0}  # [m], [N]
HELD_BACK = ("fast", "end_z", 1.0)
CELLS = 12


def netloft(program, *words):
    done = subprocess.run([program, *words], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"netloft {' '.join(words)} failed:\n{done.stdout}{done.stderr}")
    return json.loads(done.stdout)


def settings(speed):
    return [f"parts.wire.cells={CELLS}", f"water.current=[{speed}, 0, 0]"]


def measure(program, scene, folder, truth, random_numbers):
    rows = []
    for name, speed in SPEEDS.items():
        words = settings(speed) + [f"{VARIABLES[v][0]}={truth[v]!r}" for v in truth]
        result = netloft(program, "run", scene, "--json", "-o", str(folder / "made.hdf"),
                         *[word for setting in words for word in ("--set", setting)])["results"]
        rows += [(name, figure, random_numbers.gauss(result[figure], noise), noise, False) for figure, noise in NOISE.items()]
        if name == HELD_BACK[0]:
            rows.append((name, HELD_BACK[1], random_numbers.gauss(result[HELD_BACK[1]], HELD_BACK[2]), HELD_BACK[2], True))
    return rows


def study(scene, rows):
    text = ""
    for name, speed in SPEEDS.items():
        text += f"[scenes.{name}]\nscene = {json.dumps(scene)}\nset = {json.dumps(settings(speed))}\n"
    for name, (key, low, high, mean, deviation) in VARIABLES.items():
        text += (f"[variables.{name}]\nkey = {json.dumps(key)}\nrange = [{low}, {high}]\n"
                 f"distribution = \"normal\"\nmean = {mean}\ndeviation = {deviation}\n")
    for name, figure, value, deviation, held_back in rows:
        text += (f"[[measured]]\nscene = \"{name}\"\nfigure = \"results/{figure}\"\nvalue = {value!r}\n"
                 f"deviation = {deviation}\nheld_back = {str(held_back).lower()}\n")
    return text


def draw(program, scene, folder, random_numbers):
    """Makes one calibration and returns, by name, whether each interval contains the true value."""
    truth = {name: random_numbers.gauss(mean, deviation) for name, (_, _, _, mean, deviation) in VARIABLES.items()}
    rows = measure(program, scene, folder, truth, random_numbers)
    (folder / "study.toml").write_text(study(scene, rows))
    found = netloft(program, "calibrate", str(folder / "study.toml"), "--json")
    holds = {v["name"]: v["interval"][0] <= truth[v["name"]] <= v["interval"][1] for v in found["variables"]}
    held_back = next(row for row in found["rows"] if row["held_back"])
    holds["band of what is held back"] = held_back["band"][0] <= held_back["value"] <= held_back["band"][1]
    return holds, found["solves"]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("library", type=pathlib.Path)
    arguments.add_argument("--draws", type=int, default=200)
    arguments.add_argument("--seed", type=int, default=1)
    options = arguments.parse_args()
    scene = str((options.library / "scenes/verification/towed-cable.toml").resolve())
    random_numbers, held, solves = random.Random(options.seed), {}, 0
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.draws):
            holds, taken = draw(options.program, scene, pathlib.Path(folder), random_numbers)
            solves += taken
            for name, does in holds.items():
                held[name] = held.get(name, 0) + does
    print(f"| of {options.draws} draws, seed {options.seed} | hold the truth [%] |\n|---|---|")
    for name, count in held.items():
        print(f"| {name} | {100 * count / options.draws:.1f} |")
    print(f"{solves / options.draws:.1f} solves each")


if __name__ == "__main__":
    main()
